//! What a screen shows of a radiance, in bytes: those that rounding the signal gives, sooner. Curves are read from tables; what these leave
//! too close to the middle between two bytes is computed in full, so that no byte differs.

use super::tone_map::{self, LUMINANCE, Operator, ToneMap};
use glam::{DVec3, Vec3};
use std::sync::LazyLock;
use voxtrace_scene::material::encode_srgb;

/// Bits of the mantissa that number the cells of a table: so many cells an octave, as a power of two.
const CELL_BITS: u32 = 9;
/// Bits of a double's mantissa.
const MANTISSA_BITS: u32 = 52;
/// Values between two bytes that may be rounded either way: how far from the middle, in bytes. Tables err by a quarter of that at most.
const DOUBT: f64 = 1.0 / 128.0;

/// A function of positive numbers, linear within cells, of which each octave has as many.
struct Table {
    /// Bits, sign, exponent and number of the cell, of the first cell.
    first: u64,
    /// Values at the lower ends of cells, and at the upper end of the last one.
    values: Vec<f32>,
}

impl Table {
    /// For arguments from the power of two `low` to `high`; those outside have the values of the ends.
    fn new(low: f64, high: f64, function: impl Fn(f64) -> f64) -> Self {
        let cell = |value: f64| value.to_bits() >> (MANTISSA_BITS - CELL_BITS);
        let first = cell(low);
        let at = |cell: u64| f64::from_bits(cell << (MANTISSA_BITS - CELL_BITS));
        Self { first, values: (first..=cell(high) + 1).map(|cell| function(at(cell)) as f32).collect() }
    }

    fn at(&self, value: f64) -> f64 {
        const SHARE: u64 = (1 << (MANTISSA_BITS - CELL_BITS)) - 1;
        let bits = value.to_bits();
        let Some(cell) = (bits >> (MANTISSA_BITS - CELL_BITS)).checked_sub(self.first) else {
            return f64::from(self.values[0]);
        };
        let Some([low, high]) = self.values.get(cell as usize..).and_then(|rest| rest.first_chunk::<2>()) else {
            return f64::from(self.values[self.values.len() - 1]);
        };
        let share = (bits & SHARE) as f64 * (1.0 / (SHARE + 1) as f64);
        let (low, high) = (f64::from(*low), f64::from(*high));
        low + (high - low) * share
    }
}

/// The s-curve of AgX and its power law, of the light of a channel; below the first cell it is 0.
static CURVE: LazyLock<Table> = LazyLock::new(|| Table::new(1.0 / 8192.0, 32.0, tone_map::agx_curve));
/// The signal of sRGB in bytes, of linear light above `STRAIGHT`.
static SIGNAL: LazyLock<Table> = LazyLock::new(|| Table::new(STRAIGHT, 1.0, |linear| 255.0 * encode_srgb(linear)));
/// Up to here the signal of sRGB is straight, but for a little.
const STRAIGHT: f64 = 1.0 / 256.0;

/// A tone map for many pixels that become bytes.
#[derive(Clone, Copy)]
pub struct ToneBytes {
    map: ToneMap,
    gain: f64,
    curve: &'static Table,
    signal: &'static Table,
}

impl ToneBytes {
    /// For pictures by this tone map.
    pub fn new(map: ToneMap) -> Self {
        Self { map, gain: map.gain(), curve: &CURVE, signal: &SIGNAL }
    }

    /// Red, green and blue of sRGB for a linear radiance: 255 times its signal, rounded.
    pub fn of(&self, radiance: Vec3) -> [u8; 3] {
        self.of_within(radiance, DOUBT)
    }

    /// The same where `doubt` bytes around the middle between two of them are not trusted to tables.
    #[inline]
    fn of_within(&self, radiance: Vec3, doubt: f64) -> [u8; 3] {
        let near = self.near(radiance);
        let floor = near.floor();
        if ((near - floor - 0.5).abs().min_element()) < doubt {
            return self.map.bytes(radiance);
        }
        near.to_array().map(|value| (value + 0.5) as u8)
    }

    /// The signal in bytes, as far as tables say it.
    #[inline]
    fn near(&self, radiance: Vec3) -> DVec3 {
        let exposed = tone_map::exposed(radiance, self.gain);
        let display = match self.map.operator {
            Operator::Agx => tone_map::agx(exposed, |light| self.curve.at(light)),
            Operator::Neutral => tone_map::neutral(exposed),
            Operator::Reinhard => exposed / (1.0 + exposed.dot(LUMINANCE)),
            Operator::Linear => exposed,
        };
        display.map(|linear| {
            let linear = linear.clamp(0.0, 1.0);
            if linear <= STRAIGHT { 255.0 * encode_srgb(linear) } else { self.signal.at(linear) }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Radiance in all corners: grey, pure and mixed colours over 40 stops, and what is no light.
    fn radiances() -> impl Iterator<Item = Vec3> {
        let colors =
            [[1.0, 1.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.2], [0.3, 0.01, 1.0], [0.9, 0.7, 0.5], [1.0, 0.3, 0.05]];
        let steps = (0..40_000).map(|step| ((step as f32 + 0.37) / 1000.0 - 24.0).exp2());
        let lights = steps.flat_map(move |light| colors.map(|color| Vec3::from_array(color) * light));
        let odd = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, -1.0, 0.0, -0.0, f32::MIN_POSITIVE, f32::MAX, 1e-40];
        lights.chain(odd.into_iter().flat_map(|odd| [Vec3::splat(odd), Vec3::new(odd, 0.5, 0.0)]))
    }

    fn maps() -> impl Iterator<Item = ToneMap> {
        Operator::ALL.into_iter().flat_map(|operator| [0.0, -1.7, 3.0].map(|exposure| ToneMap { operator, exposure }))
    }

    #[test]
    fn bytes_are_those_that_rounding_the_signal_gives() {
        let mut differ = 0;
        for map in maps() {
            let tone = ToneBytes::new(map);
            for radiance in radiances() {
                let expected = map.bytes(radiance);
                assert_eq!(tone.of(radiance), expected, "{map:?} {radiance}");
                differ += usize::from(tone.of_within(radiance, 0.0) != expected);
            }
        }
        assert!(differ > 0, "tables alone give other bytes somewhere: what is close is computed in full");
    }

    #[test]
    fn tables_err_by_a_quarter_of_what_is_not_trusted_to_them() {
        for map in maps() {
            let tone = ToneBytes::new(map);
            let error = |radiance: Vec3| (tone.near(radiance) - map.signal(radiance) * 255.0).abs().max_element();
            let (most, at) =
                radiances().map(|radiance| (error(radiance), radiance)).max_by(|a, b| a.0.total_cmp(&b.0)).unwrap();
            assert!(most < DOUBT / 4.0, "{map:?}: {most} at {at}");
        }
    }
}
