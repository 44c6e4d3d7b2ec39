//! How long a turn of the window's thread takes by itself. On a busy machine the clock counts what other programs do as well; the kernel says how long
//! the thread waited for a processor, and without that is left what it worked, and what it waited for others.

use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// Turns that take longer are told.
const TOLD: Duration = Duration::from_millis(100);

/// Held by a turn, and by what holds turns up and is no part of the window.
static BETWEEN: Mutex<()> = Mutex::new(());

/// Does something between two turns: looking at the memory holds locks of the heaps, which a turn would wait for.
pub fn between<T>(what: impl FnOnce() -> T) -> T {
    let _held = BETWEEN.lock().unwrap_or_else(PoisonError::into_inner);
    what()
}

/// A turn under way.
pub struct Turn {
    _held: MutexGuard<'static, ()>,
    start: Instant,
    /// Time that the thread worked, and waited for a processor, until then.
    before: [Duration; 2],
}

/// Time that the calling thread has worked, and waited for a processor, as far as the system says it.
fn worked_and_waited() -> [Duration; 2] {
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").unwrap_or_default();
    let mut nanos = text.split(' ').map(|nanos| nanos.parse().unwrap_or(0)).map(Duration::from_nanos);
    [nanos.next().unwrap_or_default(), nanos.next().unwrap_or_default()]
}

impl Turn {
    pub fn begin() -> Self {
        let held = BETWEEN.lock().unwrap_or_else(PoisonError::into_inner);
        Self { _held: held, start: Instant::now(), before: worked_and_waited() }
    }

    /// What it took, without waiting for a processor, and what of that the thread worked.
    pub fn took(&self) -> (Duration, Duration) {
        let now = worked_and_waited();
        let [worked, waited] = [0, 1].map(|part| now[part].saturating_sub(self.before[part]));
        (self.start.elapsed().saturating_sub(waited), worked)
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
        let (took, worked) = turn.took();
        if took <= self.took.min(TOLD) {
            return;
        }
        let what = what();
        if took > TOLD {
            let [took, worked] = [took, worked].map(|time| time.as_secs_f64() * 1e3);
            println!("after {:.1} s, {took:.0} ms, of which it worked {worked:.0} ms: {what}", at.as_secs_f64());
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
    assert!(turn.took().0 >= Duration::from_millis(30), "waiting for others counts");
    let mut longest = Longest::default();
    longest.take(&turn, Duration::ZERO, || "sleeping".into());
    drop(turn);
    longest.take(&Turn::begin(), Duration::ZERO, || "nothing".into());
    assert_eq!(longest.what, "sleeping");
}
