//! Meshes of which parts move ([`Mesh::moving`]): what stands still becomes one grid, each part one in its own space, all in voxels of one
//! size and with one palette. Instances stand where their nodes are at rest; each shape that a part has beside that at rest is a grid, too.

use super::appearance::BsdfClass;
use super::color_histogram::ColorHistogram;
use super::estimate::{bytes_of, voxels_of};
use super::mesh_appearance::MeshAppearance;
use super::palette::Palette;
use super::shapes::{self, Steps};
use super::spill::SpillBuffer;
use super::tile::TileJob;
use super::voxelized::{grid_of, scene_of_source, sky_of};
use super::{
    Estimate, Placement, VoxelizeError, VoxelizeOptions, VoxelizeProgress, cameras_of, material_count, surface,
};
use crate::limits::Limits;
use crate::mesh::{Mesh, MovingParts};
use glam::{DAffine3, DMat3, DVec3};
use std::sync::Arc;
use voxtrace_scene::animation::{Attached, Clip, NodeMotion, Shape, ShapeSteps, similarity_of};
use voxtrace_scene::scene::{Instance, Scene};
use voxtrace_scene::transform::Transform;

/// As [`super::voxelize`], for a mesh with parts that move.
pub(super) fn voxelize(
    mesh: &Mesh,
    moving: &MovingParts,
    options: &VoxelizeOptions,
    limits: &Limits,
    progress: &VoxelizeProgress,
) -> Result<Scene, VoxelizeError> {
    let motion = checked(mesh, moving)?;
    let whole = placement(mesh, moving, motion, options)?;
    let mut work = Work { options, limits: *limits, progress, histogram: ColorHistogram::default(), classes: None };
    let has_uvs = !mesh.uvs.is_empty() || moving.meshes.iter().any(|part| !part.uvs.is_empty());
    let mut own = Mesh { materials: mesh.materials.clone(), textures: mesh.textures.clone(), ..Mesh::new("") };
    let corners = corners_of(moving, motion, &whole);
    let mut pieces = Vec::with_capacity(1 + moving.meshes.len());
    // What stands still has the voxels that it has in a still of everything.
    for (piece, corner) in [mesh].into_iter().chain(&moving.meshes).zip([whole.origin].iter().chain(&corners)) {
        take_arrays(&mut own, piece, has_uvs);
        pieces.push(work.piece(&own, *corner, whole.voxel_size)?);
    }
    let shapes = shapes::voxelize(moving, &corners, whole.voxel_size, has_uvs, &mut own, &mut work)?;
    let is_seen = pieces.iter().chain(shapes.iter().flat_map(|own| &own.pieces)).any(Option::is_some);
    let Some(classes) = work.classes.filter(|_| is_seen) else {
        return Err(VoxelizeError::Empty);
    };
    let classes = BsdfClass::in_voxels(&classes, whole.voxel_size);
    let palette = Palette::of(&work.histogram, &classes, material_count(options), options.dither);
    let mut scene = scene_of_source(&mesh.name, mesh.unit);
    scene.voxel_size *= whole.voxel_size;
    let grids = add_grids(&mut scene, &palette, pieces)?;
    let mut shown = Vec::with_capacity(shapes.len());
    for Steps { part, rate, steps, pieces } in shapes {
        shown.push(Shown { part, rate, steps, grids: add_grids(&mut scene, &palette, pieces)? });
    }
    scene.materials = palette.materials;
    scene.sky = sky_of(&scene.materials);
    scene.cameras = cameras_of(mesh, &whole);
    if let Some((grid, origin)) = grids[0] {
        let corner = ((origin - whole.origin) / whole.voxel_size).round();
        scene.instances.push(Instance::new(grid, Transform::from_translation(corner.as_vec3())));
    }
    let motion = place(&mut scene, motion, moving, (&grids[1..], &shown), &whole);
    let moved = |clip: &Clip| Clip { motion: clip.motion.as_ref().map(|_| Arc::new(motion.clone())), ..clip.clone() };
    scene.clips = mesh.clips.iter().map(moved).collect();
    Ok(scene)
}

/// As [`super::estimate`], for a mesh with parts that move.
pub(super) fn estimate(
    mesh: &Mesh,
    moving: &MovingParts,
    options: &VoxelizeOptions,
) -> Result<Estimate, VoxelizeError> {
    let whole = placement(mesh, moving, checked(mesh, moving)?, options)?;
    let mut of_pieces = Vec::with_capacity(1 + moving.meshes.len());
    for piece in [mesh].into_iter().chain(&moving.meshes) {
        of_pieces.push(match piece.bounds() {
            Some(bounds) => {
                let own = Placement::on_lattice(bounds, piece.offset, DVec3::ZERO, whole.voxel_size)?;
                voxels_of(piece, &own, options.rule).max(1.0)
            }
            None => 0.0,
        });
    }
    let voxels = (of_pieces.iter().sum::<f64>() + shapes::estimated(moving, &of_pieces[1..])) as u64;
    Ok(Estimate { placement: whole, voxels, bytes: bytes_of(voxels, false), is_bound: false })
}

/// The motion of a mesh that is sound with its parts.
fn checked<'m>(mesh: &'m Mesh, moving: &MovingParts) -> Result<&'m NodeMotion, VoxelizeError> {
    let bad = |what: &str| VoxelizeError::BadMesh(what.to_owned().into());
    let motion = mesh.clips.iter().find_map(|clip| clip.motion.as_deref());
    let motion = motion.ok_or_else(|| bad("parts move, and nothing says how"))?;
    let parts = moving.meshes.len();
    let is_sound = moving.placed.iter().all(|&(part, _)| part < parts)
        && motion.instances.iter().all(|own| own.index < moving.placed.len() && own.node < motion.nodes.len());
    if is_sound && shapes::are_sound(moving) {
        Ok(motion)
    } else {
        Err(bad("a part, a shape or a node that moves is missing"))
    }
}

/// Where the lattice of each part lies, in its own space. A part that changes its shape, and is not turned at rest, has there the voxels of a still.
fn corners_of(moving: &MovingParts, motion: &NodeMotion, whole: &Placement) -> Vec<DVec3> {
    let mut corners = vec![DVec3::ZERO; moving.meshes.len()];
    let at_rest = motion.nodes_at(None);
    let mut instance_of = vec![None; moving.meshes.len()];
    motion.instances.iter().rev().for_each(|own| instance_of[moving.placed[own.index].0] = Some(own));
    for part in moving.changing.iter().map(|own| own.part) {
        let Some(own) = instance_of[part] else { continue };
        let map = motion.world_from_file * at_rest[own.node] * own.node_from_own;
        if map.matrix3.abs_diff_eq(DMat3::IDENTITY, 1e-9) && map.translation.is_finite() {
            corners[part] = whole.origin - map.translation;
        }
    }
    corners
}

/// The grid over everything at rest.
fn placement(
    mesh: &Mesh,
    moving: &MovingParts,
    motion: &NodeMotion,
    options: &VoxelizeOptions,
) -> Result<Placement, VoxelizeError> {
    let maps = motion.nodes_at(None);
    let (mut min, mut max) = mesh.bounds().unwrap_or((DVec3::INFINITY, DVec3::NEG_INFINITY));
    for own in &motion.instances {
        let map = motion.world_from_file * maps[own.node] * own.node_from_own;
        let part = &moving.meshes[moving.placed[own.index].0];
        for &position in &part.positions {
            let point = map.transform_point3(position.as_dvec3() + part.offset);
            (min, max) = (min.min(point), max.max(point));
        }
    }
    if min.x > max.x {
        return Err(VoxelizeError::Empty);
    }
    Placement::over((min, max), mesh.offset, options.scale)
}

/// Gives `own` the arrays of a part; all have texture coordinates where one has, so that all have the same classes of materials.
pub(super) fn take_arrays(own: &mut Mesh, part: &Mesh, has_uvs: bool) {
    own.offset = part.offset;
    own.positions.clone_from(&part.positions);
    own.triangles.clone_from(&part.triangles);
    own.uvs.clone_from(&part.uvs);
    if has_uvs {
        own.uvs.resize(own.positions.len(), glam::Vec2::ZERO);
    }
    own.colors.clone_from(&part.colors);
    own.material_of.clone_from(&part.material_of);
}

/// What all pieces share.
pub(super) struct Work<'a> {
    pub options: &'a VoxelizeOptions,
    /// What is left of the limits.
    pub limits: Limits,
    pub progress: &'a VoxelizeProgress,
    histogram: ColorHistogram,
    classes: Option<Vec<BsdfClass>>,
}

/// The voxels of a piece, and the lowest corner of its grid.
pub(super) struct Piece {
    origin: DVec3,
    spill: SpillBuffer,
}

impl Work<'_> {
    /// Voxelizes a piece at whole distances from `corner`; `None` where it has no voxels.
    pub fn piece(&mut self, mesh: &Mesh, corner: DVec3, voxel_size: f64) -> Result<Option<Piece>, VoxelizeError> {
        mesh.validate().map_err(VoxelizeError::BadMesh)?;
        let Some(bounds) = mesh.bounds() else { return Ok(None) };
        let placement = Placement::on_lattice(bounds, mesh.offset, corner, voxel_size)?;
        let (appearance, mut spill) = (MeshAppearance::of(mesh), SpillBuffer::in_memory());
        let (rule, histogram) = (self.options.rule, &self.histogram);
        let job = TileJob { mesh, placement: &placement, appearance: &appearance, rule, histogram };
        surface::run_tiles(&job, self.options, &self.limits, &mut spill, self.progress)?;
        self.limits.voxels = self.limits.voxels.saturating_sub(spill.voxels());
        self.classes.get_or_insert_with(|| appearance.classes.clone());
        Ok((spill.brick_count() > 0).then_some(Piece { origin: placement.origin, spill }))
    }
}

/// A grid, by its index, and the lowest corner of its lattice.
type Placed = Option<(usize, DVec3)>;

/// Makes grids of pieces.
fn add_grids(scene: &mut Scene, palette: &Palette, pieces: Vec<Option<Piece>>) -> Result<Vec<Placed>, VoxelizeError> {
    let mut grids = Vec::with_capacity(pieces.len());
    for piece in pieces {
        grids.push(match piece {
            Some(Piece { origin, mut spill }) => {
                scene.grids.push(grid_of(palette, &mut spill)?.into());
                Some((scene.grids.len() - 1, origin))
            }
            None => None,
        });
    }
    Ok(grids)
}

/// The shapes of a part as grids; `steps` are indices into them.
struct Shown {
    part: usize,
    rate: f64,
    steps: Vec<usize>,
    grids: Vec<Placed>,
}

/// The clips of a mesh without parts that move, of which a camera may, in voxels.
pub(super) fn clips_of(mesh: &Mesh, placement: &Placement) -> Vec<Clip> {
    let mut clips = mesh.clips.clone();
    for motion in clips.iter_mut().filter_map(|clip| clip.motion.as_mut()) {
        let motion = Arc::make_mut(motion);
        motion.world_from_file = in_voxels(placement) * motion.world_from_file;
    }
    clips
}

/// From the space of a mesh to its voxels.
fn in_voxels(placement: &Placement) -> DAffine3 {
    DAffine3::from_scale(DVec3::splat(1.0 / placement.voxel_size)) * DAffine3::from_translation(-placement.origin)
}

/// Adds the instances that move to the scene, at rest. Returns their motion in voxels.
fn place(
    scene: &mut Scene,
    motion: &NodeMotion,
    moving: &MovingParts,
    (grids, shown): (&[Placed], &[Shown]),
    whole: &Placement,
) -> NodeMotion {
    let world_from_file = in_voxels(whole) * motion.world_from_file;
    let mut instances = Vec::with_capacity(motion.instances.len());
    let (at_rest, mut shapes) = (motion.nodes_at(None), Vec::new());
    let part_from_grid =
        |origin: DVec3| DAffine3::from_translation(origin) * DAffine3::from_scale(DVec3::splat(whole.voxel_size));
    let mut shown_of = vec![None; grids.len()];
    shown.iter().for_each(|shown| shown_of[shown.part] = Some(shown));
    for own in &motion.instances {
        let (part, name) = &moving.placed[own.index];
        let shown = shown_of[*part];
        // What has no voxels at rest may have some later.
        let first = grids[*part].or_else(|| shown?.grids.iter().copied().flatten().next());
        let Some((grid, origin)) = first else { continue };
        let node_from_own = own.node_from_own * part_from_grid(origin);
        if let Some(shown) = shown {
            let mut index_of = vec![None; shown.grids.len()];
            let mut own_shapes = Vec::with_capacity(shown.grids.len());
            for (index, &(grid, origin)) in
                index_of.iter_mut().zip(&shown.grids).filter_map(|(index, grid)| Some((index, grid.as_ref()?)))
            {
                *index = Some(own_shapes.len());
                own_shapes.push(Shape { grid, node_from_grid: own.node_from_own * part_from_grid(origin) });
            }
            let steps = shown.steps.iter().map(|&step| index_of[step]).collect();
            let (index, node) = (scene.instances.len(), own.node);
            shapes.push(ShapeSteps { index, node, rate: shown.rate, shapes: own_shapes, steps });
        }
        let rest = similarity_of(&(world_from_file * at_rest[own.node] * node_from_own));
        let world_from_grid = rest.map_or(Transform::IDENTITY, |(transform, _)| transform);
        instances.push(Attached { index: scene.instances.len(), node: own.node, node_from_own });
        scene.instances.push(Instance { name: name.clone(), ..Instance::new(grid, world_from_grid) });
    }
    NodeMotion { world_from_file, instances, shapes, ..motion.clone() }
}
