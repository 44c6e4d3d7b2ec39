//! Light groups: they add up to the picture, sample by sample, on every tracer with the same bits.

use std::sync::Arc;
use voxtrace::film::Pixel;
use voxtrace::glam::{IVec3, Vec3};
use voxtrace::grid::VoxelBox;
use voxtrace::output::{FilmFile, SceneStamp};
use voxtrace::sky::{Background, Environment, EnvironmentMap};
use voxtrace::{
    Camera, Film, Frame, Integrator, LightGroup, Material, PackedScene, Progress, Region, Scene, Sky, Sun, TraceError,
    Tracer, VoxelGrid,
};
use voxtrace_tests::estimate::render;
use voxtrace_tests::gpu::{ONE_OF_EACH, assert_valid, device, film, film_methods, for_each_tracer};

/// A floor with blocks and lamps, lit by all three: by a sun, and by a sky that is a gradient or a map whose directions are chosen.
fn scene(has_map: bool, block: Material) -> Scene {
    let mut grid = VoxelGrid::new();
    let mut fill = |min: [i32; 3], max: [i32; 3], material| {
        grid.fill_box(VoxelBox { min: IVec3::from(min), max: IVec3::from(max) }, material);
    };
    fill([-12, -12, -1], [12, 12, 0], 0);
    fill([-6, 2, 0], [-1, 6, 5], 1);
    fill([3, -4, 0], [6, 2, 4], 2);
    fill([-3, -5, 3], [-1, -3, 4], 3);
    let materials = vec![
        Material::diffuse(Vec3::new(0.6, 0.5, 0.4)),
        block,
        Material::diffuse(Vec3::new(0.2, 0.4, 0.7)),
        Material::emissive(Vec3::new(9.0, 8.0, 6.0)),
    ];
    let texel = |index: u32| Vec3::new(0.2, 0.3, 0.5) * if index == 27 { 40.0 } else { 1.0 };
    let texels: Vec<Vec3> = (0..64).map(texel).collect();
    let background = match has_map {
        true => Background::Environment(Environment::new(EnvironmentMap::new(8, &texels).unwrap().into(), 30.0)),
        false => Sky::gradient(Vec3::new(0.2, 0.15, 0.1), Vec3::new(0.4, 0.6, 0.9)).background().clone(),
    };
    let direction = Vec3::new(0.4, -0.3, 0.8).normalize();
    let sun = Sun { direction, angular_radius: 0.05, irradiance: Vec3::splat(2.0) };
    let sky = Sky::new(background).with_brightness(1.5).with_sun(sun);
    let mut scene = Scene { sky, light_intensity: 2.0, ..Scene::from_grid("groups", grid, materials) };
    scene.cameras.push(Camera::look_at(Vec3::new(3.0, -26.0, 17.0), Vec3::new(0.0, 0.0, 1.0)));
    scene
}

fn frame(scene: &Scene) -> Frame {
    Frame::new(scene.cameras[0].clone(), 32, 24).samples(4).max_bounces(5)
}

/// Largest difference between the pixels of a film and the sum of others, over the largest sum.
fn left_over<'a>(whole: &Film, parts: impl Iterator<Item = &'a [Pixel]>) -> f64 {
    let mut rest: Vec<[f64; 3]> = whole.pixels.iter().map(|pixel| pixel.radiance.map(|sum| sum as f64)).collect();
    let largest = rest.iter().flatten().copied().fold(0.0, f64::max);
    for part in parts {
        for (rest, pixel) in rest.iter_mut().zip(part) {
            (0..3).for_each(|channel| rest[channel] -= pixel.radiance[channel] as f64);
        }
    }
    rest.iter().flatten().map(|rest| rest.abs()).fold(0.0, f64::max) / largest
}

#[test]
fn the_samples_of_the_groups_add_up_to_those_of_the_picture() {
    for (has_map, block) in [
        (false, Material::diffuse(Vec3::splat(0.7))),
        (true, Material::diffuse(Vec3::splat(0.7))),
        (true, Material::glass(1.5, 0.0)),
        (false, Material::plastic(Vec3::new(0.8, 0.2, 0.1), 0.3)),
    ] {
        let scene = scene(has_map, block);
        let frame = frame(&scene);
        let packed = Arc::new(PackedScene::pack(&scene).unwrap());
        let whole = render(&packed, &frame);
        let of = |group| render(&packed, &frame.clone().light_group(group));
        let groups = LightGroup::PARTS.map(of);
        assert!(groups.iter().all(|group| group.pixels.iter().any(|pixel| pixel.radiance[0] > 0)));
        let parts = || groups.iter().map(|group| &group.pixels[..]);
        let rest = left_over(&whole, parts());
        assert!(rest < 1e-6, "{rest} is left of {block:?}");
        // A group too few, and one of other paths.
        let missing = left_over(&whole, parts().skip(1));
        let other = render(&packed, &frame.clone().seed(9).light_group(LightGroup::Sky));
        let strange = left_over(&whole, [&groups[0].pixels[..], &other.pixels, &groups[2].pixels].into_iter());
        assert!(missing > 0.01 && strange > 0.01, "{missing} {strange}");
    }
}

#[test]
fn every_tracer_makes_the_same_films_of_each_group() {
    let Some(device) = device() else { return };
    let scene = scene(true, Material::diffuse(Vec3::splat(0.7)));
    let packed = Arc::new(PackedScene::pack(&scene).unwrap());
    for_each_tracer(&device, &film_methods(&device, &ONE_OF_EACH), &packed, |tracer, traversal, _| {
        let mut last = Film::new(1, 1, Region::full(1, 1), 0);
        for group in [LightGroup::Sun, LightGroup::Sky, LightGroup::Emitters, LightGroup::All] {
            let frame = frame(&scene).light_group(group);
            let found = film(tracer, &frame);
            let differ = found.pixels != render(&packed, &frame).pixels;
            assert!(!differ, "{group:?} by {traversal:?}");
            assert!(found.pixels != last.pixels, "another group is another film");
            last = found;
        }
    });
    assert_valid(&device);
}

#[test]
fn films_with_groups_are_kept_and_merged_to_the_bit() {
    let scene = scene(false, Material::diffuse(Vec3::splat(0.7)));
    let packed = Arc::new(PackedScene::pack(&scene).unwrap());
    let with_groups = |frame: Frame| {
        let groups = LightGroup::PARTS.map(|group| (group, render(&packed, &frame.clone().light_group(group)).pixels));
        FilmFile {
            film: Film { groups: groups.into(), ..render(&packed, &frame) },
            frame,
            scene: SceneStamp::of(&packed),
        }
    };
    let whole = with_groups(frame(&scene));
    let bytes = whole.to_bytes();
    assert_eq!(FilmFile::from_bytes(&bytes).unwrap(), whole);
    let mut parts = [(0, 1), (1, 3)].map(|(first, count)| {
        let part = with_groups(frame(&scene).first_sample(first).samples(count));
        FilmFile::from_bytes(&part.to_bytes()).unwrap().film
    });
    let [sum, rest] = &mut parts;
    let without = Film { groups: Vec::new(), ..rest.clone() };
    assert!(sum.clone().merge(&without).is_err(), "groups would be lost");
    sum.merge(rest).unwrap();
    assert_eq!((&sum.pixels, &sum.groups), (&whole.film.pixels, &whole.film.groups));

    // Damaged: one byte of a group, a group that is there twice.
    let mut damaged = bytes.clone();
    let place = bytes.len() - 100;
    damaged[place] ^= 1;
    assert!(FilmFile::from_bytes(&damaged).is_err());
    let mut twice = whole.clone();
    twice.film.groups[1].0 = twice.film.groups[0].0;
    assert!(FilmFile::from_bytes(&twice.to_bytes()).is_err());
}

#[test]
fn the_study_s_integrator_has_no_groups() {
    let scene = scene(false, Material::diffuse(Vec3::splat(0.7)));
    let mut tracer = voxtrace::CpuTracer::new(None);
    tracer.set_scene(&Arc::new(PackedScene::pack(&scene).unwrap())).unwrap();
    let essay = frame(&scene).integrator(Integrator::Essay);
    let result = tracer.render(&essay.clone().light_group(LightGroup::Sun), &Progress::default());
    assert!(matches!(result, Err(TraceError::BadFrame(_))), "{result:?}");
    tracer.render(&essay, &Progress::default()).unwrap();
}
