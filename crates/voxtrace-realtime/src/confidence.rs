//! How far what frames before know still holds where light may have changed: some paths of the frame before are followed again, with their own
//! random numbers, and what they find now is compared (Schied, Peters, Dachsbacher, "Gradient Estimation for Real-Time Adaptive Temporal Filtering", HPG 2018).
//! As random numbers are a hash, nothing but what was found has to be kept.

use crate::memory::LEAST_ALBEDO;
use crate::path::View;
use glam::Vec3;
use rayon::prelude::*;
use voxtrace_core::Frame;
use voxtrace_core::denoise::box_mean;
use voxtrace_core::math::luminance;
use voxtrace_core::sampler::{Sampler, pcg4d};

/// Mixed into the user's seed.
const SEED: u32 = 0xc2b2_ae35;
/// One pixel of a square of this width is looked at.
pub const STRIDE: u32 = 5;
/// Squares on either side over which changes are averaged; where none of them found light, over more.
const REACH: [usize; 2] = [1, 4];
/// How far, in voxels and in pixel widths, what is seen may be from what was seen: else it moved, and nothing is known of its light.
const PLACE_TOLERANCE: f32 = 2.0;

/// Shares of the light that changed, between which what is left of darker light goes over to being as dark.
const MOSTLY: [f32; 2] = [0.5, 0.75];

/// What changed of a pixel's light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Change {
    /// How much of it is another: 0 nothing, 1 all.
    pub share: f32,
    /// What the light that is remembered is to be multiplied with, at most 1: else the little that is left of a bright lamp that was switched off would outshine what is there now.
    pub scale: f32,
}

impl Change {
    /// That of the mean light of some squares then and now, the mean of its steps and of the larger of both.
    fn of([before, now, step, larger]: [f32; 4]) -> Self {
        if larger <= 0.0 {
            return Self { share: 0.0, scale: 1.0 };
        }
        let share = (step / larger).min(1.0);
        let darker = (before - now).max(0.0) / before.max(1e-30);
        let goes_over = ((share - MOSTLY[0]) / (MOSTLY[1] - MOSTLY[0])).clamp(0.0, 1.0);
        Self { share, scale: 1.0 - goes_over * darker }
    }
}

/// What paths of some pixels of a frame found without the light cache, to be found again.
pub struct Found {
    size: [u32; 2],
    /// Of each square: the luminance of the light that fell on what its pixel showed, and where that was.
    squares: Vec<(f32, Vec3)>,
}

impl Found {
    /// Follows the paths of frame `number`, one for each square of pixels.
    pub fn of(view: &View, frame: &Frame, number: u32) -> Self {
        let size = [frame.width, frame.height];
        let columns = size[0].div_ceil(STRIDE);
        let square = |index: u32| {
            let (column, row) = (index % columns, index / columns);
            let [dx, dy, ..] = pcg4d([column, row, number, SEED]);
            let x = (column * STRIDE + dx % STRIDE).min(size[0] - 1);
            let y = (row * STRIDE + dy % STRIDE).min(size[1] - 1);
            let sampler = Sampler { seed: frame.seed ^ SEED, pixel: y * size[0] + x, sample: number };
            let sample = view.sample(x, y, sampler, false, &mut Vec::new());
            sample.shown.map_or((0.0, Vec3::ZERO), |shown| {
                (luminance(sample.light) / (luminance(sample.albedo) + LEAST_ALBEDO), shown.place)
            })
        };
        Self { size, squares: (0..columns * size[1].div_ceil(STRIDE)).into_par_iter().map(square).collect() }
    }

    /// What is another in `now`, for each pixel.
    pub fn changes(&self, now: &Self, view: &View) -> Vec<Change> {
        let [width, height] = self.size;
        let columns = width.div_ceil(STRIDE);
        let compare = |(before, now): (&(f32, Vec3), &(f32, Vec3))| {
            let distance = (now.1 - view.eye).length();
            let tolerance = PLACE_TOLERANCE * (1.0 + view.view_angle / height as f32 * distance);
            let is_same = (now.1 - before.1).length() <= tolerance;
            if is_same { [before.0, now.0, (now.0 - before.0).abs(), now.0.max(before.0)] } else { [0.0; 4] }
        };
        let squares: Vec<[f32; 4]> = self.squares.iter().zip(&now.squares).map(compare).collect();
        let values = [0, 1, 2, 3].map(|which| squares.iter().map(|square| square[which]).collect::<Vec<_>>());
        let around = |reach| [0, 1, 2, 3].map(|which: usize| box_mean(&values[which], columns as usize, reach));
        let (near, far) = (around(REACH[0]), around(REACH[1]));
        let change = |pixel: u32| {
            let at = (pixel / width / STRIDE * columns + pixel % width / STRIDE) as usize;
            let around = if near[3][at] > 0.0 { &near } else { &far };
            Change::of([0, 1, 2, 3].map(|which| around[which][at]))
        };
        (0..width * height).into_par_iter().map(change).collect()
    }
}

/// How many paths a pixel still remembers where a share of the light changed: the next one counts as much as the share says.
pub fn paths_left(paths: f32, changed: f32) -> f32 {
    let next = 1.0 / (paths + 1.0);
    let next = next + (1.0 - next) * changed;
    1.0 / next - 1.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_left_of_light_that_was_switched_off_is_as_dark_as_what_is_there_now() {
        // All lamps at a tenth: what is remembered is scaled, so that one path that is left of a hundred shows the same.
        let dimmed = Change::of([1.0, 0.1, 0.9, 1.0]);
        assert!((dimmed.share - 0.9).abs() < 1e-6 && (dimmed.scale - 0.1).abs() < 1e-6, "{dimmed:?}");
        // Things that move change a part of the light, some squares up and others down: nothing is scaled, however often.
        assert_eq!(Change::of([1.0, 0.8, 0.5, 1.1]).scale, 1.0);
        // What is brighter has most of the mean by itself.
        assert_eq!(Change::of([0.1, 1.0, 0.9, 1.0]).scale, 1.0);
        assert_eq!(Change::of([0.0, 0.0, 0.0, 0.0]), Change { share: 0.0, scale: 1.0 });
        // Between both nothing jumps.
        assert!((Change::of([1.0, 0.375, 0.625, 1.0]).scale - (1.0 - 0.5 * 0.625)).abs() < 1e-6);
    }
}
