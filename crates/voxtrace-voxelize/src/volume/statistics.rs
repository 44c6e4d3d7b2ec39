//! Statistics of a volume's values. The threshold between background and object is Otsu's ("A threshold selection method from
//! gray-level histograms", 1979). Values are looked at once for their range and, where all are whole, for how often each occurs;
//! others once more for each histogram.

use super::{Preset, Volume};
use crate::fields::{FieldReader, FieldWriter};
use rayon::prelude::*;
use std::convert::Infallible;
use std::ops::RangeInclusive;

/// Bins of the histogram.
const BINS: usize = 1024;
/// A volume with more distinct values is never a label map.
const MOST_LABELS: usize = 256;
/// The range of labels.
const LABELS: RangeInclusive<f32> = -32_768.0..=65_535.0;
/// The least label, and how many whole numbers the range has.
const FIRST_LABEL: i32 = -32_768;
const LABEL_COUNT: usize = 98_304;
/// Values that are compared with the first of them at once.
const RUN: usize = 64;
/// Values processed by one task.
const CHUNK: usize = 1 << 18;

/// Statistics of the finite values of a volume.
#[derive(Clone, Debug, PartialEq)]
pub struct ValueStatistics {
    /// The least value, 0 where there is none.
    pub lowest: f32,
    /// The greatest value, 0 where there is none.
    pub highest: f32,
    /// The 99.9th percentile.
    pub bright: f32,
    /// Otsu's threshold between background and object.
    pub threshold: f32,
    /// The distinct values, ascending, where there are at most 256, all whole numbers from −32,768 to 65,535.
    pub labels: Option<Vec<i32>>,
    /// Whether the file says that its values are labels.
    pub is_labels: bool,
    /// The transfer function for the kind of data that the file says it holds.
    pub suited: Option<Preset>,
}

impl ValueStatistics {
    pub(super) fn of(volume: &Volume) -> Self {
        Self::of_while(volume, &|| true)
    }

    /// As [`Self::of`]; anything where nobody wants it any more.
    pub(super) fn of_while(volume: &Volume, wanted: &(dyn Fn() -> bool + Sync)) -> Self {
        let mut look = Look::default();
        look.add(&volume.values, wanted);
        let mut values = Self::at_first(&look, volume);
        let mut binned = |low, high| Ok::<_, Infallible>(binned_while(&volume.values, low, high, wanted));
        let Ok(()) = values.measure_scale(&look, &mut binned);
        values
    }

    /// What a look at all values of a volume says; its scale, [`Self::bright`] and [`Self::threshold`], is not measured yet.
    pub(super) fn at_first(look: &Look, frame: &Volume) -> Self {
        let (lowest, highest) = look.range();
        let (is_labels, suited) = (frame.is_labels, frame.suited);
        Self { lowest, highest, bright: highest, threshold: lowest, labels: look.labels(), is_labels, suited }
    }

    /// Measures the scale. `binned` counts all values in bins from its first to its second argument; it is asked where not all are whole.
    pub(super) fn measure_scale<E>(
        &mut self,
        look: &Look,
        binned: &mut dyn FnMut(f32, f32) -> Result<Vec<u64>, E>,
    ) -> Result<(), E> {
        let (lowest, highest) = (self.lowest, self.highest);
        let mut counted = |low, high| look.binned(low, high).map_or_else(|| binned(low, high), Ok);
        // A few extreme values must not compress all others into one bin.
        let bright = quantile(&counted(lowest, highest)?, 0.999, lowest, highest);
        self.bright = if bright > lowest { bright } else { highest };
        self.threshold = otsu(&counted(lowest, self.bright)?, lowest, self.bright);
        Ok(())
    }
}

/// What a look at values finds: the range of the finite ones, and how often each occurs where all are whole numbers in the range of
/// labels.
#[derive(Clone, Debug)]
pub(super) struct Look {
    low: f32,
    high: f32,
    /// Of each label from the first one on; empty where nothing was counted.
    counts: Vec<u64>,
    is_whole: bool,
    /// All finite values, where they were codes and not all are whole.
    values: Option<Vec<(f32, u64)>>,
}

impl Default for Look {
    fn default() -> Self {
        Self { low: f32::MAX, high: f32::MIN, counts: Vec::new(), is_whole: true, values: None }
    }
}

impl Look {
    /// Looks at further values, on all threads, as long as that is wanted.
    pub fn add(&mut self, values: &[f32], wanted: &(dyn Fn() -> bool + Sync)) {
        let looks = values.par_chunks(CHUNK).fold(Self::default, |mut look, values| {
            if wanted() {
                look.add_chunk(values);
            }
            look
        });
        let found = looks.reduce(Self::default, Self::and);
        *self = std::mem::take(self).and(found);
    }

    /// What codes say, of which each occurs so often and stands for a value.
    pub fn of_codes(table: &[f32], counts: &[u64]) -> Self {
        let found = table.iter().zip(counts).filter(|&(_, &count)| count > 0).map(|(&value, &count)| (value, count));
        let mut look = Self::default();
        let distinct: Vec<f32> = found.clone().map(|(value, _)| value).collect();
        look.add_chunk(&distinct);
        if look.is_whole {
            look.counts.fill(0);
            found.for_each(|(value, count)| look.counts[(value as i32 - FIRST_LABEL) as usize] += count);
        } else {
            look.values = Some(found.filter(|(value, _)| value.is_finite()).collect());
        }
        look
    }

    /// Looks at further values.
    pub fn add_chunk(&mut self, values: &[f32]) {
        let (mut low, mut high, mut is_whole) = (self.low, self.high, self.is_whole);
        for &value in values {
            // Infinite ones and what is no number change nothing.
            let is_finite = value.abs() < f32::INFINITY;
            low = if is_finite & (value < low) { value } else { low };
            high = if is_finite & (value > high) { value } else { high };
            is_whole &= (value as i32 as f32 == value) & LABELS.contains(&value);
        }
        (self.low, self.high, self.is_whole) = (low, high, is_whole);
        if !is_whole {
            self.counts = Vec::new();
            return;
        }
        self.counts.resize(LABEL_COUNT, 0);
        let place = |value: f32| (value as i32 - FIRST_LABEL) as usize;
        let (runs, rest) = values.as_chunks::<RUN>();
        for run in runs {
            if run.iter().fold(true, |is_one, value| is_one & (*value == run[0])) {
                self.counts[place(run[0])] += RUN as u64;
            } else {
                run.iter().for_each(|&value| self.counts[place(value)] += 1);
            }
        }
        rest.iter().for_each(|&value| self.counts[place(value)] += 1);
    }

    /// Adds the look to what is written.
    pub fn write(&self, out: &mut FieldWriter) {
        out.value([self.low, self.high]);
        out.value([u8::from(self.is_whole), u8::from(!self.counts.is_empty()), u8::from(self.values.is_some())]);
        let counted = self.counts.iter().enumerate().filter(|(_, count)| **count > 0);
        out.values(&counted.map(|(label, &count)| [label as u64, count]).collect::<Vec<_>>());
        let values = self.values.iter().flatten().map(|&(value, count)| [u64::from(value.to_bits()), count]);
        out.values(&values.collect::<Vec<_>>());
    }

    /// The look that was written.
    pub fn read(from: &mut FieldReader) -> Option<Self> {
        let [low, high] = from.value()?;
        let [is_whole, has_counts, has_values] = from.value::<[u8; 3]>()?;
        let mut counts = vec![0; if has_counts > 0 { LABEL_COUNT } else { 0 }];
        for [label, count] in from.values::<[u64; 2]>()? {
            *counts.get_mut(usize::try_from(label).ok()?)? = count;
        }
        let values = from.values::<[u64; 2]>()?.into_iter();
        let values = values.map(|[value, count]| Some((f32::from_bits(u32::try_from(value).ok()?), count)));
        let values: Option<Vec<_>> = values.collect();
        Some(Self { low, high, counts, is_whole: is_whole > 0, values: if has_values > 0 { values } else { None } })
    }

    /// What two looks say together.
    pub fn and(self, other: Self) -> Self {
        let (low, high) = (self.low.min(other.low), self.high.max(other.high));
        let is_whole = self.is_whole && other.is_whole;
        let counts = match (is_whole, self.counts.is_empty(), other.counts.is_empty()) {
            (false, ..) => Vec::new(),
            (_, true, _) => other.counts,
            (_, _, true) => self.counts,
            _ => sum(self.counts, other.counts),
        };
        Self { low, high, counts, is_whole, values: None }
    }

    /// The least and the greatest value, 0 where there is none.
    pub fn range(&self) -> (f32, f32) {
        if self.low > self.high { (0.0, 0.0) } else { (self.low, self.high) }
    }

    /// The whole numbers that occur, and how often.
    fn counted(&self) -> impl Iterator<Item = (i32, u64)> + '_ {
        (FIRST_LABEL..).zip(&self.counts).filter(|&(_, &count)| count > 0).map(|(value, &count)| (value, count))
    }

    /// As [`binned`], where all values were counted.
    pub fn binned(&self, low: f32, high: f32) -> Option<Vec<u64>> {
        let bin = bins(low, high);
        let mut counts = vec![0; BINS];
        match &self.values {
            Some(values) => values.iter().for_each(|&(value, count)| counts[bin(value)] += count),
            None => self.counted().for_each(|(value, count)| counts[bin(value as f32)] += count),
        }
        (self.is_whole || self.values.is_some()).then_some(counts)
    }

    /// The share of values that are at least so much, where all were counted.
    pub fn share_from(&self, low: f32) -> Option<f64> {
        let (mut all, mut above) = (0, 0);
        let mut add = |value: f32, count: u64| {
            all += count;
            above += if value >= low { count } else { 0 };
        };
        match &self.values {
            Some(values) => values.iter().for_each(|&(value, count)| add(value, count)),
            None => self.counted().for_each(|(value, count)| add(value as f32, count)),
        }
        ((self.is_whole || self.values.is_some()) && all > 0).then(|| above as f64 / all as f64)
    }

    /// The distinct values, if all are whole and few.
    pub fn labels(&self) -> Option<Vec<i32>> {
        let labels: Vec<i32> = self.counted().map(|(value, _)| value).take(MOST_LABELS + 1).collect();
        (self.is_whole && labels.len() <= MOST_LABELS).then_some(labels)
    }
}

/// The bin of a value, of those from `low` to `high`; what is higher is in the last one.
fn bins(low: f32, high: f32) -> impl Fn(f32) -> usize {
    let factor = BINS as f64 / (f64::from(high) - f64::from(low)).max(f64::MIN_POSITIVE);
    move |value| (((f64::from(value) - f64::from(low)) * factor) as usize).min(BINS - 1)
}

/// Counts of finite values in bins from `low` to `high`.
pub(super) fn binned(values: &[f32], low: f32, high: f32) -> Vec<u64> {
    binned_while(values, low, high, &|| true)
}

/// As [`binned`], as long as that is wanted.
fn binned_while(values: &[f32], low: f32, high: f32, wanted: &(dyn Fn() -> bool + Sync)) -> Vec<u64> {
    let bin = bins(low, high);
    let count = |mut counts: Vec<u64>, values: &[f32]| {
        if wanted() {
            values.iter().filter(|value| value.is_finite()).for_each(|&value| counts[bin(value)] += 1);
        }
        counts
    };
    values.par_chunks(CHUNK).fold(|| vec![0; BINS], count).reduce(|| vec![0; BINS], sum)
}

/// Sums of two histograms.
pub(super) fn sum(mut a: Vec<u64>, b: Vec<u64>) -> Vec<u64> {
    a.iter_mut().zip(b).for_each(|(a, b)| *a += b);
    a
}

/// The lower edge of a bin.
fn edge(bin: usize, low: f32, high: f32) -> f32 {
    (f64::from(low) + (f64::from(high) - f64::from(low)) * bin as f64 / BINS as f64) as f32
}

fn quantile(counts: &[u64], share: f64, low: f32, high: f32) -> f32 {
    let wanted = (counts.iter().sum::<u64>() as f64 * share) as u64;
    let mut sum = 0;
    let bin = counts.iter().position(|count| {
        sum += count;
        sum > wanted
    });
    edge(bin.map_or(BINS, |bin| bin + 1), low, high)
}

/// The edge between two bins with the largest between-class variance.
fn otsu(counts: &[u64], low: f32, high: f32) -> f32 {
    let total = counts.iter().sum::<u64>() as f64;
    let moment: f64 = counts.iter().enumerate().map(|(bin, &count)| bin as f64 * count as f64).sum();
    let (mut weight, mut sum, mut best) = (0.0, 0.0, (0.0, 0, 0));
    for (bin, &count) in counts.iter().enumerate() {
        weight += count as f64;
        sum += bin as f64 * count as f64;
        if weight == 0.0 || weight >= total {
            continue;
        }
        let apart = sum / weight - (moment - sum) / (total - weight);
        let between = weight * (total - weight) * apart * apart;
        if between > best.0 {
            best = (between, bin + 1, bin + 1);
        } else if between == best.0 {
            // Where the maximum is a plateau, empty bins lie between the classes: take its middle.
            best.2 = bin + 1;
        }
    }
    edge(usize::midpoint(best.1, best.2), low, high)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn values(samples: Vec<f32>) -> ValueStatistics {
        ValueStatistics::of(&Volume::new([samples.len(), 1, 1], samples))
    }

    #[test]
    fn the_threshold_parts_two_kinds_and_ignores_what_is_no_number() {
        let mut samples: Vec<f32> = (0..9000).map(|i| (i % 90) as f32 * 0.1).collect();
        samples.extend((0..1000).map(|i| 90.0 + (i % 20) as f32));
        samples.extend([f32::NAN, f32::INFINITY, f32::NEG_INFINITY]);
        let found = values(samples);
        assert!(found.threshold > 9.0 && found.threshold < 90.0, "{}", found.threshold);
        assert_eq!((found.lowest, found.highest), (0.0, 109.0));
        assert!(values(vec![f32::NAN; 4]).threshold.is_finite() && values(vec![5.0; 4]).threshold.is_finite());
    }

    #[test]
    fn looks_at_parts_are_a_look_at_all() {
        let wholes: Vec<f32> = (0..5000).map(|i| (i * i % 701) as f32 - 300.0).collect();
        let mut parts = wholes.clone();
        parts[4321] += 0.25;
        for (samples, is_whole) in [(wholes, true), (parts, false)] {
            let frame = Volume::new([5000, 1, 1], samples.clone());
            let mut look = Look::default();
            samples.chunks(777).for_each(|piece| look.add(piece, &|| true));
            let mut found = ValueStatistics::at_first(&look, &frame);
            let mut passes = 0;
            let mut count = |low, high| {
                passes += 1;
                Ok::<_, Infallible>(samples.chunks(99).map(|piece| binned(piece, low, high)).fold(vec![0; BINS], sum))
            };
            let Ok(()) = found.measure_scale(&look, &mut count);
            assert_eq!((&found, passes), (&ValueStatistics::of(&frame), if is_whole { 0 } else { 2 }));
            assert_eq!(look.share_from(0.0).is_some(), is_whole);
        }
    }
}
