//! `Volume`: samples on a lattice.

use crate::arguments::{Index, Number, Numbers, Three, number_of};
use crate::errors::{argument, other};
use crate::forks::detach;
use crate::interrupt::run_while;
use crate::scene::PyScene;
use crate::transfer::AnyTransfer;
use numpy::ndarray::{ArrayView3, Axis, Ix3};
use numpy::{IntoPyArray, PyArray1, PyArrayMethods, PyReadonlyArray1};
use pyo3::exceptions::PyIndexError;
use pyo3::prelude::*;
use rayon::prelude::*;
use voxtrace::Volume;
use voxtrace::glam::{DAffine3, DMat3, DVec3};
use voxtrace::scene::Unit;
use voxtrace::volume::{self, Preset, VolumeOptions};
use voxtrace::voxelize::Scale;

/// A volume taken apart: samples, size, affine, unit, whether they are labels and the name; then the preset that suits it, notes and colours of samples.
type Pickled<S> = (S, [usize; 3], [f64; 12], (Option<String>, bool, String), (Option<String>, Vec<String>, Vec<u8>));

/// Samples as numpy has them, the first axis fastest.
type Samples<'py> = Bound<'py, PyArray1<f32>>;

/// The edges of the steps, and how many samples are in each.
type Histogram<'py> = (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<u64>>);

/// Scalar samples on a regular lattice, as scanners and simulations make them.
///
/// >>> import numpy, voxtrace
/// >>> x, y, z = numpy.mgrid[-1:1:32j, -1:1:32j, -1:1:32j]
/// >>> ball = voxtrace.Volume.from_array(1 - numpy.sqrt(x * x + y * y + z * z), spacing=0.1)
/// >>> ball.voxelize(threshold=0.2).voxels > 1000
/// True
#[pyclass(name = "Volume", module = "voxtrace", frozen)]
pub struct PyVolume(pub Volume);

#[pymethods]
impl PyVolume {
    /// A volume of an array of shape `(X, Y, Z)`, of any type of real numbers; it is kept as float32.
    ///
    /// `spacing`: distance between samples, one number or three. `affine`: 4 × 4 or 3 × 4, from indices to the world, z up; patients as in DICOM (left,
    /// back, head). `unit`: `"mm"`, `"m"` or `None`. `labels`: values are labels, which are not interpolated.
    ///
    /// Raises `ValueError` for another shape, an affine that flattens, and both of `spacing` and `affine`.
    #[staticmethod]
    #[pyo3(signature = (array, *, spacing=None, affine=None, unit=None, labels=false, name="array"))]
    fn _from_numpy(
        py: Python<'_>,
        array: Numbers<'_, f32, Ix3>,
        spacing: Option<&Bound<'_, PyAny>>,
        affine: Option<Vec<[f64; 4]>>,
        unit: Option<&str>,
        labels: bool,
        name: &str,
    ) -> PyResult<Self> {
        let view = array.as_array();
        let (x, y, z) = view.dim();
        let values = detach(py, || first_axis_fastest(&view))?;
        let volume = frame_of(([x, y, z], values), (spacing, affine, unit), labels, name)?;
        // First that there are samples: of none it is no fault that none are there.
        volume.validate_lattice().and_then(|()| volume.validate()).map_err(argument)?;
        Ok(Self(volume))
    }

    /// The samples, shape `(X, Y, Z)`, float32; a copy.
    fn to_numpy<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let [x, y, z] = self.0.size;
        let values = py.detach(|| self.0.values.clone()).into_pyarray(py);
        // The first axis varies fastest here.
        let array = values.reshape([z, y, x]).map_err(argument)?;
        array.call_method1("transpose", ((2, 1, 0),))
    }

    /// Samples along each axis.
    #[getter]
    fn shape(&self) -> (usize, usize, usize) {
        self.0.size.into()
    }

    /// Distance between samples along each axis, in `unit`.
    #[getter]
    fn spacing(&self) -> [f64; 3] {
        self.0.spacing().to_array()
    }

    /// From indices to the world, 4 × 4: places in `unit`.
    #[getter]
    fn affine(&self) -> [[f64; 4]; 4] {
        let DAffine3 { matrix3, translation } = self.0.world_from_index;
        let row = |at: usize| [matrix3.x_axis[at], matrix3.y_axis[at], matrix3.z_axis[at], translation[at]];
        [row(0), row(1), row(2), [0.0, 0.0, 0.0, 1.0]]
    }

    /// Unit of length: `"mm"`, `"m"` or `None`, where it is not known.
    #[getter]
    fn unit(&self) -> Option<&'static str> {
        unit_name(self.0.unit)
    }

    /// Name for people.
    #[getter]
    fn name(&self) -> &str {
        &self.0.name
    }

    /// What `__reduce__` has taken apart.
    #[staticmethod]
    #[pyo3(signature = (values, size, affine, told, found))]
    fn _of_parts(
        values: PyReadonlyArray1<'_, f32>,
        size: [usize; 3],
        affine: [f64; 12],
        told: (Option<String>, bool, String),
        found: (Option<String>, Vec<String>, Vec<u8>),
    ) -> PyResult<Self> {
        let ((unit, is_labels, name), (suited, notes, colors)) = (told, found);
        let volume = Volume {
            name,
            world_from_index: DAffine3::from_cols_array(&affine),
            unit: unit_of(unit.as_deref())?,
            is_labels,
            suited: suited.and_then(|name| Preset::ALL.into_iter().find(|preset| preset.name() == name)),
            notes,
            colors: colors.as_chunks::<3>().0.to_vec(),
            ..Volume::new(size, values.to_vec()?)
        };
        volume.validate().map_err(argument)?;
        Ok(Self(volume))
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, Pickled<Samples<'py>>)> {
        let volume = &self.0;
        let values = py.detach(|| volume.values.clone()).into_pyarray(py);
        let told = (self.unit().map(str::to_owned), volume.is_labels, volume.name.clone());
        let suited = volume.suited.map(|preset| preset.name().to_owned());
        let found = (suited, volume.notes.clone(), volume.colors.as_flattened().to_vec());
        let parts = (values, volume.size, volume.world_from_index.to_cols_array(), told, found);
        Ok((py.get_type::<Self>().getattr("_of_parts")?, parts))
    }

    /// The same one: it is never changed.
    fn __copy__<'py>(slf: &Bound<'py, Self>) -> Bound<'py, Self> {
        slf.clone()
    }

    fn __deepcopy__<'py>(slf: &Bound<'py, Self>, _memo: &Bound<'py, PyAny>) -> Bound<'py, Self> {
        slf.clone()
    }

    fn __getitem__(&self, sample: (Index, Index, Index)) -> PyResult<f32> {
        let (Index(x), Index(y), Index(z)) = sample;
        let [width, depth, height] = self.0.size;
        if x >= width || y >= depth || z >= height {
            return Err(PyIndexError::new_err(format!("sample ({x}, {y}, {z}) of {width} × {depth} × {height}")));
        }
        Ok(self.0.values[(z * depth + y) * width + x])
    }

    /// How often values occur: the edges of 1,024 even steps from `low` to `high`, float64, and how many samples are in each, uint64. By default they reach from the
    /// least value to the 99.9th percentile; what is higher is in the last one.
    #[pyo3(signature = (low=None, high=None))]
    fn histogram<'py>(&self, py: Python<'py>, low: Option<f32>, high: Option<f32>) -> PyResult<Histogram<'py>> {
        if [low, high].into_iter().flatten().any(|bound| !bound.is_finite()) {
            return Err(argument("low and high are finite"));
        }
        let (low, high, counts) = detach(py, || {
            let values = (low.is_none() || high.is_none()).then(|| self.0.statistics());
            let low = low.or(values.as_ref().map(|values| values.lowest)).unwrap_or(0.0);
            let high = high.or(values.as_ref().map(|values| values.bright)).unwrap_or(0.0);
            (low, high, if low < high { self.0.histogram(low, high) } else { Vec::new() })
        })?;
        if counts.is_empty() && low != high {
            return Err(argument("low is below high"));
        }
        let step = f64::from(high - low) / counts.len().max(1) as f64;
        let edges: Vec<f64> = (0..=counts.len()).map(|edge| f64::from(low) + edge as f64 * step).collect();
        Ok((edges.into_pyarray(py), counts.into_pyarray(py)))
    }

    /// The value between background and object (Otsu's), from which `voxelize` shows values where nothing else is said.
    #[getter]
    fn threshold(&self, py: Python<'_>) -> PyResult<f32> {
        detach(py, || self.0.statistics().threshold)
    }

    /// Makes voxels of what `transfer`, a `TransferFunction` or the name of a preset, shows; without it one is chosen by the values.
    ///
    /// `threshold` overrides its threshold. `resolution` is the number of voxels along the longest side, `voxel_size` their edge in `unit`; by default
    /// there is one for each sample. `shell`: only those that a ray from outside can reach are kept.
    ///
    /// Raises `VoxtraceError` where nothing would be seen; Ctrl-C ends it.
    #[pyo3(signature = (transfer=None, *, threshold=None, resolution=None, voxel_size=None, shell=true))]
    fn voxelize(
        &self,
        py: Python<'_>,
        transfer: Option<AnyTransfer>,
        threshold: Option<f32>,
        resolution: Option<Number<u32>>,
        voxel_size: Option<f64>,
        shell: bool,
    ) -> PyResult<PyScene> {
        let options = VolumeOptions {
            scale: scale_of(resolution, voxel_size)?,
            transfer: transfer.map(|transfer| transfer.0),
            threshold,
            shell,
            overlays: Vec::new(),
        };
        let limits = voxtrace::import::Limits::default();
        let scene = run_while(py, |wanted| volume::voxelize_while(&self.0, &options, &limits, wanted))?;
        Ok(PyScene::of(scene.map_err(|error| other(py, error))?))
    }

    fn __repr__(&self) -> String {
        let ([x, y, z], spacing) = (self.0.size, self.0.spacing());
        let unit = self.unit().map_or(String::new(), |unit| format!(" {unit}"));
        format!(
            "<Volume {:?}: {x} × {y} × {z} samples, {:.4} × {:.4} × {:.4}{unit} apart>",
            self.0.name, spacing.x, spacing.y, spacing.z
        )
    }
}

/// Where samples lie: their distance or an affine, and a unit.
type Place<'a, 'py> = (Option<&'a Bound<'py, PyAny>>, Option<Vec<[f64; 4]>>, Option<&'a str>);

/// A volume of samples, of this size, that lie where arguments say.
pub fn frame_of(
    (size, values): ([usize; 3], Vec<f32>),
    (spacing, affine, unit): Place<'_, '_>,
    labels: bool,
    name: &str,
) -> PyResult<Volume> {
    let spacing = spacing
        .map(|spacing| {
            spacing.extract::<f64>().map(DVec3::splat).or_else(|_| spacing.extract::<Three>().map(|three| three.0))
        })
        .transpose()?;
    let mut volume = Volume::new(size, values);
    volume.world_from_index = match (spacing, affine) {
        (Some(_), Some(_)) => return Err(argument("spacing or affine, not both")),
        (Some(spacing), None) => DAffine3::from_scale(spacing),
        (None, Some(rows)) => affine_of(&rows)?,
        (None, None) => DAffine3::IDENTITY,
    };
    volume.unit = unit_of(unit)?;
    (volume.is_labels, volume.name) = (labels, name.into());
    Ok(volume)
}

/// The size of voxels that arguments ask for.
pub fn scale_of(resolution: Option<Number<u32>>, voxel_size: Option<f64>) -> PyResult<Option<Scale>> {
    match (number_of(resolution, "resolution", 1)?, voxel_size) {
        (Some(_), Some(_)) => Err(argument("resolution or voxel_size, not both")),
        (Some(resolution), None) => Ok(Some(Scale::Resolution(resolution))),
        (None, Some(size)) if size > 0.0 && size.is_finite() => Ok(Some(Scale::VoxelSize(size))),
        (None, Some(size)) => Err(argument(format!("voxel_size is above 0, not {size}"))),
        (None, None) => Ok(None),
    }
}

/// The unit of a name.
fn unit_of(unit: Option<&str>) -> PyResult<Unit> {
    match unit {
        None => Ok(Unit::Voxel),
        Some("mm") => Ok(Unit::Millimetre),
        Some("m") => Ok(Unit::Metre),
        Some(unit) => Err(argument(format!("unit is \"mm\", \"m\" or None, not {unit:?}"))),
    }
}

/// Name of a unit.
pub fn unit_name(unit: Unit) -> Option<&'static str> {
    match unit {
        Unit::Voxel => None,
        Unit::Metre => Some("m"),
        Unit::Millimetre => Some("mm"),
    }
}

/// The samples with the first axis fastest.
fn first_axis_fastest(view: &ArrayView3<f32>) -> Vec<f32> {
    let turned = view.view().permuted_axes([2, 1, 0]);
    let (z, y, x) = turned.dim();
    let mut values = vec![0.0; x * y * z];
    values.par_chunks_mut((x * y).max(1)).enumerate().for_each(|(z, slab)| {
        slab.iter_mut().zip(turned.index_axis(Axis(0), z).iter()).for_each(|(value, &sample)| *value = sample);
    });
    values
}

fn affine_of(rows: &[[f64; 4]]) -> PyResult<DAffine3> {
    if !(3..=4).contains(&rows.len()) || rows.get(3).is_some_and(|row| *row != [0.0, 0.0, 0.0, 1.0]) {
        return Err(argument("an affine has 4 × 4 numbers, the last row 0, 0, 0, 1, or 3 × 4"));
    }
    let column = |at: usize| DVec3::new(rows[0][at], rows[1][at], rows[2][at]);
    Ok(DAffine3 { matrix3: DMat3::from_cols(column(0), column(1), column(2)), translation: column(3) })
}
