//! The tree of nodes of a glTF document, and with it the whole mesh.

use super::accessor::Accessors;
use super::buffers::Buffers;
use super::document::{Document, GltfCamera, Node, Primitive};
use super::moving::{Carried, Movers, Parts};
use super::primitives::{Form, Target, has_triangles};
use super::skins::{Skins, is_bound};
use super::{Fault, animations, cameras, materials, morphs, not_shown};
use crate::import::mesh::lines::Lines;
use crate::import::reader::local_origin::LocalOrigin;
use crate::import::reader::{ClipChoice, Geometry, ImportOptions};
use crate::import::source::folder::Folder;
use glam::{DAffine3, DMat3, DMat4, DQuat, DVec3, Vec4};
use voxtrace_scene::animation::NodePose;
use voxtrace_scene::camera::Camera;
use voxtrace_scene::scene::LengthUnit;
use voxtrace_voxelize::Limits;
use voxtrace_voxelize::mesh::Mesh;
use voxtrace_voxelize::points::PointCloud;

/// Whether this is the module of a page.
const IS_OF_PAGES: bool = cfg!(target_arch = "wasm32");

/// Reads the default scene, or the first one, or what no other node holds.
pub(super) fn read(
    document: &Document,
    buffers: &Buffers,
    folder: &Folder,
    options: &ImportOptions,
) -> Result<Geometry, Fault> {
    let limits = &options.limits;
    let accessors = Accessors { document, buffers, limits };
    // Pages show stills: what plays is not part of their module.
    let played = if IS_OF_PAGES { None } else { animations::chosen(document, &options.animation) };
    let mut movers = played.map(|clip| Movers::of(clip, &accessors)).transpose()?.unwrap_or_default();
    let skins = Skins::of(document, limits, &movers);
    let is_played = played.is_some() || options.animation == ClipChoice::Later;
    let Looks { mut mesh, coordinate_sets } = look(document, buffers, folder, limits, is_played)?;
    let mut target =
        Target { mesh: &mut mesh, local_origin: LocalOrigin::default(), coordinate_sets: &coordinate_sets };
    let (mut skipped, mut parts) = (0, Parts::default());
    let Found { cameras, skinned } = visit(document, limits, &mut movers, &mut |worn, place| {
        match place.carried {
            Some(carried) if has_triangles(worn.primitive) => parts.add(worn, carried, None),
            Some(_) => skipped += 1,
            None => skipped += usize::from(!target.push(worn.primitive, &accessors, &place.world, worn.form())?),
        }
        Ok(())
    })?;
    for posed in skins.posed(&skinned, &accessors, &movers)? {
        let worn = posed.worn;
        match movers.carry(&posed, document) {
            Some(carried) if has_triangles(worn.primitive) => {
                parts.add(worn, carried, Some((posed.pose, posed.bends)));
            }
            Some(_) => skipped += 1,
            None => {
                let form = Form { pose: Some(&posed.pose), ..worn.form() };
                skipped += usize::from(!target.push(worn.primitive, &accessors, &DAffine3::IDENTITY, form)?);
            }
        }
    }
    if target.mesh.triangles.is_empty() && parts.is_empty() {
        return loose(&skins, &accessors, target).map(Geometry::Points);
    }
    mesh.offset = target.local_origin.offset();
    mesh.clips = animations::clips(document, &accessors);
    let mut carried_cameras = Vec::new();
    for (camera, carried) in cameras_at(&cameras, mesh.offset) {
        carried_cameras.extend(carried.map(|carried| carried.attached(mesh.cameras.len())));
        mesh.cameras.push(camera);
    }
    if let Some(clip) = played {
        let clip = (clip, options.shape_rate);
        parts.hang((movers, &skins), carried_cameras, clip, &mut mesh, (&accessors, &coordinate_sets))?;
    }
    mesh.notes.extend(note_of_skipped(skipped));
    Ok(Geometry::Mesh(mesh))
}

/// Reads a document without triangles: its points, and points along its lines.
fn loose(skins: &Skins, accessors: &Accessors, mut target: Target) -> Result<PointCloud, Fault> {
    let mut lines = Lines::default();
    let found = visit(accessors.document, accessors.limits, &mut Movers::default(), &mut |worn, place| {
        target.push_loose(worn.primitive, accessors, &place.world, worn.form(), &mut lines).map(drop)
    })?;
    for posed in skins.posed(&found.skinned, accessors, &Movers::default())? {
        let form = Form { pose: Some(&posed.pose), ..posed.worn.form() };
        target.push_loose(posed.worn.primitive, accessors, &DAffine3::IDENTITY, form, &mut lines)?;
    }
    let mut mesh = std::mem::replace(target.mesh, Mesh::new(""));
    if mesh.positions.is_empty() {
        return Err(Fault::unsupported("a glTF file without a triangle, a line or a point"));
    }
    mesh.offset = target.local_origin.offset();
    let most = accessors.limits.points;
    lines.draw(&mut mesh, accessors.limits).map_err(|count| Fault::limit("points on lines", count, most))?;
    mesh.notes.push(format!("no triangles: the vertices and {} lines are taken for points", lines.len()));
    Ok(PointCloud::from_corners(mesh))
}

/// A mesh without triangles, and the coordinate set of each material of the document.
pub(super) struct Looks {
    pub mesh: Mesh,
    pub coordinate_sets: materials::CoordinateSets,
}

/// Reads materials and pictures; one of the animations may be played.
pub(super) fn look(
    document: &Document,
    buffers: &Buffers,
    folder: &Folder,
    limits: &Limits,
    is_played: bool,
) -> Result<Looks, Fault> {
    let mut mesh = Mesh { unit: LengthUnit::METRE, ..Mesh::new("") };
    let mut primitives = document.meshes.iter().flat_map(|mesh| &mesh.primitives);
    if primitives.any(|primitive| primitive.material.is_none() && primitive.attributes.contains_key("COLOR_0")) {
        // Colours of vertices are a share of white where nothing else is said, not of our grey.
        mesh.materials[0].base_color = Vec4::ONE;
    }
    let coordinate_sets = materials::read(document, buffers, folder, limits, &mut mesh)?;
    mesh.notes.extend(not_shown::parts(document, is_played).note());
    if mesh.materials.len() > 65_535 {
        let what = format!("materials: {} is more than the fixed limit of 65535", mesh.materials.len());
        return Err(Fault::unsupported(what));
    }
    Ok(Looks { mesh, coordinate_sets })
}

/// What is said about primitives without triangles.
pub(super) fn note_of_skipped(count: usize) -> Option<String> {
    (count > 0).then(|| format!("{count} primitives that are no triangles are left out"))
}

/// Where nodes have something.
#[derive(Clone, Copy)]
pub(super) struct Place {
    /// From there to the world, everything at rest.
    pub world: DAffine3,
    /// The node that carries it, where one moves.
    pub carried: Option<Carried>,
}

/// A camera where a node has it.
pub(super) type PlacedCamera<'a> = (&'a Node, &'a GltfCamera, Place);

/// The cameras that are of use, relative to `offset`, and what carries them.
pub(super) fn cameras_at(cameras: &[PlacedCamera], offset: DVec3) -> impl Iterator<Item = (Camera, Option<Carried>)> {
    cameras.iter().filter_map(move |(node, camera, place)| {
        Some((cameras::camera(node, camera, &place.world, offset)?, place.carried))
    })
}

/// A primitive as a node has it.
#[derive(Clone, Copy)]
pub(super) struct Worn<'a> {
    pub primitive: &'a Primitive,
    /// The node, by its index in the document.
    pub node: usize,
    /// Of its morph targets, without an animation.
    pub weights: &'a [f32],
}

impl<'a> Worn<'a> {
    /// What shapes it where no joints do.
    pub fn form(&self) -> Form<'a> {
        Form { weights: self.weights, pose: None }
    }
}

/// What is found in a scene beside the primitives that nodes place.
pub(super) struct Found<'a> {
    pub cameras: Vec<PlacedCamera<'a>>,
    /// Primitives that the joints of a skin place, with its number.
    pub skinned: Vec<(Worn<'a>, usize)>,
}

/// Calls `each` with the primitives of all nodes of the scene in turn and where they are, without those that joints place.
pub(super) fn visit<'a>(
    document: &'a Document,
    limits: &Limits,
    movers: &mut Movers,
    each: &mut dyn FnMut(Worn<'a>, &Place) -> Result<(), Fault>,
) -> Result<Found<'a>, Fault> {
    let mut visited = vec![false; document.nodes.len()];
    let root = Place { world: DAffine3::IDENTITY, carried: None };
    let mut pending: Vec<(usize, Place, u32)> = roots(document)?.into_iter().map(|n| (n, root, 0)).collect();
    pending.reverse();
    let mut found = Found { cameras: Vec::new(), skinned: Vec::new() };
    while let Some((index, outer, depth)) = pending.pop() {
        let node = document.nodes.get(index).ok_or_else(|| Fault::malformed(format!("node {index} is missing")))?;
        if std::mem::replace(&mut visited[index], true) {
            return Err(Fault::malformed(format!("node {index} has two parents, or is its own")));
        }
        if depth > limits.depth {
            return Err(Fault::limit("depth of nodes", depth.into(), limits.depth.into()));
        }
        let local = local(node);
        let [of_mesh, carried] = movers.enter(index, &node.name, &outer, &local);
        let place = Place { world: outer.world * local, carried };
        if let Some(mesh) = node.mesh {
            let gltf_mesh = document.meshes.get(mesh);
            let gltf_mesh = gltf_mesh.ok_or_else(|| Fault::malformed(format!("mesh {mesh} is missing")))?;
            for primitive in &gltf_mesh.primitives {
                let worn = Worn { primitive, node: index, weights: morphs::weights(node, gltf_mesh) };
                // A skin places vertices wherever the node is; those that name no joint have nothing else than the node.
                match node.skin.filter(|_| is_bound(primitive)) {
                    Some(skin) => found.skinned.push((worn, skin)),
                    None => each(worn, &Place { carried: of_mesh, ..place })?,
                }
            }
        }
        if let Some(camera) = node.camera.and_then(|camera| document.cameras.get(camera)) {
            found.cameras.push((node, camera, place));
        }
        pending.extend(node.children.iter().rev().map(|&child| (child, place, depth + 1)));
    }
    Ok(found)
}

fn roots(document: &Document) -> Result<Vec<usize>, Fault> {
    if let Some(scene) = document.scenes.get(document.scene.unwrap_or(0)) {
        return Ok(scene.nodes.clone());
    }
    if let Some(scene) = document.scene {
        return Err(Fault::malformed(format!("scene {scene} is missing")));
    }
    let mut is_child = vec![false; document.nodes.len()];
    for &child in document.nodes.iter().flat_map(|node| &node.children) {
        *is_child.get_mut(child).ok_or_else(|| Fault::malformed(format!("node {child} is missing")))? = true;
    }
    Ok((0..is_child.len()).filter(|&node| !is_child[node]).collect())
}

/// From the space of a node to that of its parent, at rest.
pub(super) fn local(node: &Node) -> DAffine3 {
    if let Some(matrix) = &node.matrix {
        let matrix = DMat4::from_cols_array(matrix);
        let axes = DMat3::from_cols(matrix.x_axis.truncate(), matrix.y_axis.truncate(), matrix.z_axis.truncate());
        return DAffine3 { matrix3: axes, translation: matrix.w_axis.truncate() };
    }
    pose(node).map()
}

/// The translation, rotation and scale of a node without a matrix.
pub(super) fn pose(node: &Node) -> NodePose {
    let rotation = DQuat::from_array(node.rotation.unwrap_or([0.0, 0.0, 0.0, 1.0]));
    NodePose {
        translation: DVec3::from_array(node.translation.unwrap_or([0.0; 3])),
        rotation: if rotation.length_squared() > 0.0 { rotation.normalize() } else { DQuat::IDENTITY },
        scale: DVec3::from_array(node.scale.unwrap_or([1.0; 3])),
    }
}
