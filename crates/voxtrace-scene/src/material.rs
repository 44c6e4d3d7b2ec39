//! Surface materials. Colours are linear Rec. 709 (importers convert from sRGB).

use glam::Vec3;

/// Most materials that one scene may hold.
pub const MAX_MATERIALS: usize = 65_535;

/// What a voxel is made of. Base colour and emission shade today; the other parameters are kept as files give them
/// and shade as diffuse.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// Diffuse reflectance, linear, each channel in [0, 1].
    pub base_color: Vec3,
    /// Radiance that the surface emits, linear, each channel ≥ 0; the scene's `light_intensity` multiplies it.
    pub emission: Vec3,
    /// Roughness in [0, 1].
    pub roughness: f32,
    /// Metalness in [0, 1].
    pub metallic: f32,
    /// Transmission in [0, 1].
    pub transmission: f32,
    /// Index of refraction, ≥ 1.
    pub ior: f32,
}

impl Material {
    /// A diffuse surface of a linear colour.
    pub fn diffuse(base_color: Vec3) -> Self {
        Self { base_color, emission: Vec3::ZERO, roughness: 1.0, metallic: 0.0, transmission: 0.0, ior: 1.5 }
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
