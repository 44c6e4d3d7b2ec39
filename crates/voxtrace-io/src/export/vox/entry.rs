//! One entry of a .vox palette: an sRGB colour and the MATL chunk that goes with it.

use crate::import::vox::{Body, Dict, MEDIUM_KEYS, Numbered};
use glam::Vec3;
use voxtrace_scene::material::{Material, linear_color, srgb_from_linear};

/// Most powers of ten that MagicaVoxel's emission knows.
const MOST_POWER: i32 = 4;

/// A material as a palette entry says it. Diffuse surfaces have a roughness of 1 and the index of refraction of
/// [`Material::diffuse`]; a surface that emits has no other properties.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Entry {
    /// Colour, sRGB; of an emitter the colour of its light.
    pub color: [u8; 3],
    /// Emitted radiance over the linear colour, 0 for what does not emit.
    pub emission: f32,
    /// As in [`Material`].
    pub roughness: f32,
    /// As in [`Material`].
    pub metallic: f32,
    /// As in [`Material`].
    pub transmission: f32,
    /// As in [`Material`].
    pub ior: f32,
    /// Weight of the coat, anisotropy, absorption (red, green, blue) and scattering, as in [`Material`]: MagicaVoxel has no numbers of the same
    /// meaning, so they go under names of their own, which it ignores.
    pub medium: [f32; 6],
}

impl Entry {
    /// The entry nearest to a material whose emission is multiplied by `light_intensity`.
    pub fn of(material: &Material, light_intensity: f32) -> Self {
        let plain = Material::diffuse(material.base_color);
        let color = srgb_of(material.base_color);
        let emission = material.emission * light_intensity;
        if emission.max_element() > 0.0 {
            let own = scale_between(linear_color(color), emission).map(|scale| (color, scale));
            let (color, emission) = own.unwrap_or_else(|| split_color(emission));
            let Material { roughness, metallic, transmission, ior, .. } = plain;
            return Self { color, emission, roughness, metallic, transmission, ior, medium: medium_of(&plain) };
        }
        let Material { roughness, metallic, transmission, ior, .. } = *material;
        Self { color, emission: 0.0, roughness, metallic, transmission, ior, medium: medium_of(material) }
    }

    /// All of the entry as numbers that order and compare.
    pub fn key(&self) -> ([u8; 3], [u32; 5], [u32; 6]) {
        let numbers = [self.emission, self.roughness, self.metallic, self.transmission, self.ior];
        (self.color, numbers.map(f32::to_bits), self.medium.map(f32::to_bits))
    }

    /// The MATL chunk of the colour index `id`.
    pub fn chunk(&self, id: i32) -> Body<'static> {
        let plain = Material::diffuse(Vec3::ONE);
        let is_plain = (self.roughness, self.metallic, self.transmission, self.ior)
            == (plain.roughness, plain.metallic, plain.transmission, plain.ior)
            && self.medium == medium_of(&plain);
        let mut properties = Dict::default();
        if self.emission > 0.0 {
            let power =
                (0..MOST_POWER).find(|&power| f64::from(self.emission) <= 10f64.powi(power)).unwrap_or(MOST_POWER);
            properties.push("_type", "_emit");
            properties.push("_emit", (f64::from(self.emission) / 10f64.powi(power)).to_string());
            properties.push("_flux", power.to_string());
        } else if is_plain {
            properties.push("_type", "_diffuse");
        } else {
            let kind = match (self.metallic > 0.0, self.transmission > 0.0) {
                (true, false) => "_metal",
                (false, true) => "_glass",
                _ => "_blend",
            };
            properties.push("_type", kind);
            properties.push("_metal", self.metallic.to_string());
            properties.push("_trans", self.transmission.to_string());
            properties.push("_alpha", self.transmission.to_string());
            properties.push("_rough", self.roughness.to_string());
            properties.push("_ior", (self.ior - 1.0).to_string());
            properties.push("_ri", self.ior.to_string());
            let [specular, anisotropy, red, green, blue, scattering] = self.medium;
            let values =
                [specular.to_string(), anisotropy.to_string(), format!("{red} {green} {blue}"), scattering.to_string()];
            MEDIUM_KEYS.into_iter().zip(values).for_each(|(key, value)| properties.push(key, value));
        }
        Body::Material(Numbered { id, properties })
    }
}

fn medium_of(material: &Material) -> [f32; 6] {
    let Material { specular, anisotropy, absorption, scattering, .. } = *material;
    [specular, anisotropy, absorption.x, absorption.y, absorption.z, scattering]
}

/// Nearest sRGB bytes of a linear colour.
pub fn srgb_of(linear: Vec3) -> [u8; 3] {
    linear.to_array().map(srgb_from_linear)
}

/// An sRGB colour and a factor whose product is `light`: exactly if there is such a pair, else with the brightest channel
/// at 255.
pub fn split_color(light: Vec3) -> ([u8; 3], f32) {
    let brightest = light.max_element();
    if brightest <= 0.0 {
        return ([255; 3], 0.0);
    }
    let with_brightest = |byte: u8| {
        let scale = brightest / linear_color([byte; 3]).x;
        (srgb_of(light * (1.0 / scale)), scale)
    };
    let exact = |byte| {
        let (color, _) = with_brightest(byte);
        scale_between(linear_color(color), light).map(|scale| (color, scale))
    };
    (1..=255).rev().find_map(exact).unwrap_or_else(|| with_brightest(255))
}

/// The factor that makes `light` of `color` in every bit, if there is one: tries the floats around the quotient.
fn scale_between(color: Vec3, light: Vec3) -> Option<f32> {
    let axis = color.to_array().iter().position(|&channel| channel > 0.0 && channel == color.max_element())?;
    let quotient = (light[axis] / color[axis]).to_bits();
    let near = (0..8).flat_map(|steps| [quotient.wrapping_add(steps), quotient.wrapping_sub(steps)]);
    near.map(f32::from_bits).find(|&scale| scale.is_finite() && color * scale == light)
}
