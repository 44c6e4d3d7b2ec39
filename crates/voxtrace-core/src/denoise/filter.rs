//! The filter from end to end.

use super::chance;
use super::features::{FeaturePixel, Features};
use super::surfaces::Surfaces;
use super::variance;
use super::wavelet::{Light, box_mean, detail_to_keep, luminance, smooth};
use crate::film::{Film, Pixel};
use glam::Vec3;
use rayon::prelude::*;

/// Levels of the wavelet transform: the last one reaches 2 · 2³ pixels far.
const LEVELS: u32 = 4;
/// How many times its variance a pixel's square step may be before the filter is doubted.
const MOST_STEP: f32 = 1.2;
/// Pixels on either side over which that is averaged.
const TRUST_REACH: usize = 4;
/// Standard deviations by which the light of two pixels may differ before they are no longer alike, where how noisy they are is a guess.
const GUESSED_TOLERANCE: f32 = 4.0;
/// Added to albedos before they divide, so that black surfaces do not make noise of nothing.
const LEAST_ALBEDO: f32 = 0.003;
/// Least sum of an albedo's channels that says how much light falls on a surface.
const LEAST_SUM: f32 = 0.1 * LEAST_ALBEDO;

/// The mean radiance of each pixel of `film` without noise, linear, row by row. `features` are those of the film. Where
/// [`Film::earlier`] says how the pixels stood after some of their samples, best half of them, the filter knows from the difference how noisy
/// each is; else that is guessed from the pixels around.
///
/// # Panics
/// If the features, or the earlier pixels, are as many as those of another film.
pub fn denoise(film: &Film, features: &Features) -> Vec<Vec3> {
    filtered(film, features, &|| true)
}

/// As [`denoise`], as long as it is `wanted`, which is asked now and then, on several threads, and which says no for good; `None` then.
///
/// # Panics
/// As [`denoise`].
pub fn denoise_while(film: &Film, features: &Features, wanted: &(dyn Fn() -> bool + Sync)) -> Option<Vec<Vec3>> {
    let radiance = filtered(film, features, wanted);
    wanted().then_some(radiance)
}

/// The mean radiance of each pixel, or anything where nobody wants it any more.
fn filtered(film: &Film, features: &Features, wanted: &(dyn Fn() -> bool + Sync)) -> Vec<Vec3> {
    let width = film.region.width().max(1) as usize;
    assert_eq!(film.pixels.len(), features.pixels.len(), "features are those of the film");
    let surfaces = Surfaces::new(features, width, wanted);
    let noisy: Vec<Vec3> = light_of(&film.pixels, features);
    let earlier = variance::earlier(film);
    let own_variance = variance::of(&noisy, film, earlier, features, &surfaces);
    let mut tolerance = match earlier {
        Some(_) => variance::tolerances(&noisy, &own_variance, &surfaces),
        None => vec![GUESSED_TOLERANCE * GUESSED_TOLERANCE; noisy.len()],
    };
    let variance = variance::with_surroundings(&own_variance, &surfaces);
    let mut light = Light::new(&noisy, variance, width);
    let mut kept = [0, 1, 2].map(|_| vec![0.0; noisy.len()]);
    for level in 0..LEVELS {
        let coarse = smooth(&light, &surfaces, &tolerance, 1 << level);
        detail_to_keep(&light, &coarse, &mut kept);
        light = coarse.light;
        if earlier.is_some() {
            variance::lower_tolerances(&mut tolerance);
        }
    }
    let smooth = |index: usize| Vec3::from_array([0, 1, 2].map(|c: usize| light.channels[c][index] + kept[c][index]));
    let smooth: Vec<Vec3> = (0..noisy.len()).into_par_iter().map(smooth).collect();
    let trust = trust(&noisy, &smooth, &own_variance, width);
    let [direct, albedo] = chance::without(features, &surfaces);
    let pixel = |(index, features): (usize, &FeaturePixel)| {
        if features.coverage == 0.0 {
            return features.direct;
        }
        let light = noisy[index] + trust[index] * (smooth[index] - noisy[index]);
        (direct[index] + radiance_of(light, albedo[index])).max(Vec3::ZERO)
    };
    features.pixels.par_iter().enumerate().map(pixel).collect()
}

/// How far each pixel goes from what it was to what the filter made of it: all the way where that is about as far as its noise, and
/// the less the farther beyond it is (James and Stein, "Estimation with Quadratic Loss", 1961).
pub fn trust(noisy: &[Vec3], smooth: &[Vec3], variance: &[f32], width: usize) -> Vec<f32> {
    let step = |(noisy, smooth): (&Vec3, &Vec3)| {
        let step = luminance(*smooth) - luminance(*noisy);
        step * step
    };
    let steps: Vec<f32> = noisy.par_iter().zip(smooth).map(step).collect();
    let (steps, variance) = (box_mean(&steps, width, TRUST_REACH), box_mean(variance, width, TRUST_REACH));
    steps.iter().zip(variance).map(|(step, variance)| (MOST_STEP * variance / step.max(1e-30)).min(1.0)).collect()
}

/// The light that falls on a surface of this albedo which sends back `radiance`. A channel that the surface hardly sends back says nothing
/// about the light: there it is what all channels together say. Else the blue light of a red surface would be none, and that of others beside
/// it would be darkened by it.
fn light_on(radiance: Vec3, albedo: Vec3) -> Vec3 {
    let grey = radiance.element_sum() / albedo.element_sum().max(LEAST_SUM);
    (radiance + LEAST_ALBEDO * grey) / (albedo + LEAST_ALBEDO)
}

/// What [`light_on`] was made of.
fn radiance_of(light: Vec3, albedo: Vec3) -> Vec3 {
    let shown = light * (albedo + LEAST_ALBEDO);
    // The sum over the channels has the grey light of each, too.
    let grey = shown.element_sum() / (albedo.element_sum().max(LEAST_SUM) + 3.0 * LEAST_ALBEDO);
    shown - LEAST_ALBEDO * grey
}

/// The light that falls on the surfaces that each pixel shows.
pub fn light_of(pixels: &[Pixel], features: &Features) -> Vec<Vec3> {
    let light = |(pixel, features): (&Pixel, &FeaturePixel)| {
        if features.coverage > 0.0 { light_on(pixel.mean() - features.direct, features.albedo) } else { Vec3::ZERO }
    };
    pixels.par_iter().zip(&features.pixels).map(light).collect()
}
