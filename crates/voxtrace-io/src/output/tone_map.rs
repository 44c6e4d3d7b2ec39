//! From linear scene radiance to the sRGB signal of a screen. The default operator follows the idea of AgX (T. Sobotka,
//! 2022): compress the gamut towards grey, an s-shaped curve over the logarithm of each channel, and expand again, so
//! that bright colours turn to white the way film does it instead of to pure primaries.
//! `docs/decisions/0001-tone-mapping.md` says why it is the default.

use glam::{DVec3, Vec3};
use std::sync::LazyLock;
use voxtrace_scene::material::encode_srgb;

/// How a film becomes visible: an exposure and an operator.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ToneMap {
    /// The curve.
    pub operator: Operator,
    /// Exposure in stops: the radiance is multiplied by 2 to this power.
    pub exposure: f32,
}

/// The curve from radiance to signal.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Operator {
    /// An s-curve over 16.5 stops with film-like highlights: for scenes with lamps, windows and deep shadow.
    #[default]
    Agx,
    /// Base colours stay as they are up to 0.8, only highlights are compressed: for product-like pictures of models.
    Neutral,
    /// Reinhard's `L / (1 + L)` on luminance.
    Reinhard,
    /// No curve: what is brighter than 1 is clipped. For measuring.
    Linear,
}

impl Operator {
    /// All operators, in the order of the documentation.
    pub const ALL: [Self; 4] = [Self::Agx, Self::Neutral, Self::Reinhard, Self::Linear];

    /// Name on the command line and in files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Agx => "agx",
            Self::Neutral => "neutral",
            Self::Reinhard => "reinhard",
            Self::Linear => "linear",
        }
    }
}

impl Default for ToneMap {
    fn default() -> Self {
        Self { operator: Operator::default(), exposure: 0.0 }
    }
}

impl ToneMap {
    /// The sRGB signal, each channel in [0, 1], of a linear radiance. What is not a number becomes black.
    pub fn signal(&self, radiance: Vec3) -> DVec3 {
        // f64 throughout: library functions of different systems differ in the last bit, and here that stays far below
        // what rounding to 16 bits can see.
        let exposed = exposed(radiance, self.gain());
        let display = match self.operator {
            Operator::Agx => agx(exposed, agx_curve),
            Operator::Neutral => neutral(exposed),
            Operator::Reinhard => exposed / (1.0 + exposed.dot(LUMINANCE)),
            Operator::Linear => exposed,
        };
        display.map(encode_srgb)
    }

    /// The signal as bytes; of many pixels [`super::ToneBytes`] gives the same sooner.
    pub fn bytes(&self, radiance: Vec3) -> [u8; 3] {
        self.signal(radiance).to_array().map(|value| (value * 255.0).round() as u8)
    }

    /// The factor on the radiance.
    pub(super) fn gain(&self) -> f64 {
        f64::from(self.exposure).exp2()
    }
}

/// What is shown of a radiance: finite, not negative, and black where it is not a number.
pub(super) fn exposed(radiance: Vec3, gain: f64) -> DVec3 {
    let exposed = radiance.as_dvec3().max(DVec3::ZERO) * gain;
    DVec3::select(exposed.is_nan_mask(), DVec3::ZERO, exposed).min(DVec3::splat(1e30))
}

/// Luminance of linear Rec. 709.
pub(super) const LUMINANCE: DVec3 = DVec3::new(0.2126, 0.7152, 0.0722);

/// Share by which colours move towards grey before the curve, and away from it after.
const GREY_BEFORE: f64 = 0.20;
const GREY_AFTER: f64 = 0.17;
/// Stops below and above middle grey that the curve covers.
const STOPS_BELOW: f64 = 10.0;
const STOPS_ABOVE: f64 = 6.5;
const MIDDLE_GREY: f64 = 0.18;
/// Slope of the curve at middle grey.
const SLOPE: f64 = 3.0;
/// Bend of the curve's dark and bright ends: the larger, the longer it stays straight.
const BEND_DARK: f64 = 1.4;
const BEND_BRIGHT: f64 = 2.5;
/// The curve yields a signal of this power law.
const GAMMA: f64 = 2.2;

/// The operator, around a curve of the light of each channel.
pub(super) fn agx(linear: DVec3, curve: impl Fn(f64) -> f64) -> DVec3 {
    let grey = |color: DVec3| DVec3::splat(color.element_sum() / 3.0);
    let inset = linear.lerp(grey(linear), GREY_BEFORE);
    let curved = inset.map(curve);
    // The inverse of a lerp towards grey, which keeps grey where it is.
    ((curved - grey(curved) * GREY_AFTER) / (1.0 - GREY_AFTER)).clamp(DVec3::ZERO, DVec3::ONE)
}

/// The curve of AgX: of the light of a channel, what a screen is to show.
pub(super) fn agx_curve(light: f64) -> f64 {
    let stops = (light.max(1e-10) / MIDDLE_GREY).log2();
    s_curve(((stops + STOPS_BELOW) / (STOPS_BELOW + STOPS_ABOVE)).clamp(0.0, 1.0)).powf(GAMMA)
}

/// The s-curve's parameters below and above its pivot.
static SIDES: LazyLock<[Side; 2]> = LazyLock::new(|| {
    let (pivot_x, pivot_y) = (STOPS_BELOW / (STOPS_BELOW + STOPS_ABOVE), MIDDLE_GREY.powf(1.0 / GAMMA));
    let side = |room_x: f64, room_y: f64, sign: f64, bend: f64| {
        let reach = SLOPE * room_x;
        let scale = reach / ((reach / room_y).powf(bend) - 1.0).powf(1.0 / bend);
        Side { pivot_x, pivot_y, sign, scale, bend }
    };
    [side(pivot_x, pivot_y, -1.0, BEND_DARK), side(1.0 - pivot_x, 1.0 - pivot_y, 1.0, BEND_BRIGHT)]
});

/// One side of the s-curve.
struct Side {
    pivot_x: f64,
    pivot_y: f64,
    sign: f64,
    scale: f64,
    bend: f64,
}

/// Maps [0, 1] onto [0, 1], steepest in the pivot (middle grey), with ends `u / (1 + uᵖ)^(1/p)` that are scaled so that
/// they reach 0 and 1 exactly.
fn s_curve(x: f64) -> f64 {
    let [dark, bright] = &*SIDES;
    let Side { pivot_x, pivot_y, sign, scale, bend } = if x < dark.pivot_x { dark } else { bright };
    let u = SLOPE * (x - pivot_x).abs() / scale;
    // The dark end is 0 but for rounding, and powers of less are no numbers.
    (pivot_y + sign * scale * u / (1.0 + u.powf(*bend)).powf(1.0 / bend)).max(0.0)
}

/// The Khronos PBR Neutral tone mapper (Khronos 3D Commerce working group, 2024, specification 1.0).
pub(super) fn neutral(linear: DVec3) -> DVec3 {
    const START: f64 = 0.8 - 0.04;
    const DESATURATION: f64 = 0.15;
    let least = linear.min_element();
    let offset = if least < 0.08 { least - 6.25 * least * least } else { 0.04 };
    let color = linear - offset;
    let peak = color.max_element();
    if peak < START {
        return color;
    }
    let room = 1.0 - START;
    let new_peak = 1.0 - room * room / (peak + room - START);
    let grey = 1.0 - 1.0 / (DESATURATION * (peak - new_peak) + 1.0);
    (color * (new_peak / peak)).lerp(DVec3::splat(new_peak), grey)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn map(operator: Operator) -> ToneMap {
        ToneMap { operator, exposure: 0.0 }
    }

    #[test]
    fn every_operator_is_monotonic_on_grey_from_black_towards_white() {
        for operator in Operator::ALL {
            let signal = |stops: f64| map(operator).signal(Vec3::splat(stops.exp2() as f32));
            let curve: Vec<_> = (-160..=80).map(|i| signal(f64::from(i) / 8.0)).collect();
            assert!(curve.windows(2).all(|pair| pair[1].cmpge(pair[0]).all()), "{operator:?}");
            assert!(curve[0].max_element() < 0.01, "{operator:?}");
            assert!(curve[240].min_element() > 0.99, "{operator:?}");
        }
    }

    #[test]
    fn grey_stays_grey_and_hues_keep_their_order() {
        for operator in Operator::ALL {
            for value in [0.01_f32, 0.18, 1.0, 7.0] {
                let grey = map(operator).signal(Vec3::splat(value));
                assert!((grey.max_element() - grey.min_element()).abs() < 1e-12, "{operator:?}");
                let warm = map(operator).signal(Vec3::new(1.0, 0.6, 0.2) * value);
                assert!(warm.x >= warm.y && warm.y >= warm.z, "{operator:?} {value}");
            }
        }
    }

    #[test]
    fn middle_grey_stays_middle_grey_under_agx() {
        let signal = map(Operator::Agx).signal(Vec3::splat(0.18)).x;
        assert!((signal - encode_srgb(0.18)).abs() < 1e-3, "{signal}");
    }

    #[test]
    fn a_channel_without_light_does_not_darken_the_others() {
        for operator in Operator::ALL {
            let pure = map(operator).signal(Vec3::new(0.004, 0.0, 0.0));
            let mixed = map(operator).signal(Vec3::new(0.004, 0.0004, 0.0004));
            assert!(pure.x > 2.5 / 255.0 && pure.x > 0.7 * mixed.x, "{operator:?}: {pure} {mixed}");
        }
    }

    #[test]
    fn the_s_curve_is_continuous_and_reaches_both_ends() {
        assert!(s_curve(0.0).abs() < 1e-12 && (s_curve(1.0) - 1.0).abs() < 1e-12);
        let pivot = STOPS_BELOW / (STOPS_BELOW + STOPS_ABOVE);
        let slope = |from: f64, to: f64| (s_curve(to) - s_curve(from)) / (to - from);
        assert!((slope(pivot - 1e-6, pivot) - SLOPE).abs() < 0.01);
        assert!((slope(pivot, pivot + 1e-6) - SLOPE).abs() < 0.01);
    }

    #[test]
    fn a_bright_coloured_lamp_turns_white_under_agx_but_not_when_clipped() {
        let lamp = Vec3::new(1.0, 0.3, 0.05) * 60.0;
        assert!(map(Operator::Agx).signal(lamp).min_element() > 0.75);
        assert!(map(Operator::Agx).signal(lamp / 60.0).z < 0.5);
    }

    #[test]
    fn the_neutral_operator_keeps_base_colours_and_compresses_highlights() {
        // A saturated colour below 0.8 passes but for the small offset of its darkest channel.
        let color = Vec3::new(0.7, 0.3, 0.0);
        let passed = map(Operator::Neutral).signal(color);
        let expected = map(Operator::Linear).signal(color);
        assert!((passed - expected).abs().max_element() < 1e-6);
        let bright = map(Operator::Neutral).signal(Vec3::splat(4.0)).x;
        assert!(bright > 0.9 && bright < 1.0);
    }

    #[test]
    fn one_stop_of_exposure_doubles_the_light() {
        let color = Vec3::new(0.1, 0.2, 0.3);
        for operator in Operator::ALL {
            let brighter = ToneMap { operator, exposure: 1.0 }.signal(color);
            assert_eq!(brighter, map(operator).signal(color * 2.0));
            assert_ne!(brighter, map(operator).signal(color));
        }
    }

    #[test]
    fn what_is_not_a_number_or_endless_gives_a_signal_in_range() {
        for operator in Operator::ALL {
            for value in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, -1.0, f32::MAX] {
                let signal = ToneMap { operator, exposure: 20.0 }.signal(Vec3::new(value, 0.5, 0.0));
                assert!(signal.cmpge(DVec3::ZERO).all() && signal.cmple(DVec3::ONE).all(), "{operator:?} {value}");
            }
        }
    }
}
