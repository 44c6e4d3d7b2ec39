//! A synthetic CT of 512³ samples with noise, as plain and gzipped NIfTI: from the file to the first picture, compared with
//! reading alone by nibabel.

use crate::Options;
use crate::stopwatch::beside;
use flate2::{Compression, write::GzEncoder};
use rayon::prelude::*;
use std::error::Error;
use std::io::Write;
use std::path::Path;
use std::sync::Arc;
use voxtrace::glam::DVec3;
use voxtrace::import::{self, ImportOptions};
use voxtrace::output::{Metadata, PngOptions, write_png};
use voxtrace::{CpuTracer, Film, Frame, Integrator, PackedScene, Progress, Region, Tracer};
use voxtrace_tests::terrain::random;

/// Bytes before the samples.
const HEADER: usize = 352;

/// Measures and prints.
pub fn measure(options: &Options, folder: &Path) -> Result<(), Box<dyn Error>> {
    let (plain, zipped, picture) = (folder.join("ct.nii"), folder.join("ct.nii.gz"), folder.join("ct.png"));
    let bytes = volume(options.samples);
    std::fs::write(&plain, &bytes)?;
    let mut encoder = GzEncoder::new(Vec::new(), Compression::fast());
    encoder.write_all(&bytes)?;
    let compressed = encoder.finish()?;
    std::fs::write(&zipped, &compressed)?;
    println!("{}^3 samples, {} MB, {} as gzip", options.samples, bytes.len() / 1_000_000, compressed.len() / 1_000_000);
    drop((bytes, compressed));
    for (name, file) in [("NIfTI", &plain), ("NIfTI, gzip", &zipped)] {
        beside(options, &format!("{name} to the first picture"), file, || render(file, &picture))?;
    }
    Ok(())
}

/// From the file to a picture of 640 × 360, a path for each pixel.
fn render(file: &Path, picture: &Path) -> Result<(), Box<dyn Error>> {
    let packed = Arc::new(PackedScene::pack(&import::open(file, &ImportOptions::default())?)?);
    let (width, height) = (640, 360);
    let frame = Frame::new(packed.overview(width as f32 / height as f32), width, height)
        .samples(1)
        .seed(0)
        .max_bounces(8)
        .integrator(Integrator::Path);
    let mut tracer = CpuTracer::new(None);
    tracer.set_scene(&packed)?;
    tracer.render(&frame, &Progress::default())?;
    let mut film = Film::new(width, height, Region::full(width, height), 0);
    tracer.read(&mut film)?;
    write_png(std::fs::File::create(picture)?, &film, &PngOptions::default(), &Metadata::default())?;
    Ok(())
}

/// A NIfTI file: air, a body with fat and soft tissue, a shell and a column of bone; whole Hounsfield units with noise.
fn volume(samples: usize) -> Vec<u8> {
    let mut bytes = vec![0; HEADER + 2 * samples.pow(3)];
    let mut put = |at: usize, value: &[u8]| bytes[at..at + value.len()].copy_from_slice(value);
    put(0, &348i32.to_le_bytes());
    for (at, value) in [3, samples as i16, samples as i16, samples as i16, 1, 1, 1, 1].into_iter().enumerate() {
        put(40 + 2 * at, &value.to_le_bytes());
    }
    // Samples of 16 bits with a sign.
    put(70, &4i16.to_le_bytes());
    put(72, &16i16.to_le_bytes());
    for (at, value) in [1.0f32, 0.6, 0.6, 0.8].into_iter().enumerate() {
        put(76 + 4 * at, &value.to_le_bytes());
    }
    put(108, &(HEADER as f32).to_le_bytes());
    put(112, &1f32.to_le_bytes());
    put(123, &[2]);
    put(344, b"n+1\0");
    let place = |at: usize| {
        let at = [at % samples, at / samples % samples, at / samples / samples];
        DVec3::from_array(at.map(|at| at as f64 / samples as f64 * 2.0 - 1.0))
    };
    let row = |(row, bytes): (usize, &mut [u8])| {
        for (column, sample) in bytes.chunks_exact_mut(2).enumerate() {
            let at = row * samples + column;
            let noise = (0..3).map(|part| random(at as u64, part)).sum::<f64>() * 30.0 - 45.0;
            sample.copy_from_slice(&((hounsfield(place(at)) + noise) as i16).to_le_bytes());
        }
    };
    bytes[HEADER..].par_chunks_mut(2 * samples).enumerate().for_each(row);
    bytes
}

fn hounsfield(at: DVec3) -> f64 {
    let body = (at * DVec3::new(1.0, 1.3, 0.9)).length();
    let column = (at - DVec3::new(0.0, 0.35, 0.0)).truncate().length();
    match () {
        () if body > 0.93 => -1000.0,
        () if column < 0.1 => 500.0 + 200.0 * (at.z * 40.0).sin(),
        () if body > 0.85 => -90.0,
        () if (0.66..0.72).contains(&body) => 900.0,
        () => 45.0,
    }
}
