//! The progress of a render that may be done again in part.

use voxtrace_core::Progress;

/// Reports samples to whoever watches a render, each once, although some are rendered again after a loss.
pub struct Watch<'a> {
    progress: &'a Progress,
    /// Samples of the film so far.
    done: u64,
    /// The most that was reported.
    reported: u64,
}

impl<'a> Watch<'a> {
    pub fn new(progress: &'a Progress) -> Self {
        Self { progress, done: 0, reported: 0 }
    }

    pub fn is_cancelled(&self) -> bool {
        self.progress.is_cancelled()
    }

    pub fn add(&mut self, samples: u64) {
        self.done += samples;
        self.progress.add(self.done.saturating_sub(self.reported));
        self.reported = self.reported.max(self.done);
    }

    /// Goes back to a film with that many samples fewer than there were.
    pub fn forget(&mut self, samples: u64) {
        self.done = self.done.saturating_sub(samples);
    }

    /// Samples rendered since the watch began, those that were lost left out.
    pub fn done(&self) -> u64 {
        self.done
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn samples_that_are_rendered_again_are_reported_once() {
        let progress = Progress::default();
        let mut watch = Watch::new(&progress);
        watch.add(100);
        watch.forget(40);
        watch.add(30);
        assert_eq!((watch.done(), progress.samples_done()), (90, 100));
        watch.add(30);
        assert_eq!((watch.done(), progress.samples_done()), (120, 120));
    }
}
