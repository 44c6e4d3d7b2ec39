//! `Material`.

use crate::arguments::Color;
use crate::errors::argument;
use pyo3::prelude::*;
use voxtrace::Material;
use voxtrace::glam::Vec3;

/// A material taken apart: colours and numbers.
type Pickled = ([[f32; 3]; 3], [f32; 7]);

/// What a voxel is made of. Colours are linear Rec. 709, or `"#rrggbb"` as pickers show them.
///
/// >>> import voxtrace
/// >>> voxtrace.Material("#ff8800", emission=(4, 2, 0)).base_color[0]
/// 1.0
#[pyclass(name = "Material", module = "voxtrace", frozen, eq, from_py_object)]
#[derive(Clone, PartialEq)]
pub struct PyMaterial(pub Material);

#[pymethods]
impl PyMaterial {
    /// A surface: matte, unless `metallic`, `specular` or `transmission` say otherwise.
    ///
    /// `base_color`: reflectance, channels in [0, 1]. `emission`: radiance, channels ≥ 0. `roughness`, `metallic`, `transmission` and `specular` are in [0, 1], `ior`
    /// is ≥ 1. Of the medium that light comes into: `absorption` and `scattering`, one over voxels, ≥ 0, and `anisotropy` of the scattering in (-1, 1).
    ///
    /// Raises `ValueError` for numbers out of range.
    #[new]
    #[pyo3(signature = (base_color=Color(Vec3::splat(0.8)), *, emission=Color(Vec3::ZERO), roughness=1.0, metallic=0.0, transmission=0.0, ior=1.5, specular=0.0, anisotropy=0.0, absorption=Color(Vec3::ZERO), scattering=0.0),
        text_signature = "(base_color=(0.8, 0.8, 0.8), *, emission=(0, 0, 0), roughness=1.0, metallic=0.0, transmission=0.0, ior=1.5, specular=0.0, anisotropy=0.0, absorption=(0, 0, 0), scattering=0.0)")]
    #[expect(clippy::too_many_arguments, reason = "keywords of Python")]
    fn new(
        base_color: Color,
        emission: Color,
        roughness: f32,
        metallic: f32,
        transmission: f32,
        ior: f32,
        specular: f32,
        anisotropy: f32,
        absorption: Color,
        scattering: f32,
    ) -> PyResult<Self> {
        let shares =
            [("roughness", roughness), ("metallic", metallic), ("transmission", transmission), ("specular", specular)];
        for (name, share) in shares {
            if !(0.0..=1.0).contains(&share) {
                return Err(argument(format!("{name} is in [0, 1], not {share}")));
            }
        }
        let is_color = base_color.0.min_element() >= 0.0 && base_color.0.max_element() <= 1.0;
        let is_light = emission.0.min_element() >= 0.0 && absorption.0.min_element() >= 0.0;
        if !is_color || !is_light {
            return Err(argument("channels of base_color are in [0, 1], those of emission and absorption ≥ 0"));
        }
        if !(ior >= 1.0 && ior.is_finite() && anisotropy.abs() < 1.0 && scattering >= 0.0 && scattering.is_finite()) {
            return Err(argument("ior is ≥ 1, anisotropy in (-1, 1), scattering ≥ 0"));
        }
        Ok(Self(Material {
            base_color: base_color.0,
            emission: emission.0,
            roughness,
            metallic,
            transmission,
            ior,
            specular,
            anisotropy,
            absorption: absorption.0,
            scattering,
        }))
    }

    /// Diffuse reflectance, or the colour of a metal: linear, three numbers in [0, 1].
    #[getter]
    fn base_color(&self) -> [f32; 3] {
        self.0.base_color.to_array()
    }

    /// Radiance that the surface emits, linear.
    #[getter]
    fn emission(&self) -> [f32; 3] {
        self.0.emission.to_array()
    }

    /// Roughness of metal, coat and glass in [0, 1].
    #[getter]
    fn roughness(&self) -> f32 {
        self.0.roughness
    }

    /// Metalness in [0, 1].
    #[getter]
    fn metallic(&self) -> f32 {
        self.0.metallic
    }

    /// Share of the light that enters the voxel, in [0, 1].
    #[getter]
    fn transmission(&self) -> f32 {
        self.0.transmission
    }

    /// Index of refraction, ≥ 1.
    #[getter]
    fn ior(&self) -> f32 {
        self.0.ior
    }

    /// Weight of the coat over the diffuse surface, in [0, 1].
    #[getter]
    fn specular(&self) -> f32 {
        self.0.specular
    }

    /// Anisotropy of scattering in the medium, in (-1, 1).
    #[getter]
    fn anisotropy(&self) -> f32 {
        self.0.anisotropy
    }

    /// Absorption coefficient of the medium, one over voxels.
    #[getter]
    fn absorption(&self) -> [f32; 3] {
        self.0.absorption.to_array()
    }

    /// Scattering coefficient of the medium, one over voxels.
    #[getter]
    fn scattering(&self) -> f32 {
        self.0.scattering
    }

    /// What `__reduce__` has taken apart: also what a file had that cannot be asked for.
    #[staticmethod]
    fn _of_parts(colors: [[f32; 3]; 3], numbers: [f32; 7]) -> Self {
        let [base_color, emission, absorption] = colors.map(Vec3::from_array);
        let [roughness, metallic, transmission, ior, specular, anisotropy, scattering] = numbers;
        Self(Material {
            base_color,
            emission,
            roughness,
            metallic,
            transmission,
            ior,
            specular,
            anisotropy,
            absorption,
            scattering,
        })
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, Pickled)> {
        let Material { base_color, emission, absorption, roughness, metallic, transmission, .. } = self.0;
        let Material { ior, specular, anisotropy, scattering, .. } = self.0;
        let colors = [base_color, emission, absorption].map(|color| color.to_array());
        let numbers = [roughness, metallic, transmission, ior, specular, anisotropy, scattering];
        Ok((py.get_type::<Self>().getattr("_of_parts")?, (colors, numbers)))
    }

    fn __repr__(&self) -> String {
        let [r, g, b] = self.0.base_color.to_array();
        let mut text = format!("Material(({r:.3}, {g:.3}, {b:.3})");
        if self.0.is_emissive() {
            let [r, g, b] = self.0.emission.to_array();
            text += &format!(", emission=({r:.3}, {g:.3}, {b:.3})");
        }
        let plain = Material::diffuse(self.0.base_color);
        let shares = [
            ("roughness", self.0.roughness, plain.roughness),
            ("metallic", self.0.metallic, plain.metallic),
            ("transmission", self.0.transmission, plain.transmission),
            ("ior", self.0.ior, plain.ior),
            ("specular", self.0.specular, plain.specular),
        ];
        for (name, value, usual) in shares {
            if value != usual {
                text += &format!(", {name}={value}");
            }
        }
        text + ")"
    }
}
