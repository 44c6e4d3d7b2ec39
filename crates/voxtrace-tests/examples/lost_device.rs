//! One picture by several devices of which one is lost on the way and does not come back, as its driver would say it (`faults.rs`): whether the film is that of
//! one device, and what it took.
//! `cargo run --release -p voxtrace-tests --example lost_device -- SCENE.vxt SAMPLES DEVICE DEVICE…`; devices by number or name. The last one is lost.

use std::error::Error;
use std::sync::Arc;
use std::thread;
use std::time::{Duration, Instant};
use voxtrace::{Film, Frame, PackedScene, Progress, Region, Tracer};
use voxtrace_vulkan::{Device, Fault, Faults, Options, Settings, SharedTracer, VulkanTracer};

const SIZE: (u32, u32) = (1920, 1080);

fn device(name: &str, faults: &Arc<Faults>) -> Result<VulkanTracer, Box<dyn Error>> {
    let options = Options { faults: Some(faults.clone()), ..Options::default() };
    Ok(VulkanTracer::new(Device::open(options, Some(name), None)?, Settings::default())?)
}

/// The film of a frame, and the seconds that it took.
fn rendered(tracer: &mut dyn Tracer, frame: &Frame) -> Result<(Film, f64), Box<dyn Error>> {
    let start = Instant::now();
    tracer.render(frame, &Progress::default())?;
    let mut film = Film::new(1, 1, Region::full(1, 1), 0);
    tracer.read(&mut film)?;
    Ok((film, start.elapsed().as_secs_f64()))
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [scene, samples, names @ ..] = &arguments[..] else {
        return Err("a scene, samples and devices are wanted".into());
    };
    let scene = Arc::new(PackedScene::open(scene.as_ref())?);
    let camera = scene.cameras.first().ok_or("the scene has no camera")?.clone();
    let frame = Frame::new(camera, SIZE.0, SIZE.1).samples(samples.parse()?);
    let first = frame.clone().samples(16).seed(77);

    let (name, others) = names.split_first().ok_or("no device is named")?;
    let mut alone = device(name, &Faults::none())?;
    alone.set_scene(&scene)?;
    rendered(&mut alone, &first)?;
    let (expected, one) = rendered(&mut alone, &frame)?;
    drop(alone);
    println!("{name} alone: {one:.2} s");

    let faults: Vec<Arc<Faults>> = names.iter().map(|_| Faults::none()).collect();
    let devices: Result<Vec<_>, _> = names.iter().zip(&faults).map(|(name, faults)| device(name, faults)).collect();
    let mut shared = SharedTracer::new(devices?, false);
    shared.set_scene(&scene)?;
    rendered(&mut shared, &first)?;
    let (film, all) = rendered(&mut shared, &frame)?;
    println!("{} devices: {all:.2} s, {:.2} times one; same film: {}", names.len(), one / all, film == expected);

    // The same once more, from the start: a third of the way the last one is lost.
    rendered(&mut shared, &first)?;
    let lost = faults.last().filter(|_| !others.is_empty()).ok_or("at least two devices are wanted")?.clone();
    let planting = thread::spawn(move || {
        thread::sleep(Duration::from_secs_f64(all / 3.0));
        lost.plant("vkCreateDevice", Fault::OutOfHostMemory);
        lost.plant("vkQueueSubmit", Fault::DeviceLost);
    });
    let (film, seconds) = rendered(&mut shared, &frame)?;
    planting.join().map_err(|_| "the loss was not planted")?;
    println!(
        "one lost after {:.2} s: {seconds:.2} s; same film: {}; left: {:?}",
        all / 3.0,
        film == expected,
        shared.names()
    );
    shared.take_notes().iter().for_each(|note| println!("  {note}"));
    if film == expected && shared.names().len() + 1 == names.len() { Ok(()) } else { Err("not as it should be".into()) }
}
