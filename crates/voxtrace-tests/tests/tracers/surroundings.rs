//! A ground without end and fog: the plane that rays meet, closed forms of light, and the same films from every tracer.

use std::sync::Arc;
use voxtrace::camera::Lens;
use voxtrace::glam::{IVec3, Vec3};
use voxtrace::surroundings::{Fog, Ground};
use voxtrace::{Camera, CpuTracer, Film, Frame, Integrator, Material, PackedScene, Ray};
use voxtrace::{Scene, Sky, Tracer, VoxelGrid};
use voxtrace_tests::estimate::render;
use voxtrace_tests::gpu::{ONE_OF_EACH, assert_valid, device, film, film_methods, for_each_tracer};
use voxtrace_tests::random::Random;

const COLOR: Vec3 = Vec3::new(0.6, 0.5, 0.25);

/// A tower and a low wall, in a white sky.
fn scene() -> Scene {
    let mut grid = VoxelGrid::new();
    for at in 0..5 * 5 * 30 {
        grid.set(IVec3::new(at % 5 + 40, at / 5 % 5 - 7, at / 25 + 3), 0);
    }
    for x in 20..70 {
        grid.set(IVec3::new(x, 9, 3), 1);
    }
    let materials = vec![Material::diffuse(Vec3::splat(0.4)), Material::glass(1.4, 0.2)];
    Scene { sky: Sky::uniform(Vec3::ONE), ..Scene::from_grid("tower", grid, materials) }
}

fn packed(scene: &Scene, ground: Option<Ground>, fog: Option<Fog>) -> Arc<PackedScene> {
    let packed = PackedScene::pack(scene).unwrap().with_surroundings(ground.as_ref(), fog.as_ref()).unwrap();
    packed.validate().unwrap();
    Arc::new(packed)
}

fn on_ground(height: Option<f32>) -> Arc<PackedScene> {
    packed(&scene(), Some(Ground { height, color: COLOR }), None)
}

/// The largest distance of a hit from the plane `z = height`, in shares of the way to it; infinite where a ray that goes down meets nothing.
fn worst(scene: &PackedScene, height: f64, rays: &[Ray]) -> f64 {
    let error = |ray: &Ray| {
        let Some(hit) = scene.cast(ray) else { return f64::INFINITY };
        let t = (height - f64::from(ray.origin.z)) / f64::from(ray.direction.z);
        // What stands on the ground is nearer.
        if scene.instances()[hit.instance as usize].scene_instance == 0 {
            0.0
        } else {
            (f64::from(hit.t) / t - 1.0).abs()
        }
    };
    rays.iter().map(error).fold(0.0, f64::max)
}

#[test]
fn every_ray_that_goes_down_meets_the_ground_where_the_plane_is() {
    let mut random = Random(7);
    let mut uniform = |low: f32, high: f32| low + (high - low) * random.unit();
    let mut rays = Vec::new();
    for _ in 0..20_000 {
        let origin = Vec3::new(uniform(-200.0, 200.0), uniform(-200.0, 200.0), uniform(4.0, 60.0));
        let direction = Vec3::new(uniform(-1.0, 1.0), uniform(-1.0, 1.0), -uniform(0.05, 1.0).powi(3));
        rays.push(Ray::new(origin, direction));
    }
    // At the borders of the squares, and a few steps of f32 beside them.
    for reach in [120.0f32, 128.0, 960.0, 1024.0, 7680.0, 8192.0, 61_440.0, 65_536.0] {
        for step in -20..=20 {
            let x = 45.0 + f32::from_bits((reach.to_bits() as i32 + step) as u32);
            for (x, y) in [(x, uniform(-50.0, 50.0)), (uniform(-50.0, 50.0), x), (-x, x), (90.0 - x, 1.0)] {
                rays.push(Ray::new(Vec3::new(x, y, 50.0), Vec3::NEG_Z));
                let eye = Vec3::new(45.0, 0.0, 50.0);
                rays.push(Ray::new(eye, Vec3::new(x, y, 3.0) - eye));
            }
        }
    }
    let scene = on_ground(None);
    let found = worst(&scene, 3.0, &rays);
    assert!(found < 1e-5, "{found}");
    assert!(worst(&on_ground(Some(2.999)), 3.0, &rays) > 1e-5, "the comparison sees a thousandth of a voxel");
    let bare = PackedScene::pack(&self::scene()).unwrap();
    assert_eq!(worst(&bare, 3.0, &rays), f64::INFINITY, "and a ray that meets nothing");
    assert!(scene.cast(&Ray::new(Vec3::new(0.0, 0.0, 50.0), Vec3::new(1.0, 0.0, 1e-3))).is_none(), "above the horizon");
}

/// Mean of red, green and blue over a film.
fn mean(film: &Film) -> [f64; 3] {
    let mut sum = [0.0; 3];
    for pixel in &film.pixels {
        let own = pixel.mean().to_array();
        (0..3).for_each(|channel| sum[channel] += f64::from(own[channel]) / film.pixels.len() as f64);
    }
    sum
}

#[test]
fn ground_that_sees_the_whole_sky_reflects_its_colour_of_it() {
    let camera = Camera::look_at(Vec3::new(-3000.0, 10.0, 60.0), Vec3::new(-3100.0, 10.0, 3.0));
    let frame = Frame::new(camera, 8, 6).integrator(Integrator::Path).samples(16);
    let found = mean(&render(&on_ground(None), &frame));
    let is_near =
        |expected: [f32; 3]| found.iter().zip(expected).all(|(own, wanted)| (own - f64::from(wanted)).abs() < 2e-4);
    assert!(is_near(COLOR.to_array()), "{found:?}");
    assert!(!is_near([0.601, 0.5, 0.25]), "the comparison sees a thousandth");
}

#[test]
fn what_stands_on_the_ground_leaves_a_shadow_that_touches_it() {
    // Straight down beside the tower, from which half the sky is hidden near its foot.
    let below = |x: f32| {
        let camera = Camera { up: Vec3::Y, ..Camera::look_at(Vec3::new(x, -4.5, 40.0), Vec3::new(x, -4.5, 3.0)) };
        let camera = camera.with_lens(Lens::Orthographic { view_height: 0.02 });
        Frame::new(camera, 8, 8).integrator(Integrator::Path).samples(64).max_bounces(0)
    };
    let share = |x: f32| mean(&render(&on_ground(None), &below(x).max_bounces(1)))[0] / 0.6;
    let (near, far) = (share(39.98), share(30.0));
    // The tower is so high that at its foot it hides nearly the half, and reflects at most 0.4 of what it sees.
    assert!((0.5..0.72).contains(&near) && far > 0.85, "{near} {far}");
}

/// Estimates of the radiance straight through fog, of a camera `distance` before a white wall or the end of the fog.
fn through_fog(fog: Fog, wall: Option<f32>) -> [f64; 3] {
    let mut grid = VoxelGrid::new();
    for at in 0..40 * 40 {
        grid.set(IVec3::new(20, at % 40 - 20, at / 40 - 20), 0);
    }
    let lamp = Material::emissive(Vec3::ONE);
    let mut scene = Scene::from_grid("wall", grid, vec![lamp]);
    scene.sky = if wall.is_some() { Sky::black() } else { Sky::uniform(Vec3::ONE) };
    let (eye, towards) = match wall {
        Some(distance) => (Vec3::new(20.0 - distance, 0.3, 0.2), Vec3::X),
        None => (Vec3::new(15.0, 0.3, 0.2), Vec3::NEG_X),
    };
    let camera = Camera::look_at(eye, eye + towards).with_lens(Lens::Orthographic { view_height: 1.0 });
    let frame = Frame::new(camera, 32, 32).integrator(Integrator::Path).samples(256).max_bounces(0);
    mean(&render(&packed(&scene, None, Some(fog)), &frame))
}

#[test]
fn black_fog_takes_light_away_as_beer_says() {
    let fog = |density| Fog { density, color: Vec3::ZERO, anisotropy: 0.0 };
    // Where nothing scatters light on, it is there or not: a mean of 262,144 such samples is within 4.5 standard errors.
    let is_beer = |found: [f64; 3], depth: f64| {
        let expected = (-depth).exp();
        (found[0] - expected).abs() < 4.5 * (expected * (1.0 - expected) / 262_144.0).sqrt()
    };
    for (density, distance) in [(0.05, 10.0), (0.02, 37.0), (0.3, 4.0)] {
        let found = through_fog(fog(density), Some(distance));
        let depth = f64::from(density) * f64::from(distance);
        assert!(is_beer(found, depth), "{density} {distance}: {found:?} and not {}", (-depth).exp());
        assert!(!is_beer(found, depth * 1.02), "the comparison sees two per cent");
    }
    // From x = 15 to the end of the cube: four diagonals of the wall from its middle.
    let diagonal = f64::from(Vec3::new(1.0, 40.0, 40.0).length());
    let depth = 0.004 * (4.0 * diagonal - (20.5 - 15.0));
    let found = through_fog(fog(0.004), None);
    assert!(is_beer(found, depth), "{found:?} and not {}", (-depth).exp());
    assert!(!is_beer(found, depth * 1.02));
}

#[test]
fn white_fog_is_invisible_in_a_white_sky() {
    let mut scene = scene();
    scene.materials[0] = Material::diffuse(Vec3::ONE);
    let fog = |color| Fog { density: 0.01, color: Vec3::splat(color), anisotropy: 0.5 };
    let camera = Camera::look_at(Vec3::new(10.0, -60.0, 20.0), Vec3::new(42.0, -5.0, 15.0));
    let frame = Frame::new(camera, 16, 12).integrator(Integrator::Path).samples(48).max_bounces(600);
    let found = |color| mean(&render(&packed(&scene, None, Some(fog(color))), &frame))[0];
    let white = found(1.0);
    assert!((white - 1.0).abs() < 0.02, "{white}");
    assert!(found(0.98) < 0.98, "the comparison sees grey fog");
}

#[test]
fn every_tracer_makes_the_same_film_of_ground_and_fog() {
    let mut scene = scene();
    scene.sky = Sky::study(1.0).with_sun(voxtrace::Sun::at(130.0, 30.0, 2.0));
    let ground = Ground { height: None, color: COLOR };
    let matte = Scene { materials: vec![scene.materials[0]; 2], ..scene.clone() };
    let fog = Fog { density: 0.01, color: Vec3::new(0.9, 0.95, 1.0), anisotropy: 0.6 };
    let camera = Camera::look_at(Vec3::new(-20.0, -60.0, 24.0), Vec3::new(42.0, -5.0, 9.0));
    let frame = Frame::new(camera, 32, 24).integrator(Integrator::Path).samples(2);
    let scenes = [packed(&matte, Some(ground), None), packed(&scene, Some(ground), Some(fog))];
    let expected = scenes.each_ref().map(|scene| {
        let mut cpu = CpuTracer::new(None);
        cpu.set_scene(scene).unwrap();
        film(&mut cpu, &frame)
    });
    assert_ne!(expected[0], expected[1]);
    let Some(device) = device() else { return };
    // On software, shaders with materials are left to the first method: that is the fog.
    let foggy = film_methods(&device, &ONE_OF_EACH[..1]);
    for_each_tracer(&device, &film_methods(&device, &ONE_OF_EACH), &scenes[0], |tracer, traversal, primitive| {
        let count = if foggy.contains(&(traversal, primitive)) { 2 } else { 1 };
        for (scene, expected) in scenes.iter().zip(&expected).take(count) {
            tracer.set_scene(scene).unwrap();
            let found = film(tracer, &frame);
            let differ = found.pixels.iter().zip(&expected.pixels).filter(|(a, b)| a != b).count();
            assert_eq!(differ, 0, "pixels by {traversal:?} {primitive:?}");
        }
    });
    assert_valid(&device);
}
