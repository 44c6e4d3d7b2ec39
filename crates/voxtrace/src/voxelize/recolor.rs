//! The colours of a picture as the colours of a scene: each material takes the nearest one in Oklab.

use super::census::Census;
use super::key::{Class, key_of};
use super::palette::Palette;
use crate::export::vox::oklab::oklab_of;
use crate::scene::Scene;
use glam::Vec3;
use rayon::prelude::*;

/// The colours of sRGB texels, linear, at most `most` of them: more are gathered to look alike. Texels that are less than half
/// opaque are left out.
pub fn colors_of_texels(texels: &[[u8; 4]], most: usize) -> Vec<Vec3> {
    let census = Census::default();
    for &[red, green, blue, alpha] in texels {
        if alpha >= 128 {
            census.add(&[key_of(u32::from_be_bytes([0, red, green, blue]), 0, 0)], 1);
        }
    }
    let plain = Class { roughness: 1.0, metallic: 0.0, transmission: 0.0, ior: 1.5 };
    if census.look_count() == 0 {
        return Vec::new();
    }
    Palette::of(&census, &[plain], most.max(1), false).materials.iter().map(|material| material.base_color).collect()
}

/// Gives each material of a scene the nearest of the colours; what glows does so in its new colour, as strongly as before.
/// Without colours nothing changes.
pub fn recolor(scene: &mut Scene, colors: &[Vec3]) {
    let in_oklab: Vec<Vec3> = colors.iter().map(|&color| oklab_of(color)).collect();
    scene.materials.par_iter_mut().for_each(|material| {
        let strength = material.emission.max_element();
        // A lamp may have no colour but that of its light.
        let is_dark = material.base_color.max_element() == 0.0 && strength > 0.0;
        let color = if is_dark { material.emission / strength } else { material.base_color };
        let wanted = oklab_of(color);
        let nearest = (0..colors.len())
            .min_by(|&a, &b| in_oklab[a].distance_squared(wanted).total_cmp(&in_oklab[b].distance_squared(wanted)));
        let Some(nearest) = nearest.map(|index| colors[index]) else { return };
        let brightest = nearest.max_element();
        if strength > 0.0 && brightest > 0.0 {
            material.emission = nearest * (strength / brightest);
        }
        if !is_dark {
            material.base_color = nearest;
        }
    });
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::VoxelGrid;
    use crate::material::{Material, linear_color};

    #[test]
    fn materials_take_the_nearest_colours_and_lamps_keep_their_strength() {
        let texels = [[255, 0, 0, 255], [0, 0, 255, 255], [250, 250, 250, 255], [0, 255, 0, 20], [255, 0, 0, 255]];
        let colors = colors_of_texels(&texels, 255);
        assert_eq!(colors, [[0, 0, 255], [250, 250, 250], [255, 0, 0]].map(linear_color));
        let lamp = Material { emission: Vec3::new(4.0, 1.0, 1.0), ..Material::diffuse(Vec3::new(0.9, 0.1, 0.1)) };
        let bulb = Material::emissive(Vec3::new(0.1, 0.1, 3.0));
        let plain = Material::diffuse(linear_color([20, 30, 200]));
        let mut scene = Scene::from_grid("", VoxelGrid::new(), vec![plain, lamp, bulb]);
        recolor(&mut scene, &colors);
        assert_eq!(scene.materials[0].base_color, colors[0]);
        assert_eq!((scene.materials[1].base_color, scene.materials[1].emission), (colors[2], colors[2] * 4.0));
        assert_eq!((scene.materials[2].base_color, scene.materials[2].emission), (Vec3::ZERO, colors[0] * 3.0));
        let before = scene.clone();
        recolor(&mut scene, &[]);
        assert_eq!(scene, before);
    }

    #[test]
    fn more_colours_than_allowed_are_gathered() {
        let texels: Vec<[u8; 4]> = (0..4096).map(|i| [(i % 64 * 4) as u8, (i / 64 * 4) as u8, 128, 255]).collect();
        let colors = colors_of_texels(&texels, 16);
        assert!(colors.len() <= 16 && colors.len() > 8, "{}", colors.len());
        assert_eq!(colors_of_texels(&texels, 65_535).len(), 4096);
        assert!(colors_of_texels(&[[1, 2, 3, 0]], 16).is_empty());
    }
}
