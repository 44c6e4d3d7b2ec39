//! The gallery's pictures of materials, one for each slider: five balls and five bricks, from its least value to its greatest. `cargo xtask
//! pictures material-gallery` runs it and makes the pictures small. `cargo run --release -p voxtrace-tests --example material_gallery -- FOLDER [SHEET…]`

use std::path::Path;
use voxtrace::glam::{IVec3, Vec3};
use voxtrace::grid::VoxelBox;
use voxtrace::{Camera, Material, Renderer, Scene, Sky, Sun, VoxelGrid};

/// Values of one slider.
const COLUMNS: usize = 5;
/// Voxels from one column to the next, radius of a ball, and size of a brick.
const SPACE: i32 = 34;
const RADIUS: i32 = 13;
const BRICK: IVec3 = IVec3::new(26, 12, 10);
const SIZE: (u32, u32) = (640, 232);

/// A picture: its name, whether lamps are all its light, and the material of each value.
struct Sheet {
    name: &'static str,
    is_dark: bool,
    materials: [Material; COLUMNS],
}

/// A sheet by the values that the page names.
fn sheet(name: &'static str, values: [f32; COLUMNS], material: impl Fn(f32) -> Material) -> Sheet {
    Sheet { name, is_dark: name == "emission", materials: values.map(material) }
}

fn sheets() -> Vec<Sheet> {
    const ROUGHNESS: [f32; COLUMNS] = [0.0, 0.25, 0.5, 0.75, 1.0];
    const SHARE: [f32; COLUMNS] = [0.0, 0.25, 0.5, 0.75, 1.0];
    let [gold, red, amber, green] = [[255, 196, 90], [190, 30, 40], [250, 170, 60], [70, 150, 80]]
        .map(|color| Material::from_srgb(color).base_color);
    vec![
        sheet("metal-roughness", ROUGHNESS, |roughness| Material::metal(gold, roughness)),
        sheet("metal-share", SHARE, |metallic| Material { metallic, ..Material::plastic(gold, 0.2) }),
        sheet("plastic-roughness", ROUGHNESS, |roughness| Material::plastic(red, roughness)),
        sheet("plastic-coat", SHARE, |specular| Material { specular, ..Material::plastic(red, 0.1) }),
        sheet("glass-roughness", [0.0, 0.15, 0.3, 0.45, 0.6], |roughness| Material::glass(1.5, roughness)),
        sheet("glass-index", [1.0, 1.1, 1.33, 1.5, 2.4], |ior| Material::glass(ior, 0.0)),
        sheet("glass-share", SHARE, |transmission| Material { transmission, ..Material::plastic(green, 0.1) }),
        sheet("glass-colour", [320.0, 80.0, 40.0, 20.0, 10.0], |voxels| {
            Material::glass(1.5, 0.0).tinted(amber, voxels)
        }),
        sheet("cloud-density", [0.01, 0.03, 0.1, 0.3, 1.0], |density| Material::cloud(Vec3::splat(0.99), density, 0.0)),
        sheet("cloud-phase", [-0.8, -0.4, 0.0, 0.4, 0.8], |g| Material::cloud(Vec3::splat(0.99), 0.1, g)),
        sheet("emission", [0.05, 0.2, 1.0, 4.0, 16.0], |strength| {
            Material::from_srgb([255, 150, 60]).glowing(strength)
        }),
    ]
}

/// The balls behind, the bricks in front, on a floor of tiles.
fn scene(sheet: &Sheet) -> Scene {
    let mut materials = [[205, 200, 190], [125, 122, 118]].map(Material::from_srgb).to_vec();
    let mut grid = VoxelGrid::new();
    for tile in 0..40 * 30 {
        let corner = IVec3::new(tile % 40 * 10 - 130, tile / 40 * 10 - 100, -1);
        grid.fill_box(VoxelBox { min: corner, max: corner + IVec3::new(10, 10, 1) }, ((tile + tile / 40) % 2) as u16);
    }
    for (column, material) in (0..).zip(sheet.materials) {
        let index = materials.len() as u16;
        materials.push(material);
        let middle = IVec3::new(column * SPACE, 0, RADIUS);
        for at in 0..(2 * RADIUS).pow(3) {
            let at = IVec3::new(at % 26, at / 26 % 26, at / 676) - RADIUS;
            if (at.as_vec3() + 0.5).length() < RADIUS as f32 {
                grid.set(middle + at, index);
            }
        }
        let corner = IVec3::new(column * SPACE - BRICK.x / 2, -32, 0);
        grid.fill_box(VoxelBox { min: corner, max: corner + BRICK }, index);
    }
    let mut scene = Scene::from_grid(sheet.name, grid, materials);
    scene.sky = if sheet.is_dark {
        Sky::gradient(Vec3::splat(0.004), Vec3::splat(0.012))
    } else {
        // A wide sun: what glass and metal focus of it is soft.
        let direction = Vec3::new(-0.6, -0.5, 0.8).normalize();
        let sun = Sun { direction, angular_radius: 0.3, irradiance: Vec3::splat(2.0) };
        Sky::gradient(Vec3::new(0.35, 0.33, 0.3), Vec3::new(0.55, 0.75, 1.1)).with_sun(sun)
    };
    scene
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args().skip(1);
    let folder = arguments.next().ok_or("which folder?")?;
    let wanted: Vec<String> = arguments.collect();
    let middle = Vec3::new((COLUMNS as i32 - 1) as f32 * SPACE as f32 / 2.0, -14.0, 9.0);
    let camera = Camera { fov_y: 14.6, ..Camera::look_at(middle + Vec3::new(0.0, -235.0, 115.0), middle) };
    for sheet in sheets().iter().filter(|sheet| wanted.is_empty() || wanted.iter().any(|name| name == sheet.name)) {
        let path = Path::new(&folder).join(sheet.name).with_extension("png");
        let mut renderer = Renderer::new(&scene(sheet))?.view(camera.clone()).size(SIZE.0, SIZE.1);
        // What comes out of a white cloud was scattered many times.
        let bounces = if sheet.name.starts_with("cloud") { 128 } else { 24 };
        renderer = renderer.samples(64).max_bounces(bounces).denoise(true);
        renderer.render()?.save(&path)?;
        println!("{}", path.display());
    }
    Ok(())
}
