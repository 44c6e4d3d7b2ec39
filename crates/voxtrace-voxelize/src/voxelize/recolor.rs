//! Colour quantization of a finished scene: to fewer materials, chosen by [`Palette`] as for meshes, or to the colours of a
//! picture, of which each material takes the nearest in Oklab.

use super::appearance::{AppearanceKey, BsdfClass, appearance_key, emission_bits, rgb_bits};
use super::color_histogram::ColorHistogram;
use super::palette::{Palette, SMALL, nearest_two, threshold};
use glam::{IVec3, Vec3};
use rayon::prelude::*;
use rustc_hash::FxHashMap;
use std::sync::Arc;
use voxtrace_scene::brick::{BRICK_SIZE, Brick};
use voxtrace_scene::grid::VoxelGrid;
use voxtrace_scene::material::{MAX_MATERIALS, Material};
use voxtrace_scene::oklab::oklab_of;
use voxtrace_scene::scene::Scene;

/// The palette of sRGB texels: at most `most` linear colours. More distinct colours than that are quantized by median cut.
/// Texels with an alpha below one half are left out.
pub fn colors_of_texels(texels: &[[u8; 4]], most: usize) -> Vec<Vec3> {
    let histogram = ColorHistogram::default();
    let mut tally = histogram.tally();
    for &[red, green, blue, alpha] in texels {
        if alpha >= 128 {
            tally.add(&[appearance_key(u32::from_be_bytes([0, red, green, blue]), 0, 0)], 1);
        }
    }
    drop(tally);
    let plain = BsdfClass { roughness: 1.0, metallic: 0.0, transmission: 0.0, ior: 1.5, coat: None, absorption: None };
    if histogram.appearance_count() == 0 {
        return Vec::new();
    }
    Palette::of(&histogram, &[plain], most.max(1), false).materials.iter().map(|material| material.base_color).collect()
}

/// Quantizes the materials of a scene to at most `most` by median cut, and for small palettes k-means, in Oklab. At least one
/// material is kept for each combination of roughness, metalness, transmission and index of refraction (up to 16 of them).
/// `dither` mixes two materials where none fits, up to 1,024 materials. A scene that uses no more than `most` stays unchanged.
pub fn quantize_palette(scene: &mut Scene, most: usize, dither: bool) {
    let uses = uses(scene);
    if uses.iter().filter(|&&uses| uses > 0).count() <= most {
        return;
    }
    let class = |material: &Material| {
        let Material { roughness, metallic, transmission, ior, .. } = *material;
        BsdfClass { roughness, metallic, transmission, ior, coat: None, absorption: None }
    };
    let (of_material, classes) = BsdfClass::grouped(scene.materials.iter().map(class));
    let key = |(material, class): (&Material, u8)| {
        appearance_key(rgb_bits(material.base_color), class, emission_bits(material.emission))
    };
    let keys: Vec<AppearanceKey> = scene.materials.iter().zip(of_material).map(key).collect();
    let histogram = ColorHistogram::default();
    for (key, uses) in keys.iter().zip(uses) {
        if uses > 0 {
            histogram.add(&[*key], u32::try_from(uses).unwrap_or(u32::MAX));
        }
    }
    let palette = Palette::of(&histogram, &classes, most.clamp(1, MAX_MATERIALS), dither);
    repaint(scene, |material, voxel| {
        // An index out of range stays one, so that validation still finds it.
        keys.get(usize::from(material)).map_or(u16::MAX, |&key| palette.index(key, voxel))
    });
    scene.materials = palette.materials;
}

/// Gives each material of a scene the nearest of the linear `colors`, by distance in Oklab. Emission takes the new colour and
/// keeps its strength (the largest channel). `dither` mixes two of at most 1,024 colours where none fits. With no colours the
/// scene stays unchanged.
pub fn recolor(scene: &mut Scene, colors: &[Vec3], dither: bool) {
    if colors.is_empty() {
        return;
    }
    let dither = dither && colors.len() <= SMALL;
    let centers: Vec<(usize, Vec3)> = colors.iter().map(|&color| (0, oklab_of(color))).collect();
    let painted = |material: &Material| {
        let strength = material.emission.max_element();
        // A black emitter has no colour but that of its emission.
        let is_dark = material.base_color.max_element() == 0.0 && strength > 0.0;
        let color = if is_dark { material.emission / strength } else { material.base_color };
        let (nearest, second, share) = nearest_two(0, oklab_of(color), &centers, dither);
        let with = |index: u16| {
            let color = colors[usize::from(index)];
            let (mut material, brightest) = (*material, color.max_element());
            if strength > 0.0 && brightest > 0.0 {
                material.emission = color * (strength / brightest);
            }
            if !is_dark {
                material.base_color = color;
            }
            material
        };
        (with(nearest), with(second), share)
    };
    let painted: Vec<_> = scene.materials.par_iter().map(painted).collect();
    let mut materials = MaterialTable::default();
    let nearest: Vec<u16> = painted.iter().map(|(nearest, ..)| materials.index(nearest).unwrap_or(0)).collect();
    let mixed: Vec<(u16, u16, u8)> = painted
        .iter()
        .zip(nearest)
        .map(|((_, second, share), nearest)| (nearest, materials.index(second).unwrap_or(nearest), *share))
        .collect();
    repaint(scene, |material, voxel| match mixed.get(usize::from(material)) {
        Some(&(_, second, share)) if u32::from(share) > threshold(voxel) => second,
        Some(&(nearest, ..)) => nearest,
        None => u16::MAX,
    });
    scene.materials = materials.materials;
}

/// Materials without duplicates, and the index of each.
#[derive(Default)]
struct MaterialTable {
    materials: Vec<Material>,
    indices: FxHashMap<[u32; 16], u16>,
}

impl MaterialTable {
    /// The index of a material; `None` where there is no room for another one.
    fn index(&mut self, material: &Material) -> Option<u16> {
        let Material { base_color: color, emission, absorption, .. } = *material;
        let Material { roughness, metallic, transmission, ior, specular, anisotropy, scattering, .. } = *material;
        let ([a, b, c], [d, e, f], [g, h, i]) = (color.to_array(), emission.to_array(), absorption.to_array());
        let surface = [roughness, metallic, transmission, ior, specular, anisotropy, scattering];
        let [j, k, l, m, n, o, p] = surface;
        let key = [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p].map(f32::to_bits);
        if let Some(&index) = self.indices.get(&key) {
            return Some(index);
        }
        let index = u16::try_from(self.materials.len()).ok().filter(|&index| usize::from(index) < MAX_MATERIALS)?;
        self.materials.push(*material);
        self.indices.insert(key, index);
        Some(index)
    }
}

/// Number of voxels of each material; a grid counts once for each of its instances.
fn uses(scene: &Scene) -> Vec<u64> {
    let mut uses = vec![0u64; scene.materials.len()];
    for (index, grid) in scene.grids.iter().enumerate() {
        let times = scene.instances.iter().filter(|instance| instance.grid == index).count().max(1) as u64;
        for (_, brick) in grid.sorted_bricks() {
            for &material in brick.materials() {
                if let Some(uses) = uses.get_mut(usize::from(material)) {
                    *uses += times;
                }
            }
        }
    }
    uses
}

/// Gives each voxel the material that `of` returns for its old one and its coordinates in its grid.
fn repaint(scene: &mut Scene, of: impl Fn(u16, IVec3) -> u16 + Sync) {
    for grid in &mut scene.grids {
        let bricks = grid.sorted_bricks();
        let repainted = bricks.par_iter().map(|&(at, brick)| {
            let corner = at * BRICK_SIZE;
            let materials = brick.voxels().map(|(local, material)| of(material, corner + local)).collect();
            (at, Brick::new(*brick.occupancy(), materials))
        });
        *grid = Arc::new(VoxelGrid::from_bricks(repainted.collect::<Vec<_>>()));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use voxtrace_scene::material::linear_color;

    #[test]
    fn materials_take_the_nearest_colours_and_lamps_keep_their_strength() {
        let texels = [[255, 0, 0, 255], [0, 0, 255, 255], [250, 250, 250, 255], [0, 255, 0, 20], [255, 0, 0, 255]];
        let colors = colors_of_texels(&texels, 255);
        assert_eq!(colors, [[0, 0, 255], [250, 250, 250], [255, 0, 0]].map(linear_color));
        let lamp = Material { emission: Vec3::new(4.0, 1.0, 1.0), ..Material::diffuse(Vec3::new(0.9, 0.1, 0.1)) };
        let bulb = Material::emissive(Vec3::new(0.1, 0.1, 3.0));
        let plain = Material::diffuse(linear_color([20, 30, 200]));
        let mut grid = VoxelGrid::new();
        for x in 0..4 {
            grid.set(IVec3::X * x, x as u16);
        }
        let mut scene = Scene::from_grid("", grid, vec![plain, lamp, bulb, plain]);
        recolor(&mut scene, &colors, false);
        let of = |x: i32| scene.materials[usize::from(scene.grids[0].get(IVec3::X * x).unwrap())];
        assert_eq!((of(0).base_color, scene.materials.len()), (colors[0], 3));
        assert_eq!((of(1).base_color, of(1).emission), (colors[2], colors[2] * 4.0));
        assert_eq!((of(2).base_color, of(2).emission), (Vec3::ZERO, colors[0] * 3.0));
        assert_eq!(of(3), of(0));
        let before = scene.clone();
        recolor(&mut scene, &[], false);
        assert_eq!(scene, before);
    }

    #[test]
    fn more_colours_than_allowed_are_quantized() {
        let texels: Vec<[u8; 4]> = (0..4096).map(|i| [(i % 64 * 4) as u8, (i / 64 * 4) as u8, 128, 255]).collect();
        let colors = colors_of_texels(&texels, 16);
        assert!(colors.len() <= 16 && colors.len() > 8, "{}", colors.len());
        assert_eq!(colors_of_texels(&texels, 65_535).len(), 4096);
        assert!(colors_of_texels(&[[1, 2, 3, 0]], 16).is_empty());
    }

    /// Columns of 16 × 16 voxels, one for each of so many greys, from the world's origin along x.
    fn greys(count: i32) -> Scene {
        let mut grid = VoxelGrid::new();
        for (x, yz) in (0..count).flat_map(|x| (0..256).map(move |yz| (x, yz))) {
            grid.set(IVec3::new(x, yz % 16, yz / 16), x as u16);
        }
        let shade = |x: i32| Material::diffuse(linear_color([(60 + x * 120 / count) as u8; 3]));
        Scene::from_grid("greys", grid, (0..count).map(shade).collect())
    }

    /// Means of the lightness of the voxels of each column.
    fn lightness(scene: &Scene) -> Vec<f32> {
        let count = scene.grids[0].bounds().unwrap().max.x as usize;
        let mut sums = vec![0.0; count];
        for (voxel, material) in scene.grids[0].voxels() {
            sums[voxel.x as usize] += oklab_of(scene.materials[usize::from(material)].base_color).x / 256.0;
        }
        sums
    }

    #[test]
    fn the_materials_of_any_scene_are_quantized_and_dithering_keeps_their_means() {
        let scene = greys(60);
        let wanted = lightness(&scene);
        let worst = |scene: &Scene| {
            let differences = lightness(scene).into_iter().zip(&wanted).map(|(found, wanted)| (found - wanted).abs());
            differences.fold(0.0, f32::max)
        };
        let (mut plain, mut mixed) = (scene.clone(), scene.clone());
        quantize_palette(&mut plain, 6, false);
        quantize_palette(&mut mixed, 6, true);
        assert!((2..=6).contains(&plain.materials.len()) && (2..=6).contains(&mixed.materials.len()));
        assert_eq!((plain.grids[0].count(), mixed.grids[0].count()), (60 * 256, 60 * 256));
        assert!(worst(&plain) < 0.06, "{}", worst(&plain));
        // The two ends of the ramp lie outside of all mixtures.
        let inner = |scene: &Scene| {
            let pairs = lightness(scene).into_iter().zip(&wanted).skip(8).take(44);
            pairs.map(|(found, wanted)| (found - wanted).abs()).fold(0.0, f32::max)
        };
        assert!(inner(&mixed) < 0.3 * inner(&plain), "{} {}", inner(&mixed), inner(&plain));
        let mut same = scene.clone();
        quantize_palette(&mut same, 60, true);
        assert!(same == scene);
        let two = [linear_color([60; 3]), linear_color([180; 3])];
        let mut black_and_white = scene.clone();
        recolor(&mut black_and_white, &two, false);
        let plain = worst(&black_and_white);
        let near = [linear_color([100; 3]), linear_color([130; 3]), linear_color([60; 3]), linear_color([180; 3])];
        let mut mixed = scene.clone();
        recolor(&mut mixed, &near, true);
        assert!(mixed.materials.len() == 4 && worst(&mixed) < 0.2 * plain, "{} {plain}", worst(&mixed));
    }

    #[test]
    fn emitters_and_glass_stay_so_when_colours_are_quantized() {
        let mut scene = greys(60);
        let lamp = Material::emissive(Vec3::new(5.0, 4.0, 3.0));
        let glass = Material { transmission: 0.9, roughness: 0.0, ..Material::diffuse(Vec3::ONE) };
        scene.materials.extend([lamp, glass]);
        let grid = Arc::make_mut(&mut scene.grids[0]);
        grid.set(IVec3::new(0, 0, 20), 60);
        grid.set(IVec3::new(0, 0, 21), 61);
        quantize_palette(&mut scene, 12, true);
        assert!(scene.materials.len() <= 12, "{}", scene.materials.len());
        let of = |z: i32| scene.materials[usize::from(scene.grids[0].get(IVec3::new(0, 0, z)).unwrap())];
        assert!((of(20).emission - lamp.emission).abs().max_element() < 0.02);
        assert_eq!((of(21).transmission, of(21).roughness, of(0).transmission), (0.9, 0.0, 0.0));
    }
}
