//! Stripes: rows of bricks that are made together, as many as the memory budget holds. Each reads the rows of samples under it and
//! those that its border needs.

use super::super::resample::Axis;
use super::super::slab::EDGE;
use super::ahead::ON_THE_WAY;
use std::ops::Range;

/// Bytes of a voxel in the window: the sum of its samples, ten layers of its material and bit, and what bricks are made in.
const BYTES_OF_VOXEL: u64 = 4 + 10 * 2 + 4;
/// Up to so many layers of samples under a layer of voxels are kept until it is made.
pub(super) const FEW: usize = 4;

/// Some rows of the grid, and the samples that they need.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Stripe {
    /// Rows of bricks of the stripe.
    pub bricks: Range<usize>,
    /// Rows of voxels that are looked at: those of the bricks and one at either side.
    pub voxels: Range<usize>,
    /// Rows of samples under them.
    pub samples: Range<usize>,
}

/// How many rows of so many bytes a budget holds, at least one.
pub(super) fn rows_within(budget: u64, bytes_of_row: u64) -> usize {
    usize::try_from(budget / bytes_of_row.max(1)).unwrap_or(usize::MAX).max(1)
}

/// Cuts the rows of a grid, whose axes are in the order of the lattice, into stripes for half of the budget; the other half is the spill
/// buffer's and the file's. A row of samples has so many bytes, of which the source keeps others.
pub(super) fn stripes_of([of_row, kept_of_row]: [u64; 2], axes: &[&Axis; 3], budget: u64) -> Vec<Stripe> {
    let rows = axes[1].count();
    let samples_of_row = (axes[1].samples(0).count() as u64).max(1);
    let under = axes[2].taps.iter().map(|taps| taps.weights.len()).max().unwrap_or(1);
    let layers = if under <= FEW { under as u64 } else { 1 } + ON_THE_WAY;
    let bytes = axes[0].count() as u64 * BYTES_OF_VOXEL + samples_of_row * (of_row * layers + kept_of_row);
    let most = (rows_within(budget / 2, bytes).saturating_sub(2) / EDGE).max(1);
    let count = rows.div_ceil(EDGE);
    let stripe = |first: usize| {
        let bricks = first..(first + most).min(count);
        let voxels = (bricks.start * EDGE).saturating_sub(1)..(bricks.end * EDGE + 1).min(rows);
        let touched = voxels.clone().flat_map(|row| axes[1].samples(row).map(|(sample, _)| sample));
        let (low, high) = touched.fold((usize::MAX, 0), |(low, high), at| (low.min(at), high.max(at + 1)));
        Stripe { bricks, voxels, samples: low..high }
    };
    (0..count).step_by(most).map(stripe).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stripes_cover_all_rows_once_and_the_samples_of_their_borders() {
        for (samples, voxels, backwards) in [(40, 40, false), (40, 40, true), (100, 33, true), (9, 50, false)] {
            let size = [5, samples, 7];
            let axes = [5, voxels, 7];
            let axes = [0, 1, 2].map(|n| Axis::new(n, size, backwards, axes[n], false));
            let axes = [&axes[0], &axes[1], &axes[2]];
            let all = stripes_of([20, 0], &axes, u64::MAX);
            assert_eq!((all.len(), all[0].samples.clone(), all[0].voxels.clone()), (1, 0..samples, 0..voxels));
            let cut = stripes_of([20, 0], &axes, 1);
            assert_eq!(cut.len(), usize::div_ceil(voxels, EDGE));
            for (n, stripe) in cut.iter().enumerate() {
                assert_eq!(stripe.bricks, n..n + 1);
                let needed = stripe.voxels.clone().flat_map(|row| axes[1].samples(row).map(|(at, _)| at));
                let needed: Vec<usize> = needed.collect();
                assert!(needed.iter().all(|at| stripe.samples.contains(at)));
                assert_eq!(needed.iter().max(), Some(&(stripe.samples.end - 1)));
            }
        }
    }
}
