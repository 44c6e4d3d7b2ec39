//! How much of a picture each device gets next. What there is to do is a range of units, samples of all pixels or rows of pixels; each device gets as many
//! of them as it does in a while, by how quick it was last, and less towards the end, so that all of them end together.

use std::ops::Range;
use std::time::Duration;

/// A device is asked for what takes about so long, or so many times as long as handing the part over takes, if that is more.
const A_WHILE: f64 = 1.0;
const TIMES_OF_HANDING_OVER: f64 = 30.0;
/// What takes less than this is not shared further, in seconds.
const SHORTEST: f64 = 0.2;

/// How quick a device is, as far as it is known.
#[derive(Clone, Copy, Debug, Default)]
pub struct Pace {
    /// Units of one sample of all pixels in a second; 0: not known yet.
    pub rate: f64,
    /// Seconds that handing a part over took.
    pub overhead: f64,
}

impl Pace {
    /// What a part says: its share of one sample of all pixels, how long it was traced, and how long it took to hand it over.
    pub fn learn(&mut self, samples: f64, traced: Duration, handed_over: Duration) {
        self.rate = samples / traced.as_secs_f64().max(1e-6);
        self.overhead = handed_over.as_secs_f64();
    }
}

/// What is left to be dealt out.
#[derive(Debug)]
pub struct Deal {
    left: Range<u32>,
    /// What devices gave back undone.
    returned: Vec<Range<u32>>,
    /// Samples of all pixels that one unit is.
    unit: f64,
    /// Units for a device of which nothing is known.
    first: u32,
}

impl Deal {
    pub fn new(units: Range<u32>, unit: f64, first: u32) -> Self {
        Self { left: units, returned: Vec::new(), unit, first: first.max(1) }
    }

    pub fn is_empty(&self) -> bool {
        self.left.is_empty() && self.returned.is_empty()
    }

    /// Samples of all pixels that so many units are.
    pub fn samples(&self, units: &Range<u32>) -> f64 {
        units.len() as f64 * self.unit
    }

    /// The next part for a device of a pace, while all of them together have the rate `together`; `None` where nothing is left.
    pub fn take(&mut self, pace: Pace, together: f64) -> Option<Range<u32>> {
        if let Some(part) = self.returned.pop() {
            return Some(part);
        }
        let all = self.left.len() as u32;
        if all == 0 {
            return None;
        }
        let units = if pace.rate > 0.0 {
            // Half of what there is left for it, so that later parts even out what nobody foresaw.
            let share = 0.5 * self.samples(&self.left) / together.max(pace.rate);
            let seconds = share.clamp(SHORTEST, f64::max(A_WHILE, TIMES_OF_HANDING_OVER * pace.overhead));
            (pace.rate * seconds / self.unit).round() as u32
        } else {
            self.first
        };
        let end = self.left.start + units.clamp(1, all);
        let part = self.left.start..end;
        self.left.start = end;
        Some(part)
    }

    /// Takes a part back that nobody did.
    pub fn give_back(&mut self, part: Range<u32>) {
        self.returned.push(part);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Devices of these rates deal among themselves; returns when each was done, in seconds, and what they had.
    fn ends(rates: &[f64], units: u32) -> (Vec<f64>, Vec<Range<u32>>) {
        let mut deal = Deal::new(0..units, 1.0, 1);
        let (mut at, mut paces) = (vec![0.0_f64; rates.len()], vec![Pace::default(); rates.len()]);
        let mut parts = Vec::new();
        let mut is_done = vec![false; rates.len()];
        while let Some(next) = (0..rates.len()).filter(|&of| !is_done[of]).min_by(|&a, &b| at[a].total_cmp(&at[b])) {
            let together = paces.iter().map(|pace| pace.rate).sum();
            let Some(part) = deal.take(paces[next], together) else {
                is_done[next] = true;
                continue;
            };
            let seconds = part.len() as f64 / rates[next];
            at[next] += seconds;
            paces[next].learn(part.len() as f64, Duration::from_secs_f64(seconds), Duration::ZERO);
            parts.push(part);
        }
        (at, parts)
    }

    #[test]
    fn devices_of_any_speed_end_together_and_every_unit_is_dealt_once() {
        for rates in [&[100.0, 100.0][..], &[300.0, 100.0, 20.0], &[1000.0]] {
            let (ends, mut parts) = ends(rates, 4096);
            let best = 4096.0 / rates.iter().sum::<f64>();
            assert!(ends.iter().all(|end| (end - best).abs() <= 0.25), "{ends:?}, at best {best}");
            parts.sort_by_key(|part| part.start);
            assert_eq!((parts[0].start, parts[parts.len() - 1].end), (0, 4096));
            assert!(parts.windows(2).all(|pair| pair[0].end == pair[1].start));
            assert!(parts.len() < 100, "{} parts", parts.len());
        }
    }

    #[test]
    fn what_is_given_back_comes_first() {
        let mut deal = Deal::new(0..10, 1.0, 2);
        let part = deal.take(Pace::default(), 0.0).unwrap();
        assert_eq!(part, 0..2);
        deal.give_back(part);
        assert_eq!(deal.take(Pace::default(), 0.0), Some(0..2));
        assert_eq!(deal.take(Pace::default(), 0.0), Some(2..4));
    }
}
