//! The filter: an à-trous wavelet transform of the light that falls on surfaces, with weights that stop at edges and details that come back where they are more
//! than noise. It is that of stills ([`voxtrace_core::denoise`], decision 48), made of passes in which each pixel gathers from others, and told by how many paths a
//! pixel remembers: after few, everything that differs is noise, and pixels like no other borrow from all around.

mod surfaces;
pub(crate) use surfaces::box_mean;
mod variance;
mod wavelet;

use crate::memory::Memory;
use glam::Vec3;
use rayon::prelude::*;
use surfaces::Surfaces;
use voxtrace_core::math::luminance;

/// Levels of the wavelet transform: the last one reaches 2 · 2⁴ pixels far.
const LEVELS: u32 = 5;
/// How many times its variance a pixel's square step may be before the filter is doubted.
const MOST_STEP: f32 = 1.2;
/// Pixels on either side over which that is averaged.
const TRUST_REACH: usize = 4;

/// The radiance of each pixel, `width` in a row, without noise.
pub fn filter(memory: &[Memory], width: usize) -> Vec<Vec3> {
    let surfaces = Surfaces::new(memory, width);
    let noisy: Vec<Vec3> = memory.par_iter().map(Memory::irradiance).collect();
    let own = variance::of(memory, &noisy, &surfaces);
    let mut tolerance = variance::tolerances(memory, &noisy, &own, &surfaces);
    let mut light = wavelet::Light { color: noisy.clone(), variance: variance::with_surroundings(&own, &surfaces) };
    let mut kept = vec![Vec3::ZERO; noisy.len()];
    for level in 0..LEVELS {
        let coarse = wavelet::smooth(&light, &surfaces, &tolerance, 1 << level);
        wavelet::keep_detail(&light, &coarse, width, &mut kept);
        light = coarse.light;
        variance::lower_tolerances(&mut tolerance, memory);
    }
    let smooth: Vec<Vec3> = light.color.par_iter().zip(&kept).map(|(light, kept)| *light + *kept).collect();
    let trust = trust(&noisy, &smooth, &own, width);
    let pixel = |index: usize| {
        let light = noisy[index] + (smooth[index] - noisy[index]) * trust[index];
        memory[index].radiance(light)
    };
    (0..memory.len()).into_par_iter().map(pixel).collect()
}

/// How far each pixel goes from what it was to what the filter made of it: all the way where that is about as far as its noise, and
/// the less the farther beyond it is (James and Stein, "Estimation with Quadratic Loss", 1961).
fn trust(noisy: &[Vec3], smooth: &[Vec3], variance: &[f32], width: usize) -> Vec<f32> {
    let step = |(noisy, smooth): (&Vec3, &Vec3)| {
        let step = luminance(*smooth) - luminance(*noisy);
        step * step
    };
    let steps: Vec<f32> = noisy.par_iter().zip(smooth).map(step).collect();
    let (steps, variance) = (box_mean(&steps, width, TRUST_REACH), box_mean(variance, width, TRUST_REACH));
    steps.iter().zip(variance).map(|(step, variance)| (MOST_STEP * variance / step.max(1e-30)).min(1.0)).collect()
}
