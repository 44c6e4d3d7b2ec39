//! Geometry larger than memory: what is in a file is read again whenever it is needed, piece by piece, and becomes voxels
//! through buckets on the disk.

use super::ply::large::PlyTriangles;
use super::stl::StlTriangles;
use super::{Format, ImportError, ImportOptions, Limits, format, input::Input};
use crate::mesh::source::TriangleSource;
use crate::mesh::{Mesh, UpAxis};
use crate::scene::Unit;
use crate::voxelize::large::Survey;
use crate::voxelize::{self, Estimate, VoxelizeError, VoxelizeOptions, VoxelizeProgress, Written};
use std::path::Path;

/// A mesh that stays in its file.
pub struct LargeGeometry {
    source: Box<dyn TriangleSource>,
    survey: Option<Survey>,
}

/// Opens the mesh of a file without reading it into memory, if it would take more than a third of `budget` there and is in
/// one of the formats for which that is possible: binary PLY and STL. `None` where it is not.
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
    let sized: Option<(u64, Box<dyn TriangleSource>)> = match found {
        Some(Format::Ply) => PlyTriangles::open(path, budget, &options.limits)?
            .map(|source| (source.size_bytes(), Box::new(source) as Box<dyn TriangleSource>)),
        Some(Format::Stl) => {
            StlTriangles::open(path)?.map(|source| (source.size_bytes(), Box::new(source) as Box<dyn TriangleSource>))
        }
        _ => None,
    };
    let Some((_, mut source)) = sized.filter(|(size, _)| *size > budget / 3) else { return Ok(None) };
    let frame = source.frame();
    frame.name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    frame.unit = options.unit.unwrap_or(frame.unit);
    if let Some(up) = options.up {
        source = Box::new(Turned::new(source, up));
    }
    Ok(Some(LargeGeometry { source, survey: None }))
}

impl LargeGeometry {
    /// What the reader left out or put up with.
    pub fn notes(&mut self) -> &[String] {
        &self.source.frame().notes
    }

    /// Unit of the positions.
    pub fn unit(&mut self) -> Unit {
        self.source.frame().unit
    }

    /// Says what the unit of the positions is.
    pub fn set_unit(&mut self, unit: Unit) {
        self.source.frame().unit = unit;
    }

    /// Reads all of it once, to know how large it is.
    ///
    /// # Errors
    /// If it cannot be read, there is nothing, or it was cancelled.
    pub fn survey(&mut self, progress: &VoxelizeProgress) -> Result<(), VoxelizeError> {
        self.survey = Some(Survey::of(self.source.as_mut(), progress)?);
        Ok(())
    }

    /// Triangles, known once there was a survey.
    pub fn triangles(&self) -> u64 {
        self.survey.as_ref().map_or(0, Survey::triangles)
    }

    /// Estimates what voxelizing will come to; makes a survey where there was none.
    ///
    /// # Errors
    /// As [`Self::survey`]; also if there is no grid for it.
    pub fn estimate(&mut self, options: &VoxelizeOptions) -> Result<Estimate, VoxelizeError> {
        let survey = self.surveyed(&VoxelizeProgress::default())?;
        survey.estimate(self.source.as_mut(), options)
    }

    /// Voxelizes into a native file; makes a survey where there was none. The file is the one of the same geometry in memory.
    ///
    /// # Errors
    /// As [`Self::survey`]; also if filling is asked for, there are more voxels than allowed or the file cannot be written.
    pub fn voxelize_to_file(
        &mut self,
        options: &VoxelizeOptions,
        limits: &Limits,
        path: &Path,
        progress: &VoxelizeProgress,
    ) -> Result<Written, VoxelizeError> {
        let survey = self.surveyed(&VoxelizeProgress::default())?;
        voxelize::voxelize_large_to_file(self.source.as_mut(), &survey, options, limits, path, progress)
    }

    fn surveyed(&mut self, progress: &VoxelizeProgress) -> Result<Survey, VoxelizeError> {
        match &self.survey {
            Some(survey) => Ok(survey.clone()),
            None => {
                self.survey(progress)?;
                self.surveyed(progress)
            }
        }
    }
}

/// Triangles with another axis up.
struct Turned {
    source: Box<dyn TriangleSource>,
    up: UpAxis,
    piece: Mesh,
}

impl Turned {
    fn new(mut source: Box<dyn TriangleSource>, up: UpAxis) -> Self {
        let piece = source.frame().clone();
        source.frame().turn_up(up);
        Self { source, up, piece }
    }
}

impl TriangleSource for Turned {
    fn frame(&mut self) -> &mut Mesh {
        self.source.frame()
    }

    fn count(&self) -> u64 {
        self.source.count()
    }

    fn colors(&self) -> crate::mesh::source::SourceColors {
        self.source.colors()
    }

    fn has_uvs(&self) -> bool {
        self.source.has_uvs()
    }

    fn release(&mut self) {
        self.source.release();
    }

    fn for_each(&mut self, each: &mut dyn FnMut(&Mesh) -> bool) -> Result<(), ImportError> {
        let (turned, up) = (&mut self.piece, self.up);
        self.source.for_each(&mut |piece| {
            turned.clear();
            turned.positions.extend(piece.positions.iter().map(|&position| up.turned(position)));
            turned.colors.extend_from_slice(&piece.colors);
            turned.uvs.extend_from_slice(&piece.uvs);
            each(turned)
        })
    }
}
