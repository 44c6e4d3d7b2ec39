//! The tracers on a Vulkan device against the CPU: the same hits and pictures, bit for bit.

use std::sync::Arc;
use voxtrace::{CpuTracer, Film, Frame, Hit, Integrator, PackedScene, Progress, Region, Tracer};
use voxtrace_tests::gpu::{assert_valid, cases, compare_hits, device};
use voxtrace_tests::rooms;
use voxtrace_vulkan::{Settings, VulkanTracer};

const RAYS: usize = 1 << 16;

fn cast(tracer: &mut dyn Tracer, scene: &Arc<PackedScene>, rays: &[voxtrace::Ray]) -> Vec<Hit> {
    let mut hits = vec![Hit { t: -1.0, instance: 7, ..Hit::MISS }; rays.len()];
    tracer.set_scene(scene).unwrap();
    tracer.cast(rays, &mut hits).unwrap();
    hits
}

#[test]
fn the_compute_walk_finds_the_hits_of_the_cpu() {
    let Some(device) = device() else { return };
    let mut tracer = VulkanTracer::new(Arc::clone(&device), Settings::default()).unwrap();
    for case in cases(RAYS) {
        let expected = cast(&mut CpuTracer::new(None), &case.scene, &case.rays);
        let mut hits = cast(&mut tracer, &case.scene, &case.rays);
        compare_hits(&case.rays, &hits, &expected).unwrap_or_else(|difference| panic!("{}: {difference}", case.name));
        assert_eq!(tracer.statistics().camera_rays, RAYS as u64, "the device counted the rays");
        // A planted fault.
        let met = expected.iter().position(|hit| !hit.is_miss()).unwrap();
        hits[met].voxel.x += 1;
        compare_hits(&case.rays, &hits, &expected).unwrap_err();
    }
    drop(tracer);
    assert_valid(&device);
}

/// A film full of nonsense, so that one that nobody wrote is noticed.
fn poisoned() -> Film {
    let mut film = Film::new(3, 3, Region::full(3, 3), 77);
    film.pixels.fill(voxtrace::film::Pixel { radiance: [99; 3], samples: 5, covered: 6 });
    film
}

fn render(tracer: &mut dyn Tracer, frame: &Frame) -> Film {
    tracer.render(frame, &Progress::default()).unwrap();
    let mut film = poisoned();
    tracer.read(&mut film).unwrap();
    film
}

#[test]
fn the_compute_walk_renders_the_pictures_of_the_cpu() {
    let Some(device) = device() else { return };
    let mut tracer = VulkanTracer::new(Arc::clone(&device), Settings::default()).unwrap();
    for scene in [rooms::lamp_room(), rooms::open_plain()] {
        let packed = Arc::new(PackedScene::pack(&scene).unwrap());
        for integrator in [Integrator::Essay, Integrator::Path] {
            let frame = Frame { layers: true, ..rooms::frame(&scene, (67, 41), 4, integrator) };
            let mut cpu = CpuTracer::new(None);
            cpu.set_scene(&packed).unwrap();
            tracer.set_scene(&packed).unwrap();
            let expected = render(&mut cpu, &frame);
            assert!(render(&mut tracer, &frame) == expected, "{} {integrator:?}", scene.name);
            let other = render(&mut tracer, &Frame { seed: 2, ..frame });
            assert!(other != expected, "the comparison sees another seed");
        }
    }
    drop(tracer);
    assert_valid(&device);
}
