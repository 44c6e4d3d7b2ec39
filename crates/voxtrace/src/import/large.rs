//! Geometry larger than memory: what is in a file is read again whenever it is needed, piece by piece, and becomes voxels
//! through buckets on the disk.

use super::las::large::LasPoints;
use super::ply::large::PlyTriangles;
use super::ply::points::PlyPoints;
use super::stl::StlTriangles;
use super::turned::{TurnedPoints, TurnedTriangles};
use super::{Format, ImportError, ImportOptions, Limits, format, input::Input};
use crate::mesh::source::TriangleSource;
use crate::points::source::PointSource;
use crate::scene::Unit;
use crate::voxelize::{self, Estimate, VoxelizeError, VoxelizeOptions, VoxelizeProgress, Written, large, large_points};
use std::path::Path;

/// A mesh or a cloud of points that stays in its file.
pub struct LargeGeometry {
    content: Content,
    /// Length and time of the file.
    stamp: String,
}

enum Content {
    Mesh(Box<dyn TriangleSource>, Option<large::Survey>),
    Points(Box<dyn PointSource>, Option<large_points::Survey>),
}

impl Content {
    fn mesh(source: impl TriangleSource + 'static) -> Self {
        Self::Mesh(Box::new(source), None)
    }

    fn points(source: impl PointSource + 'static) -> Self {
        Self::Points(Box::new(source), None)
    }
}

/// Opens the mesh or the points of a file without reading them into memory, if they would take more than a third of `budget`
/// there and are in one of the formats for which that is possible: binary PLY, binary STL, LAS, LAZ. `None` where not.
///
/// # Errors
/// If the file cannot be read or is not what it says.
pub fn open_large(path: &Path, options: &ImportOptions, budget: u64) -> Result<Option<LargeGeometry>, ImportError> {
    let limits = Limits { bytes: u64::MAX, ..options.limits };
    let mut input = Input::open(path, &limits)?;
    if input.remaining().is_none() {
        return Ok(None);
    }
    let found = Format::detect(input.peek(format::HEAD)?, path);
    drop(input);
    let sized = match found {
        Some(Format::Ply) => match PlyTriangles::open(path, budget, &options.limits)? {
            Some(source) => Some((source.size_bytes(), Content::mesh(source))),
            None => PlyPoints::open(path)?.map(|source| (source.size_bytes(), Content::points(source))),
        },
        Some(Format::Stl) => StlTriangles::open(path)?.map(|source| (source.size_bytes(), Content::mesh(source))),
        Some(Format::Las) => {
            let source = LasPoints::open(path, &options.limits)?;
            Some((source.size_bytes(), Content::points(source)))
        }
        _ => None,
    };
    let Some((_, mut content)) = sized.filter(|(size, _)| *size > budget / 3) else { return Ok(None) };
    let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    content = match content {
        Content::Mesh(mut source, _) => {
            let frame = source.frame();
            (frame.name, frame.unit) = (name, options.unit.unwrap_or(frame.unit));
            match options.up {
                Some(up) => Content::mesh(TurnedTriangles::new(source, up)),
                None => Content::Mesh(source, None),
            }
        }
        Content::Points(mut source, _) => {
            let frame = source.frame();
            (frame.name, frame.unit) = (name, options.unit.unwrap_or(frame.unit));
            match options.up {
                Some(up) => Content::points(TurnedPoints::new(source, up)),
                None => Content::Points(source, None),
            }
        }
    };
    Ok(Some(LargeGeometry { content, stamp: stamp_of(path)? }))
}

/// What changes with a file.
fn stamp_of(path: &Path) -> Result<String, ImportError> {
    let metadata = std::fs::metadata(path).map_err(|error| ImportError::io(path, error))?;
    Ok(format!("{} {:?}", metadata.len(), metadata.modified().ok()))
}

impl LargeGeometry {
    /// What the reader left out or put up with; all of it is known after a survey.
    pub fn notes(&mut self) -> &[String] {
        match &mut self.content {
            Content::Mesh(source, _) => &source.frame().notes,
            Content::Points(source, _) => &source.frame().notes,
        }
    }

    /// Unit of the positions.
    pub fn unit(&mut self) -> Unit {
        match &mut self.content {
            Content::Mesh(source, _) => source.frame().unit,
            Content::Points(source, _) => source.frame().unit,
        }
    }

    /// Says what the unit of the positions is.
    pub fn set_unit(&mut self, unit: Unit) {
        match &mut self.content {
            Content::Mesh(source, _) => source.frame().unit = unit,
            Content::Points(source, _) => source.frame().unit = unit,
        }
    }

    /// Whether it is points.
    pub fn is_points(&self) -> bool {
        matches!(self.content, Content::Points(..))
    }

    /// Reads all of it once, to know how large it is and how many voxels it may become with these options.
    ///
    /// # Errors
    /// If it cannot be read, there is nothing, or it was cancelled.
    pub fn survey(&mut self, options: &VoxelizeOptions, progress: &VoxelizeProgress) -> Result<(), VoxelizeError> {
        match &mut self.content {
            Content::Mesh(source, survey) => *survey = Some(large::Survey::of(source.as_mut(), progress)?),
            Content::Points(source, survey) => {
                *survey = Some(large_points::Survey::of(source.as_mut(), options, progress)?);
            }
        }
        Ok(())
    }

    /// Triangles or points, known once there was a survey.
    pub fn count(&self) -> u64 {
        match &self.content {
            Content::Mesh(_, survey) => survey.as_ref().map_or(0, large::Survey::triangles),
            Content::Points(_, survey) => survey.as_ref().map_or(0, large_points::Survey::points),
        }
    }

    /// Estimates what voxelizing will come to; makes a survey where there was none.
    ///
    /// # Errors
    /// As [`Self::survey`]; also if there is no grid for it.
    pub fn estimate(&mut self, options: &VoxelizeOptions) -> Result<Estimate, VoxelizeError> {
        match &mut self.content {
            Content::Mesh(source, Some(survey)) => survey.estimate(source.as_mut(), options),
            Content::Points(source, Some(survey)) => survey.estimate(source.as_mut(), options),
            _ => {
                self.survey(options, &VoxelizeProgress::default())?;
                self.estimate(options)
            }
        }
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
        match &mut self.content {
            Content::Mesh(source, Some(survey)) => voxelize::voxelize_large_to_file(
                (source.as_mut(), &self.stamp),
                survey,
                options,
                limits,
                path,
                progress,
            ),
            Content::Points(source, Some(survey)) => voxelize::voxelize_large_points_to_file(
                (source.as_mut(), &self.stamp),
                survey,
                options,
                limits,
                path,
                progress,
            ),
            _ => {
                self.survey(options, &VoxelizeProgress::default())?;
                self.voxelize_to_file(options, limits, path, progress)
            }
        }
    }
}
