//! What chance at clear glass leaves in the features: each sample follows one of two ways there, so that pixels that show the same have seen
//! other shares of both. Light is divided by what its own samples saw; the mean of pixels that are alike is what it is multiplied by again.

use super::features::{FeaturePixel, Features};
use super::surfaces::Surfaces;
use super::variance;
use super::wavelet::{Light, smooth};
use glam::Vec3;
use rayon::prelude::*;

/// Levels of the blur: more would take edges away that are seen through glass, without which noise was not less.
const LEVELS: u32 = 2;
/// Standard deviations by which two pixels may differ before they are no longer alike.
const TOLERANCE: f32 = 3.0;

/// `direct` and `albedo` of each pixel without that noise. Pixels that show no clear glass stay as they are.
pub fn without(features: &Features, surfaces: &Surfaces) -> [Vec<Vec3>; 2] {
    let [direct, albedo]: [fn(&FeaturePixel) -> Vec3; 2] = [|pixel| pixel.direct, |pixel| pixel.albedo];
    [(direct, 0), (albedo, 1)].map(|(color, which)| {
        let colors: Vec<Vec3> = features.pixels.par_iter().map(color).collect();
        let own: Vec<f32> = features.pixels.par_iter().map(|pixel| pixel.chance[which]).collect();
        if own.par_iter().all(|&variance| variance == 0.0) {
            return colors;
        }
        let around = variance::with_surroundings(&own, surfaces);
        let variance = own.iter().zip(around).map(|(&own, around)| if own > 0.0 { around } else { 0.0 }).collect();
        let tolerance = vec![TOLERANCE * TOLERANCE; own.len()];
        let mut light = Light::new(&colors, variance, surfaces.width);
        for level in 0..LEVELS {
            light = smooth(&light, surfaces, &tolerance, 1 << level).light;
        }
        let [r, g, b] = &light.channels;
        let color =
            |index: usize| if own[index] > 0.0 { Vec3::new(r[index], g[index], b[index]) } else { colors[index] };
        (0..own.len()).into_par_iter().map(color).collect()
    })
}
