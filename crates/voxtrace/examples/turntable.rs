//! Twelve pictures around a scene, as an animation or for a contact sheet: `cargo run --release --example turntable -- FOLDER`

use std::path::Path;
use voxtrace::glam::Vec3;
use voxtrace::{Camera, Renderer, scenes};

const FRAMES: u32 = 12;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folder = std::env::args().nth(1).unwrap_or("turntable".into());
    std::fs::create_dir_all(&folder)?;
    let mut renderer = Renderer::new(&scenes::generate("city", Some(300_000))?)?.size(320, 180).samples(16);
    let overview = renderer.scene().overview(16.0 / 9.0);
    let offset = overview.eye - overview.target;
    for frame in 0..FRAMES {
        let angle = frame as f32 / FRAMES as f32 * std::f32::consts::TAU;
        let (sine, cosine) = angle.sin_cos();
        let turned = Vec3::new(offset.x * cosine - offset.y * sine, offset.x * sine + offset.y * cosine, offset.z);
        renderer = renderer.view(Camera { eye: overview.target + turned, ..overview.clone() }).seed(frame);
        let path = Path::new(&folder).join(format!("frame_{frame:04}.png"));
        renderer.render()?.save(&path)?;
        println!("{}", path.display());
    }
    Ok(())
}
