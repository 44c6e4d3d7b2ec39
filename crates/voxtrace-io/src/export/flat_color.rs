//! Materials as plain colours, for formats that have nothing else.

use glam::Vec3;
use voxtrace_scene::material::{Material, srgb_from_linear};

/// Depth in voxels from which transparent matter shows its colour.
const DEPTH_OF_TINT: f32 = 2.0;

/// The linear colour that a material shows: that of its light, or of what gets through it.
pub fn shown_color(material: &Material) -> Vec3 {
    if material.is_emissive() {
        return material.emission / material.emission.max_element().max(1.0);
    }
    if material.is_transmissive() {
        let through = (-material.absorption * DEPTH_OF_TINT).exp();
        return material.base_color * Vec3::ONE.lerp(through, material.transmission);
    }
    material.base_color
}

/// As [`shown_color`], sRGB.
pub fn shown_srgb(material: &Material) -> [u8; 3] {
    shown_color(material).to_array().map(srgb_from_linear)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn light_and_glass_show_their_hue() {
        let amber = Material::from_srgb([200, 120, 10]);
        assert_eq!(shown_srgb(&amber), [200, 120, 10]);
        let lamp = Material::emissive(Vec3::new(8.0, 4.0, 0.0));
        assert_eq!(shown_color(&lamp), Vec3::new(1.0, 0.5, 0.0));
        let green = Material::glass(1.5, 0.0).tinted(Vec3::new(0.1, 0.9, 0.1), DEPTH_OF_TINT);
        assert!(shown_color(&green).abs_diff_eq(Vec3::new(0.1, 0.9, 0.1), 1e-5));
    }
}
