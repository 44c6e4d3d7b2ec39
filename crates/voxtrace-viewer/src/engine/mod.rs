//! The thread that traces. It takes requests, the last one of a kind counts, and tells of each picture that is ready to be drawn; the
//! window never waits for it.

mod any_tracer;
mod contrast;
mod edits;
mod pace;
mod pictures;
mod side;
mod worker;

pub use contrast::Contrast;
pub use pace::Quality;

use crate::tr;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread::JoinHandle;
use voxtrace::lines::Lines;
use voxtrace::{BounceLimits, Camera, Film, Frame, Integrator, PackedScene, Patch, Progress, TraceError};
use voxtrace_vulkan::{Device, MemoryReport, Picture, RealTimeFrame, Settings, Statistics};
use worker::Worker;

/// What traces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Backend {
    /// The processor.
    Cpu,
    /// The device of the window.
    Device(Settings),
}

/// What tracing leaves out.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Pause {
    /// Nothing: samples are added until there are as many as were asked for.
    #[default]
    Nothing,
    /// All samples but the first: a view that changes is still shown.
    Samples,
    /// Everything: device and cores are for something else.
    Everything,
}

/// Whether views are shown in real-time light while they move.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum RealTimeChoice {
    /// The film alone is shown.
    #[default]
    Off,
    /// On devices, but not on those in software.
    Auto,
    /// On all devices.
    On,
}

impl Lit {
    /// Milliseconds of each pass of the frame, in their order; what runs several times is told once.
    pub fn passes(&self) -> Vec<(&'static str, f64)> {
        let mut sums: Vec<(&'static str, f64)> = Vec::new();
        for &(name, ms) in &self.frame.passes {
            match sums.iter_mut().find(|(known, _)| *known == name) {
                Some((_, sum)) => *sum += ms,
                None => sums.push((name, ms)),
            }
        }
        sums
    }
}

impl RealTimeChoice {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Off, Self::Auto, Self::On];

    /// Its name in the settings.
    pub fn name(self) -> &'static str {
        match self {
            Self::Off => "off",
            Self::Auto => "auto",
            Self::On => "on",
        }
    }

    /// That of a name in the settings; of one that there is not, what the window chooses.
    pub fn of_name(name: &str) -> Self {
        Self::ALL.into_iter().find(|choice| choice.name() == name).unwrap_or(Self::Auto)
    }
}

/// The light that a view is shown in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Light {
    /// Whether it is real-time light at first.
    pub real_time: RealTimeChoice,
    /// Whether a view that stands shows its film at once, however noisy it is.
    pub is_bare: bool,
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
    /// Most of them by kind.
    pub bounce_limits: BounceLimits,
    /// Most radiance that a bounce adds of indirect light; infinite where nothing is clamped.
    pub clamp_indirect: f32,
    /// Whether light passes clear glass straight.
    pub clear_shadows: bool,
    /// Lines on the faces of voxels.
    pub lines: Lines,
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
            .bounce_limits(self.bounce_limits)
            .clamp_indirect(self.clamp_indirect)
            .clear_shadows(self.clear_shadows)
            .lines(self.lines)
            .seed(self.seed)
    }

    /// That frame of a scene: without lines as long as its instances are merged, until they come apart.
    pub(super) fn frame_in(&self, scene: &PackedScene) -> Frame {
        let lines = if scene.is_merged() { Lines::default() } else { self.lines };
        self.frame().lines(lines)
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
    /// Samples a pixel of that step; none where it was a frame of real-time light.
    pub step_samples: u32,
    /// What the device counted in it, and its memory; `None` on the processor.
    pub device: Option<(Statistics, MemoryReport)>,
    /// The real-time light that is seen of it; `None` where it is the film alone.
    pub lit: Option<Lit>,
}

/// A frame of real-time light that is seen.
#[derive(Clone, Debug)]
pub struct Lit {
    /// What it took.
    pub frame: Arc<RealTimeFrame>,
    /// How fine it is.
    pub quality: Quality,
    /// How much is seen of the film over it, 0 to 1.
    pub film_weight: f32,
}

/// Where two tracers differ.
#[derive(Clone)]
pub struct Differences {
    /// The first one's picture, black where they do.
    pub picture: Arc<Picture>,
    /// Pixels of the picture.
    pub pixels: u64,
    /// Those that differ.
    pub count: u64,
    /// Samples of both films.
    pub samples: u32,
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
    /// An edit could not be followed: the scene has to be set again.
    Stale,
    /// The device was lost: pictures lie on this one from now on.
    Moved(Arc<Device>),
    /// The device was lost and does not come back: nothing can be shown any more.
    Gone(TraceError),
}

/// A request.
enum Request {
    Scene(Option<Arc<PackedScene>>),
    Follow(Arc<Patch>),
    View { view: Box<View>, is_moving: bool },
    Backend(Backend),
    Other(Option<Backend>),
    Contrast(Contrast),
    Light(Light),
    Film(usize, Sender<Option<(Frame, Film)>>),
    Pause(Pause),
    Lost(Arc<Device>),
    Quit,
}

/// What both threads see.
#[derive(Default)]
struct Shared {
    /// The picture, and the one that it is compared with.
    shown: Mutex<[Option<Shown>; 2]>,
    differences: Mutex<Option<Differences>>,
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
        let shared = Arc::new(Shared { is_first: AtomicBool::new(false), ..Shared::default() });
        let mut worker = Worker::new(receiver, Arc::clone(&shared), Box::new(tell), device, backend);
        let thread = std::thread::spawn(move || {
            crate::threads::yield_to_window();
            // A panic was printed, where nobody may look: the picture would stand still without a word.
            if catch_unwind(AssertUnwindSafe(|| worker.run())).is_err() {
                let (step, reason) = ("tracing".into(), tr!("tracing.fault").into());
                (worker.tell)(Event::Failed(TraceError::Device { step, reason }));
            }
        });
        Self { requests, shared, thread: Some(thread) }
    }

    /// Traces another scene, or none.
    pub fn set_scene(&self, scene: Option<Arc<PackedScene>>) {
        self.send(Request::Scene(scene), true);
    }

    /// Follows an edit of the scene. The film begins anew.
    pub fn follow(&self, patch: Arc<Patch>) {
        let is_first = self.shared.is_first.load(Ordering::Relaxed);
        self.send(Request::Follow(patch), !is_first);
    }

    /// Traces a scene in which things moved: as a view that moves on, it does not keep the first picture from coming.
    pub fn move_scene(&self, scene: Arc<PackedScene>) {
        let is_first = self.shared.is_first.load(Ordering::Relaxed);
        self.send(Request::Scene(Some(scene)), !is_first);
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

    /// Traces the view by other means as well, turn by turn, or by one alone.
    pub fn compare_with(&self, other: Option<Backend>) {
        self.send(Request::Other(other), false);
    }

    /// Says what is wanted of two tracers.
    pub fn set_contrast(&self, contrast: Contrast) {
        self.send(Request::Contrast(contrast), false);
    }

    /// Shows views in this light from now on. At first it is that of the film alone.
    pub fn set_light(&self, light: Light) {
        self.send(Request::Light(light), false);
    }

    /// Leaves something out from now on, or nothing any more.
    pub fn pause(&self, pause: Pause) {
        self.send(Request::Pause(pause), pause != Pause::Nothing);
    }

    /// Whoever shows pictures found that their device is lost: it is opened anew, and the film goes on from where it was, as far as
    /// that was kept. [`Event::Moved`] says where.
    pub fn lost(&self, device: Arc<Device>) {
        self.send(Request::Lost(device), true);
    }

    /// Asks for the film at full resolution: the answer comes when the step under way is done, `None` where there is no whole
    /// picture yet.
    pub fn film(&self) -> FilmAnswer {
        self.film_of(0)
    }

    /// As [`Self::film`], of the first tracer, 0, or the second, 1.
    pub fn film_of(&self, side: usize) -> FilmAnswer {
        let (sender, receiver) = channel();
        self.send(Request::Film(side, sender), false);
        receiver
    }

    /// The last picture.
    pub fn shown(&self) -> Option<Shown> {
        locked(&self.shared.shown)[0].clone()
    }

    /// The last picture of the second tracer.
    pub fn other_shown(&self) -> Option<Shown> {
        locked(&self.shared.shown)[1].clone()
    }

    /// Where two tracers differ, once that is known.
    pub fn differences(&self) -> Option<Differences> {
        locked(&self.shared.differences).clone()
    }

    /// Samples of all pixels that the step under way has added.
    pub fn samples_under_way(&self) -> u64 {
        locked(&self.shared.progress).samples_done()
    }

    /// Sends a request, and ends the step under way where that is of no use any more.
    fn send(&self, request: Request, ends_step: bool) {
        // The thread is there until this value is dropped, or it panicked and told so.
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
            // A panic was told when it happened.
            let _ = thread.join();
        }
    }
}

fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
