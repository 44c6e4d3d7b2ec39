//! Functions that shaders reproduce to the bit: sums, products, quotients and square roots in a fixed order, and polynomials in
//! place of the standard library's sine and cosine.

use glam::Vec3;
use std::f32::consts::PI;
pub use voxtrace_scene::trigonometry::sincos_turns;

/// The unit vector along `vector`, which must not be zero.
#[inline]
pub fn normalize(vector: Vec3) -> Vec3 {
    vector * (1.0 / vector.length_squared().sqrt())
}

/// Luminance of a linear Rec. 709 colour.
#[inline]
pub fn luminance(color: Vec3) -> f32 {
    color.x * 0.2126 + color.y * 0.7152 + color.z * 0.0722
}

/// A cosine-weighted direction of the hemisphere around +z (density cos θ / π), for `u` and `v` uniform in [0, 1). Its z is at least
/// 2⁻¹², so that it never lies in the surface.
#[inline]
pub fn cosine_hemisphere(u: f32, v: f32) -> Vec3 {
    let radius = u.sqrt();
    let (sin, cos) = sincos_turns(v);
    Vec3::new(radius * cos, radius * sin, (1.0 - u).sqrt())
}

/// Probability density of [`cosine_hemisphere`] over solid angle.
#[inline]
pub fn cosine_hemisphere_pdf(cos_theta: f32) -> f32 {
    cos_theta.max(0.0) * (1.0 / PI)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_hemisphere_is_sampled_in_proportion_to_the_cosine() {
        let moments = |sample: fn(f32, f32) -> Vec3| {
            let steps = 200;
            let mut mean = Vec3::ZERO;
            for i in 0..steps * steps {
                let at = |index: i32| (index as f32 + 0.5) / steps as f32;
                mean += sample(at(i / steps), at(i % steps)) / (steps * steps) as f32;
            }
            mean
        };
        // The mean of z under density cos θ / π is ∫ cos² θ dω / π = 2/3.
        let expected = Vec3::new(0.0, 0.0, 2.0 / 3.0);
        assert!(moments(cosine_hemisphere).abs_diff_eq(expected, 1e-4));
        let uniform = |u: f32, v: f32| cosine_hemisphere(1.0 - (1.0 - u) * (1.0 - u), v);
        assert!(!moments(uniform).abs_diff_eq(expected, 1e-2));
    }
}
