//! Showing the film: the mean of its samples goes to a picture, in the submit that adds the last of them where that can be, so that a
//! frame of a window does not wait for another one.

use super::Worker;
use crate::commands::Job;
use crate::film::DeviceFilm;
use crate::passes::Passes;
use crate::picture::Picture;
use crate::records::{Dispatch, LENS_PINHOLE, SKY_GRADIENT, binding};
use crate::spirv;
use crate::variant::{Entry, Variant};
use std::sync::Arc;
use voxtrace_core::TraceError;

/// A launch of the pass that shows pixels of a buffer.
#[derive(Clone, Copy)]
pub(super) struct Show {
    pub variant: Variant,
    /// The first of them, in the buffer.
    pub first: u32,
    pub count: u32,
    /// Place in the picture where the buffer begins.
    pub place: u32,
}

impl Show {
    pub fn dispatch(&self) -> Dispatch {
        Dispatch { first: self.first, count: self.count, samples: self.place, ..Dispatch::default() }
    }
}

impl Worker {
    /// Makes the film's last samples show it in `picture`, where one launch does that: a film in one buffer, and no more pixels than a launch
    /// may have. Nothing may be in flight.
    pub(super) fn show_with_samples(
        &mut self,
        film: &DeviceFilm,
        picture: Option<&Picture>,
    ) -> Result<Option<Show>, TraceError> {
        self.shown_ms = None;
        let Some(picture) = picture.filter(|picture| self.suits(picture, film)) else { return Ok(None) };
        let (variant, most) = self.prepare_show(picture)?;
        let [part] = &film.parts[..] else { return Ok(None) };
        let pixels = part.region.pixels() as u64;
        Ok((pixels <= most).then_some(Show { variant, first: 0, count: pixels as u32, place: 0 }))
    }

    /// Milliseconds of the picture that the last call of `render` wrote, by the device's clock; `None` where it wrote none.
    pub fn take_shown(&mut self) -> Option<f64> {
        self.shown_ms.take()
    }

    /// What stays bound must not go away before it. Nothing may be in flight.
    pub(super) fn stop_showing(&self) {
        self.bindings.bind(binding::HITS, &self.nothing);
    }

    /// Writes the mean of the film's samples to a picture of its size. Returns the device's milliseconds.
    pub fn resolve(&mut self, picture: &Picture) -> Result<f64, TraceError> {
        let film = self.film.take().ok_or(TraceError::NoFilm)?;
        let result = match self.suits(picture, &film) {
            true => self.resolve_film(picture, &film),
            false => Err(TraceError::BadFrame("the picture has another size or lies on another device".into())),
        };
        self.stop_showing();
        self.film = Some(film);
        result
    }

    fn resolve_film(&mut self, picture: &Picture, film: &DeviceFilm) -> Result<f64, TraceError> {
        let (variant, most) = self.prepare_show(picture)?;
        let Some(passes) = &self.resolve_passes else { return Err(TraceError::NoFilm) };
        let (mut place, mut gpu_ms) = (0, 0.0);
        for part in &film.parts {
            self.bindings.bind(binding::PIXELS, &part.pixels);
            let pixels = part.region.pixels() as u64;
            let mut first = 0;
            while first < pixels {
                let count = (pixels - first).min(most);
                let show = Show { variant, first: first as u32, count: count as u32, place };
                let record = |commands, offset| passes.launch(variant, &self.bindings, commands, offset, show.count);
                let workgroups = Some(passes.proof(variant, show.count));
                let (step, dispatch) = ("showing the film", show.dispatch());
                let job = Job { step, work: 0, dispatch, workgroups, record: &record, then: None };
                gpu_ms += self.submitter.run(&job)?.gpu_ms;
                first += count;
            }
            place += pixels as u32;
        }
        Ok(gpu_ms)
    }

    fn suits(&self, picture: &Picture, film: &DeviceFilm) -> bool {
        let size = (film.frame.region.width(), film.frame.region.height());
        picture.size() == size && Arc::ptr_eq(picture.device(), &self.device)
    }

    /// Makes the pass and binds the picture. Returns the variant, and the most pixels of one launch. Nothing may be in flight.
    fn prepare_show(&mut self, picture: &Picture) -> Result<(Variant, u64), TraceError> {
        let variant = self.variant(Entry::Resolve, (LENS_PINHOLE, SKY_GRADIENT), None)?;
        let made = self.resolve_passes.take();
        let made = made.unwrap_or_else(|| Passes::new(&self.device, &self.bindings, spirv::RESOLVE));
        let passes = self.resolve_passes.insert(made);
        passes.prepare(variant)?;
        self.bindings.bind(binding::HITS, picture.to_write());
        Ok((variant, passes.most_items()))
    }
}
