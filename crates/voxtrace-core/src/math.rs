//! Functions that shaders reproduce to the bit: sums, products, quotients and square roots in a fixed order, and polynomials in
//! place of the standard library's sine and cosine.

use glam::Vec3;
use std::f32::consts::{LOG2_E, PI};
pub use voxtrace_scene::trigonometry::sincos_turns;

/// The unit vector along `vector`, which must not be zero.
#[inline]
pub fn normalize(vector: Vec3) -> Vec3 {
    vector * (1.0 / vector.length_squared().sqrt())
}

/// 1 over the largest power of two that is not above `x`, exactly; `x` is a normal number > 0 below 2¹²⁷.
#[inline]
pub fn inverse_power_of_two(x: f32) -> f32 {
    f32::from_bits(254u32.wrapping_sub(x.to_bits() >> 23) << 23)
}

/// About 1 / `x`, within 1.5 per cent, for weights that need not be exact: quotients with the same bits on every device are dear. `x` is a
/// normal number > 0 below 2¹²⁶. One step of Newton's from a difference of exponents.
#[inline]
pub fn reciprocal_guess(x: f32) -> f32 {
    let guess = f32::from_bits(0x7ef3_11c3 - x.to_bits());
    guess * (2.0 - x * guess)
}

/// e to the power of `x`, `x` ≤ 0, within three units in the last place; 0 below −87.
#[inline]
pub fn exponential(x: f32) -> f32 {
    if x < -87.0 {
        return 0.0;
    }
    let power = (x * LOG2_E - 0.5) as i32;
    let k = power as f32;
    let r = (x - k * LN_2_HIGH) - k * LN_2_LOW;
    // Taylor series: for |r| <= ln 2 / 2 the first omitted term is below 6e-9.
    let tail = 1.0 / 24.0 + r * (1.0 / 120.0 + r * (1.0 / 720.0 + r * (1.0 / 5040.0)));
    let series = 1.0 + r * (1.0 + r * (0.5 + r * (1.0 / 6.0 + r * tail)));
    series * f32::from_bits(((127 + power) as u32) << 23)
}

/// Natural logarithm of a normal number > 0, within two units in the last place or 1e-7.
#[inline]
pub fn logarithm(x: f32) -> f32 {
    let bits = x.to_bits();
    let is_upper = bits & 0x007f_ffff > 0x0035_04f3;
    // The mantissa in [√½, √2), where the series of the inverse hyperbolic tangent is quick.
    let power = (bits >> 23) as i32 - 127 + i32::from(is_upper);
    let mantissa = f32::from_bits(bits & 0x007f_ffff | if is_upper { 0x3f00_0000 } else { 0x3f80_0000 });
    let s = (mantissa - 1.0) / (mantissa + 1.0);
    let ss = s * s;
    let series = s * (2.0 + ss * (2.0 / 3.0 + ss * (0.4 + ss * (2.0 / 7.0 + ss * (2.0 / 9.0)))));
    power as f32 * LN_2_HIGH + (power as f32 * LN_2_LOW + series)
}

/// The logarithm of 2 in two parts, the first of ten bits, whose products with whole numbers are exact.
const LN_2_HIGH: f32 = 355.0 / 512.0;
const LN_2_LOW: f32 = -2.121_944_4e-4;

/// A right-handed pair of unit vectors at right angles to the unit vector `z` and to each other (Duff et al., "Building an Orthonormal Basis,
/// Revisited", JCGT 6(1), 2017).
#[inline]
pub fn orthonormal_pair(z: Vec3) -> (Vec3, Vec3) {
    let sign = if z.z < 0.0 { -1.0 } else { 1.0 };
    let a = -1.0 / (sign + z.z);
    let b = z.x * z.y * a;
    (Vec3::new(1.0 + sign * z.x * z.x * a, sign * b, -sign * z.x), Vec3::new(b, sign + z.y * z.y * a, -z.y))
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
    fn powers_of_two_are_exact_and_guessed_reciprocals_near() {
        for step in 0..200_000 {
            let x = 1e-18 * 1.0004_f32.powi(step);
            let power = inverse_power_of_two(x);
            assert!(power.to_bits() & 0x007f_ffff == 0 && (1.0..2.0).contains(&(x * power)), "{x}: {power}");
            let product = reciprocal_guess(x) * x;
            assert!((0.985..1.0001).contains(&product), "{x}: {product}");
        }
    }

    #[test]
    fn exponentials_and_logarithms_are_those_of_doubles() {
        let check = |own: &dyn Fn(f32) -> f32, true_value: fn(f64) -> f64, values: &mut dyn Iterator<Item = f32>| {
            values
                .map(|x| (f64::from(own(x)) - true_value(x.into())).abs() / true_value(x.into()).abs().max(0.3))
                .fold(0.0, f64::max)
        };
        let negative = || (0..80_000).map(|i| -0.001 * i as f32);
        assert!(check(&exponential, f64::exp, &mut negative()) < 4e-7);
        assert!(check(&|x| exponential(x) * 1.000_002, f64::exp, &mut negative()) > 4e-7, "a fault is seen");
        for x in negative() {
            let relative = f64::from(exponential(x)) / f64::from(x).exp() - 1.0;
            assert!(relative.abs() < 4e-7, "{x}: {relative}");
        }
        assert_eq!((exponential(0.0), exponential(-1e9), exponential(f32::NEG_INFINITY)), (1.0, 0.0, 0.0));
        let positive = || (1..100_000).map(|i| 1e-5 * i as f32).chain([1.0 / 16_777_216.0, 1.0, 2.0, 1e30]);
        assert!(check(&logarithm, f64::ln, &mut positive()) < 4e-7);
        assert!(check(&|x| logarithm(x) * 1.000_002, f64::ln, &mut positive()) > 4e-7, "a fault is seen");
        assert_eq!(logarithm(1.0), 0.0);
    }

    #[test]
    fn pairs_are_orthonormal_and_right_handed() {
        for z in [Vec3::Z, Vec3::NEG_Z, Vec3::X, Vec3::new(0.48, -0.6, -0.64), Vec3::new(1e-4, 2e-4, -1.0).normalize()]
        {
            let (x, y) = orthonormal_pair(z);
            assert!(x.cross(y).abs_diff_eq(z, 1e-6) && y.cross(z).abs_diff_eq(x, 1e-6), "{z}");
        }
    }

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
