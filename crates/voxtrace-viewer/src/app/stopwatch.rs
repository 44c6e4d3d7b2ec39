//! How long the window took: with `VOXTRACE_VIEW_TIMES=1` it says so on stderr when it is closed. On Linux it also says what its thread itself
//! worked in a turn: on a busy machine the clock counts what other programs do as well.

use crate::phases::{FELT, Phases};
use std::time::{Duration, Instant};

/// Times of one run.
pub struct Stopwatch {
    start: Instant,
    first_picture: Option<Duration>,
    first_whole: Option<Duration>,
    /// Pictures that were drawn, of the film alone and with real-time light.
    pictures: [u64; 2],
    opening: Duration,
    /// The turns of the event loop.
    turns: Phases,
    /// The thread's own time when the turn began, the longest turn by it, and those that were felt.
    own: (Option<Duration>, Duration, u64),
}

/// The processor time of the calling thread.
fn own_time() -> Option<Duration> {
    #[cfg(target_os = "linux")]
    {
        let time = rustix::time::clock_gettime(rustix::time::ClockId::ThreadCPUTime);
        Some(Duration::new(time.tv_sec.try_into().ok()?, time.tv_nsec.try_into().ok()?))
    }
    #[cfg(not(target_os = "linux"))]
    None
}

impl Stopwatch {
    pub fn start() -> Self {
        let (first_picture, first_whole, own) = (None, None, (None, Duration::ZERO, 0));
        let (opening, turns) = (Duration::ZERO, Phases::default());
        Self { start: Instant::now(), first_picture, first_whole, pictures: [0; 2], opening, turns, own }
    }

    /// The window is open: what that took is no turn that anybody waits for.
    pub fn opened(&mut self) {
        self.opening = self.start.elapsed();
        self.begin_turn();
    }

    /// The window woke up.
    pub fn begin_turn(&mut self) {
        self.turns.begin();
        self.own.0 = own_time();
    }

    /// What the turn did until now, or since the last call.
    pub fn lap(&mut self, phase: &'static str) {
        self.turns.lap(phase);
    }

    /// It goes to sleep again.
    pub fn end_turn(&mut self) {
        self.turns.end("events");
        let Some((begun, now)) = self.own.0.take().zip(own_time()) else { return };
        let own = now.saturating_sub(begun);
        self.own.1 = self.own.1.max(own);
        self.own.2 += u64::from(own > FELT);
    }

    /// A picture of the scene was drawn, at full resolution or coarser, with real-time light in it or without.
    pub fn picture(&mut self, is_whole: bool, is_lit: bool) {
        self.pictures[usize::from(is_lit)] += 1;
        self.first_picture.get_or_insert_with(|| self.start.elapsed());
        if is_whole {
            self.first_whole.get_or_insert_with(|| self.start.elapsed());
        }
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
        if let Some(whole) = self.first_whole {
            eprintln!("first picture at full resolution after {:.0} ms", ms(whole));
        }
        let [film, lit] = self.pictures;
        eprintln!("pictures drawn: {film} of the film alone, {lit} with real-time light");
        eprintln!("{} turns of the window, {}", self.turns.summary().0, self.turns);
        if own_time().is_some() {
            let (_, longest, felt) = self.own;
            eprintln!(
                "  the thread itself worked over {:.0} ms in {felt} of them, {:.1} ms at most",
                ms(FELT),
                ms(longest)
            );
        }
        if let Some(drawing) = drawing {
            eprintln!("{} frames, on a thread of their own, {drawing}", drawing.summary().0);
        }
    }
}
