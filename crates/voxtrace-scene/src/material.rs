//! Surface materials. Colours are linear Rec. 709 (importers convert from sRGB).

use glam::Vec3;

/// Most materials that one scene may hold.
pub const MAX_MATERIALS: usize = 65_535;

/// What a voxel is made of. The surface is a mixture: with the share `metallic` a metal, of the rest with the share `transmission` the
/// boundary of a transparent medium, of the rest a diffuse surface under a coat of weight `specular`. `voxtrace_core::bsdf` has the models.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// Diffuse reflectance, and the colour in which a metal reflects at normal incidence; inside a medium the share of light that is
    /// scattered on, not absorbed, where it is scattered. Linear, each channel in [0, 1].
    pub base_color: Vec3,
    /// Radiance that the surface emits, linear, each channel ≥ 0; the scene's `light_intensity` multiplies it. A medium without a surface
    /// ([`Self::is_without_surface`]) emits it within, in each voxel of the way through it.
    pub emission: Vec3,
    /// Roughness of metal, coat and glass in [0, 1]; its square is the α of the microfacets.
    pub roughness: f32,
    /// Metalness in [0, 1].
    pub metallic: f32,
    /// Share of the light that enters the voxel, in [0, 1].
    pub transmission: f32,
    /// Index of refraction of coat and medium, ≥ 1. Light enters a medium of index 1 without reflection or refraction.
    pub ior: f32,
    /// Weight of the coat over the diffuse surface, in [0, 1]: 0 is matte, 1 plastic.
    pub specular: f32,
    /// Anisotropy of scattering in the medium: mean cosine, in (−1, 1), > 0 forwards (Henyey and Greenstein 1941).
    pub anisotropy: f32,
    /// Absorption coefficient of the medium, one over voxels, each channel ≥ 0.
    pub absorption: Vec3,
    /// Scattering coefficient of the medium, one over voxels, ≥ 0.
    pub scattering: f32,
}

impl Material {
    /// A diffuse surface of a linear colour.
    pub fn diffuse(base_color: Vec3) -> Self {
        Self {
            base_color,
            emission: Vec3::ZERO,
            roughness: 1.0,
            metallic: 0.0,
            transmission: 0.0,
            ior: 1.5,
            specular: 0.0,
            anisotropy: 0.0,
            absorption: Vec3::ZERO,
            scattering: 0.0,
        }
    }

    /// A metal that reflects `base_color` (linear) at normal incidence.
    pub fn metal(base_color: Vec3, roughness: f32) -> Self {
        Self { metallic: 1.0, roughness, ..Self::diffuse(base_color) }
    }

    /// A diffuse surface of a linear colour under a clear coat.
    pub fn plastic(base_color: Vec3, roughness: f32) -> Self {
        Self { specular: 1.0, roughness, ..Self::diffuse(base_color) }
    }

    /// Clear glass.
    pub fn glass(ior: f32, roughness: f32) -> Self {
        Self { transmission: 1.0, ior, roughness, ..Self::diffuse(Vec3::ONE) }
    }

    /// The same medium, through `voxels` of which white light takes on `color` (linear). A channel below 2⁻²⁴ counts as 2⁻²⁴.
    #[must_use]
    pub fn tinted(self, color: Vec3, voxels: f32) -> Self {
        let coefficient =
            |channel: f32| (-f64::from(channel.clamp(1.0 / 16_777_216.0, 1.0)).ln() / f64::from(voxels)) as f32;
        Self { absorption: Vec3::from_array(color.to_array().map(coefficient)), ..self }
    }

    /// A cloud: nothing is reflected where light enters, and `density` times in a voxel, on average, it is scattered, of which the share
    /// `albedo` (linear) goes on.
    pub fn cloud(albedo: Vec3, density: f32, anisotropy: f32) -> Self {
        Self { transmission: 1.0, ior: 1.0, roughness: 0.0, scattering: density, anisotropy, ..Self::diffuse(albedo) }
    }

    /// Whether light enters the voxel.
    pub fn is_transmissive(&self) -> bool {
        self.transmission > 0.0
    }

    /// A flame: a medium without a surface that absorbs `density` of the light in a voxel, and seen through a thick piece of it has the radiance
    /// `radiance` (linear).
    pub fn flame(radiance: Vec3, density: f32) -> Self {
        let absorption = Vec3::splat(density);
        Self { emission: radiance * density, scattering: 0.0, absorption, ..Self::cloud(Vec3::ONE, 0.0, 0.0) }
    }

    /// Whether all light enters the voxel without reflection or refraction: then there is only what is within.
    pub fn is_without_surface(&self) -> bool {
        self.transmission >= 1.0 && self.ior == 1.0 && self.metallic <= 0.0
    }

    /// A diffuse surface of a colour as screens and pickers show it: sRGB bytes.
    pub fn from_srgb(srgb: [u8; 3]) -> Self {
        Self::diffuse(linear_color(srgb))
    }

    /// The same surface, which emits `strength` times its base colour as radiance as well.
    #[must_use]
    pub fn glowing(self, strength: f32) -> Self {
        Self { emission: self.base_color * strength, ..self }
    }

    /// A surface that emits `emission` (linear radiance) and reflects nothing.
    pub fn emissive(emission: Vec3) -> Self {
        Self { emission, ..Self::diffuse(Vec3::ZERO) }
    }

    /// Whether the surface emits light.
    pub fn is_emissive(&self) -> bool {
        self.emission.max_element() > 0.0
    }
}

impl Default for Material {
    fn default() -> Self {
        Self::diffuse(Vec3::splat(0.8))
    }
}

/// Linear value of an sRGB byte (IEC 61966-2-1).
pub fn linear_from_srgb(byte: u8) -> f32 {
    let value = f64::from(byte) / 255.0;
    (if value <= 0.04045 { value / 12.92 } else { ((value + 0.055) / 1.055).powf(2.4) }) as f32
}

/// Nearest sRGB byte of a linear value, clamped to [0, 1] (IEC 61966-2-1).
pub fn srgb_from_linear(linear: f32) -> u8 {
    (encode_srgb(f64::from(linear)) * 255.0).round() as u8
}

/// sRGB signal in [0, 1] of a linear value, clamped to [0, 1]; what is not a number becomes 0 (IEC 61966-2-1).
#[expect(clippy::manual_clamp, reason = "clamp would keep NaN")]
pub fn encode_srgb(linear: f64) -> f64 {
    let value = linear.max(0.0).min(1.0);
    if value <= 0.003_130_8 { value * 12.92 } else { 1.055 * value.powf(1.0 / 2.4) - 0.055 }
}

/// Linear colour of three sRGB bytes.
pub fn linear_color(srgb: [u8; 3]) -> Vec3 {
    Vec3::from_array(srgb.map(linear_from_srgb))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_colour_of_the_screen_becomes_linear_and_glows_in_its_own_hue() {
        let amber = Material::from_srgb([255, 188, 0]).glowing(10.0);
        assert_eq!((amber.base_color.x, amber.base_color.z), (1.0, 0.0));
        assert!((amber.base_color.y - 0.503).abs() < 1e-3, "{}", amber.base_color.y);
        assert_eq!(amber.emission, amber.base_color * 10.0);
        assert!(amber.is_emissive() && !Material::from_srgb([255, 188, 0]).is_emissive());
    }
}
