//! `cargo bench -p voxtrace-tests --bench moving -- 1000 10000`: the cost of a frame, without tracing, in which the given numbers of
//! instances move: making a placement and passing it to the tracer, compared with packing the whole scene again. Medians of
//! twenty frames, milliseconds.

use std::error::Error;
use std::sync::Arc;
use std::time::Instant;
use voxtrace::{PackedScene, Placement, Scene, Tracer};
use voxtrace_tests::moving::moving;
use voxtrace_vulkan::{Device, Options, Primitive, Settings, Traversal, VulkanTracer, missing};

const FRAMES: u32 = 20;

/// Runs `work` for each frame; gives the median of its times, milliseconds.
fn median(frames: &[Scene], mut work: impl FnMut(&Scene) -> Result<(), Box<dyn Error>>) -> Result<f64, Box<dyn Error>> {
    let mut times = Vec::new();
    for scene in frames {
        let start = Instant::now();
        work(scene)?;
        times.push(start.elapsed().as_secs_f64() * 1e3);
    }
    times.sort_by(f64::total_cmp);
    Ok(times[times.len() / 2])
}

fn measure(count: usize, device: Option<&Arc<Device>>) -> Result<(), Box<dyn Error>> {
    let frames: Vec<Scene> = (0..FRAMES).map(|frame| moving(count, frame)).collect();
    let first = Arc::new(PackedScene::pack(&frames[0])?);
    let pack = median(&frames, |scene| PackedScene::pack(scene).map(|_| ()).map_err(Into::into))?;
    let place = median(&frames, |scene| Placement::of_scene(first.geometry(), scene).map(|_| ()).map_err(Into::into))?;
    let bytes = first.placement().size_bytes();
    println!("{count} instances: {bytes} bytes; packing {pack:.3}, placing {place:.3}");
    let Some(device) = device else { return Ok(()) };
    for (traversal, primitive) in [
        (Traversal::Walk, Primitive::Grid),
        (Traversal::Query, Primitive::Grid),
        (Traversal::Pipeline, Primitive::Brick),
    ] {
        if missing(device.info(), traversal).is_some() {
            continue;
        }
        let settings = Settings { traversal, primitive, is_exact: true };
        let mut tracer = VulkanTracer::new(Arc::clone(device), settings)?;
        tracer.set_scene(&first)?;
        let anew = median(&frames, |scene| Ok(tracer.set_scene(&Arc::new(PackedScene::pack(scene)?))?))?;
        tracer.set_scene(&first)?;
        let moved = median(&frames, |scene| Ok(tracer.set_placement(&Placement::of_scene(first.geometry(), scene)?)?))?;
        let name = traversal.name();
        println!("  {name}: packing and setting {anew:.3}, placing and setting {moved:.3}: {:.1} times", anew / moved);
    }
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    let counts: Vec<usize> = std::env::args().filter_map(|argument| argument.parse().ok()).collect();
    let device = Device::open(Options::default(), None, None).inspect_err(|error| eprintln!("no device: {error}")).ok();
    if let Some(device) = &device {
        println!("{}", device.info().name);
    }
    let counts = if counts.is_empty() { vec![1000, 10_000] } else { counts };
    counts.into_iter().try_for_each(|count| measure(count, device.as_ref()))
}
