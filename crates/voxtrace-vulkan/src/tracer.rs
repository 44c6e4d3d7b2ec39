//! The tracer that outlives its device: what is lost with a device is done again on the same device, opened anew, and on
//! the CPU if that is lost too.

mod contract;
mod real_time;
mod show;

use crate::accel::AccelReport;
use crate::allocations::MemoryReport;
use crate::device::Device;
use crate::method::Settings;
use crate::statistics::Statistics;
use crate::watch::Watch;
use crate::worker::{Canvas, Worker};
use std::io::Write;
use std::sync::Arc;
use std::time::{Duration, Instant};
use voxtrace_core::CpuTracer;
use voxtrace_core::Film;
use voxtrace_core::Frame;
use voxtrace_core::PackedScene;
use voxtrace_core::Progress;
use voxtrace_core::TraceError;
use voxtrace_core::Tracer;
use voxtrace_realtime::Parts;

/// A device that is lost twice within this time is not tried again.
const BETWEEN_LOSSES: Duration = Duration::from_secs(60);
/// How often a long render is copied to the host, so that a loss costs no more than this.
const BETWEEN_COPIES: Duration = Duration::from_secs(10);

/// Traces on a Vulkan device.
pub struct VulkanTracer {
    backend: Backend,
    settings: Settings,
    submit_ms: Option<f64>,
    /// Whether scenes that do not fit are traced page by page.
    has_pages: bool,
    /// Whether the CPU goes on where the device does not come back.
    has_processor: bool,
    most_paths: Option<u32>,
    scene: Option<Arc<PackedScene>>,
    /// The film as it was last on the host.
    copy: Option<(Frame, Film)>,
    /// The last render, with the samples that it reached: what a loss before the next copy costs.
    rendered: Option<Frame>,
    /// When that was, or when the film began.
    copied: Instant,
    last_loss: Option<Instant>,
    /// Whether the film has samples of other moments, which cannot be rendered again.
    is_carried: bool,
    /// Parts of real-time light, and whether its rays are exact.
    real_time_settings: (Parts, bool),
    notes: Vec<String>,
    device: Arc<Device>,
}

/// What does the work.
enum Backend {
    Device(Box<Worker>),
    Cpu(Box<CpuTracer>),
    /// The device could not be opened anew, and nothing has been asked since.
    None,
}

impl VulkanTracer {
    /// A tracer on a device.
    ///
    /// # Errors
    /// [`TraceError::Unsupported`] where the device lacks the traversal; what the driver answers.
    pub fn new(device: Arc<Device>, settings: Settings) -> Result<Self, TraceError> {
        let worker = Worker::new(Arc::clone(&device), settings)?;
        Ok(Self {
            backend: Backend::Device(Box::new(worker)),
            settings,
            submit_ms: None,
            has_pages: true,
            has_processor: true,
            most_paths: None,
            scene: None,
            copy: None,
            rendered: None,
            copied: Instant::now(),
            last_loss: None,
            is_carried: false,
            real_time_settings: (Parts::ALL, false),
            notes: Vec::new(),
            device,
        })
    }

    /// The device, as it was opened last.
    pub fn device(&self) -> &Arc<Device> {
        &self.device
    }

    /// The scene that was set, as edits have made it; `None` before.
    #[doc(hidden)]
    pub fn scene(&self) -> Option<&Arc<PackedScene>> {
        self.scene.as_ref()
    }

    /// What is allocated on the device.
    pub fn memory(&self) -> MemoryReport {
        self.device.memory()
    }

    /// What the acceleration structures of the scene take, `None` where there are none.
    pub fn accel_report(&self) -> Option<AccelReport> {
        match &self.backend {
            Backend::Device(worker) => worker.accel_report(),
            _ => None,
        }
    }

    /// What the device did in the last call of `render`, `cast` or `set_placement`; nothing once the CPU does the work.
    pub fn statistics(&self) -> Statistics {
        match &self.backend {
            Backend::Device(worker) => worker.statistics(),
            _ => Statistics::default(),
        }
    }

    /// Whether the CPU does the work, because the device was lost twice.
    pub fn is_on_cpu(&self) -> bool {
        matches!(self.backend, Backend::Cpu(_))
    }

    /// Lets submits take about so many milliseconds each, so that a window that shares the device gets its turn.
    pub fn set_submit_ms(&mut self, submit_ms: f64) {
        self.submit_ms = Some(submit_ms);
        if let Backend::Device(worker) = &mut self.backend {
            worker.set_submit_ms(submit_ms);
        }
    }

    /// Whether a scene that does not fit the device is traced all the same, with [`crate::Traversal::Walk`], page by page: then rays bring what they come to,
    /// and the picture is the same, tens of times slower. Else setting it is [`TraceError::OutOfMemory`]. At first they are.
    pub fn with_pages(mut self, has_pages: bool) -> Self {
        self.has_pages = has_pages;
        if let Backend::Device(worker) = &mut self.backend {
            worker.allow_pages(has_pages);
        }
        self
    }

    /// Gives up with [`TraceError::DeviceLost`] where the CPU would go on for a device that does not come back: others take its work.
    pub(crate) fn without_processor(mut self) -> Self {
        self.has_processor = false;
        self
    }

    /// How many paths are traced at once in waves, at most, with [`crate::Traversal::Walk`] and [`voxtrace_core::Integrator::Path`]: those are quicker, and take
    /// 124 bytes a path among matte things, else 220, but no more than a quarter of the memory that is left. 0 makes one shader follow each path from its
    /// camera to its end, which gives the same picture. At first it is what suits the device. Real-time light is in waves of all its paths unless it is 0, or by one shader
    /// where at first that suits the device; of the paths that meet other than matte things, at most so many are in waves at once.
    pub fn with_most_paths(mut self, most_paths: u32) -> Self {
        self.most_paths = Some(most_paths);
        if let Backend::Device(worker) = &mut self.backend {
            worker.set_most_paths(self.most_paths);
        }
        self
    }

    /// Leaves out a step of waves, by the name of its entry point, from the next program on that is made for them, for tests.
    #[cfg(feature = "faults")]
    pub fn leave_out(&mut self, step: &'static str) {
        if let Backend::Device(worker) = &mut self.backend {
            worker.leave_out(step);
        }
    }

    /// Brings the next pages of the scene as if nothing were in them, for tests.
    #[cfg(feature = "faults")]
    pub fn empty_pages(&mut self, count: usize) {
        if let Backend::Device(worker) = &mut self.backend {
            worker.empty_pages(count);
        }
    }

    /// Pages of the scene that the next round of tracing would seem to use, for tests.
    #[cfg(feature = "faults")]
    pub fn marked_pages(&mut self) -> Result<usize, TraceError> {
        match &mut self.backend {
            Backend::Device(worker) => worker.marked_pages(),
            _ => Ok(0),
        }
    }

    /// Bytes of pages of the scene that were uploaded since it was set, and how often some were, `None` where it lies on the device whole.
    pub fn paged(&self) -> Option<(u64, u64)> {
        match &self.backend {
            Backend::Device(worker) => worker.paged(),
            _ => None,
        }
    }

    /// Samples that every pixel of the film has.
    pub fn samples(&self) -> u32 {
        match (&self.backend, &self.rendered) {
            (Backend::Device(worker), _) => worker.samples(),
            (_, rendered) => rendered.as_ref().map_or(0, |frame| frame.samples),
        }
    }

    /// Goes on after somebody else found the device to be lost: on the device, opened anew, or on the CPU, with the film as it was
    /// last copied to the host. [`Self::samples`] says how much of it there is.
    ///
    /// # Errors
    /// Where not even the CPU goes on.
    pub fn lost(&mut self, last_pass: &str) -> Result<(), TraceError> {
        self.recover(last_pass)?;
        let kept = |(frame, film): &(Frame, Film)| frame.clone().samples(film.sample_range().0);
        self.rendered = self.copy.as_ref().map(kept);
        Ok(())
    }

    /// Does `work`, again after each loss of the device.
    fn attempt<R>(&mut self, mut work: impl FnMut(&mut Backend) -> Result<R, TraceError>) -> Result<R, TraceError> {
        loop {
            match work(&mut self.backend) {
                Err(TraceError::DeviceLost { last_pass }) => self.recover(&last_pass)?,
                result => return result,
            }
        }
    }

    /// Opens the device anew, or turns to the CPU, and puts scene and film back; fails where the film cannot be.
    fn recover(&mut self, last_pass: &str) -> Result<(), TraceError> {
        if !std::mem::take(&mut self.is_carried) {
            return self.open_again(last_pass);
        }
        (self.copy, self.rendered) = (None, None);
        self.open_again(last_pass)?;
        Err(TraceError::DeviceLost { last_pass: last_pass.into() })
    }

    fn open_again(&mut self, last_pass: &str) -> Result<(), TraceError> {
        let report = self.device.fault_report();
        let written = report.and_then(|report| write_report(&report));
        let where_to_read = written.map_or(String::new(), |path| format!("; the driver's report is in {path}"));
        self.notes.push(format!("{} was lost during {last_pass}{where_to_read}", self.device.info().name));
        // Frees what is left of the lost device first.
        self.backend = Backend::None;
        let now = Instant::now();
        // Waiting for work that does not end is no time in which it went well.
        let between = BETWEEN_LOSSES + self.device.hung().unwrap_or_default();
        let is_second = self.last_loss.is_some_and(|last| now.duration_since(last) < between);
        self.last_loss = Some(now);
        if !is_second {
            match self.reopen() {
                Ok(()) => {
                    self.notes.push("the device was opened anew and goes on".into());
                    return Ok(());
                }
                // Whatever went wrong: the CPU needs no device.
                Err(error) => self.notes.push(format!("the device does not come back: {error}")),
            }
        }
        self.backend = Backend::None;
        if !self.has_processor {
            return Err(TraceError::DeviceLost { last_pass: last_pass.into() });
        }
        let mut cpu = CpuTracer::new(None);
        if let Some(scene) = &self.scene {
            cpu.set_scene(scene)?;
        }
        if let Some((frame, film)) = &self.copy {
            cpu.resume(frame, film.clone())?;
        }
        self.backend = Backend::Cpu(Box::new(cpu));
        self.notes.push("the CPU goes on".into());
        Ok(())
    }

    fn reopen(&mut self) -> Result<(), TraceError> {
        self.device = self.device.reopened()?;
        let mut worker = Worker::new(Arc::clone(&self.device), self.settings)?;
        worker.allow_pages(self.has_pages);
        worker.set_most_paths(self.most_paths);
        worker.set_real_time(self.real_time_settings.0, self.real_time_settings.1);
        if let Some(submit_ms) = self.submit_ms {
            worker.set_submit_ms(submit_ms);
        }
        if let Some(scene) = &self.scene {
            worker.set_scene(scene)?;
        }
        if let Some((frame, film)) = &self.copy {
            worker.resume(frame, film)?;
        }
        self.backend = Backend::Device(Box::new(worker));
        Ok(())
    }

    /// Renders, and shows the film with the last samples where that can be.
    fn render_with(&mut self, frame: &Frame, progress: &Progress, canvas: Option<Canvas>) -> Result<(), TraceError> {
        frame.check()?;
        self.scene.iter().try_for_each(|scene| frame.check_in(scene))?;
        if let Backend::Device(worker) = &self.backend
            && !worker.has_film_of(frame)
        {
            // A film that begins has samples of this moment alone.
            self.is_carried = false;
        }
        // A film of another frame is of no use after a loss.
        self.copy = self.copy.take().filter(|(last, _)| frame.continues(last));
        let last = self.rendered.as_ref().filter(|last| frame.continues(last));
        let rendered = last.map_or(0, |last| u64::from(last.samples) * frame.region.pixels() as u64);
        let mut watch = Watch::new(progress, rendered.max(samples_of(&self.copy)));
        if self.keep_copy_of_last(frame)? {
            watch.go_back_to(samples_of(&self.copy));
        }
        loop {
            let until = Instant::now() + BETWEEN_COPIES;
            let finished = match &mut self.backend {
                Backend::Device(worker) => worker.render(frame, &mut watch, until, canvas),
                Backend::Cpu(cpu) => watch.follow(|progress| cpu.render(frame, progress)).map(|()| true),
                Backend::None => Err(TraceError::NoScene),
            };
            let kept_or_lost = match finished {
                Ok(false) => self.keep_copy(frame).map(|()| false),
                finished => finished,
            };
            match kept_or_lost {
                Ok(true) => {
                    let samples = match &mut self.backend {
                        Backend::Device(worker) => worker.samples(),
                        Backend::Cpu(cpu) if progress.is_cancelled() => {
                            let mut film = Film::new(0, 0, frame.region, 0);
                            cpu.read(&mut film)?;
                            film.sample_range().0
                        }
                        _ => frame.samples,
                    };
                    self.rendered = Some(frame.clone().samples(samples));
                    return Ok(());
                }
                Ok(false) => {}
                Err(TraceError::DeviceLost { last_pass }) => {
                    // What is not in the copy is rendered again.
                    watch.go_back_to(samples_of(&self.copy));
                    self.recover(&last_pass)?;
                }
                Err(error) => return Err(error),
            }
        }
    }

    /// Copies the film to the host. Where the device is lost meanwhile, the last copy stays.
    fn keep_copy(&mut self, frame: &Frame) -> Result<(), TraceError> {
        let mut film = Film::new(0, 0, frame.region, 0);
        match &mut self.backend {
            Backend::Device(worker) => worker.read(&mut film)?,
            Backend::Cpu(cpu) => cpu.read(&mut film)?,
            Backend::None => return Err(TraceError::NoFilm),
        }
        self.copy = Some((frame.clone(), film));
        self.copied = Instant::now();
        Ok(())
    }

    /// Copies a film that is made in many short calls to the host, when that is due. Returns whether the film is that of the copy, also as its device was lost.
    fn keep_copy_of_last(&mut self, frame: &Frame) -> Result<bool, TraceError> {
        let mut is_copied = false;
        match self.rendered.take().filter(|last| frame.continues(last)) {
            // A film begins.
            None => self.copied = Instant::now(),
            Some(last) => {
                if self.copied.elapsed() >= BETWEEN_COPIES && matches!(self.backend, Backend::Device(_)) {
                    match self.keep_copy(&last) {
                        Err(TraceError::DeviceLost { last_pass }) => return self.recover(&last_pass).map(|()| true),
                        result => result?,
                    }
                    is_copied = true;
                }
                self.rendered = Some(last);
            }
        }
        Ok(is_copied)
    }
}

/// Samples of all pixels.
fn samples_of(copy: &Option<(Frame, Film)>) -> u64 {
    let film = copy.as_ref().map(|(_, film)| film);
    film.map_or(0, |film| film.pixels.iter().map(|pixel| u64::from(pixel.samples)).sum())
}

/// Writes what the driver knows about a fault to a file among the temporary ones; `None` where that fails.
fn write_report(report: &str) -> Option<String> {
    // Under a name that nobody has taken: others may write there, too, and links lead elsewhere.
    (0..100).find_map(|number| {
        let path = std::env::temp_dir().join(format!("voxtrace-gpu-fault-{}-{number}.txt", std::process::id()));
        let mut file = std::fs::File::options().write(true).create_new(true).open(&path).ok()?;
        file.write_all(report.as_bytes()).ok()?;
        Some(path.display().to_string())
    })
}
