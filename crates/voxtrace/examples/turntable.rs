//! Twelve pictures around a scene, for an animation or a contact sheet, in the folder that is named:
//! `cargo run --release --example turntable -- FOLDER`

use std::path::Path;
use voxtrace::glam::{Quat, Vec3};
use voxtrace::{Camera, Renderer, scenes};

const FRAMES: u32 = 12;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folder = std::env::args().nth(1).unwrap_or("turntable".into());
    std::fs::create_dir_all(&folder)?;
    let mut renderer = Renderer::new(&scenes::generate("city", Some(400_000))?)?.size(320, 180).samples(8);
    // Nearer than the view of everything: the scene fills the picture from all sides.
    let overview = renderer.scene().overview(16.0 / 9.0);
    let target = overview.target.with_z(0.0);
    let offset = (overview.eye - target) * 0.58;
    for frame in 0..FRAMES {
        let turn = Quat::from_axis_angle(Vec3::Z, frame as f32 / FRAMES as f32 * std::f32::consts::TAU);
        let camera = Camera { eye: target + turn * offset, target, ..overview.clone() };
        let path = Path::new(&folder).join(format!("frame_{frame:04}.png"));
        renderer = renderer.view(camera).seed(frame);
        renderer.render()?.save(&path)?;
        println!("{}", path.display());
    }
    Ok(())
}
