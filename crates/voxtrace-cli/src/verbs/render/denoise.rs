//! Pictures without noise: `--denoise`, by our filter or by Open Image Denoise where it is installed.

use crate::failure::Failure;
use crate::session::trace_failure;
use voxtrace::PackedScene;
use voxtrace::denoise::{Features, denoise};
use voxtrace::film::Pixel;
use voxtrace::glam::Vec3;
use voxtrace::motion::{Moment, Shot};
use voxtrace::output::{Denoised, FilmFile};
use voxtrace_oidn::{Oidn, OidnError, VARIABLE};

/// What to say where films alone are written. They are not filtered, but keep how they stood half way, which tells the filter later how noisy
/// they are.
pub const OF_FILMS: &str = "films keep their noise: --resume FILM --denoise -o NAME.png makes a picture without it";

/// The filters, as an option.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum DenoiseArg {
    /// Our own, always there, with the same bits everywhere
    Voxtrace,
    /// Open Image Denoise, where its library is installed
    Oidn,
}

/// A filter that is ready.
pub enum Filter {
    Voxtrace,
    Oidn(Oidn),
}

impl Filter {
    /// Makes the filter ready, before the long work starts.
    pub fn open(filter: DenoiseArg) -> Result<Self, Failure> {
        match filter {
            DenoiseArg::Voxtrace => Ok(Self::Voxtrace),
            DenoiseArg::Oidn => Oidn::open().map(Self::Oidn).map_err(|error| {
                let failure = Failure::other(&error);
                match error {
                    OidnError::NotFound(_) => failure.hint(format!(
                        "`pip install pyoidn` brings it; {VARIABLE} says where the library is; --denoise alone needs nothing"
                    )),
                    _ => failure.hint("--denoise alone is voxtrace's own filter"),
                }
            }),
        }
    }

    /// The picture of a film without its noise; the samples of a shot that is exposed show a moment each.
    pub fn apply(&self, scene: &PackedScene, file: &FilmFile, shot: Option<&Shot>) -> Result<Denoised, Failure> {
        let features = match shot.filter(|shot| shot.exposure > 0.0) {
            Some(shot) => Features::of_moments(&file.frame, &file.film, |sample| {
                let Moment { camera, placement } = (shot.moments)(shot.time_of(file.frame.seed, sample))?;
                let scene =
                    placement.map_or_else(|| Ok(scene.clone()), |placement| scene.with_placement(&placement))?;
                Ok((scene, camera))
            })
            .map_err(trace_failure)?,
            None => Features::of(scene, &file.frame, &file.film),
        };
        match self {
            Self::Voxtrace => Ok(Denoised { radiance: denoise(&file.film, &features), filter: "voxtrace" }),
            Self::Oidn(oidn) => {
                let color: Vec<Vec3> = file.film.pixels.iter().map(Pixel::mean).collect();
                let albedo: Vec<Vec3> = features.pixels.iter().map(|pixel| pixel.albedo).collect();
                let normal: Vec<Vec3> = features.pixels.iter().map(|pixel| pixel.normal).collect();
                let region = file.film.region;
                let (width, height) = (region.width() as usize, region.height() as usize);
                let radiance = oidn.denoise(width, height, &color, &albedo, &normal).map_err(Failure::other)?;
                Ok(Denoised { radiance, filter: "oidn" })
            }
        }
    }
}
