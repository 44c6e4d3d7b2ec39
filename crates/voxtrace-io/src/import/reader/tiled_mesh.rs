//! Meshes of several files that are one: read together, one after the other while they are voxelized out of core, or shared among processes
//! that voxelize some of their space each.

use super::large_content::{About, Content, LargeContent};
use super::{Data, Geometry, ImportOptions, PointFilter};
use crate::import::readers::READERS;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use voxtrace_scene::scene::LengthUnit;
use voxtrace_voxelize::mesh::joined::{Joined, Part};
use voxtrace_voxelize::mesh::{Mesh, UpAxis};
use voxtrace_voxelize::voxelize::large::{self, MeshFiles, MeshTiles, ReadMesh};
use voxtrace_voxelize::voxelize::{
    Estimate, VoxelizeError, VoxelizeOptions, VoxelizeProgress, Written, voxelize_large_to_file,
};
use voxtrace_voxelize::{ImportError, ImportErrorKind, Limits};

fn other(path: &Path, what: &str) -> ImportError {
    ImportError::of_file(path, ImportErrorKind::OtherTiles(what.into()))
}

/// Reads the meshes of several files as one, in their order.
pub(crate) fn read(paths: &[PathBuf], options: &ImportOptions) -> Result<Data, ImportError> {
    let files = Files { paths: paths.into(), options: options.clone() };
    let meshes = (0..paths.len()).map(|number| files.read(number)).collect::<Result<Vec<Mesh>, _>>()?;
    files.check_units(meshes.iter().map(|mesh| mesh.unit).enumerate())?;
    let parts: Vec<Part> = meshes.iter().map(Part::of).collect();
    let whole = Joined::of(&parts).and_then(|joined| joined.whole(meshes));
    whole.map(|mesh| Geometry::Mesh(mesh).into()).map_err(|fault| other(&paths[0], &String::from(fault)))
}

/// Files of meshes, which are read one at a time.
#[derive(Clone, Debug)]
struct Files {
    paths: Arc<[PathBuf]>,
    options: ImportOptions,
}

impl Files {
    fn read(&self, number: usize) -> Result<Mesh, ImportError> {
        let path = &self.paths[number];
        match READERS.open(path, &self.options)?.read()? {
            Data::Geometry(Geometry::Mesh(mesh)) if mesh.moving.is_none() => Ok(mesh),
            Data::Geometry(Geometry::Mesh(_)) => Err(other(path, "what moves is not read as one with other files")),
            _ => Err(other(path, "there is no mesh in it to be one with those of the other files")),
        }
    }

    /// Refuses meshes of different units, by their files and not by their names, which may be alike.
    fn check_units(&self, units: impl IntoIterator<Item = (usize, LengthUnit)>) -> Result<(), ImportError> {
        let mut units = units.into_iter();
        let Some((first, unit)) = units.next() else { return Ok(()) };
        match units.find(|&(_, other)| other != unit).and_then(|(number, _)| self.paths.get(number)) {
            Some(path) => {
                let first = self.paths.get(first).map_or(Path::new(""), PathBuf::as_path);
                Err(other(path, &format!("this mesh and {} have different units", first.display())))
            }
            None => Ok(()),
        }
    }

    /// Reads the meshes of a survey.
    fn reader(&self) -> Box<ReadMesh<'static>> {
        let files = self.clone();
        Box::new(move |number| files.read(number))
    }

    fn survey(
        &self,
        stamp: &str,
        files: Range<usize>,
        progress: &VoxelizeProgress,
    ) -> Result<MeshTiles, VoxelizeError> {
        MeshTiles::of((self.paths.len(), stamp, self.reader()), files, progress)
    }
}

/// Meshes of several files, which several processes voxelize together. Files are told by their numbers, from 0 on, in the order in which they
/// were named.
#[derive(Debug)]
pub struct TiledMesh {
    files: Files,
    lengths: Vec<u64>,
    /// Names and lengths of the files, and how they are read: the same wherever a copy of them lies.
    stamp: String,
}

impl TiledMesh {
    /// The meshes of these files.
    ///
    /// # Errors
    /// If there is none, or one of them is not there.
    pub fn open(paths: Vec<PathBuf>, options: &ImportOptions) -> Result<Self, ImportError> {
        if paths.is_empty() {
            return Err(other(Path::new(""), "no file is named"));
        }
        let length = |path: &PathBuf| std::fs::metadata(path).map(|metadata| metadata.len());
        let lengths = paths.iter().map(|path| length(path).map_err(|error| ImportError::io(path, error)));
        let lengths: Vec<u64> = lengths.collect::<Result<_, _>>()?;
        let names: Vec<_> = paths.iter().map(|path| path.file_name().unwrap_or_default()).collect();
        let stamp = format!("{names:?} {lengths:?} {:?} {:?}", options.up, options.unit);
        Ok(Self { files: Files { paths: paths.into(), options: options.clone() }, lengths, stamp })
    }

    /// Shares the files among at most so many surveys: consecutive ones, with about as many bytes in each.
    pub fn shares(&self, surveys: usize) -> Vec<Range<usize>> {
        super::tiled_cloud::shares_of(&self.lengths, surveys)
    }

    /// Looks through some files.
    ///
    /// # Errors
    /// If there are no such files, one cannot be read or holds no mesh, or it was cancelled.
    pub fn survey(&self, files: Range<usize>, progress: &VoxelizeProgress) -> Result<MeshTiles, VoxelizeError> {
        self.files.survey(&self.stamp, files, progress)
    }

    /// Checks that a survey is of all files; returns the unit of their positions, and what readers left out or put up with.
    ///
    /// # Errors
    /// If it is not, or the meshes cannot be one.
    pub fn check(&self, survey: &MeshTiles) -> Result<(LengthUnit, Vec<String>), VoxelizeError> {
        survey.check(&self.stamp)?;
        self.files.check_units(survey.units())?;
        let frame = survey.joined()?.frame;
        Ok((frame.unit, frame.notes))
    }

    /// Voxelizes the share `share.0` of `share.1` into the part `path`; returns how many files were read. Intermediate data lies beside it.
    ///
    /// # Errors
    /// As [`Self::check`]; also if there is no such share, a file cannot be read or has changed, there are more voxels than allowed, the part cannot
    /// be written, or it was cancelled.
    pub fn voxelize(
        &self,
        survey: &MeshTiles,
        share: (usize, usize),
        options: &VoxelizeOptions,
        limits: &Limits,
        path: &Path,
        progress: &VoxelizeProgress,
    ) -> Result<usize, VoxelizeError> {
        let tiles = (survey, &*self.stamp, self.files.reader());
        large::voxelize_mesh_tiles(tiles, share, options, limits, path, progress)
    }

    /// Makes a native file of the parts of all of so many shares: the bytes that one process writes. No file is read.
    ///
    /// # Errors
    /// As [`Self::check`]; also if a part is missing, damaged or of other work, there are more voxels than allowed, the file cannot be written, or it
    /// was cancelled.
    #[expect(clippy::too_many_arguments, reason = "each is another thing")]
    pub fn merge(
        &self,
        survey: &MeshTiles,
        shares: usize,
        parts: &[PathBuf],
        options: &VoxelizeOptions,
        limits: &Limits,
        path: &Path,
        progress: &VoxelizeProgress,
    ) -> Result<Written, VoxelizeError> {
        large::merge_mesh_tiles((survey, &self.stamp), shares, parts, options, limits, path, progress)
    }
}

/// Meshes of several files that one process voxelizes out of core.
struct ManyMeshes {
    files: Files,
    name: String,
    unit: LengthUnit,
    notes: Vec<String>,
    surveyed: Option<(MeshFiles<'static>, large::Survey)>,
}

/// Opens the meshes of several files without holding them all in memory, if they would take more than a third of `budget`.
pub(crate) fn open_large(
    paths: &[PathBuf],
    budget: u64,
    options: &ImportOptions,
) -> Result<Option<LargeContent>, ImportError> {
    let mut size_bytes = 0;
    for path in paths {
        size_bytes += std::fs::metadata(path).map_err(|error| ImportError::io(path, error))?.len();
    }
    if size_bytes <= budget / 3 {
        return Ok(None);
    }
    let files = Files { paths: paths.into(), options: options.clone() };
    let Mesh { name, unit, notes, .. } = files.read(0)?;
    let content = Box::new(ManyMeshes { files, name, unit, notes, surveyed: None });
    Ok(Some(LargeContent { content, size_bytes, files: Vec::new() }))
}

impl Content for ManyMeshes {
    fn about(&mut self) -> About<'_> {
        About { name: &mut self.name, unit: &mut self.unit, notes: &self.notes }
    }

    fn z_up(self: Box<Self>, _: UpAxis) -> Box<dyn Content> {
        // Each file is turned when it is read.
        self
    }

    fn filtered(self: Box<Self>, _: &Path, _: PointFilter) -> Box<dyn Content> {
        self
    }

    fn count(&self) -> Option<u64> {
        self.surveyed.as_ref().map(|(_, survey)| survey.triangles())
    }

    fn survey(&mut self, _: &VoxelizeOptions, progress: &VoxelizeProgress) -> Result<(), VoxelizeError> {
        let tiles = self.files.survey("", 0..self.files.paths.len(), progress)?;
        tiles.check("")?;
        self.files.check_units(tiles.units())?;
        let source = MeshFiles::new(&tiles, self.files.reader())?;
        self.notes.clone_from(&source.joined().frame.notes);
        let survey = tiles.survey(source.joined());
        self.surveyed = Some((source, survey));
        Ok(())
    }

    fn estimate(&mut self, options: &VoxelizeOptions) -> Result<Estimate, VoxelizeError> {
        let (source, survey) = self.surveyed.as_mut().ok_or(VoxelizeError::Empty)?;
        survey.estimate(source, options)
    }

    fn voxelize_to_file(
        &mut self,
        stamp: &str,
        options: &VoxelizeOptions,
        limits: &Limits,
        path: &Path,
        progress: &VoxelizeProgress,
    ) -> Result<Written, VoxelizeError> {
        let (source, survey) = self.surveyed.as_mut().ok_or(VoxelizeError::Empty)?;
        source.rename(&self.name, self.unit);
        voxelize_large_to_file((source, stamp), survey, options, limits, path, progress)
    }
}
