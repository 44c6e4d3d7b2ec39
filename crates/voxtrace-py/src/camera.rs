//! `Camera`.

use crate::arguments::{Size, Three};
use crate::errors::argument;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::collections::BTreeMap;
use voxtrace::Camera;
use voxtrace::camera::Lens;
use voxtrace::glam::Vec3;

/// What `__new__` takes: `eye` and `target`, and the keywords.
type NewArguments<'py> = (([f32; 3], [f32; 3]), Bound<'py, PyDict>);

/// A view: from `eye` towards `target`, world units (voxels of scale 1), z up.
///
/// >>> import voxtrace
/// >>> voxtrace.Camera((60, -80, 50), (0, 0, 10), fov=35).fov
/// 35.0
#[pyclass(name = "Camera", module = "voxtrace", frozen, eq, from_py_object)]
#[derive(Clone, PartialEq)]
pub struct PyCamera(pub Camera);

#[pymethods]
impl PyCamera {
    /// `fov` is the vertical field of view, degrees. `lens`: `"pinhole"`, `"thin-lens"` (`aperture`, `focus`, `blades`, `blade_rotation`),
    /// `"orthographic"` (`view_height`), `"panorama"` (`eye_distance`) or `"fisheye"` (`fisheye_angle`), with those keywords.
    ///
    /// Raises `ValueError` where one cannot look so.
    #[new]
    #[pyo3(signature = (eye, target, *, up=None, fov=None, name="", lens="pinhole", **settings))]
    fn new(
        eye: Three,
        target: Three,
        up: Option<Three>,
        fov: Option<f32>,
        name: &str,
        lens: &str,
        settings: Option<BTreeMap<String, f32>>,
    ) -> PyResult<Self> {
        let mut camera = Camera::look_at(eye.single(), target.single());
        camera.up = up.map_or(Vec3::Z, Three::single);
        camera.fov_y = fov.unwrap_or(camera.fov_y);
        camera.name = name.into();
        let settings = settings.unwrap_or_default();
        camera.lens = Lens::from_settings(lens, |key| settings.get(key).copied()).map_err(argument)?;
        let known = camera.lens.settings();
        if let Some(key) = settings.keys().find(|key| !known.iter().any(|(known, _)| known == key)) {
            return Err(argument(format!("the lens {lens} has no {key:?}")));
        }
        camera.check().map_err(argument)?;
        Ok(Self(camera))
    }

    /// Position, world units.
    #[getter]
    fn eye(&self) -> [f32; 3] {
        self.0.eye.to_array()
    }

    /// Point in the middle of the picture, world units.
    #[getter]
    fn target(&self) -> [f32; 3] {
        self.0.target.to_array()
    }

    /// Direction that points upwards in the picture.
    #[getter]
    fn up(&self) -> [f32; 3] {
        self.0.up.to_array()
    }

    /// Vertical field of view, degrees.
    #[getter]
    fn fov(&self) -> f32 {
        self.0.fov_y
    }

    /// The ray through a place of the picture, in pixels from its upper left corner: origin and direction of unit length, world units. What `Renderer.cast` finds by
    /// it is what the picture shows there. `size`: width and height of the picture.
    #[pyo3(signature = (place, size))]
    fn ray(&self, place: (f32, f32), size: Size) -> PyResult<([f32; 3], [f32; 3])> {
        if size.0 == 0 || size.1 == 0 {
            return Err(argument("size is at least 1 × 1"));
        }
        let ray = self.0.frame(size.0, size.1).central_ray(place.into());
        Ok((ray.origin.to_array(), ray.direction.to_array()))
    }

    /// Name of the camera, empty where it has none.
    #[getter]
    fn name(&self) -> &str {
        &self.0.name
    }

    /// Name of the lens.
    #[getter]
    fn lens(&self) -> &'static str {
        self.0.lens.name()
    }

    /// For pickle: what makes the same camera.
    fn __getnewargs_ex__<'py>(&self, py: Python<'py>) -> PyResult<NewArguments<'py>> {
        let keywords = PyDict::new(py);
        keywords.set_item("up", self.up())?;
        keywords.set_item("fov", self.fov())?;
        keywords.set_item("name", self.name())?;
        keywords.set_item("lens", self.lens())?;
        for (key, value) in self.0.lens.settings() {
            keywords.set_item(key, value)?;
        }
        Ok(((self.eye(), self.target()), keywords))
    }

    fn __repr__(&self) -> String {
        let vector = |v: Vec3| format!("({:.2}, {:.2}, {:.2})", v.x, v.y, v.z);
        format!("Camera({}, {}, fov={:.1})", vector(self.0.eye), vector(self.0.target), self.0.fov_y)
    }
}
