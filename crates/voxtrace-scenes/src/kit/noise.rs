//! Hash noise and angles for the built-in scenes, made of integer operations and + − × ÷ alone, so that every machine
//! generates the same voxels. The integer hash is the two-round xor-shift-multiply mixer known as lowbias32.

use glam::{IVec3, Vec3};

/// A well mixed 32-bit hash of a number.
#[inline]
pub fn hash(mut x: u32) -> u32 {
    x ^= x >> 16;
    x = x.wrapping_mul(0x7feb_352d);
    x ^= x >> 15;
    x = x.wrapping_mul(0x846c_a68b);
    x ^ x >> 16
}

/// A hash of a lattice point and a seed.
#[inline]
pub fn hash3(at: IVec3, seed: u32) -> u32 {
    let x = (at.x as u32).wrapping_mul(0x8da6_b343);
    let y = (at.y as u32).wrapping_mul(0xd816_3841);
    let z = (at.z as u32).wrapping_mul(0xcb1a_b31f);
    hash(x ^ y.rotate_left(11) ^ z.rotate_left(22) ^ seed.wrapping_mul(0x9e37_79b9))
}

/// A hash as a number in [0, 1).
#[inline]
pub fn unit(hash: u32) -> f32 {
    (hash >> 8) as f32 * (1.0 / 16_777_216.0)
}

/// A hash as a number in [−1, 1).
#[inline]
pub fn signed(hash: u32) -> f32 {
    unit(hash) * 2.0 - 1.0
}

/// The largest integer that is not above `x` (`f32::floor` is a library call on plain x86-64).
#[inline]
pub fn floor(x: f32) -> i32 {
    let whole = x as i32;
    whole - i32::from((whole as f32) > x)
}

/// The fractional part of `x`, in [0, 1).
#[inline]
pub fn fraction(x: f32) -> f32 {
    x - floor(x) as f32
}

/// The lattice cell of a point and the smoothed position in it.
#[inline]
fn cell(at: Vec3) -> (IVec3, Vec3) {
    let corner = IVec3::new(floor(at.x), floor(at.y), floor(at.z));
    let f = at - corner.as_vec3();
    (corner, f * f * (Vec3::splat(3.0) - f * 2.0))
}

/// Value noise in [−1, 1] with features of size 1: random values on the integer lattice, interpolated smoothly.
pub fn value_noise(at: Vec3, seed: u32) -> f32 {
    let (corner, f) = cell(at);
    let value = |x, y, z| signed(hash3(corner + IVec3::new(x, y, z), seed));
    let along_x = |y, z| mix(value(0, y, z), value(1, y, z), f.x);
    let along_y = |z| mix(along_x(0, z), along_x(1, z), f.y);
    mix(along_y(0), along_y(1), f.z)
}

/// Fractal noise (fBm) in [−1, 1]: octaves of [`value_noise`], each of twice the frequency and half the amplitude.
pub fn fractal_noise(mut at: Vec3, octaves: u32, seed: u32) -> f32 {
    let (mut sum, mut weight, mut total) = (0.0, 1.0, 0.0);
    for octave in 0..octaves {
        sum += weight * value_noise(at, seed.wrapping_add(octave));
        total += weight;
        weight *= 0.5;
        at *= 2.0;
    }
    sum / total
}

/// Linear interpolation: `a` at 0, `b` at 1.
#[inline]
pub fn mix(a: f32, b: f32, share: f32) -> f32 {
    a + (b - a) * share
}

/// Smoothstep: 0 below `low`, 1 above `high`, a cubic between.
pub fn smooth_step(low: f32, high: f32, x: f32) -> f32 {
    let t = ((x - low) / (high - low)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// Sine and cosine of an angle in degrees, exact at multiples of 90°, by Taylor series on ±45°.
pub fn sin_cos_degrees(degrees: f32) -> (f32, f32) {
    let quarter = floor(degrees / 90.0 + 0.5);
    let x = (f64::from(degrees) - f64::from(quarter) * 90.0) * (std::f64::consts::PI / 180.0);
    let square = x * x;
    let (mut sin, mut cos) = (0.0, 0.0);
    // Horner from the highest term: sin = x (1 − x²/2·3 (1 − x²/4·5 (…))), cos alike.
    for n in (1..=8).rev() {
        let n = f64::from(n);
        sin = square / (2.0 * n * (2.0 * n + 1.0)) * (1.0 - sin);
        cos = square / ((2.0 * n - 1.0) * 2.0 * n) * (1.0 - cos);
    }
    let (sin, cos) = ((x * (1.0 - sin)) as f32, (1.0 - cos) as f32);
    match quarter.rem_euclid(4) {
        0 => (sin, cos),
        1 => (cos, -sin),
        2 => (-sin, -cos),
        _ => (-cos, sin),
    }
}

/// Angle of (x, y) in turns, [0, 1), 0 along +x and growing towards +y; off by less than 1e-3 turns. For patterns.
pub fn turns(x: f32, y: f32) -> f32 {
    let (ax, ay) = (x.abs(), y.abs());
    let ratio = ax.min(ay) / ax.max(ay).max(1e-20);
    // atan(r) / 2π on [0, 1].
    let eighth = ratio * (0.125 + 0.0435 * (1.0 - ratio));
    let quarter = if ay > ax { 0.25 - eighth } else { eighth };
    let half = if x < 0.0 { 0.5 - quarter } else { quarter };
    let turns = if y < 0.0 { 1.0 - half } else { half };
    if turns < 1.0 { turns } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sines_and_cosines_agree_with_the_library() {
        for degrees in -720..=720 {
            let (sin, cos) = sin_cos_degrees(degrees as f32);
            let angle = f64::from(degrees).to_radians();
            assert!((f64::from(sin) - angle.sin()).abs() < 1e-7, "sin {degrees}°");
            assert!((f64::from(cos) - angle.cos()).abs() < 1e-7, "cos {degrees}°");
        }
        assert_eq!(sin_cos_degrees(90.0), (1.0, -0.0));
        assert_eq!(sin_cos_degrees(180.0), (-0.0, -1.0));
    }

    #[test]
    fn turns_agree_with_atan2() {
        for degrees in 0..360 {
            let (sin, cos) = f64::from(degrees).to_radians().sin_cos();
            let error = (f64::from(turns(cos as f32, sin as f32)) - f64::from(degrees) / 360.0).abs();
            assert!(error.min(1.0 - error) < 1e-3, "{degrees}°: {error}");
        }
    }

    #[test]
    fn noise_stays_within_one_and_has_no_steps() {
        let mut last = value_noise(Vec3::ZERO, 7);
        for i in 1..4000 {
            let now = value_noise(Vec3::new(0.01, 0.003, -0.007) * i as f32, 7);
            assert!(now.abs() <= 1.0 && (now - last).abs() < 0.06, "step {i}: {last} to {now}");
            last = now;
        }
    }

    #[test]
    fn floor_agrees_with_the_library() {
        for i in -400..400 {
            let x = i as f32 * 0.125;
            assert_eq!(floor(x), f32::floor(x) as i32);
        }
    }
}
