//! A synthetic CT of 512³ samples with noise, as plain and gzipped NIfTI: from the file to the first picture, compared with
//! reading alone by nibabel.

use crate::Options;
use crate::stopwatch::beside;
use flate2::{Compression, write::GzEncoder};
use std::error::Error;
use std::io::Write;
use std::path::Path;
use std::sync::Arc;
use voxtrace::import::{self, ImportOptions};
use voxtrace::output::{Metadata, PngOptions, write_png};
use voxtrace::{CpuTracer, Film, Frame, Integrator, PackedScene, Progress, Region, Tracer};
use voxtrace_tests::phantom;

/// Measures and prints.
pub fn measure(options: &Options, folder: &Path) -> Result<(), Box<dyn Error>> {
    let (plain, zipped, picture) = (folder.join("ct.nii"), folder.join("ct.nii.gz"), folder.join("ct.png"));
    let bytes = phantom::nifti(options.samples, 45.0);
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
