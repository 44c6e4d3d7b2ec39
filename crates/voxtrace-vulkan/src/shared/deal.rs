//! How much of a picture each device gets next. What there is to do is a range of units, samples of all pixels or rows of pixels; each device gets as many
//! of them as it does in a while, by how quick it was last, and less towards the end, so that all of them end together.

use std::ops::Range;
use std::time::Duration;

/// A part takes at most so long, or so many times as long as handing it over takes, if that is more: so much is lost with a device.
const LONGEST: f64 = 2.0;
const MOST_TIMES_OF_HANDING_OVER: f64 = 50.0;
/// What takes less than this, or so many times as long as handing it over, is not shared further, in seconds.
const SHORTEST: f64 = 0.1;
const LEAST_TIMES_OF_HANDING_OVER: f64 = 6.0;
/// Part of what is left for a device that it gets at once: later parts even out what nobody foresaw.
const SHARE: f64 = 0.75;

/// How quick a device is, as far as it is known.
#[derive(Clone, Copy, Debug, Default)]
pub struct Pace {
    /// Units of one sample of all pixels in a second; 0: not known yet.
    pub rate: f64,
    /// Seconds that reading the film of a part and adding it took.
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

    /// The next part for a device of a pace, while all of them together have the rate `together`, and the others are busy with what is `under_way`, samples of
    /// all pixels; `None` where nothing is left.
    pub fn take(&mut self, pace: Pace, together: f64, under_way: f64) -> Option<Range<u32>> {
        if let Some(part) = self.returned.pop() {
            return Some(part);
        }
        let all = self.left.len() as u32;
        if all == 0 {
            return None;
        }
        let units = if pace.rate > 0.0 {
            // When all of them would end, if they shared what is left fairly.
            let share = (self.samples(&self.left) + under_way) / together.max(pace.rate);
            let shortest = f64::max(SHORTEST, LEAST_TIMES_OF_HANDING_OVER * pace.overhead);
            let longest = f64::max(LONGEST, MOST_TIMES_OF_HANDING_OVER * pace.overhead);
            let seconds = if share * SHARE.min(1.0 - SHARE) < shortest { share } else { share * SHARE };
            let seconds = seconds.min(longest);
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

    /// Devices of these rates deal among themselves, and take so many seconds to hand a part over; returns when each was done, in seconds, and what they had.
    fn ends(rates: &[f64], units: u32, overhead: f64) -> (Vec<f64>, Vec<Range<u32>>) {
        let mut deal = Deal::new(0..units, 1.0, 1);
        let (mut at, mut paces) = (vec![0.0_f64; rates.len()], vec![Pace::default(); rates.len()]);
        let mut parts = Vec::new();
        let mut is_done = vec![false; rates.len()];
        while let Some(next) = (0..rates.len()).filter(|&of| !is_done[of]).min_by(|&a, &b| at[a].total_cmp(&at[b])) {
            let together = paces.iter().map(|pace| pace.rate).sum();
            let busy = (0..rates.len()).filter(|&of| of != next && !is_done[of]);
            let under_way = busy.map(|of| (at[of] - at[next]) * rates[of]).sum();
            let Some(part) = deal.take(paces[next], together, under_way) else {
                is_done[next] = true;
                continue;
            };
            let seconds = part.len() as f64 / rates[next];
            at[next] += seconds + overhead;
            let spans = [seconds, overhead].map(Duration::from_secs_f64);
            paces[next].learn(part.len() as f64, spans[0], spans[1]);
            parts.push(part);
        }
        (at, parts)
    }

    #[test]
    fn devices_of_any_speed_end_together_and_every_unit_is_dealt_once() {
        for rates in [&[100.0, 100.0][..], &[300.0, 100.0, 20.0], &[1000.0]] {
            let (ends, mut parts) = ends(rates, 4096, 0.0);
            let best = 4096.0 / rates.iter().sum::<f64>();
            assert!(ends.iter().all(|end| (end - best).abs() <= 0.25), "{ends:?}, at best {best}");
            parts.sort_by_key(|part| part.start);
            assert_eq!((parts[0].start, parts[parts.len() - 1].end), (0, 4096));
            assert!(parts.windows(2).all(|pair| pair[0].end == pair[1].start));
            assert!(parts.len() < 100, "{} parts", parts.len());
        }
    }

    #[test]
    fn what_takes_long_to_hand_over_is_dealt_in_few_parts() {
        // Films of 3840 × 2160: a third of a second to read and to add.
        for (rates, units) in [(&[34.0, 34.0][..], 160), (&[34.0, 34.0], 1600), (&[143.0, 143.0], 4096)] {
            let overhead = 10.0 / rates[0];
            let (ends, parts) = ends(rates, units, overhead);
            let best = f64::from(units) / rates.iter().sum::<f64>() + overhead;
            let last = ends.iter().fold(0.0_f64, |last, &end| last.max(end));
            assert!(last < 1.06 * best + 2.0 * overhead, "{last}, at best {best}, in {parts:?}");
        }
    }

    #[test]
    fn what_is_given_back_comes_first() {
        let mut deal = Deal::new(0..10, 1.0, 2);
        let part = deal.take(Pace::default(), 0.0, 0.0).unwrap();
        assert_eq!(part, 0..2);
        deal.give_back(part);
        assert_eq!(deal.take(Pace::default(), 0.0, 0.0), Some(0..2));
        assert_eq!(deal.take(Pace::default(), 0.0, 0.0), Some(2..4));
    }
}
