//! How a medium scatters: the phase function of Henyey and Greenstein ("Diffuse Radiation in the Galaxy", 1941).

use crate::math::{orthonormal_pair, sincos_turns};
use glam::Vec3;
use std::f32::consts::PI;

/// Below this anisotropy all directions are alike: the formula would cancel.
const ISOTROPIC: f32 = 1e-3;

/// Density over solid angle of being scattered by an angle of cosine `cos`, > 0 forwards.
#[inline]
pub fn pdf(anisotropy: f32, cos: f32) -> f32 {
    let g = anisotropy;
    let base = 1.0 + g * g - 2.0 * g * cos;
    (1.0 - g * g) / (4.0 * PI * (base * base.sqrt()))
}

/// The unit direction into which light that travels along the unit vector `forward` is scattered, for `u` and `v` uniform in [0, 1), and the
/// cosine between the two.
#[inline]
pub fn sample(anisotropy: f32, forward: Vec3, u: f32, v: f32) -> (Vec3, f32) {
    let g = anisotropy;
    let cos = if g.abs() < ISOTROPIC {
        1.0 - 2.0 * u
    } else {
        let ratio = (1.0 - g * g) / (1.0 + g - 2.0 * g * u);
        (1.0 + g * g - ratio * ratio) / (2.0 * g)
    };
    let cos = cos.clamp(-1.0, 1.0);
    let radius = (1.0 - cos * cos).sqrt();
    let (sin_phi, cos_phi) = sincos_turns(v);
    let (x, y) = orthonormal_pair(forward);
    (x * (radius * cos_phi) + y * (radius * sin_phi) + forward * cos, cos)
}
