//! Which functions give the same bits here as elsewhere: a checksum for each group of them, over inputs that are the same everywhere. What
//! `examples/words.rs` prints natively must stand in the browser too; a picture that differs is then known by the function that does.

use voxtrace_core::bsdf::{Bsdf, MaterialBsdf};
use voxtrace_core::light::{Lights, Receiver};
use voxtrace_core::math::{cosine_hemisphere, exponential, logarithm, normalize};
use voxtrace_core::medium::{self, phase};
use voxtrace_core::packed::PackedMaterial;
use voxtrace_core::sampler::Sampler;
use voxtrace_core::surface::Surface;
use voxtrace_core::{PackedScene, film::Pixel, walk};
use voxtrace_io::output::{Operator, ToneMap};
use voxtrace_scene::camera::{Lens, Projection};
use voxtrace_scene::glam::{Mat3, Vec2, Vec3};
use voxtrace_scene::material::{encode_srgb, linear_from_srgb};
use voxtrace_scene::{Camera, Hit, Instance, Material, Ray, Scene, Sky, Sun, Transform, VoxelGrid};
use wasm_bindgen::prelude::*;

/// Cases of each group.
const CASES: u32 = 4096;

/// Groups of functions with a checksum of what they give, a line each: `name checksum`. `edge` is that of the scene which some of them read, voxels.
#[wasm_bindgen]
pub fn selftest(edge: u32) -> Vec<String> {
    let scene = PackedScene::pack(&scene_of(edge.clamp(8, 256) as i32)).expect("the scene is sound");
    let (rays, hits) = rays_and_hits(&scene);
    let portrait = scene.portrait(1.5);
    let groups: [(&str, Vec<u32>); 11] = [
        ("sampler", of_cases(|case| case.sampler().stratified(case.0 % 9).to_vec())),
        ("mathematics", of_cases(mathematics)),
        ("sRGB", of_cases(|case| vec![linear_from_srgb(case.byte()), encode_srgb(f64::from(case.u()[1])) as f32])),
        ("tone mapping", of_cases(tone_mapping)),
        ("film", film()),
        ("materials", of_cases(materials)),
        ("media", of_cases(media)),
        ("cameras", of_cases(|case| cameras(case, &portrait))),
        ("scene", scene.content_hash().to_le_bytes().map(u32::from).to_vec()),
        ("walk", hits.iter().flat_map(words_of_hit).collect()),
        ("lights", lights(&scene, &rays, &hits)),
    ];
    groups.iter().map(|(name, words)| format!("{name} {:016x}", checksum(words))).collect()
}

/// FNV-1a of words (Fowler, Noll and Vo 1991).
fn checksum(words: &[u32]) -> u64 {
    words.iter().fold(0xcbf2_9ce4_8422_2325, |sum, &word| (sum ^ u64::from(word)).wrapping_mul(0x0100_0000_01b3))
}

/// A cube of scattered voxels of all kinds of materials, and under it a copy that is turned, smaller and has lamps.
fn scene_of(edge: i32) -> Scene {
    let ([r, g, b, rough], glass) = (Case(1).u(), Material::glass(1.5, 0.2).tinted(Vec3::new(0.9, 0.4, 0.5), 4.0));
    let color = Vec3::new(r, g, b);
    let materials = vec![
        Material::diffuse(color),
        Material::metal(color, rough),
        Material::plastic(color, 0.3),
        glass,
        Material::emissive(color * 20.0),
        Material::cloud(color, 0.2, 0.3),
    ];
    let count = materials.len() as u16;
    let mut scene = Scene { materials, ..Scene::new("selftest") };
    let mut grid = VoxelGrid::default();
    for case in 0..(edge * edge) as u32 {
        let [x, y, z, material] = Case(case).more(7);
        let voxel = (Vec3::new(x, y, z) * edge as f32).floor().as_ivec3();
        grid.set(voxel, (material * f32::from(count)) as u16);
    }
    let (sin, cos) = (0.6, 0.8);
    let linear = Mat3::from_cols(Vec3::new(cos, sin, 0.0), Vec3::new(-sin, cos, 0.0), Vec3::Z) * 0.75;
    let index = scene.add_instance(grid, Transform::IDENTITY);
    let grid = scene.instances[index].grid;
    scene.instances.push(Instance::new(grid, Transform { linear, translation: Vec3::Z * -edge as f32 }));
    let direction = normalize(Vec3::new(0.3, -0.5, 0.7));
    scene.sky = Sky::study(0.8).with_sun(Some(Sun { direction, angular_radius: 0.05, irradiance: Vec3::splat(2.0) }));
    scene
}

/// One case of a group, and its random numbers.
#[derive(Clone, Copy)]
struct Case(u32);

impl Case {
    fn sampler(self) -> Sampler {
        Sampler { seed: 7, pixel: self.0, sample: self.0 % 97 }
    }

    /// Four numbers in [0, 1).
    fn u(self) -> [f32; 4] {
        self.more(0)
    }

    /// Four others.
    fn more(self, dimension: u32) -> [f32; 4] {
        self.sampler().independent(dimension)
    }

    fn byte(self) -> u8 {
        self.0 as u8
    }

    /// A direction above the surface.
    fn direction(self, dimension: u32) -> Vec3 {
        let [u, v, ..] = self.more(dimension);
        normalize(cosine_hemisphere(u, v) + Vec3::Z * 0.01)
    }
}

/// The bits of the numbers that a function gives for all cases.
fn of_cases(function: impl Fn(Case) -> Vec<f32>) -> Vec<u32> {
    (0..CASES).flat_map(|case| function(Case(case))).map(f32::to_bits).collect()
}

fn mathematics(case: Case) -> Vec<f32> {
    let [u, v, w, x] = case.u();
    let direction = cosine_hemisphere(u, v);
    let other = normalize(Vec3::new(u, v, 2.0) - direction);
    let vectors = [direction, other].map(|vector| vector.to_array()).concat();
    [vectors, vec![exponential(-20.0 * w), logarithm(x + 1e-6), u / (v + 0.1), w.sqrt()]].concat()
}

/// To sixteen bits, more than pictures have: powers and logarithms of f64 are the system's, and may differ far below that.
fn tone_mapping(case: Case) -> Vec<f32> {
    let [u, v, w, x] = case.u();
    let exposure = 12.0 * x - 6.0;
    let of = |operator| ToneMap { operator, exposure }.signal(Vec3::new(u, 4.0 * v, 30.0 * w * w));
    Operator::ALL
        .into_iter()
        .flat_map(|operator| of(operator).to_array())
        .map(|value| (value * 65_535.0).round() as f32)
        .collect()
}

fn film() -> Vec<u32> {
    let words = (0..CASES).flat_map(|case| {
        let [u, v, w, x] = Case(case).u();
        let mut pixel = Pixel { radiance: [u64::from(case) << 30; 3], samples: case, covered: case / 2 };
        let scale = exponential(60.0 * x - 30.0);
        pixel.add(Vec3::new(u, v, if case.is_multiple_of(13) { f32::NAN } else { w }) * scale, case.is_multiple_of(3));
        bytemuck::cast::<Pixel, [u32; 8]>(pixel)
    });
    words.collect()
}

/// Each model of materials by itself and mixed, smooth and rough.
fn materials(case: Case) -> Vec<f32> {
    let ([r, g, b, rough], [a, c, d, ior], [u, v, w, _]) = (case.u(), case.more(1), case.more(2));
    let only = |model: u32, share: f32| if case.0 % 5 == 4 { share } else { f32::from(u8::from(case.0 % 5 == model)) };
    let material = PackedMaterial {
        base_color: Vec3::new(r, g, b),
        roughness: if case.0.is_multiple_of(4) { 0.0 } else { rough },
        emission: Vec3::ZERO,
        metallic: only(0, a),
        transmission: only(1, c),
        ior: 1.0 + ior,
        specular: only(2, d),
        anisotropy: 0.0,
        absorption: Vec3::ZERO,
        scattering: 0.0,
    };
    let mut choice = w;
    let bsdf = MaterialBsdf::new(&material, 1.0, &mut choice);
    let (wo, wi) = (case.direction(3), case.direction(4));
    let eval = bsdf.eval(wo, wi);
    let mut numbers = [eval.weight.to_array(), bsdf.albedo().to_array()].concat();
    numbers.push(eval.pdf);
    if let Some(sample) = bsdf.sample(wo, [u, v, choice]) {
        numbers.extend([sample.wi, sample.weight].iter().flat_map(Vec3::to_array));
        numbers.push(sample.pdf);
    }
    numbers
}

fn media(case: Case) -> Vec<f32> {
    let ([r, g, b, scattering], [u, v, w, _]) = (case.u(), case.more(1));
    let glass = Material::glass(1.5, 0.0);
    let absorption = Vec3::new(r, g, b) * 3.0;
    let medium = PackedMaterial::from(&Material { absorption, scattering, anisotropy: w - 0.5, ..glass });
    let (direction, cos) = phase::sample(w - 0.5, case.direction(2), u, v);
    let numbers =
        [medium::unscattered(&medium, 30.0 * w), medium::free_path(&medium, u), cos, phase::pdf(w - 0.5, cos)];
    [medium::attenuation(&medium, 30.0 * w).to_array().to_vec(), direction.to_array().to_vec(), numbers.to_vec()]
        .concat()
}

/// Rays of all lenses.
fn cameras(case: Case, portrait: &Camera) -> Vec<f32> {
    let ([u, v, w, x], [a, b, c, d]) = (case.u(), case.more(1));
    let lens = Lens::from_numbers(case.0 % 5, [1.0 + a, 1.0 + 90.0 * b, (9.0 * c).floor(), 360.0 * d]);
    let camera = Camera { fov_y: 1.0 + 150.0 * w, ..portrait.clone() }.with_lens(lens.unwrap_or_default());
    let ray = camera.frame(1920, 1080).ray(Vec2::new(1920.0 * u, 1080.0 * v), Vec2::new(x, w));
    [ray.origin.to_array(), ray.direction.to_array()].concat()
}

/// Camera rays and rays that leave what they met, and what all of them met.
fn rays_and_hits(scene: &PackedScene) -> (Vec<Ray>, Vec<Hit>) {
    let camera = scene.cameras.first().cloned().unwrap_or_else(|| scene.overview(1.0)).frame(64, 64);
    let ray = |case| {
        let [u, v, ..] = Case(case).u();
        camera.ray(Vec2::new((case % 64) as f32 + u, (case / 64) as f32 + v), Vec2::splat(0.5))
    };
    let mut rays: Vec<Ray> = (0..CASES).map(ray).collect();
    let mut hits = vec![Hit::MISS; rays.len()];
    walk::cast_batch(scene, &rays, &mut hits);
    let bounced = rays.iter().zip(&hits).zip(0..).filter(|((_, hit), _)| !hit.is_miss()).map(|((ray, hit), case)| {
        let surface = Surface::new(scene, ray, hit);
        Ray::new(surface.origin, surface.world_direction(Case(case).direction(5)))
    });
    let bounced: Vec<Ray> = bounced.collect();
    let mut met = vec![Hit::MISS; bounced.len()];
    walk::cast_batch(scene, &bounced, &mut met);
    rays.extend(bounced);
    hits.extend(met);
    (rays, hits)
}

fn words_of_hit(hit: &Hit) -> [u32; 6] {
    let [x, y, z] = hit.voxel.to_array().map(|value| value as u32);
    [hit.t.to_bits(), hit.instance, x, y, z, hit.face]
}

/// The lights that are chosen where rays meet the scene.
fn lights(scene: &PackedScene, rays: &[Ray], hits: &[Hit]) -> Vec<u32> {
    let lights = Lights::new(scene);
    let met = rays.iter().zip(hits).zip(0..).filter(|((_, hit), _)| !hit.is_miss());
    let numbers = met.flat_map(|((ray, hit), case)| {
        let surface = Surface::new(scene, ray, hit);
        let receiver = Receiver::on_surface(surface.origin, surface.normal);
        let sample = lights.sample(&receiver, Case(case).more(6));
        let chosen = sample.map(|sample| {
            let vectors = [sample.ray.direction, sample.radiance].map(|vector| vector.to_array()).concat();
            [vectors, vec![sample.ray.t_max, sample.cos_theta, sample.pdf]].concat()
        });
        let found = [lights.sun_pdf(&receiver, ray.direction), lights.emitter_pdf(&receiver, ray, hit)];
        chosen.unwrap_or_default().into_iter().chain(found)
    });
    numbers.map(f32::to_bits).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_group_gives_the_same_twice_and_a_wrong_bit_is_seen() {
        let lines = selftest(48);
        assert_eq!(lines, selftest(48));
        assert_ne!(lines, selftest(40));
        let mut sums: Vec<_> = lines.iter().filter_map(|line| line.rsplit(' ').next()).collect();
        sums.sort_unstable();
        sums.dedup();
        assert_eq!(sums.len(), lines.len(), "every group has something to say");
        let words = of_cases(mathematics);
        let mut other = words.clone();
        other[77] ^= 1;
        assert_ne!(checksum(&words), checksum(&other));
    }
}
