//! Places on surfaces, and the choice of lights there.

use super::{Group, hit, hit_words, ray, ray_words, vector, words};
use std::sync::Arc;
use voxtrace::glam::{IVec3, Mat3, Vec3};
use voxtrace::{Hit, Instance, Material, PackedScene, Ray, Scene, Sky, Sun, Transform};
use voxtrace_core::light::{Lights, Receiver};
use voxtrace_core::math::{cosine_hemisphere, normalize};
use voxtrace_core::surface::Surface;
use voxtrace_core::walk;
use voxtrace_tests::random::Random;
use voxtrace_tests::scenes::noise;

/// Turned, mirrored and scaled instances of a grid with many lamps, under a sun.
fn lamps(has_sun: bool) -> Arc<PackedScene> {
    let mut random = Random(3);
    let lamp = |strength: f32| Material::emissive(Vec3::new(1.0, 0.5, 2.0) * strength);
    let materials = vec![Material::default(), Material::default(), lamp(1.0), lamp(7.0)];
    let mut scene = Scene { materials, light_intensity: 1.5, ..Scene::new("lamps") };
    let direction = Vec3::new(0.3, -0.5, 0.7).normalize();
    let sun = Sun { direction, angular_radius: 0.05, irradiance: Vec3::new(2.0, 1.9, 1.8) };
    scene.sky = Sky::study(0.8).with_sun(has_sun.then_some(sun));
    for index in 0..6u64 {
        let turned = Mat3::from_axis_angle(random.direction(), random.unit() * 6.0);
        let linear = [Mat3::IDENTITY, turned, turned * -0.6][(index / 2) as usize];
        let translation = random.point(Vec3::splat(-30.0), Vec3::splat(30.0));
        // Two instances show each grid, and share the tree over its lamps.
        if index < 3 {
            scene.grids.push(noise(IVec3::splat(-8), 16, 0.1, 4, index).into());
        }
        scene.instances.push(Instance::new(index as usize % 3, Transform { linear, translation }));
    }
    Arc::new(PackedScene::pack(&scene).expect("the scene is sound"))
}

/// Rays from anywhere, and what they meet.
fn hits(scene: &PackedScene, count: usize) -> Vec<(Ray, Hit)> {
    let mut random = Random(5);
    let mut ray = || Ray::new(random.point(Vec3::splat(-50.0), Vec3::splat(50.0)), random.direction());
    (0..)
        .map(|_| ray())
        .map(|ray| (ray, walk::cast(scene, &ray)))
        .filter(|(_, hit)| !hit.is_miss())
        .take(count)
        .collect()
}

#[test]
fn surfaces_are_the_same() {
    let scene = lamps(false);
    let mut random = Random(6);
    let mut inputs = Vec::new();
    for (ray, hit) in hits(&scene, 16_384) {
        let local = cosine_hemisphere(random.unit(), random.unit());
        inputs.extend(ray_words(&ray).chain(hit_words(&hit)).chain(words(local.to_array())));
    }
    let place = |ray: &Ray, hit: &Hit, local| {
        let surface = Surface::new(&scene, ray, hit);
        let (world, back) = (surface.world_direction(local), surface.local_direction(local));
        let vectors = [surface.origin, surface.normal, world, back];
        words(vectors.iter().flat_map(Vec3::to_array)).collect::<Vec<u32>>()
    };
    let group = Group { entry: "check_surface", scene: &scene, words: (17, 12), inputs };
    group.check(
        |case| place(&ray(case), &hit(&case[8..]), vector(&case[14..])),
        // The place where the f32 ray is, without regard to the face.
        |case| {
            let (ray, hit) = (ray(case), hit(&case[8..]));
            let mut output = place(&ray, &hit, vector(&case[14..]));
            output.splice(..3, words(ray.at(hit.t).to_array()));
            output
        },
    );
}

#[test]
fn lights_are_chosen_the_same_way() {
    for has_sun in [true, false] {
        let scene = lamps(has_sun);
        let mut random = Random(8);
        let mut inputs = Vec::new();
        let all = hits(&scene, 8192);
        for (ray, hit) in &all {
            // The place that the ray leaves, as after a bounce, or one where it arrives.
            let surface = Surface::new(&scene, ray, hit);
            let (point, normal) = match random.below(2) {
                0 => (ray.origin, normalize(ray.direction + random.direction())),
                _ => (surface.origin, surface.normal),
            };
            let u = std::array::from_fn::<f32, 4, _>(|_| random.unit());
            inputs.extend(words([point.to_array(), normal.to_array()].concat()).chain(words(u)));
            inputs.extend(ray_words(ray).chain(hit_words(hit)));
        }
        let choose = |case: &[u32], u: [f32; 4]| {
            let lights = Lights::new(&scene);
            let receiver = Receiver::on_surface(vector(case), vector(&case[3..]));
            let (ray, hit) = (ray(&case[10..]), hit(&case[18..]));
            let (mut output, mut direction) = (vec![0; 10], Vec3::ZERO);
            if let Some(sample) = lights.sample(&receiver, u) {
                direction = sample.ray.direction;
                let numbers = [&sample.ray.direction.to_array()[..], &[sample.ray.t_max, sample.cos_theta]];
                let light = [&sample.radiance.to_array()[..], &[sample.pdf]];
                output = std::iter::once(1).chain(words([numbers, light].concat().concat())).collect();
            }
            output.extend(words([lights.sun_pdf(&receiver, direction), lights.emitter_pdf(&receiver, &ray, &hit)]));
            output
        };
        let numbers = |case: &[u32]| [6, 7, 8, 9].map(|at| f32::from_bits(case[at]));
        let group = Group { entry: "check_light", scene: &scene, words: (24, 12), inputs };
        group.check(
            |case| choose(case, numbers(case)),
            // The two numbers that place the point on the face, exchanged.
            |case| {
                let [a, b, c, d] = numbers(case);
                choose(case, [a, b, d, c])
            },
        );
        let meets_lamp = |(_, hit): &&(Ray, Hit)| scene.material(hit).emission.x > 0.0;
        assert!(all.iter().filter(meets_lamp).count() > 1000, "many rays meet lamps");
    }
}
