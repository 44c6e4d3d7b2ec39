//! What the tracing thread does: it takes the wishes that wait, traces a step of the view, and shows it.

use super::pace::Pace;
use super::{Backend, Event, Request, Shared, Shown, View, locked};
use std::sync::Arc;
use std::sync::atomic::Ordering;
use std::sync::mpsc::{Receiver, TryRecvError};
use std::time::Instant;
use voxtrace::{CpuTracer, Film, Frame, PackedScene, Progress, TraceError, Tracer};
use voxtrace_vulkan::{Device, Picture, VulkanTracer};

/// Milliseconds of a picture on a device that shares its queue with the window, and on the processor.
const DEVICE_MS: f64 = 10.0;
const CPU_MS: f64 = 80.0;

/// Either kind of tracer.
enum AnyTracer {
    Cpu(Box<CpuTracer>),
    Device(Box<VulkanTracer>),
}

impl AnyTracer {
    fn as_tracer(&mut self) -> &mut dyn Tracer {
        match self {
            Self::Cpu(tracer) => &mut **tracer,
            Self::Device(tracer) => &mut **tracer,
        }
    }
}

/// The state of the thread.
pub(super) struct Worker {
    requests: Receiver<Request>,
    shared: Arc<Shared>,
    tell: Box<dyn Fn(Event) + Send>,
    device: Arc<Device>,
    backend: Backend,
    /// With the scene set; made when first needed.
    tracer: Option<AnyTracer>,
    scene: Option<Arc<PackedScene>>,
    view: Option<View>,
    is_moving: bool,
    is_paused: bool,
    has_failed: bool,
    /// Samples of the view at full resolution.
    done: u32,
    pace: Pace,
    /// Pictures that were made; those that nobody else holds are used again.
    pictures: Vec<Arc<Picture>>,
    /// The film of the processor, kept for its memory.
    film: Film,
}

impl Worker {
    /// A worker that has nothing to trace yet.
    pub fn new(
        requests: Receiver<Request>,
        shared: Arc<Shared>,
        tell: Box<dyn Fn(Event) + Send>,
        device: Arc<Device>,
        backend: Backend,
    ) -> Self {
        Self {
            requests,
            shared,
            tell,
            device,
            backend,
            tracer: None,
            scene: None,
            view: None,
            is_moving: false,
            is_paused: false,
            has_failed: false,
            done: 0,
            pace: Pace::new(CPU_MS),
            pictures: Vec::new(),
            film: Film::new(0, 0, voxtrace::Region::full(0, 0), 0),
        }
    }

    /// Works until the last wish.
    pub fn run(&mut self) {
        loop {
            let progress = Arc::new(Progress::default());
            *locked(&self.shared.progress) = Arc::clone(&progress);
            if !self.take_requests() {
                return;
            }
            if self.has_work()
                && let Err(error) = self.step(&progress)
            {
                self.fail(error);
            }
        }
    }

    fn has_work(&self) -> bool {
        // A coarse picture of a view that moves on is not refined.
        let waits = self.is_moving && self.pace.is_coarse();
        let is_open = self.view.as_ref().is_some_and(|view| self.done < view.samples);
        is_open && !waits && self.scene.is_some() && !self.is_paused && !self.has_failed
    }

    /// Takes all wishes that wait, or waits for one where there is nothing to do. Returns false at the end.
    fn take_requests(&mut self) -> bool {
        if !self.has_work() {
            match self.requests.recv() {
                Ok(request) => {
                    if !self.take(request) {
                        return false;
                    }
                }
                Err(_) => return false,
            }
        }
        loop {
            match self.requests.try_recv() {
                Ok(request) => {
                    if !self.take(request) {
                        return false;
                    }
                }
                Err(TryRecvError::Empty) => return true,
                Err(TryRecvError::Disconnected) => return false,
            }
        }
    }

    /// Takes a wish. Returns false where it is the last.
    fn take(&mut self, request: Request) -> bool {
        match request {
            Request::Quit => return false,
            Request::Pause(is_paused) => self.is_paused = is_paused,
            Request::Film(answer) => {
                // Whoever asked may be gone.
                let _ = answer.send(self.whole_film());
            }
            Request::Scene(scene) => {
                // The old scene's memory is free before the new one takes its own.
                self.tracer = None;
                self.scene = scene;
                self.begin();
            }
            Request::Backend(backend) => {
                if backend != self.backend {
                    self.tracer = None;
                    self.backend = backend;
                }
                self.begin();
            }
            Request::View { view, is_moving } => {
                self.is_moving = is_moving;
                let continues = self.view.as_ref().is_some_and(|last| view.frame().continues(&last.frame()));
                self.view = Some(*view);
                if !continues {
                    self.begin();
                }
            }
        }
        true
    }

    /// Begins a new film.
    fn begin(&mut self) {
        self.done = 0;
        self.has_failed = false;
        self.pace.begin();
    }

    fn fail(&mut self, error: TraceError) {
        self.has_failed = true;
        (self.tell)(Event::Failed(error));
    }

    /// Traces one step of the view and shows it.
    fn step(&mut self, progress: &Progress) -> Result<(), TraceError> {
        self.open_tracer()?;
        let (Some(view), Some(tracer)) = (&self.view, &mut self.tracer) else { return Ok(()) };
        let pixels = u64::from(view.width) * u64::from(view.height);
        let step = self.pace.next(pixels, view.samples - self.done);
        let (width, height) = (view.width.div_ceil(step.scale), view.height.div_ceil(step.scale));
        self.shared.is_first.store(self.pace.is_first(), Ordering::Relaxed);
        let is_whole = step.scale == 1;
        let samples = if is_whole { self.done + step.samples } else { 1 };
        let frame = view.frame().size(width, height).samples(samples);
        let start = Instant::now();
        let rendered = tracer.as_tracer().render(&frame, progress);
        let notes = tracer.as_tracer().take_notes();
        notes.into_iter().for_each(|note| (self.tell)(Event::Notice(note)));
        rendered?;
        if progress.is_cancelled() {
            return Ok(());
        }
        let mut ms = start.elapsed().as_secs_f64() * 1e3;
        let Some(picture) = self.resolve(&frame)? else { return Ok(()) };
        let mut of_device = None;
        if let Some(AnyTracer::Device(tracer)) = &self.tracer {
            let statistics = tracer.statistics();
            ms = if statistics.gpu_ms > 0.0 { statistics.gpu_ms } else { ms };
            of_device = Some((statistics, tracer.memory()));
        }
        self.pace.update(step, pixels, ms);
        if is_whole {
            self.done = samples;
        }
        self.show(Shown {
            picture,
            samples: if is_whole { samples } else { 0 },
            scale: step.scale,
            step_ms: ms,
            step_samples: step.samples,
            device: of_device,
        });
        Ok(())
    }

    fn show(&self, shown: Shown) {
        *locked(&self.shared.shown) = Some(shown);
        (self.tell)(Event::Picture);
    }

    /// Makes the tracer with the scene, where there is none.
    fn open_tracer(&mut self) -> Result<(), TraceError> {
        let Some(scene) = &self.scene else { return Err(TraceError::NoScene) };
        if self.tracer.is_some() {
            return Ok(());
        }
        let (mut tracer, budget_ms) = match self.backend {
            Backend::Cpu => (AnyTracer::Cpu(Box::new(CpuTracer::new(None))), CPU_MS),
            Backend::Device(settings) => {
                let mut tracer = VulkanTracer::new(Arc::clone(&self.device), settings)?;
                tracer.set_submit_ms(DEVICE_MS);
                (AnyTracer::Device(Box::new(tracer)), DEVICE_MS)
            }
        };
        tracer.as_tracer().set_scene(scene)?;
        self.pace = Pace::new(budget_ms);
        self.tracer = Some(tracer);
        Ok(())
    }

    /// A picture of the tracer's film, `None` where the device was lost and the next step makes one.
    fn resolve(&mut self, frame: &Frame) -> Result<Option<Arc<Picture>>, TraceError> {
        let by_host = match &self.tracer {
            Some(AnyTracer::Device(tracer)) if tracer.is_on_cpu() => true,
            Some(AnyTracer::Device(tracer)) => {
                let device = Arc::clone(tracer.device());
                if !Arc::ptr_eq(&device, &self.device) {
                    self.moved(device);
                }
                false
            }
            _ => true,
        };
        let mut picture = self.free_picture(frame.width, frame.height, by_host)?;
        match &mut self.tracer {
            Some(AnyTracer::Device(tracer)) if !by_host => match tracer.resolve(&picture) {
                Err(TraceError::DeviceLost { .. }) => return Ok(None),
                result => result?,
            },
            Some(tracer) => {
                tracer.as_tracer().read(&mut self.film)?;
                // Nobody else holds a free picture.
                if let Some(picture) = Arc::get_mut(&mut picture) {
                    picture.write(&self.film);
                }
            }
            None => return Ok(None),
        }
        self.pictures.push(Arc::clone(&picture));
        Ok(Some(picture))
    }

    /// Pictures lie on another device from now on.
    fn moved(&mut self, device: Arc<Device>) {
        self.pictures.clear();
        *locked(&self.shared.shown) = None;
        self.device = Arc::clone(&device);
        (self.tell)(Event::Moved(device));
    }

    /// A picture that nobody holds, taken out of the pool. Pictures of other sizes go where nobody holds them.
    fn free_picture(&mut self, width: u32, height: u32, by_host: bool) -> Result<Arc<Picture>, TraceError> {
        let suits =
            |picture: &Arc<Picture>| picture.size() == (width, height) && picture.is_written_by_host() == by_host;
        self.pictures.retain(|picture| Arc::strong_count(picture) > 1 || suits(picture));
        match self.pictures.iter().position(|picture| Arc::strong_count(picture) == 1 && suits(picture)) {
            Some(index) => Ok(self.pictures.swap_remove(index)),
            None => Ok(Arc::new(Picture::new(&self.device, width, height, by_host)?)),
        }
    }

    /// The film at full resolution, where its pixels have samples.
    fn whole_film(&mut self) -> Option<(Frame, Film)> {
        let frame = self.view.as_ref()?.frame().samples(self.done);
        let tracer = self.tracer.as_mut().filter(|_| self.done > 0)?;
        let mut film = Film::new(0, 0, voxtrace::Region::full(0, 0), 0);
        tracer.as_tracer().read(&mut film).ok()?;
        (film.width == frame.width && film.sample_range() == (self.done, self.done)).then_some((frame, film))
    }
}
