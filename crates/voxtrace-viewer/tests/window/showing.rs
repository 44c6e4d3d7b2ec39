//! The benchmark of frames: what it measures is there for every frame, and what it draws is a window.

use crate::common::packed;
use crate::drawing::device;
use std::sync::Arc;
use voxtrace::{Frame, Integrator};
use voxtrace_viewer::frame_bench::{FrameBench, Times};
use voxtrace_vulkan::Settings;

const FRAMES: u32 = 3;

/// How many of each time there are, and whether all are above nothing.
fn counts(times: &Times) -> [(usize, bool); 5] {
    let all = [&times.wall_ms, &times.trace_ms, &times.resolve_ms, &times.panels_ms, &times.draw_ms];
    all.map(|times| (times.len(), times.iter().all(|&ms| ms > 0.0)))
}

#[test]
fn each_part_of_a_frame_is_measured_with_panels_and_without() {
    let Some(device) = device() else { return };
    let (scene, settings) = (packed(), Settings::default());
    let frame = Frame::new(scene.cameras[0].clone(), 96, 64).integrator(Integrator::Essay).max_bounces(3);
    let bench = FrameBench { device: &device, settings, scene: &scene, frame: &frame, frames: FRAMES };
    let traced = bench.traced().unwrap();
    let (some, none) = ((FRAMES as usize, true), (0, true));
    assert_eq!(counts(&traced), [some, some, none, none, none], "nothing is shown");
    for has_panels in [false, true] {
        let shown = bench.shown(has_panels).unwrap();
        assert_eq!(counts(&shown), [some, some, some, some, some]);
        let drawn = bench.drawn(has_panels).unwrap();
        assert_eq!(counts(&drawn), [some, none, none, some, some], "nothing is traced");
    }
    assert_eq!(Arc::clone(device.vulkan()).messages().first(), Vec::<String>::new());
}
