//! How long a turn of the window's thread takes by itself. On a busy machine the clock counts what other programs do as well; the kernel says how long
//! the thread waited for a processor, and without that is left what it worked, and what it waited for others.

use std::time::{Duration, Instant};

/// Turns that take longer are told.
const TOLD: Duration = Duration::from_millis(100);

/// A turn under way.
pub struct Turn {
    start: Instant,
    /// Time that the thread waited for a processor until then.
    waited: Duration,
}

/// Time that the calling thread has waited for a processor, as far as the system says it.
fn waited() -> Duration {
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").unwrap_or_default();
    Duration::from_nanos(text.split(' ').nth(1).and_then(|nanos| nanos.parse().ok()).unwrap_or(0))
}

impl Turn {
    pub fn begin() -> Self {
        Self { start: Instant::now(), waited: waited() }
    }

    /// What it took, without waiting for a processor.
    pub fn took(&self) -> Duration {
        self.start.elapsed().saturating_sub(waited().saturating_sub(self.waited))
    }
}

/// The longest turn.
#[derive(Clone, Debug, Default)]
pub struct Longest {
    pub took: Duration,
    /// What was done.
    pub what: String,
    /// When, since the beginning.
    pub at: Duration,
}

impl Longest {
    /// Takes a turn that is over.
    pub fn take(&mut self, turn: &Turn, at: Duration, what: impl FnOnce() -> String) {
        let took = turn.took();
        if took <= self.took.min(TOLD) {
            return;
        }
        let what = what();
        if took > TOLD {
            println!("after {:.1} s, {:.0} ms: {what}", at.as_secs_f64(), took.as_secs_f64() * 1e3);
        }
        if took > self.took {
            *self = Self { took, what, at };
        }
    }
}

#[test]
fn a_turn_counts_what_a_thread_works_and_waits_for() {
    let turn = Turn::begin();
    std::thread::sleep(Duration::from_millis(30));
    assert!(turn.took() >= Duration::from_millis(30), "waiting for others counts");
    let mut longest = Longest::default();
    longest.take(&turn, Duration::ZERO, || "sleeping".into());
    longest.take(&Turn::begin(), Duration::ZERO, || "nothing".into());
    assert_eq!(longest.what, "sleeping");
}
