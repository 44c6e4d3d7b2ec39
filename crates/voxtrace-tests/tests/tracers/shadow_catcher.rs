//! A ground that shows nothing but the shadows on it: closed forms and sums over all directions, what else a picture shows, and the same films from
//! every tracer.

use std::f64::consts::{PI, TAU};
use std::sync::Arc;
use voxtrace::camera::Lens;
use voxtrace::cuts::Cuts;
use voxtrace::glam::{DVec3, IVec3, Vec3};
use voxtrace::sky::{Background, Environment};
use voxtrace::surroundings::Ground;
use voxtrace::{Camera, CpuTracer, Film, Frame, Material, PackedScene, Scene, Sky, Sun, Tracer, VoxelGrid};
use voxtrace_tests::environments::noise_map;
use voxtrace_tests::estimate::render;
use voxtrace_tests::gpu::{ONE_OF_EACH, assert_valid, device, film, film_methods, for_each_tracer};

/// What the plate of a scene spans, and the height of its lower side above the ground.
const PLATE: [f64; 4] = [-6.0, 10.0, -9.0, 5.0];
const HEIGHT: f64 = 8.0;

/// A plate of one layer above a ground at the height 0.
fn plate(sky: Sky, material: Material) -> Arc<PackedScene> {
    let [x0, x1, y0, y1] = PLATE.map(|edge| edge as i32);
    let mut grid = VoxelGrid::new();
    for (x, y) in (x0..x1).flat_map(|x| (y0..y1).map(move |y| (x, y))) {
        grid.set(IVec3::new(x, y, HEIGHT as i32), 0);
    }
    on_ground(&Scene { sky, ..Scene::from_grid("plate", grid, vec![material]) }, Some(0.0))
}

fn on_ground(scene: &Scene, height: Option<f32>) -> Arc<PackedScene> {
    let ground = Ground { height, color: Vec3::splat(0.5) };
    Arc::new(PackedScene::pack(scene).unwrap().with_surroundings(Some(&ground), None).unwrap())
}

/// Straight down on a place of the ground, from below the plate.
fn above(x: f32, y: f32) -> Frame {
    let camera = Camera { up: Vec3::Y, ..Camera::look_at(Vec3::new(x, y, 4.0), Vec3::new(x, y, 0.0)) };
    let camera = camera.with_lens(Lens::Orthographic { view_height: 0.02 });
    Frame::new(camera, 16, 16).samples(1024).transparent(true).shadow_catcher(true)
}

/// Mean alpha of a film whose samples are all black.
fn alpha(film: &Film) -> f64 {
    assert!(film.pixels.iter().all(|pixel| pixel.radiance == [0; 3]), "shadows are black");
    let sum = |count: fn(&voxtrace::film::Pixel) -> u32| film.pixels.iter().map(|pixel| f64::from(count(pixel))).sum();
    let (covered, samples): (f64, f64) = (sum(|pixel| pixel.covered), sum(|pixel| pixel.samples));
    covered / samples
}

/// Whether an alpha of 262,144 samples is within 4.5 standard errors, and what a texel of a map is wide.
fn is_near(found: f64, expected: f64) -> bool {
    (found - expected).abs() < 4.5 * (expected * (1.0 - expected) / 262_144.0).sqrt() + 1e-6
}

/// Share of the light on the ground at (`x`, `y`) that a plate so high keeps from it, of which `radiance` is the luminance: a sum over directions
/// whose cosines are as likely as ground sees them.
fn blocked(radiance: impl Fn(DVec3) -> f64, (x, y): (f64, f64), height: f64) -> f64 {
    let steps = 1500;
    let (mut all, mut lost) = (0.0, 0.0);
    for index in 0..steps * steps {
        let at = |step: i32| (f64::from(step) + 0.5) / f64::from(steps);
        let (z, turn) = (at(index / steps).sqrt(), TAU * at(index % steps));
        let radius = (1.0 - z * z).sqrt();
        let direction = DVec3::new(radius * turn.cos(), radius * turn.sin(), z);
        let (to_x, to_y) = (x + direction.x / z * height, y + direction.y / z * height);
        let light = radiance(direction);
        all += light;
        if (PLATE[0]..PLATE[1]).contains(&to_x) && (PLATE[2]..PLATE[3]).contains(&to_y) {
            lost += light;
        }
    }
    lost / all
}

/// Form factor of a plate seen from a point of parallel ground below it (Howell, Menguc and Daun, "Thermal Radiation Heat Transfer", C-11).
fn form_factor((x, y): (f64, f64), height: f64) -> f64 {
    let corner = |a: f64, b: f64| {
        let (a, b) = (a / height, b / height);
        let half = |a: f64, b: f64| a / (1.0 + a * a).sqrt() * (b / (1.0 + a * a).sqrt()).atan();
        (half(a, b) + half(b, a)) / TAU
    };
    let [x0, x1, y0, y1] = PLATE;
    [x - x0, x1 - x].iter().flat_map(|a| [y - y0, y1 - y].map(|b| corner(*a, b))).sum()
}

fn luminance(color: Vec3) -> f64 {
    color.as_dvec3().dot(DVec3::new(0.2126, 0.7152, 0.0722))
}

#[test]
fn under_a_plate_in_an_even_sky_alpha_is_its_form_factor() {
    let scene = plate(Sky::uniform(Vec3::new(0.2, 0.5, 0.9)), Material::default());
    for place in [(0.0, 0.0), (-4.5, 3.25), (8.0, -7.5)] {
        let found = alpha(&render(&scene, &above(place.0 as f32, place.1 as f32)));
        let expected = form_factor(place, HEIGHT);
        assert!(is_near(found, expected), "{place:?}: {found} and not {expected}");
        assert!(
            !is_near(found, form_factor(place, HEIGHT * 1.03)),
            "the comparison sees a plate that is a little higher"
        );
        assert!((blocked(|_| 1.0, place, HEIGHT) - expected).abs() < 1e-4, "so does the sum over directions");
    }
}

#[test]
fn alpha_is_the_share_of_the_light_of_sun_and_sky_that_is_kept_from_the_ground() {
    let gradient = |nadir: f32, zenith: f32| Sky::gradient(Vec3::splat(nadir), Vec3::splat(zenith));
    let direction = Vec3::new(0.3, -0.4, 0.75).normalize();
    let wide = Sun { direction, angular_radius: 0.4, irradiance: Vec3::new(1.5, 1.2, 0.6) };
    let map = Sky::new(Background::Environment(Environment::new(noise_map(64, 3), 40.0)));
    let skies = [
        gradient(0.0, 3.0),
        gradient(2.0, 0.1),
        gradient(1.0, 1.0).with_sun(Some(wide)),
        Sky::uniform(Vec3::ZERO).with_sun(Some(wide)),
        map.clone(),
        map.with_brightness(0.5).with_sun(Some(wide)),
    ];
    let place = (3.0, 2.0);
    for (index, sky) in skies.into_iter().enumerate() {
        let disc = |sun: &Sun| {
            luminance(sun.irradiance * sky.brightness()) / (PI * f64::from(sun.angular_radius.sin()).powi(2))
        };
        let radiance = |direction: DVec3| {
            let d = direction.as_vec3();
            let is_in = |sun: &&Sun| d.angle_between(sun.direction) < sun.angular_radius;
            luminance(sky.radiance(d)) + sky.sun().filter(is_in).map_or(0.0, disc)
        };
        let found = alpha(&render(&plate(sky.clone(), Material::default()), &above(3.0, 2.0)));
        let expected = blocked(radiance, place, HEIGHT);
        // Within a texel of a map light is taken as even.
        let slack = if sky.background().environment().is_some() { 2e-3 } else { 4e-4 };
        assert!((found - expected).abs() < 4.0 * slack, "sky {index}: {found} and not {expected}");
        let even = blocked(|_| 1.0, place, HEIGHT);
        assert!((found - even).abs() > 4.0 * slack, "sky {index}: the comparison sees what light comes from where");
    }
}

#[test]
fn the_shadow_of_the_sun_has_an_edge() {
    let sun = Sun { direction: Vec3::new(0.6, 0.0, 0.8), angular_radius: 1e-3, irradiance: Vec3::ONE };
    let scene = plate(Sky::uniform(Vec3::ZERO).with_sun(Some(sun)), Material::default());
    // Of the lower side eight above the ground the shadow is six aside, of the upper one another three fourths.
    let covered = |x: f32, y: f32| alpha(&render(&scene, &above(x, y).samples(64)));
    for (x, y, expected) in
        [(-12.7, 0.0, 1.0), (-12.8, 0.0, 0.0), (3.95, 0.0, 1.0), (4.05, 0.0, 0.0), (0.0, 4.95, 1.0), (0.0, 5.05, 0.0)]
    {
        assert_eq!(covered(x, y), expected, "{x} {y}");
    }
    // Half of the disc is hidden at the edge itself.
    let half = covered(4.0, 0.0);
    assert!((half - 0.5).abs() < 0.1, "{half}");
    // No light falls, and nothing is kept from the ground.
    assert_eq!(alpha(&render(&plate(Sky::uniform(Vec3::ZERO), Material::default()), &above(0.0, 0.0).samples(4))), 0.0);
    // Light of the sun that comes from below the horizon neither.
    let below = Sun { direction: Vec3::new(0.6, 0.0, -0.8), ..sun };
    let night = plate(Sky::uniform(Vec3::ZERO).with_sun(Some(below)), Material::default());
    assert_eq!(alpha(&render(&night, &above(0.0, 0.0).samples(4))), 0.0);
}

#[test]
fn glass_casts_a_shadow_as_dense_as_what_it_reflects() {
    let sun = Sun { direction: Vec3::Z, angular_radius: 1e-3, irradiance: Vec3::ONE };
    let scene = plate(Sky::uniform(Vec3::ZERO).with_sun(Some(sun)), Material::glass(1.5, 0.0));
    let frame = above(0.0, 0.0);
    assert_eq!(alpha(&render(&scene, &frame)), 1.0, "glass that refracts is in the way");
    let found = alpha(&render(&scene, &frame.clone().clear_shadows(true)));
    // Two boundaries reflect four per cent each.
    assert!(is_near(found, 1.0 - 0.96f64.powi(2)), "{found}");
    assert!(!is_near(found, 1.0 - 0.95f64.powi(2)), "the comparison sees one per cent");
}

/// A tower beside a pane and a lamp, on the ground.
fn yard(sky: Sky) -> Arc<PackedScene> {
    let mut grid = VoxelGrid::new();
    for at in 0..5 * 5 * 24 {
        grid.set(IVec3::new(at % 5 + 40, at / 5 % 5 - 7, at / 25), 0);
    }
    for at in 0..20 * 8 {
        grid.set(IVec3::new(at % 20 + 55, -12, at / 20), 1);
    }
    for at in 0..4 * 4 * 4 {
        grid.set(IVec3::new(at % 4 + 18, at / 4 % 4 - 7, at / 16), 2);
    }
    let materials = vec![Material::diffuse(Vec3::splat(0.4)), Material::glass(1.4, 0.0), Material::emissive(Vec3::ONE)];
    on_ground(&Scene { sky, ..Scene::from_grid("yard", grid, materials) }, None)
}

fn day() -> Sky {
    Sky::study(1.0).with_sun(Sun::at(130.0, 30.0, 2.0))
}

fn view() -> Frame {
    let camera = Camera::look_at(Vec3::new(-20.0, -60.0, 24.0), Vec3::new(42.0, -5.0, 9.0));
    Frame::new(camera, 48, 36).samples(2).max_bounces(4).transparent(true).shadow_catcher(true)
}

#[test]
fn all_but_the_ground_is_as_it_was() {
    let scene = yard(day());
    let frame = view().samples(16).aovs(true);
    let caught = render(&scene, &frame);
    let plain = render(&scene, &frame.clone().shadow_catcher(false));
    assert_eq!(caught.aovs, plain.aovs);
    let is_ground = |instance: u32| scene.instances().get(instance as usize).is_some_and(|i| i.scene_instance > 0);
    let aovs = caught.aovs.as_ref().unwrap();
    let whole = |index: usize| {
        // Pixels beside others of the same kind: samples within them meet nothing else.
        let (x, y) = (index % 48, index / 48);
        let kind = |x: usize, y: usize| (aovs[y * 48 + x].instance == u32::MAX, is_ground(aovs[y * 48 + x].instance));
        let near = (y.saturating_sub(1)..(y + 2).min(36))
            .flat_map(|y| (x.saturating_sub(1)..(x + 2).min(48)).map(move |x| (x, y)));
        near.into_iter().all(|(u, v)| kind(u, v) == kind(x, y)).then_some(kind(x, y))
    };
    let (mut objects, mut ground, mut clear) = (0, 0, 0);
    for index in 0..48 * 36 {
        match whole(index) {
            Some((false, false)) => {
                objects += 1;
                assert_eq!(caught.pixels[index], plain.pixels[index], "pixel {index}");
            }
            Some((false, true)) => {
                ground += 1;
                clear += usize::from(caught.pixels[index].covered == 0);
                assert_eq!(caught.pixels[index].radiance, [0; 3]);
                assert_ne!(caught.pixels[index], plain.pixels[index], "pixel {index}");
            }
            Some((true, _)) => assert_eq!(caught.pixels[index], plain.pixels[index]),
            None => {}
        }
    }
    assert!(objects > 15 && ground > 500 && clear > 50 && clear < ground, "{objects} {ground} {clear}");
    // Groups of light follow the same paths.
    let sun = render(&scene, &frame.light_group(voxtrace::LightGroup::Sun));
    assert!(sun.pixels.iter().zip(&caught.pixels).all(|(a, b)| a.covered == b.covered));
    assert_ne!(sun.pixels, caught.pixels);
}

#[test]
fn what_is_cut_away_leaves_no_shadow_unless_it_is_asked_to() {
    let sun = Sun { direction: Vec3::new(0.6, 0.0, 0.8), angular_radius: 1e-3, irradiance: Vec3::ONE };
    let mut scene = PackedScene::clone(&plate(Sky::uniform(Vec3::ZERO).with_sun(Some(sun)), Material::default()));
    let covered = |scene: &PackedScene| alpha(&render(&Arc::new(scene.clone()), &above(0.0, 0.0).samples(4)));
    assert_eq!(covered(&scene), 1.0);
    let below = Cuts::default().plane(Vec3::Z, 6.0).unwrap();
    scene.cuts = below.clone();
    assert_eq!(covered(&scene), 0.0);
    scene.cuts = below.shadows(true);
    assert_eq!(covered(&scene), 1.0);
}

#[test]
fn every_tracer_makes_the_same_film_of_shadows() {
    let map = Sky::new(Background::Environment(Environment::new(noise_map(24, 5), 77.0)));
    let scenes = [yard(day()), yard(map.with_sun(Sun::at(130.0, 30.0, 2.0)))];
    let frames = [view(), view().clear_shadows(true)];
    let cpu = |scene: &Arc<PackedScene>, frame: &Frame| {
        let mut cpu = CpuTracer::new(None);
        cpu.set_scene(scene).unwrap();
        film(&mut cpu, frame)
    };
    let expected = scenes.each_ref().map(|scene| frames.each_ref().map(|frame| cpu(scene, frame)));
    assert_ne!(expected[0], expected[1]);
    assert_ne!(expected[0][0], expected[0][1], "glass casts another shadow");
    assert_ne!(expected[0][0], cpu(&scenes[0], &view().shadow_catcher(false)));
    let Some(device) = device() else { return };
    // On software, which compiles each kind of sky for half a minute, the map is left to the first method.
    let all = film_methods(&device, &ONE_OF_EACH);
    let mapped = film_methods(&device, &ONE_OF_EACH[..1]);
    for_each_tracer(&device, &all, &scenes[0], |tracer, traversal, primitive| {
        let count = if mapped.contains(&(traversal, primitive)) { 2 } else { 1 };
        for (scene, expected) in scenes.iter().zip(&expected).take(count) {
            tracer.set_scene(scene).unwrap();
            for (frame, expected) in frames.iter().zip(expected) {
                let found = film(tracer, frame);
                let differ = found.pixels.iter().zip(&expected.pixels).filter(|(a, b)| a != b).count();
                assert_eq!(differ, 0, "pixels by {traversal:?} {primitive:?}");
            }
        }
    });
    assert_valid(&device);
}
