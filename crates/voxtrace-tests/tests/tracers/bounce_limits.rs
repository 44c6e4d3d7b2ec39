//! Limits of bounces by kind against closed forms, and the clamp of indirect light; the same films from every tracer.

use std::sync::Arc;
use voxtrace::camera::Lens;
use voxtrace::film::Pixel;
use voxtrace::glam::{IVec3, Vec3};
use voxtrace::grid::VoxelBox;
use voxtrace::output::{FilmFile, SceneStamp};
use voxtrace::{
    BounceLimits, Camera, CpuTracer, Frame, Integrator, Material, PackedScene, Progress, Scene, Sky, Sun, TraceError,
    Tracer, VoxelGrid,
};
use voxtrace_tests::estimate::{radiance, render};
use voxtrace_tests::gpu::{Method, ONE_OF_EACH, assert_valid, device, film, film_methods, for_each_tracer};
use voxtrace_tests::rooms::{lamp_room, shell};

const ALL: BounceLimits = BounceLimits { diffuse: 255, glossy: 255, transmitted: 255, volume: 255 };

/// Checks a picture's mean radiance against a value, within a hundredth; and that it is not the value a twentieth beside it.
fn check(scene: &Scene, frame: &Frame, expected: f64) {
    let mean = radiance(scene, frame, 1)[0].mean;
    let is = |expected: f64| (mean - expected).abs() <= 0.01 * expected.max(0.01);
    assert!(is(expected), "{mean}, not {expected}, {:?}", frame.bounce_limits);
    assert!(!is(expected * 1.05 + 0.001), "the comparison sees another value");
}

/// The inside of a closed box of walls that glow.
fn furnace(wall: Material) -> (Scene, Frame) {
    let scene = Scene { sky: Sky::black(), ..Scene::from_grid("furnace", shell(IVec3::splat(8), |_| 0), vec![wall]) };
    let camera = Camera::look_at(Vec3::splat(4.1), Vec3::new(8.0, 4.7, 3.6));
    (scene, Frame::new(camera, 12, 12).samples(16).max_bounces(8))
}

#[test]
fn a_furnace_shows_as_many_bounces_as_its_kind_may_have() {
    // L = E (1 + r + … + rⁿ) after n bounces.
    let sum = |r: f64, n: i32| (0..=n).map(|k| r.powi(k)).sum::<f64>();
    let (matte, frame) = furnace(Material { emission: Vec3::ONE, ..Material::diffuse(Vec3::splat(0.6)) });
    for diffuse in [0, 1, 3] {
        let limits = BounceLimits { diffuse, glossy: 0, transmitted: 0, volume: 0 };
        check(&matte, &frame.clone().bounce_limits(limits), sum(0.6, diffuse.into()));
    }
    check(&matte, &frame.clone().bounce_limits(BounceLimits { glossy: 0, ..ALL }), sum(0.6, 8));
    // The smaller of the limit of a kind and that of all counts.
    check(&matte, &frame.clone().max_bounces(2).bounce_limits(BounceLimits { diffuse: 5, ..ALL }), sum(0.6, 2));

    let (mirrors, frame) = furnace(Material { emission: Vec3::ONE, ..Material::metal(Vec3::ONE, 0.0) });
    for glossy in [0, 1, 2] {
        let limits = BounceLimits { glossy, diffuse: 0, ..ALL };
        check(&mirrors, &frame.clone().bounce_limits(limits), f64::from(glossy) + 1.0);
    }
}

/// A wide slab of 8 voxels, three voxels above a ground that glows, looked at from straight above.
fn slab(material: Material) -> (Scene, Frame) {
    let mut grid = VoxelGrid::new();
    let layer = |bottom, top| VoxelBox { min: IVec3::new(-90, -90, bottom), max: IVec3::new(90, 90, top) };
    grid.fill_box(layer(-8, 0), 0);
    grid.fill_box(layer(-12, -11), 1);
    let ground = Material { emission: Vec3::ONE, ..Material::diffuse(Vec3::ZERO) };
    let scene = Scene { sky: Sky::black(), ..Scene::from_grid("slab", grid, vec![material, ground]) };
    let camera = Camera::look_at(Vec3::new(0.2, 0.3, 10.0), Vec3::new(0.2, 0.3, 0.0));
    let camera = camera.with_lens(Lens::Orthographic { view_height: 4.0 });
    (scene, Frame::new(camera, 8, 8).samples(64).max_bounces(60))
}

#[test]
fn a_pane_shows_as_many_refractions_and_reflections_as_it_may() {
    let (scene, frame) = slab(Material::glass(1.5, 0.0));
    let (surface, limited) = (0.04_f64, |limits| frame.clone().bounce_limits(limits));
    // In and out again; once more from within needs two reflections.
    let through = (1.0 - surface).powi(2);
    check(&scene, &limited(BounceLimits { transmitted: 1, ..ALL }), 0.0);
    check(&scene, &limited(BounceLimits { transmitted: 2, glossy: 0, ..ALL }), through);
    check(&scene, &limited(BounceLimits { transmitted: 2, glossy: 2, ..ALL }), through * (1.0 + surface * surface));
    // A sky above, and a ground that is black: what the upper face reflects alone.
    let mut under_sky = scene.clone();
    under_sky.sky = Sky::uniform(Vec3::ONE);
    under_sky.materials[1].emission = Vec3::ZERO;
    check(&under_sky, &limited(BounceLimits { transmitted: 0, ..ALL }), surface);
    check(&under_sky, &limited(BounceLimits { transmitted: 0, glossy: 0, ..ALL }), 0.0);
}

#[test]
fn a_cloud_without_bounces_lets_through_what_it_does_not_scatter() {
    let (scene, frame) = slab(Material::cloud(Vec3::ONE, 0.2, 0.0));
    let limited = |limits| frame.clone().samples(256).bounce_limits(limits);
    let unscattered = (-0.2 * 8.0_f64).exp();
    check(&scene, &limited(BounceLimits { volume: 0, ..ALL }), unscattered);
    let once = radiance(&scene, &limited(BounceLimits { volume: 1, ..ALL }), 1)[0].mean;
    let all = radiance(&scene, &limited(ALL), 1)[0].mean;
    assert!(once > 1.1 * unscattered && all > 1.1 * once, "{unscattered} {once} {all}");
}

/// Things of every kind of bounce, a lamp and a sun.
fn still_life() -> Scene {
    let mut grid = VoxelGrid::new();
    let mut fill = |min: [i32; 3], max: [i32; 3], material| {
        grid.fill_box(VoxelBox { min: IVec3::from(min), max: IVec3::from(max) }, material);
    };
    fill([-12, -12, -1], [12, 12, 0], 0);
    fill([-10, 4, 0], [0, 8, 5], 1);
    fill([2, 5, 0], [5, 8, 4], 2);
    fill([-9, -8, 0], [-1, 0, 5], 3);
    fill([6, -9, 1], [11, -2, 6], 4);
    fill([4, 0, 6], [5, 1, 7], 5);
    let materials = vec![
        Material::diffuse(Vec3::new(0.6, 0.5, 0.4)),
        Material::metal(Vec3::new(0.9, 0.7, 0.3), 0.4),
        Material::plastic(Vec3::new(0.8, 0.1, 0.1), 0.0),
        Material::glass(1.5, 0.2).tinted(Vec3::new(0.4, 0.9, 0.6), 4.0),
        // It glows, too.
        Material {
            emission: Vec3::new(0.3, 0.2, 0.1),
            absorption: Vec3::new(0.1, 0.0, 0.4),
            ..Material::cloud(Vec3::new(0.95, 0.9, 0.8), 0.4, 0.6)
        },
        Material::emissive(Vec3::new(90.0, 80.0, 60.0)),
    ];
    let direction = Vec3::new(0.4, -0.3, 0.8).normalize();
    let sun = Sun { direction, angular_radius: 0.05, irradiance: Vec3::splat(2.0) };
    let sky = Sky::gradient(Vec3::new(0.2, 0.15, 0.1), Vec3::new(0.4, 0.6, 0.9)).with_sun(sun);
    let mut scene = Scene { sky, ..Scene::from_grid("still life", grid, materials) };
    scene.cameras.push(Camera::look_at(Vec3::new(3.0, -26.0, 17.0), Vec3::new(0.0, 0.0, 1.0)));
    scene
}

fn frame_of(scene: &Scene) -> Frame {
    Frame::new(scene.cameras[0].clone(), 32, 24).samples(4).max_bounces(6)
}

fn pixels(scene: &Scene, frame: &Frame) -> Vec<Pixel> {
    render(&Arc::new(PackedScene::pack(scene).unwrap()), frame).pixels
}

#[test]
fn limits_that_are_not_reached_change_no_bit() {
    for scene in [still_life(), lamp_room()] {
        let frame = frame_of(&scene);
        let expected = pixels(&scene, &frame);
        let large = BounceLimits { diffuse: 254, glossy: 254, transmitted: 254, volume: 254 };
        assert!(pixels(&scene, &frame.clone().bounce_limits(large)) == expected);
        assert!(pixels(&scene, &frame.clone().clamp_indirect(1e30)) == expected);
        let one = BounceLimits { diffuse: 1, ..ALL };
        assert!(pixels(&scene, &frame.clone().bounce_limits(one)) != expected, "the comparison sees a limit");
        assert!(pixels(&scene, &frame.clone().clamp_indirect(0.1)) != expected, "the comparison sees a clamp");
    }
}

#[test]
fn the_clamp_leaves_direct_light_alone_and_makes_nothing_brighter() {
    let scene = lamp_room();
    let frame = frame_of(&scene);
    let clamped = |frame: &Frame| pixels(&scene, &frame.clone().clamp_indirect(1e-4));
    // One bounce: what lamps send to the surfaces that are seen.
    let direct = pixels(&scene, &frame.clone().max_bounces(1));
    assert!(clamped(&frame.clone().max_bounces(1)) == direct);
    let (all, least) = (pixels(&scene, &frame), clamped(&frame));
    let brightness = |pixels: &[Pixel]| pixels.iter().map(|pixel| f64::from(pixel.mean().x)).sum::<f64>();
    assert!(brightness(&all) > 1.1 * brightness(&direct), "there is indirect light");
    // At most 1e-4 for each of the light chosen and the light met at five further bounces.
    for ((all, least), direct) in all.iter().zip(&least).zip(&direct) {
        let (all, least, direct) = (all.mean(), least.mean(), direct.mean());
        assert!(least.cmple(all + 1e-6).all(), "{least} {all}");
        assert!((least - direct).abs().max_element() <= 1.1e-3, "{least} {direct}");
    }
}

#[test]
fn lamps_in_mirrors_and_behind_glass_are_direct_light() {
    let mut scene = still_life();
    scene.materials[0] = Material::metal(Vec3::splat(0.9), 0.0);
    scene.materials[1] = Material::metal(Vec3::splat(0.8), 0.0);
    scene.materials[2] = Material::glass(1.5, 0.0);
    scene.materials[3] = Material::glass(1.3, 0.0);
    scene.materials[4] = Material::glass(1.0, 0.0);
    let frame = frame_of(&scene);
    assert!(pixels(&scene, &frame.clone().clamp_indirect(1e-3)) == pixels(&scene, &frame));
    scene.materials[0] = Material::metal(Vec3::splat(0.9), 0.5);
    assert!(pixels(&scene, &frame.clone().clamp_indirect(1e-3)) != pixels(&scene, &frame));
}

/// Compares the films of a scene by some methods, of a software device by the `few`, with those of the processor.
fn compare_films(scene: &Scene, few: &[Method]) {
    let limits = BounceLimits { diffuse: 2, glossy: 1, transmitted: 3, volume: 2 };
    let frame = frame_of(scene);
    let frames = [frame.clone().bounce_limits(limits), frame.clone().bounce_limits(limits).clamp_indirect(0.5), frame];
    let packed = Arc::new(PackedScene::pack(scene).unwrap());
    let mut cpu = CpuTracer::new(None);
    cpu.set_scene(&packed).unwrap();
    let expected = frames.each_ref().map(|frame| film(&mut cpu, frame));
    assert!(expected[0].pixels != expected[1].pixels && expected[1].pixels != expected[2].pixels);
    let Some(device) = device() else { return };
    for_each_tracer(&device, &film_methods(&device, few), &packed, |tracer, traversal, _| {
        for (index, (frame, expected)) in frames.iter().zip(&expected).enumerate() {
            let found = film(tracer, frame);
            let differ = found.pixels.iter().zip(&expected.pixels).filter(|(a, b)| a != b).count();
            assert_eq!(differ, 0, "pixels of frame {index} of {} by {traversal:?}", scene.name);
        }
    });
    assert_valid(&device);
}

#[test]
fn every_tracer_limits_and_clamps_to_the_same_bits() {
    compare_films(&still_life(), &ONE_OF_EACH);
}

// Matte scenes have modules of their own, and others where light is clamped.
#[test]
fn every_tracer_limits_and_clamps_matte_scenes_to_the_same_bits() {
    compare_films(&lamp_room(), &ONE_OF_EACH[..1]);
}

#[test]
fn films_know_their_limits_and_the_study_s_integrator_has_none() {
    let scene = lamp_room();
    let packed = Arc::new(PackedScene::pack(&scene).unwrap());
    let usual = frame_of(&scene).samples(1);
    let limits = BounceLimits { diffuse: 2, glossy: 1, ..ALL };
    let frame = usual.clone().bounce_limits(limits).clamp_indirect(0.5);
    let file = |frame: &Frame| {
        let (film, frame) = (render(&packed, frame), frame.clone());
        FilmFile { film, frame, scene: SceneStamp::of(&packed) }
    };
    let (limited, unlimited) = (file(&frame), file(&usual));
    assert_eq!(FilmFile::from_bytes(&limited.to_bytes()).unwrap(), limited);
    assert_eq!(limited.to_bytes().len(), unlimited.to_bytes().len() + 12);
    let difference = |other: &Frame| limited.difference(other, &limited.scene).unwrap();
    assert_eq!(difference(&usual), "bounces by kind 2,1,-,- in the film, -,-,-,- asked for");
    let otherwise = frame.clone().clamp_indirect(2.0);
    assert_eq!(difference(&otherwise), "clamp of indirect light 0.5 in the film, 2 asked for");
    assert_eq!(limited.difference(&frame, &limited.scene), None);

    let mut tracer = CpuTracer::new(None);
    tracer.set_scene(&packed).unwrap();
    for wrong in [frame.integrator(Integrator::Essay), usual.clone().clamp_indirect(0.0)] {
        assert!(matches!(tracer.render(&wrong, &Progress::default()), Err(TraceError::BadFrame(_))));
    }
    tracer.render(&usual.integrator(Integrator::Essay), &Progress::default()).unwrap();
}
