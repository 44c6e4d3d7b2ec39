//! What lies under a pixel: casts the ray of a pixel, names what it met, and renders it glowing.
//! `cargo run --release --example picking -- picked.png`

use voxtrace::glam::Vec2;
use voxtrace::{Material, Renderer, scenes};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let path = std::env::args().nth(1).unwrap_or("picking.png".into());
    let (width, height) = (480, 270);
    let mut scene = scenes::generate("operating-room", Some(200_000))?;
    let renderer = Renderer::new(&scene)?;
    let packed = renderer.scene();

    let camera = scene.cameras[0].frame(width, height);
    let hit =
        packed.cast(&camera.central_ray(Vec2::new(240.5, 135.5))).ok_or("the middle of the picture shows the sky")?;
    let instance = packed.scene_instance(&hit);
    println!("voxel {} of instance {instance} at {:.1} voxels, face {:?}", hit.voxel, hit.t, hit.face());
    println!("its material: {:?}", packed.material(&hit));

    let glow = scene.materials.len() as u16;
    scene.materials.push(Material::from_srgb([255, 120, 20]).glowing(4.0));
    let grid = &mut scene.grids[scene.instances[instance].grid];
    std::sync::Arc::make_mut(grid).fill_sphere(hit.voxel.as_dvec3() + 0.5, 2.5, glow);
    Renderer::new(&scene)?.size(width, height).samples(32).render()?.save(&path)?;
    println!("{path}");
    Ok(())
}
