//! How noisy the light of each pixel is: from the squares of its paths, and as long as these are few from the pixels around.

use super::surfaces::Surfaces;
use crate::memory::Memory;
use glam::Vec3;
use rayon::prelude::*;
use voxtrace_core::denoise::box_mean;
use voxtrace_core::math::luminance;

/// Between whole numbers, as the others, so that means of numbers of paths decide the same however they are rounded: paths from which on a pixel knows its noise itself.
pub const ENOUGH_PATHS: f32 = 3.5;
/// Paths that differ, so that their squares say something.
pub const SEVERAL_PATHS: f32 = 1.5;
/// Standard deviations by which the light of two pixels may differ before they are no longer alike, where light varies about as much as
/// its noise would have it; the least, and the most after many paths.
const TOLERANCE: [f32; 3] = [10.0, 2.5, 7.0];
/// Paths of which there must be many times as many before that is the most.
const PATHS_OF_TOLERANCE: f32 = 13.0;
/// What a level of the wavelet transform has of the tolerance of the one before it: means of more pixels have shorter tails. After few paths, and after many.
const TOLERANCE_FALL: [f32; 2] = [0.8, 0.6];
/// Paths that are many for that.
const MANY_PATHS: f32 = 7.5;
/// Pixels on either side over which the variation of light is averaged.
const TOLERANCE_REACH: usize = 8;
/// Pixels on either side of which the noise is that of a pixel without enough paths.
const SPATIAL_REACH: i32 = 3;

/// Variance of the luminance of each pixel's light.
pub fn of(memory: &[Memory], light: &[Vec3], surfaces: &Surfaces) -> Vec<f32> {
    let of_surroundings = |of: usize| {
        let (mut sum, mut squares, mut weights) = (0.0, 0.0, 0.0);
        surfaces.around(of, SPATIAL_REACH, 1, |at, _, _| {
            let (weight, light) = (surfaces.alike(of, at), luminance(light[at]));
            sum += weight * light;
            squares += weight * light * light;
            weights += weight;
        });
        let scale = 1.0 / f32::max(weights, 1e-20);
        (squares * scale - sum * scale * sum * scale).max(0.0)
    };
    let pixel = |(index, memory): (usize, &Memory)| {
        if memory.paths >= ENOUGH_PATHS {
            return memory.variance();
        }
        let spatial = of_surroundings(index);
        if memory.paths < SEVERAL_PATHS { spatial } else { 0.5 * (spatial + memory.variance()) }
    };
    memory.par_iter().enumerate().map(pixel).collect()
}

/// The same as far as pixels around that are alike can tell. A pixel that a rare bright path has hit is noisier than those around.
pub fn with_surroundings(own: &[f32], surfaces: &Surfaces) -> Vec<f32> {
    let around = surfaces.mean(&surfaces.mean(own, 1), 2);
    own.iter().zip(around).map(|(own, around)| own.max(around)).collect()
}

/// Standard deviations by which each pixel's light may differ from another's before they are no longer alike. Where light varies no
/// more than its noise, whatever differs is noise; where it varies more, as where voxels are smaller than pixels, it is as likely light.
pub fn tolerances(memory: &[Memory], light: &[Vec3], variance: &[f32], surfaces: &Surfaces) -> Vec<f32> {
    let values: Vec<f32> = light.par_iter().map(|&light| luminance(light)).collect();
    let around = surfaces.mean(&values, 1);
    let squares: Vec<f32> =
        values.iter().zip(around).map(|(value, around)| (value - around) * (value - around)).collect();
    let reach = |values: &[f32]| box_mean(values, surfaces.width, TOLERANCE_REACH);
    let (squares, variance) = (reach(&squares), reach(variance));
    let [usual, least, most] = TOLERANCE;
    let tolerance = |(memory, (square, variance)): (&Memory, (f32, f32))| {
        let excess = square / variance.max(1e-30);
        let most = most * (1.0 + PATHS_OF_TOLERANCE / memory.paths.max(1.0));
        (usual / (excess * excess).max(1e-6)).clamp(least, most)
    };
    memory.iter().zip(squares.into_iter().zip(variance)).map(tolerance).collect()
}

/// From one level of the wavelet transform to the next coarser one.
pub fn lower_tolerances(tolerances: &mut [f32], memory: &[Memory]) {
    let ([_, least, _], [few, many]) = (TOLERANCE, TOLERANCE_FALL);
    tolerances.par_iter_mut().zip(memory).for_each(|(tolerance, memory)| {
        let fall = if memory.paths < MANY_PATHS { few } else { many };
        *tolerance = (*tolerance * fall).max(tolerance.min(least));
    });
}
