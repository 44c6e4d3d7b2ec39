//! Voxelizing straight into a native file, tile by tile, with a checkpoint file where the work is large.

use super::spill::SpillBuffer;
use super::voxelized::{Voxelized, scene_of_source};
use super::{
    VoxelizeError, VoxelizeOptions, VoxelizeProgress, cameras_of, estimate, estimate_points, fingerprint, large,
    large_points, points, surface,
};
use crate::limits::Limits;
use crate::mesh::{Mesh, source::TriangleSource};
use crate::points::{PointCloud, source::PointSource};
use std::path::Path;
use voxtrace_scene::scene::Scene;

/// The scene that was written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Written {
    /// Occupied voxels.
    pub voxels: u64,
    /// Number of materials.
    pub materials: usize,
    /// Whether every colour is exact, none quantized.
    pub is_exact: bool,
}

/// Bytes of encoded bricks that stay in memory where no budget is given.
const MAX_SPILL_IN_MEMORY: u64 = 1 << 28;

/// Voxelizes a mesh straight into a native file, tile by tile; the file holds the scene that [`super::voxelize`] makes, packed.
/// With a memory budget, and where there are many voxels, finished tiles are spilled to a checkpoint file `PATH.part`. When the
/// process is stopped or killed, the same call resumes from it; success removes it.
///
/// # Errors
/// As [`super::voxelize_with_progress`]; also if the file cannot be written.
pub fn voxelize_to_file(
    mesh: Mesh,
    options: &VoxelizeOptions,
    limits: &Limits,
    path: &Path,
    progress: &VoxelizeProgress,
) -> Result<Written, VoxelizeError> {
    let is_small = options.memory_budget.is_none() && are_few(estimate(&mesh, options)?.voxels);
    let key = (!is_small).then(|| fingerprint::of_mesh(&mesh, options));
    into_file(key, path, progress, |spill| {
        let run = surface::run(&mesh, options, limits, spill, progress)?;
        let mut scene = scene_of_source(&mesh.name, mesh.unit);
        scene.cameras = cameras_of(&mesh, &run.placement);
        // The mesh may be the larger part of the memory.
        drop(mesh);
        Ok((run, scene))
    })
}

/// As [`voxelize_to_file`], out of core: for triangles that stay in their file. `stamp` changes when the file does; it decides
/// whether a checkpoint may be resumed.
pub fn voxelize_large_to_file(
    (source, stamp): (&mut dyn TriangleSource, &str),
    survey: &large::Survey,
    options: &VoxelizeOptions,
    limits: &Limits,
    path: &Path,
    progress: &VoxelizeProgress,
) -> Result<Written, VoxelizeError> {
    let key = fingerprint::of_large_mesh(source.frame(), stamp, survey.summary(), options);
    let work = |spill: &mut SpillBuffer| large::run(source, survey, options, limits, path, spill, progress);
    into_file(Some(key), path, progress, work)
}

/// As [`voxelize_points_to_file`], out of core: for points that stay in their file. `stamp` changes when the file does; it
/// decides whether a checkpoint may be resumed.
pub fn voxelize_large_points_to_file(
    (source, stamp): (&mut dyn PointSource, &str),
    survey: &large_points::Survey,
    options: &VoxelizeOptions,
    limits: &Limits,
    path: &Path,
    progress: &VoxelizeProgress,
) -> Result<Written, VoxelizeError> {
    let key = fingerprint::of_large_points(source.frame(), stamp, survey.summary(), options);
    let work = |spill: &mut SpillBuffer| large_points::run(source, survey, options, limits, path, spill, progress);
    into_file(Some(key), path, progress, work)
}

/// Whether the bricks of so many voxels stay in memory. Such work takes so little time that it needs no checkpoints.
fn are_few(voxels: u64) -> bool {
    voxels.saturating_mul(5) < MAX_SPILL_IN_MEMORY
}

/// Writes the bricks that `work` leaves in a spill buffer into a native file. With a key, the fingerprint of the work, there are
/// checkpoints.
fn into_file(
    key: Option<u128>,
    path: &Path,
    progress: &VoxelizeProgress,
    work: impl FnOnce(&mut SpillBuffer) -> Result<(Voxelized, Scene), VoxelizeError>,
) -> Result<Written, VoxelizeError> {
    with_spill(key, path, progress, |spill| {
        let (run, scene) = work(spill)?;
        run.write(scene, spill, path, progress)
    })
}

/// Does work with a spill buffer beside its output, which is kept where the work is interrupted; without a key it is in memory.
pub(crate) fn with_spill(
    key: Option<u128>,
    path: &Path,
    progress: &VoxelizeProgress,
    work: impl FnOnce(&mut SpillBuffer) -> Result<Written, VoxelizeError>,
) -> Result<Written, VoxelizeError> {
    let mut spill = match key {
        None => SpillBuffer::in_memory(),
        Some(key) => SpillBuffer::beside(path, key)?,
    };
    let written = work(&mut spill);
    if let Err(VoxelizeError::Cancelled | VoxelizeError::Io(_)) = written {
        spill.keep(progress);
    }
    written
}

/// Voxelizes a cloud of points straight into a native file, which holds the scene of [`super::voxelize_points`], packed.
///
/// # Errors
/// As [`super::voxelize_points`]; also if the file cannot be written.
pub fn voxelize_points_to_file(
    cloud: PointCloud,
    options: &VoxelizeOptions,
    limits: &Limits,
    path: &Path,
    progress: &VoxelizeProgress,
) -> Result<Written, VoxelizeError> {
    // There are no more voxels than points; the estimate takes a while.
    let is_small = options.memory_budget.is_none()
        && (are_few(cloud.positions.len() as u64) || are_few(estimate_points(&cloud, options)?.voxels));
    let key = (!is_small).then(|| fingerprint::of_points(&cloud, options));
    into_file(key, path, progress, |spill| {
        let run = points::run(&cloud, options, limits, spill, progress)?;
        let mut scene = scene_of_source(&cloud.name, cloud.unit);
        scene.georeference = Some(run.placement.georeference(&cloud));
        // The points may be the larger part of the memory.
        drop(cloud);
        Ok((run, scene))
    })
}
