//! The tracers on a Vulkan device against the CPU: the same hits and pictures, bit for bit.

use std::sync::{Arc, OnceLock};
use voxtrace::glam::{IVec3, Vec3};
use voxtrace::{CpuTracer, Film, Frame, Hit, Integrator, Material, PackedScene, Progress, Ray, Region, Scene, Tracer};
use voxtrace_test_support::{Alone, skip};
use voxtrace_tests::gpu::{Case, assert_valid, cases, compare_hits, device};
use voxtrace_tests::random::Random;
use voxtrace_tests::rooms;
use voxtrace_tests::scenes::noise;
use voxtrace_vulkan::{Device, Primitive, Settings, Traversal, VulkanTracer, missing};

const RAYS: usize = 1 << 16;

fn cast(tracer: &mut dyn Tracer, scene: &Arc<PackedScene>, rays: &[Ray]) -> Vec<Hit> {
    // Arbitrary values, so that a hit that was never written is noticed.
    let mut hits = vec![Hit { t: -1.0, instance: 7, ..Hit::MISS }; rays.len()];
    tracer.set_scene(scene).unwrap();
    tracer.cast_into(rays, &mut hits).unwrap();
    hits
}

/// The five scenes with the hits of the CPU.
fn expected() -> &'static [(Case, Vec<Hit>)] {
    static EXPECTED: OnceLock<Vec<(Case, Vec<Hit>)>> = OnceLock::new();
    EXPECTED.get_or_init(|| {
        let with_hits = |case: Case| {
            let hits = cast(&mut CpuTracer::new(None), &case.scene, &case.rays);
            (case, hits)
        };
        cases(RAYS).into_iter().map(with_hits).collect()
    })
}

/// A tracer, `None` where the machine has no device or, with a word about it, the device lacks the traversal.
fn tracer(traversal: Traversal, primitive: Primitive) -> Option<(Alone<Arc<Device>>, VulkanTracer)> {
    let device = device()?;
    if let Some(reason) = missing(device.info(), traversal) {
        skip(&format!("{} has no {}: {reason}", device.info().name, traversal.name()));
        return None;
    }
    let settings = Settings { traversal, primitive, is_exact: true };
    let tracer = VulkanTracer::new(Arc::clone(&device), settings).unwrap();
    Some((device, tracer))
}

/// Every ray of every scene meets what it meets on the CPU.
fn check_hits(traversal: Traversal, primitive: Primitive) {
    let Some((device, mut tracer)) = tracer(traversal, primitive) else { return };
    for (case, expected) in expected() {
        let mut hits = cast(&mut tracer, &case.scene, &case.rays);
        let compared = compare_hits(&case.rays, &hits, expected);
        compared.unwrap_or_else(|difference| panic!("{}: {difference}", case.name));
        assert_eq!(tracer.statistics().camera_rays, RAYS as u64, "the device counted the rays");
        // A planted wrong voxel.
        let met = expected.iter().position(|hit| !hit.is_miss()).unwrap();
        hits[met].voxel.x += 1;
        compare_hits(&case.rays, &hits, expected).unwrap_err();
    }
    drop(tracer);
    assert_valid(&device);
}

#[test]
fn the_compute_walk_finds_the_hits_of_the_cpu() {
    check_hits(Traversal::Walk, Primitive::default());
}

#[test]
fn queries_of_voxels_find_the_hits_of_the_cpu() {
    check_hits(Traversal::Query, Primitive::VoxelExact);
}

#[test]
fn queries_of_bricks_find_the_hits_of_the_cpu() {
    check_hits(Traversal::Query, Primitive::Brick);
}

#[test]
fn queries_of_grids_find_the_hits_of_the_cpu() {
    check_hits(Traversal::Query, Primitive::Grid);
}

#[test]
fn pipelines_of_voxels_find_the_hits_of_the_cpu() {
    check_hits(Traversal::Pipeline, Primitive::VoxelExact);
}

#[test]
fn pipelines_of_bricks_find_the_hits_of_the_cpu() {
    check_hits(Traversal::Pipeline, Primitive::Brick);
}

#[test]
fn pipelines_of_grids_find_the_hits_of_the_cpu() {
    check_hits(Traversal::Pipeline, Primitive::Grid);
}

/// Rays from 16,000 voxels away: what hardware rounds must not exceed what boxes are larger than their content.
#[test]
fn boxes_lose_no_voxel_to_rays_from_far_away() {
    let materials = vec![Material::default(); 3];
    let grid = noise(IVec3::ZERO, 40, 0.05, 3, 1);
    let scene = Arc::new(PackedScene::pack(&Scene::from_grid("far", grid, materials)).unwrap());
    let mut random = Random(3);
    let rays: Vec<Ray> = (0..RAYS)
        .map(|_| {
            let (target, direction) = (random.point(Vec3::ZERO, Vec3::splat(40.0)), random.direction());
            Ray::new(target - direction * 16_000.0, direction)
        })
        .collect();
    let expected = cast(&mut CpuTracer::new(None), &scene, &rays);
    for primitive in [Primitive::VoxelExact, Primitive::Brick, Primitive::Grid] {
        let Some((device, mut tracer)) = tracer(Traversal::Query, primitive) else { return };
        compare_hits(&rays, &cast(&mut tracer, &scene, &rays), &expected).unwrap();
        drop(tracer);
        assert_valid(&device);
    }
}

/// Whether the ray enters the voxel of its hit within 1/256 voxel of an edge of the face.
fn is_on_an_edge(scene: &PackedScene, ray: &Ray, hit: &Hit) -> bool {
    let grid_from_world = &scene.instances()[hit.instance as usize].grid_from_world;
    let point = grid_from_world.point(ray.origin + ray.direction * hit.t);
    let aside = (point - point.round()).abs();
    (0..3).any(|axis| axis != hit.face as usize / 2 && aside[axis] <= 1.0 / 256.0)
}

/// Number of hits that differ; an error where one differs far from edges.
fn differing(case: &Case, hits: &[Hit], expected: &[Hit]) -> Result<usize, String> {
    let odd: Vec<usize> = (0..hits.len()).filter(|&index| hits[index] != expected[index]).collect();
    for &index in &odd {
        let (ray, found) = (&case.rays[index], [hits[index], expected[index]]);
        if !found.iter().any(|hit| !hit.is_miss() && is_on_an_edge(&case.scene, ray, hit)) {
            return Err(format!("{}: {ray:?}\n got {:?}\n not {:?}", case.name, found[0], found[1]));
        }
    }
    Ok(odd.len())
}

/// As `check_hits`; but as hardware decides which triangles a ray meets, one ray of 10,000 may pass an edge on its other side.
fn check_triangles(traversal: Traversal) {
    let Some((device, mut tracer)) = tracer(traversal, Primitive::Triangle) else { return };
    for (case, expected) in expected() {
        let mut hits = cast(&mut tracer, &case.scene, &case.rays);
        let odd = differing(case, &hits, expected).unwrap_or_else(|difference| panic!("{difference}"));
        eprintln!("{} {}: {odd} of {RAYS} rays differ", traversal.name(), case.name);
        assert!(odd as f64 <= 1e-4 * RAYS as f64, "{}: {odd} rays differ", case.name);
        // A planted wrong voxel in the middle of a face.
        let is_inside = |&index: &usize| {
            let hit = &expected[index];
            !hit.is_miss() && !is_on_an_edge(&case.scene, &case.rays[index], hit)
        };
        hits[(0..RAYS).find(is_inside).unwrap()] = Hit::MISS;
        differing(case, &hits, expected).unwrap_err();
    }
    drop(tracer);
    assert_valid(&device);
}

#[test]
fn queries_of_triangles_find_the_hits_of_the_cpu() {
    check_triangles(Traversal::Query);
}

#[test]
fn pipelines_of_triangles_find_the_hits_of_the_cpu() {
    check_triangles(Traversal::Pipeline);
}

/// The study's approximate method is right where the nearest centre among the boxes that hardware hands over is that of the
/// voxel met first: rays from outside, away from edges. Its errors are counted.
fn check_approximate(traversal: Traversal) {
    let Some((device, mut tracer)) = tracer(traversal, Primitive::VoxelApprox) else { return };
    let (case, expected) = &expected()[1];
    let hits = cast(&mut tracer, &case.scene, &case.rays);
    // Random rays from outside.
    let wrong = (0..RAYS).step_by(8).filter(|&index| hits[index] != expected[index]).count();
    eprintln!("{}: {wrong} of {} rays wrong", traversal.name(), RAYS / 8);
    // Planted: the hits of other rays.
    let swapped = (0..RAYS).step_by(8).filter(|&index| hits[index] != expected[(index + 8) % RAYS]).count();
    assert!(swapped > RAYS / 16, "the comparison sees other hits: {swapped}");
    assert!((wrong as f64) < 0.05 * (RAYS / 8) as f64, "{wrong} rays wrong");
    drop(tracer);
    assert_valid(&device);
}

#[test]
fn queries_of_approximate_voxels_are_mostly_right_from_outside() {
    check_approximate(Traversal::Query);
}

#[test]
fn pipelines_of_approximate_voxels_are_mostly_right_from_outside() {
    check_approximate(Traversal::Pipeline);
}

/// A film of arbitrary values, so that one that was never written is noticed.
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

/// Pictures of four samples with both integrators, and what the CPU makes of them.
fn pictures() -> &'static [(Arc<PackedScene>, Frame, Film)] {
    static PICTURES: OnceLock<Vec<(Arc<PackedScene>, Frame, Film)>> = OnceLock::new();
    PICTURES.get_or_init(|| {
        let picture = |scene: &Scene, integrator| {
            let packed = Arc::new(PackedScene::pack(scene).unwrap());
            let frame = rooms::frame(scene, (67, 41), 4, integrator).aovs(true);
            let mut cpu = CpuTracer::new(None);
            cpu.set_scene(&packed).unwrap();
            let film = render(&mut cpu, &frame);
            assert!(film.pixels.iter().any(|pixel| pixel.radiance[0] > 0), "the picture is not black");
            (packed, frame, film)
        };
        let scenes = [rooms::lamp_room(), rooms::open_plain()];
        let both = |scene| [Integrator::Essay, Integrator::Path].map(|integrator| picture(scene, integrator));
        scenes.iter().flat_map(both).collect()
    })
}

/// Four-sample pictures equal the CPU's bit for bit.
fn check_pictures(traversal: Traversal, primitive: Primitive) {
    let Some((device, mut tracer)) = tracer(traversal, primitive) else { return };
    let pictures = pictures();
    for (index, (scene, frame, expected)) in pictures.iter().enumerate() {
        tracer.set_scene(scene).unwrap();
        let film = render(&mut tracer, frame);
        assert!(film == *expected, "{} {:?}", scene.name, frame.integrator);
        // A swapped picture, a stale film, and a film that nobody read are all seen.
        assert!(film != pictures[(index + 1) % pictures.len()].2, "the comparison sees another picture");
        assert!(poisoned() != *expected, "the comparison sees a film that nobody wrote");
    }
    let (_, frame, stale) = pictures.last().unwrap();
    let other = render(&mut tracer, &frame.clone().seed(2));
    assert!(other != *stale, "a new seed gives a new film");
    drop(tracer);
    assert_valid(&device);
}

#[test]
fn the_compute_walk_renders_the_pictures_of_the_cpu() {
    check_pictures(Traversal::Walk, Primitive::default());
}

#[test]
fn queries_render_the_pictures_of_the_cpu() {
    for primitive in [Primitive::VoxelExact, Primitive::Brick, Primitive::Grid] {
        check_pictures(Traversal::Query, primitive);
    }
}

#[test]
fn pipelines_render_the_pictures_of_the_cpu() {
    for primitive in [Primitive::VoxelExact, Primitive::Brick, Primitive::Grid] {
        check_pictures(Traversal::Pipeline, primitive);
    }
}

#[test]
fn however_often_a_device_is_interrupted_its_pixels_are_at_most_one_round_apart() {
    let Some((device, mut tracer)) = tracer(Traversal::Walk, Primitive::default()) else { return };
    let scene = rooms::lamp_room();
    tracer.set_scene(&Arc::new(PackedScene::pack(&scene).unwrap())).unwrap();
    // More pixels than a submit of a slow device takes, so that rounds are broken off and each is of one sample.
    let frame = rooms::frame(&scene, (1024, 768), 1000, Integrator::Essay);
    let mut film = poisoned();
    for _ in 0..6 {
        let progress = Progress::default();
        std::thread::scope(|scope| {
            scope.spawn(|| {
                while progress.samples_done() == 0 {
                    std::thread::yield_now();
                }
                progress.cancel();
            });
            tracer.render(&frame, &progress).unwrap();
        });
        tracer.read(&mut film).unwrap();
        let (least, most) = film.sample_range();
        let is_quick = least > 8;
        assert!(is_quick || most - least <= 1, "{least} to {most}");
    }
    // A call for as many samples as the pixels ahead have evens them out.
    let even = frame.samples(film.sample_range().1.max(1));
    let film = render(&mut tracer, &even);
    assert_eq!(film.sample_range(), (even.samples, even.samples));
    drop(tracer);
    assert_valid(&device);
}

#[test]
fn a_film_of_another_frame_takes_the_place_of_the_one_before() {
    let Some((device, mut tracer)) = tracer(Traversal::Walk, Primitive::default()) else { return };
    let scene = rooms::lamp_room();
    tracer.set_scene(&Arc::new(PackedScene::pack(&scene).unwrap())).unwrap();
    let frame = rooms::frame(&scene, (256, 256), 1, Integrator::Essay);
    tracer.render(&frame, &Progress::default()).unwrap();
    let one = tracer.memory();
    assert!(one.bytes("film") > 1 << 20 && one.peak_bytes >= one.total_bytes());
    for seed in [77, 78] {
        tracer.render(&frame.clone().seed(seed), &Progress::default()).unwrap();
        assert_eq!(tracer.memory().peak_bytes, one.peak_bytes, "two films were there at once");
    }
    drop(tracer);
    assert_valid(&device);
}
