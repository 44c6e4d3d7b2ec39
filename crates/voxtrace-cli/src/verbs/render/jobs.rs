//! What a render is to make: the frame of each view with its files, and whether a film belongs to it.

use super::files::Job;
use super::{DEFAULT_SAMPLES, MAX_PIXELS, RenderArgs};
use crate::failure::Failure;
use crate::parse::MAX_SAMPLES;
use crate::picture::path_of_view;
use crate::views::View;
use std::path::{Path, PathBuf};
use voxtrace::lines::Lines;
use voxtrace::output::{FilmFile, SceneStamp};
use voxtrace::{Film, Frame, Integrator, Region};

impl RenderArgs {
    /// The frame of every view, with the files it is written to.
    pub(super) fn jobs(&self, views: Vec<View>, lines: Lines, resumed: Option<&FilmFile>) -> Result<Vec<Job>, Failure> {
        let film = resumed.map(|file| &file.frame);
        let (width, height) = self.size(resumed);
        let of_film = film.filter(|film| (film.width, film.height) == (width, height)).map(|film| film.region);
        let region = self.quality.crop.or(of_film).unwrap_or(Region::full(width, height));
        if region.x1 > width || region.y1 > height {
            return Err(Failure::usage(format!("the crop reaches beyond the picture of {width}x{height}")));
        }
        if region.pixels() as u64 > MAX_PIXELS {
            return Err(Failure::usage(format!("{width}x{height} are more than {MAX_PIXELS} pixels"))
                .hint("render it in parts with --crop"));
        }
        let asked = self.quality.integrator.map(Integrator::from);
        let integrator = asked.or(film.map(|film| film.integrator)).unwrap_or_default();
        if self.quality.light_groups && integrator == Integrator::Essay {
            return Err(Failure::usage("--light-groups needs the integrator path"));
        }
        let has_catcher = self.surroundings.has_shadow_catcher();
        if has_catcher && integrator == Integrator::Essay {
            return Err(Failure::usage("--shadow-catcher needs the integrator path"));
        }
        if !lines.is_none() && integrator == Integrator::Essay {
            return Err(Failure::usage("--edges and --grid need the integrator path"));
        }
        let default_bounces = if integrator == Integrator::Essay { 3 } else { 8 };
        let same_integrator = film.filter(|film| film.integrator == integrator);
        let max_bounces = self.quality.max_bounces.or(same_integrator.map(|film| film.max_bounces));
        let has_other_end = self.quality.time_limit.is_some() || self.quality.noise.is_some();
        let default_samples = match film {
            _ if has_other_end => MAX_SAMPLES,
            Some(film) => film.samples,
            None => DEFAULT_SAMPLES,
        };
        let seed = self.quality.seed.or(film.map(|film| film.seed)).unwrap_or(0);
        let first_sample = self.film.first_sample.or(film.map(|film| film.first_sample)).unwrap_or(0);
        let job = |view: View| {
            let frame_number = view.frame.map_or(0, |frame| frame - 1);
            let path = |pattern: &PathBuf| path_of_view(pattern, view.camera_suffix.as_deref(), view.frame);
            Job {
                name: view.name(),
                outputs: self.picture.output.iter().map(path).collect(),
                checkpoint: self.film.checkpoint.as_ref().map(path),
                number: view.frame,
                films: self.film.checkpoint.clone(),
                frame: Frame::new(view.camera, width, height)
                    .region(region)
                    .first_sample(first_sample)
                    .samples(self.quality.spp.unwrap_or(default_samples))
                    .seed(seed.wrapping_add(frame_number))
                    .max_bounces(max_bounces.unwrap_or(default_bounces))
                    .integrator(integrator)
                    .bounce_limits(self.quality.limits.bounces(film))
                    .clamp_indirect(self.quality.limits.clamp_indirect(film))
                    .clear_shadows(self.quality.limits.clear_shadows(film))
                    .transparent(self.is_transparent() || film.is_some_and(|film| film.transparent))
                    .shadow_catcher(has_catcher || film.is_some_and(|film| film.shadow_catcher))
                    .lines(lines)
                    .aovs(self.quality.aovs || film.is_some_and(|film| film.aovs)),
            }
        };
        let jobs: Vec<Job> = views.into_iter().map(job).collect();
        let mut paths: Vec<_> = jobs.iter().flat_map(|job| job.outputs.iter().chain(&job.checkpoint)).collect();
        paths.sort();
        match paths.windows(2).find(|pair| pair[0] == pair[1]) {
            Some(pair) => Err(Failure::usage(format!("two views would both be written to {}", pair[0].display()))),
            None => Ok(jobs),
        }
    }

    /// The film to continue, where it is one of this job.
    pub(super) fn check_film(&self, job: &Job, file: FilmFile, stamp: &SceneStamp) -> Result<Film, Failure> {
        let pattern = self.film.resume.as_deref().unwrap_or(Path::new("the film"));
        let path = job.number.map_or_else(|| pattern.to_owned(), |frame| path_of_view(pattern, None, Some(frame)));
        let path = path.display();
        if let Some(difference) = file.difference(&job.frame, stamp) {
            return Err(Failure::mismatch(format!("cannot continue {path}: {difference}")).hint(match job.number {
                // Where the camera stands in a frame depends on how many there are.
                Some(_) => {
                    "say --frames as before, leave out the options that the films already know, or start new films"
                }
                None => "leave out the options that the film already knows, or start a new film",
            }));
        }
        let (_, most) = file.film.sample_range();
        if most > job.frame.samples {
            let message = format!("{path} holds {most} samples already, {} were asked for", job.frame.samples);
            return Err(Failure::mismatch(message).hint(format!("ask for --spp {most} or more")));
        }
        Ok(file.film)
    }
}
