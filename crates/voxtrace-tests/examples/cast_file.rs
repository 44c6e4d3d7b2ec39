//! How many rays of a file a second the library casts through a scene on the processor, alone and with what the Python package says of each hit beside it: position,
//! normal and material.
//! `cargo run --release -p voxtrace-tests --example cast_file -- SCENE.vxt RAYS [ROUNDS]`; RAYS are 32-bit floats, little-endian: six a ray, origin and direction.

use rayon::prelude::*;
use std::error::Error;
use std::sync::Arc;
use std::time::Instant;
use voxtrace::glam::Vec3;
use voxtrace::{CpuTracer, Hit, PackedScene, Ray, Tracer};

/// Rays of one task.
const CHUNK: usize = 1 << 12;

/// Position, normal and material of each hit.
fn tell(scene: &PackedScene, rays: &[Ray], hits: &[Hit]) -> Vec<(Vec3, Vec3, u32)> {
    let mut told = vec![(Vec3::ZERO, Vec3::ZERO, u32::MAX); rays.len()];
    let chunks = told.par_chunks_mut(CHUNK).zip(rays.par_chunks(CHUNK)).zip(hits.par_chunks(CHUNK));
    chunks.for_each(|((told, rays), hits)| {
        let mut materials = vec![u32::MAX; hits.len()];
        scene.material_indices(hits, &mut materials);
        for (index, (ray, hit)) in rays.iter().zip(hits).enumerate().filter(|(_, (_, hit))| !hit.is_miss()) {
            told[index] = (ray.at(hit.t), scene.normal(hit), materials[index]);
        }
    });
    told
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let (Some(scene), Some(rays)) = (arguments.next(), arguments.next()) else {
        return Err("a scene and a file of rays are wanted".into());
    };
    let rounds: usize = arguments.next().map_or(Ok(5), |rounds| rounds.parse())?;
    let scene = Arc::new(PackedScene::open(scene.as_ref())?);
    let bytes = std::fs::read(rays)?;
    let numbers: Vec<f32> = bytes.as_chunks().0.iter().map(|bytes| f32::from_le_bytes(*bytes)).collect();
    let rays: Vec<Ray> = numbers
        .as_chunks::<6>()
        .0
        .iter()
        .map(|&[x, y, z, dx, dy, dz]| Ray::new(Vec3::new(x, y, z), Vec3::new(dx, dy, dz)))
        .collect();
    let mut tracer = CpuTracer::new(None);
    tracer.set_scene(&scene)?;
    let mut hits = vec![Hit::MISS; rays.len()];
    for _ in 0..rounds {
        let start = Instant::now();
        tracer.cast_into(&rays, &mut hits)?;
        let seconds = start.elapsed().as_secs_f64();
        let met = hits.iter().filter(|hit| !hit.is_miss()).count();
        let start = Instant::now();
        let told = tell(&scene, &rays, &hits);
        let all = seconds + start.elapsed().as_secs_f64();
        let speed = |seconds: f64| 1e-6 * rays.len() as f64 / seconds;
        println!(
            "{:.3} million rays/s, with all answers {:.3}; {met} of {} meet a voxel",
            speed(seconds),
            speed(all),
            told.len()
        );
    }
    Ok(())
}
