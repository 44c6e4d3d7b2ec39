//! `Sky`.

use crate::arguments::Color;
use crate::errors::{argument, of_packed, of_reading};
use crate::forks::detach;
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use std::path::PathBuf;
use std::sync::Arc;
use voxtrace::import::Limits;
use voxtrace::sky::{Background, Environment, Sun};
use voxtrace::{PackedScene, Sky};

/// Light that comes from outside the scene.
///
/// >>> import voxtrace
/// >>> sky = voxtrace.Sky.uniform((0.5, 0.5, 0.5)).with_sun(bearing=120, height=40)
/// >>> sky.brightness
/// 1.0
#[pyclass(name = "Sky", module = "voxtrace", frozen, eq, from_py_object)]
#[derive(Clone, PartialEq)]
pub struct PySky(pub Sky);

#[pymethods]
impl PySky {
    /// From one colour straight down to another straight up.
    ///
    /// Raises `ValueError` for channels below 0.
    #[staticmethod]
    fn gradient(nadir: Color, zenith: Color) -> PyResult<Self> {
        Ok(Self(Sky::gradient(nadir.radiance()?, zenith.radiance()?)))
    }

    /// The same radiance from everywhere.
    ///
    /// Raises `ValueError` for channels below 0.
    #[staticmethod]
    fn uniform(color: Color) -> PyResult<Self> {
        Ok(Self(Sky::uniform(color.radiance()?)))
    }

    /// No light.
    #[staticmethod]
    fn black() -> Self {
        Self(Sky::black())
    }

    /// A panorama, `.hdr` or `.exr`, turned clockwise by `rotation` degrees, seen from above.
    ///
    /// Raises `ReadError` where the file holds none.
    #[staticmethod]
    #[pyo3(signature = (path, *, rotation=0.0))]
    fn environment(py: Python<'_>, path: PathBuf, rotation: f32) -> PyResult<Self> {
        let map = detach(py, || voxtrace::import::read_environment(&path, &Limits::default()))?;
        let map = map.map_err(|error| of_reading(py, &error))?;
        Ok(Self(Sky::new(Background::Environment(Environment::new(Arc::new(map), rotation)))))
    }

    /// The same sky with a warm white sun at a `bearing` (degrees clockwise from +y) and `height` above the horizon, of irradiance `strength`; 0
    /// takes the sun away.
    #[pyo3(signature = (*, bearing=150.0, height=45.0, strength=3.0))]
    fn with_sun(&self, bearing: f32, height: f32, strength: f32) -> PyResult<Self> {
        if !(bearing.is_finite() && height.is_finite() && strength >= 0.0 && strength.is_finite()) {
            return Err(argument("bearing and height are finite, strength is ≥ 0"));
        }
        Ok(Self(self.0.clone().with_sun(Sun::at(bearing, height, strength))))
    }

    /// The same sky, brighter or darker, its sun too.
    fn with_brightness(&self, brightness: f32) -> PyResult<Self> {
        if !(brightness >= 0.0 && brightness.is_finite()) {
            return Err(argument("brightness is ≥ 0"));
        }
        Ok(Self(self.0.clone().with_brightness(brightness)))
    }

    /// Factor on all its light.
    #[getter]
    fn brightness(&self) -> f32 {
        self.0.brightness()
    }

    /// What `__reduce__` has taken apart.
    #[staticmethod]
    fn _of_bytes(py: Python<'_>, scene: &[u8]) -> PyResult<Self> {
        let scene = detach(py, || PackedScene::from_bytes(scene))?.map_err(|error| of_packed(py, error))?;
        Ok(Self(scene.sky))
    }

    /// For pickle: as the sky of an empty scene.
    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, (Bound<'py, PyBytes>,))> {
        let mut scene = PackedScene::empty();
        scene.sky = self.0.clone();
        let bytes = PyBytes::new(py, &detach(py, || scene.to_bytes())?);
        Ok((py.get_type::<Self>().getattr("_of_bytes")?, (bytes,)))
    }

    fn __repr__(&self) -> String {
        let kind = match self.0.background() {
            Background::Gradient(_) => "gradient",
            Background::Environment(_) => "environment",
        };
        let sun = if self.0.sun().is_some() { ", sun" } else { "" };
        format!("<Sky: {kind}{sun}, brightness {}>", self.0.brightness())
    }
}
