//! How long a turn of the window's thread takes by itself. On a busy machine the clock counts what other programs do as well; the kernel says how long
//! the thread waited for a processor, and without that is left what it worked, and what it waited for others. Of a machine that stands still, or whose
//! processors others have that the kernel does not see, it says nothing: what holds up a thread that has nothing to do, too, is no work of a turn.

use std::io::Read;
use std::ops::Range;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError, TryLockError};
use std::time::{Duration, Instant};

/// Turns that take longer are told.
const TOLD: Duration = Duration::from_millis(100);

/// How long the thread rests that feels the machine's pulse, and by how much it wakes too late where something held it up.
const REST: Duration = Duration::from_millis(10);
const LATE: Duration = Duration::from_millis(50);

/// What the thread that feels the machine's pulse has felt.
struct Felt {
    /// When it felt it last; nothing where there is no such thread.
    at: Option<Instant>,
    /// When something held the machine up.
    holds: Vec<Range<Instant>>,
}

static FELT: Mutex<Felt> = Mutex::new(Felt { at: None, holds: Vec::new() });

fn felt() -> MutexGuard<'static, Felt> {
    FELT.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Time of processors that a hypervisor gave to others since the machine started, of `/proc/stat`, in steps of a tick.
fn stolen() -> Duration {
    let mut head = [0; 256];
    let length = std::fs::File::open("/proc/stat").and_then(|mut file| file.read(&mut head)).unwrap_or(0);
    let text = String::from_utf8_lossy(&head[..length]);
    let ticks: Option<u64> = text.lines().next().and_then(|line| line.split_ascii_whitespace().nth(8)?.parse().ok());
    Duration::from_millis(10 * ticks.unwrap_or(0))
}

/// A thread that feels the machine's pulse until this is dropped.
pub struct Pulse(Arc<AtomicBool>);

impl Pulse {
    pub fn feel() -> Self {
        let is_over = Arc::new(AtomicBool::new(false));
        let of_thread = Arc::clone(&is_over);
        *felt() = Felt { at: Some(Instant::now()), holds: Vec::new() };
        std::thread::spawn(move || {
            let processors = std::thread::available_parallelism().map_or(1, |number| number.get() as u32);
            let (mut before, mut stolen_before) = (Instant::now(), stolen());
            loop {
                std::thread::sleep(REST);
                let (now, stolen) = (Instant::now(), stolen());
                // The sum over all processors: each of them lost its share.
                let lost = stolen.saturating_sub(stolen_before) / processors;
                let theft = now.checked_sub(lost).unwrap_or(now);
                let mut felt = felt();
                if of_thread.load(Ordering::Relaxed) {
                    return;
                }
                if now - before > REST + LATE {
                    felt.holds.push(before + REST..now);
                }
                if theft < now {
                    felt.holds.push(theft..now);
                }
                felt.at = Some(now);
                (before, stolen_before) = (now, stolen);
            }
        });
        Self(is_over)
    }
}

impl Drop for Pulse {
    fn drop(&mut self) {
        self.0.store(true, Ordering::Relaxed);
        felt().at = None;
    }
}

/// For how much of some time that is over the machine was held up.
fn held_up(time: Range<Instant>) -> Duration {
    // Where all of it stood still, this thread may go on before the one that feels it.
    let patience = Instant::now() + Duration::from_secs(10);
    let mut holds = loop {
        let felt = felt();
        let Some(at) = felt.at else { return Duration::ZERO };
        if at > time.end || Instant::now() > patience {
            break felt.holds.clone();
        }
        drop(felt);
        std::thread::sleep(Duration::from_millis(1));
    };
    holds.sort_by_key(|hold| hold.start);
    let (mut upto, mut sum) = (time.start, Duration::ZERO);
    for hold in holds {
        let (start, end) = (hold.start.max(upto), hold.end.min(time.end));
        if start < end {
            sum += end - start;
            upto = end;
        }
    }
    sum
}

/// Held by a turn, and by what holds turns up and is no part of the window.
static BETWEEN: Mutex<()> = Mutex::new(());

/// Does something between two turns: looking at the memory holds locks of the heaps, which a turn would wait for. Nothing where one turn takes long.
pub fn between<T>(what: impl FnOnce() -> T) -> Option<T> {
    for _ in 0..1000 {
        let held = match BETWEEN.try_lock() {
            Ok(held) => Some(held),
            Err(TryLockError::Poisoned(error)) => Some(error.into_inner()),
            Err(TryLockError::WouldBlock) => None,
        };
        if held.is_some() {
            return Some(what());
        }
        std::thread::sleep(Duration::from_millis(1));
    }
    None
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
        let time = turn.start..Instant::now();
        let (mut took, worked) = turn.took();
        if took > TOLD {
            took = took.saturating_sub(held_up(time));
        }
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
    // Longer than what is asked for: the clocks of the kernel are not the same.
    std::thread::sleep(Duration::from_millis(60));
    assert!(turn.took().0 >= Duration::from_millis(30), "waiting for others counts");
    let mut longest = Longest::default();
    longest.take(&turn, Duration::ZERO, || "sleeping".into());
    drop(turn);
    // Unless the machine stands still just then.
    let is_kept = |_| {
        let mut longest = longest.clone();
        longest.take(&Turn::begin(), Duration::ZERO, || "nothing".into());
        longest.what == "sleeping"
    };
    assert!((0..20).any(is_kept));
}
