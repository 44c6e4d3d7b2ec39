//! Geometry larger than memory: what is in a file is read again whenever it is needed, piece by piece, and becomes voxels
//! through buckets on the disk.

use super::Reader;
use super::large_content::{Content, LargeContent};
use super::options::ImportOptions;
use std::path::{Path, PathBuf};
use voxtrace_scene::scene::LengthUnit;
use voxtrace_voxelize::mesh::UpAxis;
use voxtrace_voxelize::points::source::PointSource;
use voxtrace_voxelize::voxelize::{Estimate, VoxelizeError, VoxelizeOptions, VoxelizeProgress, Written};
use voxtrace_voxelize::{ImportError, Limits};

/// A mesh or a cloud of points that stays in its file.
pub struct LargeGeometry {
    content: Box<dyn Content>,
    /// Length and time of the file.
    stamp: String,
}

impl LargeGeometry {
    /// What a reader has opened of one or several files, with the points, the unit and the axis that are asked for; `path` names it.
    pub(crate) fn new(
        found: LargeContent,
        path: &Path,
        files: &[PathBuf],
        reader: &Reader,
        options: &ImportOptions,
    ) -> Result<Self, ImportError> {
        let mut content = found.content;
        if options.points.is_asked() && !reader.filters_points {
            content = content.filtered(path, options.points);
        }
        let about = content.about();
        *about.name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        *about.unit = options.unit.unwrap_or(*about.unit);
        if let (Some(from), Some(to)) = (reader.up_axis, options.up) {
            // The reader has turned it to z already.
            if from != UpAxis::Z {
                content = content.z_up(from.inverse());
            }
            content = content.z_up(to);
        }
        let beside = found.files.iter().filter(|file| file.as_path() != path);
        let stamps = files.iter().chain(beside).map(|file| stamp_of(file)).collect::<Result<Vec<String>, _>>()?;
        let chosen = if options.points.is_asked() { format!(" {:?}", options.points) } else { String::new() };
        Ok(Self { content, stamp: stamps.join(" ") + &chosen })
    }
}

/// What changes with a file.
pub(super) fn stamp_of(path: &Path) -> Result<String, ImportError> {
    let metadata = std::fs::metadata(path).map_err(|error| ImportError::io(path, error))?;
    Ok(format!("{} {:?}", metadata.len(), metadata.modified().ok()))
}

impl LargeGeometry {
    /// The points, where it is points.
    pub(crate) fn into_points(self) -> Option<Box<dyn PointSource>> {
        self.content.into_points()
    }

    /// What the reader left out or put up with; all of it is known after a survey.
    pub fn notes(&mut self) -> &[String] {
        self.content.about().notes
    }

    /// Unit of the positions.
    pub fn unit(&mut self) -> LengthUnit {
        *self.content.about().unit
    }

    /// Says what the unit of the positions is.
    pub fn set_unit(&mut self, unit: LengthUnit) {
        *self.content.about().unit = unit;
    }

    /// Whether it is points.
    pub fn is_points(&self) -> bool {
        self.content.is_points()
    }

    /// Reads all of it once, to know how large it is and how many voxels it may become with these options.
    ///
    /// # Errors
    /// If it cannot be read, there is nothing, or it was cancelled.
    pub fn survey(&mut self, options: &VoxelizeOptions, progress: &VoxelizeProgress) -> Result<(), VoxelizeError> {
        self.content.survey(options, progress)
    }

    /// Triangles or points, known once there was a survey.
    pub fn count(&self) -> u64 {
        self.content.count().unwrap_or(0)
    }

    /// Estimates what voxelizing will come to; makes a survey where there was none.
    ///
    /// # Errors
    /// As [`Self::survey`]; also if there is no grid for it.
    pub fn estimate(&mut self, options: &VoxelizeOptions) -> Result<Estimate, VoxelizeError> {
        self.survey_once(options)?;
        self.content.estimate(options)
    }

    /// Voxelizes into a native file; makes a survey where there was none. The file is the one of the same geometry in memory,
    /// byte for byte. What is inside of closed surfaces is not filled.
    ///
    /// # Errors
    /// As [`Self::survey`]; also if there are more voxels than allowed or the file cannot be written.
    pub fn voxelize_to_file(
        &mut self,
        options: &VoxelizeOptions,
        limits: &Limits,
        path: &Path,
        progress: &VoxelizeProgress,
    ) -> Result<Written, VoxelizeError> {
        self.survey_once(options)?;
        self.content.voxelize_to_file(&self.stamp, options, limits, path, progress)
    }

    fn survey_once(&mut self, options: &VoxelizeOptions) -> Result<(), VoxelizeError> {
        if self.content.count().is_some() { Ok(()) } else { self.survey(options, &VoxelizeProgress::default()) }
    }
}
