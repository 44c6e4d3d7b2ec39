//! One tree, planted four hundred times: instances share their grid, whatever their rotation and scale.
//! `cargo run --release --example instances -- forest.png`

use voxtrace::glam::{DVec3, IVec3, Quat, Vec3};
use voxtrace::grid::VoxelBox;
use voxtrace::{Camera, Instance, Material, Renderer, Scene, Transform, VoxelGrid};

const GRASS: u16 = 0;
const BARK: u16 = 1;
const LEAVES: u16 = 2;

fn tree() -> VoxelGrid {
    let mut grid = VoxelGrid::new();
    grid.fill_box(VoxelBox { min: IVec3::new(-1, -1, 0), max: IVec3::new(2, 2, 14) }, BARK);
    for (height, radius) in [(14.0, 7.0), (20.0, 5.5), (25.0, 3.5)] {
        grid.fill_sphere(DVec3::new(0.5, 0.5, height), radius, LEAVES);
    }
    grid
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path = std::env::args().nth(1).unwrap_or("instances.png".into());
    let mut ground = VoxelGrid::new();
    ground.fill_box(VoxelBox { min: IVec3::new(-20, -20, -2), max: IVec3::new(420, 420, 0) }, GRASS);
    let colors = [[106, 142, 74], [101, 76, 54], [58, 110, 52]];
    let mut scene = Scene::from_grid("forest", ground, colors.map(Material::from_srgb).to_vec());

    let first = scene.add_instance(tree(), Transform::IDENTITY);
    let shared = scene.instances.pop().map_or(first, |instance| instance.grid);
    for index in 0..400u32 {
        // A hash in place of dice: the same forest on every run.
        let random = |salt: u32| (index * 4 + salt).wrapping_mul(2_654_435_761) as f32 / u32::MAX as f32;
        let place = Vec3::new((index % 20) as f32 + random(0), (index / 20) as f32 + random(1), 0.0) * 20.0;
        let turn = Transform::from_rotation(Quat::from_rotation_z(random(2) * std::f32::consts::TAU));
        scene.instances.push(Instance::new(shared, turn.scaled(0.6 + 0.8 * random(3)).translated(place)));
    }
    let camera = Camera::look_at(Vec3::new(-60.0, -120.0, 130.0), Vec3::new(200.0, 180.0, 0.0));
    Renderer::new(&scene)?.view(camera).size(480, 270).samples(32).render()?.save(&path)?;
    println!("{path}: {} instances of {} grids", scene.instances.len(), scene.grids.len());
    Ok(())
}
