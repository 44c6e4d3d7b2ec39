//! One level of the wavelet transform: a blur whose weights stop at edges (Dammertz et al., "Edge-Avoiding À-Trous Wavelet Transform for fast Global
//! Illumination Filtering", HPG 2010), and which of the details that it took away are more than noise (Chang, Yu, Vetterli, "Adaptive Wavelet
//! Thresholding for Image Denoising and Compression", IEEE TIP 9(9), 2000).

use super::surfaces::Surfaces;
use super::variance::{ENOUGH_PATHS, SEVERAL_PATHS};
use crate::memory::Memory;
use glam::Vec3;
use rayon::prelude::*;
use voxtrace_core::denoise::box_mean;
use voxtrace_core::math::luminance;

/// Variance below which noise is not looked for, relative to the square of the light, so that exact light divides by no zero.
const LEAST_VARIANCE: f32 = 1e-6;
/// How many times its noise the energy of a detail must be before any of it is kept: after one path, of which nobody knows how noisy it is, and after several.
const THRESHOLD: [f32; 2] = [4.0, 1.6];
/// Pixels on either side over which the energy of details is averaged.
const NEIGHBOURHOOD: usize = 1;
/// The middle of a level's kernel; on either side there is half of the rest. That of the linear B-spline, and of a narrower one after many paths, whose light
/// needs fewer others.
const MIDDLE: [f32; 2] = [0.5, 0.6];
/// Paths that are many for that.
const NARROW_PATHS: f32 = 31.5;
/// What of another pixel's noise counts beside a pixel's own, times the paths that it remembers, once it knows its own. Else dark pixels, whose noise is
/// little, would leave out bright ones that take light from them, and after few paths a picture would be too dark.
const OTHERS_NOISE: f32 = 0.2;

/// Light and the variance of its luminance, of each pixel.
pub struct Light {
    pub color: Vec<Vec3>,
    pub variance: Vec<f32>,
}

/// A coarser level, and what of each pixel's light is its own of the finer one.
pub struct Coarse {
    pub light: Light,
    pub own_share: Vec<f32>,
}

/// The next coarser level, from pixels `step` apart.
pub fn smooth(light: &Light, surfaces: &Surfaces, tolerance: &[f32], step: i32) -> Coarse {
    let pixel = |of: usize| {
        let own = luminance(light.color[of]);
        let paths = surfaces.memory[of].paths;
        let middle = if paths < NARROW_PATHS { MIDDLE[0] } else { MIDDLE[1] };
        let hat = [middle, 0.5 * (1.0 - middle)];
        // Square differences of light at which pixels are no longer alike: what the own noise says, and what each unit of another's variance adds.
        let square = tolerance[of] * tolerance[of];
        let own_reach = square * (light.variance[of] + LEAST_VARIANCE * own * own + 1e-12);
        let others = if paths < ENOUGH_PATHS { 0.0 } else { square * (OTHERS_NOISE / paths) };
        let (mut color, mut variance, mut weights) = (Vec3::ZERO, 0.0, 0.0);
        surfaces.around(of, 1, step, |at, dx, dy| {
            let mut weight = hat[dx.unsigned_abs() as usize] * hat[dy.unsigned_abs() as usize];
            if at != of {
                let difference = luminance(light.color[at]) - own;
                let reach = own_reach + others * light.variance[at];
                let lights = (1.0 - difference * difference / reach).max(0.0);
                weight *= surfaces.alike(of, at) * lights * lights;
            }
            color += light.color[at] * weight;
            variance += weight * weight * light.variance[at];
            weights += weight;
        });
        let scale = 1.0 / weights;
        (color * scale, (variance * scale * scale, hat[0] * hat[0] * scale))
    };
    let (color, rest): (Vec<_>, Vec<_>) = (0..light.color.len()).into_par_iter().map(pixel).unzip();
    let (variance, own_share) = rest.into_iter().unzip();
    Coarse { light: Light { color, variance }, own_share }
}

/// Adds to `kept` the part of what `coarse` lacks of `fine` that is more than noise.
pub fn keep_detail(fine: &Light, coarse: &Coarse, surfaces: &Surfaces, kept: &mut [Vec3]) {
    let &Surfaces { memory, width, .. } = surfaces;
    let energy = |(fine, coarse): (&Vec3, &Vec3)| {
        let detail = luminance(*fine - *coarse);
        detail * detail
    };
    let energy: Vec<f32> = fine.color.par_iter().zip(&coarse.light.color).map(energy).collect();
    // The detail is (1 − own) · fine minus the others' shares, whose noises are independent.
    let noise = |((fine, coarse), own): ((&f32, &f32), &f32)| (fine * (1.0 - 2.0 * own) + coarse).max(0.0);
    let pairs = fine.variance.par_iter().zip(&coarse.light.variance).zip(&coarse.own_share);
    let noise: Vec<f32> = pairs.map(noise).collect();
    let (energy, noise) = (box_mean(&energy, width, NEIGHBOURHOOD), box_mean(&noise, width, NEIGHBOURHOOD));
    kept.par_iter_mut().enumerate().for_each(|(index, kept)| {
        let threshold = threshold(&memory[index]);
        let share = (1.0 - threshold * noise[index] / energy[index].max(1e-30)).max(0.0);
        *kept += (fine.color[index] - coarse.light.color[index]) * share;
    });
}

/// How many times its noise the energy of a pixel's details must be.
fn threshold(memory: &Memory) -> f32 {
    let [one, several] = THRESHOLD;
    if memory.paths < SEVERAL_PATHS { one } else { several }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn details_of_twice_their_noise_are_kept_unless_one_path_alone_is_known() {
        let kept = |paths: f32| {
            let memory = vec![Memory { paths, coverage: 1.0, ..Memory::default() }; 9];
            let light =
                |color: f32, variance: f32| Light { color: vec![Vec3::splat(color); 9], variance: vec![variance; 9] };
            let coarse = Coarse { light: light(0.0, 0.0), own_share: vec![0.0; 9] };
            let mut kept = vec![Vec3::ZERO; 9];
            keep_detail(&light(1.0, 0.5), &coarse, &Surfaces::new(&memory, 3), &mut kept);
            kept[4].x
        };
        assert_eq!(kept(1.0), 0.0);
        assert!((kept(2.0) - 0.2).abs() < 1e-6, "{}", kept(2.0));
    }
}
