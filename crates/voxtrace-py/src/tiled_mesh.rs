//! `TiledMesh`: meshes of many files that are one, of whose space many processes voxelize some each. `voxtrace.dask` shares it out.

use crate::arguments::{Number, number_of};
use crate::errors::{argument, of_reading, raised};
use crate::forks::detach;
use crate::tiles::{limits_of, on_threads, unit_of, with_levels, work, writing};
use crate::volume::scale_of;
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use std::path::PathBuf;
use voxtrace::import::{ImportOptions, Limits, TiledMesh};
use voxtrace::voxelize::large::MeshTiles;
use voxtrace::voxelize::{Scale, SurfaceRule, VoxelizeOptions};

/// Meshes of several files as one, and how it becomes voxels. Files are told by their numbers; ranges of them are a first number and an end.
#[pyclass(name = "TiledMesh", module = "voxtrace._voxtrace", frozen)]
pub struct PyTiledMesh {
    mesh: TiledMesh,
    options: VoxelizeOptions,
    limits: Limits,
}

#[pymethods]
impl PyTiledMesh {
    /// The meshes of these files, of which none is read yet.
    #[new]
    #[pyo3(signature = (paths, *, resolution=None, voxel_size=None, surface="conservative", palette=None, dither=false, unit=None, memory=None, trusted=false))]
    #[expect(clippy::too_many_arguments, reason = "keywords of Python")]
    fn new(
        py: Python<'_>,
        paths: Vec<PathBuf>,
        resolution: Option<Number<u32>>,
        voxel_size: Option<f64>,
        surface: &str,
        palette: Option<Number<usize>>,
        dither: bool,
        unit: Option<&str>,
        memory: Option<Number<u64>>,
        trusted: bool,
    ) -> PyResult<Self> {
        let rule = match surface {
            "conservative" => SurfaceRule::Conservative,
            "thin" => SurfaceRule::Thin,
            other => return Err(argument(format!("surface is conservative or thin, not {other:?}"))),
        };
        let limits = limits_of(trusted);
        let usual = VoxelizeOptions::default();
        let options = VoxelizeOptions {
            scale: scale_of(resolution, voxel_size)?.unwrap_or(Scale::Automatic),
            rule,
            max_materials: number_of(palette, "palette", 0)?.unwrap_or(usual.max_materials),
            dither,
            memory_budget: number_of(memory, "memory", 0)?,
            ..usual
        };
        let import = ImportOptions { limits, unit: unit.map(unit_of).transpose()?, ..ImportOptions::default() };
        let mesh = detach(py, || TiledMesh::open(paths, &import))?.map_err(|error| of_reading(py, &error))?;
        Ok(Self { mesh, options, limits })
    }

    /// Shares the files among at most so many surveys, by their bytes.
    fn shares(&self, surveys: usize) -> Vec<(usize, usize)> {
        self.mesh.shares(surveys).into_iter().map(|share| (share.start, share.end)).collect()
    }

    /// Looks through some files.
    fn survey<'py>(&self, py: Python<'py>, first: usize, end: usize) -> PyResult<Bound<'py, PyBytes>> {
        let found = work(py, |progress| self.mesh.survey(first..end, progress).map(|found| found.to_bytes()))?;
        found.map(|found| PyBytes::new(py, &found)).map_err(|error| raised(py, error))
    }

    /// Checks that a survey is of all files; returns what readers left out or put up with.
    fn check(&self, py: Python<'_>, survey: &[u8]) -> PyResult<Vec<String>> {
        let checked = work(py, |_| Ok(self.mesh.check(&MeshTiles::from_bytes(survey)?)?.1))?;
        checked.map_err(|error| raised(py, error))
    }

    /// Voxelizes the part with the number `part` of `parts`; returns how many files were read for it.
    fn voxelize(&self, py: Python<'_>, survey: &[u8], part: usize, parts: usize, path: PathBuf) -> PyResult<usize> {
        writing(py, &path, |progress| {
            let survey = MeshTiles::from_bytes(survey)?;
            self.mesh.voxelize(&survey, (part, parts), &self.options, &self.limits, &path, progress)
        })
    }

    /// Makes the file of all of so many parts, with so many levels of detail, or with -1 all, on at least so many threads; returns the number of voxels.
    #[pyo3(signature = (survey, parts, made, path, levels=0, threads=0))]
    #[expect(clippy::too_many_arguments, reason = "keywords of Python")]
    fn merge(
        &self,
        py: Python<'_>,
        survey: &[u8],
        parts: usize,
        made: Vec<PathBuf>,
        path: PathBuf,
        levels: i32,
        threads: usize,
    ) -> PyResult<u64> {
        let written = writing(py, &path, |progress| {
            on_threads(threads, || {
                let survey = MeshTiles::from_bytes(survey)?;
                self.mesh.merge(&survey, parts, &made, &self.options, &self.limits, &path, progress)
            })
        })?;
        with_levels(py, &path, levels, threads)?;
        Ok(written.voxels)
    }
}

/// Brings together what several processes have found in files.
#[pyfunction]
pub fn join_mesh_surveys<'py>(py: Python<'py>, found: Vec<Vec<u8>>) -> PyResult<Bound<'py, PyBytes>> {
    let joined = detach(py, || {
        let surveys = found.iter().map(|found| MeshTiles::from_bytes(found)).collect::<Result<Vec<_>, _>>()?;
        MeshTiles::join(surveys).map(|joined| joined.to_bytes())
    })?;
    joined.map(|joined| PyBytes::new(py, &joined)).map_err(|error| raised(py, error))
}
