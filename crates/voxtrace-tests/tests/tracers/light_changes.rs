//! Another light on the same scene: a tracer that has the scene uploads nothing, and gives the bits of a tracer that gets it anew.

use std::sync::Arc;
use voxtrace::sky::{Background, Environment};
use voxtrace::{CpuTracer, Integrator, PackedScene, Placement, Progress, Sky, Sun, TraceError, Tracer};
use voxtrace_test_support::skip;
use voxtrace_tests::environments::noise_map;
use voxtrace_tests::gpu::{film, wanted};
use voxtrace_tests::moving::moving;
use voxtrace_tests::rooms;
use voxtrace_vulkan::{Device, Fault, Faults, Options, Primitive, Settings, Traversal, VulkanTracer, devices, missing};

/// The scene in lights that each differ from the one before in one thing.
fn lights(scene: &PackedScene) -> Vec<Arc<PackedScene>> {
    let mut lit = scene.clone();
    let mut lights = Vec::new();
    lit.sky.set_sun(Sun::at(200.0, 35.0, 4.0));
    lights.push(Arc::new(lit.clone()));
    lit.sky.set_sun(Sun::at(120.0, 60.0, 4.0));
    lights.push(Arc::new(lit.clone()));
    lit.sky.set_brightness(0.25);
    lights.push(Arc::new(lit.clone()));
    lit.light_intensity *= 3.0;
    lights.push(Arc::new(lit));
    lights
}

/// Changes the light by one traversal; its device is its own, so that uploads are counted for it alone.
fn check_uploads(traversal: Traversal) {
    let Some(wanted) = wanted() else { return };
    let list = devices(Options::default()).unwrap();
    let info = list.iter().find(|info| info.index.to_string() == *wanted || info.name.contains(&*wanted)).unwrap();
    if let Some(reason) = missing(info, traversal) {
        skip(&format!("{}: {reason}", info.name));
        return;
    }
    let described = moving(12, 0);
    let scene = Arc::new(PackedScene::pack(&described).unwrap());
    let frame = rooms::frame(&described, (24, 18), 3, Integrator::Path);
    let settings = Settings { traversal, primitive: Primitive::Brick, is_exact: true };
    let device = Device::open(Options::default(), Some(&wanted), None).unwrap();
    let mut tracer = VulkanTracer::new(Arc::clone(&device), settings).unwrap();
    tracer.set_scene(&scene).unwrap();
    let mut last = film(&mut tracer, &frame);
    for lit in lights(&scene) {
        let before = uploaded(&device);
        tracer.set_scene(&lit).unwrap();
        assert_eq!(uploaded(&device), before, "{traversal:?}: a light is no array");
        let ours = film(&mut tracer, &frame);
        let mut fresh = CpuTracer::new(None);
        fresh.set_scene(&lit).unwrap();
        assert!(ours == film(&mut fresh, &frame), "{traversal:?}: the film of a fresh tracer");
        assert!(ours != last, "{traversal:?}: the comparison sees a light that did not change");
        last = ours;
    }
    // The same light with things elsewhere is another scene: it must not be taken for the same.
    let moved = Placement::of_scene(scene.geometry(), &moving(12, 4)).unwrap();
    let placed = Arc::new(scene.with_placement(&moved).unwrap());
    let before = uploaded(&device);
    tracer.set_scene(&placed).unwrap();
    assert!(uploaded(&device) > before, "{traversal:?}: the count sees an upload");
    let mut fresh = CpuTracer::new(None);
    fresh.set_scene(&placed).unwrap();
    assert!(film(&mut tracer, &frame) == film(&mut fresh, &frame), "{traversal:?}: things that moved");
}

#[test]
fn another_light_uploads_no_array_and_gives_the_bits_of_a_fresh_tracer() {
    check_uploads(Traversal::Walk);
}

#[test]
fn another_light_uploads_no_array_for_ray_queries_and_gives_the_bits_of_a_fresh_tracer() {
    check_uploads(Traversal::Query);
}

#[test]
fn another_light_uploads_no_array_for_a_pipeline_and_gives_the_bits_of_a_fresh_tracer() {
    check_uploads(Traversal::Pipeline);
}

/// Bytes that were sent to the device so far.
fn uploaded(device: &Device) -> u64 {
    device.memory().uploaded.values().sum()
}

#[test]
fn a_light_for_which_there_is_no_memory_leaves_no_scene() {
    let Some(wanted) = wanted() else { return };
    let described = moving(12, 0);
    let scene = Arc::new(PackedScene::pack(&described).unwrap());
    let frame = rooms::frame(&described, (24, 18), 1, Integrator::Essay);
    let mut lit = (*scene).clone();
    lit.sky = Sky::new(Background::Environment(Environment::new(noise_map(16, 3), 0.0)));
    let lit = Arc::new(lit);
    let faults = Faults::none();
    let options = Options { faults: Some(Arc::clone(&faults)), ..Options::default() };
    let device = Device::open(options, Some(&wanted), None).unwrap();
    let mut tracer = VulkanTracer::new(device, Settings::default()).unwrap();
    tracer.set_scene(&scene).unwrap();
    film(&mut tracer, &frame);
    faults.plant("vkCreateBuffer", Fault::OutOfDeviceMemory);
    tracer.set_scene(&lit).unwrap_err();
    assert_eq!(faults.fired().len(), 1);
    // Not the scene before, of which the tracer knows nothing any more.
    assert_eq!(tracer.render(&frame, &Progress::default()), Err(TraceError::NoScene));
    tracer.set_scene(&lit).unwrap();
    let mut fresh = CpuTracer::new(None);
    fresh.set_scene(&lit).unwrap();
    assert!(film(&mut tracer, &frame) == film(&mut fresh, &frame));
}
