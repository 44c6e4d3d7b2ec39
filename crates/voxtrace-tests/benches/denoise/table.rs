//! The lines of one scene in one size. The noise of the picture to compare with, known from how far it is from that of four times the samples, is
//! taken off the square error, but not off FLIP.

use super::films::Films;
use super::{Args, Outcome};
use glam::Vec3;
use std::path::Path;
use std::time::Instant;
use voxtrace::Film;
use voxtrace::difference::{Difference, Shown};
use voxtrace::output::ToneMap;
use voxtrace_core::denoise::{Features, denoise};
use voxtrace_oidn::Oidn;

/// Runs of a filter, of which the quickest counts.
const RUNS: usize = 3;

/// What a filter took, seconds: of the clock, and of all processors together where the system tells.
#[derive(Clone, Copy)]
struct Cost(f64, Option<f64>);

/// Processor time of this process, seconds.
fn processor_time() -> Option<f64> {
    let line = std::fs::read_to_string("/proc/self/stat").ok()?;
    let mut fields = line.rsplit_once(") ")?.1.split(' ').skip(11).map(|field| field.parse::<f64>().ok());
    // Linux counts hundredths there, whatever its own clock is.
    Some((fields.next()?? + fields.next()??) / 100.0)
}

/// The outcome of the quickest of some runs.
fn timed<T>(mut work: impl FnMut() -> Outcome<T>) -> Outcome<(T, Cost)> {
    let mut best: Option<(T, Cost)> = None;
    for _ in 0..RUNS {
        let (start, before) = (Instant::now(), processor_time());
        let outcome = work()?;
        let cost =
            Cost(start.elapsed().as_secs_f64(), processor_time().zip(before).map(|(after, before)| after - before));
        if best.as_ref().is_none_or(|(_, least)| cost.0 < least.0) {
            best = Some((outcome, cost));
        }
    }
    best.ok_or_else(|| "no run".into())
}

/// What the lines of a scene share.
struct Lines<'a> {
    label: String,
    reference: &'a Shown,
    /// Mean square error of the reference itself.
    reference_noise: f64,
    pictures: Option<&'a Path>,
}

impl Lines<'_> {
    fn print(&self, what: &str, shown: &Shown, cost: Option<Cost>) -> Outcome<()> {
        let difference = Difference::of(self.reference, shown)?;
        let psnr = -10.0 * (difference.rmse.powi(2) - self.reference_noise).max(1e-9).log10();
        let seconds = |seconds: Option<f64>| seconds.map_or(String::new(), |seconds| format!("{seconds:.2} s"));
        let (time, processor) = (seconds(cost.map(|cost| cost.0)), seconds(cost.and_then(|cost| cost.1)));
        println!("| {} | {what} | {psnr:.2} | {:.4} | {time} | {processor} |", self.label, difference.mean_flip());
        self.keep(what, shown)
    }

    fn keep(&self, what: &str, shown: &Shown) -> Outcome<()> {
        let Some(folder) = self.pictures else { return Ok(()) };
        std::fs::create_dir_all(folder)?;
        let name = format!("{} {what}", self.label).replace([' ', ','], "-");
        write_ppm(&folder.join(name + ".ppm"), shown)
    }
}

/// Writes a picture as PPM.
fn write_ppm(path: &Path, shown: &Shown) -> Outcome<()> {
    let mut ppm = format!("P6 {} {} 255\n", shown.width, shown.height).into_bytes();
    ppm.extend(shown.signal.iter().flat_map(|signal| (*signal * 255.0).to_array().map(|value| value.round() as u8)));
    Ok(std::fs::write(path, ppm)?)
}

pub fn print(args: &Args, films: &Films, oidn: Option<&Oidn>) -> Outcome<()> {
    let (width, height) = (films.frame.width, films.frame.height);
    let of_radiance = |radiance: &[Vec3]| Shown::of_radiance(width, height, radiance, &ToneMap::default());
    let means = |film: &Film| film.pixels.iter().map(|pixel| pixel.mean()).collect::<Vec<Vec3>>();
    let (reference, more, mut noisy) = (films.reference()?, films.more()?, films.noisy()?);

    // Variances are to each other as one over the samples.
    let [of_more, of_many] = [4 * args.samples, args.reference].map(|samples| 1.0 / f64::from(samples));
    let apart = Difference::of(&reference, &more)?;
    let reference_noise = apart.rmse.powi(2) * of_many / (of_more + of_many);
    eprintln!("{}: reference of {} samples, noise {reference_noise:.2e}", films.name, args.reference);
    let label = format!("{}, {width}×{height}", films.name);
    let lines = Lines { label, reference: &reference, reference_noise, pictures: args.pictures.as_deref() };
    lines.keep("reference", &reference)?;
    lines.print(&format!("{} samples", args.samples), &of_radiance(&means(&noisy)), None)?;
    lines.print(&format!("{} samples", 4 * args.samples), &more, None)?;
    let start = Instant::now();
    let features = Features::of(&films.scene, &films.frame, &noisy);
    eprintln!("features: {:.2} s", start.elapsed().as_secs_f64());
    let (clean, cost) = timed(|| Ok(denoise(&noisy, &features)))?;
    lines.print("ours", &of_radiance(&clean), Some(cost))?;
    noisy.earlier = None;
    let (clean, cost) = timed(|| Ok(denoise(&noisy, &features)))?;
    lines.print("ours, noise guessed", &of_radiance(&clean), Some(cost))?;
    let Some(oidn) = oidn else { return Ok(()) };
    let albedo: Vec<Vec3> = features.pixels.iter().map(|pixel| pixel.albedo).collect();
    let normal: Vec<Vec3> = features.pixels.iter().map(|pixel| pixel.normal).collect();
    let color = means(&noisy);
    let (clean, cost) = timed(|| Ok(oidn.denoise(width as usize, height as usize, &color, &albedo, &normal)?))?;
    lines.print("Open Image Denoise", &of_radiance(&clean), Some(cost))
}
