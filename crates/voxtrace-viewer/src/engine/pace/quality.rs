//! How fine frames of real-time light are: as fine as their time allows, by what frames before took. Going from one to another loses what
//! is known of the pixels where their size changes, so it is done seldom, and not back and forth.

use voxtrace_vulkan::Rate;

/// How fine a frame is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Quality {
    /// Pixels of the window along each side of a pixel: 1, 2, 4 or 8.
    pub scale: u32,
    /// How many pixels have a path.
    pub rate: Rate,
}

/// All, from fine to coarse, and about what they take of the first one's time.
const ALL: [(u32, Rate, f64); 7] = [
    (1, Rate::Full, 1.0),
    (1, Rate::Half, 0.6),
    (2, Rate::Full, 0.25),
    (2, Rate::Half, 0.15),
    (4, Rate::Full, 0.0625),
    (4, Rate::Half, 0.0375),
    (8, Rate::Full, 0.0156),
];
/// Frames are late above this share of their time; a finer quality is tried where it would take less than this one.
const LATE: f64 = 1.25;
const EARLY: f64 = 0.7;
/// Late frames one after the other until a coarser quality is taken.
const PATIENCE: u32 = 4;
/// Early frames until a finer one is tried: at first, and at most, after tries that failed.
const WAIT: u32 = 30;
const LONGEST_WAIT: u32 = 1920;
/// A try has failed where frames are late within so many.
const TRIAL: u32 = 60;
/// How much of a new measurement counts.
const WEIGHT: f64 = 0.5;

/// Chooses the quality of one frame after the other.
#[derive(Clone, Debug)]
pub struct QualityPace {
    budget_ms: f64,
    /// Place among all.
    now: usize,
    /// What frames of it take; `None` before the first.
    ms: Option<f64>,
    /// Whether that is a guess.
    is_guessed: bool,
    late: u32,
    early: u32,
    /// Early frames that are waited for.
    wait: u32,
    /// Frames since a finer quality was tried.
    tried: Option<u32>,
}

impl QualityPace {
    /// Frames that take `budget_ms` each.
    pub fn new(budget_ms: f64) -> Self {
        Self { budget_ms, now: 0, ms: None, is_guessed: false, late: 0, early: 0, wait: WAIT, tried: None }
    }

    /// Begins with what suits a device on which the finest frame takes about `ms`, where nothing is known yet.
    pub fn begin(&mut self, ms: f64) {
        if self.ms.is_none() {
            let fits = |&index: &usize| ms * ALL[index].2 <= self.budget_ms;
            self.now = (0..ALL.len()).find(fits).unwrap_or(ALL.len() - 1);
            self.ms = Some(ms * ALL[self.now].2);
            self.is_guessed = true;
        }
    }

    /// The quality of the next frame of a view that moves.
    pub fn moving(&self) -> Quality {
        quality(self.now)
    }

    /// The quality of the next frame of a view that stands, which may take `ms`: nobody waits for it, so all pixels have their paths, and
    /// they are as small as can be.
    pub fn still(&self, ms: f64) -> Quality {
        let fits = |&index: &usize| self.ms.is_none_or(|now| now * ALL[index].2 / ALL[self.now].2 <= ms);
        let full = (0..self.now).filter(|&index| ALL[index].1 == Rate::Full);
        quality(full.into_iter().find(fits).unwrap_or(self.now))
    }

    /// Takes into account that a frame took `ms`. Where that of a view that stands is finer than those of views that move, and quick enough, theirs are as
    /// fine from now on.
    pub fn update(&mut self, of: Quality, ms: f64) {
        let finer = (0..self.now).find(|&index| quality(index) == of);
        if let Some(index) = finer.filter(|_| ms < EARLY * self.budget_ms) {
            self.go_to(index);
            (self.ms, self.is_guessed) = (Some(ms), false);
        }
        if of != self.moving() {
            return;
        }
        let is_first = self.ms.is_none() || std::mem::take(&mut self.is_guessed);
        let now = self.ms.filter(|_| !is_first).map_or(ms, |old| old + WEIGHT * (ms - old));
        self.ms = Some(now);
        self.tried = self.tried.map(|frames| frames + 1).filter(|&frames| frames <= TRIAL);
        self.late = if now > LATE * self.budget_ms { self.late + 1 } else { 0 };
        let finer = self.now.checked_sub(1).map(|index| now * ALL[index].2 / ALL[self.now].2);
        self.early = if finer.is_some_and(|ms| ms < EARLY * self.budget_ms) { self.early + 1 } else { 0 };
        // At first nothing is known that could be lost.
        if self.late >= PATIENCE || (is_first && self.late > 0) {
            if self.tried.take().is_some() {
                self.wait = (self.wait * 2).min(LONGEST_WAIT);
            }
            let fits = |&index: &usize| now * ALL[index].2 / ALL[self.now].2 <= self.budget_ms;
            self.go_to((self.now + 1..ALL.len()).find(fits).unwrap_or(ALL.len() - 1));
        } else if self.early >= self.wait {
            self.go_to(self.now - 1);
            self.tried = Some(0);
        }
    }

    fn go_to(&mut self, index: usize) {
        self.ms = self.ms.map(|ms| ms * ALL[index].2 / ALL[self.now].2);
        (self.now, self.late, self.early) = (index, 0, 0);
    }
}

fn quality(index: usize) -> Quality {
    let (scale, rate, _) = ALL[index];
    Quality { scale, rate }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The qualities of frames on a device, of which the finest takes so many milliseconds.
    fn frames(pace: &mut QualityPace, count: usize, mut finest_ms: impl FnMut(usize) -> f64) -> Vec<usize> {
        let mut frame = |index| {
            let now = pace.now;
            pace.update(pace.moving(), finest_ms(index) * ALL[now].2);
            now
        };
        (0..count).map(&mut frame).collect()
    }

    fn changes(qualities: &[usize]) -> usize {
        qualities.windows(2).filter(|pair| pair[0] != pair[1]).count()
    }

    #[test]
    fn a_quick_device_stays_at_the_finest_and_a_slow_one_takes_at_once_what_fits() {
        let mut quick = QualityPace::new(10.0);
        assert_eq!(changes(&frames(&mut quick, 500, |_| 4.0)), 0);
        assert_eq!(quick.moving(), Quality { scale: 1, rate: Rate::Full });
        let mut slow = QualityPace::new(10.0);
        frames(&mut slow, 2, |_| 60.0);
        assert_eq!(slow.moving(), Quality { scale: 2, rate: Rate::Half });
        // What is hopeless is as coarse as can be.
        let mut hopeless = QualityPace::new(10.0);
        frames(&mut hopeless, 2, |_| 1e5);
        assert_eq!(hopeless.moving().scale, 8);
    }

    #[test]
    fn half_rate_is_taken_where_it_is_enough() {
        let mut pace = QualityPace::new(10.0);
        frames(&mut pace, 2, |_| 15.0);
        assert_eq!(pace.moving(), Quality { scale: 1, rate: Rate::Half });
    }

    #[test]
    fn times_that_waver_around_the_budget_do_not_make_the_quality_flip() {
        for middle in [8.0, 10.0, 12.0, 14.0, 18.0, 40.0] {
            let mut pace = QualityPace::new(10.0);
            let qualities = frames(&mut pace, 3000, |index| middle * (1.0 + 0.2 * (index as f64).sin()));
            assert!(changes(&qualities) <= 10, "{middle} ms: {} changes", changes(&qualities));
            assert!(changes(&qualities[2000..]) <= 2, "{middle} ms: {} changes late", changes(&qualities[2000..]));
        }
    }

    #[test]
    fn one_slow_frame_changes_nothing_and_an_easier_view_becomes_finer() {
        let mut pace = QualityPace::new(10.0);
        frames(&mut pace, 100, |index| if index == 50 { 60.0 } else { 5.0 });
        assert_eq!(pace.now, 0);
        frames(&mut pace, 20, |_| 60.0);
        assert!(pace.moving().scale > 1);
        frames(&mut pace, 200, |_| 4.0);
        assert_eq!(pace.now, 0);
    }

    #[test]
    fn a_view_that_stands_is_traced_finer_where_that_takes_no_longer_than_may_be() {
        let mut pace = QualityPace::new(10.0);
        frames(&mut pace, 3, |_| 60.0);
        assert_eq!(pace.still(250.0), Quality { scale: 1, rate: Rate::Full });
        assert_eq!(pace.still(20.0), Quality { scale: 2, rate: Rate::Full });
        // What they take says nothing about frames of views that move, unless they are quick.
        let before = pace.now;
        pace.update(pace.still(250.0), 60.0);
        assert_eq!(pace.now, before);
        pace.update(pace.still(250.0), 5.0);
        assert_eq!(pace.now, 0);
    }

    #[test]
    fn a_guess_begins_and_a_measurement_decides() {
        let mut pace = QualityPace::new(10.0);
        pace.begin(50.0);
        assert_eq!((pace.moving().scale, pace.still(250.0).scale), (2, 1), "a guess too high");
        pace.update(pace.still(250.0), 4.0);
        assert_eq!(pace.moving(), Quality { scale: 1, rate: Rate::Full });
        let mut pace = QualityPace::new(10.0);
        pace.begin(10_000.0);
        assert_eq!((pace.moving().scale, pace.still(250.0).scale), (8, 8), "a device in software never traces seconds");
        let mut pace = QualityPace::new(10.0);
        pace.begin(5.0);
        pace.update(pace.moving(), 60.0);
        assert_eq!(pace.moving(), Quality { scale: 2, rate: Rate::Half }, "a guess too low");
    }
}
