//! Voxelizing some files of a cloud into a part: a log of bricks that are finished, and of sums where points of other files may be in
//! the same bricks.

use super::seams::Seams;
use super::tiles::TileSurvey;
use super::{Grid, Work};
use crate::limits::Limits;
use crate::points::source::{PointSource, TiledPoints};
use crate::voxelize::color_histogram::ColorHistogram;
use crate::voxelize::spill::SpillBuffer;
use crate::voxelize::{VoxelizeError, VoxelizeOptions, VoxelizeProgress};
use std::ops::Range;
use std::path::Path;
use voxtrace_core::atomic_file::TemporaryFile;

/// Voxelizes some files of a cloud that was surveyed into the part `path`, which is there whole or not at all; returns the number of
/// their points. What becomes of all parts together is the same, however files are shared among them.
///
/// # Errors
/// If the survey is not whole, wants measures or is of other work, files cannot be read, there are more voxels than allowed, the
/// part cannot be written, or it was cancelled.
pub fn voxelize_tiles(
    (source, stamp): (&mut dyn TiledPoints, &str),
    survey: &TileSurvey,
    files: Range<usize>,
    options: &VoxelizeOptions,
    limits: &Limits,
    path: &Path,
    progress: &VoxelizeProgress,
) -> Result<u64, VoxelizeError> {
    survey.teach((&mut *source, stamp), files.clone(), options)?;
    if survey.wants_measures(options)? {
        return Err(VoxelizeError::Parts("the survey wants measures of all files, which a second pass makes".into()));
    }
    let source: &mut dyn PointSource = source;
    let (found, key) = (survey.survey(), survey.part_key());
    let grid = Grid::of(found.placement(source.frame().offset, options)?, found.scale(options))?;
    let seams = Seams::of(survey.tiles(), &files, &grid);
    let temporary = TemporaryFile::beside(path)?;
    let mut spill = SpillBuffer::of_part(temporary.try_clone()?, key)?;
    let work = Work { survey: found, options, limits, path, progress, seams: Some(&seams) };
    // Which colours there are is asked when all parts are there.
    work.spill_bricks(source, &ColorHistogram::default(), &mut spill)?;
    spill.end_part(files.start as u64..files.end as u64)?;
    temporary.replace(path)?;
    Ok(seams.points())
}
