//! `cargo bench -p voxtrace-tests --bench larger -- SCENE.vxt 1280x720 2 4 8`: a scene on the device whole, and in a half, a quarter and an eighth of the memory
//! that it takes there: seconds for a picture with 16 samples by `path`, bytes of pages that came, and whether the film is the same.

use std::error::Error;
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Instant;
use voxtrace::{Camera, Film, Frame, Integrator, PackedScene, Progress, Region, Tracer};
use voxtrace_vulkan::{Device, Options, Settings, Traversal, VulkanTracer};

/// Renders with so many bytes on the device, or as many as it has; returns the film.
fn measure(scene: &Arc<PackedScene>, frame: &Frame, budget: Option<u64>) -> Result<Film, Box<dyn Error>> {
    let device = Device::open(Options::default(), std::env::var("VOXTRACE_DEVICE").ok().as_deref(), budget)?;
    let settings = Settings { traversal: Traversal::Walk, is_exact: true, ..Settings::default() };
    let mut tracer = VulkanTracer::new(device, settings)?;
    let start = Instant::now();
    tracer.set_scene(scene)?;
    let set = start.elapsed().as_secs_f64();
    // Compiling is no part of it.
    tracer.render(&frame.clone().samples(0), &Progress::default())?;
    let start = Instant::now();
    let mut film = Film::new(1, 1, Region::full(1, 1), 0);
    let mut first = 0.0;
    for samples in [1, frame.samples] {
        tracer.render(&frame.clone().samples(samples), &Progress::default())?;
        first = if samples == 1 { start.elapsed().as_secs_f64() } else { first };
    }
    tracer.read(&mut film)?;
    let rendered = start.elapsed().as_secs_f64();
    let (peak, pages) = (tracer.memory().peak_bytes, tracer.paged());
    let pages = pages.map_or("whole".into(), |(bytes, rounds)| {
        format!("{:.3} GB of pages came in {rounds} rounds", bytes as f64 * 1e-9)
    });
    let rendered = format!("{rendered:.2} s, the first sample in {first:.2} s");
    println!("  at most {:.3} GB: set in {set:.2} s, rendered in {rendered}, {pages}", peak as f64 * 1e-9);
    Ok(film)
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).filter(|argument| !argument.starts_with("--")).collect();
    let [file, size, parts @ ..] = &arguments[..] else { return Err("which .vxt file, and what size?".into()) };
    let (width, height) = size.split_once('x').ok_or("a size is like 1280x720")?;
    let scene = Arc::new(PackedScene::open(&PathBuf::from(file))?);
    let camera =
        scene.cameras.first().cloned().unwrap_or_else(|| Camera::look_at([-1e3, -1e3, 5e2].into(), [0.0; 3].into()));
    let frame = Frame::new(camera, width.parse()?, height.parse()?).samples(16).integrator(Integrator::Path);
    let geometry = scene.geometry();
    let words = geometry.cells().len() + geometry.bricks().len() + geometry.brick_materials().len();
    let lights = size_of_val(geometry.emitters()) + size_of_val(geometry.light_nodes());
    let bytes = (4 * words + lights) as u64;
    println!("{file}: {:.3} GB, {} voxels", bytes as f64 * 1e-9, scene.statistics().voxels);
    let whole = measure(&scene, &frame, None)?;
    for part in parts.iter().filter_map(|part| part.parse::<u64>().ok()) {
        let film = measure(&scene, &frame, Some(bytes / part))?;
        println!("    {}", if film.pixels == whole.pixels { "the same film" } else { "ANOTHER FILM" });
    }
    Ok(())
}
