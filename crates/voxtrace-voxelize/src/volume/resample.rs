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

/// Parts of a sample in which voxels begin where they do not divide all samples evenly: their step comes from spacings, which files round, and voxels are to be
/// the same for all that.
const FINEST: f64 = 16_384.0;

/// Where the voxels of an axis lie among its samples, which are each one long.
#[derive(Clone, Copy)]
pub(super) struct Spacing {
    /// How many there are.
    pub count: usize,
    /// Length of a voxel.
    pub step: f64,
    /// How far behind the beginning of the first sample the first voxel begins, and before the end of the last one the last voxel ends; below 0 where voxels
    /// reach beyond the samples.
    pub margin: f64,
}

impl Spacing {
    /// So many voxels from the first sample to the last.
    pub fn over(samples: usize, count: usize) -> Self {
        Self { count, step: samples as f64 / count as f64, margin: 0.0 }
    }

    /// So many voxels of a length in the middle of the samples.
    pub fn within(samples: usize, count: usize, step: f64) -> Self {
        Self { count, step, margin: (samples as f64 - count as f64 * step) * 0.5 }
    }

    /// Where a voxel begins, in samples.
    fn begin(&self, at: usize) -> f64 {
        let begin = self.margin + at as f64 * self.step;
        if self.margin == 0.0 { begin } else { (begin * FINEST).round() / FINEST }
    }
}

impl Axis {
    /// The axis along lattice axis `lattice`, with `count` voxels over all its samples.
    #[cfg(test)]
    pub fn new(lattice: usize, size: [usize; 3], backwards: bool, count: usize, nearest: bool) -> Self {
        Self::spaced(lattice, size, backwards, Spacing::over(size[lattice], count), nearest)
    }

    /// The axis along lattice axis `lattice`, with voxels in these places.
    pub fn spaced(lattice: usize, size: [usize; 3], backwards: bool, spacing: Spacing, nearest: bool) -> Self {
        let stride = size[..lattice].iter().product();
        let samples = size[lattice];
        let Spacing { count, step, margin } = spacing;
        let tap = |at: usize| {
            let at = if backwards { count - 1 - at } else { at };
            let (low, high) = (spacing.begin(at), spacing.begin(at + 1));
            let (first, weights) = if samples == count {
                (at, vec![1.0])
            } else if nearest {
                (((low + high) * 0.5) as usize, vec![1.0])
            } else if step > 1.0 {
                // What is left beside the outermost voxels is theirs.
                let low = if margin != 0.0 && at == 0 { 0.0 } else { low };
                let high = if margin != 0.0 && at + 1 == count { samples as f64 } else { high };
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
    fn voxels_that_fit_no_whole_number_of_times_stay_as_long_as_they_are() {
        let samples: Vec<f32> = (0..12).map(|i| i as f32 + 0.5).collect();
        // Up to a quarter of a voxel is left on each side, or reaches beyond.
        for (count, step) in [(30, 0.41), (30, 0.395), (13, 0.9), (5, 2.5), (5, 2.3), (4, 2.75), (1, 20.0)] {
            let spacing = Spacing::within(12, count, step);
            let axis = Axis::spaced(0, [12, 1, 1], false, spacing, false);
            let found = mixed(&axis, &samples);
            for (at, value) in found.iter().enumerate() {
                let wanted = ((12.0 - count as f64 * step) * 0.5 + (at as f64 + 0.5) * step).clamp(0.5, 11.5) as f32;
                // Samples are steps to the box filter, whose outermost voxels have what is left.
                let tolerance = if step > 1.0 { 0.35 } else { 1e-4 };
                assert!((value - wanted).abs() < tolerance, "{count} {step} {at}: {value} {wanted}");
            }
            let ends = axis.samples(0).next().zip(axis.samples(count - 1).last());
            let ends = ends.map(|((first, _), (last, _))| (first, last));
            assert!(step < 1.0 || ends == Some((0, 11)), "{count} {step}: {ends:?}");
            let mut backwards = mixed(&Axis::spaced(0, [12, 1, 1], true, spacing, false), &samples);
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
