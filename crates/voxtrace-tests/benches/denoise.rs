//! `cargo bench -p voxtrace-tests --bench denoise`: how much of the noise is left in pictures of the built-in scenes, beside pictures of
//! many samples (whose own noise, known from how far it is from the picture of four times the samples, is taken off the square error): raw, by the filter of `voxtrace-core`, by Open Image Denoise where it is installed, and raw with four times the samples. Prints the
//! table of `docs/denoising.md`. The pictures of many samples take hours on few cores; they are kept in a folder, and a run that was
//! stopped goes on.

use clap::Parser;
use glam::Vec3;
use std::error::Error;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Instant;
use voxtrace::difference::{Difference, Shown};
use voxtrace::import::ImportOptions;
use voxtrace::output::{FilmFile, SceneStamp, ToneMap};
use voxtrace::{CpuTracer, Film, Frame, PackedScene, Progress, Tracer};
use voxtrace_core::denoise::{Features, denoise};
use voxtrace_oidn::Oidn;

/// Seed of the pictures of many samples: another one, so that they do not contain the noise that they measure.
const REFERENCE_SEED: u32 = 1;
/// Samples after which a picture of many samples is kept.
const STEP: u32 = 32;

#[derive(Parser)]
struct Args {
    /// Scenes
    #[arg(long, value_delimiter = ',', default_value = "church,operating-room,city")]
    scenes: Vec<String>,
    /// Voxels of each scene; its own number by default
    #[arg(long)]
    voxels: Option<u64>,
    /// Sizes of the pictures
    #[arg(long, value_delimiter = ',', default_value = "960x540,1280x720")]
    sizes: Vec<String>,
    /// Samples of the noisy picture
    #[arg(long, default_value_t = 16)]
    samples: u32,
    /// Samples of the picture to compare with
    #[arg(long, default_value_t = 2048)]
    reference: u32,
    /// Folder that keeps scenes and films
    #[arg(long, default_value = "target/denoise")]
    cache: PathBuf,
    /// Writes the pictures there, as PPM
    #[arg(long)]
    pictures: Option<PathBuf>,
    /// Renders the pictures of many samples, compares nothing
    #[arg(long)]
    prepare: bool,
    /// Compares with the pictures of many samples that are there, however many samples they have
    #[arg(long)]
    as_is: bool,
    // What `cargo bench` says.
    #[arg(long, hide = true)]
    bench: bool,
}

type Outcome<T> = Result<T, Box<dyn Error>>;

/// A scene, kept packed.
fn scene(args: &Args, name: &str) -> Outcome<Arc<PackedScene>> {
    let path = args.cache.join(format!("{name}-{}.vxt", args.voxels.unwrap_or(0)));
    if !path.exists() {
        let scene = voxtrace::scenes::generate(name, args.voxels)?;
        PackedScene::pack(&scene)?.save(&path)?;
    }
    let loaded = voxtrace::import::load(&path, &ImportOptions::default())?;
    match loaded.content {
        voxtrace::import::Content::Packed(packed) => Ok(Arc::new(*packed)),
        voxtrace::import::Content::Scene(scene) => Ok(Arc::new(PackedScene::pack(&scene)?)),
    }
}

/// A film of a frame, continued where a file has some of it and kept there.
fn film(tracer: &mut CpuTracer, scene: &PackedScene, frame: &Frame, path: &Path, as_is: bool) -> Outcome<Film> {
    let mut film = Film::new(frame.width, frame.height, frame.region, frame.first_sample);
    if let Ok(file) = FilmFile::open(path) {
        film = file.film;
        if as_is || film.sample_range().0 >= frame.samples {
            return Ok(film);
        }
        tracer.resume(&file.frame, film.clone())?;
    }
    while film.sample_range().0 < frame.samples {
        let samples = (film.sample_range().0 + STEP).min(frame.samples);
        let part = frame.clone().samples(samples);
        tracer.render(&part, &Progress::default())?;
        tracer.read(&mut film)?;
        FilmFile { frame: part, scene: SceneStamp::of(scene), film: film.clone() }.save(path)?;
        eprintln!("{}: {samples} of {} samples", path.display(), frame.samples);
    }
    Ok(film)
}

/// The mean radiance of each pixel.
fn means(film: &Film) -> Vec<Vec3> {
    film.pixels.iter().map(|pixel| pixel.mean()).collect()
}

/// One line of the table.
struct Row<'a> {
    label: String,
    frame: &'a Frame,
    reference: &'a Shown,
    /// Mean square error of the reference itself.
    reference_noise: f64,
}

impl Row<'_> {
    fn print(&self, what: &str, radiance: &[Vec3], seconds: Option<f64>, pictures: Option<&Path>) -> Outcome<()> {
        let shown = Shown::of_radiance(self.frame.width, self.frame.height, radiance, &ToneMap::default());
        let difference = Difference::of(self.reference, &shown)?;
        let psnr = -10.0 * (difference.rmse.powi(2) - self.reference_noise).max(1e-9).log10();
        let time = seconds.map_or(String::new(), |seconds| format!("{seconds:.2} s"));
        println!("| {} | {what} | {:.2} | {:.4} | {time} |", self.label, psnr, difference.mean_flip());
        let Some(folder) = pictures else { return Ok(()) };
        std::fs::create_dir_all(folder)?;
        let name = format!("{} {what}", self.label).replace([' ', '×', ','], "-");
        write_ppm(&folder.join(name + ".ppm"), &shown)
    }
}

/// Writes a picture as PPM.
fn write_ppm(path: &Path, shown: &Shown) -> Outcome<()> {
    let mut ppm = format!("P6 {} {} 255\n", shown.width, shown.height).into_bytes();
    ppm.extend(shown.signal.iter().flat_map(|signal| (*signal * 255.0).to_array().map(|value| value.round() as u8)));
    Ok(std::fs::write(path, ppm)?)
}

fn main() -> Outcome<()> {
    let args = Args::parse();
    std::fs::create_dir_all(&args.cache)?;
    let oidn = Oidn::open();
    if let Err(error) = &oidn {
        eprintln!("{error}");
    }
    if !args.prepare {
        println!("| scene | picture | PSNR, dB | FLIP | time |\n|---|---|---:|---:|---:|");
    }
    for size in &args.sizes {
        let (width, height) = size.split_once('x').ok_or("a size is WIDTHxHEIGHT")?;
        for name in &args.scenes {
            measure(&args, name, (width.parse()?, height.parse()?), oidn.as_ref().ok())?;
        }
    }
    Ok(())
}

/// The lines of one scene in one size.
fn measure(args: &Args, name: &str, (width, height): (u32, u32), oidn: Option<&Oidn>) -> Outcome<()> {
    let scene = scene(args, name)?;
    let mut tracer = CpuTracer::new(None);
    tracer.set_scene(&scene)?;
    let camera = scene.cameras.first().ok_or("a scene without a camera")?.clone();
    let frame = Frame::new(camera, width, height).samples(args.samples);
    let path = |what: &str| args.cache.join(format!("{name}-{}-{width}x{height}-{what}.vxf", args.voxels.unwrap_or(0)));
    let many = frame.clone().samples(args.reference).seed(REFERENCE_SEED);
    let reference_film = film(&mut tracer, &scene, &many, &path("reference"), args.as_is)?;
    if args.prepare {
        return Ok(());
    }
    let reference = Shown::of_radiance(width, height, &means(&reference_film), &ToneMap::default());
    let of = |tracer: &mut CpuTracer, samples: u32| {
        let frame = frame.clone().samples(samples);
        film(tracer, &scene, &frame, &path(&samples.to_string()), false)
    };
    let half = of(&mut tracer, args.samples / 2)?;
    let mut noisy = of(&mut tracer, args.samples)?;
    let more = of(&mut tracer, 4 * args.samples)?;

    // Variances are to each other as one over the samples.
    let reference_samples = f64::from(reference_film.sample_range().0);
    let (ours, theirs) = (1.0 / f64::from(4 * args.samples), 1.0 / reference_samples);
    let apart = Difference::of(&reference, &Shown::of_radiance(width, height, &means(&more), &ToneMap::default()))?;
    let reference_noise = apart.rmse.powi(2) * theirs / (ours + theirs);
    eprintln!("{name}: reference of {reference_samples} samples, noise {reference_noise:.2e}");
    let row =
        Row { label: format!("{name}, {width} × {height}"), frame: &frame, reference: &reference, reference_noise };
    let pictures = args.pictures.as_deref();
    row.print(&format!("{} samples", args.samples), &means(&noisy), None, pictures)?;
    row.print(&format!("{} samples", 4 * args.samples), &means(&more), None, pictures)?;
    let start = Instant::now();
    let features = Features::of(&scene, &frame, &noisy);
    eprintln!("features: {:.2} s", start.elapsed().as_secs_f64());
    for (what, earlier) in [("ours", Some(half.pixels)), ("ours, noise guessed", None)] {
        noisy.earlier = earlier;
        let start = Instant::now();
        let clean = denoise(&noisy, &features);
        row.print(what, &clean, Some(start.elapsed().as_secs_f64()), pictures)?;
    }
    if let Some(oidn) = oidn {
        let albedo: Vec<Vec3> = features.pixels.iter().map(|pixel| pixel.albedo).collect();
        let normal: Vec<Vec3> = features.pixels.iter().map(|pixel| pixel.normal).collect();
        let start = Instant::now();
        let clean = oidn.denoise(width as usize, height as usize, &means(&noisy), &albedo, &normal)?;
        row.print("Open Image Denoise", &clean, Some(start.elapsed().as_secs_f64()), pictures)?;
    }
    match pictures {
        Some(folder) => write_ppm(&folder.join(format!("{name}-{width}-{height}-reference.ppm")), &reference),
        None => Ok(()),
    }
}
