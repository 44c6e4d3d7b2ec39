//! The hits of a million rays a scene, as a checksum, with each set of vector instructions that the processor has (but arrays, which are slow
//! and tested elsewhere) and ray after ray, and their speed on one core.
//! Runs wherever Rust runs, so that processors that are not at hand can be compared: natively, under an emulator, in Node.
//! `cargo run --release -p voxtrace-scenes --example instructions -- [VOXELS]`; the checksums of a scene must all be the same, on every machine.

use std::time::Instant;
use voxtrace_core::math::cosine_hemisphere;
use voxtrace_core::sampler::Sampler;
use voxtrace_core::surface::Surface;
use voxtrace_core::{Instructions, PackedScene, walk};
use voxtrace_scene::glam::Vec2;
use voxtrace_scene::{Hit, Ray};

/// Rays of a scene.
const RAYS: usize = 1_000_000;
/// Rays that the CPU tracer casts at a time.
const WAVE: usize = 4096;
/// Edge of the blocks in which camera rays follow each other, pixels.
const BLOCK: usize = 8;
/// Camera rays: a square picture.
const EDGE: usize = 576;

/// Camera rays, block by block, and bounces from what they meet until there are enough.
fn rays_of(scene: &PackedScene) -> Vec<Ray> {
    let camera = scene.cameras[0].frame(EDGE as u32, EDGE as u32);
    let sampler = |index: usize| Sampler { seed: 0, pixel: index as u32, sample: 0 };
    let camera_ray = |index: usize| {
        let (block, within) = (index / (BLOCK * BLOCK), index % (BLOCK * BLOCK));
        let (x, y) = (block % (EDGE / BLOCK) * BLOCK + within % BLOCK, block / (EDGE / BLOCK) * BLOCK + within / BLOCK);
        let [u, v, ..] = sampler(index).independent(0);
        camera.central_ray(Vec2::new(x as f32 + u, y as f32 + v))
    };
    let mut all: Vec<Ray> = (0..EDGE * EDGE).map(camera_ray).collect();
    let mut last = 0..all.len();
    while all.len() < RAYS && !last.is_empty() {
        let start = all.len();
        for index in last {
            let hit = walk::cast(scene, &all[index]);
            if !hit.is_miss() {
                let surface = Surface::new(scene, &all[index], &hit);
                let [u, v, ..] = sampler(index).independent(1);
                all.push(Ray::new(surface.origin, surface.world_direction(cosine_hemisphere(u, v))));
            }
        }
        last = start..all.len();
    }
    all.truncate(RAYS);
    all
}

/// FNV-1a of the words of hits: distance, voxel, face and instance (Fowler, Noll and Vo 1991).
fn checksum(hits: &[Hit]) -> u64 {
    let words = hits.iter().flat_map(|hit| {
        let face = if hit.is_miss() { 6 } else { hit.face() as u32 };
        let [x, y, z] = hit.voxel.to_array().map(|number| number as u32);
        [hit.t.to_bits(), x, y, z, face, hit.instance]
    });
    words.fold(0xcbf2_9ce4_8422_2325, |sum, word| (sum ^ u64::from(word)).wrapping_mul(0x0100_0000_01b3))
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let voxels = std::env::args().nth(1).map(|text| text.parse()).transpose()?;
    let mut differ = false;
    for name in voxtrace_scenes::NAMES {
        // The forest has models, of a number of their own.
        let voxels = voxels.filter(|_| name != "forest");
        let packed = PackedScene::pack(&voxtrace_scenes::generate(name, voxels)?)?;
        let rays = rays_of(&packed);
        let mut sums = Vec::new();
        let is_tried = |tried: &Instructions| *tried != Instructions::Portable && tried.is_available();
        for instructions in Instructions::ALL.into_iter().filter(is_tried) {
            let mut hits = vec![Hit::MISS; rays.len()];
            let start = Instant::now();
            for (rays, hits) in rays.chunks(WAVE).zip(hits.chunks_mut(WAVE)) {
                walk::cast_batch_with(instructions, &packed, rays, hits);
            }
            let speed = rays.len() as f64 / start.elapsed().as_secs_f64() / 1e6;
            sums.push(checksum(&hits));
            let (sum, hits) = (checksum(&hits), hits.iter().filter(|hit| !hit.is_miss()).count());
            let instructions = instructions.name();
            println!(
                "{name}, {} rays, {instructions}: {hits} hits, {sum:016x}, {speed:.2} million rays a second",
                rays.len()
            );
        }
        differ |= sums.iter().any(|sum| *sum != sums[0]);
    }
    if differ { Err("instructions differ in their hits".into()) } else { Ok(()) }
}
