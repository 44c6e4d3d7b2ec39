//! Clouds of several files that many processes voxelize together: each surveys some files, each voxelizes some into a part, and one
//! merges the parts to the scene that one process makes, byte for byte.

use super::options::ImportOptions;
use std::ops::Range;
use std::path::{Path, PathBuf};
use voxtrace_scene::scene::LengthUnit;
use voxtrace_voxelize::points::source::{PointSource, TiledPoints};
use voxtrace_voxelize::voxelize::large_points::{TilePart, TileSurvey, merge_tiles, voxelize_tiles};
use voxtrace_voxelize::voxelize::{VoxelizeError, VoxelizeOptions, VoxelizeProgress, Written};
use voxtrace_voxelize::{ImportError, Limits};

/// A cloud of points in several files, of which several processes voxelize some each. Files are told by their numbers, from 0 on, in the
/// order in which they were named or, of a folder, in that of their names.
pub struct TiledCloud {
    source: Box<dyn PointSource>,
    /// Names and lengths of the files, and how they are read: the same wherever a copy of them lies.
    stamp: String,
}

impl TiledCloud {
    /// What a reader has opened of these files; `None` where they cannot be read apart.
    pub(crate) fn new(
        mut source: Box<dyn PointSource>,
        files: &[PathBuf],
        options: &ImportOptions,
    ) -> Result<Option<Self>, ImportError> {
        if source.tiled().is_none() {
            return Ok(None);
        }
        let described = |path: &PathBuf| {
            let metadata = std::fs::metadata(path).map_err(|error| ImportError::io(path, error))?;
            Ok(format!("{:?} {}", path.file_name().unwrap_or_default(), metadata.len()))
        };
        let described: Vec<String> = files.iter().map(described).collect::<Result<_, ImportError>>()?;
        let how = format!("{:?} {:?} {:?}", options.points, options.up, options.unit);
        Ok(Some(Self { source, stamp: described.join(" ") + &how }))
    }

    /// Points of each file, as their headers say. Files outside of the box that is asked for are left out.
    pub fn points_of_tiles(&mut self) -> Vec<u64> {
        self.source.tiled().map(|files| files.points_of_tiles()).unwrap_or_default()
    }

    /// Shares the files among at most so many parts: consecutive ones, with about as many points in each part.
    pub fn shares(&mut self, parts: usize) -> Vec<Range<usize>> {
        shares_of(&self.points_of_tiles(), parts)
    }

    /// What the reader left out or put up with; all of it is known after the merge.
    pub fn notes(&mut self) -> &[String] {
        &self.source.frame().notes
    }

    /// Unit of the positions.
    pub fn unit(&mut self) -> LengthUnit {
        self.source.frame().unit
    }

    /// Says what the unit of the positions is.
    pub fn set_unit(&mut self, unit: LengthUnit) {
        self.source.frame().unit = unit;
    }

    fn files(&mut self) -> Result<(&mut dyn TiledPoints, &str), VoxelizeError> {
        let files = self.source.tiled().ok_or(VoxelizeError::NoPoints)?;
        Ok((files, &self.stamp))
    }

    /// Makes the first pass over some files.
    ///
    /// # Errors
    /// If there are no such files, one cannot be read, or it was cancelled.
    pub fn survey(
        &mut self,
        files: Range<usize>,
        options: &VoxelizeOptions,
        progress: &VoxelizeProgress,
    ) -> Result<TileSurvey, VoxelizeError> {
        TileSurvey::of(self.files()?, files, options, progress)
    }

    /// Checks that a survey is of all files with these options; afterwards notes are known.
    ///
    /// # Errors
    /// If not, there are no points, or none that are asked for.
    pub fn check(&mut self, survey: &TileSurvey, options: &VoxelizeOptions) -> Result<(), VoxelizeError> {
        survey.teach_all(self.files()?, options)
    }

    /// Makes the second pass over some files, where [`TileSurvey::wants_measures`]: bytes for
    /// [`voxtrace_voxelize::voxelize::large_points::joined_bytes`].
    ///
    /// # Errors
    /// As [`Self::survey`]; also if the survey is not of all files, or of other work.
    pub fn measure(
        &mut self,
        survey: &TileSurvey,
        files: Range<usize>,
        options: &VoxelizeOptions,
        progress: &VoxelizeProgress,
    ) -> Result<Vec<u8>, VoxelizeError> {
        survey.measure(self.files()?, files, options, progress)
    }

    /// What headers and first points let expect of all files, so that parts can be made before all points were seen; `None` where that is not enough.
    ///
    /// # Errors
    /// If a file cannot be read.
    pub fn expected(&mut self, options: &VoxelizeOptions) -> Result<Option<TileSurvey>, VoxelizeError> {
        TileSurvey::expected(self.files()?, options)
    }

    /// Voxelizes some files into the part `path`, with a survey of all of them or with what is expected of them. Intermediate data lies beside it.
    ///
    /// # Errors
    /// As [`Self::measure`]; also if the survey wants measures, there are more voxels than allowed, or the part cannot be written.
    pub fn voxelize(
        &mut self,
        survey: &TileSurvey,
        files: Range<usize>,
        options: &VoxelizeOptions,
        limits: &Limits,
        path: &Path,
        progress: &VoxelizeProgress,
    ) -> Result<TilePart, VoxelizeError> {
        voxelize_tiles(self.files()?, survey, files, options, limits, path, progress)
    }

    /// Makes a native file of all parts: the bytes that one process writes. No file is read but for its header.
    ///
    /// # Errors
    /// If a part is missing, damaged or of other work, there are more voxels than allowed, the file cannot be written, or it was cancelled.
    pub fn merge(
        &mut self,
        survey: &TileSurvey,
        parts: &[PathBuf],
        options: &VoxelizeOptions,
        limits: &Limits,
        path: &Path,
        progress: &VoxelizeProgress,
    ) -> Result<Written, VoxelizeError> {
        merge_tiles(self.files()?, survey, parts, options, limits, path, progress)
    }
}

/// Shares files of these sizes among at most so many parts: consecutive ones, with about as much in each.
pub(super) fn shares_of(sizes: &[u64], parts: usize) -> Vec<Range<usize>> {
    // A file with nothing in it takes some time, too.
    let all: u64 = sizes.iter().map(|&size| size.max(1)).sum();
    let (mut shares, mut start, mut sum) = (Vec::<Range<usize>>::new(), 0, 0u64);
    for (file, &size) in sizes.iter().enumerate() {
        sum += size.max(1);
        let goal = u128::from(all) * (shares.len() as u128 + 1);
        if u128::from(sum) * parts.max(1) as u128 >= goal || file + 1 == sizes.len() {
            shares.push(start..file + 1);
            start = file + 1;
        }
    }
    shares
}
