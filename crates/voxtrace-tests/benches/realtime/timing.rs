//! How long the steps of real-time light take on a device: at the first frame, while nothing moves, along a way of the camera, at half the rate, and where
//! instances move before a camera that stands.

use super::maker::OnDevice;
use super::situations::{Situation, on_the_way, size_of};
use super::{Args, Outcome, parts, scene_of};
use std::collections::BTreeMap;
use std::sync::Arc;
use voxtrace::{Frame, PackedScene, Tracer};
use voxtrace_vulkan::{Picture, Rate, RealTimeFrame};

/// Frames over which times are averaged, and those before.
const FRAMES: u32 = 24;
const BEFORE: u32 = 12;

pub fn measure(args: &Args) -> Outcome<()> {
    println!("| scene | | parts | all, ms | steps, ms | MB |\n|---|---|---|---:|---|---:|");
    for name in &args.scenes {
        let (scene, frame) = scene_of(args, name, None)?;
        let scene = Arc::new(scene);
        for parts_name in &args.parts {
            let mut device = OnDevice::new(args, parts(parts_name)?)?;
            eprintln!("{name} on {}", device.name());
            device.tracer.set_scene(&scene)?;
            let picture = device.picture(frame.width, frame.height)?;
            let line = |what: &str, frames: &[RealTimeFrame]| print(name, what, parts_name, frames);
            let first = device.tracer.show_real_time(&frame, Rate::Full, &picture)?;
            line("first frame", first.as_slice());
            for rate in [Rate::Full, Rate::Half] {
                let label = if rate == Rate::Half { " at half the rate" } else { "" };
                line(&format!("still{label}"), &frames(&mut device, &picture, rate, |_| frame.clone())?);
                let way = |number: u32| moved(&scene, &frame, number);
                line(&format!("moving{label}"), &frames(&mut device, &picture, rate, way)?);
            }
            line("64 instances move", &where_instances_move(args, name, &mut device, &picture)?);
        }
    }
    Ok(())
}

fn moved(scene: &PackedScene, frame: &Frame, number: u32) -> Frame {
    let mut frame = frame.clone();
    frame.camera = on_the_way(&frame.camera, number, size_of(scene));
    frame
}

fn frames(
    device: &mut OnDevice,
    picture: &Picture,
    rate: Rate,
    view: impl Fn(u32) -> Frame,
) -> Outcome<Vec<RealTimeFrame>> {
    let mut frames = Vec::new();
    for number in 0..BEFORE + FRAMES {
        let frame = device.tracer.show_real_time(&view(number), rate, picture)?.ok_or("the device was lost")?;
        if number >= BEFORE {
            frames.push(frame);
        }
    }
    Ok(frames)
}

/// The frames in which the balls move that were added to the scene.
fn where_instances_move(
    args: &Args,
    name: &str,
    device: &mut OnDevice,
    picture: &Picture,
) -> Outcome<Vec<RealTimeFrame>> {
    // The scenes that have balls already stay as they are.
    if name.contains('+') {
        return Ok(Vec::new());
    }
    let (scene, frame) = scene_of(args, name, Some(Situation::Moving))?;
    let mut frames = Vec::new();
    for step in Situation::Moving.steps(scene, &frame)?.unwrap_or_default().iter().take((BEFORE + FRAMES) as usize) {
        device.follow(step)?;
        let frame = device.tracer.show_real_time(&step.frame, Rate::Full, picture)?.ok_or("the device was lost")?;
        frames.push(frame);
    }
    Ok(frames.split_off((BEFORE as usize).min(frames.len())))
}

/// Prints the means.
fn print(name: &str, what: &str, parts: &str, frames: &[RealTimeFrame]) {
    if frames.is_empty() {
        return;
    }
    let count = frames.len().max(1) as f64;
    let mut steps: BTreeMap<&str, f64> = BTreeMap::new();
    for (step, ms) in frames.iter().flat_map(|frame| &frame.passes) {
        let group = if step.starts_with("filter_level") { "filter_levels" } else { step };
        *steps.entry(group).or_default() += ms / count;
    }
    let all = frames.iter().map(|frame| frame.gpu_ms).sum::<f64>() / count;
    let steps: Vec<String> = steps.iter().map(|(step, ms)| format!("{step} {ms:.3}")).collect();
    let bytes = frames.last().map_or(0, |frame| frame.bytes);
    println!("| {name} | {what} | {parts} | {all:.3} | {} | {:.0} |", steps.join(", "), bytes as f64 * 1e-6);
}
