//! `voxtrace info FILM`: what a film shows, how many samples its pixels have, and how noisy it is.

use super::merge::film_failure;
use crate::failure::Failure;
use crate::import::Begun;
use crate::noise;
use serde_json::json;
use std::fs::File;
use std::io::{Read, Seek};
use std::path::Path;
use voxtrace::output::{FILM_MAGIC, FilmFile};

/// What a name is of, as its first bytes tell.
pub enum Found {
    /// A film.
    Film(Box<FilmFile>),
    /// A pipe of something else, which gives its bytes once.
    Pipe(Begun),
    /// Something else.
    Other,
}

/// Looks at a file or a pipe. What cannot be read is something else: reading it says why.
pub fn look_at(path: &Path) -> Result<Found, Failure> {
    let Some(metadata) = std::fs::metadata(path).ok().filter(|metadata| !metadata.is_dir()) else {
        return Ok(Found::Other);
    };
    let mut bytes = Vec::new();
    let begin = |mut file: File| (&mut file).take(FILM_MAGIC.len() as u64).read_to_end(&mut bytes).map(|_| file);
    let Ok(mut file) = File::open(path).and_then(begin) else { return Ok(Found::Other) };
    if bytes == FILM_MAGIC {
        let read = file.read_to_end(&mut bytes).map_err(Into::into);
        let film = read.and_then(|_| FilmFile::from_bytes(&bytes));
        return film.map(|film| Found::Film(film.into())).map_err(|error| film_failure(path, &error));
    }
    if metadata.is_file() {
        // Where `/dev/stdin` is a handle of a file that is open already, both have one place.
        let _ = file.rewind();
        return Ok(Found::Other);
    }
    Ok(Found::Pipe(Begun::of(bytes, file)))
}

/// Prints what a film says.
pub fn print(file: &FilmFile, as_json: bool) {
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
        return crate::stdout::print(&format!("{json:#}\n"));
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
}
