//! Scenes larger than the memory that they may take on a device: films and hits are those of the whole scene, bit for bit, however little of it
//! is there at a time.

use std::sync::Arc;
use voxtrace::glam::{IVec3, Mat3, Vec3};
use voxtrace::meanwhile::Meanwhile;
use voxtrace::packed::{LevelCount, Levels};
use voxtrace::{
    Camera, CpuTracer, Film, Frame, Hit, Instance, Integrator, Material, PackedScene, Progress, Region, Scene,
    TraceError, Tracer, Transform, VoxelGrid,
};
use voxtrace_tests::gpu::{assert_valid, compare_hits, device, film, wanted};
use voxtrace_tests::random::Random;
use voxtrace_tests::rays::mixed;
use voxtrace_vulkan::{Device, Options, Primitive, Settings, Traversal, VulkanTracer};

/// Voxels along the edges of the hills.
const EDGE: i32 = 1000;

/// Hills of many materials, with lamps on them, and a small turned copy of them above: some 5 MB of voxels.
fn hills() -> Scene {
    let materials = (0..40).map(|i| match i {
        0 => Material::emissive(Vec3::new(40.0, 30.0, 20.0)),
        i => Material::diffuse(Vec3::new(0.2 + 0.015 * i as f32, 0.8 - 0.01 * i as f32, 0.4)),
    });
    let mut grid = VoxelGrid::new();
    let mut random = Random(3);
    for y in 0..EDGE {
        for x in 0..EDGE {
            let height = 30.0 * (x as f32 * 0.021).sin() * (y as f32 * 0.017).cos() + 6.0 * (x as f32 * 0.1).cos();
            for depth in 0..3 {
                grid.set(IVec3::new(x, y, height as i32 - depth), 1 + random.below(39) as u16);
            }
            if x % 47 == 5 && y % 53 == 9 {
                grid.set(IVec3::new(x, y, height as i32 + 4), 0);
            }
        }
    }
    let mut scene = Scene::from_grid("hills", grid, materials.collect());
    let linear = Mat3::from_axis_angle(Vec3::new(0.3, 0.5, 0.8).normalize(), 0.7) * 0.2;
    scene.instances.push(Instance::new(0, Transform { linear, translation: Vec3::new(300.0, 300.0, 60.0) }));
    scene
}

fn frame() -> Frame {
    let camera = Camera::look_at(Vec3::new(-60.0, -40.0, 160.0), Vec3::new(350.0, 350.0, 0.0));
    Frame::new(camera, 64, 36).samples(3).aovs(true).integrator(Integrator::Path)
}

/// A tracer that may take so many bytes beside what it takes without a scene.
fn tracer_in(traversal: Traversal, budget: u64) -> Option<VulkanTracer> {
    let settings = Settings { traversal, primitive: Primitive::Grid, is_exact: true };
    let options = Options { validation: true, ..Options::default() };
    let open = |budget| Device::open(options.clone(), Some(&wanted()?), budget).ok();
    let idle = VulkanTracer::new(open(None)?, settings).ok()?.memory().total_bytes();
    VulkanTracer::new(open(Some(idle + budget))?, settings).ok()
}

#[test]
fn a_scene_in_pages_gives_the_film_and_the_hits_of_the_whole_scene() {
    let Some(device) = device() else { return };
    let scene = hills();
    let rays = mixed(&scene.grids[0], 20_000, 7);
    let scene = Arc::new(PackedScene::pack(&scene).unwrap());
    let mut cpu = CpuTracer::new(None);
    cpu.set_scene(&scene).unwrap();
    let expected = film(&mut cpu, &frame());
    let mut expected_hits = vec![Hit::MISS; rays.len()];
    cpu.cast_into(&rays, &mut expected_hits).unwrap();

    let geometry = scene.geometry();
    let words = geometry.cells().len() + geometry.bricks().len() + geometry.brick_materials().len();
    let words = words + (size_of_val(geometry.emitters()) + size_of_val(geometry.light_nodes())) / 4;
    // A quarter of it, and two thirds; a quarter of what there is is left to films.
    for (part, of) in [(1, 4), (2, 3)] {
        let budget = (4 * words * part / of * 4 / 3) as u64;
        let mut tracer = tracer_in(Traversal::Walk, budget).unwrap();
        tracer.set_scene(&scene).unwrap();
        assert_eq!(tracer.paged(), Some((0, 0)));
        let ours = film(&mut tracer, &frame());
        assert!(ours.pixels == expected.pixels && ours.aovs == expected.aovs, "{part} of {of}");
        let (loaded, rounds) = tracer.paged().unwrap();
        assert!(loaded > budget / 3 && rounds > 3, "{loaded} bytes of pages came in {rounds} rounds");
        let mut hits = vec![Hit::MISS; rays.len()];
        tracer.cast_into(&rays, &mut hits).unwrap();
        compare_hits(&rays, &hits, &expected_hits).unwrap();
        let held = tracer.memory().entries.iter().find(|(name, _)| name.contains("pages")).map(|(_, bytes)| *bytes);
        assert!(held.is_some_and(|bytes| bytes <= budget), "{held:?} of {budget}");
        // A film that is broken off goes on.
        let progress = Progress::default();
        progress.cancel();
        let other = frame().seed(9);
        tracer.render(&other, &progress).unwrap();
        assert!(film(&mut tracer, &other).pixels == film(&mut cpu, &other).pixels);
        assert!(film(&mut cpu, &frame()) == expected);
    }
    // Pages that come with nothing in them are seen.
    let mut tracer = tracer_in(Traversal::Walk, (4 * words / 2) as u64).unwrap();
    tracer.set_scene(&scene).unwrap();
    tracer.empty_pages(9);
    assert!(film(&mut tracer, &frame()).pixels != expected.pixels);
    drop(tracer);
    assert_valid(&device);
}

#[test]
fn what_rays_came_to_is_not_marked_for_those_that_follow() {
    let Some(device) = device() else { return };
    let scene = hills();
    let rays = mixed(&scene.grids[0], 500, 7);
    let scene = Arc::new(PackedScene::pack(&scene).unwrap());
    let mut tracer = tracer_in(Traversal::Walk, 2 << 20).unwrap();
    tracer.set_scene(&scene).unwrap();
    let mut hits = vec![Hit::MISS; rays.len()];
    tracer.cast_into(&rays, &mut hits).unwrap();
    assert!(tracer.paged().is_some_and(|(bytes, _)| bytes > 0));
    assert_eq!(tracer.marked_pages().unwrap(), 0, "pages that nothing needs any more would stay");
    drop(tracer);
    assert_valid(&device);
}

#[test]
fn pixels_show_a_coarser_level_until_their_pages_are_there() {
    let Some(device) = device() else { return };
    let scene = Arc::new(PackedScene::pack(&hills()).unwrap());
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("hills.vxt");
    scene.save_with_levels(&path, LevelCount::Some(3), &mut |_| true).unwrap();
    let level = Arc::new(Levels::open(&path).unwrap().scene(3).unwrap());
    let expected = {
        let mut cpu = CpuTracer::new(None);
        cpu.set_scene(&scene).unwrap();
        film(&mut cpu, &frame())
    };
    let of_level = {
        let mut cpu = CpuTracer::new(None);
        cpu.set_scene(&level).unwrap();
        film(&mut cpu, &frame().samples(1))
    };
    assert!(of_level.pixels != expected.pixels);
    let fine = tracer_in(Traversal::Walk, 2 << 20).unwrap();
    let mut tracer = Meanwhile::new(fine, tracer_in(Traversal::Walk, 1 << 30).unwrap());
    tracer.set_scenes(&scene, &level).unwrap();
    assert!(tracer.tracer().paged().is_some());
    let read = |tracer: &mut Meanwhile<VulkanTracer, VulkanTracer>| {
        let mut film = Film::new(1, 1, Region::full(1, 1), 0);
        tracer.read(&mut film).unwrap();
        film
    };
    // Nothing is there.
    let stopped = Progress::default();
    stopped.cancel();
    tracer.render(&frame(), &stopped).unwrap();
    assert!(read(&mut tracer).pixels == of_level.pixels);
    // Something is there: each pixel is of the scene or of the level.
    let some = Progress::default();
    std::thread::scope(|scope| {
        scope.spawn(|| {
            while some.samples_done() == 0 {
                std::thread::sleep(std::time::Duration::from_millis(1));
            }
            some.cancel();
        });
        tracer.render(&frame(), &some).unwrap();
    });
    let mut alone = CpuTracer::new(None);
    alone.set_scene(&scene).unwrap();
    let films: Vec<Film> = (1..=3).map(|samples| film(&mut alone, &frame().samples(samples))).collect();
    let (mut of_scene, mut coarse) = (0, 0);
    for (index, pixel) in read(&mut tracer).pixels.iter().enumerate() {
        match films.iter().any(|film| film.pixels[index] == *pixel) {
            true => of_scene += 1,
            false if of_level.pixels[index] == *pixel => coarse += 1,
            false => panic!("pixel {index} is of neither"),
        }
    }
    assert!(of_scene > 0, "{of_scene} of the scene, {coarse} of the level");
    // All is there.
    tracer.render(&frame(), &Progress::default()).unwrap();
    let whole = read(&mut tracer);
    assert!(whole.pixels == expected.pixels && whole.aovs == expected.aovs);
    // Another view begins with the level again, and a scene without one with nothing.
    let other = frame().seed(9);
    tracer.render(&other, &stopped).unwrap();
    assert!(read(&mut tracer).pixels.iter().all(|pixel| pixel.samples == 1));
    tracer.set_scene(&scene).unwrap();
    tracer.render(&other, &stopped).unwrap();
    assert!(read(&mut tracer).pixels.iter().all(|pixel| pixel.samples == 0), "the comparison sees what is missing");
    drop(tracer);
    assert_valid(&device);
}

#[test]
fn too_little_memory_is_said_with_what_it_takes() {
    let Some(device) = device() else { return };
    let scene = Arc::new(PackedScene::pack(&hills()).unwrap());
    let mut tracer = tracer_in(Traversal::Walk, 1 << 17).unwrap();
    let Err(TraceError::OutOfMemory { needed, available }) = tracer.set_scene(&scene) else {
        panic!("it does not fit")
    };
    assert!(available <= 1 << 17 && needed > available && needed < 1 << 20, "{needed} of {available}");
    // What it takes suffices.
    let mut tracer = tracer_in(Traversal::Walk, needed).unwrap();
    tracer.set_scene(&scene).unwrap();
    assert_eq!(tracer.paged(), Some((0, 0)));
    // Structures of ray tracing hardware must be whole.
    if let Some(mut tracer) = tracer_in(Traversal::Query, 1 << 20) {
        assert!(matches!(tracer.set_scene(&scene), Err(TraceError::OutOfMemory { .. })));
    }
    // Where it fits it is whole.
    let mut tracer = tracer_in(Traversal::Walk, 1 << 30).unwrap();
    tracer.set_scene(&scene).unwrap();
    assert_eq!(tracer.paged(), None);
    drop(tracer);
    assert_valid(&device);
}

#[test]
fn samples_of_a_render_in_pages_that_is_broken_off_are_told_once_and_a_scene_that_fits_is_whole_again() {
    let Some(device) = device() else { return };
    let scene = Arc::new(PackedScene::pack(&hills()).unwrap());
    let mut tracer = tracer_in(Traversal::Walk, 2 << 20).unwrap();
    tracer.set_scene(&scene).unwrap();
    assert!(tracer.paged().is_some());
    let frame = frame().aovs(false).integrator(Integrator::Essay);
    let (stopped, rest) = (Progress::default(), Progress::default());
    std::thread::scope(|scope| {
        let render = scope.spawn(|| tracer.render(&frame, &stopped));
        while stopped.samples_done() == 0 && !render.is_finished() {
            std::thread::yield_now();
        }
        stopped.cancel();
        render.join().unwrap().unwrap();
    });
    tracer.render(&frame, &rest).unwrap();
    let (first, second) = (stopped.samples_done(), rest.samples_done());
    assert_eq!(first + second, 64 * 36 * 3, "{first}, then {second}");
    // The table of pages is gone, and nothing is bound in its place that is gone, too.
    let small = voxtrace_tests::rooms::lamp_room();
    let frame = voxtrace_tests::rooms::frame(&small, (31, 17), 2, Integrator::Essay);
    let small = Arc::new(PackedScene::pack(&small).unwrap());
    tracer.set_scene(&small).unwrap();
    assert_eq!(tracer.paged(), None);
    let mut cpu = CpuTracer::new(None);
    cpu.set_scene(&small).unwrap();
    assert!(film(&mut tracer, &frame) == film(&mut cpu, &frame));
    assert_valid(tracer.device());
    assert_valid(&device);
}
