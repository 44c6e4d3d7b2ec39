//! What glass of voxels does to light, in closed form. Faces look along the axes, so a ball of voxels is no lens: a face keeps the two components
//! of n·direction along itself, and glass whose index is above √2 lets nothing out through a face at right angles to the one that it came in by.
//! What enters along d therefore leaves along d with some of its components' signs changed, whatever the shape: it focuses nothing.

use std::sync::Arc;
use voxtrace::camera::Lens;
use voxtrace::glam::{IVec3, Mat3, Vec3};
use voxtrace::grid::VoxelBox;
use voxtrace::sky::{Background, Environment, EnvironmentMap};
use voxtrace::{Camera, Frame, Integrator, Material, Scene, Sky, Transform, VoxelGrid};
use voxtrace_tests::estimate::{Estimate, check_equal, check_same, radiance};

const RADIUS: i32 = 6;

/// A sky that is the same in all directions that differ by signs alone: brighter towards the axes.
fn mirrored_sky(edge: u32) -> Sky {
    // The square that holds all directions is folded along its middle lines and diagonals; so are its texels.
    let half = edge as f32 / 2.0;
    let texel = |index: u32| {
        let place = |at: u32| ((at as f32 + 0.5 - half) / half).abs();
        let (u, v) = (place(index % edge), place(index / edge));
        // Beyond the diagonal lies the other hemisphere, mirrored at it.
        let (u, v) = if u + v <= 1.0 { (u, v) } else { (1.0 - v, 1.0 - u) };
        Vec3::splat(0.5 + u * v + 0.5 * (u - v).powi(2))
    };
    let texels: Vec<Vec3> = (0..edge * edge).map(texel).collect();
    Sky::new(Background::Environment(Environment::new(Arc::new(EnvironmentMap::new(edge, &texels).unwrap()), 0.0)))
}

/// A ball of glass, turned about z, under that sky, and parallel rays along `direction` through most of it.
fn ball(ior: f32, turn: f32, direction: Vec3) -> (Scene, Frame) {
    let mut grid = VoxelGrid::new();
    for index in 0..(2 * RADIUS).pow(3) {
        let at = IVec3::new(index % 12, index / 12 % 12, index / 144) - RADIUS;
        if (at.as_vec3() + 0.5).length() < RADIUS as f32 {
            grid.set(at, 0);
        }
    }
    let mut scene = Scene { sky: mirrored_sky(64), ..Scene::from_grid("ball", grid, vec![Material::glass(ior, 0.0)]) };
    scene.instances[0].world_from_grid = Transform { linear: Mat3::from_rotation_z(turn), translation: Vec3::ZERO };
    let camera = Camera::look_at(direction * -30.0, Vec3::ZERO).with_lens(Lens::Orthographic { view_height: 9.0 });
    let frame = Frame::new(camera, 12, 12).integrator(Integrator::Path).samples(96).max_bounces(600);
    (scene, frame)
}

#[test]
fn a_ball_of_glass_voxels_sends_parallel_light_on_in_its_own_direction_but_for_signs() {
    for direction in [Vec3::new(0.3, 0.5, -0.81), Vec3::new(-0.7, 0.1, 0.2), Vec3::new(0.05, -0.9, 0.1)] {
        let direction = direction.normalize();
        let seen = |ior: f32, turn: f32| {
            let (scene, frame) = ball(ior, turn, direction);
            radiance(&scene, &frame, 1)
        };
        let sky = f64::from(mirrored_sky(64).radiance(direction).x);
        for ior in [1.45, 1.5, 2.4] {
            check_equal(&seen(ior, 0.0), sky).unwrap_or_else(|error| panic!("{direction} {ior}: {error}"));
        }
        // Below √2 light goes around the edges, and the faces of a turned ball are no mirrors of this sky.
        check_equal(&seen(1.2, 0.0), sky).unwrap_err();
        check_equal(&seen(1.5, 0.4), sky).unwrap_err();
    }
}

/// What a stack of plates, from above, reflects and lets through at right angles: light goes to and fro in each without interference.
fn stack(iors: &[f64]) -> (f64, f64) {
    let around: Vec<f64> = [1.0].into_iter().chain(iors.iter().copied()).chain([1.0]).collect();
    let surfaces = around.windows(2).map(|pair| ((pair[0] - pair[1]) / (pair[0] + pair[1])).powi(2));
    surfaces.fold((0.0, 1.0), |(reflected, through), surface| {
        let between = 1.0 - reflected * surface;
        (reflected + through * through * surface / between, through * (1.0 - surface) / between)
    })
}

/// Plates from the lowest up, each so many voxels thick, above a lamp, seen from above; each an instance of its own where they are `apart`.
fn plates(layers: &[(f32, i32)], apart: bool) -> (Scene, Frame) {
    let materials = layers.iter().map(|&(ior, _)| Material::glass(ior, 0.0));
    let lamp = Material::emissive(Vec3::ONE);
    let mut scene = Scene::new("plates");
    scene.materials = [lamp].into_iter().chain(materials).collect();
    scene.sky = Sky::black();
    let layer = |low, high| VoxelBox { min: IVec3::new(-40, -40, low), max: IVec3::new(40, 40, high) };
    let mut grid = VoxelGrid::new();
    grid.fill_box(layer(-4, -3), 0);
    let mut low = 0;
    for (index, &(_, thickness)) in layers.iter().enumerate() {
        if apart {
            let mut own = VoxelGrid::new();
            // Deeper than it is seen: what was there before counts.
            own.fill_box(layer(if index > 0 { -1 } else { 0 }, thickness), index as u16 + 1);
            scene.add_instance(own, Transform::from_translation(Vec3::Z * low as f32));
        } else {
            grid.fill_box(layer(low, low + thickness), index as u16 + 1);
        }
        low += thickness;
    }
    scene.add_instance(grid, Transform::IDENTITY);
    let camera = Camera { up: Vec3::Y, ..Camera::look_at(Vec3::new(0.3, 0.2, 40.0), Vec3::new(0.3, 0.2, 0.0)) };
    let camera = camera.with_lens(Lens::Orthographic { view_height: 3.0 });
    (scene, Frame::new(camera, 12, 12).integrator(Integrator::Path).samples(128).max_bounces(300))
}

/// Whether estimates are within half a per cent of a value.
fn is_near(found: &[Estimate], expected: f64) -> bool {
    found.iter().all(|own| (own.mean / expected - 1.0).abs() < 0.005)
}

#[test]
fn ice_in_water_in_glass_lets_through_what_fresnel_says_and_has_no_seams() {
    let layers = [(1.5, 2), (1.33, 3), (1.31, 4), (1.33, 1), (1.5, 2)];
    let (_, expected) = stack(&layers.map(|(ior, _)| f64::from(ior)));
    let whole = {
        let (scene, frame) = plates(&layers, false);
        radiance(&scene, &frame, 1)
    };
    assert!(is_near(&whole, expected), "{whole:?} and not {expected}");
    let apart = {
        let (scene, frame) = plates(&layers, true);
        radiance(&scene, &frame, 1)
    };
    check_same(&whole, &apart, 0.01).unwrap();
    // With a gap of air wherever things adjoin there would be less.
    let gaps = stack(&[1.5, 1.0, 1.33, 1.0, 1.31, 1.0, 1.33, 1.0, 1.5]).1;
    assert!(!is_near(&whole, gaps), "{gaps}");
    // A single plate, and one of air.
    assert!((stack(&[1.5]).1 - 0.96 * 0.96 / (1.0 - 0.04f64.powi(2))).abs() < 1e-12);
    assert_eq!(stack(&[1.0]), (0.0, 1.0));
}
