//! Light that passes clear glass straight: closed forms, the same light by both techniques, and the same films from every tracer.

use std::sync::Arc;
use voxtrace::camera::Lens;
use voxtrace::glam::{IVec3, Mat3, Vec3};
use voxtrace::grid::VoxelBox;
use voxtrace::output::{FilmFile, SceneStamp};
use voxtrace::sky::{Background, Environment};
use voxtrace::{
    BounceLimits, Camera, CpuTracer, Film, Frame, Integrator, Material, PackedScene, Scene, Sky, Sun, Tracer,
    Transform, VoxelGrid,
};
use voxtrace_tests::environments::even_map;
use voxtrace_tests::estimate::{radiance, render};
use voxtrace_tests::gpu::{ONE_OF_EACH, assert_valid, device, film, film_methods, for_each_tracer};

const IOR: f32 = 1.5;

fn fill(grid: &mut VoxelGrid, min: [i32; 3], max: [i32; 3], material: u16) {
    grid.fill_box(VoxelBox { min: IVec3::from(min), max: IVec3::from(max) }, material);
}

/// Reflectance of the floor.
const FLOOR: f64 = 0.5;

/// A wide floor under a pane so many voxels thick, seen from between the two. No light is reflected or refracted by the pane on its way to the camera.
fn under_a_pane(pane: Material, thickness: i32, sky: Sky) -> (Scene, Frame) {
    let mut grid = VoxelGrid::new();
    fill(&mut grid, [-120, -120, -1], [120, 120, 0], 0);
    fill(&mut grid, [-120, -120, 2], [120, 120, 2 + thickness], 1);
    let floor = Material::diffuse(Vec3::splat(FLOOR as f32));
    let scene = Scene { sky, ..Scene::from_grid("pane", grid, vec![floor, pane]) };
    let camera = Camera::look_at(Vec3::new(0.3, 0.2, 1.5), Vec3::new(0.3, 0.2, 0.0));
    let camera = camera.with_lens(Lens::Orthographic { view_height: 4.0 });
    let limits = BounceLimits { diffuse: 1, glossy: 0, transmitted: 0, ..BounceLimits::default() };
    (scene, Frame::new(camera, 8, 8).samples(16).bounce_limits(limits).clear_shadows(true))
}

/// A black sky with a small sun straight above.
fn sun() -> Sky {
    let sun = Sun { direction: Vec3::Z, angular_radius: 0.01, irradiance: Vec3::splat(3.0) };
    Sky::uniform(Vec3::ZERO).with_sun(sun)
}

/// What a boundary lets pass, by Fresnel's equations in double precision.
fn passed(cos: f64) -> f64 {
    let n = f64::from(IOR);
    let cos_t = (1.0 - (1.0 - cos * cos) / (n * n)).sqrt();
    let parallel = (n * cos - cos_t) / (n * cos + cos_t);
    let perpendicular = (cos - n * cos_t) / (cos + n * cos_t);
    1.0 - (parallel * parallel + perpendicular * perpendicular) / 2.0
}

#[test]
fn a_pane_takes_from_the_sun_what_its_faces_reflect_and_its_inside_absorbs() {
    let (bare, face) = (3.0 * FLOOR / std::f64::consts::PI, passed(1.0));
    let tint = Material::glass(IOR, 0.0).tinted(Vec3::splat(0.5), 4.0);
    for (pane, thickness, expected) in [
        (Material::glass(IOR, 0.0), 3, bare * face * face),
        (tint, 8, bare * face * face * 0.25),
        (Material { metallic: 0.25, ..Material::glass(IOR, 0.0) }, 3, bare * face * face * 0.75),
    ] {
        let (scene, frame) = under_a_pane(pane, thickness, sun());
        let found = radiance(&scene, &frame, 1)[0].mean;
        assert!((found - expected).abs() < 0.002 * expected, "{found} {expected}");
        let fault = expected / face;
        assert!((found - fault).abs() > 0.01 * expected, "the comparison sees a face that reflects nothing");
        let blocked = radiance(&scene, &frame.clone().clear_shadows(false), 1)[0].mean;
        assert_eq!(blocked, 0.0, "without the option glass is in the way");
    }
    let (scene, frame) = under_a_pane(Material::glass(IOR, 0.5), 3, sun());
    assert_eq!(radiance(&scene, &frame, 1)[0].mean, 0.0, "rough glass is not clear");
}

#[test]
fn light_through_a_pane_is_the_same_by_chance_and_by_choice() {
    // Of each direction of a white sky the floor gets what two faces let pass. Directions of a map are chosen, those of a gradient are met.
    const STEPS: u32 = 20_000;
    let sum = |power: i32| -> f64 {
        let at = |step: u32| (f64::from(step) + 0.5) / f64::from(STEPS);
        // Of the squared cosine, so that each step has the same share of a matte surface's light.
        (0..STEPS).map(|step| passed(at(step).sqrt()).powi(power)).sum::<f64>() / f64::from(STEPS) * FLOOR
    };
    let (expected, fault) = (sum(2), sum(1));
    let map = Sky::new(Background::Environment(Environment::new(even_map(16, Vec3::ONE), 0.0)));
    for sky in [Sky::uniform(Vec3::ONE), map] {
        let (scene, frame) = under_a_pane(Material::glass(IOR, 0.0), 3, sky);
        let found = radiance(&scene, &frame.samples(64), 1)[0];
        let tolerance = 5.0 * found.standard_error + 0.003 * expected;
        assert!((found.mean - expected).abs() < tolerance, "{found:?} {expected}");
        assert!((found.mean - fault).abs() > tolerance, "the comparison sees a face that reflects nothing: {fault}");
    }
}

/// A floor with panes, a block of tinted glass, a metal and a lamp, some of it turned.
fn still_life() -> Scene {
    let mut grid = VoxelGrid::new();
    fill(&mut grid, [-12, -12, -1], [12, 12, 0], 0);
    fill(&mut grid, [-8, -8, 5], [8, 8, 6], 1);
    fill(&mut grid, [-4, 2, 0], [2, 6, 4], 2);
    fill(&mut grid, [4, -4, 0], [7, -1, 4], 3);
    fill(&mut grid, [-3, -3, 9], [1, 1, 10], 4);
    fill(&mut grid, [8, 4, 0], [11, 7, 3], 5);
    let materials = vec![
        Material::diffuse(Vec3::new(0.7, 0.6, 0.5)),
        Material::glass(IOR, 0.0),
        Material::glass(1.33, 0.0).tinted(Vec3::new(0.3, 0.8, 0.6), 4.0),
        Material { transmission: 0.5, ..Material::metal(Vec3::new(0.9, 0.7, 0.3), 0.3) },
        Material::emissive(Vec3::new(6.0, 5.0, 4.0)),
        Material { metallic: 0.3, ..Material::glass(1.8, 0.0) },
    ];
    let sun = Sun { direction: Vec3::new(0.3, -0.4, 0.8).normalize(), angular_radius: 0.03, irradiance: Vec3::ONE };
    let sky = Sky::gradient(Vec3::splat(0.1), Vec3::new(0.3, 0.4, 0.6)).with_sun(sun);
    let mut scene = Scene { sky, ..Scene::from_grid("panes", grid, materials) };
    let mut lump = VoxelGrid::new();
    fill(&mut lump, [0, 0, 0], [4, 4, 3], 2);
    let turned = Transform { linear: Mat3::from_rotation_z(0.6), translation: Vec3::new(-9.0, -9.0, 0.1) };
    scene.add_instance(lump, turned);
    scene
}

#[test]
fn every_tracer_makes_the_same_film_of_clear_shadows() {
    let packed = Arc::new(PackedScene::pack(&still_life()).unwrap());
    let camera = Camera::look_at(Vec3::new(6.0, -26.0, 17.0), Vec3::new(0.0, 0.0, 2.0));
    let clear = Frame::new(camera, 32, 24).samples(2).max_bounces(6).clear_shadows(true);
    let frames = [clear.clone(), clear.clone().clear_shadows(false)];
    let mut cpu = CpuTracer::new(None);
    cpu.set_scene(&packed).unwrap();
    let expected: Vec<Film> = frames.iter().map(|frame| film(&mut cpu, frame)).collect();
    let differ = expected[0].pixels.iter().zip(&expected[1].pixels).filter(|(a, b)| a != b).count();
    assert!(differ > 100, "the comparison sees the option: {differ}");
    let Some(device) = device() else { return };
    for_each_tracer(&device, &film_methods(&device, &ONE_OF_EACH), &packed, |tracer, traversal, primitive| {
        for (frame, expected) in frames.iter().zip(&expected) {
            let found = film(tracer, frame);
            let differ = found.pixels.iter().zip(&expected.pixels).filter(|(a, b)| a != b).count();
            assert_eq!(differ, 0, "{traversal:?} {primitive:?}, clear: {}", frame.clear_shadows);
        }
    });
    assert_valid(&device);
}

#[test]
fn films_know_that_shadows_were_clear_and_the_study_s_integrator_has_none() {
    let (scene, clear) = under_a_pane(Material::glass(IOR, 0.0), 2, sun());
    let packed = Arc::new(PackedScene::pack(&scene).unwrap());
    let file = |frame: &Frame| {
        let (film, frame) = (render(&packed, frame), frame.clone());
        FilmFile { film, frame, scene: SceneStamp::of(&packed) }
    };
    let kept = file(&clear);
    assert_eq!(FilmFile::from_bytes(&kept.to_bytes()).unwrap(), kept);
    let usual = clear.clone().clear_shadows(false);
    assert_eq!(file(&usual).to_bytes().len(), kept.to_bytes().len());
    let difference = kept.difference(&usual, &kept.scene).unwrap();
    assert_eq!(difference, "clear shadows true in the film, false asked for");
    assert!(clear.integrator(Integrator::Essay).check().is_err());
}
