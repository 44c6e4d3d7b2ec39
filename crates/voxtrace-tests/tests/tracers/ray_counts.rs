//! The processor counts the rays that devices count, of every kind; and it says which walk traced them.

use crate::cuts::{cut, plane, things};
use std::sync::Arc;
use voxtrace::cuts::Cuts;
use voxtrace::glam::Vec3;
use voxtrace::{Camera, CpuTracer, Frame, Instructions, Integrator, PackedScene, RayCounts, Scene, Tracer};
use voxtrace_tests::gpu::{assert_valid, device, film};
use voxtrace_vulkan::{Settings, VulkanTracer};

fn view(integrator: Integrator) -> Frame {
    let camera = Camera::look_at(Vec3::new(3.0, -26.0, 17.0), Vec3::new(0.0, 0.0, 1.0));
    Frame::new(camera, 40, 24).samples(3).max_bounces(5).integrator(integrator)
}

fn counted(scene: &Arc<PackedScene>, frame: &Frame) -> RayCounts {
    let mut cpu = CpuTracer::new(None);
    cpu.set_scene(scene).unwrap();
    film(&mut cpu, frame);
    cpu.ray_counts()
}

/// Scenes and frames in which each kind of ray is, or is not.
fn cases() -> Vec<(&'static str, Arc<PackedScene>, Frame)> {
    let whole = Cuts::default();
    let half = plane([0.0, -1.0, 0.0], 4.0);
    let named = |name, scene: &Scene, cuts: &Cuts, frame| (name, cut(scene, cuts), frame);
    let path = || view(Integrator::Path);
    vec![
        named("essay", &things(true, false), &whole, view(Integrator::Essay)),
        named("path among matte things", &things(true, true), &whole, path()),
        named("path through media", &things(false, true), &whole, path()),
        named("path through media with clear shadows", &things(false, true), &whole, path().clear_shadows(true)),
        named("path through media that are cut", &things(false, true), &half, path()),
    ]
}

#[test]
fn the_processor_counts_each_kind_of_ray_as_shaders_do() {
    let Some(device) = device() else { return };
    let mut tracer = VulkanTracer::new(Arc::clone(&device), Settings::default()).unwrap();
    for (name, scene, frame) in cases() {
        let ours = counted(&scene, &frame);
        tracer.set_scene(&scene).unwrap();
        film(&mut tracer, &frame);
        let theirs = tracer.statistics();
        let kinds = |counts: RayCounts| [counts.camera, counts.bounce, counts.light];
        let expected = [theirs.camera_rays, theirs.bounce_rays, theirs.shadow_rays];
        assert_eq!(kinds(ours), expected, "camera, bounces, lights: {name}");
        assert_eq!(ours.camera, 40 * 24 * 3);
        assert!(ours.bounce > 1000, "{name}: {ours:?}");
        assert_eq!(ours.light > 0, frame.integrator == Integrator::Path, "{name}: {ours:?}");
        // A planted fault: a bounce less.
        assert_ne!(kinds(counted(&scene, &frame.clone().max_bounces(frame.max_bounces - 1))), expected, "{name}");
    }
    drop(tracer);
    assert_valid(&device);
}

#[test]
fn rays_that_are_counted_are_those_of_the_last_call() {
    let (_, scene, frame) = cases().remove(1);
    let mut cpu = CpuTracer::new(Some(1));
    cpu.set_scene(&scene).unwrap();
    film(&mut cpu, &frame);
    let first = cpu.ray_counts();
    film(&mut cpu, &frame.clone().samples(4));
    assert_eq!(cpu.ray_counts().camera, 40 * 24, "one sample more");
    film(&mut cpu, &frame.clone().samples(4));
    assert_eq!(cpu.ray_counts(), RayCounts::default(), "nothing was left to do");
    assert_eq!(counted(&scene, &frame), first, "on any number of threads");
}

#[test]
fn in_air_every_ray_is_traced_by_one_walk_or_another() {
    for (name, scene, frame) in cases() {
        let counts = counted(&scene, &frame);
        let is_in_media = frame.integrator == Integrator::Path && scene.has_media();
        if !is_in_media {
            assert_eq!(counts.walks.total(), counts.total(), "{name}: {counts:?}");
        }
        assert!(counts.walks.total() <= counts.total() && counts.walks.total() > counts.camera, "{name}: {counts:?}");
        match Instructions::chosen() {
            Instructions::Scalar => assert_eq!(counts.walks.scalar, counts.walks.total(), "{name}"),
            _ => assert_eq!(counts.walks.scalar, 0, "{name}"),
        }
    }
}
