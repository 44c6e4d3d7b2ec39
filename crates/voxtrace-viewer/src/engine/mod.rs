//! The thread that traces. It takes wishes, the last one of a kind counts, and tells of each picture that is ready to be drawn; the
//! window never waits for it.

mod pace;

use pace::Pace;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, Sender, TryRecvError, channel};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread::JoinHandle;
use std::time::Instant;
use voxtrace::{Camera, CpuTracer, Film, Frame, Integrator, PackedScene, Progress, TraceError, Tracer};
use voxtrace_vulkan::{Device, MemoryReport, Picture, Settings, Statistics, VulkanTracer};

/// Milliseconds of a picture on a device that shares its queue with the window, and on the processor.
const DEVICE_MS: f64 = 10.0;
const CPU_MS: f64 = 80.0;

/// What traces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Backend {
    /// The processor.
    Cpu,
    /// The device of the window.
    Device(Settings),
}

/// The view to trace.
#[derive(Clone, Debug, PartialEq)]
pub struct View {
    /// Where from.
    pub camera: Camera,
    /// Pixels of the picture.
    pub width: u32,
    /// Pixels of the picture.
    pub height: u32,
    /// Samples of each pixel after which the picture is done.
    pub samples: u32,
    /// How light is computed.
    pub integrator: Integrator,
    /// Most surfaces that scatter a path.
    pub max_bounces: u32,
    /// Seed of the random numbers.
    pub seed: u32,
}

impl View {
    /// The frame of the whole picture.
    pub fn frame(&self) -> Frame {
        Frame::new(self.camera.clone(), self.width, self.height)
            .samples(self.samples)
            .integrator(self.integrator)
            .max_bounces(self.max_bounces)
            .seed(self.seed)
    }
}

/// A picture that is ready.
#[derive(Clone)]
pub struct Shown {
    /// Its radiance, on the device of the window.
    pub picture: Arc<Picture>,
    /// Samples of each pixel.
    pub samples: u32,
    /// Pixels of the window along each side of a pixel.
    pub scale: u32,
    /// Milliseconds that the last step took, by the device's clock where it has one.
    pub step_ms: f64,
    /// Samples a pixel of that step.
    pub step_samples: u32,
    /// What the device counted in it, and its memory; `None` on the processor.
    pub device: Option<(Statistics, MemoryReport)>,
}

/// Where a film comes to that was asked for.
pub type FilmAnswer = Receiver<Option<(Frame, Film)>>;

/// What the engine tells.
pub enum Event {
    /// There is a new picture: see [`Engine::shown`].
    Picture,
    /// A line for people about something that went on.
    Notice(String),
    /// Nothing is traced until the scene, the view or what traces changes.
    Failed(TraceError),
    /// The device was lost: pictures lie on this one from now on.
    Moved(Arc<Device>),
}

/// A wish.
enum Request {
    Scene(Option<Arc<PackedScene>>),
    View { view: Box<View>, is_moving: bool },
    Backend(Backend),
    Film(Sender<Option<(Frame, Film)>>),
    Pause(bool),
    Quit,
}

/// What both threads see.
struct Shared {
    shown: Mutex<Option<Shown>>,
    /// The call under way.
    progress: Mutex<Arc<Progress>>,
    /// Whether that is the first picture of its view: it comes soon, and a view that moves on must not keep it from ever coming.
    is_first: AtomicBool,
}

/// The tracing thread.
pub struct Engine {
    requests: Sender<Request>,
    shared: Arc<Shared>,
    thread: Option<JoinHandle<()>>,
}

impl Engine {
    /// Starts the thread. Pictures lie on `device`; `tell` is called on the thread.
    pub fn start(device: Arc<Device>, backend: Backend, tell: impl Fn(Event) + Send + 'static) -> Self {
        let (requests, receiver) = channel();
        let shared =
            Arc::new(Shared { shown: Mutex::default(), progress: Mutex::default(), is_first: AtomicBool::new(false) });
        let mut worker = Worker {
            requests: receiver,
            shared: Arc::clone(&shared),
            tell: Box::new(tell),
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
        };
        let thread = std::thread::spawn(move || worker.run());
        Self { requests, shared, thread: Some(thread) }
    }

    /// Traces another scene, or none.
    pub fn set_scene(&self, scene: Option<Arc<PackedScene>>) {
        self.send(Request::Scene(scene), true);
    }

    /// Traces another view. While it `is_moving`, a coarse picture in time is worth more than a fine one.
    pub fn set_view(&self, view: View, is_moving: bool) {
        let is_first = self.shared.is_first.load(Ordering::Relaxed);
        self.send(Request::View { view: Box::new(view), is_moving }, !is_first);
    }

    /// Traces by other means.
    pub fn set_backend(&self, backend: Backend) {
        self.send(Request::Backend(backend), true);
    }

    /// Stops adding samples, or goes on.
    pub fn pause(&self, is_paused: bool) {
        self.send(Request::Pause(is_paused), is_paused);
    }

    /// Asks for the film at full resolution: the answer comes when the step under way is done, `None` where there is no whole
    /// picture yet.
    pub fn film(&self) -> FilmAnswer {
        let (sender, receiver) = channel();
        self.send(Request::Film(sender), false);
        receiver
    }

    /// The last picture.
    pub fn shown(&self) -> Option<Shown> {
        locked(&self.shared.shown).clone()
    }

    /// Samples of all pixels that the step under way has added.
    pub fn samples_under_way(&self) -> u64 {
        locked(&self.shared.progress).samples_done()
    }

    /// Sends a wish, and ends the step under way where that is of no use any more.
    fn send(&self, request: Request, ends_step: bool) {
        // The thread is there until this value is dropped, or it panicked, which `drop` passes on.
        let _ = self.requests.send(request);
        if ends_step {
            locked(&self.shared.progress).cancel();
        }
    }
}

impl Drop for Engine {
    fn drop(&mut self) {
        self.send(Request::Quit, true);
        if let Some(thread) = self.thread.take() {
            // A panic was printed when it happened.
            let _ = thread.join();
        }
    }
}

fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

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
struct Worker {
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
    fn run(&mut self) {
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
