//! Balls of metal, plastic, glass and cloud, from smooth to rough and from thin to dense: materials are a surface and, where light enters, a
//! medium. `cargo run --release --example materials -- materials.png`

use voxtrace::glam::{IVec3, Vec3};
use voxtrace::grid::VoxelBox;
use voxtrace::{Camera, Material, Renderer, Scene, Sky, Sun, VoxelGrid};

const RADIUS: i32 = 13;
const SPACE: i32 = 32;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path = std::env::args().nth(1).unwrap_or("materials.png".into());
    let mut materials = [[210, 205, 195], [120, 118, 115]].map(Material::from_srgb).to_vec();
    let mut grid = VoxelGrid::new();
    for tile in 0..24 * 16 {
        let corner = IVec3::new(tile % 24 * 10 - 60, tile / 24 * 10 - 30, -1);
        grid.fill_box(VoxelBox { min: corner, max: corner + IVec3::new(10, 10, 1) }, ((tile + tile / 24) % 2) as u16);
    }
    let [gold, red, amber] =
        [[255, 196, 90], [190, 30, 40], [250, 170, 60]].map(|rgb| Material::from_srgb(rgb).base_color);
    for column in 0..4 {
        let roughness = column as f32 / 3.5;
        let rows = [
            Material::metal(gold, roughness),
            Material::plastic(red, roughness),
            Material::glass(1.5, roughness * 0.7).tinted(amber, 40.0),
            Material::cloud(Vec3::splat(0.98), 0.02 * 3f32.powi(column), 0.5),
        ];
        for (row, material) in (0..).zip(rows) {
            materials.push(material);
            let middle = IVec3::new(column * SPACE, row * SPACE, RADIUS);
            for index in 0..(2 * RADIUS).pow(3) {
                let at = IVec3::new(index % 26, index / 26 % 26, index / 676) - RADIUS;
                if (at.as_vec3() + 0.5).length() < RADIUS as f32 {
                    grid.set(middle + at, materials.len() as u16 - 1);
                }
            }
        }
    }
    let mut scene = Scene::from_grid("materials", grid, materials);
    let sun =
        Sun { direction: Vec3::new(-0.6, -0.4, 0.9).normalize(), angular_radius: 0.1, irradiance: Vec3::splat(2.0) };
    scene.sky = Sky::gradient(Vec3::new(0.35, 0.33, 0.3), Vec3::new(0.55, 0.75, 1.1)).with_sun(sun);
    let middle = Vec3::new(48.0, 46.0, 6.0);
    let camera = Camera { fov_y: 34.0, ..Camera::look_at(middle + Vec3::new(-40.0, -165.0, 125.0), middle) };
    Renderer::new(&scene)?.view(camera).size(400, 300).samples(64).render()?.save(&path)?;
    println!("{path}: metal, plastic, glass and cloud");
    Ok(())
}
