//! Boxes, spheres and copies: a block, hollowed by spheres, and its mirrored neighbour.
//! `cargo run --release --example editing -- edited.png`

use voxtrace::glam::{DVec3, IVec3, Mat3, Vec3};
use voxtrace::grid::VoxelBox;
use voxtrace::{Camera, Instance, Material, Renderer, Scene, Transform, VoxelGrid};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path = std::env::args().nth(1).unwrap_or("editing.png".into());
    let mut grid = VoxelGrid::new();
    grid.fill_box(VoxelBox { min: IVec3::ZERO, max: IVec3::new(64, 32, 48) }, 0);
    for step in 0..4 {
        grid.clear_sphere(DVec3::new(8.0 + 16.0 * f64::from(step), 0.0, 30.0), 7.0 + f64::from(step));
    }
    grid.fill_sphere(DVec3::new(56.0, 4.0, 30.0), 4.0, 2);
    // What stands in the lower left corner is set on top, in another place.
    let source = grid.clone();
    grid.copy_region(&source, VoxelBox { min: IVec3::ZERO, max: IVec3::new(16, 32, 16) }, IVec3::new(0, 0, 48));
    grid.fill_box(VoxelBox { min: IVec3::new(-40, -60, -2), max: IVec3::new(180, 60, 0) }, 1);
    grid.clear(IVec3::new(0, 0, 63));

    let stone = Material::from_srgb([196, 178, 150]);
    let floor = Material::from_srgb([110, 116, 124]);
    let lamp = Material::from_srgb([255, 170, 70]).glowing(12.0);
    let mut scene = Scene::from_grid("edited", grid, vec![stone, floor, lamp]);
    let mirror = Mat3::from_diagonal(Vec3::new(-1.0, 1.0, 1.0));
    scene.instances.push(Instance::new(0, Transform { linear: mirror, translation: Vec3::new(140.0, 0.0, 0.0) }));

    let camera = Camera::look_at(Vec3::new(70.0, -150.0, 80.0), Vec3::new(70.0, 10.0, 24.0));
    Renderer::new(&scene)?.view(camera).size(480, 270).samples(32).render()?.save(&path)?;
    println!("{path}: {} voxels", scene.grids[0].count());
    Ok(())
}
