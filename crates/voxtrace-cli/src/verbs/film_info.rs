//! `voxtrace info FILM`: what a film shows, how many samples its pixels have, and how noisy it is.

use super::merge::open_film;
use crate::failure::Failure;
use crate::noise;
use serde_json::json;
use std::path::Path;
use voxtrace::output::FILM_MAGIC;

/// Whether a name is that of a film file. A pipe gives its bytes once, and whoever reads the scene needs the first ones, too.
pub fn is_film(name: &str) -> bool {
    if !Path::new(name).is_file() {
        return false;
    }
    let mut head = [0; 8];
    let read = std::fs::File::open(name).and_then(|mut file| std::io::Read::read_exact(&mut file, &mut head));
    read.is_ok() && head == *FILM_MAGIC
}

/// Prints what a film says.
pub fn print(path: &Path, as_json: bool) -> Result<(), Failure> {
    let file = open_film(path)?;
    let (film, frame) = (&file.film, &file.frame);
    let (least, most) = film.sample_range();
    let all: u64 = film.pixels.iter().map(|pixel| u64::from(pixel.samples)).sum();
    let mean = all as f64 / film.pixels.len().max(1) as f64;
    let errors = noise::errors(frame, film);
    let root_mean = (errors.iter().map(|error| error * error).sum::<f64>() / errors.len().max(1) as f64).sqrt();
    let worst = errors.iter().copied().fold(0.0, f64::max);
    if as_json {
        let error = (!errors.is_empty())
            .then(|| json!({ "tiles": errors.len(), "root_mean_square": root_mean, "worst_tile": worst }));
        let json = json!({
            "scene": file.scene.name,
            "scene_hash": format!("{:016x}", file.scene.content_hash),
            "camera": frame.camera.name,
            "width": film.width,
            "height": film.height,
            "integrator": frame.integrator.name(),
            "max_bounces": frame.max_bounces,
            "seed": frame.seed,
            "first_sample": film.first_sample,
            "samples": { "asked_for": frame.samples, "least": least, "most": most, "mean": mean },
            "error": error,
        });
        crate::stdout::print(&format!("{json:#}\n"));
        return Ok(());
    }
    let samples = if least == most { most.to_string() } else { format!("{least} to {most}, {mean:.1} in the mean") };
    let error = match errors.len() {
        0 => "not known: only films of --noise and --denoise tell".to_owned(),
        tiles => format!("{root_mean:.4}, {worst:.4} in the worst of {tiles} tiles (relative, estimated)"),
    };
    crate::stdout::print(&format!(
        "scene             {}\ncamera            {}\nsize              {} x {}\nintegrator        {}, {} bounces, seed {}\n\
         samples           {samples} a pixel, of {} from {}\nerror             {error}\n",
        file.scene.name,
        frame.camera.name,
        film.width,
        film.height,
        frame.integrator.name(),
        frame.max_bounces,
        frame.seed,
        frame.samples,
        film.first_sample,
    ));
    Ok(())
}
