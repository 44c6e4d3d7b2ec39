//! The tree of nodes of a glTF document, and with it the whole mesh.

use super::accessor::Accessors;
use super::buffers::Buffers;
use super::document::{Document, GltfCamera, Node, Primitive};
use super::primitives::Target;
use super::{Fault, cameras, materials, not_shown};
use crate::import::mesh::lines::Lines;
use crate::import::reader::Geometry;
use crate::import::reader::local_origin::LocalOrigin;
use crate::import::source::folder::Folder;
use glam::{DAffine3, DMat3, DMat4, DQuat, DVec3, Vec4};
use voxtrace_scene::camera::Camera;
use voxtrace_scene::scene::LengthUnit;
use voxtrace_voxelize::Limits;
use voxtrace_voxelize::mesh::Mesh;
use voxtrace_voxelize::points::PointCloud;

/// Reads the default scene, or the first one, or what no other node holds.
pub(super) fn read(
    document: &Document,
    buffers: &Buffers,
    folder: &Folder,
    limits: &Limits,
) -> Result<Geometry, Fault> {
    let Looks { mut mesh, coordinate_sets } = look(document, buffers, folder, limits)?;
    let accessors = Accessors { document, buffers, limits };
    let mut target =
        Target { mesh: &mut mesh, local_origin: LocalOrigin::default(), coordinate_sets: &coordinate_sets };
    let mut skipped = 0;
    let cameras = visit(document, limits, &mut |primitive, world| {
        skipped += usize::from(!target.push(primitive, &accessors, world)?);
        Ok(())
    })?;
    if target.mesh.triangles.is_empty() {
        return loose(document, &accessors, target).map(Geometry::Points);
    }
    mesh.offset = target.local_origin.offset();
    mesh.cameras.extend(cameras_at(&cameras, mesh.offset));
    mesh.notes.extend(note_of_skipped(skipped));
    Ok(Geometry::Mesh(mesh))
}

/// Reads a document without triangles: its points, and points along its lines.
fn loose(document: &Document, accessors: &Accessors, mut target: Target) -> Result<PointCloud, Fault> {
    let mut lines = Lines::default();
    visit(document, accessors.limits, &mut |primitive, world| {
        target.push_loose(primitive, accessors, world, &mut lines).map(drop)
    })?;
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

/// Reads materials and pictures.
pub(super) fn look(document: &Document, buffers: &Buffers, folder: &Folder, limits: &Limits) -> Result<Looks, Fault> {
    let mut mesh = Mesh { unit: LengthUnit::METRE, ..Mesh::new("") };
    let mut primitives = document.meshes.iter().flat_map(|mesh| &mesh.primitives);
    if primitives.any(|primitive| primitive.material.is_none() && primitive.attributes.contains_key("COLOR_0")) {
        // Colours of vertices are a share of white where nothing else is said, not of our grey.
        mesh.materials[0].base_color = Vec4::ONE;
    }
    let coordinate_sets = materials::read(document, buffers, folder, limits, &mut mesh)?;
    mesh.notes.extend(not_shown::parts(document).note());
    if mesh.materials.len() > 65_535 {
        return Err(Fault::limit("materials", mesh.materials.len() as u64, 65_535));
    }
    Ok(Looks { mesh, coordinate_sets })
}

/// What is said about primitives without triangles.
pub(super) fn note_of_skipped(count: usize) -> Option<String> {
    (count > 0).then(|| format!("{count} primitives that are no triangles are left out"))
}

/// A camera where a node has it.
pub(super) type PlacedCamera<'a> = (&'a Node, &'a GltfCamera, DAffine3);

/// The cameras that are of use, relative to `offset`.
pub(super) fn cameras_at(cameras: &[PlacedCamera], offset: DVec3) -> impl Iterator<Item = Camera> {
    cameras.iter().filter_map(move |(node, camera, world)| cameras::camera(node, camera, world, offset))
}

/// Calls `each` with the primitives of all nodes of the scene in turn and where they are; returns the cameras.
pub(super) fn visit<'a>(
    document: &'a Document,
    limits: &Limits,
    each: &mut dyn FnMut(&'a Primitive, &DAffine3) -> Result<(), Fault>,
) -> Result<Vec<PlacedCamera<'a>>, Fault> {
    let mut visited = vec![false; document.nodes.len()];
    let mut pending: Vec<(usize, DAffine3, u32)> =
        roots(document)?.into_iter().map(|n| (n, DAffine3::IDENTITY, 0)).collect();
    pending.reverse();
    let mut found_cameras = Vec::new();
    while let Some((index, parent, depth)) = pending.pop() {
        let node = document.nodes.get(index).ok_or_else(|| Fault::malformed(format!("node {index} is missing")))?;
        if std::mem::replace(&mut visited[index], true) {
            return Err(Fault::malformed(format!("node {index} has two parents, or is its own")));
        }
        if depth > limits.depth {
            return Err(Fault::limit("depth of nodes", depth.into(), limits.depth.into()));
        }
        let world = parent * local(node);
        if let Some(mesh) = node.mesh {
            let gltf_mesh = document.meshes.get(mesh);
            let gltf_mesh = gltf_mesh.ok_or_else(|| Fault::malformed(format!("mesh {mesh} is missing")))?;
            gltf_mesh.primitives.iter().try_for_each(|primitive| each(primitive, &world))?;
        }
        if let Some(camera) = node.camera.and_then(|camera| document.cameras.get(camera)) {
            found_cameras.push((node, camera, world));
        }
        pending.extend(node.children.iter().rev().map(|&child| (child, world, depth + 1)));
    }
    Ok(found_cameras)
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

fn local(node: &Node) -> DAffine3 {
    if let Some(matrix) = &node.matrix {
        let matrix = DMat4::from_cols_array(matrix);
        let axes = DMat3::from_cols(matrix.x_axis.truncate(), matrix.y_axis.truncate(), matrix.z_axis.truncate());
        return DAffine3 { matrix3: axes, translation: matrix.w_axis.truncate() };
    }
    let rotation = DQuat::from_array(node.rotation.unwrap_or([0.0, 0.0, 0.0, 1.0]));
    let rotation = if rotation.length_squared() > 0.0 { rotation.normalize() } else { DQuat::IDENTITY };
    let scale = DVec3::from_array(node.scale.unwrap_or([1.0; 3]));
    DAffine3::from_scale_rotation_translation(scale, rotation, DVec3::from_array(node.translation.unwrap_or([0.0; 3])))
}
