//! A grid from a formula: a gyroid, cut out of a cube, with a colour for each height.
//! `cargo run --release --example procedural_grid -- gyroid.png`

use voxtrace::glam::{IVec3, Vec3};
use voxtrace::{Camera, Material, Renderer, Scene, VoxelGrid};

const EDGE: i32 = 96;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path = std::env::args().nth(1).unwrap_or("procedural_grid.png".into());
    let mut grid = VoxelGrid::new();
    for index in 0..EDGE.pow(3) {
        let voxel = IVec3::new(index % EDGE, index / EDGE % EDGE, index / EDGE.pow(2));
        // sin x cos y + sin y cos z + sin z cos x = 0, two periods along an edge.
        let p = (voxel.as_vec3() + 0.5) * (4.0 * std::f32::consts::PI / EDGE as f32);
        let distance = p.x.sin() * p.y.cos() + p.y.sin() * p.z.cos() + p.z.sin() * p.x.cos();
        if distance.abs() < 0.2 {
            grid.set(voxel, (voxel.z * 16 / EDGE) as u16);
        }
    }
    let materials =
        (0..16u8).map(|shade| Material::from_srgb([90 + shade * 10, 200 - shade * 8, 230 - shade * 4])).collect();
    let scene = Scene::from_grid("gyroid", grid, materials);
    let middle = Vec3::splat(EDGE as f32 / 2.0);
    let camera = Camera::look_at(middle + Vec3::new(130.0, -170.0, 110.0), middle);
    Renderer::new(&scene)?.view(camera).size(480, 360).samples(32).render()?.save(&path)?;
    println!("{path}: {} voxels", scene.grids[0].count());
    Ok(())
}
