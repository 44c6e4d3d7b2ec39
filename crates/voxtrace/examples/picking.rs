//! What lies under a pixel: casts the ray of a pixel, names what it meets, and lights up the voxels around it.
//! `cargo run --release --example picking -- picked.png`

use std::sync::Arc;
use voxtrace::glam::{IVec3, Vec2};
use voxtrace::{Material, Renderer, scenes};

const SIZE: (u32, u32) = (400, 225);
/// The pixel that is picked, from the upper left corner.
const PIXEL: (u32, u32) = (190, 60);
const RADIUS: i32 = 14;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path = std::env::args().nth(1).unwrap_or("picking.png".into());
    let mut scene = scenes::generate("city", Some(600_000))?;
    let renderer = Renderer::new(&scene)?;
    let packed = renderer.scene();

    let camera = scene.cameras[0].frame(SIZE.0, SIZE.1);
    // Half a pixel on: its middle.
    let position = Vec2::new(PIXEL.0 as f32 + 0.5, PIXEL.1 as f32 + 0.5);
    let hit = packed.cast(&camera.central_ray(position)).ok_or("the pixel shows the sky")?;
    let instance = packed.scene_instance(&hit);
    println!("voxel {} of instance {instance}, {:.1} voxels away, face {:?}", hit.voxel, hit.t, hit.face());
    println!("its colour, linear: {:.2}", packed.material(&hit).base_color);

    let glow = scene.materials.len() as u16;
    scene.materials.push(Material::from_srgb([255, 0, 90]).glowing(1.0));
    let grid = Arc::make_mut(&mut scene.grids[scene.instances[instance].grid]);
    let near: Vec<IVec3> =
        grid.voxels().map(|(voxel, _)| voxel).filter(|v| v.distance_squared(hit.voxel) < RADIUS.pow(2)).collect();
    for voxel in &near {
        grid.set(*voxel, glow);
    }
    Renderer::new(&scene)?.size(SIZE.0, SIZE.1).samples(24).render()?.save(&path)?;
    println!("{path}: the {} voxels around it glow", near.len());
    Ok(())
}
