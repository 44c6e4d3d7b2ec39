//! Light transport against analytic results: white furnaces, emitters and skies of known radiance; and the two integrators
//! against each other.

use glam::{IVec3, Mat3, Vec3};
use std::f64::consts::PI;
use std::sync::Arc;
use voxtrace::{Camera, Film, Integrator, Material, PackedScene, Scene, Sky, Sun, Transform, VoxelGrid};
use voxtrace_tests::estimate::{check_equal, check_same, radiance, render};
use voxtrace_tests::{rooms, scenes};

/// Irradiance is measured this far above a surface, voxels.
const OFFSET: f32 = 1.0 / 1024.0;

const BOTH: [Integrator; 2] = [Integrator::Essay, Integrator::Path];

fn uniform_sky(radiance: f32) -> Sky {
    Sky::uniform(Vec3::splat(radiance))
}

fn grey(value: f32) -> Material {
    Material::diffuse(Vec3::splat(value))
}

/// A porous body that does not emit, with a camera in front of it.
fn crumbs(albedo: f32, sky: Sky) -> Scene {
    let grid = scenes::noise(IVec3::splat(-4), 8, 0.3, 1, 3);
    let mut scene = Scene { sky, ..Scene::from_grid("crumbs", grid, vec![grey(albedo)]) };
    scene.cameras.push(Camera::look_at(Vec3::new(9.0, 12.0, 6.0), Vec3::ZERO));
    scene
}

/// A plain of albedo one half, its surface at z = 0, under `sky`; the camera looks closely at `point`.
fn plain(sky: Sky, point: Vec3) -> Scene {
    let mut grid = VoxelGrid::new();
    for y in -30..30 {
        (-30..30).for_each(|x| _ = grid.set(IVec3::new(x, y, -1), 0));
    }
    let mut scene = Scene { sky, ..Scene::from_grid("plain", grid, vec![grey(0.5), grey(0.0)]) };
    let camera = Camera::look_at(point + Vec3::new(6.0, 3.0, 5.0), point);
    scene.cameras.push(Camera { fov_y: 0.01, ..camera });
    scene
}

fn with_emission(mut scene: Scene, factor: f32) -> Scene {
    scene.materials.iter_mut().for_each(|material| material.emission *= factor);
    scene
}

#[test]
fn a_white_body_in_a_white_sky_is_invisible() {
    for integrator in BOTH {
        let check = |scene: Scene| {
            let frame = rooms::frame(&scene, (12, 12), 16, integrator).max_bounces(200);
            check_equal(&radiance(&scene, &frame, 2), 1.0)
        };
        check(crumbs(1.0, uniform_sky(1.0))).unwrap();
        check(crumbs(0.98, uniform_sky(1.0))).unwrap_err();
        check(crumbs(1.0, uniform_sky(1.02))).unwrap_err();
    }
}

#[test]
fn a_closed_glowing_room_has_the_radiance_of_the_geometric_series() {
    let albedo = 0.6_f64;
    for bounces in [0, 1, 4, 60] {
        let check = |factor: f32, seen_bounces: i32| {
            let wall = Material { emission: Vec3::splat(0.5 * factor), ..grey(albedo as f32) };
            let grid = rooms::shell(IVec3::new(5, 4, 3), |_| 0);
            let mut scene = Scene { sky: Sky::black(), ..Scene::from_grid("glow", grid, vec![wall]) };
            scene.cameras.push(Camera::look_at(Vec3::new(1.5, 1.5, 1.5), Vec3::new(3.0, 3.0, 1.0)));
            let frame = rooms::frame(&scene, (8, 8), 64, Integrator::Path).max_bounces(bounces);
            check_equal(&radiance(&scene, &frame, 1), 0.5 * (1.0 - albedo.powi(seen_bounces + 1)) / (1.0 - albedo))
        };
        check(1.0, bounces as i32).unwrap();
        check(1.02, bounces as i32).unwrap_err();
        if bounces < 10 {
            check(1.0, bounces as i32 + 1).unwrap_err();
        }
    }
}

#[test]
fn a_plain_reflects_the_gradient_of_the_sky() {
    for integrator in BOTH {
        let check = |sky: Sky| {
            let scene = plain(sky.clone(), Vec3::new(0.3, 0.4, 0.0));
            let estimates = radiance(&scene, &rooms::frame(&scene, (8, 8), 64, integrator), 1);
            // The mean height of the sky, weighed by the cosine, is (1 + 2/3) / 2.
            let radiance_of = |direction| sky.background().radiance(direction);
            let expected = (radiance_of(Vec3::NEG_Z) / 6.0 + radiance_of(Vec3::Z) * (5.0 / 6.0)) * 0.5;
            (0..3).try_for_each(|channel| check_equal(&estimates[channel..=channel], expected[channel].into()))
        };
        check(Sky::study(1.0)).unwrap();
        check(Sky::gradient(Vec3::new(0.1, 2.0, 0.5), Vec3::new(3.0, 0.2, 0.1))).unwrap();
        check(Sky::study(1.02)).unwrap_err();
    }
}

/// Irradiance at `point` (normal +z) from the faces, of radiance one, of a voxel placed by `transform`, by quadrature in
/// double precision; faces behind the horizon or turned away send nothing.
fn irradiance_of_voxel(transform: &Transform, point: Vec3) -> f64 {
    let steps = 200;
    let mut sum = 0.0;
    for face in voxtrace::ray::FACES {
        let in_grid = face.normal().as_vec3();
        let normal = transform.direction(in_grid).normalize().as_dvec3();
        let (a, b) = in_grid.any_orthonormal_pair();
        for i in 0..steps * steps {
            let at = |index: i32| (index as f32 + 0.5) / steps as f32 - 0.5;
            let on_face = Vec3::splat(0.5) + in_grid * 0.5 + a * at(i / steps) + b * at(i % steps);
            let toward = transform.point(on_face).as_dvec3() - point.as_dvec3();
            let (above, sent) = (toward.z.max(0.0), (-toward.dot(normal)).max(0.0));
            sum += above * sent / toward.length_squared().powi(2);
        }
    }
    sum * f64::from(transform.scale()).powi(2) / f64::from(steps * steps)
}

#[test]
fn a_plain_under_one_glowing_voxel_has_the_radiance_of_its_form_factor() {
    // A unit square, centred at height 2 above a point, in closed form: the quadrature agrees.
    let (half, height) = (0.5_f64, 2.0_f64);
    let ratio = half / height;
    let quarter = ratio / (1.0 + ratio * ratio).sqrt() * (ratio / (1.0 + ratio * ratio).sqrt()).atan() / PI;
    let above = Transform::from_translation(Vec3::new(-0.5, -0.5, 2.0));
    assert!((irradiance_of_voxel(&above, Vec3::ZERO) / (4.0 * PI * quarter) - 1.0).abs() < 1e-4);

    let turned = Mat3::from_axis_angle(Vec3::new(2.0, 3.0, 6.0) / 7.0, 1.1);
    let places = [
        (above, Vec3::new(0.01, 0.02, 0.0)),
        (above, Vec3::new(3.3, -1.2, 0.0)),
        (Transform::from_translation(Vec3::new(0.0, 0.0, 0.0)), Vec3::new(1.2, 0.4, 0.0)),
        (Transform { linear: turned * 1.7, translation: Vec3::new(1.0, 1.0, 3.0) }, Vec3::new(0.3, 0.4, 0.0)),
        (
            Transform { linear: turned * Mat3::from_diagonal(Vec3::new(-0.5, 0.5, 0.5)), ..above },
            Vec3::new(1.5, 0.4, 0.0),
        ),
    ];
    for (transform, point) in places {
        let mut scene = plain(Sky::black(), point);
        scene.materials[1].emission = Vec3::splat(7.0);
        scene.light_intensity = 3.0;
        let mut voxel = VoxelGrid::new();
        voxel.set(IVec3::ZERO, 1);
        scene.add_instance(voxel, transform);
        let expected = 21.0 * 0.5 / PI * irradiance_of_voxel(&transform, point + Vec3::Z * OFFSET);
        let check = |scene: Scene| {
            let frame = rooms::frame(&scene, (16, 16), 64, Integrator::Path).max_bounces(1);
            check_equal(&radiance(&scene, &frame, 1), expected).map_err(|why| format!("{transform:?} {why}"))
        };
        check(scene.clone()).unwrap();
        check(with_emission(scene, 1.02)).unwrap_err();
    }
}

#[test]
fn a_plain_in_the_sun_has_the_radiance_of_lamberts_law() {
    let dark = Sky::uniform(Vec3::ZERO).with_brightness(2.0);
    for angular_radius in [0.0, 0.0047, 0.3] {
        let check = |irradiance: f32| {
            let direction = Vec3::new(0.48, 0.6, 0.64);
            let sun = Sun { direction, angular_radius, irradiance: Vec3::splat(irradiance) };
            let scene = plain(dark.clone().with_sun(sun), Vec3::new(0.3, 0.4, 0.0));
            let frame = rooms::frame(&scene, (16, 16), 64, Integrator::Path);
            check_equal(&radiance(&scene, &frame, 1), 0.5 * 2.0 * 3.0 * 0.64 / PI)
        };
        check(3.0).unwrap();
        check(3.06).unwrap_err();
    }
}

#[test]
fn the_suns_disc_has_its_radiance_and_size() {
    let check = |radius: f64| {
        let sun = Sun { direction: Vec3::Y, angular_radius: radius as f32, irradiance: Vec3::ONE };
        let mut scene = crumbs(0.5, uniform_sky(1.0).with_sun(sun));
        scene.cameras[0] = Camera { fov_y: 8.0, ..Camera::look_at(Vec3::Y * 50.0, Vec3::Y * 51.0) };
        let frame = rooms::frame(&scene, (32, 32), 32, Integrator::Path);
        // The disc's share of the picture plane times its radiance, plus the sky.
        let (radius_tan, half) = (0.03_f64.tan(), 4.0_f64.to_radians().tan());
        let share = PI * radius_tan * radius_tan / (4.0 * half * half);
        check_equal(&radiance(&scene, &frame, 1), 1.0 + share / (PI * 0.03_f64.sin().powi(2)))
    };
    check(0.03).unwrap();
    check(0.06).unwrap_err();
}

#[test]
fn both_integrators_agree_in_the_mean() {
    for scene in [rooms::lamp_room(), Scene { sky: Sky::study(1.5), ..rooms::open_plain() }] {
        let by_essay = radiance(&scene, &rooms::frame(&scene, (16, 16), 256, Integrator::Essay), 2);
        let check = |scene: &Scene| {
            let by_path = radiance(scene, &rooms::frame(scene, (16, 16), 32, Integrator::Path), 2);
            check_same(&by_path, &by_essay, 0.15)
        };
        check(&scene).unwrap();
        let brighter = Scene { light_intensity: 1.1, sky: Sky::study(1.5 * 1.1), ..scene.clone() };
        check(&if scene.name == "lamp room" { Scene { sky: Sky::black(), ..brighter } } else { brighter }).unwrap_err();
    }
}

#[test]
fn no_sample_carries_more_than_the_brightest_source() {
    let check = |sky: f32| {
        let scene = crumbs(1.0, uniform_sky(sky));
        let frame = rooms::frame(&scene, (40, 40), 1, Integrator::Essay).max_bounces(30);
        let film = render(&Arc::new(PackedScene::pack(&scene).unwrap()), &frame);
        let brightest = film.pixels.iter().map(|pixel| pixel.mean().max_element()).fold(0.0, f32::max);
        if brightest <= 1.0 { Ok(()) } else { Err(format!("{brightest}")) }
    };
    check(1.0).unwrap();
    check(1.001).unwrap_err();
}

/// Root of the mean squared difference of two films over the pixels that are black in `lamps`. The edge of a lamp in view
/// is as noisy with any integrator: its error is that of the camera's jitter, and it would drown the light on surfaces.
fn distance(a: &Film, b: &Film, lamps: &Film) -> f64 {
    let pixels = || a.pixels.iter().zip(&b.pixels).zip(&lamps.pixels).filter(|(_, lamp)| lamp.mean() == Vec3::ZERO);
    let squares = pixels().map(|((a, b), _)| (a.mean() - b.mean()).as_dvec3().length_squared());
    assert!(pixels().count() > a.pixels.len() / 2, "most pixels see lamps");
    (squares.sum::<f64>() / pixels().count() as f64).sqrt()
}

#[test]
fn in_lamp_light_the_path_integrator_needs_less_than_a_tenth_of_the_samples() {
    let mut lit = vec![(rooms::lamp_room(), 3)];
    // Built-in scenes are made to a number of voxels, and this one has its lamps in view.
    lit.extend(voxtrace::scenes::generate("operating-room", Some(200_000)).map(|scene| (scene, 3)));
    for (scene, max_bounces) in lit {
        let packed = Arc::new(PackedScene::pack(&scene).unwrap());
        let picture = |samples, integrator, seed| {
            let frame = rooms::frame(&scene, (40, 30), samples, integrator);
            render(&packed, &frame.seed(seed).max_bounces(max_bounces))
        };
        let lamps = render(&packed, &rooms::frame(&scene, (40, 30), 512, Integrator::Essay).max_bounces(0));
        let truth = picture(1024, Integrator::Path, 99);
        let check = |samples| {
            let by_path = distance(&picture(samples, Integrator::Path, 1), &truth, &lamps);
            let by_essay = distance(&picture(320, Integrator::Essay, 2), &truth, &lamps);
            println!("{}: path {samples}: {by_path:.4}, essay 320: {by_essay:.4}", scene.name);
            if by_path < by_essay { Ok(()) } else { Err(format!("{}: {by_path}, {by_essay}", scene.name)) }
        };
        check(32).unwrap();
        check(1).unwrap_err();
    }
}
