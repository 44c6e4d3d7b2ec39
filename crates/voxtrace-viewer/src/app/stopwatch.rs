//! How long the window took: with `VOXTRACE_VIEW_TIMES=1` it says so on stderr when it is closed.

use std::time::{Duration, Instant};

/// A turn of the event loop that takes longer than this is felt.
const FELT: Duration = Duration::from_millis(50);

/// Times of one run.
pub struct Stopwatch {
    start: Instant,
    first_picture: Option<Duration>,
    turn: Instant,
    turns: u64,
    felt: u64,
    longest: Duration,
}

impl Stopwatch {
    pub fn start() -> Self {
        let now = Instant::now();
        Self { start: now, first_picture: None, turn: now, turns: 0, felt: 0, longest: Duration::ZERO }
    }

    /// The window woke up.
    pub fn begin_turn(&mut self) {
        self.turn = Instant::now();
    }

    /// It goes to sleep again.
    pub fn end_turn(&mut self) {
        let time = self.turn.elapsed();
        self.turns += 1;
        self.felt += u64::from(time > FELT);
        self.longest = self.longest.max(time);
    }

    /// A picture of the scene was drawn.
    pub fn picture(&mut self) {
        self.first_picture.get_or_insert_with(|| self.start.elapsed());
    }

    /// Says it, where that is asked for.
    pub fn report(&self) {
        if !std::env::var("VOXTRACE_VIEW_TIMES").is_ok_and(|value| value == "1") {
            return;
        }
        let ms = |time: Duration| time.as_secs_f64() * 1e3;
        if let Some(first) = self.first_picture {
            eprintln!("first picture after {:.0} ms", ms(first));
        }
        let (turns, felt, longest) = (self.turns, self.felt, ms(self.longest));
        eprintln!("{turns} turns of the window, {felt} over {:.0} ms, the longest {longest:.1} ms", ms(FELT));
    }
}
