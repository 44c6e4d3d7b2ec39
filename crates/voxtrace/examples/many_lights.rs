//! Two thousand lamps in the dark, set like the seeds of a sunflower: emissive voxels are found by a light tree, so that their
//! number hardly counts. `cargo run --release --example many_lights -- lamps.png`

use voxtrace::glam::{IVec3, Vec3};
use voxtrace::grid::VoxelBox;
use voxtrace::{Camera, Material, Renderer, Scene, Sky, VoxelGrid};

const LAMPS: i32 = 2_000;
const FLOOR: u16 = 6;
const POST: u16 = 7;
const COLORS: [[u8; 3]; 6] =
    [[255, 60, 30], [255, 140, 30], [90, 220, 70], [30, 150, 255], [100, 60, 255], [255, 50, 150]];

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path = std::env::args().nth(1).unwrap_or("many_lights.png".into());
    let mut grid = VoxelGrid::new();
    grid.fill_box(VoxelBox { min: IVec3::new(-260, -260, -1), max: IVec3::new(260, 260, 0) }, FLOOR);
    for index in 0..LAMPS {
        // Vogel's spiral: each lamp a golden angle on from the last.
        let (sine, cosine) = (index as f32 * 2.399_963).sin_cos();
        let distance = 5.0 * (index as f32 + 8.0).sqrt();
        let height = 6.0 + 4.0 * (distance / 18.0).sin();
        let foot = IVec3::new((distance * cosine).round() as i32, (distance * sine).round() as i32, 0);
        let top = foot + IVec3::new(0, 0, height as i32);
        grid.fill_box(VoxelBox { min: foot, max: top + IVec3::new(1, 1, 0) }, POST);
        // Neighbours along one of the 34 arms have numbers that differ by 34.
        grid.fill_box(VoxelBox { min: top, max: top + 2 }, (index % 34 * 6 / 34) as u16);
    }
    let lamps = COLORS.map(|color| Material::from_srgb(color).glowing(5.0));
    let matte = [[190, 190, 196], [60, 60, 66]].map(Material::from_srgb);
    let mut scene = Scene::from_grid("lamps", grid, [&lamps[..], &matte].concat());
    scene.sky = Sky::black();
    let camera = Camera { fov_y: 38.0, ..Camera::look_at(Vec3::new(0.0, -350.0, 280.0), Vec3::new(0.0, -28.0, 0.0)) };
    Renderer::new(&scene)?.view(camera).size(400, 225).samples(32).render()?.save(&path)?;
    println!("{path}: {LAMPS} lamps");
    Ok(())
}
