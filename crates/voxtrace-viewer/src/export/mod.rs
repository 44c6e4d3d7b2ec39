//! Pictures that are rendered to files beside the window, one or a row of frames, on a thread with a tracer of its own. What is written is what
//! `voxtrace render` writes with the same options: the same frame, tracer, film and encoder.

mod names;
mod request;
mod run;

pub use names::{free_name, place};
pub use request::{Existing, ExportRequest, Job, frame_path};
pub use run::{End, Outcome, Source, export};

use crate::tr;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, TryRecvError, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::JoinHandle;
use std::time::Instant;
use voxtrace::Progress;

/// How far an export is, and the request to stop it: what both threads see.
#[derive(Default)]
pub struct Watch {
    is_cancelled: AtomicBool,
    /// The picture under way.
    progress: Mutex<Arc<Progress>>,
    /// Pictures that are done with.
    done: AtomicUsize,
    /// Of these, those that were there already.
    kept: AtomicUsize,
}

impl Watch {
    /// Asks the export to stop. The picture under way is not written.
    pub fn cancel(&self) {
        self.is_cancelled.store(true, Ordering::Relaxed);
        self.progress().cancel();
    }

    fn is_cancelled(&self) -> bool {
        self.is_cancelled.load(Ordering::Relaxed)
    }

    fn progress(&self) -> Arc<Progress> {
        Arc::clone(&self.progress.lock().unwrap_or_else(PoisonError::into_inner))
    }

    /// The progress of the next picture.
    fn begin(&self) -> Arc<Progress> {
        let next = Arc::new(Progress::default());
        *self.progress.lock().unwrap_or_else(PoisonError::into_inner) = Arc::clone(&next);
        // Whoever cancelled meanwhile held the one before.
        if self.is_cancelled() {
            next.cancel();
        }
        next
    }
}

/// An export under way.
pub struct Exporting {
    /// What is written, for people.
    pub name: String,
    /// How many pictures.
    pub pictures: usize,
    /// Samples of all pixels of one of them.
    samples: u64,
    start: Instant,
    watch: Arc<Watch>,
    answer: Receiver<Outcome>,
    thread: Option<JoinHandle<()>>,
}

impl Exporting {
    /// Begins an export. `wake` is called when it has ended.
    pub fn start(request: ExportRequest, source: Source, wake: impl Fn() + Send + 'static) -> Self {
        let (sender, answer) = channel();
        let watch = Arc::new(Watch::default());
        let (name, pictures) = (request.name(), request.jobs.len());
        let samples = request.jobs.first().map_or(0, Job::samples);
        let watched = Arc::clone(&watch);
        let thread = std::thread::spawn(move || {
            let outcome = catch_unwind(AssertUnwindSafe(|| export(&request, source, &watched)));
            let outcome = outcome.unwrap_or_else(|_| Outcome::failed(tr!("said.rendering_failed").into()));
            // The window may be closed.
            let _ = sender.send(outcome);
            wake();
        });
        Self { name, pictures, samples, start: Instant::now(), watch, answer, thread: Some(thread) }
    }

    /// Pictures that are done.
    pub fn done(&self) -> usize {
        self.watch.done.load(Ordering::Relaxed)
    }

    /// Share that is done, 0 to 1.
    pub fn share(&self) -> f32 {
        let under_way = self.watch.progress().samples_done() as f64 / self.samples.max(1) as f64;
        let done = self.done() as f64;
        (((done + under_way.min(1.0)) / self.pictures.max(1) as f64) as f32).min(1.0)
    }

    /// Seconds that are left at the speed so far, once that can be told.
    pub fn seconds_left(&self) -> Option<f64> {
        let kept = self.watch.kept.load(Ordering::Relaxed) as f64 / self.pictures.max(1) as f64;
        let rendered = f64::from(self.share()) - kept;
        let left = 1.0 - f64::from(self.share());
        let seconds = self.start.elapsed().as_secs_f64();
        (rendered > 0.0 && seconds > 0.5).then(|| seconds * left / rendered)
    }

    /// Asks it to stop.
    pub fn cancel(&self) {
        self.watch.cancel();
    }

    /// What came of it, once it has ended.
    pub fn take(&mut self) -> Option<Outcome> {
        match self.answer.try_recv() {
            Ok(outcome) => Some(outcome),
            Err(TryRecvError::Empty) => None,
            Err(TryRecvError::Disconnected) => Some(Outcome::failed(tr!("said.rendering_no_word").into())),
        }
    }
}

impl Drop for Exporting {
    fn drop(&mut self) {
        self.cancel();
        if let Some(thread) = self.thread.take() {
            // A panic was caught and told.
            let _ = thread.join();
        }
    }
}
