//! A quick benchmark of the view, on a thread of its own: the project's benchmark on the scene, camera and size that are shown.

use crate::engine::Pause;
use crate::session::{Command, Session};
use crate::tr;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, Sender, TryRecvError, channel};
use std::time::Duration;
use voxtrace::PackedScene;
use voxtrace_bench::{BenchError, Host, LoadedScene, Measurement, Monitor, Request, SceneEntry};
use voxtrace_vulkan::Traversal;

/// Frames that are measured, and those before.
pub const FRAMES: u32 = 64;
/// Frames before the first that counts.
pub const WARM_UP: u32 = 4;
/// Most seconds of the frames.
pub const SECONDS: u64 = 20;

/// What is measured.
pub struct Subject {
    /// The scene in its light; its first camera is that of the view.
    pub scene: PackedScene,
    /// What to ask for; the folder of the report is chosen here.
    pub request: Request,
}

/// A benchmark on its way.
pub struct Benchmark {
    /// What is done now.
    pub work: String,
    /// Frames of it that are done, and all.
    pub frames: (u64, u64),
    is_cancelled: Arc<AtomicBool>,
    answers: Receiver<Answer>,
}

enum Answer {
    Work(String, u64),
    Frame(u64),
    Done(Result<Vec<Measurement>, String>),
}

impl Benchmark {
    /// Begins to measure. `wake` is called whenever there is news.
    pub fn start(subject: Subject, wake: Arc<dyn Fn() + Send + Sync>) -> Self {
        let (sender, answers) = channel();
        let is_cancelled = Arc::new(AtomicBool::new(false));
        let mut window = Window { scene: subject.scene, sender, wake, is_cancelled: Arc::clone(&is_cancelled) };
        let mut request = subject.request;
        std::thread::spawn(move || {
            let measured = catch_unwind(AssertUnwindSafe(|| {
                let folder = tempfile::tempdir().map_err(|error| tr!("benchmark.no_folder", error = error))?;
                request.output = folder.path().to_path_buf();
                let results = voxtrace_bench::run(&request, &mut window);
                results.map(|results| results.measurements()).map_err(|error: BenchError| error.to_string())
            }));
            // Without an answer nothing would be traced any more.
            let measured = measured.unwrap_or_else(|_| Err(tr!("benchmark.failed").into()));
            window.tell(Answer::Done(measured));
        });
        Self { work: "preparing".into(), frames: (0, 0), is_cancelled, answers }
    }

    /// Stops as soon as the frame under way is done.
    pub fn cancel(&self) {
        self.is_cancelled.store(true, Ordering::Relaxed);
    }

    /// Takes what has come. Returns the results at the end.
    pub fn take(&mut self) -> Option<Result<Vec<Measurement>, String>> {
        loop {
            match self.answers.try_recv() {
                Ok(Answer::Work(work, frames)) => (self.work, self.frames) = (work, (0, frames)),
                Ok(Answer::Frame(done)) => self.frames.0 = done,
                Ok(Answer::Done(measured)) => return Some(measured),
                Err(TryRecvError::Empty) => return None,
                Err(TryRecvError::Disconnected) => {
                    return Some(Err(tr!("benchmark.failed").into()));
                }
            }
        }
    }
}

impl Drop for Benchmark {
    fn drop(&mut self) {
        self.cancel();
    }
}

/// The window as the host of a benchmark.
struct Window {
    scene: PackedScene,
    sender: Sender<Answer>,
    wake: Arc<dyn Fn() + Send + Sync>,
    is_cancelled: Arc<AtomicBool>,
}

impl Window {
    fn tell(&self, answer: Answer) {
        // Nobody listens to what is not wanted any more.
        let _ = self.sender.send(answer);
        (self.wake)();
    }
}

impl Monitor for Window {
    fn begin(&mut self, name: &str, total: u64) {
        self.tell(Answer::Work(name.to_owned(), total));
    }

    fn update(&mut self, done: u64) {
        self.tell(Answer::Frame(done));
    }

    fn is_interrupted(&self) -> bool {
        self.is_cancelled.load(Ordering::Relaxed)
    }
}

impl Host for Window {
    type Error = BenchError;

    fn load(&mut self, entry: &SceneEntry, _: Option<u64>) -> Result<LoadedScene, BenchError> {
        Ok(LoadedScene { stem: entry.name.clone(), scene: self.scene.clone() })
    }
}

impl Session {
    /// The cells that are measured, as `voxtrace bench --cells` has them: what traces, and what it is compared with.
    pub fn bench_cells(&self) -> Vec<String> {
        let settings = &self.render_settings;
        let name = |traversal: Traversal, primitive: voxtrace_vulkan::Primitive| match traversal.uses_primitives() {
            true => format!("{}:{}", traversal.name(), primitive.name()),
            false => traversal.name().to_owned(),
        };
        let mut cells = vec![name(settings.traversal, settings.primitive)];
        cells.extend(self.comparison.as_ref().map(|other| {
            let cell = name(other.traversal, other.primitive);
            // Where nothing else is said, all round as the picture's tracer does.
            match other.traversal != Traversal::Cpu && other.fast != self.is_fast() {
                true => format!("{cell}:{}", if other.fast { "fast" } else { "precise" }),
                false => cell,
            }
        }));
        cells.dedup();
        cells
    }

    /// Whether the driver may round as it likes for the picture.
    fn is_fast(&self) -> bool {
        self.render_settings.fast && self.render_settings.traversal != Traversal::Cpu
    }

    /// What a benchmark of the view measures, `device` being the window's; `None` without a scene.
    pub fn bench_subject(&self, device: Option<String>) -> Option<Subject> {
        let open = self.open.as_ref()?;
        let mut scene = (*open.lit).clone();
        scene.cameras.insert(0, self.navigator.camera().clone());
        let request = Request {
            scenes: vec![SceneEntry::named(&scene.name)],
            cells: self.bench_cells(),
            precise: !self.is_fast(),
            frames: Some(FRAMES),
            warm_up: Some(WARM_UP),
            time_limit: Some(Duration::from_secs(SECONDS)),
            size: Some(self.size()),
            max_bounces: Some(self.render_settings.max_bounces),
            integrator: Some(self.render_settings.integrator),
            sweep: Some(Vec::new()),
            device,
            skip_probes: true,
            ..Request::default()
        };
        Some(Subject { scene, request })
    }

    /// Whether something is measured: nothing else is to be traced meanwhile.
    pub(crate) fn is_measured(&self) -> bool {
        self.benchmark.is_some() || self.running.as_ref().is_some_and(|running| running.request.measures)
    }

    /// Measures the view, or stops measuring. What is made beside the window would share the device, or the cores, with it.
    pub fn toggle_benchmark(&mut self) {
        match &self.benchmark {
            Some(benchmark) => benchmark.cancel(),
            None if self.running.is_some() || self.exporting.is_some() => self.say(tr!("running.busy"), true),
            None if self.open.is_some() => {
                self.measured = None;
                // What traces would share the device, or the cores, with what is measured.
                self.ask(Command::Pause(Pause::Everything));
                self.ask(Command::Benchmark);
            }
            None => self.say(tr!("said.there_is_no_scene_to_measure"), false),
        }
    }

    /// Takes what has come from the thread that measures.
    pub fn take_measured(&mut self) {
        let Some(done) = self.benchmark.as_mut().and_then(Benchmark::take) else { return };
        self.benchmark = None;
        self.ask(Command::Pause(self.pause()));
        match done {
            Ok(measured) => self.measured = Some(measured),
            Err(error) => self.say(tr!("said.no_benchmark", error = error), true),
        }
    }
}
