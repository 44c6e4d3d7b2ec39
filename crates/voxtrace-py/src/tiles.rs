//! `TiledCloud`: a scan of many files, of which many processes voxelize some each. `voxtrace.dask` shares it out.

use crate::arguments::{Number, number_of};
use crate::errors::{argument, of_reading, of_writing, other, raised};
use crate::forks::detach;
use crate::interrupt::{run, run_while};
use crate::volume::scale_of;
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use std::num::NonZero;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::thread;
use voxtrace::import::{ImportOptions, Limits, MapBounds, PointFilter, READERS};
use voxtrace::packed::{LevelCount, add_levels};
use voxtrace::points::ColorBy;
use voxtrace::scene::LengthUnit;
use voxtrace::voxelize::large_points::{TileSurvey, joined_bytes};
use voxtrace::voxelize::{PointOptions, Scale, VoxelizeError, VoxelizeOptions, VoxelizeProgress};

/// A scan of LAS or LAZ files, and how it becomes voxels. Files are told by their numbers; ranges of them are a first number and an end.
#[pyclass(name = "TiledCloud", module = "voxtrace._voxtrace", frozen)]
pub struct PyTiledCloud {
    cloud: Mutex<voxtrace::import::TiledCloud>,
    options: VoxelizeOptions,
    limits: Limits,
}

#[pymethods]
impl PyTiledCloud {
    /// Opens the files, or those of a folder, and reads their headers.
    #[new]
    #[pyo3(signature = (paths, *, resolution=None, voxel_size=None, color_by="auto", min_points=Number::Fits(1), classes=None, bounds=None, palette=None, dither=false, unit=None, memory=None, trusted=false),
        text_signature = "(paths, *, resolution=None, voxel_size=None, color_by='auto', min_points=1, classes=None, bounds=None, palette=None, dither=False, unit=None, memory=None, trusted=False)")]
    #[expect(clippy::too_many_arguments, reason = "keywords of Python")]
    fn new(
        py: Python<'_>,
        paths: Vec<PathBuf>,
        resolution: Option<Number<u32>>,
        voxel_size: Option<f64>,
        color_by: &str,
        min_points: Number<u32>,
        classes: Option<&str>,
        bounds: Option<Vec<f64>>,
        palette: Option<Number<usize>>,
        dither: bool,
        unit: Option<&str>,
        memory: Option<Number<u64>>,
        trusted: bool,
    ) -> PyResult<Self> {
        let color_by = match color_by {
            "auto" => ColorBy::Auto,
            "rgb" => ColorBy::Rgb,
            "intensity" => ColorBy::Intensity,
            "classification" => ColorBy::Classification,
            "height" => ColorBy::Height,
            other => {
                return Err(argument(format!(
                    "color_by is auto, rgb, intensity, classification or height, not {other:?}"
                )));
            }
        };
        let bounds = bounds.map(|numbers| numbers.iter().map(f64::to_string).collect::<Vec<_>>().join(","));
        let points = PointFilter {
            classes: classes.map(|classes| classes.parse().map_err(argument)).transpose()?,
            bounds: bounds.map(|bounds| bounds.parse::<MapBounds>().map_err(argument)).transpose()?,
        };
        let limits = limits_of(trusted);
        let usual = VoxelizeOptions::default();
        let options = VoxelizeOptions {
            scale: scale_of(resolution, voxel_size)?.unwrap_or(Scale::Automatic),
            points: PointOptions { color_by, min_points: min_points.of("min_points", 0)?.max(1) },
            max_materials: number_of(palette, "palette", 0)?.unwrap_or(usual.max_materials),
            dither,
            memory_budget: number_of(memory, "memory", 0)?,
            ..usual
        };
        let import = ImportOptions { limits, points, unit: unit.map(unit_of).transpose()?, ..ImportOptions::default() };
        let opened = detach(py, || READERS.open_all(&paths, &import).and_then(|mut opened| opened.open_tiled()))?;
        let cloud = opened.map_err(|error| of_reading(py, &error))?;
        Ok(Self { cloud: Mutex::new(cloud), options, limits })
    }

    /// Shares the files among at most so many parts, by their points.
    fn shares(&self, py: Python<'_>, parts: usize) -> PyResult<Vec<(usize, usize)>> {
        let shares = self.with(py, |cloud, _| Ok(cloud.shares(parts)))?;
        Ok(shares.into_iter().map(|share| (share.start, share.end)).collect())
    }

    /// Looks through some files.
    fn survey<'py>(&self, py: Python<'py>, first: usize, end: usize) -> PyResult<Bound<'py, PyBytes>> {
        let found = self.with(py, |cloud, progress| {
            cloud.survey(first..end, &self.options, progress).map(|mut survey| survey.to_bytes())
        });
        found.map(|found| PyBytes::new(py, &found))
    }

    /// Whether a survey is of all files, and with these options; what else it wants is a second pass, if that is the second answer.
    fn check(&self, py: Python<'_>, survey: &[u8]) -> PyResult<bool> {
        self.with(py, |cloud, _| {
            let survey = TileSurvey::from_bytes(survey)?;
            cloud.check(&survey, &self.options)?;
            survey.wants_measures(&self.options)
        })
    }

    /// Makes the second pass over some files.
    fn measure<'py>(&self, py: Python<'py>, survey: &[u8], first: usize, end: usize) -> PyResult<Bound<'py, PyBytes>> {
        let found = self.with(py, |cloud, progress| {
            cloud.measure(&TileSurvey::from_bytes(survey)?, first..end, &self.options, progress)
        });
        found.map(|found| PyBytes::new(py, &found))
    }

    /// What headers and first points let expect of all files: a survey to make parts with before all points were seen; `None` where that is not enough.
    fn expected<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyBytes>>> {
        let expected =
            self.with(py, |cloud, _| Ok(cloud.expected(&self.options)?.map(|mut survey| survey.to_bytes())))?;
        Ok(expected.map(|expected| PyBytes::new(py, &expected)))
    }

    /// Voxelizes some files into a part; returns the number of their points and, where the survey is what was expected, what was found in them.
    fn voxelize<'py>(
        &self,
        py: Python<'py>,
        survey: &[u8],
        first: usize,
        end: usize,
        path: PathBuf,
    ) -> PyResult<(u64, Option<Bound<'py, PyBytes>>)> {
        let part = self.writing(py, &path, |cloud, progress| {
            let survey = TileSurvey::from_bytes(survey)?;
            cloud.voxelize(&survey, first..end, &self.options, &self.limits, &path, progress)
        })?;
        Ok((part.points, part.found.map(|mut found| PyBytes::new(py, &found.to_bytes()))))
    }

    /// Holds the survey that parts have found against what was expected: that survey, and whether the parts are parts of it.
    fn bear_out<'py>(&self, py: Python<'py>, found: &[u8], expected: &[u8]) -> PyResult<(Bound<'py, PyBytes>, bool)> {
        let (survey, is_so) = self.with(py, |_, _| {
            let mut survey = TileSurvey::from_bytes(found)?;
            let is_so = survey.bear_out(&TileSurvey::from_bytes(expected)?, &self.options)?;
            Ok((survey.to_bytes(), is_so))
        })?;
        Ok((PyBytes::new(py, &survey), is_so))
    }

    /// Makes the file of all parts, with so many levels of detail, or with -1 all, on at least so many threads; returns the number of voxels.
    #[pyo3(signature = (survey, parts, path, levels=0, threads=0))]
    fn merge(
        &self,
        py: Python<'_>,
        survey: &[u8],
        parts: Vec<PathBuf>,
        path: PathBuf,
        levels: i32,
        threads: usize,
    ) -> PyResult<u64> {
        let written = self.writing(py, &path, |cloud, progress| {
            on_threads(threads, || {
                let survey = TileSurvey::from_bytes(survey)?;
                cloud.merge(&survey, &parts, &self.options, &self.limits, &path, progress)
            })
        })?;
        with_levels(py, &path, levels, threads)?;
        Ok(written.voxels)
    }

    /// What was left out or put up with, once a survey of all files was checked.
    #[getter]
    fn notes(&self, py: Python<'_>) -> PyResult<Vec<String>> {
        self.with(py, |cloud, _| Ok(cloud.notes().to_vec()))
    }
}

impl PyTiledCloud {
    fn with<T: Send>(
        &self,
        py: Python<'_>,
        make: impl FnOnce(&mut voxtrace::import::TiledCloud, &VoxelizeProgress) -> Result<T, VoxelizeError> + Send,
    ) -> PyResult<T> {
        work(py, |progress| make(&mut self.held(), progress))?.map_err(|error| raised(py, error))
    }

    /// As [`Self::with`], for work that writes `path`.
    fn writing<T: Send>(
        &self,
        py: Python<'_>,
        path: &Path,
        make: impl FnOnce(&mut voxtrace::import::TiledCloud, &VoxelizeProgress) -> Result<T, VoxelizeError> + Send,
    ) -> PyResult<T> {
        writing(py, path, |progress| make(&mut self.held(), progress))
    }

    fn held(&self) -> MutexGuard<'_, voxtrace::import::TiledCloud> {
        // Whoever panicked while holding it has left nothing half done that is read.
        self.cloud.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Does work with files that Ctrl-C ends.
pub fn work<T: Send>(
    py: Python<'_>,
    make: impl FnOnce(&VoxelizeProgress) -> Result<T, VoxelizeError> + Send,
) -> PyResult<Result<T, VoxelizeError>> {
    let progress = VoxelizeProgress::default();
    run(py, || progress.cancel(), |_| Ok(()), || make(&progress))
}

/// As [`work`], which writes `path`.
pub fn writing<T: Send>(
    py: Python<'_>,
    path: &Path,
    make: impl FnOnce(&VoxelizeProgress) -> Result<T, VoxelizeError> + Send,
) -> PyResult<T> {
    work(py, make)?.map_err(|error| match error {
        VoxelizeError::Io(error) => of_writing(path, &error),
        error => raised(py, error),
    })
}

/// Does work on at least so many threads, as far as the machine has them for this process.
pub fn on_threads<T: Send>(threads: usize, make: impl FnOnce() -> T + Send) -> T {
    let there = thread::available_parallelism().map_or(1, NonZero::get);
    let threads = threads.min(there);
    if threads <= rayon::current_num_threads() {
        return make();
    }
    match rayon::ThreadPoolBuilder::new().num_threads(threads).build() {
        Ok(pool) => pool.install(make),
        Err(_) => make(),
    }
}

/// Adds so many levels of detail to a file, or with a negative number all.
pub fn with_levels(py: Python<'_>, path: &Path, levels: i32, threads: usize) -> PyResult<()> {
    let count = u32::try_from(levels).map_or(LevelCount::All, LevelCount::Some);
    if count == LevelCount::Some(0) {
        return Ok(());
    }
    let added = run_while(py, |wanted| on_threads(threads, || add_levels(path, count, &mut |_| wanted())))?;
    added.map_err(|error| other(py, error))
}

/// The limits that protect from hostile files, or none.
pub fn limits_of(trusted: bool) -> Limits {
    let most = u64::MAX;
    let unlimited = Limits { bytes: most, voxels: most, points: most, items: most, ratio: most, ..Limits::default() };
    if trusted { unlimited } else { Limits::default() }
}

/// The unit of a symbol.
pub fn unit_of(symbol: &str) -> PyResult<LengthUnit> {
    let symbols = || LengthUnit::SYMBOLS.map(|(symbol, _)| symbol).join(", ");
    LengthUnit::of_symbol(symbol).ok_or_else(|| argument(format!("unit is one of {}, not {symbol:?}", symbols())))
}

/// Brings together what several processes have found in files.
#[pyfunction]
pub fn join_surveys<'py>(py: Python<'py>, found: Vec<Vec<u8>>) -> PyResult<Bound<'py, PyBytes>> {
    let joined = detach(py, || joined_bytes(found.iter().map(Vec::as_slice)))?;
    joined.map(|joined| PyBytes::new(py, &joined)).map_err(|error| raised(py, error))
}
