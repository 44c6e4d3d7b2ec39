//! The seams of light transport: materials, what shines from infinitely far away, projections.

use super::{Group, empty, numbers, ray_words, vector, words};
use std::sync::Arc;
use voxtrace::camera::{Axes, CameraFrame, Fisheye, Lens, Orthographic, Panorama, Perspective, Projection, ThinLens};
use voxtrace::glam::{Vec2, Vec2Swizzles, Vec3};
use voxtrace::packed::PackedMaterial;
use voxtrace::sky::{Background, Environment, Gradient, equal_area};
use voxtrace::{Camera, Material, PackedScene, Scene, Sky, Sun};
use voxtrace_core::bsdf::{Bsdf, BsdfSample, MaterialBsdf};
use voxtrace_core::light::{DistantLight, Lights, Receiver};
use voxtrace_core::math::normalize;
use voxtrace_core::medium::{self, phase};
use voxtrace_tests::environments::noise_map;
use voxtrace_tests::random::Random;
use voxtrace_vulkan::records::{FrameParams, LENS_FISHEYE, LENS_ORTHOGRAPHIC, LENS_PANORAMA, LENS_PINHOLE, LENS_THIN};

#[test]
fn materials_scatter_the_same_way() {
    let mut random = Random(11);
    let mut inputs = Vec::new();
    for case in 0..16_384 {
        // Base colour, roughness, emission, metalness, transmission, index of refraction, coat, anisotropy, absorption, scattering; of
        // half of the materials one model is left, and of some the surface is smooth.
        let mut material: [f32; 16] = std::array::from_fn(|at| random.unit() + f32::from(u8::from(at == 9)));
        let (model, is_smooth) = (case % 8, case / 8 % 4 == 0);
        for at in [7, 8, 10] {
            material[at] = if model < 4 { f32::from(u8::from(at == [7, 8, 10, 0][model])) } else { material[at] };
        }
        material[3] = if is_smooth { 0.05 } else { material[3] };
        let upwards = |direction: Vec3| direction * direction.z.signum();
        let (wo, wi) = (upwards(random.direction()), random.direction());
        let u: [f32; 3] = std::array::from_fn(|at| if case % 64 == at { 0.0 } else { random.unit() });
        inputs.extend(words([&material[..], &wo.to_array(), &u, &wi.to_array()].concat()));
    }
    let scatter = |case: &[u32], u: [f32; 3]| {
        let number = |at: usize| f32::from_bits(case[at]);
        let material = PackedMaterial {
            base_color: vector(case),
            roughness: number(3),
            emission: vector(&case[4..]),
            metallic: number(7),
            transmission: number(8),
            ior: number(9),
            specular: number(10),
            anisotropy: number(11),
            absorption: vector(&case[12..]),
            scattering: number(15),
        };
        let [a, b, mut choice] = u;
        let bsdf = MaterialBsdf::new(&material, 1.0, &mut choice);
        let (wo, wi) = (vector(&case[16..]), vector(&case[22..]));
        let (sample, eval) = (bsdf.sample(wo, [a, b, choice]), bsdf.eval(wo, wi));
        let mut output = vec![sample.is_some().into()];
        let sample = sample.unwrap_or(BsdfSample { wi: Vec3::Z, weight: Vec3::ZERO, pdf: 0.0, is_delta: false });
        output.extend(words(flat(&[sample.wi, sample.weight])));
        output.extend([sample.pdf.to_bits(), sample.is_delta.into()]);
        output.extend(words(eval.weight.to_array().into_iter().chain([eval.pdf]).chain(bsdf.albedo().to_array())));
        output
    };
    let u = |case: &[u32]| vector(&case[19..]).to_array();
    let group = Group { entry: "check_bsdf", scene: &empty(), words: (25, 16), inputs };
    group.check(
        |case| scatter(case, u(case)),
        // The two numbers of the direction, exchanged.
        |case| {
            let [a, b, c] = u(case);
            scatter(case, [b, a, c])
        },
    );
}

#[test]
fn media_attenuate_and_scatter_the_same_way() {
    let mut random = Random(13);
    let mut inputs = Vec::new();
    for case in 0..16_384 {
        let coefficients: [f32; 4] = std::array::from_fn(|_| random.unit() * 3.0);
        let anisotropy = if case % 16 == 0 { 1e-4 } else { 1.9 * random.unit() - 0.95 };
        // Up to the longest ways that leave anything.
        let voxels = random.unit() * if case % 2 == 0 { 1.0 } else { 100.0 };
        let u: [f32; 3] = std::array::from_fn(|at| if case % 64 == at { 0.0 } else { random.unit() });
        let cos = 2.0 * u[2] - 1.0;
        let numbers = [&coefficients[..], &[anisotropy, voxels], &random.direction().to_array(), &u[..2], &[cos]];
        inputs.extend(words(numbers.concat()));
    }
    let scatter = |case: &[u32], [u, v]: [f32; 2]| {
        let number = |at: usize| f32::from_bits(case[at]);
        let (absorption, scattering, anisotropy) = (vector(case), number(3), number(4));
        let material = Material { absorption, scattering, anisotropy, ..Material::glass(1.5, 0.0) };
        let medium = PackedMaterial::from(&material);
        let (direction, cos) = phase::sample(anisotropy, vector(&case[6..]), u, v);
        let attenuation = medium::attenuation(&medium, number(5));
        let way = [medium::unscattered(&medium, number(5)), medium::free_path(&medium, u)];
        words(
            [&flat(&[attenuation])[..], &way, &direction.to_array(), &[cos, phase::pdf(anisotropy, number(11))]]
                .concat(),
        )
    };
    let u = |case: &[u32]| [f32::from_bits(case[9]), f32::from_bits(case[10])];
    let group = Group { entry: "check_medium", scene: &empty(), words: (12, 10), inputs };
    group.check(
        |case| scatter(case, u(case)).collect(),
        |case| {
            let [u, v] = u(case);
            scatter(case, [v, u]).collect()
        },
    );
}

/// A scene of nothing but a sky, a gradient or a map, and a low sun.
fn sunny(sun_radius: f32, map: Option<Environment>) -> Arc<PackedScene> {
    let direction = Vec3::new(0.3, -0.5, 0.2).normalize();
    let sun = Sun { direction, angular_radius: sun_radius, irradiance: Vec3::new(2.0, 1.9, 1.8) };
    let gradient = Gradient { nadir: Vec3::new(0.2, 0.1, 0.4), zenith: Vec3::new(0.3, 0.9, 1.7) };
    let background = map.map_or(Background::Gradient(gradient), Background::Environment);
    let sky = Sky::new(background).with_brightness(0.7).with_sun(sun);
    Arc::new(PackedScene::pack(&Scene { sky, ..Scene::new("sunny") }).expect("the scene is sound"))
}

#[test]
fn sun_and_sky_shine_the_same_way() {
    let turned = |edge, rotation| Some(Environment::new(noise_map(edge, 5), rotation));
    for (sun_radius, map) in [(0.01, None), (0.4, None), (0.4, turned(64, 0.0)), (0.01, turned(37, 123.0))] {
        let has_map = map.is_some();
        let scene = sunny(sun_radius, map);
        let lights = Lights::new(&scene);
        let sun = lights.sun.as_ref().expect("there is a sun");
        let mut random = Random(12);
        let mut inputs = Vec::new();
        for _ in 0..16_384 {
            let receiver = [random.point(Vec3::splat(-9.0), Vec3::splat(9.0)), random.direction()];
            let u: [f32; 4] = std::array::from_fn(|_| random.unit());
            // Inside the disc, near its rim, and anywhere.
            let near = normalize(sun.direction + random.direction() * sun_radius * 1.5 * random.unit());
            let direction = if random.below(3) == 0 { random.direction() } else { near };
            inputs.extend(words(flat(&receiver).into_iter().chain(u).chain(direction.to_array())));
        }
        let shine = |case: &[u32], u: [f32; 4]| {
            let receiver = Receiver::on_surface(vector(case), vector(&case[3..]));
            let direction = vector(&case[10..]);
            let sample = sun.sample(&receiver, u);
            let of_sky = lights.sky.sample(&receiver, u);
            let mut output = vec![sample.is_some().into()];
            let numbers = [
                &sample.map_or(Vec3::ZERO, |sample| sample.ray.direction).to_array()[..],
                &sun.le(direction).to_array(),
                &[sun.pdf(direction)],
                &lights.sky.le(direction).to_array(),
                &[
                    lights.sky.pdf(direction),
                    lights.sun_pdf(&receiver, direction),
                    lights.sky_pdf(&receiver, direction),
                ],
            ];
            output.extend(words(numbers.concat()));
            output.push(of_sky.is_some().into());
            let chosen = of_sky.map_or([Vec3::ZERO; 2], |sample| [sample.ray.direction, sample.radiance]);
            output.extend(words(flat(&chosen).into_iter().chain([of_sky.map_or(0.0, |sample| sample.pdf)])));
            output
        };
        let u = |case: &[u32]| [6, 7, 8, 9].map(|at| f32::from_bits(case[at]));
        let in_disc = inputs.chunks(13).filter(|case| sun.contains(vector(&case[10..]))).count();
        let from_sky = |case: &[u32]| {
            let receiver = Receiver::on_surface(vector(case), vector(&case[3..]));
            lights.sky.sample(&receiver, u(case)).is_some()
        };
        let chosen = inputs.chunks(13).filter(|case| from_sky(case)).count();
        assert!(if has_map { chosen > 4000 } else { chosen == 0 }, "{chosen} directions of the sky");
        assert!(in_disc > 1000 && in_disc < 15_000, "{in_disc} directions in the disc");
        let group = Group { entry: "check_distant_light", scene: &scene, words: (13, 22), inputs };
        group.check(
            |case| shine(case, u(case)),
            |case| {
                let [a, b, c, d] = u(case);
                shine(case, [b, a, d, c])
            },
        );
    }
}

#[test]
fn places_of_environment_maps_are_the_same() {
    let mut random = Random(14);
    let mut inputs = Vec::new();
    for case in 0..16_384 {
        let direction = match case % 8 {
            // Poles, seams, and near them.
            0 => Vec3::Z * if random.below(2) == 0 { 1.0 } else { -1.0 },
            1 => normalize(random.direction() * Vec3::new(1.0, 1e-5, 1.0)),
            2 => normalize(random.direction() * Vec3::new(1.0, 1.0, 1e-6)),
            _ => random.direction(),
        };
        inputs.extend(words(direction.to_array().into_iter().chain([random.unit(), random.unit()])));
    }
    let map = |case: &[u32], place: Vec2| {
        let there = equal_area::square_of(vector(case));
        let direction = equal_area::direction_of(place);
        words([there.to_array().to_vec(), direction.to_array().to_vec()].concat()).collect::<Vec<u32>>()
    };
    let place = |case: &[u32]| Vec2::from_slice(&numbers(&case[3..5]));
    let group = Group { entry: "check_equal_area", scene: &empty(), words: (5, 5), inputs };
    group.check(|case| map(case, place(case)), |case| map(case, place(case).yx()));
}

#[test]
fn cameras_send_the_same_rays() {
    let mut random = Random(13);
    let mut inputs = Vec::new();
    let (width, height) = (1980, 1080);
    for case in 0..16_384 {
        let mut point = || random.point(Vec3::splat(-900.0), Vec3::splat(900.0));
        let camera = Camera { up: point(), ..Camera::look_at(point(), point()) };
        let numbers =
            [0.1 + 99.0 * random.unit(), 1.0 + 300.0 * random.unit(), random.below(9) as f32, 360.0 * random.unit()];
        let lens = Lens::from_numbers(case % 5, numbers).unwrap_or_default();
        let camera = Camera { fov_y: 1.0 + 170.0 * random.unit(), ..camera }.with_lens(lens);
        let frame = FrameParams::default().with_camera(&camera.frame(width, height));
        let FrameParams { lens, eye, corner, pixel_x, pixel_y, lens_x, lens_y, blades, .. } = frame;
        inputs.push(lens);
        inputs.extend(words(flat(&[eye, corner, pixel_x, pixel_y, lens_x, lens_y])));
        inputs.push(blades);
        // The middle of picture and lens is a place of its own.
        let place = [random.unit() * width as f32, random.unit() * height as f32, random.unit(), random.unit()];
        inputs.extend(words(if case % 97 == 0 { [990.0, 540.0, 0.5, 0.5] } else { place }));
    }
    let send = |case: &[u32], [x, y]: [f32; 2]| {
        let lens = Vec2::from_slice(&numbers(&case[22..24]));
        ray_words(&camera_of(case).ray(Vec2::new(x, y), lens)).collect::<Vec<u32>>()
    };
    let group = Group { entry: "check_camera", scene: &empty(), words: (24, 8), inputs };
    let place = |case: &[u32]| [f32::from_bits(case[20]), f32::from_bits(case[21])];
    group.check(
        |case| send(case, place(case)),
        |case| {
            let [x, y] = place(case);
            send(case, [y, x])
        },
    );
}

/// The camera of a case: the inverse of `FrameParams::with_camera`.
fn camera_of(case: &[u32]) -> CameraFrame {
    let [eye, corner, pixel_x, pixel_y, lens_x, lens_y] = std::array::from_fn(|at| vector(&case[1 + 3 * at..]));
    let perspective = Perspective { eye, corner, pixel_x, pixel_y };
    let axes = Axes { forward: corner, right: pixel_x, up: pixel_y };
    match case[0] {
        LENS_PINHOLE => CameraFrame::Perspective(perspective),
        LENS_THIN => CameraFrame::ThinLens(ThinLens { perspective, lens_x, lens_y, blades: case[19] }),
        LENS_ORTHOGRAPHIC => CameraFrame::Orthographic(Orthographic { corner, pixel_x, pixel_y, forward: lens_x }),
        LENS_PANORAMA => {
            CameraFrame::Panorama(Panorama { eye, axes, inverse_size: lens_x.truncate(), half_eye_distance: lens_x.z })
        }
        LENS_FISHEYE => {
            CameraFrame::Fisheye(Fisheye { eye, axes, middle: lens_x.truncate(), turns_per_pixel: lens_x.z })
        }
        other => panic!("lens {other}"),
    }
}

/// The numbers of several vectors.
fn flat(vectors: &[Vec3]) -> Vec<f32> {
    vectors.iter().flat_map(Vec3::to_array).collect()
}
