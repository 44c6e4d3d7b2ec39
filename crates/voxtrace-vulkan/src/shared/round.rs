//! Devices bring a film to its end: each takes a part, traces it, hands its film over and takes the next one.

use super::deal::Deal;
use super::gather::Gathered;
use super::member::Member;
use std::ops::Range;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::{Duration, Instant};
use voxtrace_core::{Film, Frame, Progress, Region, TraceError, Tracer};

/// How often whoever waits is told, and asked whether to go on.
const TICK: Duration = Duration::from_millis(20);
/// A device that takes so many times as long for a part as an idle one would, and this long at least, is overtaken by it.
const PATIENCE: f64 = 2.0;
const SHORTEST_PATIENCE: f64 = 0.5;

/// A part that a device is busy with.
struct Running {
    part: Range<u32>,
    begun: Instant,
    progress: Arc<Progress>,
    /// Whether another device does it as well.
    is_overtaken: bool,
}

/// What devices share while they trace.
struct Table {
    deal: Deal,
    gathered: Gathered,
    running: Vec<Option<Running>>,
    /// Rates, by device; 0 for those that do not take part.
    rates: Vec<f64>,
    finished: Vec<Range<u32>>,
    /// Samples of pixels of the parts that are finished.
    done: u64,
    /// Devices that are at it.
    busy: usize,
    is_cancelled: bool,
    notes: Vec<String>,
    failure: Option<TraceError>,
}

impl Table {
    fn is_over(&self) -> bool {
        self.is_cancelled || self.gathered.is_complete() || self.failure.is_some()
    }

    /// What devices still have to do of the parts that they are busy with, samples of all pixels, as far as it is known how quick they are.
    fn under_way(&self) -> f64 {
        let busy = self.running.iter().zip(&self.rates).filter_map(|(running, rate)| Some((running.as_ref()?, rate)));
        let rest = |(running, rate): (&Running, &f64)| {
            let done = running.begun.elapsed().as_secs_f64() * rate;
            f64::max(0.0, self.deal.samples(&running.part) - done)
        };
        busy.filter(|(_, rate)| **rate > 0.0).map(rest).sum()
    }

    /// A part that keeps everybody waiting, for another device that does it as well: whichever is there first counts. That is one whose device takes much
    /// longer than it said, and in the end, when there is nothing else to do, than this one would.
    fn overtaken(&mut self, member: &Member) -> Option<Range<u32>> {
        let (deal, rates) = (&self.deal, &self.rates);
        let is_end = deal.is_empty();
        let is_slow = |(number, running): &(usize, &mut Running)| {
            let own = rates[*number];
            let rate = if is_end || own == 0.0 { member.pace.rate } else { own };
            let wanted = deal.samples(&running.part) / rate.max(1e-9);
            let patience = f64::max(PATIENCE * wanted, SHORTEST_PATIENCE);
            !running.is_overtaken && running.begun.elapsed().as_secs_f64() > patience
        };
        let running = self.running.iter_mut().enumerate();
        let mut slow = running.filter_map(|(number, running)| Some((number, running.as_mut()?))).filter(is_slow);
        let (_, slow) = slow.next()?;
        slow.is_overtaken = true;
        Some(slow.part.clone())
    }
}

/// A round of sharing.
pub struct Round<'a> {
    frame: &'a Frame,
    table: Mutex<Table>,
    changed: Condvar,
}

impl<'a> Round<'a> {
    pub fn new(frame: &'a Frame, deal: Deal, gathered: Gathered, members: &[Member]) -> Self {
        let rates = members.iter().map(|member| if member.is_ready() { member.pace.rate } else { 0.0 });
        let table = Table {
            deal,
            gathered,
            running: members.iter().map(|_| None).collect(),
            rates: rates.collect(),
            finished: Vec::new(),
            done: 0,
            busy: members.iter().filter(|member| member.is_ready()).count(),
            is_cancelled: false,
            notes: Vec::new(),
            failure: None,
        };
        Self { frame, table: Mutex::new(table), changed: Condvar::new() }
    }

    /// Traces until the film is whole, or cancelled, or no device is left. Returns the film and what there is to say.
    pub fn run(self, members: &mut [Member], progress: &Progress) -> (Film, Vec<String>, Result<(), TraceError>) {
        thread::scope(|scope| {
            let ready = members.iter_mut().enumerate().filter(|(_, member)| member.is_ready());
            let round = &self;
            let threads: Vec<_> =
                ready.map(|(number, member)| scope.spawn(move || round.work(number, member))).collect();
            let mut told = 0;
            loop {
                let mut table = self.lock();
                table.is_cancelled |= progress.is_cancelled();
                if table.is_over() {
                    table.running.iter().flatten().for_each(|running| running.progress.cancel());
                }
                told = tell(&table, progress, told);
                // A thread that panicked does not say that it is done.
                if table.busy == 0 || threads.iter().all(thread::ScopedJoinHandle::is_finished) {
                    break;
                }
                drop(self.changed.wait_timeout(table, TICK).unwrap_or_else(PoisonError::into_inner));
            }
        });
        let table = self.table.into_inner().unwrap_or_else(PoisonError::into_inner);
        (table.gathered.film, table.notes, table.failure.map_or(Ok(()), Err))
    }

    fn lock(&self) -> MutexGuard<'_, Table> {
        self.table.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// What one device does.
    fn work(&self, number: usize, member: &mut Member) {
        #[cfg(feature = "faults")]
        member.follow_faults();
        while let Some((part, progress)) = self.next(number, member) {
            let (frame, start) = self.lock().gathered.task(self.frame, &part);
            match trace(member.tracer(), &frame, start, &progress) {
                Ok((film, traced, reading)) => {
                    let begun = Instant::now();
                    let is_whole = film.sample_range().0 >= frame.samples;
                    let samples = self.hand_over(number, &part, film, is_whole);
                    if is_whole {
                        member.pace.learn(samples, traced, reading + begun.elapsed());
                        self.lock().rates[number] = member.pace.rate;
                    }
                }
                Err(error) => self.leave(number, member, part, error),
            }
            self.changed.notify_all();
        }
        self.lock().busy -= 1;
        self.changed.notify_all();
    }

    /// The next part of a device, which waits while others do the last ones. `None` when it may go.
    fn next(&self, number: usize, member: &Member) -> Option<(Range<u32>, Arc<Progress>)> {
        let mut table = self.lock();
        while !table.is_over() && member.is_ready() {
            let together = table.rates.iter().sum();
            let (overtaken, under_way) = (table.overtaken(member), table.under_way());
            if let Some(part) = overtaken.or_else(|| table.deal.take(member.pace, together, under_way)) {
                let progress = Arc::new(Progress::default());
                let (begun, shared) = (Instant::now(), Arc::clone(&progress));
                let running = Running { part: part.clone(), begun, progress: shared, is_overtaken: false };
                table.running[number] = Some(running);
                return Some((part, progress));
            }
            table = self.changed.wait_timeout(table, TICK).unwrap_or_else(PoisonError::into_inner).0;
        }
        None
    }

    /// Puts the film of a part with the others, unless another device was quicker. Returns the samples of all pixels that the part is.
    fn hand_over(&self, number: usize, part: &Range<u32>, film: Film, is_whole: bool) -> f64 {
        let mut table = self.lock();
        let samples = table.running[number].take().map_or(0, |running| running.progress.samples_done());
        let is_wanted = !table.finished.contains(part);
        if is_wanted && is_whole {
            table.gathered.put(part, film);
            table.finished.push(part.clone());
            table.done += samples;
            let same = table.running.iter().flatten().filter(|running| running.part == *part);
            same.for_each(|running| running.progress.cancel());
        } else if is_wanted && table.is_cancelled {
            table.gathered.put_unfinished(part, &film);
            table.done += samples;
        }
        table.deal.samples(part)
    }

    /// A device is left out after an error, and what it had goes to the others.
    fn leave(&self, number: usize, member: &mut Member, part: Range<u32>, error: TraceError) {
        let mut table = self.lock();
        let table = &mut *table;
        table.running[number] = None;
        table.rates[number] = 0.0;
        let is_taken = table.running.iter().flatten().any(|running| running.part == part);
        if !is_taken && !table.finished.contains(&part) {
            table.deal.give_back(part);
        }
        if let Err(error) = member.leave(error, &mut table.notes) {
            table.failure = Some(error);
        }
    }
}

/// Traces a part. Returns its film, and how long it took to trace it and to read it.
fn trace(
    tracer: &mut (dyn Tracer + Send),
    frame: &Frame,
    start: Option<Film>,
    progress: &Progress,
) -> Result<(Film, Duration, Duration), TraceError> {
    let begun = Instant::now();
    if let Some(start) = start {
        tracer.resume(frame, start)?;
    }
    tracer.render(frame, progress)?;
    let traced = begun.elapsed();
    let mut film = Film::new(0, 0, Region::full(0, 0), 0);
    tracer.read(&mut film)?;
    Ok((film, traced, begun.elapsed().saturating_sub(traced)))
}

/// Tells whoever waits how many samples there are; those that are lost are not told again.
fn tell(table: &Table, progress: &Progress, told: u64) -> u64 {
    let running = table.running.iter().flatten().filter(|running| !running.is_overtaken);
    let done = table.done + running.map(|running| running.progress.samples_done()).sum::<u64>();
    progress.add(done.saturating_sub(told));
    done.max(told)
}
