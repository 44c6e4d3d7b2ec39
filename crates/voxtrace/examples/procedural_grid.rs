//! A grid from a formula: a gyroid, a surface that divides space in two, cut to a ball and coloured by height.
//! `cargo run --release --example procedural_grid -- gyroid.png`

use voxtrace::glam::{IVec3, Vec3};
use voxtrace::grid::VoxelBox;
use voxtrace::{Camera, Material, Renderer, Scene, Sky, Sun, VoxelGrid};

const EDGE: i32 = 128;
const SHADES: i32 = 16;

/// Distance from the gyroid sin x cos y + sin y cos z + sin z cos x = 0, roughly.
fn gyroid(p: Vec3) -> f32 {
    p.x.sin() * p.y.cos() + p.y.sin() * p.z.cos() + p.z.sin() * p.x.cos()
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path = std::env::args().nth(1).unwrap_or("procedural_grid.png".into());
    let middle = Vec3::splat(EDGE as f32 / 2.0);
    let mut grid = VoxelGrid::new();
    for index in 0..EDGE.pow(3) {
        let voxel = IVec3::new(index % EDGE, index / EDGE % EDGE, index / EDGE.pow(2));
        let centre = voxel.as_vec3() + 0.5;
        // Three periods along an edge.
        let is_wall = gyroid((centre - middle) * (3.0 * std::f32::consts::TAU / EDGE as f32)).abs() < 0.3;
        if is_wall && centre.distance(middle) < middle.x {
            grid.set(voxel, (voxel.z * SHADES / EDGE) as u16);
        }
    }
    let voxels = grid.count();
    let floor = VoxelBox { min: IVec3::new(-1500, -1500, -2), max: IVec3::new(1500, 1500, 0) };
    grid.fill_box(floor, SHADES as u16);

    let shade = |z: i32| Material::from_srgb([30 + z as u8 * 14, 100 + z as u8 * 6, 150 - z as u8 * 6]);
    let materials = (0..SHADES).map(shade).chain([Material::from_srgb([205, 203, 198])]).collect();
    let mut scene = Scene::from_grid("gyroid", grid, materials);
    let direction = Vec3::new(0.75, -0.35, 0.9).normalize();
    let sun = Sun { direction, angular_radius: 0.03, irradiance: Vec3::new(3.2, 2.9, 2.4) };
    scene.sky = Sky::study(0.5).with_sun(sun);
    let camera = Camera { fov_y: 36.0, ..Camera::look_at(Vec3::new(190.0, -120.0, 150.0), middle * 0.92) };
    Renderer::new(&scene)?.view(camera).size(400, 300).samples(40).render()?.save(&path)?;
    println!("{path}: a gyroid of {voxels} voxels");
    Ok(())
}
