//! Motion blur, for every tracer: each sample of a frame has its own moment within the time that the shutter is open, the same for all pixels.
//! A [`MovingTracer`] puts things, and the camera, where they are at that moment, and lets the tracer within add this one sample to its film.
//! Sums of samples are exact, so that the film is that of all of them, in whatever order and on whatever machines they were rendered
//! (`docs/decisions/0145-motion-blur.md`).

use crate::dynamic::Patch;
use crate::film::{AovPixel, Film};
use crate::frame::Frame;
use crate::packed::{PackedScene, Placement};
use crate::region::Region;
use crate::sampler::pcg4d;
use crate::tracer::{Progress, TraceError, Tracer};
use std::sync::Arc;
use voxtrace_scene::camera::Camera;
use voxtrace_scene::ray::{Hit, Ray};
use xxhash_rust::xxh3::Xxh3;

/// Keeps the hash of moments apart from those of pixels.
const MOMENTS: u32 = 0x6d6f_7665;

/// How things stand at one time.
#[derive(Clone, Debug)]
pub struct Moment {
    /// The view.
    pub camera: Camera,
    /// Where things are; `None`: where they always are.
    pub placement: Option<Placement>,
}

/// A scene over time: how it stands at a time, in seconds. Must give the same for the same time.
pub type Moments = Arc<dyn Fn(f64) -> Result<Moment, TraceError> + Send + Sync>;

/// What one frame of an animation shows.
#[derive(Clone)]
pub struct Shot {
    /// When the shutter opens, seconds.
    pub opens: f64,
    /// How long it stays open, seconds; 0: everything stands still.
    pub exposure: f64,
    /// The scene over time.
    pub moments: Moments,
}

impl Shot {
    /// The moment in the middle of the exposure, whose camera and placement stand for the frame.
    ///
    /// # Errors
    /// Those of the moments.
    pub fn middle(&self) -> Result<Moment, TraceError> {
        (self.moments)(self.opens + 0.5 * self.exposure)
    }

    /// Tells films of this shot from those of others: a hash of `content_hash`, that of the scene, and of how things stand when the shutter
    /// opens, in the middle, and when it closes. Where nothing moves but the camera, which films keep, and nothing is exposed, it is
    /// `content_hash` itself.
    ///
    /// # Errors
    /// Those of the moments.
    pub fn stamp(&self, content_hash: u64) -> Result<u64, TraceError> {
        let mut hash = Xxh3::with_seed(content_hash);
        let mut is_moving = self.exposure > 0.0;
        for share in [0.0, 0.5, 1.0] {
            let Moment { camera, placement } = (self.moments)(self.opens + share * self.exposure)?;
            if self.exposure > 0.0 {
                hash.update(bytemuck::bytes_of(&[camera.eye, camera.target, camera.up]));
                hash.update(&camera.fov_y.to_le_bytes());
                // What is in focus may change, too. A pinhole has no settings.
                camera.lens.settings().iter().for_each(|(_, value)| hash.update(&value.to_le_bytes()));
            }
            if let Some(placement) = placement {
                is_moving = true;
                hash.update(bytemuck::cast_slice(placement.instances()));
            }
        }
        Ok(if is_moving { hash.digest() } else { content_hash })
    }

    /// The time of a sample of a frame with this seed, seconds.
    pub fn time_of(&self, seed: u32, sample: u32) -> f64 {
        self.opens + self.exposure * share_of_exposure(seed, sample)
    }
}

/// The share of the exposure, in [0, 1), at which a sample is taken: van der Corput's sequence in base 2, turned by a hash of the seed. Of the
/// first 2ᵏ samples, and of each 2ᵏ after them, one lies in each 2ᵏth part of the exposure. Depends on seed and number of the sample alone,
/// not on how many there are.
pub fn share_of_exposure(seed: u32, sample: u32) -> f64 {
    let [turn, ..] = pcg4d([seed, MOMENTS, 0, 0]);
    f64::from(sample.reverse_bits().wrapping_add(turn)) / 4_294_967_296.0
}

/// A tracer of scenes that move while the shutter is open. Without a shot it is the tracer within.
pub struct MovingTracer {
    tracer: Box<dyn Tracer + Send>,
    shot: Option<Shot>,
    /// The film of a shot that is exposed.
    film: Option<ExposedFilm>,
}

/// A film that gathers samples of many moments. It grows within the tracer, which keeps it from one moment to the next.
struct ExposedFilm {
    frame: Frame,
    /// Samples that every pixel has.
    least: u32,
    /// The film as it was last here: what is left of it where a device is lost.
    copy: Film,
    /// Whether the tracer has the film; else it is the copy.
    is_within: bool,
    aovs: Option<Vec<AovPixel>>,
}

impl ExposedFilm {
    fn new(frame: &Frame, mut film: Film) -> Self {
        let (aovs, least) = (film.aovs.take(), film.sample_range().0);
        Self { frame: frame.clone(), least, copy: film, is_within: false, aovs }
    }

    /// Adds one sample, the next that some pixels lack, to those pixels.
    fn add_sample(
        &mut self,
        tracer: &mut (dyn Tracer + Send),
        shot: &Shot,
        progress: &Progress,
    ) -> Result<(), TraceError> {
        let moment = (shot.moments)(shot.time_of(self.frame.seed, self.frame.first_sample + self.least))?;
        let own = self.frame.clone().camera(moment.camera).samples(self.least + 1).aovs(false);
        if self.is_within {
            tracer.set_moment(moment.placement.as_ref(), &own)?;
        } else {
            if let Some(placement) = &moment.placement {
                tracer.set_placement(placement)?;
            }
            tracer.resume(&own, self.copy.clone())?;
            self.is_within = true;
        }
        tracer.render(&own, progress)?;
        self.least += 1;
        // A device that is lost costs half of the samples at most.
        if progress.is_cancelled() || self.least.is_power_of_two() {
            self.copy = read(tracer, self.frame.region)?;
            self.least = self.copy.sample_range().0;
        }
        Ok(())
    }

    /// Takes the AOVs of the middle of the exposure. The tracer must not have the film.
    fn add_aovs(&mut self, tracer: &mut (dyn Tracer + Send), shot: &Shot) -> Result<(), TraceError> {
        let moment = shot.middle()?;
        if let Some(placement) = &moment.placement {
            tracer.set_placement(placement)?;
        }
        tracer.render(&self.frame.clone().camera(moment.camera).samples(1), &Progress::default())?;
        self.aovs = read(tracer, self.frame.region)?.aovs;
        Ok(())
    }

    /// Goes back to the copy where a device was lost with the film.
    fn after<R>(&mut self, result: Result<R, TraceError>) -> Result<Option<R>, TraceError> {
        match result {
            Err(TraceError::DeviceLost { .. }) if self.is_within => {
                (self.is_within, self.least) = (false, self.copy.sample_range().0);
                Ok(None)
            }
            result => result.map(Some),
        }
    }
}

/// The film of a tracer.
fn read(tracer: &mut (dyn Tracer + Send), region: Region) -> Result<Film, TraceError> {
    let mut film = Film::new(0, 0, region, 0);
    tracer.read(&mut film)?;
    Ok(film)
}

impl MovingTracer {
    /// A tracer that moves what `tracer` renders.
    pub fn new(tracer: Box<dyn Tracer + Send>) -> Self {
        Self { tracer, shot: None, film: None }
    }

    /// Takes the shot that later calls render, and forgets the film. Where nothing moves while it is exposed, things are put where they are
    /// at once; else [`Tracer::cast`] meets them where they were last.
    ///
    /// # Errors
    /// As [`Tracer::set_placement`]; those of the moments.
    pub fn set_shot(&mut self, shot: Shot) -> Result<(), TraceError> {
        if let Some(placement) = shot.middle()?.placement {
            self.tracer.set_placement(&placement)?;
        }
        self.film = None;
        self.shot = Some(shot);
        Ok(())
    }

    /// The shot that was set last.
    pub fn shot(&self) -> Option<&Shot> {
        self.shot.as_ref()
    }

    /// The shot, where things move while it is exposed.
    fn exposed(&self) -> Option<Shot> {
        self.shot.clone().filter(|shot| shot.exposure > 0.0)
    }

    /// Brings the film up to the samples that its frame asks for.
    fn expose(&mut self, film: &mut ExposedFilm, shot: &Shot, progress: &Progress) -> Result<(), TraceError> {
        if film.frame.aovs && film.aovs.is_none() {
            film.add_aovs(&mut *self.tracer, shot)?;
        }
        while !progress.is_cancelled() && film.least < film.frame.samples {
            let added = film.add_sample(&mut *self.tracer, shot, progress);
            film.after(added)?;
        }
        Ok(())
    }
}

impl Tracer for MovingTracer {
    fn set_scene(&mut self, scene: &Arc<PackedScene>) -> Result<(), TraceError> {
        self.film = None;
        self.tracer.set_scene(scene)
    }

    fn set_placement(&mut self, placement: &Placement) -> Result<(), TraceError> {
        self.film = None;
        self.tracer.set_placement(placement)
    }

    fn patch(&mut self, patch: &Patch) -> Result<(), TraceError> {
        if !patch.is_empty() {
            self.film = None;
        }
        self.tracer.patch(patch)
    }

    fn cast_into(&mut self, rays: &[Ray], hits: &mut [Hit]) -> Result<(), TraceError> {
        self.tracer.cast_into(rays, hits)
    }

    fn render(&mut self, frame: &Frame, progress: &Progress) -> Result<(), TraceError> {
        let Some(shot) = self.exposed() else { return self.tracer.render(frame, progress) };
        frame.check()?;
        let mut film = match self.film.take() {
            Some(film) if frame.continues(&film.frame) => ExposedFilm { frame: frame.clone(), ..film },
            _ => ExposedFilm::new(frame, Film::new(frame.width, frame.height, frame.region, frame.first_sample)),
        };
        let result = self.expose(&mut film, &shot, progress);
        self.film = Some(film);
        result
    }

    fn read(&mut self, film: &mut Film) -> Result<(), TraceError> {
        let Some(shot) = self.exposed() else { return self.tracer.read(film) };
        let mut own = self.film.take().ok_or(TraceError::NoFilm)?;
        let mut read = || loop {
            if !own.is_within {
                film.clone_from(&own.copy);
                return Ok(());
            }
            let (result, had) = (self.tracer.read(film), own.least);
            if own.after(result)?.is_some() {
                return Ok(());
            }
            // What was lost is rendered again.
            let wanted = std::mem::replace(&mut own.frame.samples, had);
            let rendered = self.expose(&mut own, &shot, &Progress::default());
            own.frame.samples = wanted;
            rendered?;
        };
        let result = read();
        film.aovs.clone_from(&own.aovs);
        self.film = Some(own);
        result
    }

    fn resume(&mut self, frame: &Frame, film: Film) -> Result<(), TraceError> {
        if self.exposed().is_none() {
            return self.tracer.resume(frame, film);
        }
        frame.check()?;
        frame.check_film(&film)?;
        self.film = Some(ExposedFilm::new(frame, film));
        Ok(())
    }

    fn set_moment(&mut self, placement: Option<&Placement>, frame: &Frame) -> Result<(), TraceError> {
        if self.exposed().is_some() {
            return Err(TraceError::BadFrame("the moments are those of the shot".into()));
        }
        self.tracer.set_moment(placement, frame)
    }

    fn take_notes(&mut self) -> Vec<String> {
        self.tracer.take_notes()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;
    use voxtrace_scene::camera::Lens;

    #[test]
    fn moments_lie_one_in_each_part_of_the_exposure_whatever_their_number() {
        for seed in [0, 1, 77] {
            for bits in 0..8u32 {
                let count = 1 << bits;
                for from in [0, count, 5 * count] {
                    let mut parts: Vec<u32> = (from..from + count)
                        .map(|sample| {
                            // The turn moves all parts alike.
                            let share = share_of_exposure(seed, sample) - share_of_exposure(seed, from);
                            ((share - share.floor()) * f64::from(count)).round() as u32 % count
                        })
                        .collect();
                    parts.sort_unstable();
                    assert!(parts.iter().copied().eq(0..count), "{parts:?}");
                }
            }
            assert!((0..100).all(|sample| (0.0..1.0).contains(&share_of_exposure(seed, sample))));
        }
        assert_ne!(share_of_exposure(0, 0), share_of_exposure(1, 0));
    }

    #[test]
    fn stamps_tell_exposures_apart_in_which_the_focus_moves() {
        let stamp = |speed: f32| {
            let at = move |seconds: f64| {
                let focus = 9.0 + speed * (seconds as f32 - 0.5);
                let lens = Lens::Thin { aperture: 1.0, focus, blades: 0, blade_rotation: 0.0 };
                Ok(Moment { camera: Camera::look_at(Vec3::X, Vec3::ZERO).with_lens(lens), placement: None })
            };
            Shot { opens: 0.0, exposure: 1.0, moments: Arc::new(at) }.stamp(7).unwrap()
        };
        assert_eq!(stamp(2.0), stamp(2.0));
        assert_ne!(stamp(2.0), stamp(4.0), "in the middle both are the same");
    }
}
