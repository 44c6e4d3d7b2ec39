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
            let sample = view.sample(x, y, sampler, &mut Vec::new());
            sample.shown.map_or((0.0, Vec3::ZERO), |shown| {
                (luminance(sample.light) / (luminance(sample.albedo) + LEAST_ALBEDO), shown.place)
            })
        };
        Self { size, squares: (0..columns * size[1].div_ceil(STRIDE)).into_par_iter().map(square).collect() }
    }

    /// How much of the light is another in `now`, for each pixel: 0 nothing, 1 all.
    pub fn changes(&self, now: &Self, view: &View) -> Vec<f32> {
        let [width, height] = self.size;
        let columns = width.div_ceil(STRIDE);
        let compare = |(before, now): (&(f32, Vec3), &(f32, Vec3))| {
            let distance = (now.1 - view.eye).length();
            let tolerance = PLACE_TOLERANCE * (1.0 + view.view_angle / height as f32 * distance);
            let is_same = (now.1 - before.1).length() <= tolerance;
            if is_same { ((now.0 - before.0).abs(), now.0.max(before.0)) } else { (0.0, 0.0) }
        };
        let (steps, lights): (Vec<f32>, Vec<f32>) = self.squares.iter().zip(&now.squares).map(compare).unzip();
        let around = |reach| [&steps, &lights].map(|values| box_mean(values, columns as usize, reach));
        let ([steps, lights], [far_steps, far_lights]) = (around(REACH[0]), around(REACH[1]));
        let share = |pixel: u32| {
            let at = (pixel / width / STRIDE * columns + pixel % width / STRIDE) as usize;
            let (step, light) =
                if lights[at] > 0.0 { (steps[at], lights[at]) } else { (far_steps[at], far_lights[at]) };
            if light > 0.0 { (step / light).min(1.0) } else { 0.0 }
        };
        (0..width * height).into_par_iter().map(share).collect()
    }
}

/// How many paths a pixel still remembers where a share of the light changed: the next one counts as much as the share says.
pub fn paths_left(paths: f32, changed: f32) -> f32 {
    let next = 1.0 / (paths + 1.0);
    let next = next + (1.0 - next) * changed;
    1.0 / next - 1.0
}
