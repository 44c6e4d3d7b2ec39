//! The ratio of two programs that were measured in turns, a pair of medians in each round, and where it lies. Rounds are drawn with
//! replacement (the bootstrap, B. Efron, 1979), since what changes from round to round meets both of a pair. A few rounds draw intervals
//! that are too narrow, which is made up for as in T. Hesterberg, "What teachers should know about the bootstrap", 2015.

use super::interval::{RESAMPLES, SplitMix, ends};

/// Fewer rounds than this say nothing about their spread.
pub const FEWEST_ROUNDS: usize = 3;
/// The value that a normal distribution stays below with a probability of 97.5 %.
const NORMAL: f64 = 1.959_964;

/// The geometric mean of ratios, and the interval in which it lies with a certainty of 95 %; `None` of fewer than three.
pub fn ratio_of_rounds(ratios: &[f64]) -> Option<(f64, Option<[f64; 2]>)> {
    let count = ratios.len();
    if ratios.iter().any(|ratio| !(ratio.is_finite() && *ratio > 0.0)) || count == 0 {
        return None;
    }
    let logarithms: Vec<f64> = ratios.iter().map(|ratio| ratio.ln()).collect();
    let mean = logarithms.iter().sum::<f64>() / count as f64;
    if count < FEWEST_ROUNDS {
        return Some((mean.exp(), None));
    }
    let mut random = SplitMix(0x9e37_79b9_7f4a_7c15);
    let mut draw = || (0..count).map(|_| logarithms[random.below(count)]).sum::<f64>() / count as f64;
    let mut means: Vec<f64> = (0..RESAMPLES).map(|_| draw()).collect();
    let widened = widening(count);
    let interval = ends(&mut means).map(|end| (mean + (end - mean) * widened).exp());
    Some((mean.exp(), Some(interval)))
}

/// How much wider an interval of so many values is than that which the bootstrap draws: as the quantile of Student's distribution is beside
/// that of the normal one, and as their standard deviation is beside that of all there could be.
fn widening(count: usize) -> f64 {
    let (size, freedom) = (count as f64, (count - 1) as f64);
    let z = NORMAL;
    // Cornish and Fisher's series (1960) of Student's quantile.
    let terms = [
        (z.powi(3) + z) / (4.0 * freedom),
        (5.0 * z.powi(5) + 16.0 * z.powi(3) + 3.0 * z) / (96.0 * freedom.powi(2)),
        (3.0 * z.powi(7) + 19.0 * z.powi(5) + 17.0 * z.powi(3) - 15.0 * z) / (384.0 * freedom.powi(3)),
    ];
    (z + terms.iter().sum::<f64>()) / z * (size / freedom).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Ratios around `truth` whose logarithms have a standard deviation of 0.1.
    fn ratios(count: usize, truth: f64, seed: u64) -> Vec<f64> {
        let mut random = SplitMix(seed);
        let mut uniform = || random.below(1 << 30) as f64 / f64::from(1 << 30);
        (0..count).map(|_| truth * (0.1 * ((0..12).map(|_| uniform()).sum::<f64>() - 6.0)).exp()).collect()
    }

    #[test]
    fn nineteen_of_twenty_intervals_hold_the_truth_also_of_few_rounds() {
        for count in [4, 5, 8, 20] {
            let holds = |seed| {
                let (_, interval) = ratio_of_rounds(&ratios(count, 1.3, seed)).unwrap();
                interval.is_some_and(|[low, high]| low <= 1.3 && 1.3 <= high)
            };
            let held = (0..400).filter(|&seed| holds(77 + seed)).count();
            assert!((364..=396).contains(&held), "{held} of 400 with {count} rounds");
        }
    }

    #[test]
    fn student_s_quantiles_are_those_of_tables() {
        for (count, wanted) in [(4, 3.182), (5, 2.776), (9, 2.306), (31, 2.042)] {
            let size = count as f64;
            let found = widening(count) * NORMAL / (size / (size - 1.0)).sqrt();
            assert!((found / wanted - 1.0).abs() < 0.01, "{count}: {found}, not {wanted}");
        }
    }

    #[test]
    fn equal_rounds_leave_no_doubt_and_few_ones_nothing_but_doubt() {
        let (ratio, interval) = ratio_of_rounds(&[2.0, 0.5, 1.0]).unwrap();
        assert!((ratio - 1.0).abs() < 1e-12 && interval.is_some_and(|[low, high]| low < 0.5 && high > 2.0));
        let (ratio, interval) = ratio_of_rounds(&[1.5; 4]).unwrap();
        assert!(
            (ratio - 1.5).abs() < 1e-12
                && interval.is_some_and(|ends| ends.iter().all(|end| (end - 1.5).abs() < 1e-12))
        );
        assert_eq!(ratio_of_rounds(&[1.5, 1.5]).unwrap().1, None);
        assert_eq!((ratio_of_rounds(&[]), ratio_of_rounds(&[1.0, 0.0, 1.0])), (None, None));
    }
}
