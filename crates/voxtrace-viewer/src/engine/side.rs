//! One of the pictures that the engine traces: its tracer, how far it is, and the pictures that it has made.

mod real_time;

use super::any_tracer::AnyTracer;
use super::pace::{Pace, Step};
use super::pictures::Pictures;
use super::{Backend, Shown, View};
use real_time::RealTime;
use std::sync::Arc;
use std::time::Instant;
use voxtrace::{CpuTracer, Film, Frame, PackedScene, Patch, Progress, Ray, TraceError, Tracer};
use voxtrace_vulkan::{Device, Picture, Under, VulkanTracer};

/// Milliseconds of a picture on a device that shares its queue with the window, and on the processor.
const DEVICE_MS: f64 = 10.0;
const CPU_MS: f64 = 80.0;

/// What came of a step.
pub(super) enum Stepped {
    /// A picture to be shown.
    Picture(Shown),
    /// A request ended it.
    Cancelled,
    /// The device was lost, and pictures lie on this one from now on: the next step makes one.
    Moved(Arc<Device>),
    /// The device was lost; the next step opens it anew.
    Lost,
}

/// What a step may do.
#[derive(Clone, Copy)]
pub(super) struct Turn {
    /// Most samples.
    pub most: u32,
    /// Whether the view moves on.
    pub is_moving: bool,
}

/// What a film is laid over, and how much of the film is seen.
type Below = Option<(Arc<Picture>, f32)>;

/// A film that grows, and its pictures.
pub(super) struct Side {
    pub backend: Backend,
    /// Whether the processor traces although a device was asked for, which failed.
    pub stands_in: bool,
    /// With the scene set; made when first needed.
    tracer: Option<AnyTracer>,
    /// Samples of the view at full resolution.
    pub done: u32,
    /// What the tracer's film was made of, where that is of an earlier view.
    left: Option<Frame>,
    /// What the tracer rendered last.
    last: Option<Frame>,
    pace: Pace,
    pictures: Pictures,
    real_time: RealTime,
    /// The film of the processor, kept for its memory.
    film: Film,
    /// What went wrong and was mended, for people.
    pub notes: Vec<String>,
}

impl Side {
    pub fn new(backend: Backend) -> Self {
        Self {
            backend,
            stands_in: false,
            tracer: None,
            done: 0,
            left: None,
            last: None,
            pace: Pace::new(CPU_MS),
            pictures: Pictures::default(),
            real_time: RealTime::default(),
            film: empty_film(),
            notes: Vec::new(),
        }
    }

    /// Begins a new film.
    pub fn begin(&mut self) {
        self.done = 0;
        self.left = self.last.take().or(self.left.take());
        self.pace.begin();
        self.real_time.begin();
    }

    /// Gives back what the scene takes.
    pub fn close(&mut self) {
        (self.tracer, self.stands_in) = (None, false);
        self.real_time.forget();
        self.begin();
    }

    /// Takes another scene in the place of an old one, or the same in another light.
    pub fn take_scene(&mut self, scenes: Option<(&Arc<PackedScene>, &Arc<PackedScene>)>) {
        if let (Some((old, scene)), Some(tracer)) = (scenes, &mut self.tracer)
            && Arc::ptr_eq(old.geometry(), scene.geometry())
            // Where things moved, a device takes their places alone; then another light is no upload.
            && (std::ptr::eq(old.instances(), scene.instances())
                || tracer.as_tracer().set_placement(scene.placement()).is_ok())
            && tracer.set_light_of(scene).is_ok()
        {
            // The tracer forgot its film.
            (self.last, self.left) = (None, None);
            return;
        }
        // The old scene's memory is free before the new one takes its own.
        self.close();
    }

    /// The scene that is traced, once there is a tracer.
    pub fn scene(&self) -> Option<Arc<PackedScene>> {
        self.tracer.as_ref().and_then(AnyTracer::scene)
    }

    /// Follows an edit of the scene. Where that fails, nothing is traced before a scene is set again.
    pub fn follow(&mut self, patch: &Patch) -> Result<(), TraceError> {
        let Some(tracer) = &mut self.tracer else { return Ok(()) };
        let followed = tracer.as_tracer().patch(patch);
        self.notes.extend(tracer.as_tracer().take_notes());
        if followed.is_err() {
            self.close();
        }
        // The tracer forgot its film.
        self.begin();
        (self.last, self.left) = (None, None);
        followed
    }

    /// Lets the processor trace from now on.
    pub fn stand_in(&mut self) {
        self.close();
        self.stands_in = true;
        self.pictures = Pictures::default();
    }

    /// Whether a device traces, or is to.
    pub fn is_on_device(&self) -> bool {
        let is_cpu = matches!(&self.tracer, Some(AnyTracer::Cpu(_)));
        self.backend != Backend::Cpu && !self.stands_in && !is_cpu
    }

    /// Pictures lie on `device` from now on. What traces on another one, which was lost, is closed.
    pub fn leave_device(&mut self, device: &Arc<Device>) {
        self.pictures = Pictures::default();
        self.real_time.forget();
        if let Some(AnyTracer::Device(tracer)) = &self.tracer
            && !tracer.is_on_cpu()
            && !Arc::ptr_eq(tracer.device(), device)
        {
            self.close();
        }
    }

    /// Opens the device that was `lost` anew, where this side traces on it, and goes on with the film as far as it was kept. Returns the device
    /// that it traces on then.
    pub fn recover(&mut self, lost: &Arc<Device>) -> Result<Option<Arc<Device>>, TraceError> {
        let Some(AnyTracer::Device(tracer)) = &mut self.tracer else { return Ok(None) };
        if tracer.is_on_cpu() {
            return Ok(None);
        }
        if Arc::ptr_eq(tracer.device(), lost) {
            tracer.lost("showing a frame")?;
            // What was not kept is traced again.
            self.done = tracer.samples();
            self.pace.begin();
        }
        self.notes.extend(tracer.take_notes());
        let device = Arc::clone(tracer.device());
        Ok((!tracer.is_on_cpu() && !Arc::ptr_eq(&device, lost)).then_some(device))
    }

    /// The film as it is, shown in another light, or from another device: its `last` picture went with the old one. `None` where there is no whole
    /// film; the next step shows it then.
    pub fn shown_again(&mut self, view: &View, last: Option<Shown>, device: &Arc<Device>) -> Option<Shown> {
        let is_whole = self.done > 0 && !self.lacks_samples(view, device);
        let last = last.filter(|_| is_whole && self.tracer.is_some());
        let frame = view.frame().samples(self.done);
        let picture = last.as_ref().and_then(|_| self.resolve(&frame, None, device).ok().flatten());
        match (last, picture) {
            (Some(last), Some(picture)) => Some(Shown { picture, samples: self.done, scale: 1, lit: None, ..last }),
            _ => {
                self.pace.begin();
                None
            }
        }
    }

    /// Whether the next step makes the first picture of its view.
    pub fn is_first(&self) -> bool {
        self.pace.is_first()
    }

    /// Whether a step may be taken: samples are missing, and a coarse picture of a view that moves on is not refined.
    pub fn is_open(&self, samples: u32, is_moving: bool) -> bool {
        self.done < samples && !(is_moving && self.pace.is_coarse())
    }

    /// How far it is, the less the earlier: nothing shown, then coarse pictures, then samples.
    pub fn place(&self) -> (u32, u32) {
        (self.pace.fineness(), self.done)
    }

    /// Traces one step of the view: a frame of real-time light, or samples of the film.
    pub fn step(
        &mut self,
        scene: &Arc<PackedScene>,
        view: &View,
        turn: Turn,
        device: &Arc<Device>,
        progress: &Progress,
    ) -> Result<Stepped, TraceError> {
        let is_lit = self.has_real_time(view, device);
        // The first picture of a tracer is one of the film, as coarse as can be: it comes at once, and says how quick the device is.
        let is_known = self.tracer.is_some() && self.pace.is_measured();
        if is_lit && is_known && (turn.is_moving || self.is_frame_next(view)) {
            return self.step_real_time(scene, view, turn.is_moving, device);
        }
        self.open_tracer(scene, device)?;
        let Some(tracer) = &mut self.tracer else { return Err(TraceError::NoScene) };
        let pixels = u64::from(view.width) * u64::from(view.height);
        let step = self.pace.next(pixels, turn.most);
        let (width, height) = (view.width.div_ceil(step.scale), view.height.div_ceil(step.scale));
        let is_whole = step.scale == 1;
        let samples = if is_whole { self.done + step.samples } else { 1 };
        let frame = view.frame_in(scene).size(width, height).samples(samples);
        if self.left.take().is_some_and(|left| frame.continues(&left)) {
            // The view went away and came back before anything else was traced. The tracer's film may have more samples than are asked
            // for now: another frame makes it forget that one.
            tracer.as_tracer().render(&frame.clone().size(1, 1).samples(1), &Progress::default())?;
        }
        self.last = Some(frame.clone());
        let below = self.under(samples, view).filter(|_| is_lit && is_whole);
        let weight = below.as_ref().map_or(1.0, |(_, weight)| *weight);
        let start = Instant::now();
        let shown = self.render(&frame, below.clone(), device, progress)?;
        if progress.is_cancelled() {
            return Ok(Stepped::Cancelled);
        }
        let mut ms = start.elapsed().as_secs_f64() * 1e3;
        if let Some(moved) = self.moved_from(device)? {
            return Ok(Stepped::Moved(moved));
        }
        if let Some(AnyTracer::Device(tracer)) = &self.tracer {
            let gpu_ms = tracer.statistics().gpu_ms;
            ms = if gpu_ms > 0.0 { gpu_ms } else { ms };
        }
        if weight > 0.0 {
            let shown = match shown {
                Some(picture) => Some(picture),
                None => self.resolve(&frame, below, device)?,
            };
            let Some(picture) = shown else { return Ok(Stepped::Lost) };
            self.stepped(step, pixels, ms, is_whole.then_some(samples));
            let samples = if is_whole { samples } else { 0 };
            return Ok(Stepped::Picture(self.shown(picture, (samples, step.scale), (ms, step.samples), weight)));
        }
        self.stepped(step, pixels, ms, Some(samples));
        self.show_lit(view, (ms, step.samples), device)
    }

    /// A step was taken, after which the film has `done` samples, where it was one of the film.
    fn stepped(&mut self, step: Step, pixels: u64, ms: f64, done: Option<u32>) {
        self.pace.update(step, pixels, ms);
        self.done = done.unwrap_or(self.done);
        self.real_time.film_came();
    }

    /// Renders a frame. Returns its picture where a device made that with the last samples.
    fn render(
        &mut self,
        frame: &Frame,
        below: Below,
        device: &Arc<Device>,
        progress: &Progress,
    ) -> Result<Option<Arc<Picture>>, TraceError> {
        let is_seen = below.as_ref().is_none_or(|(_, weight)| *weight > 0.0);
        let by_host = self.is_by_host();
        let picture = (!by_host && is_seen)
            .then(|| self.pictures.free(device, frame.width, frame.height, by_host))
            .transpose()?;
        let Some(tracer) = &mut self.tracer else { return Err(TraceError::NoScene) };
        let rendered = match (&mut *tracer, &picture) {
            (AnyTracer::Device(tracer), Some(picture)) => {
                tracer.render_over(frame, progress, picture, below.as_ref().map(under))
            }
            _ => tracer.as_tracer().render(frame, progress).map(|()| None),
        };
        self.notes.extend(tracer.as_tracer().take_notes());
        // A device that is lost while it shows: the next step makes the picture.
        let is_shown = match rendered {
            Err(TraceError::DeviceLost { .. }) => false,
            rendered => rendered?.is_some(),
        };
        if let Some(picture) = &picture {
            self.pictures.keep(picture);
        }
        Ok(picture.filter(|_| is_shown))
    }

    /// Makes the tracer with the scene, where there is none.
    fn open_tracer(&mut self, scene: &Arc<PackedScene>, device: &Arc<Device>) -> Result<(), TraceError> {
        if self.tracer.is_some() {
            return Ok(());
        }
        let (mut tracer, budget_ms) = match self.backend {
            Backend::Cpu => (AnyTracer::Cpu(Box::new(CpuTracer::new(None))), CPU_MS),
            Backend::Device(_) if self.stands_in => (AnyTracer::Cpu(Box::new(CpuTracer::new(None))), CPU_MS),
            Backend::Device(settings) => {
                let mut tracer = VulkanTracer::new(Arc::clone(device), settings)?;
                tracer.set_submit_ms(DEVICE_MS);
                (AnyTracer::Device(Box::new(tracer)), DEVICE_MS)
            }
        };
        tracer.as_tracer().set_scene(scene)?;
        self.pace = Pace::new(budget_ms);
        self.tracer = Some(tracer);
        Ok(())
    }

    /// Whether the processor makes the picture: by itself, or in the place of a device that was lost for good.
    fn is_by_host(&self) -> bool {
        match &self.tracer {
            Some(AnyTracer::Device(tracer)) => tracer.is_on_cpu(),
            _ => true,
        }
    }

    /// The device that the tracer went to by itself, where that is another one.
    fn moved_from(&self, device: &Arc<Device>) -> Result<Option<Arc<Device>>, TraceError> {
        let Some(AnyTracer::Device(tracer)) = &self.tracer else { return Ok(None) };
        let is_same = Arc::ptr_eq(tracer.device(), device);
        match tracer.is_on_cpu() {
            // It gave the device up, which may be lost; what shows pictures needs one.
            true if is_same => device.reopened().map(Some),
            false if !is_same => Ok(Some(Arc::clone(tracer.device()))),
            _ => Ok(None),
        }
    }

    /// A picture of the tracer's film, `None` where the device was lost and the next step makes one.
    fn resolve(
        &mut self,
        frame: &Frame,
        below: Below,
        device: &Arc<Device>,
    ) -> Result<Option<Arc<Picture>>, TraceError> {
        let by_host = self.is_by_host();
        let mut picture = self.pictures.free(device, frame.width, frame.height, by_host)?;
        match &mut self.tracer {
            Some(AnyTracer::Device(tracer)) if !by_host => {
                match tracer.resolve_over(&picture, below.as_ref().map(under)) {
                    Err(TraceError::DeviceLost { .. }) => return Ok(None),
                    result => drop(result?),
                }
            }
            Some(tracer) => {
                tracer.as_tracer().read(&mut self.film)?;
                // Nobody else holds a free picture.
                if let Some(picture) = Arc::get_mut(&mut picture) {
                    picture.write(&self.film);
                }
            }
            None => return Ok(None),
        }
        self.pictures.keep(&picture);
        Ok(Some(picture))
    }

    /// The film at full resolution, where its pixels have samples.
    pub fn whole_film(&mut self, view: &View) -> Option<(Frame, Film)> {
        let lines = self.last.as_ref().map_or(view.lines, |last| last.lines);
        let frame = view.frame().lines(lines).samples(self.done);
        let tracer = self.tracer.as_mut().filter(|_| self.done > 0)?;
        let mut film = empty_film();
        tracer.as_tracer().read(&mut film).ok()?;
        (film.width == frame.width && film.sample_range() == (self.done, self.done)).then_some((frame, film))
    }

    /// What rays meet, by this side's tracer.
    pub fn cast(&mut self, rays: &[Ray]) -> Result<Vec<voxtrace::Hit>, TraceError> {
        let mut hits = vec![voxtrace::Hit::MISS; rays.len()];
        let tracer = self.tracer.as_mut().ok_or(TraceError::NoScene)?;
        tracer.as_tracer().cast_into(rays, &mut hits)?;
        Ok(hits)
    }
}

/// What lies under a film, as tracers take it.
fn under((picture, film_weight): &(Arc<Picture>, f32)) -> Under<'_> {
    Under { picture, film_weight: *film_weight }
}

fn empty_film() -> Film {
    Film::new(0, 0, voxtrace::Region::full(0, 0), 0)
}
