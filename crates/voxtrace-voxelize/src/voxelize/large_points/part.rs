//! Voxelizing some files of a cloud into a part: a log of bricks that are finished, and of sums where points of other files may be in
//! the same bricks. Where the survey is only what was expected, the files are surveyed on the way.

use super::seams::Seams;
use super::survey::Announced;
use super::tiles::{Look, TileSurvey};
use super::{Grid, Work};
use crate::import_error::ImportError;
use crate::limits::Limits;
use crate::points::source::{PointSource, TiledPoints};
use crate::points::{Attributes, PointCloud};
use crate::voxelize::color_histogram::ColorHistogram;
use crate::voxelize::spill::SpillBuffer;
use crate::voxelize::{VoxelizeError, VoxelizeOptions, VoxelizeProgress};
use glam::DVec3;
use std::ops::Range;
use std::path::Path;
use voxtrace_core::atomic_file::TemporaryFile;

/// What voxelizing some files has found beside their voxels.
pub struct TilePart {
    /// Number of their points.
    pub points: u64,
    /// Their survey, where they were voxelized with what was expected of them alone.
    pub found: Option<TileSurvey>,
}

/// Voxelizes some files of a cloud into the part `path`, which is there whole or not at all. It was surveyed, or it is known what is expected of it;
/// then what all parts have found is to bear that out ([`TileSurvey::bear_out`]). What becomes of all parts together is the same, however files are
/// shared among them.
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
) -> Result<TilePart, VoxelizeError> {
    survey.teach((&mut *source, stamp), files.clone(), options)?;
    if survey.wants_measures(options)? {
        return Err(VoxelizeError::Parts("the survey wants measures of all files, which a second pass makes".into()));
    }
    let look = Look::new(Announced::of(&*source, options).without_guess());
    let mut looking = Looking { look, files: files.clone(), source };
    let source: &mut dyn PointSource = if survey.is_expected() { &mut looking } else { looking.source };
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
    let found = survey.is_expected().then(|| looking.look.survey(survey.about()));
    Ok(TilePart { points: seams.points(), found })
}

/// Files that are surveyed while a pass is made over them.
struct Looking<'a> {
    source: &'a mut dyn TiledPoints,
    files: Range<usize>,
    look: Look,
}

impl PointSource for Looking<'_> {
    fn frame(&mut self) -> &mut PointCloud {
        self.source.frame()
    }

    fn count(&self) -> u64 {
        self.source.count()
    }

    fn attributes(&self) -> Attributes {
        self.source.attributes()
    }

    fn announced_bounds(&self) -> Option<(DVec3, DVec3)> {
        self.source.announced_bounds()
    }

    fn for_each(&mut self, each: &mut dyn FnMut(&PointCloud) -> bool) -> Result<(), ImportError> {
        for number in self.files.clone() {
            let (mut tile, mut goes_on) = (self.look.begin(number), true);
            let facts = self.source.visit_tile(number, &mut |piece| {
                self.look.add(&mut tile, piece);
                goes_on = each(piece);
                goes_on
            })?;
            if !goes_on {
                break;
            }
            self.look.end(tile, facts);
        }
        Ok(())
    }
}
