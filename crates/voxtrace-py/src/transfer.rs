//! `TransferFunction`.

use crate::arguments::Color;
use crate::errors::argument;
use pyo3::prelude::*;
use pyo3::types::PyString;
use std::collections::BTreeMap;
use voxtrace::glam::Vec3;
use voxtrace::volume::{LabelColor, Preset, Ramp, Transfer};

/// A transfer function taken apart: its kind, range, stops, and labels with colour and opacity.
type Parts = (u8, [f32; 2], Vec<(f32, [f32; 3])>, Vec<(i32, [f32; 4])>);

/// Which values of a volume are shown, and in which colour.
///
/// >>> import voxtrace
/// >>> voxtrace.TransferFunction([(250, "#c9a67c"), (1200, "#f3ead2")], threshold=200)
/// <TransferFunction stops: what is 200 or more>
#[pyclass(name = "TransferFunction", module = "voxtrace", frozen, from_py_object)]
#[derive(Clone)]
pub struct PyTransfer(pub Transfer);

#[pymethods]
impl PyTransfer {
    /// Colours between `stops`, pairs of a value and a colour, in any order. Values from `threshold`, by default the first stop's, to `upper` are shown.
    /// `relative`: stops lie from 0, the volume's own threshold, to 1, its 99.9th percentile. `opacity` in [0, 1] is that of surfaces.
    ///
    /// Raises `ValueError` where there is no stop, a value is not finite, or `threshold` is above `upper`.
    #[new]
    #[pyo3(signature = (stops, *, threshold=None, upper=None, opacity=1.0, relative=false))]
    fn new(
        stops: Vec<(f32, Color)>,
        threshold: Option<f32>,
        upper: Option<f32>,
        opacity: f32,
        relative: bool,
    ) -> PyResult<Self> {
        let stop = |(value, color): (f32, Color)| Ok((value, color.reflectance()?));
        let mut stops = stops.into_iter().map(stop).collect::<PyResult<Vec<_>>>()?;
        if stops.is_empty() || stops.iter().any(|(value, _)| !value.is_finite()) {
            return Err(argument("at least one stop with a finite value is wanted"));
        }
        stops.sort_by(|a, b| a.0.total_cmp(&b.0));
        check_opacity(opacity)?;
        let ramp = match relative {
            true if threshold.is_some() || upper.is_some() => {
                return Err(argument("relative stops have no threshold of their own: voxelize(threshold=…) sets it"));
            }
            true => Ramp::Relative { stops },
            false => {
                let (low, high) = (threshold.unwrap_or(stops[0].0), upper.unwrap_or(f32::MAX));
                if low.is_nan() || high.is_nan() || low > high {
                    return Err(argument(format!("values from {low} to {high} are none: threshold is at most upper")));
                }
                Ramp::Absolute { low, high, stops }
            }
        };
        Ok(Self(Transfer { opacity, ..Transfer::new("stops", ramp) }))
    }

    /// One for a kind of data: `"ct-bone"` and `"ct-skin"` (Hounsfield units), `"mri"`, `"labels"`, `"surface"` (level sets), `"fog"`, `"hot"`.
    ///
    /// Raises `ValueError` for another name.
    #[staticmethod]
    fn preset(name: &str) -> PyResult<Self> {
        let names = || Preset::ALL.map(Preset::name).join(", ");
        let preset = Preset::ALL.into_iter().find(|preset| preset.name() == name);
        preset.map(|preset| Self(preset.transfer())).ok_or_else(|| argument(format!("{name:?} is none of {}", names())))
    }

    /// Colours of labels, which are never interpolated; labels that are not named are not shown.
    #[staticmethod]
    #[pyo3(signature = (colors, *, opacity=1.0))]
    fn labels(colors: BTreeMap<i128, Color>, opacity: f32) -> PyResult<Self> {
        check_opacity(opacity)?;
        let fits = |label: i128| {
            let (least, most) = (i32::MIN, i32::MAX);
            i32::try_from(label)
                .map_err(|_| argument(format!("a label is a whole number from {least} to {most}, not {label}")))
        };
        let look = |(label, color): (i128, Color)| Ok((fits(label)?, LabelColor::from(color.reflectance()?)));
        let colors = colors.into_iter().map(look).collect::<PyResult<_>>()?;
        Ok(Self(Transfer { opacity, ..Transfer::new("labels", Ramp::Labels(colors)) }))
    }

    /// What `__reduce__` has taken apart.
    #[staticmethod]
    fn _of_parts(name: String, opacity: f32, parts: Parts) -> Self {
        let (kind, range, stops, labels) = parts;
        let stops = stops.into_iter().map(|(value, color)| (value, Vec3::from_array(color))).collect();
        let colors = labels
            .into_iter()
            .map(|(label, [r, g, b, opacity])| (label, LabelColor { color: Vec3::new(r, g, b), opacity }));
        let ramp = match kind {
            0 => Ramp::Absolute { low: range[0], high: range[1], stops },
            1 => Ramp::Relative { stops },
            2 => Ramp::Labels(colors.collect()),
            _ => Ramp::EveryLabel,
        };
        Self(Transfer { opacity, ..Transfer::new(name, ramp) })
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, (String, f32, Parts))> {
        let taken = |stops: &[(f32, Vec3)]| stops.iter().map(|(value, color)| (*value, color.to_array())).collect();
        let parts: Parts = match &self.0.ramp {
            Ramp::Absolute { low, high, stops } => (0, [*low, *high], taken(stops), vec![]),
            Ramp::Relative { stops } => (1, [0.0; 2], taken(stops), vec![]),
            Ramp::Labels(colors) => {
                let label = |(&label, look): (&i32, &LabelColor)| (label, look.color.extend(look.opacity).to_array());
                (2, [0.0; 2], vec![], colors.iter().map(label).collect())
            }
            Ramp::EveryLabel => (3, [0.0; 2], vec![], vec![]),
        };
        Ok((py.get_type::<Self>().getattr("_of_parts")?, (self.0.name.clone(), self.0.opacity, parts)))
    }

    fn __repr__(&self) -> String {
        format!("<TransferFunction {}: {}>", self.0.name, self.0.shown())
    }
}

fn check_opacity(opacity: f32) -> PyResult<()> {
    if (0.0..=1.0).contains(&opacity) { Ok(()) } else { Err(argument(format!("opacity is in [0, 1], not {opacity}"))) }
}

/// A transfer function, or the name of a preset.
pub struct AnyTransfer(pub Transfer);

impl<'py> FromPyObject<'_, 'py> for AnyTransfer {
    type Error = PyErr;

    fn extract(object: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        if let Ok(name) = object.cast::<PyString>() {
            return PyTransfer::preset(name.to_str()?).map(|transfer| Self(transfer.0));
        }
        Ok(Self(object.extract::<PyTransfer>()?.0))
    }
}
