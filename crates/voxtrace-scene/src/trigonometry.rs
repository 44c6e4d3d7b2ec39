//! Sine and cosine that every processor and device computes alike: polynomials in place of the standard library's.

use std::f32::consts::TAU;

/// Sine and cosine of an angle in turns (1 is a full circle), within 1.5e-7 for `turns` in [0, 1].
#[inline]
pub fn sincos_turns(turns: f32) -> (f32, f32) {
    // Truncation is the floor, as `turns` ≥ 0; the floor itself is a slow call where SSE 4.1 may be absent.
    let quadrant = (turns * 4.0 + 0.5) as i32;
    let quarter = quadrant as f32;
    // The difference is exact: both are multiples of the same power of two and close to each other.
    let x = (turns - quarter * 0.25) * TAU;
    let xx = x * x;
    // Taylor series: for |x| ≤ π/4 the first omitted terms are below 2e-9.
    let sin = x + x * xx * (-1.0 / 6.0 + xx * (1.0 / 120.0 + xx * (-1.0 / 5040.0 + xx * (1.0 / 362_880.0))));
    let tail = 1.0 / 24.0 + xx * (-1.0 / 720.0 + xx * (1.0 / 40_320.0 + xx * (-1.0 / 3_628_800.0)));
    let cos = 1.0 + xx * (-0.5 + xx * tail);
    match quadrant & 3 {
        0 => (sin, cos),
        1 => (cos, -sin),
        2 => (-sin, -cos),
        _ => (-cos, sin),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sine_and_cosine_agree_with_the_library() {
        for step in 0..=100_000 {
            let turns = step as f32 / 100_000.0;
            let (sin, cos) = sincos_turns(turns);
            let (expected_sin, expected_cos) = (f64::from(turns) * std::f64::consts::TAU).sin_cos();
            assert!((f64::from(sin) - expected_sin).abs() < 1.5e-7, "sin {turns}");
            assert!((f64::from(cos) - expected_cos).abs() < 1.5e-7, "cos {turns}");
        }
    }
}
