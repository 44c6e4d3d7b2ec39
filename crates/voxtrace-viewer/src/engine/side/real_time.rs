//! Real-time light of a picture: frames that are clean at one path a pixel while the view moves, and that lie under the film while it
//! has few samples. The film itself never has anything of them.

use super::super::any_tracer::AnyTracer;
use super::super::{Light, Lit, RealTimeChoice, Shown, View};
use super::{Side, Stepped};
use crate::tr;
use std::sync::Arc;
use std::time::Instant;
use voxtrace::{Integrator, PackedScene, TraceError, Tracer};
use voxtrace_vulkan::{Device, DeviceKind, Picture};

/// Samples from which on the film alone is seen, and how many doublings before that its first trace is.
const CLEAN: u32 = 256;
const DOUBLINGS: f32 = 4.0;
/// Frames beside the film of a view that stands: so many are remembered of a pixel.
const BESIDE: u32 = 64;
/// Milliseconds that one of them may take.
const STILL_MS: f64 = 250.0;

/// What a side knows of real-time light.
#[derive(Default)]
pub struct RealTime {
    /// Whether it is wanted.
    pub light: Light,
    /// Whether the tracer cannot.
    is_refused: bool,
    /// Whether the next step is a frame, where the film takes turns with it.
    is_next: bool,
    /// Frames of this view since it stands.
    beside: u32,
    /// The last frame, and the pixels of the window along each side of its pixels.
    picture: Option<(Arc<Picture>, u32)>,
    /// What it took.
    lit: Option<Lit>,
}

impl RealTime {
    /// Another view, or another scene in the same place.
    pub fn begin(&mut self) {
        (self.is_next, self.beside) = (true, 0);
        self.picture = None;
    }

    /// The film had its turn.
    pub fn film_came(&mut self) {
        self.is_next = true;
    }

    /// Another tracer, or another device: what frames know is gone.
    pub fn forget(&mut self) {
        *self = Self { light: self.light, ..Self::default() };
        self.begin();
    }
}

/// Samples after which the film of a view is seen alone.
fn clean(samples: u32) -> u32 {
    samples.min(CLEAN)
}

/// How much of a film is seen that has `done` of so many samples, over a frame whose pixels have `scale` of the film's along each side: nothing
/// at first, then more with each doubling. It is the same for all pixels: a film has no second moments that would tell how noisy one of them is, and
/// what its neighbours tell would be seen as a pattern.
fn film_weight(done: u32, samples: u32, scale: u32) -> f32 {
    // A coarse frame is worth less.
    let alone = (clean(samples) as f32 / (scale * scale) as f32).max(1.0);
    match done {
        0 => 0.0,
        done if done >= clean(samples) => 1.0,
        done => (1.0 + (done as f32 / alone).log2() / DOUBLINGS).clamp(0.0, 1.0),
    }
}

impl Side {
    /// Shows views in this light from now on.
    pub fn set_light(&mut self, light: Light) {
        self.real_time.light = light;
        // Whoever turns it on wants it tried, also where there was no memory for it.
        self.real_time.is_refused = false;
        self.real_time.begin();
        if light.real_time == RealTimeChoice::Off {
            self.give_back();
        }
    }

    /// Gives back what frames take on the device.
    fn give_back(&mut self) {
        self.real_time.forget();
        if let Some(AnyTracer::Device(tracer)) = &mut self.tracer {
            tracer.forget_real_time();
        }
    }

    /// Makes room for what lacked memory, where real-time light takes some. Returns whether it does.
    pub fn makes_room_for(&mut self, error: &TraceError) -> bool {
        let can = matches!(error, TraceError::OutOfMemory { .. }) && self.real_time.lit.is_some();
        if can {
            self.refuse(error);
        }
        can
    }

    /// Whether a view is shown in real-time light while it moves.
    pub fn has_real_time(&self, view: &View, device: &Device) -> bool {
        let is_wanted = match self.real_time.light.real_time {
            RealTimeChoice::Off => false,
            // Devices in software would take seconds for each frame.
            RealTimeChoice::Auto => device.info().kind != DeviceKind::Cpu,
            RealTimeChoice::On => true,
        };
        let is_by_host = matches!(&self.tracer, Some(AnyTracer::Device(tracer)) if tracer.is_on_cpu());
        let can = self.is_on_device() && !is_by_host && !self.real_time.is_refused;
        // It is the light of `path`: what `essay` shows is not what it would go over to.
        is_wanted && can && view.integrator == Integrator::Path
    }

    /// The last frame, and how much is seen of a film over it that has `done` samples; `None` where that is all of it.
    pub(super) fn under(&self, done: u32, view: &View) -> Option<(Arc<Picture>, f32)> {
        let (picture, scale) = self.real_time.picture.as_ref()?;
        let weight =
            if self.real_time.light.is_bare && done > 0 { 1.0 } else { film_weight(done, view.samples, *scale) };
        (weight < 1.0).then(|| (Arc::clone(picture), weight))
    }

    /// Whether the film alone would be too noisy to be shown.
    pub(in crate::engine) fn lacks_samples(&self, view: &View, device: &Device) -> bool {
        self.has_real_time(view, device) && self.lacks_film(view)
    }

    fn lacks_film(&self, view: &View) -> bool {
        match self.real_time.light.is_bare {
            true => self.done == 0,
            false => film_weight(self.done, view.samples, 1) < 1.0,
        }
    }

    /// Whether the next step of a view that stands is a frame, in turns with the film.
    pub(super) fn is_frame_next(&self, view: &View) -> bool {
        let RealTime { is_next, beside, picture, .. } = &self.real_time;
        // After a loss the film may have samples, and nothing lies under it.
        let is_due = picture.is_none() && self.lacks_film(view) || self.under(self.done, view).is_some();
        // Frames become as fine as they can be before the film has its turns.
        let finest = self.pace.quality.still(STILL_MS).scale;
        let is_coarse = self.done == 0 && picture.as_ref().is_some_and(|(_, scale)| finest < *scale);
        is_coarse || is_due && *is_next && *beside < BESIDE
    }

    /// Traces a frame and shows it, with the film over it where that has samples enough to be seen.
    pub(super) fn step_real_time(
        &mut self,
        scene: &Arc<PackedScene>,
        view: &View,
        is_moving: bool,
        device: &Arc<Device>,
    ) -> Result<Stepped, TraceError> {
        self.open_tracer(scene, device)?;
        self.real_time.is_next = false;
        let Some(AnyTracer::Device(tracer)) = &mut self.tracer else { return Ok(Stepped::Lost) };
        self.pace.quality.begin(self.pace.guess(u64::from(view.width) * u64::from(view.height)));
        let quality = if is_moving { self.pace.quality.moving() } else { self.pace.quality.still(STILL_MS) };
        let (width, height) = (view.width.div_ceil(quality.scale), view.height.div_ceil(quality.scale));
        let picture = self.pictures.free(device, width, height, false)?;
        let frame = view.frame_in(scene).size(width, height).samples(1);
        let start = Instant::now();
        let traced = tracer.show_real_time(&frame, quality.rate, &picture);
        let ms = start.elapsed().as_secs_f64() * 1e3;
        self.notes.extend(tracer.take_notes());
        self.pictures.keep(&picture);
        let frame = match traced {
            Ok(frame) => frame,
            Err(TraceError::DeviceLost { .. }) => None,
            // The film needs less.
            Err(error @ (TraceError::Unsupported(_) | TraceError::OutOfMemory { .. })) => {
                self.refuse(&error);
                return Ok(Stepped::Lost);
            }
            Err(error) => return Err(error),
        };
        if let Some(moved) = self.moved_from(device)? {
            // What was not kept of the film is traced again.
            if let Some(AnyTracer::Device(tracer)) = &self.tracer {
                self.done = self.done.min(tracer.samples());
            }
            return Ok(Stepped::Moved(moved));
        }
        let Some(frame) = frame else { return Ok(Stepped::Lost) };
        let step_ms = if frame.gpu_ms > 0.0 { frame.gpu_ms } else { ms };
        self.pace.quality.update(quality, step_ms / f64::from(frame.frames));
        self.pace.lit();
        self.real_time.beside += u32::from(!is_moving);
        self.real_time.picture = Some((picture, quality.scale));
        self.real_time.lit = Some(Lit { frame: Arc::new(frame), quality, film_weight: 0.0 });
        self.show_lit(view, (step_ms, 0), device)
    }

    /// Shows the film alone from now on.
    fn refuse(&mut self, error: &TraceError) {
        self.notes.push(tr!("real_time.refused", error = error));
        self.give_back();
        self.real_time.is_refused = true;
    }

    /// Shows the last frame with the film over it. The last step took so many milliseconds for so many samples.
    pub(super) fn show_lit(
        &mut self,
        view: &View,
        step: (f64, u32),
        device: &Arc<Device>,
    ) -> Result<Stepped, TraceError> {
        let Some((frame, scale)) = self.real_time.picture.clone() else { return Ok(Stepped::Lost) };
        let under = self.under(self.done, view);
        let weight = under.as_ref().map_or(1.0, |(_, weight)| *weight);
        if weight == 0.0 {
            return Ok(Stepped::Picture(self.shown(frame, (self.done, scale), step, weight)));
        }
        match self.resolve(&view.frame().samples(self.done), under, device)? {
            Some(picture) => Ok(Stepped::Picture(self.shown(picture, (self.done, 1), step, weight))),
            None => Ok(Stepped::Lost),
        }
    }

    /// What is shown, and what is known about it.
    pub(super) fn shown(
        &self,
        picture: Arc<Picture>,
        (samples, scale): (u32, u32),
        (step_ms, step_samples): (f64, u32),
        film_weight: f32,
    ) -> Shown {
        let device = match &self.tracer {
            Some(AnyTracer::Device(tracer)) => Some((tracer.statistics(), tracer.memory())),
            _ => None,
        };
        let lit = self.real_time.lit.clone().filter(|_| film_weight < 1.0).map(|lit| Lit { film_weight, ..lit });
        Shown { picture, samples, scale, step_ms, step_samples, device, lit }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_film_comes_slowly_and_is_alone_in_the_end() {
        for samples in [1, 6, 64, 256, 4096] {
            for scale in [1, 2, 8] {
                let weights: Vec<f32> = (0..=samples).map(|done| film_weight(done, samples, scale)).collect();
                assert_eq!(weights[0], 0.0);
                assert!(weights.windows(2).all(|pair| pair[0] <= pair[1]), "{samples} samples: {weights:?}");
                assert!(weights[clean(samples) as usize..].iter().all(|&weight| weight == 1.0));
            }
        }
        // No step of a sample is seen.
        let weights: Vec<f32> = (0..=300).map(|done| film_weight(done, 4096, 1)).collect();
        assert!(weights.windows(2).all(|pair| pair[1] - pair[0] < 0.03), "{weights:?}");
        assert_eq!((weights[16], weights[64], weights[256]), (0.0, 0.5, 1.0));
    }
}
