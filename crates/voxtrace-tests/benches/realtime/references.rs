//! The pictures to compare with, of many samples of another seed, kept as films in a folder; and films of as few samples as frames have been, filtered as stills are.

use super::situations::{Situation, Step};
use super::{Args, Outcome};
use glam::Vec3;
use std::path::{Path, PathBuf};
use voxtrace::output::{FilmFile, PictureOptions, SceneStamp};
use voxtrace::{CpuTracer, Film, Frame, Progress, Tracer};
use voxtrace_core::denoise::{Features, denoise};
use voxtrace_oidn::Oidn;
use voxtrace_vulkan::{Request, Traversal, choose};

/// Seed of the pictures of many samples.
const REFERENCE_SEED: u32 = 1;

/// Makes pictures by the integrator.
pub struct References {
    tracer: Option<Box<dyn Tracer + Send>>,
    device: Option<String>,
    is_fast: bool,
    samples: u32,
    folder: PathBuf,
    oidn: Option<Oidn>,
}

/// Which filter a film of few samples gets.
#[derive(Clone, Copy, PartialEq)]
pub enum StillFilter {
    /// That of `voxtrace render --denoise`.
    Ours,
    /// Open Image Denoise.
    Oidn,
}

impl References {
    pub fn new(args: &Args) -> Self {
        let renderer = &args.renderer;
        Self {
            tracer: None,
            device: renderer.device.clone(),
            is_fast: renderer.fast,
            samples: args.samples,
            folder: args.cache.clone(),
            oidn: Oidn::open().inspect_err(|error| eprintln!("{error}")).ok(),
        }
    }

    /// Whether a filter of stills is there.
    pub fn has(&self, filter: StillFilter) -> bool {
        filter == StillFilter::Ours || self.oidn.is_some()
    }

    fn film(&mut self, step: &Step, frame: &Frame, path: &Path) -> Outcome<Film> {
        if let Ok(file) = FilmFile::open(path) {
            return Ok(file.film);
        }
        let tracer = match &mut self.tracer {
            Some(tracer) => tracer,
            none => none.insert(match &self.device {
                None => Box::new(CpuTracer::new(None)),
                device => {
                    let request =
                        Request { device: device.clone(), traversal: Some(Traversal::Walk), ..Request::default() };
                    let choice = choose(&Request { is_fast: self.is_fast, ..request })?;
                    eprintln!("{}", choice.reason);
                    choice.tracer
                }
            }),
        };
        tracer.set_scene(&step.scene)?;
        let mut film = Film::new(1, 1, frame.region, 0);
        tracer.render(frame, &Progress::default())?;
        tracer.read(&mut film)?;
        let file = FilmFile { frame: frame.clone(), scene: SceneStamp::of(&step.scene), film };
        file.save_picture(path, &PictureOptions::default())?;
        Ok(file.film)
    }

    fn path(&self, (scene, situation, step): (&str, Situation, &Step), samples: u32, what: &str) -> PathBuf {
        let Frame { width, height, .. } = step.frame;
        self.folder.join(format!("{scene}-{situation}-{}-{width}x{height}-{samples}{what}.vxf", step.label))
    }

    /// The picture that a step is compared with.
    pub fn picture(&mut self, of: (&str, Situation, &Step)) -> Outcome<Vec<Vec3>> {
        let (scene, situation, step) = of;
        // All frames after a cut or a change show one picture.
        let first = Step { label: "all".into(), ..step.clone() };
        let of = if situation.has_each_step() { (scene, situation, &first) } else { of };
        let samples = step.samples.min(self.samples);
        let frame = step.frame.clone().samples(samples).seed(REFERENCE_SEED);
        let film = self.film(step, &frame, &self.path(of, samples, ""))?;
        Ok(film.pixels.iter().map(|pixel| pixel.mean()).collect())
    }

    /// A film of `samples` samples, half of which know the noise of the other, filtered as a still.
    pub fn filtered(&mut self, of: (&str, Situation, &Step), samples: u32, filter: StillFilter) -> Outcome<Vec<Vec3>> {
        let step = of.2;
        let frame = step.frame.clone().samples(samples);
        let mut film = self.film(step, &frame, &self.path(of, samples, "-few"))?;
        if samples > 1 && filter == StillFilter::Ours {
            let half = self.film(step, &frame.clone().samples(samples / 2), &self.path(of, samples / 2, "-few"))?;
            film.earlier = Some(half.pixels);
        }
        let features = Features::of(&step.scene, &frame, &film);
        let Some(oidn) = self.oidn.as_ref().filter(|_| filter == StillFilter::Oidn) else {
            return Ok(denoise(&film, &features));
        };
        let color: Vec<Vec3> = film.pixels.iter().map(|pixel| pixel.mean()).collect();
        let albedo: Vec<Vec3> = features.pixels.iter().map(|pixel| pixel.albedo).collect();
        let normal: Vec<Vec3> = features.pixels.iter().map(|pixel| pixel.normal).collect();
        Ok(oidn.denoise(frame.width as usize, frame.height as usize, &color, &albedo, &normal)?)
    }
}
