//! How much of the processors a measurement got: processor time over wall time, how long its threads waited for one, and what other programs took.
//! Times on a machine that others use say little. From Linux's clock of the process (clock_gettime(2)) and `/proc` (schedstat, stat:
//! Documentation/scheduler/sched-stats.rst and proc(5)); elsewhere nothing is known.

use serde_json::{Value, json};
use std::collections::HashMap;
use std::time::Instant;

/// Most of its time that a program may wait for processors on a machine that counts as quiet.
const MOST_WAITED: f64 = 0.05;
/// Most of the processors that other programs may have there.
const MOST_OTHERS: f64 = 0.10;
/// Ticks a second in `/proc/stat`, whatever the kernel's own clock is.
const TICKS: f64 = 100.0;

/// What the processors did while something was measured, seconds.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Processor {
    /// By the wall clock.
    pub wall: f64,
    /// Processor time of this program's threads.
    pub own: Option<f64>,
    /// Time in which its threads could run and had no processor.
    pub waited: Option<f64>,
    /// Processor time of everything else on the processors that this program may use, what a hypervisor took included. Counted in ticks, so
    /// that of short turns it may be less than nothing, which makes up for those of which it is too much.
    pub others: Option<f64>,
    /// Processors that this program may use.
    pub count: Option<usize>,
    /// Turns in which it was measured, those of other cells between them.
    pub turns: u32,
}

impl Processor {
    /// Adds another turn.
    pub fn add(&mut self, turn: Self) {
        let is_first = self.turns == 0;
        let sum = |a: Option<f64>, b: Option<f64>| if is_first { b } else { a.zip(b).map(|(a, b)| a + b) };
        *self = Self {
            wall: self.wall + turn.wall,
            own: sum(self.own, turn.own),
            waited: sum(self.waited, turn.waited),
            others: sum(self.others, turn.others),
            count: turn.count,
            turns: self.turns + turn.turns,
        };
    }

    /// Processors that it had at a time.
    pub fn share(&self) -> Option<f64> {
        Some(self.own? / self.wall).filter(|share| share.is_finite())
    }

    /// Part of the time in which its threads could run that they waited.
    pub fn waited_part(&self) -> Option<f64> {
        let (own, waited) = (self.own?, self.waited?);
        Some(waited / (own + waited)).filter(|part| part.is_finite())
    }

    /// Part of the processors that other programs had.
    pub fn others_part(&self) -> Option<f64> {
        Some(self.others? / self.wall / self.count? as f64)
            .filter(|part| part.is_finite())
            .map(|part| part.clamp(0.0, 1.0))
    }

    /// Why times of work on the processors say little; `None` where the machine was quiet or nothing is known.
    pub fn disturbance(&self) -> Option<String> {
        let percent = |part: f64| format!("{:.0} %", 100.0 * part);
        let waited = self.waited_part().filter(|&part| part > MOST_WAITED);
        // On each processor a turn is counted to a tick.
        let unknown = f64::from(self.turns) / TICKS / self.wall;
        let others = self.others_part().filter(|&part| part > MOST_OTHERS + unknown);
        match (waited, others) {
            (None, None) => None,
            (Some(waited), None) => Some(format!("threads waited {} of the time for a processor", percent(waited))),
            (None, Some(others)) => Some(format!("other programs had {} of the processors", percent(others))),
            (Some(waited), Some(others)) => Some(format!(
                "threads waited {} of the time for a processor, other programs had {}",
                percent(waited),
                percent(others)
            )),
        }
    }

    /// As a cell of `results.json` has it.
    pub fn json(&self) -> Value {
        json!({
            "wall_s": self.wall, "processor_s": self.own, "waited_s": self.waited,
            "others_s": self.others.map(|others| others.max(0.0)), "processors": self.count, "turns": self.turns,
        })
    }

    /// Reads what [`Self::json`] wrote.
    pub fn from_json(json: &Value) -> Option<Self> {
        let number = |name: &str| json[name].as_f64();
        Some(Self {
            wall: number("wall_s")?,
            own: number("processor_s"),
            waited: number("waited_s"),
            others: number("others_s"),
            count: json["processors"].as_u64().and_then(|count| usize::try_from(count).ok()),
            turns: json["turns"].as_u64().and_then(|turns| u32::try_from(turns).ok())?,
        })
    }
}

/// Counts from now on.
pub struct Watch {
    start: Instant,
    counters: Option<Counters>,
}

impl Watch {
    /// Begins.
    pub fn start() -> Self {
        Self { counters: Counters::now(), start: Instant::now() }
    }

    /// What there was since then, as one turn.
    pub fn stop(self) -> Processor {
        let wall = self.start.elapsed().as_secs_f64();
        let Some((before, after)) = self.counters.zip(Counters::now()) else {
            return Processor { wall, turns: 1, ..Processor::default() };
        };
        let own = after.own - before.own;
        Processor {
            wall,
            own: Some(own),
            waited: after.waited.zip(before.waited).map(|(after, before)| waited_between(&before, &after)),
            others: after.all.zip(before.all).map(|(after, before)| after - before - own),
            count: Some(after.count),
            turns: 1,
        }
    }
}

/// Seconds since the start of this program, and of the machine.
struct Counters {
    /// Of all threads, those that ended included.
    own: f64,
    /// By the number of each thread that there is.
    waited: Option<HashMap<String, f64>>,
    all: Option<f64>,
    count: usize,
}

impl Counters {
    fn now() -> Option<Self> {
        let read = |path: &str| std::fs::read_to_string(path).ok();
        let status = read("/proc/self/status")?;
        let list = status.lines().find_map(|line| line.strip_prefix("Cpus_allowed_list:"))?;
        let allowed = processors(list.trim())?;
        let all = read("/proc/stat").and_then(|text| ticks_of_all(&text, &allowed)).map(|ticks| ticks / TICKS);
        let threads = std::fs::read_dir("/proc/self/task").ok()?.flatten();
        // A thread that ended meanwhile has no file.
        let waited: HashMap<_, _> = threads
            .filter_map(|thread| {
                let schedule = std::fs::read_to_string(thread.path().join("schedstat")).ok()?;
                Some((thread.file_name().into_string().ok()?, waited(&schedule)?))
            })
            .collect();
        let waited = Some(waited).filter(|waited| !waited.is_empty());
        Some(Self { own: own_time()?, waited, all, count: allowed.len() })
    }
}

/// Seconds for which the threads had no processor between two readings. What a thread waited that ended between them is not known.
fn waited_between(before: &HashMap<String, f64>, after: &HashMap<String, f64>) -> f64 {
    // A number may be that of another thread by now, which began with nothing.
    let since =
        |(thread, &now): (&String, &f64)| now - before.get(thread).copied().filter(|&then| then <= now).unwrap_or(0.0);
    after.iter().map(since).sum()
}

/// Processor time of this program, seconds.
#[cfg(target_os = "linux")]
fn own_time() -> Option<f64> {
    let time = rustix::time::clock_gettime(rustix::time::ClockId::ProcessCPUTime);
    Some(time.tv_sec as f64 + time.tv_nsec as f64 * 1e-9)
}

#[cfg(not(target_os = "linux"))]
fn own_time() -> Option<f64> {
    None
}

/// The numbers of a list as `0-3,8`.
fn processors(list: &str) -> Option<Vec<usize>> {
    let range = |part: &str| {
        let (first, last) = part.split_once('-').unwrap_or((part, part));
        Some(first.parse::<usize>().ok()?..=last.parse::<usize>().ok().filter(|&last| last < 1 << 16)?)
    };
    let ranges: Option<Vec<_>> = list.split(',').map(range).collect();
    Some(ranges?.into_iter().flatten().collect())
}

/// Ticks in which these processors did something, stolen ones included: neither idle nor waiting for a disk.
fn ticks_of_all(text: &str, allowed: &[usize]) -> Option<f64> {
    let busy = |line: &str| {
        let mut words = line.strip_prefix("cpu")?.split_ascii_whitespace();
        let number: usize = words.next()?.parse().ok()?;
        let ticks: Vec<f64> = words.filter_map(|word| word.parse().ok()).collect();
        let [user, nice, system, _, _, irq, softirq, steal, ..] = ticks[..] else { return None };
        allowed.contains(&number).then_some(user + nice + system + irq + softirq + steal)
    };
    // The line of all processors has no number, and is none of them.
    let each: Vec<f64> = text.lines().filter(|line| !line.starts_with("cpu ")).filter_map(busy).collect();
    (each.len() == allowed.len()).then(|| each.iter().sum())
}

/// Seconds that a thread waited, of its `schedstat`.
fn waited(text: &str) -> Option<f64> {
    text.split_ascii_whitespace().nth(1)?.parse::<f64>().ok().map(|nanoseconds| nanoseconds * 1e-9)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn turn(own: f64, waited: f64, others: f64) -> Processor {
        Processor { wall: 10.0, own: Some(own), waited: Some(waited), others: Some(others), count: Some(4), turns: 1 }
    }

    #[test]
    fn a_machine_is_quiet_until_threads_wait_or_others_work() {
        assert_eq!(turn(38.0, 1.0, 1.0).disturbance(), None);
        assert_eq!(turn(20.0, 20.0, 0.0).disturbance().unwrap(), "threads waited 50 % of the time for a processor");
        assert_eq!(turn(20.0, 0.5, 20.0).disturbance().unwrap(), "other programs had 50 % of the processors");
        let both = turn(20.0, 20.0, 20.0).disturbance().unwrap();
        assert_eq!(both, "threads waited 50 % of the time for a processor, other programs had 50 %");
        assert_eq!(Processor { wall: 1.0, turns: 1, ..Processor::default() }.disturbance(), None, "nothing is known");
    }

    #[test]
    fn turns_that_are_shorter_than_ticks_accuse_nobody() {
        // Eight turns of eight milliseconds on two processors, where three of the ticks fell into them that were due before.
        let short = Processor {
            wall: 0.064,
            own: Some(0.128),
            waited: Some(0.0),
            others: Some(0.03),
            count: Some(2),
            turns: 8,
        };
        assert_eq!(short.disturbance(), None);
        let long = Processor { wall: 6.4, own: Some(12.8), others: Some(3.0), ..short.clone() };
        assert_eq!(long.disturbance().unwrap(), "other programs had 23 % of the processors");
        let mut sum = Processor::default();
        sum.add(Processor { others: Some(-0.02), turns: 1, ..short.clone() });
        assert_eq!((sum.others_part(), &sum.json()["others_s"]), (Some(0.0), &0.0.into()));
        sum.add(Processor { others: Some(0.03), turns: 1, ..short });
        assert!((sum.others.unwrap() - 0.01).abs() < 1e-9, "what is too little makes up for what is too much");
    }

    #[test]
    fn turns_add_up_and_are_read_as_they_were_written() {
        let mut sum = Processor::default();
        sum.add(turn(38.0, 1.0, 1.0));
        sum.add(turn(20.0, 3.0, 9.0));
        let expected = Processor { wall: 20.0, turns: 2, ..turn(58.0, 4.0, 10.0) };
        assert_eq!(sum, expected);
        assert_eq!(Processor::from_json(&sum.json()), Some(expected));
        sum.add(Processor { others: None, ..turn(1.0, 1.0, 0.0) });
        assert_eq!((sum.others, sum.own), (None, Some(59.0)), "what is not known of a part is not known of the whole");
        assert_eq!(Processor::from_json(&Value::Null), None);
    }

    #[test]
    fn the_kernel_s_tables_are_read() {
        assert_eq!(processors("0-2,5"), Some(vec![0, 1, 2, 5]));
        assert_eq!(processors("0-"), None);
        let stat = "cpu  9 9 9 9 9 9 9 9 0 0\ncpu0 1 2 3 100 100 4 5 6 0 0\ncpu1 10 0 0 7 0 0 0 0 0 0\nintr 5 6\n";
        assert_eq!(ticks_of_all(stat, &[0, 1]), Some(31.0));
        assert_eq!(ticks_of_all(stat, &[1]), Some(10.0));
        assert_eq!(ticks_of_all(stat, &[1, 2]), None);
        assert_eq!(waited("2000000000 500000000 7\n"), Some(0.5));
        assert_eq!(waited("2000000000"), None);
    }

    #[test]
    fn threads_that_begin_and_end_take_no_waiting_away() {
        let at =
            |threads: &[(&str, f64)]| threads.iter().map(|&(thread, waited)| (thread.to_owned(), waited)).collect();
        let (before, after) = (at(&[("1", 3.0), ("2", 50.0), ("3", 7.0)]), at(&[("1", 3.5), ("3", 0.25), ("4", 1.0)]));
        assert_eq!(waited_between(&before, &after), 0.5 + 0.25 + 1.0);
    }

    #[test]
    fn a_thread_that_works_is_seen_to_work_also_when_it_has_ended() {
        if Counters::now().is_none() {
            return voxtrace_test_support::skip("this system has no /proc");
        }
        let watch = Watch::start();
        // Until a twentieth of a second is counted, however long the machine takes for it.
        let works = || {
            let (start, begin) = (own_time().unwrap(), Instant::now());
            while own_time().unwrap() < start + 0.05 {
                assert!(begin.elapsed().as_secs() < 300, "nothing is counted");
            }
        };
        std::thread::spawn(works).join().unwrap();
        let told = watch.stop();
        assert!(told.own.unwrap() >= 0.05, "{told:?}");
        assert!(told.wall > 0.0 && told.count >= Some(1) && told.waited.is_none_or(|waited| waited >= 0.0), "{told:?}");
    }
}
