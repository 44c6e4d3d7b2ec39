//! Showing the film: the mean of its samples goes to a picture, in the submit that adds the last of them where that can be, so that a
//! frame of a window does not wait for another one. While the film has few samples it is laid over another picture.

use super::Worker;
use crate::barrier::barrier;
use crate::bindings::Bindings;
use crate::commands::Job;
use crate::device::Device;
use crate::film::DeviceFilm;
use crate::passes::{Launch, Passes, WORKGROUP};
use crate::picture::{Picture, Under};
use crate::records::{BlendParams, Dispatch, LENS_PINHOLE, SKY_GRADIENT, binding};
use crate::spirv;
use crate::variant::{Entry, Variant};
use ash::vk;
use std::sync::Arc;
use voxtrace_core::TraceError;

/// Where a film is shown.
#[derive(Clone, Copy)]
pub struct Canvas<'a> {
    pub picture: &'a Picture,
    /// What it is laid over, if anything.
    pub under: Option<Under<'a>>,
}

/// The passes that show films.
pub(super) struct ShowPasses {
    resolve: Passes,
    blend: Passes,
}

/// A launch of the pass that shows pixels of a buffer.
#[derive(Clone, Copy)]
pub(super) struct Show {
    pub variant: Variant,
    /// The first of them, in the buffer.
    pub first: u32,
    pub count: u32,
    /// Place in the picture where the buffer begins.
    pub place: u32,
    /// How it is laid over what is bound as rays, if it is.
    pub blend: Option<(Variant, BlendParams)>,
}

impl Show {
    pub fn dispatch(&self) -> Dispatch {
        Dispatch { first: self.first, count: self.count, samples: self.place, ..Dispatch::default() }
    }

    /// Workgroups that count themselves.
    pub fn proof(&self, passes: &ShowPasses) -> u32 {
        passes.resolve.proof(self.variant, self.count)
    }

    /// Records it, with the offset of the dispatch's input.
    pub fn record(
        &self,
        (bindings, device): (&Bindings, &Device),
        passes: &ShowPasses,
        commands: vk::CommandBuffer,
        offset: u32,
    ) {
        passes.resolve.launch(self.variant, bindings, commands, offset, self.count);
        if let Some((variant, params)) = self.blend {
            barrier(device, commands);
            let groups = Launch::Groups(self.count.div_ceil(WORKGROUP));
            passes.blend.launch_step(variant, bindings, commands, params, &groups);
        }
    }
}

impl Worker {
    /// Makes the film's last samples show it on a canvas, where one launch does that: a film in one buffer, and no more pixels than a launch
    /// may have. Nothing may be in flight.
    pub(super) fn show_with_samples(
        &mut self,
        film: &DeviceFilm,
        canvas: Option<Canvas>,
    ) -> Result<Option<Show>, TraceError> {
        self.shown_ms = None;
        let Some(canvas) = canvas.filter(|canvas| self.suits(canvas, film)) else { return Ok(None) };
        let (show, most) = self.prepare_show(canvas)?;
        let [part] = &film.parts[..] else { return Ok(None) };
        let pixels = part.region.pixels() as u64;
        Ok((pixels <= most).then_some(Show { count: pixels as u32, ..show }))
    }

    /// Milliseconds of the picture that the last call of `render` wrote, by the device's clock; `None` where it wrote none.
    pub fn take_shown(&mut self) -> Option<f64> {
        self.shown_ms.take()
    }

    /// What stays bound must not go away before it. Nothing may be in flight.
    pub(super) fn stop_showing(&self) {
        self.bindings.bind(binding::HITS, &self.nothing);
        self.bindings.bind(binding::RAYS, &self.nothing);
    }

    /// Writes the mean of the film's samples to a picture of its size, over what lies under it. Returns the device's milliseconds.
    pub fn resolve(&mut self, canvas: Canvas) -> Result<f64, TraceError> {
        let film = self.film.take().ok_or(TraceError::NoFilm)?;
        let result = match self.suits(&canvas, &film) {
            true => self.resolve_film(canvas, &film),
            false => Err(TraceError::BadFrame("the picture has another size or lies on another device".into())),
        };
        self.stop_showing();
        self.film = Some(film);
        result
    }

    fn resolve_film(&mut self, canvas: Canvas, film: &DeviceFilm) -> Result<f64, TraceError> {
        let (show, most) = self.prepare_show(canvas)?;
        let (mut place, mut gpu_ms) = (0, 0.0);
        for part in &film.parts {
            self.bindings.bind(binding::PIXELS, &part.pixels);
            let pixels = part.region.pixels() as u64;
            let mut first = 0;
            while first < pixels {
                let count = (pixels - first).min(most);
                gpu_ms += self.show(Show { first: first as u32, count: count as u32, place, ..show })?;
                first += count;
            }
            place += pixels as u32;
        }
        Ok(gpu_ms)
    }

    /// Shows some pixels. Returns the device's milliseconds.
    fn show(&mut self, show: Show) -> Result<f64, TraceError> {
        let Some(passes) = &self.show_passes else { return Err(TraceError::NoFilm) };
        let workgroups = Some(show.proof(passes));
        let (step, dispatch) = ("showing the film", show.dispatch());
        let shared = (&self.bindings, &*self.device);
        let record = |commands, offset| show.record(shared, passes, commands, offset);
        let job = Job { step, work: 0, dispatch, workgroups, record: &record, then: None };
        Ok(self.submitter.run(&job)?.gpu_ms)
    }

    fn suits(&self, canvas: &Canvas, film: &DeviceFilm) -> bool {
        let size = (film.frame.region.width(), film.frame.region.height());
        let is_here = |picture: &Picture| Arc::ptr_eq(picture.device(), &self.device);
        let is_under_here = canvas.under.is_none_or(|under| is_here(under.picture));
        canvas.picture.size() == size && is_here(canvas.picture) && is_under_here
    }

    /// Makes the passes and binds the pictures. Returns what is launched, without its pixels, and the most of them in one launch. Nothing may be in
    /// flight.
    fn prepare_show(&mut self, canvas: Canvas) -> Result<(Show, u64), TraceError> {
        let variant = self.variant(Entry::Resolve, (LENS_PINHOLE, SKY_GRADIENT), None)?;
        let made = self.show_passes.take().unwrap_or_else(|| {
            let passes = |module| Passes::new(&self.device, &self.bindings, module);
            ShowPasses { resolve: passes(spirv::RESOLVE), blend: passes(spirv::BLEND) }
        });
        let passes = self.show_passes.insert(made);
        passes.resolve.prepare(variant)?;
        let mut blend = None;
        if let Some(Under { picture, film_weight }) = canvas.under {
            let over = Variant { entry: Entry::Blend, ..variant };
            passes.blend.prepare(over)?;
            self.bindings.bind(binding::RAYS, picture.to_read());
            let ((width, height), (under_width, under_height)) = (canvas.picture.size(), picture.size());
            blend = Some((over, BlendParams { width, height, under_width, under_height, film_weight }));
        }
        self.bindings.bind(binding::HITS, canvas.picture.to_write());
        Ok((Show { variant, first: 0, count: 0, place: 0, blend }, passes.resolve.most_items()))
    }
}
