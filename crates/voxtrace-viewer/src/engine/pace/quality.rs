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
const EARLY: f64 = 0.85;
/// Late frames one after the other until a coarser quality is taken.
const PATIENCE: u32 = 4;
/// Early frames until a finer one is tried: while nothing is settled yet, then, and at most, after tries that failed.
const FIRST_WAIT: u32 = 2;
const WAIT: u32 = 30;
const LONGEST_WAIT: u32 = 1920;
/// A try has failed where frames are late within so many.
const TRIAL: u32 = 60;
/// How much of a new measurement counts.
const WEIGHT: f64 = 0.5;
/// Where even the coarsest frames are late, finer ones are worth twice their time.
const WORTH: f64 = 2.0;

/// Chooses the quality of one frame after the other.
#[derive(Clone, Debug)]
pub struct QualityPace {
    budget_ms: f64,
    /// Place among all.
    now: usize,
    /// What frames of each quality take, milliseconds, as far as they were seen.
    seen: [Option<f64>; ALL.len()],
    /// What the finest frame takes, as long as none was measured.
    guess: Option<f64>,
    late: u32,
    early: u32,
    /// Early frames that are waited for.
    wait: u32,
    /// Frames since a finer quality was tried.
    tried: Option<u32>,
}

/// Milliseconds of a frame that `VOXTRACE_VIEW_FRAME_MS` asks for: with many of them frames are as fine as they can be, also on a slow device, for pictures
/// of the window.
pub fn frame_ms() -> Option<f64> {
    std::env::var("VOXTRACE_VIEW_FRAME_MS").ok()?.parse().ok().filter(|ms: &f64| *ms > 0.0)
}

impl QualityPace {
    /// Frames that take `budget_ms` each.
    pub fn new(budget_ms: f64) -> Self {
        let (seen, guess) = ([None; ALL.len()], None);
        Self { budget_ms, now: 0, seen, guess, late: 0, early: 0, wait: FIRST_WAIT, tried: None }
    }

    /// Begins with what suits a device on which the finest frame takes about `ms`, where nothing is known yet.
    pub fn begin(&mut self, ms: f64) {
        if self.guess.is_none() && self.seen.iter().all(Option::is_none) {
            self.guess = Some(ms);
            self.now = self.finest(0, self.budget_ms);
        }
    }

    /// The quality of the next frame of a view that moves.
    pub fn moving(&self) -> Quality {
        quality(self.now)
    }

    /// The quality of the next frame of a view that stands, which may take `ms`: nobody waits for it, so all pixels have their paths, and
    /// they are as small as can be.
    pub fn still(&self, ms: f64) -> Quality {
        let ms = ms.max(self.budget_ms);
        let mut full = (0..self.now).filter(|&index| ALL[index].1 == Rate::Full);
        quality(full.find(|&index| self.expected(index).is_none_or(|expected| expected <= ms)).unwrap_or(self.now))
    }

    /// What a frame of a quality would take: what it took, or by what others did. A part is the same for all, as far as two are known; else all
    /// of it is taken to grow with the pixels, which is too much for finer ones.
    fn expected(&self, index: usize) -> Option<f64> {
        let known = |index: usize| self.seen[index].map(|ms| (ALL[index].2, ms));
        if let Some((_, ms)) = known(index) {
            return Some(ms);
        }
        // The two nearest, the finer ones first.
        let mut nearest: Vec<usize> = (0..ALL.len()).filter(|&other| known(other).is_some()).collect();
        nearest.sort_by_key(|&other| (other.abs_diff(index), other));
        let cost = ALL[index].2;
        match (nearest.first().copied().and_then(known), nearest.get(1).copied().and_then(known)) {
            (Some((a, a_ms)), Some((b, b_ms))) => {
                let slope = ((a_ms - b_ms) / (a - b)).max(0.0);
                Some((a_ms + slope * (cost - a)).max(0.0))
            }
            (Some((known, ms)), None) => Some(ms * cost / known),
            _ => self.guess.map(|ms| ms * cost),
        }
    }

    /// The finest quality from one on that takes no longer than may be, else the coarsest.
    fn finest(&self, from: usize, ms: f64) -> usize {
        let fits = |&index: &usize| self.expected(index).is_none_or(|expected| expected <= ms);
        (from..ALL.len()).find(fits).unwrap_or(ALL.len() - 1)
    }

    /// Milliseconds that a frame may take: where even the coarsest takes longer than its time, more.
    fn most(&self) -> f64 {
        let is_known = self.seen.iter().flatten().count() > 1;
        let least = self.expected(ALL.len() - 1).filter(|_| is_known).unwrap_or(0.0);
        self.budget_ms.max(WORTH * least)
    }

    /// Takes into account that a frame took `ms`. Where that of a view that stands is finer than those of views that move, and quick enough, theirs are as
    /// fine from now on.
    pub fn update(&mut self, of: Quality, ms: f64) {
        let Some(index) = (0..ALL.len()).find(|&index| quality(index) == of) else { return };
        let is_first = self.seen.iter().all(Option::is_none);
        let now = match self.seen[index] {
            Some(old) => {
                let now = old + WEIGHT * (ms - old);
                // A view that is harder or easier is so in every quality.
                self.seen.iter_mut().flatten().for_each(|ms| *ms *= now / old.max(1e-6));
                now
            }
            None => ms,
        };
        self.seen[index] = Some(now);
        if index < self.now && ms < EARLY * self.most() {
            self.go_to(index);
        }
        if index != self.now {
            return;
        }
        self.tried = self.tried.map(|frames| frames + 1).filter(|&frames| frames <= TRIAL);
        let most = self.most();
        self.late = if now > LATE * most { self.late + 1 } else { 0 };
        let finer = self.now.checked_sub(1).and_then(|finer| self.expected(finer));
        self.early = if finer.is_some_and(|ms| ms < EARLY * most) { self.early + 1 } else { 0 };
        if self.early == 0 {
            self.wait = self.wait.max(WAIT);
        }
        // At first nothing is known that could be lost.
        if self.late >= PATIENCE || (is_first && self.late > 0) {
            if self.tried.take().is_some() {
                self.wait = (self.wait.max(WAIT / 2) * 2).min(LONGEST_WAIT);
            }
            self.go_to(self.finest(self.now + 1, most));
        } else if self.early >= self.wait {
            self.go_to(self.finest(0, EARLY * most).min(self.now - 1));
            // What it took once is not what it takes now.
            self.seen[self.now] = None;
            self.tried = Some(0);
        }
    }

    fn go_to(&mut self, index: usize) {
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
    fn where_most_of_a_frame_is_the_same_for_all_pixels_are_not_made_large_in_vain() {
        for (same, finest) in [(50.0, 10.0), (7.0, 2.5), (40.0, 40.0)] {
            let mut pace = QualityPace::new(10.0);
            for _ in 0..400 {
                let still = pace.still(250.0);
                for quality in [still, pace.moving(), pace.moving()] {
                    let cost = ALL.iter().find(|(scale, rate, _)| (*scale, *rate) == (quality.scale, quality.rate));
                    pace.update(quality, same + finest * cost.unwrap().2);
                }
            }
            let ms = same + finest * ALL[pace.now].2;
            assert!(ms < 2.0 * same.max(10.0) && pace.now <= 3, "{same} + {finest}: {:?}", pace.moving());
        }
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
    fn a_quick_device_is_at_the_finest_within_some_frames_however_low_the_guess() {
        // As an H200 has them: little of a coarse frame depends on its pixels.
        let ms = |quality: Quality| {
            let cost = ALL.iter().find(|(scale, rate, _)| (*scale, *rate) == (quality.scale, quality.rate));
            0.5 + 6.0 * cost.unwrap().2
        };
        let mut pace = QualityPace::new(10.0);
        pace.begin(5000.0);
        assert_eq!(pace.moving().scale, 8);
        for _ in 0..12 {
            pace.update(pace.moving(), ms(pace.moving()));
        }
        assert_eq!(pace.moving(), Quality { scale: 1, rate: Rate::Full });
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
