//! How noisy the light of each pixel is: from the difference between two parts of its samples, or without them from the pixels
//! around; then smoothed over what is alike, because one difference says little.

use super::features::Features;
use super::filter::light_of;
use super::surfaces::Surfaces;
use super::wavelet::{self, luminance};
use crate::film::{Film, Pixel};
use glam::Vec3;
use rayon::prelude::*;

/// Share of what distinguishes pixels from those around that is taken for noise where nothing else is known: with more, the filter would
/// take details for noise, and pictures of voxels smaller than pixels would become worse.
const GUESSED_SHARE: f32 = 0.6;
/// Standard deviations by which the light of two pixels may differ before they are no longer alike, where light varies about as much as
/// its noise would have it; the least, and the most.
const TOLERANCE: [f32; 3] = [6.0, 2.5, 10.0];
/// What a level of the wavelet transform has of the tolerance of the one before it: means of more pixels have shorter tails.
const TOLERANCE_FALL: f32 = 0.6;
/// Pixels on either side over which that is averaged.
const TOLERANCE_REACH: usize = 8;

/// How the pixels stood earlier, where that says how noisy they are.
pub fn earlier(film: &Film) -> Option<&[Pixel]> {
    film.earlier.as_deref().filter(|earlier| is_a_part(earlier, film))
}

/// Variance of the luminance of each pixel's mean light.
pub fn of(
    light: &[Vec3],
    film: &Film,
    earlier: Option<&[Pixel]>,
    features: &Features,
    surfaces: &Surfaces,
) -> Vec<f32> {
    match earlier {
        Some(earlier) => of_parts(light, film, earlier, features),
        None => of_surroundings(light, surfaces),
    }
}

/// The same as far as pixels around that are alike can tell, which one difference cannot.
pub fn with_surroundings(own: &[f32], surfaces: &Surfaces) -> Vec<f32> {
    // Twice, the second time with gaps: about 100 pixels.
    let around = mean(&mean(own, surfaces, 1), surfaces, 2);
    // A pixel that a rare bright sample has hit is noisier than those around.
    own.iter().zip(around).map(|(own, around)| own.max(around)).collect()
}

/// Whether the earlier pixels leave enough samples for the difference to say something: a quarter.
fn is_a_part(earlier: &[Pixel], film: &Film) -> bool {
    let samples = |pixels: &[Pixel]| pixels.iter().map(|pixel| u64::from(pixel.samples)).sum::<u64>();
    let (first, all) = (samples(earlier), samples(&film.pixels));
    first > 0 && 4 * first <= 3 * all
}

/// One estimate a pixel: (a − b)² · n m / (n + m)², where the two parts have n and m samples.
fn of_parts(light: &[Vec3], film: &Film, earlier: &[Pixel], features: &Features) -> Vec<f32> {
    assert_eq!(film.pixels.len(), earlier.len(), "the earlier film shows the same pixels");
    let first = light_of(earlier, features);
    let pixel = |index: usize| {
        let (n, all) = (earlier[index].samples as f32, film.pixels[index].samples as f32);
        if n == 0.0 || n >= all {
            return 0.0;
        }
        // The mean is n/all · a + m/all · b, so that a − mean is m/all · (a − b).
        let step = luminance(first[index]) - luminance(light[index]);
        step * step * n / (all - n)
    };
    (0..light.len()).into_par_iter().map(pixel).collect()
}

/// Square standard deviations by which each pixel's light may differ from another's before they are no longer alike. Where light varies no
/// more than its noise, whatever differs is noise; where it varies more, as where voxels are smaller than pixels, it is as likely light.
pub fn tolerances(light: &[Vec3], variance: &[f32], surfaces: &Surfaces) -> Vec<f32> {
    let around = |values: &[f32]| wavelet::box_mean(values, surfaces.width, TOLERANCE_REACH);
    let (squares, variance) = (around(&steps_to_surroundings(light, surfaces)), around(variance));
    let tolerance = |(square, variance): (f32, f32)| {
        let excess = square / variance.max(1e-30);
        let [usual, least, most] = TOLERANCE;
        let tolerance = (usual / (excess * excess).max(1e-6)).clamp(least, most);
        tolerance * tolerance
    };
    squares.into_iter().zip(variance).map(tolerance).collect()
}

/// From one level of the wavelet transform to the next coarser one.
pub fn lower_tolerances(tolerances: &mut [f32]) {
    let [_, least, _] = TOLERANCE;
    let lower = |tolerance: &mut f32| {
        *tolerance = (*tolerance * TOLERANCE_FALL * TOLERANCE_FALL).max(tolerance.min(least * least));
    };
    tolerances.par_iter_mut().for_each(lower);
}

/// As far as the pixels around tell.
fn of_surroundings(light: &[Vec3], surfaces: &Surfaces) -> Vec<f32> {
    steps_to_surroundings(light, surfaces).into_iter().map(|square| GUESSED_SHARE * square).collect()
}

/// The square distance of each pixel from the mean of those around it.
fn steps_to_surroundings(light: &[Vec3], surfaces: &Surfaces) -> Vec<f32> {
    let values: Vec<f32> = light.par_iter().map(|&light| luminance(light)).collect();
    let around = mean(&values, surfaces, 1);
    values.iter().zip(around).map(|(value, around)| (value - around) * (value - around)).collect()
}

/// The mean of the pixels around each that are alike, by the filter's kernel.
fn mean(values: &[f32], surfaces: &Surfaces, step: usize) -> Vec<f32> {
    let width = surfaces.width;
    let mut out = vec![0.0; values.len()];
    out.par_chunks_mut(width).enumerate().for_each(|(y, out)| {
        if !(surfaces.wanted)() {
            return;
        }
        let mut weights = vec![0.0; width];
        let mut alike = vec![0.0; width];
        for tap in wavelet::taps(y, width, values.len() / width, step) {
            let alike = &mut alike[..tap.columns.len()];
            surfaces.alike(y * width + tap.columns.start, tap.offset, alike);
            let from = (y * width + tap.columns.start).wrapping_add_signed(tap.offset);
            let values = &values[from..from + alike.len()];
            let sums = out[tap.columns.clone()].iter_mut().zip(&mut weights[tap.columns.clone()]);
            for ((sum, weight), (alike, value)) in sums.zip(alike.iter().zip(values)) {
                *sum += tap.weight * alike * value;
                *weight += tap.weight * alike;
            }
        }
        out.iter_mut().zip(&weights).for_each(|(sum, weight)| *sum /= weight.max(1e-20));
    });
    out
}
