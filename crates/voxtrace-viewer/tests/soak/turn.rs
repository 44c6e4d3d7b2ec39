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

/// Time of all processors, that in which they were idle, and that which this process worked, in ticks of the kernel.
fn ticks() -> Option<[u64; 3]> {
    let text = std::fs::read_to_string("/proc/stat").ok()?;
    let all: Vec<u64> =
        text.lines().next()?.split_whitespace().skip(1).filter_map(|ticks| ticks.parse().ok()).collect();
    let own = std::fs::read_to_string("/proc/self/stat").ok()?;
    let own: Vec<u64> = own.rsplit(')').next()?.split_whitespace().map(|ticks| ticks.parse().unwrap_or(0)).collect();
    // Idle, and waiting for disks, are no work; of the process its times in its own code and in the kernel are counted.
    let idle = all.get(3)? + all.get(4)?;
    Some([all.iter().take(8).sum::<u64>(), idle, own.get(11)? + own.get(12)?])
}

/// How much of the machine other programs take. Where they take much, a thread also waits for locks that are held by threads of its own process which get no
/// processor, in the heap and in the kernel: no fault of the window.
pub struct Others(Option<[u64; 3]>);

impl Others {
    pub fn watch() -> Self {
        Self(ticks())
    }

    /// Their share of all processors since then, from 0 to 1.
    pub fn share(&self) -> f64 {
        let (Some(before), Some(now)) = (self.0, ticks()) else { return 0.0 };
        let [all, idle, own] = [0, 1, 2].map(|part| now[part].saturating_sub(before[part]));
        all.saturating_sub(idle + own) as f64 / all.max(1) as f64
    }
}

/// The longest turn.
#[derive(Clone, Debug, Default)]
pub struct Longest {
    pub took: Duration,
    /// The most that the thread worked in one.
    pub worked: Duration,
    /// What was done.
    pub what: String,
    /// When, since the beginning.
    pub at: Duration,
}

impl Longest {
    /// Takes a turn that is over.
    pub fn take(&mut self, turn: &Turn, at: Duration, what: impl FnOnce() -> String) {
        let (took, worked) = turn.took();
        self.worked = self.worked.max(worked);
        if took <= self.took.min(TOLD) {
            return;
        }
        let what = what();
        if took > TOLD {
            let [took, worked] = [took, worked].map(|time| time.as_secs_f64() * 1e3);
            println!("after {:.1} s, {took:.0} ms, of which it worked {worked:.0} ms: {what}", at.as_secs_f64());
        }
        if took > self.took {
            *self = Self { took, worked: self.worked, what, at };
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
