//! Two thousand lamps of six colours in the dark: emissive voxels are found by a light tree, so that their number hardly
//! counts. `cargo run --release --example many_lights -- lamps.png`

use voxtrace::glam::{IVec3, Vec3};
use voxtrace::grid::VoxelBox;
use voxtrace::{Camera, Material, Renderer, Scene, Sky, VoxelGrid};

const COLORS: [[u8; 3]; 6] =
    [[255, 90, 60], [255, 190, 80], [120, 255, 120], [80, 200, 255], [150, 110, 255], [255, 110, 200]];

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path = std::env::args().nth(1).unwrap_or("many_lights.png".into());
    let mut grid = VoxelGrid::new();
    grid.fill_box(VoxelBox { min: IVec3::new(0, 0, -1), max: IVec3::new(320, 320, 0) }, 6);
    for index in 0..2_000i32 {
        // The high bits of a multiplicative hash, taken twice: low bits and a single round would put the lamps in rows.
        let hash = |word: u32| (word ^ word >> 15).wrapping_mul(0x2c1b_3c6d);
        let random = |salt: i32| hash(hash((index * 3 + salt + 1) as u32)) >> 12;
        let foot = IVec3::new((random(0) % 320) as i32, (random(1) % 320) as i32, 0);
        let top = 2 + (random(2) % 24) as i32;
        grid.fill_box(VoxelBox { min: foot, max: foot + IVec3::new(1, 1, top) }, 7);
        grid.set(foot + IVec3::new(0, 0, top), (index % 6) as u16);
    }
    let lamps = COLORS.map(|color| Material::from_srgb(color).glowing(30.0));
    let matte = [[128, 128, 136], [70, 70, 76]].map(Material::from_srgb);
    let mut scene = Scene::from_grid("lamps", grid, [&lamps[..], &matte].concat());
    scene.sky = Sky::black();
    let camera = Camera::look_at(Vec3::new(160.0, -60.0, 110.0), Vec3::new(160.0, 140.0, 0.0));
    Renderer::new(&scene)?.view(camera).size(480, 270).samples(64).render()?.save(&path)?;
    println!("{path}");
    Ok(())
}
