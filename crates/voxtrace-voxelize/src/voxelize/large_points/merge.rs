//! From parts to the scene: bricks that several of them reach into are finished, materials are chosen once for all, and the file is
//! written as one process writes it.

use super::tiles::TileSurvey;
use super::{Grid, scene_of};
use crate::limits::Limits;
use crate::points::source::{PointSource, TiledPoints};
use crate::voxelize::color_histogram::ColorHistogram;
use crate::voxelize::points::finish;
use crate::voxelize::spill::SpillBuffer;
use crate::voxelize::{VoxelizeError, VoxelizeOptions, VoxelizeProgress, Written, check_limits};
use std::path::{Path, PathBuf};

/// Makes a native file of the parts of a cloud, in any order: the bytes that [`crate::voxelize::voxelize_large_points_to_file`] writes.
///
/// # Errors
/// If a part is missing, damaged or of other work, files are in two of them, there are more voxels than allowed, the file cannot be
/// written, or it was cancelled.
pub fn merge_tiles(
    (source, stamp): (&mut dyn TiledPoints, &str),
    survey: &TileSurvey,
    parts: &[PathBuf],
    options: &VoxelizeOptions,
    limits: &Limits,
    path: &Path,
    progress: &VoxelizeProgress,
) -> Result<Written, VoxelizeError> {
    if survey.is_expected() {
        return Err(VoxelizeError::Parts(
            "what was expected of the files is not held against what parts have found".into(),
        ));
    }
    let count = survey.tile_count();
    survey.teach((&mut *source, stamp), 0..count, options)?;
    let source: &mut dyn PointSource = source;
    let found = survey.survey();
    let grid = Grid::of(found.placement(source.frame().offset, options)?, found.scale(options))?;
    let histogram = ColorHistogram::default();
    let work = (survey.part_key(), count as u64, "files");
    let mut spill = SpillBuffer::of_parts(parts, work, (&histogram, options.points.min_points), path, progress)?;
    check_limits(&spill, limits, progress)?;
    let scene = scene_of(source, &grid);
    let run = finish(grid.placement, &histogram, options, &spill)?;
    run.write(scene, &mut spill, path, progress)
}
