//! Voxelization of meshes and clouds of points. Surfaces are voxelized conservatively (26-separating) or thinly (6-separating),
//! closed ones also solidly, in tiles that fit into the cache. Each voxel takes the mean colour of the surface or the points
//! inside it. `docs/decisions/0012-voxelize.md` has the method and its measurements.

mod appearance;
mod binning;
mod checkpoint;
mod color_histogram;
mod disk_buckets;
mod error;
mod estimate;
mod fill;
mod fingerprint;
mod hyperloglog;
pub mod large;
pub mod large_points;
mod mesh_appearance;
mod moving;
mod options;
mod palette;
mod partition;
mod placement;
mod point_sort;
mod points;
mod polygon;
mod progress;
mod recolor;
mod shapes;
mod six_separating;
mod spill;
mod surface;
mod tile;
mod to_file;
mod triangle;
mod voxelized;

pub use error::VoxelizeError;
pub use estimate::{Estimate, estimate, estimate_points};
pub use options::{Scale, SurfaceRule, VoxelizeOptions};
pub use placement::Placement;
pub use points::PointOptions;
pub use progress::VoxelizeProgress;
pub use recolor::{colors_of_texels, quantize_palette, recolor};
pub use to_file::{
    Written, voxelize_large_points_to_file, voxelize_large_to_file, voxelize_points_to_file, voxelize_to_file,
};

use crate::limits::Limits;
use crate::mesh::Mesh;
use crate::points::PointCloud;
use binning::TileGrid;
pub(crate) use checkpoint::Step;
pub(crate) use color_histogram::ColorHistogram;
pub(crate) use fingerprint::of_description;
pub(crate) use spill::{SpillBuffer, TileRecords};
use std::ops::Range;
pub(crate) use to_file::with_spill;
pub(crate) use voxelized::SpilledBricks;
use voxtrace_scene::material::MAX_MATERIALS;
use voxtrace_scene::scene::Scene;

/// Voxelizes a mesh into a scene of one grid, and one more for each part that moves.
///
/// # Errors
/// If the mesh has no surface, or its voxels go beyond the limit.
pub fn voxelize(mesh: &Mesh, options: &VoxelizeOptions, limits: &Limits) -> Result<Scene, VoxelizeError> {
    voxelize_with_progress(mesh, options, limits, &VoxelizeProgress::default())
}

/// As [`voxelize`], reports progress and can be cancelled through it.
///
/// # Errors
/// As [`voxelize`]; also if it was cancelled.
pub fn voxelize_with_progress(
    mesh: &Mesh,
    options: &VoxelizeOptions,
    limits: &Limits,
    progress: &VoxelizeProgress,
) -> Result<Scene, VoxelizeError> {
    // Pages ask for no parts that move: what voxelizes them is not part of their module.
    if let Some(moving) = mesh.moving.as_ref().filter(|_| cfg!(not(target_arch = "wasm32"))) {
        return moving::voxelize(mesh, moving, options, limits, progress);
    }
    let mut spill = SpillBuffer::in_memory();
    let run = surface::run(mesh, options, limits, &mut spill, progress)?;
    let (cameras, clips) = (cameras_of(mesh, &run.placement), moving::clips_of(mesh, &run.placement));
    Ok(Scene { cameras, clips, ..run.into_scene(&mesh.name, mesh.unit, spill)? })
}

/// Voxelizes a cloud of points into a scene of one grid: a voxel for every cube with points in it, in their mean colour.
///
/// # Errors
/// If there are no points, or their voxels go beyond the limit; also if it was cancelled.
pub fn voxelize_points(
    cloud: &PointCloud,
    options: &VoxelizeOptions,
    limits: &Limits,
    progress: &VoxelizeProgress,
) -> Result<Scene, VoxelizeError> {
    let mut spill = SpillBuffer::in_memory();
    let run = points::run(cloud, options, limits, &mut spill, progress)?;
    let georeference = Some(run.placement.georeference(cloud));
    Ok(Scene { georeference, ..run.into_scene(&cloud.name, cloud.unit, spill)? })
}

/// The cameras of a mesh, in voxels.
fn cameras_of(mesh: &Mesh, placement: &Placement) -> Vec<voxtrace_scene::Camera> {
    let placed = mesh.cameras.iter().map(|camera| {
        let (eye, target) = (placement.point(camera.eye), placement.point(camera.target));
        let scale = eye.distance(target) / camera.eye.distance(camera.target);
        let lens = camera.lens.scaled(if scale.is_finite() { scale } else { 1.0 });
        voxtrace_scene::Camera { eye, target, lens, ..camera.clone() }
    });
    placed.collect()
}

/// The tiles of a grid.
fn tile_grid(placement: &Placement) -> Result<TileGrid, VoxelizeError> {
    let limit = u64::from(u32::MAX);
    TileGrid::of(placement).ok_or(VoxelizeError::TooLarge { what: "tiles of the grid", needed: limit + 1, limit })
}

/// Most materials of the scene.
fn material_count(options: &VoxelizeOptions) -> usize {
    options.max_materials.clamp(1, MAX_MATERIALS)
}

/// How many (tile, triangle) pairs or points fit into a quarter of the budget that a model of `bytes` leaves.
fn pairs_within(budget: u64, bytes: u64) -> u64 {
    /// Bytes of a pair, as two lists of them exist at once.
    const PAIR: u64 = 16;
    (budget.saturating_sub(bytes) / 4 / PAIR).max(1 << 20)
}

/// Cuts the layers of tiles into bands of at most `most` pairs each; a layer with more than that is a band on its own.
fn bands(by_layer: &[u64], most: u64) -> Vec<Range<usize>> {
    let (mut bands, mut start, mut sum) = (Vec::new(), 0, 0);
    for (layer, &pairs) in by_layer.iter().enumerate() {
        if sum + pairs > most && layer > start {
            bands.push(start..layer);
            (start, sum) = (layer, 0);
        }
        sum += pairs;
    }
    bands.push(start..by_layer.len());
    bands
}

/// Fails if there are too many voxels, or if the work was cancelled.
pub(crate) fn check_limits(
    spill: &SpillBuffer,
    limits: &Limits,
    progress: &VoxelizeProgress,
) -> Result<(), VoxelizeError> {
    if spill.voxels() > limits.voxels {
        return Err(VoxelizeError::TooLarge { what: "voxels", needed: spill.voxels(), limit: limits.voxels });
    }
    if progress.is_cancelled() { Err(VoxelizeError::Cancelled) } else { Ok(()) }
}
