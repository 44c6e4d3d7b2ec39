//! Confidence intervals of frame times. Neighbouring frames are alike, so frames cannot be drawn one by one: the circular
//! block bootstrap (D. Politis, J. Romano, 1992) draws blocks of them, as long as the correlation reaches (D. Politis,
//! H. White, "Automatic block-length selection for the dependent bootstrap", 2004, corrected 2009).

/// Resamples; with a fixed seed, so that the same frames give the same interval.
pub(super) const RESAMPLES: usize = 1000;
/// Fewer frames than this say nothing about their spread.
const FEWEST: usize = 12;
/// Part of the resamples that lies outside, on both sides together.
const OUTSIDE: f64 = 0.05;

/// The 95 % confidence intervals of a series, least and most.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Intervals {
    pub mean: [f64; 2],
    pub median: [f64; 2],
    /// Frames of a block.
    pub block: usize,
}

impl Intervals {
    /// Of a series in the order of time; `None` of fewer than 12 values.
    pub fn of(values: &[f64]) -> Option<Self> {
        let count = values.len();
        if count < FEWEST {
            return None;
        }
        let block = block_length(values);
        let mut random = SplitMix(0x9e37_79b9_7f4a_7c15);
        let mut sample = Vec::with_capacity(count + block);
        let (mut means, mut medians) = (Vec::with_capacity(RESAMPLES), Vec::with_capacity(RESAMPLES));
        for _ in 0..RESAMPLES {
            sample.clear();
            while sample.len() < count {
                let start = random.below(count);
                let first = &values[start..count.min(start + block)];
                sample.extend_from_slice(first);
                sample.extend_from_slice(&values[..block - first.len()]);
            }
            sample.truncate(count);
            means.push(sample.iter().sum::<f64>() / count as f64);
            medians.push(median_of(&mut sample));
        }
        Some(Self { mean: ends(&mut means), median: ends(&mut medians), block })
    }
}

/// The values between which 95 % of the resamples lie.
pub(super) fn ends(values: &mut [f64]) -> [f64; 2] {
    values.sort_by(f64::total_cmp);
    let last = (values.len() - 1) as f64;
    let at = |part: f64| values[(part * last).round() as usize];
    [at(OUTSIDE / 2.0), at(1.0 - OUTSIDE / 2.0)]
}

fn median_of(values: &mut [f64]) -> f64 {
    let count = values.len();
    let (below, &mut upper, _) = values.select_nth_unstable_by(count / 2, f64::total_cmp);
    let is_even = count.is_multiple_of(2);
    if is_even { (below.iter().copied().fold(f64::NEG_INFINITY, f64::max) + upper) / 2.0 } else { upper }
}

/// Block length by Politis and White for the circular bootstrap, in frames.
fn block_length(values: &[f64]) -> usize {
    let count = values.len();
    let size = count as f64;
    let mean = values.iter().sum::<f64>() / size;
    let most = (3.0 * size.sqrt()).min(size / 3.0).ceil() as usize;
    let covariance =
        |lag: usize| values[lag..].iter().zip(values).map(|(a, b)| (a - mean) * (b - mean)).sum::<f64>() / size;
    let variance = covariance(0);
    if variance.is_nan() || variance <= 0.0 {
        return 1;
    }
    // The smallest lag after which a run of correlations is no larger than chance.
    let run = (size.log10().sqrt().ceil() as usize).max(5);
    let furthest = (size.sqrt().ceil() as usize + run).min(count - 1);
    let covariances: Vec<f64> = (0..=furthest).map(covariance).collect();
    let chance = 2.0 * (size.log10() / size).sqrt();
    let is_small = |lag: usize| covariances.get(lag).is_none_or(|value| (value / variance).abs() < chance);
    let reach = (0..=furthest).find(|&lag| (lag + 1..=lag + run).all(is_small)).unwrap_or(furthest);
    let bandwidth = (2 * reach.max(1)).min(furthest);
    let window = |lag: usize| {
        let part = lag as f64 / bandwidth as f64;
        if part <= 0.5 { 1.0 } else { 2.0 * (1.0 - part) }
    };
    let (mut slope, mut spectrum) = (0.0, variance);
    for (lag, covariance) in covariances.iter().enumerate().take(bandwidth + 1).skip(1) {
        slope += 2.0 * window(lag) * lag as f64 * covariance;
        spectrum += 2.0 * window(lag) * covariance;
    }
    let length = (1.5 * (slope / spectrum).powi(2)).cbrt() * size.cbrt();
    if length.is_finite() { (length.round() as usize).clamp(1, most) } else { most }
}

/// SplitMix64 (G. Steele, D. Lea, C. Flood, 2014).
pub(super) struct SplitMix(pub u64);

impl SplitMix {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ z >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ z >> 31
    }

    /// A number below `count`.
    pub fn below(&mut self, count: usize) -> usize {
        ((u128::from(self.next()) * count as u128) >> 64) as usize
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers around 10 with a standard deviation of 1, each `memory` times the last one's deviation.
    fn series(count: usize, memory: f64, seed: u64) -> Vec<f64> {
        let mut random = SplitMix(seed);
        let mut uniform = || random.next() as f64 / u64::MAX as f64;
        let mut deviation = 0.0;
        (0..count)
            .map(|_| {
                let noise = (0..12).map(|_| uniform()).sum::<f64>() - 6.0;
                deviation = memory * deviation + (1.0 - memory * memory).sqrt() * noise;
                10.0 + deviation
            })
            .collect()
    }

    #[test]
    fn the_interval_of_independent_frames_is_as_wide_as_theory_says() {
        let intervals = Intervals::of(&series(2000, 0.0, 5)).unwrap();
        let expected = 2.0 * 1.96 / 2000_f64.sqrt();
        let width = intervals.mean[1] - intervals.mean[0];
        assert!((width / expected - 1.0).abs() < 0.2, "{width}, not {expected}");
        // The median of a normal distribution spreads √(π/2) times as far.
        let width = intervals.median[1] - intervals.median[0];
        assert!((width / (expected * 1.2533) - 1.0).abs() < 0.3, "{width}");
    }

    #[test]
    fn frames_that_resemble_their_neighbours_widen_the_interval() {
        let memory = 0.9_f64;
        let intervals = Intervals::of(&series(4096, memory, 7)).unwrap();
        // The variance of the mean grows by (1 + m) / (1 − m).
        let expected = 2.0 * 1.96 / 64.0 * ((1.0 + memory) / (1.0 - memory)).sqrt();
        let width = intervals.mean[1] - intervals.mean[0];
        assert!(width > 0.65 * expected && width < 1.35 * expected, "{width}, not {expected}");
        assert!(intervals.block > 10, "{}", intervals.block);
    }

    #[test]
    fn nineteen_of_twenty_intervals_hold_the_truth() {
        let holds =
            |seed| Intervals::of(&series(400, 0.5, seed)).is_some_and(|i| i.mean[0] <= 10.0 && 10.0 <= i.mean[1]);
        let held = (0..200).filter(|&seed| holds(1000 + seed)).count();
        assert!((178..=200).contains(&held), "{held} of 200");
    }

    #[test]
    fn the_same_frames_give_the_same_interval_and_few_frames_none() {
        let values = series(300, 0.3, 1);
        assert_eq!(Intervals::of(&values), Intervals::of(&values));
        assert_eq!(Intervals::of(&values[..11]), None);
        let constant = Intervals::of(&[4.0; 50]).unwrap();
        assert_eq!((constant.mean, constant.median, constant.block), ([4.0, 4.0], [4.0, 4.0], 1));
    }

    #[test]
    fn the_median_of_an_even_number_of_values_lies_between_two() {
        assert_eq!(median_of(&mut [4.0, 1.0, 3.0, 2.0]), 2.5);
        assert_eq!(median_of(&mut [4.0, 1.0, 3.0]), 3.0);
    }
}
