//! Boxes, spheres and copies: one bay of a bridge, cut out of a block, copied along, and the whole of it mirrored.
//! `cargo run --release --example editing -- bridge.png`

use voxtrace::glam::{DVec3, IVec3, Mat3, Vec3};
use voxtrace::grid::VoxelBox;
use voxtrace::{Camera, Instance, Material, Renderer, Scene, Sky, Sun, Transform, VoxelGrid};

const STONE: u16 = 0;
const LAMP: u16 = 1;
const GROUND: u16 = 2;
/// Size of a bay, voxels: along the bridge, across it, and up.
const BAY: IVec3 = IVec3::new(32, 14, 52);

fn span(min: [i32; 3], max: [i32; 3]) -> VoxelBox {
    VoxelBox { min: IVec3::from(min), max: IVec3::from(max) }
}

/// A pier on either side, an arch with a lamp between them, and four small arches above.
fn bay() -> VoxelGrid {
    let mut grid = VoxelGrid::new();
    grid.fill_box(VoxelBox { min: IVec3::ZERO, max: BAY }, STONE);
    grid.clear_box(span([5, 0, 0], [27, 14, 22]));
    grid.clear_sphere(DVec3::new(16.0, 7.0, 21.0), 12.5);
    for x in [4, 12, 20, 28] {
        grid.clear_box(span([x - 2, 0, 38], [x + 2, 14, 43]));
        grid.clear_sphere(DVec3::new(f64::from(x), 0.0, 43.0), 2.5);
        grid.clear_box(span([x - 2, 0, 50], [x + 2, 2, 52]));
    }
    grid.fill_box(span([15, 6, 30], [17, 8, 34]), STONE);
    grid.fill_sphere(DVec3::new(16.0, 7.0, 28.0), 2.6, LAMP);
    grid
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path = std::env::args().nth(1).unwrap_or("editing.png".into());
    let bay = bay();
    let mut half = VoxelGrid::new();
    for index in 0..4 {
        half.copy_region(&bay, VoxelBox { min: IVec3::ZERO, max: BAY }, IVec3::new(index * BAY.x, 0, 0));
    }
    // A tower over the second bay, with battlements.
    half.fill_box(span([36, -3, 40], [60, 17, 78]), STONE);
    half.clear_box(span([38, -1, 70], [58, 15, 78]));
    for x in (38..60).step_by(6) {
        half.clear_box(span([x, -3, 74], [x + 3, 17, 78]));
    }
    half.clear_box(span([45, -3, 52], [51, 0, 64]));
    half.fill_sphere(DVec3::new(48.0, 0.0, 58.0), 2.6, LAMP);

    let colors = [[190, 172, 146], [255, 160, 60], [126, 132, 84]];
    let [stone, lamp, ground] = colors.map(Material::from_srgb);
    let mut scene = Scene::from_grid("bridge", half, vec![stone, lamp.glowing(6.0), ground]);
    let mirror = Mat3::from_diagonal(Vec3::new(-1.0, 1.0, 1.0));
    scene.instances.push(Instance::new(0, Transform { linear: mirror, translation: Vec3::ZERO }));
    let mut plain = VoxelGrid::new();
    plain.fill_box(span([-900, -300, -2], [900, 1500, 0]), GROUND);
    scene.add_instance(plain, Transform::IDENTITY);
    let direction = Vec3::new(-0.75, -0.6, 0.42).normalize();
    let sun = Sun { direction, angular_radius: 0.02, irradiance: Vec3::new(3.4, 2.6, 1.7) };
    scene.sky = Sky::gradient(Vec3::new(0.65, 0.55, 0.5), Vec3::new(0.16, 0.3, 0.6)).with_sun(sun);

    let camera = Camera { fov_y: 38.0, ..Camera::look_at(Vec3::new(-66.0, -205.0, 58.0), Vec3::new(-4.0, 0.0, 30.0)) };
    Renderer::new(&scene)?.view(camera).size(400, 225).samples(32).render()?.save(&path)?;
    println!(
        "{path}: {} voxels in {} grids, {} instances",
        scene.grids.iter().map(|grid| grid.count()).sum::<u64>(),
        scene.grids.len(),
        scene.instances.len()
    );
    Ok(())
}
