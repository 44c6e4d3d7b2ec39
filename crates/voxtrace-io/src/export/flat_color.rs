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

/// What of materials plain colours do not hold, one phrase each.
#[cfg(any(feature = "mesh", feature = "voxels"))]
pub fn lost_of(materials: &[Material]) -> impl Iterator<Item = String> {
    let counts = [
        ("light of materials", materials.iter().filter(|material| material.is_emissive()).count()),
        ("glass and other media", materials.iter().filter(|material| material.is_transmissive()).count()),
    ];
    counts.into_iter().filter(|&(_, count)| count > 0).map(|(what, count)| format!("{what} ({count})"))
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

    #[test]
    #[cfg(any(feature = "mesh", feature = "voxels"))]
    fn lamps_and_glass_are_told_to_be_lost() {
        let materials =
            [Material::default(), Material::emissive(Vec3::ONE), Material::glass(1.5, 0.0), Material::glass(1.3, 0.0)];
        let lost: Vec<String> = lost_of(&materials).collect();
        assert_eq!(lost, ["light of materials (1)", "glass and other media (2)"]);
        assert_eq!(lost_of(&materials[..1]).count(), 0);
    }
}
