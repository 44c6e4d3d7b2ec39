//! Resampling filters from lattice to voxel grid, separable by axis: linear where voxels are finer than samples, a box filter
//! where they are coarser, nearest for labels.

/// The filter taps of one grid coordinate: consecutive samples along the axis, and their weights.
pub(super) struct Taps {
    /// Offset in the volume's values of the first sample.
    pub start: usize,
    /// Weights of the samples, which sum to 1.
    pub weights: Vec<f32>,
}

/// The filters along one axis of the grid.
pub(super) struct Axis {
    /// The axis of the lattice that it runs along.
    pub lattice: usize,
    /// Distance between samples in the volume's values.
    pub stride: usize,
    /// The taps of each grid coordinate.
    pub taps: Vec<Taps>,
}

impl Axis {
    /// The axis along lattice axis `lattice`, with `count` voxels over all its samples.
    pub fn new(lattice: usize, size: [usize; 3], backwards: bool, count: usize, nearest: bool) -> Self {
        let stride = size[..lattice].iter().product();
        let samples = size[lattice];
        // Samples per voxel.
        let step = samples as f64 / count as f64;
        let tap = |at: usize| {
            let at = if backwards { count - 1 - at } else { at };
            let (low, high) = (at as f64 * step, (at + 1) as f64 * step);
            let (first, weights) = if samples == count {
                (at, vec![1.0])
            } else if nearest {
                (((low + high) * 0.5) as usize, vec![1.0])
            } else if step > 1.0 {
                averaged(low, high, samples)
            } else {
                between((low + high) * 0.5 - 0.5, samples)
            };
            Taps { start: first.min(samples - 1) * stride, weights }
        };
        Self { lattice, stride, taps: (0..count).map(tap).collect() }
    }

    /// The samples of a voxel, by their number along the axis, with their weights.
    pub fn samples(&self, at: usize) -> impl Iterator<Item = (usize, f32)> {
        let taps = &self.taps[at];
        (taps.start / self.stride..).zip(taps.weights.iter().copied())
    }

    /// Voxels along the axis.
    pub fn count(&self) -> usize {
        self.taps.len()
    }
}

/// Box filter: the share that each sample has of the interval low..high.
fn averaged(low: f64, high: f64, samples: usize) -> (usize, Vec<f32>) {
    let first = (low as usize).min(samples - 1);
    let last = (high.ceil() as usize).clamp(first + 1, samples);
    let share = |sample: usize| (high.min((sample + 1) as f64) - low.max(sample as f64)).max(0.0);
    let sum: f64 = (first..last).map(share).sum();
    (first, (first..last).map(|sample| (share(sample) / sum) as f32).collect())
}

/// Linear filter: the two samples around a place, clamped to the outermost one.
fn between(place: f64, samples: usize) -> (usize, Vec<f32>) {
    let place = place.clamp(0.0, (samples - 1) as f64);
    let first = place as usize;
    let share = (place - first as f64) as f32;
    if first + 1 < samples && share > 0.0 { (first, vec![1.0 - share, share]) } else { (first, vec![1.0]) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mixed(axis: &Axis, samples: &[f32]) -> Vec<f32> {
        let mix = |taps: &Taps| taps.weights.iter().enumerate().map(|(i, w)| w * samples[taps.start + i]).sum();
        axis.taps.iter().map(mix).collect()
    }

    #[test]
    fn a_slope_stays_a_slope_whatever_the_step() {
        let samples: Vec<f32> = (0..12).map(|i| i as f32 + 0.5).collect();
        for count in [1, 4, 5, 12, 30] {
            let step = 12.0 / count as f32;
            let found = mixed(&Axis::new(0, [12, 1, 1], false, count, false), &samples);
            for (at, value) in found.iter().enumerate() {
                let wanted = ((at as f32 + 0.5) * step).clamp(0.5, 11.5);
                // Samples are steps to the box filter: a share of one is as bright as the whole.
                let tolerance = if count == 5 { 0.06 } else { 1e-4 };
                assert!((value - wanted).abs() < tolerance, "{count} {at}: {value} {wanted}");
            }
            let mut backwards = mixed(&Axis::new(0, [12, 1, 1], true, count, false), &samples);
            backwards.reverse();
            assert_eq!(backwards, found);
        }
    }

    #[test]
    fn labels_are_never_mixed() {
        let samples = [1.0, 9.0, 4.0];
        for count in [1, 2, 3, 7] {
            let found = mixed(&Axis::new(0, [3, 1, 1], false, count, true), &samples);
            assert!(found.iter().all(|value| samples.contains(value)), "{count}: {found:?}");
        }
    }
}
