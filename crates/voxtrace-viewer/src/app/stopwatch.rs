//! How long the window took: with `VOXTRACE_VIEW_TIMES=1` it says so on stderr when it is closed.

use crate::phases::Phases;
use std::time::{Duration, Instant};

/// Times of one run.
pub struct Stopwatch {
    start: Instant,
    first_picture: Option<Duration>,
    opening: Duration,
    /// The turns of the event loop.
    turns: Phases,
}

impl Stopwatch {
    pub fn start() -> Self {
        Self { start: Instant::now(), first_picture: None, opening: Duration::ZERO, turns: Phases::default() }
    }

    /// The window is open: what that took is no turn that anybody waits for.
    pub fn opened(&mut self) {
        self.opening = self.start.elapsed();
        self.turns.begin();
    }

    /// The window woke up.
    pub fn begin_turn(&mut self) {
        self.turns.begin();
    }

    /// What the turn did until now, or since the last call.
    pub fn lap(&mut self, phase: &'static str) {
        self.turns.lap(phase);
    }

    /// It goes to sleep again.
    pub fn end_turn(&mut self) {
        self.turns.end("events");
    }

    /// A picture of the scene was drawn.
    pub fn picture(&mut self) {
        self.first_picture.get_or_insert_with(|| self.start.elapsed());
    }

    /// Says it, where that is asked for, with what the thread that draws was busy with.
    pub fn report(&self, drawing: Option<&Phases>) {
        if !std::env::var("VOXTRACE_VIEW_TIMES").is_ok_and(|value| value == "1") {
            return;
        }
        let ms = |time: Duration| time.as_secs_f64() * 1e3;
        eprintln!("opening the window took {:.0} ms", ms(self.opening));
        if let Some(first) = self.first_picture {
            eprintln!("first picture after {:.0} ms", ms(first));
        }
        eprintln!("{} turns of the window, {}", self.turns.summary().0, self.turns);
        if let Some(drawing) = drawing {
            eprintln!("{} frames, on a thread of their own, {drawing}", drawing.summary().0);
        }
    }
}
