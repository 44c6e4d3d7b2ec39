//! What the values of a volume look like, and the transfer function that suits them. The threshold between nothing and
//! something is Otsu's ("A threshold selection method from gray-level histograms", 1979).

use super::{Preset, Transfer, Volume};
use rayon::prelude::*;
use std::collections::BTreeSet;

/// Bins of the histogram.
const BINS: usize = 1024;
/// More different values than these are no labels.
const MOST_LABELS: usize = 256;
/// So many are taken for labels where the file does not say so.
const FEW_LABELS: usize = 48;
/// Values taken together by one thread.
const CHUNK: usize = 1 << 18;

/// What values a volume has; what is not finite is left out.
#[derive(Clone, Debug, PartialEq)]
pub struct Values {
    /// The least value, 0 where there is none.
    pub lowest: f32,
    /// The greatest value, 0 where there is none.
    pub highest: f32,
    /// The value that one sample of a thousand exceeds.
    pub bright: f32,
    /// The value that best parts the samples into two kinds.
    pub threshold: f32,
    /// The different values, ascending, where they are few whole numbers from −32,768 to 65,535.
    pub labels: Option<Vec<i32>>,
    /// Whether the file says that values are names of things.
    pub is_labels: bool,
    /// The transfer function that suits what the file says to hold.
    pub suited: Option<Preset>,
}

impl Values {
    pub(super) fn of(volume: &Volume) -> Self {
        let finite =
            |values: &[f32]| values.iter().copied().filter(|v| v.is_finite()).fold((f32::MAX, f32::MIN), extended);
        let chunks = || volume.values.par_chunks(CHUNK);
        let (lowest, highest) =
            chunks().map(finite).reduce(|| (f32::MAX, f32::MIN), |a, b| (a.0.min(b.0), a.1.max(b.1)));
        let (lowest, highest) = if lowest > highest { (0.0, 0.0) } else { (lowest, highest) };
        let counts = counted(&volume.values, lowest, highest);
        // A few extreme values must not squeeze all others into one bin.
        let bright = quantile(&counts, 0.999, lowest, highest);
        let bright = if bright > lowest { bright } else { highest };
        let threshold = otsu(&counted(&volume.values, lowest, bright), lowest, bright);
        let labels = labels(&volume.values);
        Self { lowest, highest, bright, threshold, labels, is_labels: volume.is_labels, suited: volume.suited }
    }
}

fn extended((low, high): (f32, f32), value: f32) -> (f32, f32) {
    (low.min(value), high.max(value))
}

fn counted(values: &[f32], low: f32, high: f32) -> Vec<u64> {
    let factor = BINS as f64 / (f64::from(high) - f64::from(low)).max(f64::MIN_POSITIVE);
    let count = |values: &[f32]| {
        let mut counts = vec![0u64; BINS];
        for &value in values.iter().filter(|value| value.is_finite()) {
            counts[(((f64::from(value) - f64::from(low)) * factor) as usize).min(BINS - 1)] += 1;
        }
        counts
    };
    let add = |mut a: Vec<u64>, b: Vec<u64>| {
        a.iter_mut().zip(b).for_each(|(a, b)| *a += b);
        a
    };
    values.par_chunks(CHUNK).map(count).reduce(|| vec![0; BINS], add)
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

/// The edge between two bins that makes the variance between both sides the largest.
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
            // Empty bins between both sides: the middle of the gap.
            best.2 = bin + 1;
        }
    }
    edge(usize::midpoint(best.1, best.2), low, high)
}

/// The different values, if all are whole and few.
fn labels(values: &[f32]) -> Option<Vec<i32>> {
    let mut found = BTreeSet::new();
    let mut last = None;
    for &value in values {
        if last == Some(value) {
            continue;
        }
        last = Some(value);
        if value.fract() != 0.0 || !(-32_768.0..=65_535.0).contains(&value) {
            return None;
        }
        found.insert(value as i32);
        if found.len() > MOST_LABELS {
            return None;
        }
    }
    Some(found.into_iter().collect())
}

impl Transfer {
    /// The transfer function that suits the values: what the file's kind of scan says, if anything would be seen; bone where they reach from air to bone as those of a CT do, colours
    /// by name where they are few whole numbers, else a warm grey from the threshold on.
    pub fn chosen(values: &Values) -> Self {
        let is_named = values.labels.as_ref().is_some_and(|labels| {
            values.is_labels || labels.len() <= FEW_LABELS && labels.first().is_some_and(|&first| first >= 0)
        });
        let preset = if is_named {
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

    fn values(samples: Vec<f32>) -> Values {
        Values::of(&Volume::new([samples.len(), 1, 1], samples))
    }

    #[test]
    fn the_choice_follows_the_values() {
        let name = |samples: Vec<f32>| Transfer::chosen(&values(samples)).name;
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
