//! Geometry larger than memory: what is in a file is read again whenever it is needed, piece by piece, and becomes voxels
//! through buckets on the disk.

mod content;

use super::gltf::large::GltfTriangles;
use super::las::large::LasPoints;
use super::ply::large::PlyTriangles;
use super::ply::points::PlyPoints;
use super::stl::StlTriangles;
use super::{Format, ImportError, ImportOptions, Limits, format, input::Input};
use content::{Content, Points, Triangles};
use std::path::Path;
use voxtrace_scene::scene::Unit;
use voxtrace_voxelize::mesh::UpAxis;
use voxtrace_voxelize::voxelize::{Estimate, VoxelizeError, VoxelizeOptions, VoxelizeProgress, Written};

/// A mesh or a cloud of points that stays in its file.
pub struct LargeGeometry {
    content: Box<dyn Content>,
    /// Length and time of the file.
    stamp: String,
}

/// Opens the mesh or the points of a file without reading them into memory, if they would take more than a third of `budget`
/// there and are in one of the formats for which that is possible: binary PLY, binary STL, binary glTF whose
/// arrays are plain, LAS, LAZ. `None` where not.
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
            Some(source) => Some((source.size_bytes(), Triangles::boxed(source))),
            None => PlyPoints::open(path)?.map(|source| (source.size_bytes(), Points::boxed(source))),
        },
        Some(Format::Gltf) => GltfTriangles::open(path, budget, &options.limits)?
            .map(|source| (source.size_bytes(), Triangles::boxed(source))),
        Some(Format::Stl) => StlTriangles::open(path)?.map(|source| (source.size_bytes(), Triangles::boxed(source))),
        Some(Format::Las) => {
            let source = LasPoints::open(path, &options.limits)?;
            Some((source.size_bytes(), Points::boxed(source)))
        }
        _ => None,
    };
    let Some((_, mut content)) = sized.filter(|(size, _)| *size > budget / 3) else { return Ok(None) };
    let about = content.about();
    *about.name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    *about.unit = options.unit.unwrap_or(*about.unit);
    if let Some(up) = options.up {
        if found == Some(Format::Gltf) {
            // Undo the turn from y up, which the reader has made.
            content = content.turned(UpAxis::MinusY);
        }
        content = content.turned(up);
    }
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
        self.content.about().notes
    }

    /// Unit of the positions.
    pub fn unit(&mut self) -> Unit {
        *self.content.about().unit
    }

    /// Says what the unit of the positions is.
    pub fn set_unit(&mut self, unit: Unit) {
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
