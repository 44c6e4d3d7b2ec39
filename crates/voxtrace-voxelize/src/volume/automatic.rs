//! Statistics of a volume's values, and the transfer function chosen by them. The threshold between background and object is
//! Otsu's ("A threshold selection method from gray-level histograms", 1979).

use super::{Preset, Transfer, Volume};
use rayon::prelude::*;
use std::ops::RangeInclusive;

/// Bins of the histogram.
const BINS: usize = 1024;
/// A volume with more distinct values is never a label map.
const MOST_LABELS: usize = 256;
/// Up to so many distinct values are taken for labels where the file does not say what they are.
const FEW_LABELS: usize = 48;
/// The range of labels.
const LABELS: RangeInclusive<f32> = -32_768.0..=65_535.0;
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
        let span = volume.values.par_chunks(CHUNK).map(Span::of).reduce(Span::default, Span::and);
        let (lowest, highest) = if span.low > span.high { (0.0, 0.0) } else { (span.low, span.high) };
        let counts = Counts::of(&volume.values, lowest, highest, span.is_whole);
        // A few extreme values must not compress all others into one bin.
        let bright = quantile(&counts.binned(lowest, highest), 0.999, lowest, highest);
        let bright = if bright > lowest { bright } else { highest };
        let threshold = otsu(&counts.binned(lowest, bright), lowest, bright);
        let labels = counts.labels();
        Self { lowest, highest, bright, threshold, labels, is_labels: volume.is_labels, suited: volume.suited }
    }
}

/// Range of the finite values.
#[derive(Clone, Copy)]
struct Span {
    low: f32,
    high: f32,
    /// Whether all values are whole numbers in the range of labels.
    is_whole: bool,
}

impl Default for Span {
    fn default() -> Self {
        Self { low: f32::MAX, high: f32::MIN, is_whole: true }
    }
}

impl Span {
    fn of(values: &[f32]) -> Self {
        let mut span = Self::default();
        for &value in values {
            // Infinite ones and what is no number change nothing.
            let is_finite = value.abs() < f32::INFINITY;
            span.low = if is_finite & (value < span.low) { value } else { span.low };
            span.high = if is_finite & (value > span.high) { value } else { span.high };
            span.is_whole &= (value as i32 as f32 == value) & LABELS.contains(&value);
        }
        span
    }

    fn and(self, other: Self) -> Self {
        let is_whole = self.is_whole && other.is_whole;
        Self { low: self.low.min(other.low), high: self.high.max(other.high), is_whole }
    }
}

/// Histogram of the values.
enum Counts<'a> {
    /// Of each whole number from the first one on.
    Whole(i32, Vec<u64>),
    /// To be counted.
    Real(&'a [f32]),
}

impl<'a> Counts<'a> {
    fn of(values: &'a [f32], low: f32, high: f32, is_whole: bool) -> Self {
        if !is_whole {
            return Self::Real(values);
        }
        let (low, high) = (low as i32, high as i32);
        let room = (high - low) as usize + 1;
        let count = |values: &[f32]| {
            let mut counts = vec![0u64; room];
            values.iter().for_each(|&value| counts[(value as i32 - low) as usize] += 1);
            counts
        };
        let counts = values.par_chunks(CHUNK.max(16 * room)).map(count).reduce(|| vec![0; room], sum);
        Self::Whole(low, counts)
    }

    /// Counts of values in bins from `low` to `high`; what is higher is in the last one.
    fn binned(&self, low: f32, high: f32) -> Vec<u64> {
        let factor = BINS as f64 / (f64::from(high) - f64::from(low)).max(f64::MIN_POSITIVE);
        let bin = |value: f64| (((value - f64::from(low)) * factor) as usize).min(BINS - 1);
        match self {
            Self::Whole(first, counts) => {
                let mut bins = vec![0; BINS];
                (*first..).zip(counts).for_each(|(value, count)| bins[bin(value.into())] += count);
                bins
            }
            Self::Real(values) => {
                let count = |values: &[f32]| {
                    let mut bins = vec![0; BINS];
                    values.iter().filter(|value| value.is_finite()).for_each(|&value| bins[bin(value.into())] += 1);
                    bins
                };
                values.par_chunks(CHUNK).map(count).reduce(|| vec![0; BINS], sum)
            }
        }
    }

    /// The distinct values, if all are whole and few.
    fn labels(&self) -> Option<Vec<i32>> {
        let Self::Whole(first, counts) = self else { return None };
        let found = (*first..).zip(counts).filter(|&(_, &count)| count > 0).map(|(value, _)| value);
        let labels: Vec<i32> = found.take(MOST_LABELS + 1).collect();
        (labels.len() <= MOST_LABELS).then_some(labels)
    }
}

fn sum(mut a: Vec<u64>, b: Vec<u64>) -> Vec<u64> {
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

impl Transfer {
    /// Chooses a transfer function: for level sets and fog the file's own kind; for few whole numbers a colour for each label; for
    /// a CT, known by its file or by values from air to bone, the bones; else a warm grey from Otsu's threshold on.
    pub fn automatic(values: &ValueStatistics) -> Self {
        let is_named = values.labels.as_ref().is_some_and(|labels| {
            values.is_labels || labels.len() <= FEW_LABELS && labels.first().is_some_and(|&first| first >= 0)
        });
        let preset = if let Some(preset @ (Preset::Surface | Preset::Fog)) = values.suited {
            preset
        } else if is_named {
            Preset::Labels
        } else if let Some(preset) = values.suited.filter(|&preset| preset != Preset::CtBone || values.highest > 300.0)
        {
            preset
        } else if (-5000.0..=-800.0).contains(&values.lowest) && (300.0..=33_000.0).contains(&values.highest) {
            Preset::CtBone
        } else {
            Preset::Mri
        };
        preset.transfer()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn values(samples: Vec<f32>) -> ValueStatistics {
        ValueStatistics::of(&Volume::new([samples.len(), 1, 1], samples))
    }

    #[test]
    fn the_choice_follows_the_values() {
        let name = |samples: Vec<f32>| Transfer::automatic(&values(samples)).name;
        assert_eq!(name((0..5000).map(|i| i as f32 - 1024.0).collect()), "ct-bone");
        assert_eq!(name((0..5000).map(|i| i as f32 - 600.0).collect()), "mri");
        assert_eq!(name((0..5000).map(|i| (i % 7) as f32).collect()), "labels");
        assert_eq!(name((0..5000).map(|i| (i % 200) as f32).collect()), "mri");
        assert_eq!(name((0..5000).map(|i| (i % 7) as f32 + 0.5).collect()), "mri");
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
}
