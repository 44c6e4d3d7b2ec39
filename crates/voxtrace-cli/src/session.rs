//! One render from start to end: the tracer works on a thread of its own while this one watches the clock, the signals
//! and the checkpoints. How often it is paused makes no difference to the film.

use crate::failure::Failure;
use crate::interrupt;
use crate::report::Report;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::{Duration, Instant};
use voxtrace::film::Pixel;
use voxtrace::{Film, Frame, Progress, TraceError, Tracer};

/// How often the main thread looks for signals and limits.
const TICK: Duration = Duration::from_millis(50);

/// When a render pauses or ends early.
pub struct Limits {
    pub time: Option<Duration>,
    pub checkpoint_every: Option<Duration>,
    /// Whether the film keeps how it stood halfway.
    pub halfway: bool,
    /// How the film that is continued stood earlier, where that says enough about the noise.
    pub earlier: Option<Vec<Pixel>>,
}

/// How a render ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    Complete,
    TimeLimit,
    Interrupted,
}

/// Why the tracer was asked to return.
#[derive(Clone, Copy)]
enum Pause {
    Checkpoint,
    Halfway,
    End(End),
}

/// Renders `frame` until it is complete or a limit is reached, and returns the film. `save` gets the film now and then.
/// `done` samples are in the tracer's film already; the caller has called `report.begin`.
pub fn run(
    tracer: &mut (dyn Tracer + Send),
    frame: &Frame,
    mut done: u64,
    limits: &Limits,
    save: &dyn Fn(&Report, Film),
    report: &mut Report,
) -> Result<(End, Film), Failure> {
    let start = Instant::now();
    let mut film = Film::new(frame.width, frame.height, frame.region, frame.first_sample);
    let half = frame.clone().samples(frame.samples / 2);
    let mut halfway = limits.earlier.clone();
    let end = loop {
        // A film that was continued may be beyond it: then the rest counts as the other half.
        let is_first_half = limits.halfway && halfway.is_none() && half.samples > 0;
        let pause_at = limits.checkpoint_every.map(|interval| Instant::now() + interval);
        let progress = Progress::default();
        let paused = render_until(tracer, if is_first_half { &half } else { frame }, &progress, || {
            let elapsed = start.elapsed();
            report.update(done + progress.samples_done(), limits.time.map(|limit| limit.saturating_sub(elapsed)));
            if interrupt::is_requested() {
                Some(Pause::End(End::Interrupted))
            } else if limits.time.is_some_and(|limit| elapsed >= limit) {
                Some(Pause::End(End::TimeLimit))
            } else if is_first_half && limits.time.is_some_and(|limit| elapsed >= limit / 2) {
                Some(Pause::Halfway)
            } else if pause_at.is_some_and(|at| Instant::now() >= at) {
                Some(Pause::Checkpoint)
            } else {
                None
            }
        });
        let paused = paused.map_err(trace_failure);
        tracer.take_notes().iter().for_each(|note| report.warn(note));
        let paused = paused?;
        done += progress.samples_done();
        match paused {
            None if !is_first_half => break End::Complete,
            None | Some(Pause::Halfway) => {
                tracer.read(&mut film).map_err(trace_failure)?;
                halfway = Some(film.pixels.clone());
            }
            Some(Pause::End(end)) => break end,
            Some(Pause::Checkpoint) => {
                tracer.read(&mut film).map_err(trace_failure)?;
                save(report, Film { earlier: halfway.clone(), ..film.clone() });
            }
        }
    };
    tracer.read(&mut film).map_err(trace_failure)?;
    if film.sample_range().0 == 0 && frame.samples > 0 {
        done += finish_first_pass(tracer, frame, done, report)?;
        tracer.read(&mut film).map_err(trace_failure)?;
    }
    report.update(done, None);
    report.end();
    // A request to stop that came when the last sample was done changes nothing.
    let end = if film.sample_range().0 >= frame.samples { End::Complete } else { end };
    film.earlier = halfway;
    Ok((end, film))
}

/// Gives every pixel of a render that was broken off its first sample: a picture has no black parts, however short the time.
/// A second interrupt ends the process. Returns how many samples that took.
fn finish_first_pass(
    tracer: &mut (dyn Tracer + Send),
    frame: &Frame,
    done: u64,
    report: &mut Report,
) -> Result<u64, Failure> {
    let (first, progress) = (frame.clone().samples(1), Progress::default());
    let finished = render_until(tracer, &first, &progress, || {
        report.update(done + progress.samples_done(), None);
        None
    });
    let finished = finished.map_err(trace_failure);
    tracer.take_notes().iter().for_each(|note| report.warn(note));
    finished.map(|_| progress.samples_done())
}

/// Renders on another thread until that is done or `watch` says why to pause.
fn render_until(
    tracer: &mut (dyn Tracer + Send),
    frame: &Frame,
    progress: &Progress,
    mut watch: impl FnMut() -> Option<Pause>,
) -> Result<Option<Pause>, TraceError> {
    thread::scope(|scope| {
        let (sender, receiver) = channel();
        scope.spawn(move || {
            // The receiver is there until this answer has come.
            let _ = sender.send(tracer.render(frame, progress));
        });
        let mut pause = None;
        loop {
            match receiver.recv_timeout(TICK) {
                Ok(result) => return result.map(|()| pause),
                // The thread panicked; leaving the scope passes the panic on.
                Err(RecvTimeoutError::Disconnected) => return Ok(pause),
                Err(RecvTimeoutError::Timeout) => {
                    if pause.is_none() {
                        pause = watch();
                        if pause.is_some() {
                            progress.cancel();
                        }
                    }
                }
            }
        }
    })
}

/// An error of a tracer as one line with a hint.
pub fn trace_failure(error: TraceError) -> Failure {
    match error {
        TraceError::BadFrame(reason) => Failure::usage(reason),
        TraceError::Unsupported(_) => {
            Failure::other(error).hint("`voxtrace devices` says what each device can do; --traversal cpu always works")
        }
        TraceError::OutOfMemory { .. } => {
            Failure::other(error).hint("--traversal walk needs the least memory of a device, --traversal cpu none")
        }
        error => Failure::other(error),
    }
}
