//! Rendering samples of a part of a film.

use super::Worker;
use super::show::Show;
use crate::commands::Finished;
use crate::film::{DeviceFilm, Part};
use crate::records::{Counter, Dispatch, FrameParams, binding};
use crate::schedule::Round;
use crate::variant::{Entry, Variant};
use crate::watch::Watch;
use std::time::Instant;
use voxtrace_core::{Frame, TraceError};

impl Worker {
    /// Makes the program that renders so many samples of a part of a film, and tells it about the frame. Nothing may be in flight.
    pub(super) fn prepare_part(&mut self, part: &Part, samples: u64, frame: &Frame) -> Result<Variant, TraceError> {
        let params = FrameParams::of_frame(self.scene()?, &frame.clone().region(part.region));
        let mut variant = self.variant(Entry::of(frame.integrator), (params.lens, params.sky), Some(frame))?;
        if variant.has_catcher {
            self.prepare_catcher()?;
        }
        match self.prepare_waves(variant, samples)? {
            Some(in_waves) => variant = in_waves,
            None => self.passes.prepare(variant)?,
        }
        self.set_params(&params);
        self.bindings.bind(binding::PIXELS, &part.pixels);
        Ok(variant)
    }

    /// Brings one part of the film up to `target` samples. Returns false where it ran out of time.
    pub(super) fn render_part(
        &mut self,
        film: &mut DeviceFilm,
        (index, target): (usize, u32),
        frame: &Frame,
        progress: &mut Watch,
        until: Instant,
        show: Option<Show>,
    ) -> Result<bool, TraceError> {
        if self.scene.as_ref().is_some_and(|buffers| buffers.pages.is_some()) {
            return self.render_part_in_pages(film, (index, target), frame, progress, until);
        }
        let part = &mut film.parts[index];
        let pixels = part.region.pixels() as u64;
        let missing = target.saturating_sub(part.samples);
        let variant = self.prepare_part(part, pixels.saturating_mul(missing.into()), frame)?;
        let waves = self.waves.as_ref().filter(|_| variant.is_in_waves());
        let most_pixels = waves.map_or(self.passes.most_items(), |waves| waves.most_pixels(pixels));
        let most_samples = waves.map_or(u32::MAX, |waves| waves.most_samples(pixels));
        let mut is_late = false;
        while part.samples < target && !progress.is_cancelled() && !is_late {
            let mut round = Round::new(&self.render_batches, pixels, (target - part.samples).min(most_samples));
            // Pixels that a round left ahead when it was broken off wait for the others.
            let samples_target = part.samples + round.samples();
            let mut is_whole = true;
            while let Some(block) = round.next(&self.render_batches, most_pixels) {
                is_late = Instant::now() >= until;
                is_whole = !progress.is_cancelled() && !is_late;
                if !is_whole {
                    break;
                }
                let dispatch = Dispatch {
                    first: block.first as u32,
                    count: block.count as u32,
                    samples: block.samples,
                    samples_target,
                    ..Dispatch::default()
                };
                let work = block.count * u64::from(block.samples);
                let is_last = round.is_over() && samples_target >= target;
                let finished = self.submit("rendering", variant, dispatch, work, show.filter(|_| is_last))?;
                self.render_done(finished, progress);
            }
            if is_whole {
                part.samples += round.samples();
            }
        }
        while let Some(finished) = self.submitter.wait()? {
            self.render_done(Some(finished), progress);
        }
        Ok(!is_late || progress.is_cancelled())
    }

    pub(super) fn render_done(&mut self, finished: Option<Finished>, progress: &mut Watch) {
        if let Some(finished) = finished {
            let samples = u64::from(finished.counters[Counter::CameraRays as usize]);
            self.render_batches.update(samples, finished.gpu_ms);
            self.statistics.add(&finished);
            self.shown_ms = finished.then_ms.or(self.shown_ms);
            progress.add(samples);
        }
    }
}
