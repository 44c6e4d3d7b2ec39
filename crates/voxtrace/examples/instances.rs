//! Three trees, planted seven hundred times: instances share their grid, whatever their rotation and scale.
//! `cargo run --release --example instances -- forest.png`

use voxtrace::glam::{DVec3, IVec3, Quat, Vec3};
use voxtrace::grid::VoxelBox;
use voxtrace::{Camera, Instance, Material, Renderer, Scene, Sky, Sun, Transform, VoxelGrid};

const GRASS: u16 = 0;
const BARK: u16 = 1;
/// Each with the balls of its crown: height and radius, voxels.
const TREES: [(u16, [(f64, f64); 3]); 3] = [
    (2, [(12.0, 7.0), (19.0, 5.0), (25.0, 3.0)]),
    (3, [(15.0, 7.5), (20.0, 6.5), (22.0, 5.0)]),
    (4, [(14.0, 6.0), (17.0, 7.0), (21.0, 4.5)]),
];

fn tree(leaves: u16, crown: [(f64, f64); 3]) -> VoxelGrid {
    let mut grid = VoxelGrid::new();
    grid.fill_box(VoxelBox { min: IVec3::new(-1, -1, 0), max: IVec3::new(2, 2, 14) }, BARK);
    for (height, radius) in crown {
        grid.fill_sphere(DVec3::new(0.5, 0.5, height), radius, leaves);
    }
    grid
}

/// A number in [0, 1), a hash in place of dice: the same forest on every run.
fn random(index: u32, salt: u32) -> f32 {
    let hash = |word: u32| (word ^ word >> 15).wrapping_mul(0x2c1b_3c6d);
    (hash(hash(index * 8 + salt + 1)) >> 8) as f32 / (1 << 24) as f32
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path = std::env::args().nth(1).unwrap_or("instances.png".into());
    let mut ground = VoxelGrid::new();
    ground.fill_box(VoxelBox { min: IVec3::new(-400, -200, -2), max: IVec3::new(1000, 1100, 0) }, GRASS);
    let colors = [[150, 168, 92], [101, 76, 54], [78, 134, 78], [196, 128, 44], [172, 74, 40]];
    let mut scene = Scene::from_grid("forest", ground, colors.map(Material::from_srgb).to_vec());

    let first = scene.grids.len();
    scene.grids.extend(TREES.map(|(leaves, crown)| tree(leaves, crown).into()));
    for index in 0..700 {
        let cell = Vec3::new((index % 28) as f32 - 5.0, (index / 28) as f32 - 2.0, 0.0);
        let place = (cell + Vec3::new(random(index, 0), random(index, 1), 0.0)) * 22.0;
        let turn = Transform::from_rotation(Quat::from_rotation_z(random(index, 2) * std::f32::consts::TAU));
        let planted = turn.scaled(0.7 + 0.8 * random(index, 3)).translated(place);
        // One tree in four is not a fir.
        let kind = if random(index, 4) < 0.75 { 0 } else { 1 + index as usize % 2 };
        scene.instances.push(Instance::new(first + kind, planted));
    }
    let direction = Vec3::new(0.8, 0.3, 0.5).normalize();
    let sun = Sun { direction, angular_radius: 0.02, irradiance: Vec3::new(4.5, 3.7, 2.6) };
    scene.sky = Sky::study(0.6).with_sun(sun);
    let camera =
        Camera { fov_y: 36.0, ..Camera::look_at(Vec3::new(150.0, -130.0, 130.0), Vec3::new(200.0, 130.0, 0.0)) };
    Renderer::new(&scene)?.view(camera).size(400, 225).samples(24).render()?.save(&path)?;
    println!("{path}: {} instances of {} grids", scene.instances.len(), scene.grids.len());
    Ok(())
}
