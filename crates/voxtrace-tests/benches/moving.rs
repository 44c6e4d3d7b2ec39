//! `cargo bench -p voxtrace-tests --bench moving -- 10000 100000`: the cost of a frame, beside tracing, in which the given numbers of
//! instances move: making a placement, anew or from the one before, and passing it to a tracer, compared with packing the whole scene again.
//! Medians of twenty frames, milliseconds; the device's own time is that of its copies and of the build of its structure over the instances.

use std::error::Error;
use std::sync::Arc;
use std::time::Instant;
use voxtrace::{PackedScene, Placement, Scene, Tracer};
use voxtrace_tests::moving::moving;
use voxtrace_vulkan::{Device, Options, Primitive, Settings, Traversal, VulkanTracer, missing};

const FRAMES: u32 = 20;

/// The median of what `work` says for each frame.
fn median_of(
    frames: &[Scene],
    mut work: impl FnMut(&Scene) -> Result<f64, Box<dyn Error>>,
) -> Result<f64, Box<dyn Error>> {
    let mut values = frames.iter().map(&mut work).collect::<Result<Vec<_>, _>>()?;
    values.sort_by(f64::total_cmp);
    Ok(values[values.len() / 2])
}

/// Runs `work` for each frame; gives the median of its times, milliseconds.
fn median(frames: &[Scene], mut work: impl FnMut(&Scene) -> Result<(), Box<dyn Error>>) -> Result<f64, Box<dyn Error>> {
    median_of(frames, |scene| {
        let start = Instant::now();
        work(scene)?;
        Ok(start.elapsed().as_secs_f64() * 1e3)
    })
}

fn measure(count: usize, device: Option<&Arc<Device>>) -> Result<(), Box<dyn Error>> {
    let frames: Vec<Scene> = (0..FRAMES).map(|frame| moving(count, frame)).collect();
    let first = Arc::new(PackedScene::pack(&frames[0])?);
    let geometry = first.geometry();
    let pack = median(&frames, |scene| PackedScene::pack(scene).map(|_| ()).map_err(Into::into))?;
    let place = median(&frames, |scene| Placement::of_scene(geometry, scene).map(|_| ()).map_err(Into::into))?;
    let mut last = first.placement().clone();
    let follow = median(&frames, |scene| {
        last = last.moved_to_scene(geometry, scene)?;
        Ok(())
    })?;
    let bytes = first.placement().size_bytes();
    println!(
        "{count} instances: {bytes} bytes; packing {pack:.3}, placing {place:.3}, from the last frame {follow:.3}"
    );
    let Some(device) = device else { return Ok(()) };
    for (traversal, primitive) in [
        (Traversal::Walk, Primitive::Grid),
        (Traversal::Query, Primitive::Grid),
        (Traversal::Pipeline, Primitive::Grid),
        (Traversal::Pipeline, Primitive::Brick),
    ] {
        if missing(device.info(), traversal).is_some() {
            continue;
        }
        let settings = Settings { traversal, primitive, is_exact: true };
        let mut tracer = VulkanTracer::new(Arc::clone(device), settings)?;
        tracer.set_scene(&first)?;
        let mut last = first.placement().clone();
        let mut placements = Vec::new();
        for scene in &frames {
            last = last.moved_to_scene(geometry, scene)?;
            placements.push(last.clone());
        }
        let mut next = placements.iter().cycle();
        let set = median(&frames, |_| Ok(tracer.set_placement(next.next().expect("it goes round"))?))?;
        let on_device = median_of(&frames, |_| {
            tracer.set_placement(next.next().expect("it goes round"))?;
            Ok(tracer.statistics().gpu_ms)
        })?;
        let name = format!("{}:{}", traversal.name(), primitive.name());
        println!("  {name}: passing it on {set:.3}, of which on the device {on_device:.3}; in all {:.3}", follow + set);
    }
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    let counts: Vec<usize> = std::env::args().filter_map(|argument| argument.parse().ok()).collect();
    let device = Device::open(Options::default(), None, None).inspect_err(|error| eprintln!("no device: {error}")).ok();
    if let Some(device) = &device {
        println!("{}", device.info().name);
    }
    let counts = if counts.is_empty() { vec![10_000, 100_000] } else { counts };
    counts.into_iter().try_for_each(|count| measure(count, device.as_ref()))
}
