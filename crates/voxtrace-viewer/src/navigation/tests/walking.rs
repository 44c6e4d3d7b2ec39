//! Walking over a small landscape: floors, steps, walls, edges.

use crate::navigation::walking::{Ground, Walker, Wish};
use crate::navigation::{Movement, Navigator};
use voxtrace::cuts::Cuts;
use voxtrace::glam::{DVec2, DVec3, IVec3, Vec3};
use voxtrace::{Camera, Material, PackedScene, Scene, VoxelGrid};

/// A floor of 200 × 200, its top at z = 1; at x ≥ 120 three steps of 3 voxels, 10 apart; a wall at y = 150, and a roof over x < 40.
fn landscape() -> PackedScene {
    let mut grid = VoxelGrid::new();
    for x in 0..200 {
        for y in 0..200 {
            let top = 1 + 3 * ((x - 110) / 10).clamp(0, 3);
            (0..top).for_each(|z| _ = grid.set(IVec3::new(x, y, z), 0));
            if x < 40 {
                grid.set(IVec3::new(x, y, 24), 0);
            }
        }
        (0..40).for_each(|z| _ = grid.set(IVec3::new(x, 150, z), 0));
    }
    PackedScene::pack(&Scene::from_grid("landscape", grid, vec![Material::diffuse(Vec3::ONE)])).unwrap()
}

/// Somebody with an eye at 20 voxels who stands at a place and looks along +x.
fn standing(x: f32, y: f32, scene: &PackedScene) -> Navigator {
    let eye = Vec3::new(x, y, 22.0);
    let mut navigator = Navigator::new(Camera::look_at(eye, eye + Vec3::X), scene.bounds());
    navigator.walker.eye_height = 20.0;
    for _ in 0..60 {
        navigator.walk(0.02, scene);
    }
    assert!((navigator.camera().eye.z - 21.0).abs() < 1e-3, "he stands on the floor: {}", navigator.camera().eye);
    navigator
}

fn run(navigator: &mut Navigator, movement: Movement, seconds: f32, scene: &PackedScene) -> Vec3 {
    navigator.held.set(movement, true);
    for _ in 0..(seconds / 0.02).round() as usize {
        navigator.walk(0.02, scene);
    }
    navigator.held.set(movement, false);
    navigator.camera().eye
}

#[test]
fn who_falls_falls_by_the_law_of_falling_and_stands_then() {
    let scene = landscape();
    let mut navigator =
        Navigator::new(Camera::look_at(Vec3::new(80.0, 80.0, 101.0), Vec3::new(81.0, 80.0, 101.0)), scene.bounds());
    navigator.walker.eye_height = 20.0;
    // 80 voxels at 9.81 / 1.7 eye heights a second squared.
    let expected = (2.0f32 * 80.0 / (9.81 / 1.7 * 20.0)).sqrt();
    let mut time = 0.0;
    while navigator.camera().eye.z > 21.0 + 1e-3 {
        navigator.walk(0.005, &scene);
        time += 0.005;
        assert!(time < 10.0);
    }
    assert!((time - expected).abs() < 0.03, "{time} {expected}");
    assert!(!navigator.walk(0.1, &scene), "who stands is at rest: the picture goes on");
}

#[test]
fn steps_are_climbed_and_descended_and_what_is_too_high_stops() {
    let scene = landscape();
    let mut navigator = standing(100.0, 80.0, &scene);
    let eye = run(&mut navigator, Movement::Forward, 1.0, &scene);
    assert!(eye.x > 140.0 && eye.x < 146.0, "2.2 eye heights a second: {eye}");
    run(&mut navigator, Movement::TurnLeft, 0.0, &scene);
    for _ in 0..60 {
        navigator.walk(0.02, &scene);
    }
    assert!((navigator.camera().eye.z - 30.0).abs() < 0.05, "three steps up: {}", navigator.camera().eye);
    let eye = run(&mut navigator, Movement::Back, 1.0, &scene);
    assert!(eye.x < 104.0, "{eye}");
    for _ in 0..60 {
        navigator.walk(0.02, &scene);
    }
    assert!((navigator.camera().eye.z - 21.0).abs() < 0.05, "and down: {}", navigator.camera().eye);
    let mut small = standing(100.0, 80.0, &scene);
    small.walker.eye_height = 6.0;
    let eye = run(&mut small, Movement::Forward, 3.0, &scene);
    assert!(eye.x < 120.0 && eye.x > 118.0, "for a child of 6 voxels a step of 3 is a wall: {eye}");
}

#[test]
fn where_voxels_are_as_large_as_knees_one_of_them_is_a_step() {
    let mut grid = VoxelGrid::new();
    for number in 0..60 * 20 {
        let (x, y) = (number % 60, number / 60);
        (0..1 + (x - 20).clamp(0, 20)).for_each(|z| _ = grid.set(IVec3::new(x, y, z), 0));
    }
    let scene = Scene::from_grid("slope", grid, vec![Material::diffuse(Vec3::ONE)]);
    let scene = PackedScene::pack(&scene).unwrap();
    let eye = Vec3::new(10.5, 10.5, 3.6);
    let mut navigator = Navigator::new(Camera::look_at(eye, eye + Vec3::X), scene.bounds());
    navigator.walker.eye_height = 2.6;
    let eye = run(&mut navigator, Movement::Forward, 8.0, &scene);
    assert!(eye.x > 45.0 && (eye.z - 23.6).abs() < 0.1, "twenty steps up: {eye}");
}

#[test]
fn a_wall_stops_who_walks_into_it_and_lets_slide_who_walks_along() {
    let scene = landscape();
    let mut navigator = standing(60.0, 140.0, &scene);
    let eye = run(&mut navigator, Movement::Left, 2.0, &scene);
    assert!(eye.y < 150.0 - 2.0 && eye.y > 144.0 && (eye.x - 60.0).abs() < 0.1, "{eye}");
    navigator.held.set(Movement::Left, true);
    let eye = run(&mut navigator, Movement::Forward, 1.0, &scene);
    assert!(eye.x > 85.0 && eye.y < 148.0 && eye.y > 144.0, "along it: {eye}");
    let mut open = scene;
    open.cuts = Cuts::default().plane(Vec3::Z, 1.5).unwrap();
    navigator.held.clear();
    let eye = run(&mut navigator, Movement::Left, 1.0, &open);
    assert!(eye.y > 151.0, "what is cut away stops nobody: {eye}");
}

#[test]
fn who_jumps_comes_back_and_a_roof_is_in_the_way() {
    let scene = landscape();
    let mut navigator = standing(80.0, 80.0, &scene);
    navigator.held.set(Movement::Up, true);
    navigator.walk(0.02, &scene);
    navigator.held.set(Movement::Up, false);
    let mut highest = 0.0f32;
    for _ in 0..100 {
        navigator.walk(0.02, &scene);
        highest = highest.max(navigator.camera().eye.z);
    }
    assert!((highest - 34.0).abs() < 0.5, "0.65 of 20 above 21: {highest}");
    assert!((navigator.camera().eye.z - 21.0).abs() < 1e-3);
    let mut below = standing(20.0, 80.0, &scene);
    below.held.set(Movement::Up, true);
    for _ in 0..100 {
        below.walk(0.02, &scene);
        assert!(below.camera().eye.z < 23.9, "the roof is at 24: {}", below.camera().eye);
    }
}

#[test]
fn nobody_walks_over_the_edge_of_the_world() {
    let scene = landscape();
    let mut navigator = standing(20.0, 80.0, &scene);
    let eye = run(&mut navigator, Movement::Back, 3.0, &scene);
    assert!(eye.x >= 0.0 && eye.x < 2.0, "{eye}");
    assert!((eye.z - 21.0).abs() < 0.1, "{eye}");
}

#[test]
fn who_is_sent_somewhere_walks_there_and_gives_up_before_a_wall() {
    let scene = landscape();
    let mut navigator = standing(60.0, 60.0, &scene);
    let walk = |navigator: &mut Navigator, seconds: f32| {
        for _ in 0..(seconds / 0.02) as usize {
            navigator.walk(0.02, &scene);
        }
    };
    navigator.walk_to(Vec3::new(100.0, 90.0, 1.0));
    walk(&mut navigator, 5.0);
    let eye = navigator.camera().eye;
    assert!(eye.truncate().distance(Vec3::new(100.0, 90.0, 0.0).truncate()) < 3.0, "{eye}");
    assert_eq!(navigator.walker.goal(), None);
    navigator.walk_to(Vec3::new(100.0, 180.0, 1.0));
    walk(&mut navigator, 6.0);
    assert!(navigator.walker.goal().is_none() && navigator.camera().eye.y < 149.0, "{}", navigator.camera().eye);
    navigator.walk_to(Vec3::new(60.0, 60.0, 1.0));
    let eye = run(&mut navigator, Movement::Forward, 0.1, &scene);
    assert!(navigator.walker.goal().is_none() && eye.x > 100.0, "a key takes the way over");
}

/// A floor at z = 0 and nothing else.
struct Plane;

impl Ground for Plane {
    fn cast(&self, origin: DVec3, direction: DVec3, most: f64) -> Option<(f64, DVec3)> {
        let t = -origin.z / direction.z;
        (direction.z < 0.0 && t <= most).then_some((t.max(0.0), DVec3::Z))
    }
}

#[test]
fn the_way_does_not_depend_on_how_time_is_cut() {
    let pose = super::super::pose::Pose::of(&Camera::look_at(Vec3::new(0.0, 0.0, 10.0), Vec3::new(1.0, 1.0, 9.0)));
    let wish = Wish { direction: DVec2::Y, speed: 1.0, jumps: false };
    let end = |steps: usize| {
        let mut walker = Walker::default();
        walker.eye_height = 10.0;
        (0..steps).fold(pose, |pose, _| walker.moved(pose, wish, 1.0 / steps as f64, &Plane)).eye
    };
    assert!(end(1000).distance(end(5)) < 1e-6, "{} {}", end(1000), end(5));
    assert!((end(5).truncate().length() - 22.0).abs() < 1e-6 && end(5).z == 10.0, "{}", end(5));
}
