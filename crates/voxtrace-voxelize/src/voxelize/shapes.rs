//! Grids of parts that change their shape: one for each shape, of as many steps as there is room for.

use super::estimate::{enclosed_by, voxels_of};
use super::moving::{Piece, Work, take_arrays};
use super::{Placement, VoxelizeError, VoxelizeOptions, VoxelizeProgress};
use crate::mesh::{ChangingPart, Mesh, MovingParts};
use glam::DVec3;

/// Most voxels of all shapes together: a few gigabytes with all that is made of them.
const MOST_VOXELS: u64 = 1 << 28;

/// The shapes of a part that are shown.
pub(super) struct Steps {
    /// Index among the parts.
    pub part: usize,
    /// Steps a second.
    pub rate: f64,
    /// For each step the index among the pieces.
    pub steps: Vec<usize>,
    /// The voxels of each shape.
    pub pieces: Vec<Option<Piece>>,
}

/// Whether all shapes that are named are there.
pub(super) fn are_sound(moving: &MovingParts) -> bool {
    moving.changing.iter().all(|own| {
        let count = own.shapes.count();
        own.part < moving.meshes.len()
            && own.rate > 0.0
            && own.rate.is_finite()
            && !own.steps.is_empty()
            && own.steps.iter().all(|&shape| (shape as usize) < count)
    })
}

/// How many voxels the shapes come to at most, by those of the parts at rest.
pub(super) fn estimated(moving: &MovingParts, of_parts: &[f64]) -> f64 {
    let voxels = moving.changing.iter().map(|own| of_parts[own.part] * own.shapes.count() as f64);
    voxels.sum::<f64>().min(MOST_VOXELS as f64)
}

/// Voxelizes the shapes of all parts that change theirs, each at whole distances from the corner of its part.
pub(super) fn voxelize(
    moving: &MovingParts,
    corners: &[DVec3],
    voxel_size: f64,
    has_uvs: bool,
    own: &mut Mesh,
    work: &mut Work,
) -> Result<Vec<Steps>, VoxelizeError> {
    // Sizes are estimates: half of what is left is room for all.
    let most = (work.limits.voxels / 2).min(MOST_VOXELS);
    let every = stride(moving, corners, voxel_size, (work.options, most), work.progress)?;
    if every > 1 {
        let rates = moving.changing.iter().map(|own| own.rate / every as f64);
        let rate = rates.fold(f64::INFINITY, f64::min);
        work.progress.note(format!(
            "what bends has {rate:.3} shapes a second: with every shape that is asked for there would be more than {most} voxels"
        ));
    }
    let mut all = Vec::with_capacity(moving.changing.len());
    for changing in &moving.changing {
        take_arrays(own, &moving.meshes[changing.part], has_uvs);
        let mut piece_of = vec![None; changing.shapes.count()];
        let (mut pieces, mut steps) = (Vec::new(), Vec::with_capacity(changing.steps.len().div_ceil(every)));
        for &shape in changing.steps.iter().step_by(every) {
            let piece = match piece_of[shape as usize] {
                Some(piece) => piece,
                None => {
                    own.positions = changing.shapes.positions(shape as usize);
                    pieces.push(work.piece(own, corners[changing.part], voxel_size)?);
                    *piece_of[shape as usize].insert(pieces.len() - 1)
                }
            };
            steps.push(piece);
        }
        all.push(Steps { part: changing.part, rate: changing.rate / every as f64, steps, pieces });
    }
    Ok(all)
}

/// Of how many steps one is shown, so that there are about `most` voxels: a power of two.
fn stride(
    moving: &MovingParts,
    corners: &[DVec3],
    voxel_size: f64,
    (options, most): (&VoxelizeOptions, u64),
    progress: &VoxelizeProgress,
) -> Result<usize, VoxelizeError> {
    let mut sizes = Vec::with_capacity(moving.changing.len());
    for changing in &moving.changing {
        sizes.push(voxels_of_shapes(changing, moving, corners[changing.part], voxel_size, options, progress)?);
    }
    let voxels = |every: usize| -> f64 {
        let of_part = |(changing, sizes): (&ChangingPart, &Vec<f64>)| {
            let mut is_shown = vec![false; sizes.len()];
            changing.steps.iter().step_by(every).for_each(|&shape| is_shown[shape as usize] = true);
            sizes.iter().zip(is_shown).filter(|(_, is_shown)| *is_shown).map(|(size, _)| size).sum::<f64>()
        };
        moving.changing.iter().zip(&sizes).map(of_part).sum()
    };
    let longest = moving.changing.iter().map(|own| own.steps.len()).max().unwrap_or(1);
    let mut every = 1;
    while every < longest && voxels(every) > most as f64 {
        every *= 2;
    }
    Ok(every)
}

/// The voxels of each shape of a part, by its projected areas, and by what it encloses where that is filled: half of the surface's lie within.
fn voxels_of_shapes(
    changing: &ChangingPart,
    moving: &MovingParts,
    corner: DVec3,
    voxel_size: f64,
    options: &VoxelizeOptions,
    progress: &VoxelizeProgress,
) -> Result<Vec<f64>, VoxelizeError> {
    let part = &moving.meshes[changing.part];
    let (triangles, offset) = (part.triangles.clone(), part.offset);
    let mut mesh = Mesh { triangles, offset, ..Mesh::new("") };
    let mut sizes = Vec::with_capacity(changing.shapes.count());
    for shape in 0..changing.shapes.count() {
        if progress.is_cancelled() {
            return Err(VoxelizeError::Cancelled);
        }
        mesh.positions = changing.shapes.positions(shape);
        mesh.validate().map_err(VoxelizeError::BadMesh)?;
        let Some(bounds) = mesh.bounds() else {
            sizes.push(0.0);
            continue;
        };
        let placement = Placement::on_lattice(bounds, mesh.offset, corner, voxel_size)?;
        let surface = voxels_of(&mesh, &placement, options.rule);
        let filled = if options.fill { enclosed_by(&mesh, &placement) + 0.5 * surface } else { 0.0 };
        sizes.push(placement.at_most(surface.max(filled)) as f64);
    }
    Ok(sizes)
}
