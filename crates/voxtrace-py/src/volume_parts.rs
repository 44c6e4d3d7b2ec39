//! `TiledVolume`: an array of samples that stays where it is, of which many processes voxelize some layers each. `voxtrace.dask` shares it out.

use crate::arguments::Number;
use crate::errors::{argument, of_writing, raised};
use crate::interrupt::run;
use crate::tiles::{on_threads, with_levels};
use crate::transfer::AnyTransfer;
use crate::volume::{frame_of, scale_of};
use numpy::{Element, PyArrayMethods, PyReadonlyArray3};
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use std::io;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};
use voxtrace::Volume;
use voxtrace::import::{ImportError, Limits};
use voxtrace::volume::VolumeOptions;
use voxtrace::volume::large::{Block, Coding, SampleSource, Survey};
use voxtrace::volume::large::{layers_of_bricks, merge_volume_parts, voxelize_volume_part};
use voxtrace::voxelize::{VoxelizeError, VoxelizeProgress, Written};

/// An array of shape `(X, Y, Z)` that is read in slabs, and how it becomes voxels.
///
/// `read(first, end, low, high)` gives the samples of layers `first..end` along z and rows `low..high` along y: C-contiguous, of shape `(layers, rows, X)`,
/// uint8, uint16 or float32 as `kind` says: `"u8"`, `"i8"`, `"u16"`, `"i16"` (signed numbers as codes that count from the least one on) or `"f32"`. `depth`:
/// layers that are read at a time. `stamp` tells the array from others.
#[pyclass(name = "TiledVolume", module = "voxtrace._voxtrace", frozen)]
pub struct PyTiledVolume {
    frame: Volume,
    coding: Coding,
    read: Py<PyAny>,
    depth: usize,
    stamp: String,
    options: VolumeOptions,
    memory: u64,
    limits: Limits,
    /// What Python raised where it read.
    raised: Mutex<Option<PyErr>>,
}

#[pymethods]
impl PyTiledVolume {
    #[new]
    #[pyo3(signature = (read, shape, kind, depth, stamp, *, spacing=None, affine=None, unit=None, labels=false, name="array", transfer=None, threshold=None, resolution=None, voxel_size=None, shell=true, memory, trusted=false))]
    #[expect(clippy::too_many_arguments, reason = "keywords of Python")]
    fn new(
        read: Py<PyAny>,
        shape: [usize; 3],
        kind: &str,
        depth: usize,
        stamp: String,
        spacing: Option<&Bound<'_, PyAny>>,
        affine: Option<Vec<[f64; 4]>>,
        unit: Option<&str>,
        labels: bool,
        name: &str,
        transfer: Option<AnyTransfer>,
        threshold: Option<f32>,
        resolution: Option<Number<u32>>,
        voxel_size: Option<f64>,
        shell: bool,
        memory: Number<u64>,
        trusted: bool,
    ) -> PyResult<Self> {
        let frame = frame_of((shape, Vec::new()), (spacing, affine, unit), labels, name)?;
        frame.validate_lattice().map_err(argument)?;
        let table = |count: u32, least: f32| (0..count).map(|code| code as f32 + least).collect();
        let coding = match kind {
            "u8" => Coding::Bytes(table(1 << 8, 0.0)),
            "i8" => Coding::Bytes(table(1 << 8, -128.0)),
            "u16" => Coding::Words(table(1 << 16, 0.0)),
            "i16" => Coding::Words(table(1 << 16, -32_768.0)),
            "f32" => Coding::Reals,
            other => return Err(argument(format!("samples are u8, i8, u16, i16 or f32, not {other:?}"))),
        };
        let most = u64::MAX;
        let unlimited = Limits { voxels: most, items: most, ..Limits::default() };
        Ok(Self {
            frame,
            coding,
            read,
            depth: depth.max(1),
            stamp,
            options: VolumeOptions {
                scale: scale_of(resolution, voxel_size)?,
                transfer: transfer.map(|transfer| transfer.0),
                threshold,
                shell,
                overlays: Vec::new(),
            },
            memory: memory.of("memory", 0)?,
            limits: if trusted { unlimited } else { Limits::default() },
            raised: Mutex::new(None),
        })
    }

    /// Whether all samples have to be looked at before any becomes a voxel.
    fn wants_looks(&self, py: Python<'_>) -> PyResult<bool> {
        let known = Survey::without_values(&self.frame, &self.options);
        Ok(known.map_err(|error| raised(py, error))?.is_none())
    }

    /// What some layers of samples say.
    fn look<'py>(&self, py: Python<'py>, first: usize, end: usize) -> PyResult<Bound<'py, PyBytes>> {
        let look = self.work(py, |source, progress| Survey::look(source, first..end, Some(self.memory), progress))?;
        Ok(PyBytes::new(py, &look))
    }

    /// How many samples of some layers are in each of the bins from `low` to `high`.
    fn count(&self, py: Python<'_>, first: usize, end: usize, low: f32, high: f32) -> PyResult<Vec<u64>> {
        self.work(py, |source, progress| Survey::count(source, (first..end, low, high), Some(self.memory), progress))
    }

    /// The survey of what looks at all layers have found. `count(low, high)` gives the counts of all layers together, where they are wanted.
    fn survey<'py>(
        &self,
        py: Python<'py>,
        looks: Vec<Vec<u8>>,
        count: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyBytes>> {
        let mut failure = None;
        let mut binned = |low: f32, high: f32| {
            count.call1((low, high)).and_then(|counts| counts.extract::<Vec<u64>>()).map_err(|error| {
                failure = Some(error);
                VoxelizeError::Cancelled
            })
        };
        let looks = looks.iter().map(Vec::as_slice);
        let survey = Survey::of_looks(&self.frame, &self.options, looks, &mut binned);
        match (survey, failure) {
            (_, Some(error)) => Err(error),
            (Err(error), None) => Err(raised(py, error)),
            (Ok(survey), None) => Ok(PyBytes::new(py, &survey.to_bytes())),
        }
    }

    /// Layers of bricks, which are shared out.
    fn layers(&self, py: Python<'_>, survey: &[u8]) -> PyResult<usize> {
        let layers = self.survey_of(survey).and_then(|survey| layers_of_bricks(&self.frame, &survey, &self.options));
        layers.map_err(|error| raised(py, error))
    }

    /// Voxelizes some layers of bricks into a part; returns the number of their voxels.
    fn voxelize(&self, py: Python<'_>, survey: &[u8], first: usize, end: usize, path: PathBuf) -> PyResult<u64> {
        self.writing(py, &path, |source, progress| {
            let (survey, how) = (self.survey_of(survey)?, (&self.options, Some(self.memory)));
            let source = (source as &mut dyn SampleSource, self.stamp.as_str());
            voxelize_volume_part(source, &survey, first..end, how, &self.limits, &path, progress)
        })
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
        let Written { voxels, .. } = self.writing(py, &path, |_, progress| {
            on_threads(threads, || {
                let (survey, frame) = (self.survey_of(survey)?, (&self.frame, self.stamp.as_str()));
                merge_volume_parts(frame, &survey, &parts, &self.options, &self.limits, &path, progress)
            })
        })?;
        with_levels(py, &path, levels, threads)?;
        Ok(voxels)
    }
}

impl PyTiledVolume {
    fn survey_of(&self, bytes: &[u8]) -> Result<Survey, VoxelizeError> {
        Survey::from_bytes(bytes, &self.frame, &self.options)
    }

    /// Does work with the samples that Ctrl-C ends.
    fn try_work<T: Send>(
        &self,
        py: Python<'_>,
        work: impl FnOnce(&mut ArraySource<'_>, &VoxelizeProgress) -> Result<T, VoxelizeError> + Send,
    ) -> PyResult<Result<T, VoxelizeError>> {
        let progress = VoxelizeProgress::default();
        let mut source = ArraySource { of: self, frame: self.frame.clone(), slab: None };
        let done = run(py, || progress.cancel(), |_| Ok(()), || work(&mut source, &progress))?;
        match self.raised.lock().unwrap_or_else(PoisonError::into_inner).take() {
            Some(error) => Err(error),
            None => Ok(done),
        }
    }

    fn work<T: Send>(
        &self,
        py: Python<'_>,
        work: impl FnOnce(&mut ArraySource<'_>, &VoxelizeProgress) -> Result<T, VoxelizeError> + Send,
    ) -> PyResult<T> {
        self.try_work(py, work)?.map_err(|error| raised(py, error))
    }

    /// As [`Self::work`], for work that writes `path`.
    fn writing<T: Send>(
        &self,
        py: Python<'_>,
        path: &Path,
        work: impl FnOnce(&mut ArraySource<'_>, &VoxelizeProgress) -> Result<T, VoxelizeError> + Send,
    ) -> PyResult<T> {
        self.try_work(py, work)?.map_err(|error| match error {
            VoxelizeError::Io(error) => of_writing(path, &error),
            error => raised(py, error),
        })
    }
}

/// The array as the voxelizer reads it: layer by layer, of slabs that are kept until their last layer was read.
struct ArraySource<'a> {
    of: &'a PyTiledVolume,
    frame: Volume,
    slab: Option<Slab>,
}

/// Some layers of some rows.
struct Slab {
    layers: Range<usize>,
    rows: Range<usize>,
    samples: Block,
}

impl SampleSource for ArraySource<'_> {
    fn frame(&self) -> &Volume {
        &self.frame
    }

    fn frame_mut(&mut self) -> &mut Volume {
        &mut self.frame
    }

    fn bytes_of_row(&self) -> u64 {
        // The array of Python, and the copy of it.
        2 * self.frame.size[0] as u64 * self.of.depth as u64 * self.of.coding.bytes()
    }

    fn coding(&self) -> Coding {
        self.of.coding.clone()
    }

    fn read(&mut self, layer: usize, rows: Range<usize>, block: &mut Block) -> Result<(), ImportError> {
        let is_there = |slab: &&mut Slab| slab.layers.contains(&layer) && slab.rows == rows;
        if self.slab.as_mut().filter(is_there).is_none() {
            // Slabs begin where chunks do.
            let first = layer / self.of.depth * self.of.depth;
            let layers = first..(first + self.of.depth).min(self.frame.size[2]);
            self.slab = None;
            let samples = Python::attach(|py| self.of.slab(py, &layers, &rows)).map_err(|error| {
                let text = error.to_string();
                self.of.raised.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert(error);
                ImportError::io(Path::new(&self.frame.name), io::Error::other(text))
            })?;
            self.slab = Some(Slab { layers, rows: rows.clone(), samples });
        }
        let Some(slab) = &self.slab else { return Ok(()) };
        let count = rows.len() * self.frame.size[0];
        let start = (layer - slab.layers.start) * count;
        match (block, &slab.samples) {
            (Block::Bytes(own), Block::Bytes(all)) => own.copy_from_slice(&all[start..start + count]),
            (Block::Words(own), Block::Words(all)) => own.copy_from_slice(&all[start..start + count]),
            (Block::Reals(own), Block::Reals(all)) => own.copy_from_slice(&all[start..start + count]),
            _ => {}
        }
        Ok(())
    }
}

impl PyTiledVolume {
    fn slab(&self, py: Python<'_>, layers: &Range<usize>, rows: &Range<usize>) -> PyResult<Block> {
        let array = self.read.bind(py).call1((layers.start, layers.end, rows.start, rows.end))?;
        let shape = [layers.len(), rows.len(), self.frame.size[0]];
        Ok(match self.coding {
            Coding::Bytes(_) => Block::Bytes(samples_of(&array, shape)?),
            Coding::Words(_) => Block::Words(samples_of(&array, shape)?),
            Coding::Reals => Block::Reals(samples_of(&array, shape)?),
        })
    }
}

/// The samples of an array of this shape, in order.
fn samples_of<T: Element + Copy>(array: &Bound<'_, PyAny>, shape: [usize; 3]) -> PyResult<Vec<T>> {
    let array: PyReadonlyArray3<'_, T> = array.extract()?;
    let found = array.as_array();
    if found.shape() != shape {
        return Err(argument(format!("the array gives {:?} samples where {shape:?} were asked for", found.shape())));
    }
    Ok(array.to_vec()?)
}
