//! Light of environment maps against suns and furnaces, and the same films from every tracer.

use std::f64::consts::PI;
use std::sync::Arc;
use voxtrace::glam::{IVec3, Vec2, Vec3};
use voxtrace::grid::VoxelBox;
use voxtrace::sky::{Background, Environment, EnvironmentMap, equal_area};
use voxtrace::{
    Camera, CpuTracer, Film, Frame, Integrator, Material, PackedScene, Scene, Sky, Sun, Tracer, Transform, VoxelGrid,
};
use voxtrace_tests::environments::{even_map, lone_texel, noise_map};
use voxtrace_tests::estimate::{Estimate, check_equal, check_same, radiance, render};
use voxtrace_tests::gpu::{assert_valid, device, film, film_methods, for_each_tracer};
use voxtrace_tests::rooms;
use voxtrace_vulkan::{Primitive, Traversal};

fn sky(map: Arc<EnvironmentMap>) -> Sky {
    Sky::new(Background::Environment(Environment::new(map, 0.0)))
}

#[test]
fn one_texel_is_a_sun_of_its_solid_angle() {
    // The middle of a texel, and a sun of as much light there.
    let (edge, at) = (256, (150, 120));
    let middle = Vec2::new(at.0 as f32 + 0.5, at.1 as f32 + 0.5) / edge as f32;
    let direction = equal_area::direction_of(middle);
    assert!(direction.z > 0.5, "it stands above the plain");
    let solid_angle = 4.0 * PI / f64::from(edge * edge);
    let check = |strength: f32| {
        let in_texel = Scene { sky: sky(lone_texel(edge, at, Vec3::splat(4e4 * strength))), ..rooms::open_plain() };
        let irradiance = Vec3::splat((4e4 * solid_angle) as f32);
        let sun = Sun { direction, angular_radius: (solid_angle / PI).sqrt() as f32, irradiance };
        let in_sun = Scene { sky: Sky::uniform(Vec3::ZERO).with_sun(sun), ..rooms::open_plain() };
        let [texel, sun] = [in_texel, in_sun].map(|scene| {
            let frame = rooms::frame(&scene, (24, 24), 64, Integrator::Path);
            radiance(&scene, &frame, 2)
        });
        check_same(&texel, &sun, 0.05)
    };
    check(1.0).unwrap();
    check(1.1).unwrap_err();
}

#[test]
fn a_white_body_in_a_white_map_is_invisible() {
    for integrator in [Integrator::Essay, Integrator::Path] {
        let check = |light: f32| {
            let mut scene = Scene { sky: sky(even_map(8, Vec3::splat(light))), ..rooms::open_plain() };
            scene.materials.iter_mut().for_each(|material| material.base_color = Vec3::ONE);
            let frame = rooms::frame(&scene, (12, 12), 64, integrator).max_bounces(200);
            check_equal(&radiance(&scene, &frame, 2), 1.0)
        };
        check(1.0).unwrap();
        check(1.03).unwrap_err();
    }
}

#[test]
fn a_panorama_of_the_sky_shows_its_panorama() {
    // A picture in which every row and column differs.
    let (width, height) = (64, 32);
    let pixel = |index: u32| Vec3::new((index % width) as f32 / 64.0, (index / width) as f32 / 32.0, 0.5);
    let pixels: Vec<Vec3> = (0..width * height).map(pixel).collect();
    let map = EnvironmentMap::from_panorama(width, height, &pixels).unwrap();
    let scene = Scene { sky: sky(Arc::new(map)), ..Scene::new("nothing but sky") };
    let packed = Arc::new(PackedScene::pack(&scene).unwrap());
    let camera = Camera::look_at(Vec3::ZERO, Vec3::Y).with_lens(voxtrace::camera::Lens::Panorama { eye_distance: 0.0 });
    let film = render(&packed, &Frame::new(camera, width, height).samples(64));
    let worst = |shift: usize| {
        let inside =
            (0..pixels.len()).filter(|index| (2..62).contains(&(index % 64)) && (3..29).contains(&(index / 64)));
        let errors = inside.map(|index| (film.pixels[index + shift].mean() - pixels[index]).abs().max_element());
        errors.fold(0.0, f32::max)
    };
    assert!(worst(0) < 0.03, "{}", worst(0));
    assert!(worst(2) > 0.03, "two pixels to the side are noticed: {}", worst(2));
}

#[test]
fn a_map_s_sun_makes_no_fireflies() {
    let scene = Scene { sky: sky(lone_texel(256, (150, 120), Vec3::splat(4e4))), ..rooms::open_plain() };
    let packed = Arc::new(PackedScene::pack(&scene).unwrap());
    let brightest = |integrator| {
        let film = render(&packed, &rooms::frame(&scene, (48, 48), 16, integrator));
        film.pixels.iter().map(|pixel| pixel.mean().max_element()).fold(0.0, f32::max)
    };
    // White in this sun is 2.4; nothing in the picture looks into it.
    let (path, essay) = (brightest(Integrator::Path), brightest(Integrator::Essay));
    assert!(path < 4.0, "{path}");
    assert!(essay > 100.0, "surfaces alone find it as a firefly: {essay}");
}

/// A cube of a cloud before a camera that sees nothing else, under a map.
fn cloud_under(sky: Sky) -> (Scene, Frame) {
    let mut grid = VoxelGrid::new();
    grid.fill_box(VoxelBox { min: IVec3::splat(-8), max: IVec3::splat(8) }, 0);
    let scene = Scene { sky, ..Scene::from_grid("cloud", grid, vec![Material::cloud(Vec3::ONE, 0.2, 0.4)]) };
    let camera = Camera::look_at(Vec3::new(40.0, -50.0, 9.0), Vec3::ZERO);
    let frame = Frame::new(Camera { fov_y: 12.0, ..camera }, 12, 12).integrator(Integrator::Path).max_bounces(200);
    (scene, frame)
}

#[test]
fn a_white_cloud_in_a_white_map_is_invisible() {
    let check = |light: f32| {
        let (scene, frame) = cloud_under(sky(even_map(8, Vec3::splat(light))));
        let found = radiance(&scene, &frame.samples(256), 2);
        let expected = Estimate { mean: 1.0, standard_error: 0.0 };
        check_same(&found, &vec![expected; found.len()], 0.03)
    };
    check(1.0).unwrap();
    check(1.05).unwrap_err();
}

#[test]
fn a_cloud_gets_the_sun_beside_a_map_and_devices_make_the_same_film_of_it() {
    let sun = Sun::at(200.0, 35.0, 2.0);
    let (with_sun, frame) = cloud_under(sky(even_map(8, Vec3::splat(0.01))).with_sun(sun));
    let (without, _) = cloud_under(Sky::uniform(Vec3::splat(0.01)).with_sun(sun));
    let [map, flat] = [&with_sun, &without].map(|scene| radiance(scene, &frame.clone().samples(256), 1));
    check_same(&map, &flat, 0.05).unwrap();
    let (scene, frame) = cloud_under(sky(noise_map(32, 3)).with_sun(sun));
    let (scene, frame) = (Arc::new(PackedScene::pack(&scene).unwrap()), frame.max_bounces(8).samples(3));
    let expected = render(&scene, &frame);
    let Some(device) = device() else { return };
    let walk = [(Traversal::Walk, Primitive::Brick)];
    for_each_tracer(&device, &film_methods(&device, &walk), &scene, |tracer, traversal, _| {
        assert!(film(tracer, &frame) == expected, "{traversal:?}");
    });
    assert_valid(&device);
}

/// Lamps and plains under maps, with a sun and without, and a black map.
fn skies() -> Vec<Arc<PackedScene>> {
    let sun = Sun::at(200.0, 35.0, 2.0);
    let turned = |map, rotation| Sky::new(Background::Environment(Environment::new(map, rotation)));
    let skies = [
        (turned(noise_map(32, 3), 0.0), false),
        (turned(noise_map(37, 4), 200.0).with_brightness(0.4).with_sun(sun), true),
        (turned(even_map(16, Vec3::ZERO), 0.0).with_sun(sun), false),
    ];
    let scenes = skies.into_iter().map(|(sky, has_lamp)| {
        let mut scene = Scene { sky, ..rooms::open_plain() };
        if !has_lamp {
            return scene;
        }
        let mut lamp = VoxelGrid::new();
        lamp.set(IVec3::ZERO, scene.materials.len() as u16);
        scene.materials.push(Material::emissive(Vec3::new(300.0, 200.0, 90.0)));
        scene.add_instance(lamp, Transform::from_translation(Vec3::new(20.0, 20.0, 14.0)));
        scene
    });
    scenes.map(|scene| Arc::new(PackedScene::pack(&scene).unwrap())).collect()
}

#[test]
fn every_tracer_makes_the_same_film_under_every_map() {
    let scenes = skies();
    let frames = [Integrator::Essay, Integrator::Path]
        .map(|integrator| rooms::frame(&rooms::open_plain(), (24, 18), 3, integrator));
    let mut cpu = CpuTracer::new(None);
    let mut films_of = |scene: &Arc<PackedScene>| {
        cpu.set_scene(scene).unwrap();
        frames.each_ref().map(|frame| film(&mut cpu, frame))
    };
    let expected: Vec<[Film; 2]> = scenes.iter().map(&mut films_of).collect();
    for (index, films) in expected.iter().enumerate() {
        assert!(expected[..index].iter().all(|others| others[1] != films[1]), "each scene makes another film");
    }
    let Some(device) = device() else { return };
    let few = [Traversal::Walk, Traversal::Query, Traversal::Pipeline].map(|traversal| (traversal, Primitive::Brick));
    for_each_tracer(&device, &film_methods(&device, &few), &scenes[0], |tracer, traversal, primitive| {
        for (scene, expected) in scenes.iter().zip(&expected) {
            tracer.set_scene(scene).unwrap();
            for (frame, expected) in frames.iter().zip(expected) {
                assert!(film(tracer, frame) == *expected, "{traversal:?} {primitive:?} {:?}", scene.sky);
            }
        }
        // The same arrays under another map: only the map is uploaded.
        let mut lit = (*scenes[0]).clone();
        lit.sky = scenes[2].sky.clone();
        tracer.set_scene(&scenes[0]).unwrap();
        tracer.set_scene(&Arc::new(lit)).unwrap();
        assert!(film(tracer, &frames[1]) == expected[2][1], "{traversal:?} under another map");
    });
    assert_valid(&device);
}
