//! The progress of a render that may be done again in part.

use std::sync::mpsc::{self, RecvTimeoutError};
use std::thread;
use std::time::Duration;
use voxtrace_core::Progress;

/// How often whoever waits is told, and asked whether to go on, where another tracer counts for itself.
const TICK: Duration = Duration::from_millis(20);

/// Reports samples to whoever watches a render, each once, although some are rendered again after a loss.
pub struct Watch<'a> {
    progress: &'a Progress,
    /// Samples of the film so far.
    film: u64,
    /// The most that it had.
    most: u64,
    is_begun: bool,
}

impl<'a> Watch<'a> {
    /// Watches a film that has so many samples.
    pub fn new(progress: &'a Progress, film: u64) -> Self {
        Self { progress, film, most: film, is_begun: false }
    }

    pub fn is_cancelled(&self) -> bool {
        self.progress.is_cancelled()
    }

    pub fn add(&mut self, samples: u64) {
        self.film += samples;
        self.progress.add(self.film.saturating_sub(self.most));
        self.most = self.most.max(self.film);
        self.is_begun |= samples > 0;
    }

    /// Goes back to a film with so many samples.
    pub fn go_back_to(&mut self, film: u64) {
        self.film = film;
        // It may hold more than was known of before.
        self.most = self.most.max(film);
    }

    /// Whether samples were rendered since the watch began.
    pub fn is_begun(&self) -> bool {
        self.is_begun
    }

    /// Lets another tracer go on, which counts on what it is given.
    pub fn follow<R>(&mut self, render: impl FnOnce(&Progress) -> R) -> R {
        if self.film >= self.most {
            return render(self.progress);
        }
        let own = Progress::default();
        if self.is_cancelled() {
            own.cancel();
        }
        let mut told = 0;
        // Whoever ends closes the channel, a panic too.
        let (end, ended) = mpsc::channel::<()>();
        let result = thread::scope(|scope| {
            let (watch, own, told) = (&mut *self, &own, &mut told);
            scope.spawn(move || {
                while ended.recv_timeout(TICK) == Err(RecvTimeoutError::Timeout) {
                    if watch.is_cancelled() {
                        own.cancel();
                    }
                    watch.tell(own, told);
                }
            });
            let _end = end;
            render(own)
        });
        self.tell(&own, &mut told);
        result
    }

    fn tell(&mut self, own: &Progress, told: &mut u64) {
        let done = own.samples_done();
        self.add(done - *told);
        *told = done;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn samples_that_are_rendered_again_are_reported_once() {
        let progress = Progress::default();
        // Of an earlier call.
        let mut watch = Watch::new(&progress, 30);
        assert!(!watch.is_begun());
        watch.add(100);
        watch.go_back_to(10);
        watch.add(110);
        assert_eq!(progress.samples_done(), 100);
        watch.add(40);
        assert_eq!(progress.samples_done(), 130);
        assert!(watch.is_begun());
    }

    #[test]
    fn a_tracer_that_goes_on_reports_what_is_new() {
        let progress = Progress::default();
        let mut watch = Watch::new(&progress, 0);
        watch.add(100);
        watch.go_back_to(60);
        watch.follow(|own| own.add(60));
        assert_eq!(progress.samples_done(), 120, "40 of them were reported before");
        watch.follow(|own| own.add(30));
        assert_eq!(progress.samples_done(), 150, "all of them are new");
        // While it goes on.
        watch.go_back_to(50);
        let is_cancelled = watch.follow(|own| {
            own.add(150);
            while progress.samples_done() == 150 {
                thread::sleep(TICK);
            }
            progress.cancel();
            while !own.is_cancelled() {
                thread::sleep(TICK);
            }
            own.is_cancelled()
        });
        assert!(is_cancelled);
    }
}
