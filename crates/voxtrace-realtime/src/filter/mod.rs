//! The filter: an à-trous wavelet transform of the light that falls on surfaces, with weights that stop at edges and details that come back where they are more
//! than noise. It is that of stills ([`voxtrace_core::denoise`], decision 48), made of passes in which each pixel gathers from others, and told by how many paths a
//! pixel remembers: after few, everything that differs is noise, and pixels like no other borrow from all around.

mod surfaces;
mod variance;
mod wavelet;

use crate::memory::Memory;
use glam::Vec3;
use rayon::prelude::*;
use surfaces::Surfaces;
use voxtrace_core::denoise::trust;

/// Levels of the wavelet transform: the last one reaches 2⁴ pixels far, all together 31.
const LEVELS: u32 = 5;

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
        wavelet::keep_detail(&light, &coarse, &surfaces, &mut kept);
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
