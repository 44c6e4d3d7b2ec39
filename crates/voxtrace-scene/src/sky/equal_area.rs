//! Directions as places of a square, areas of the square as solid angles: the equal-area octahedral map of Clarberg, "Fast
//! Equal-Area Mapping of the (Hemi)Sphere using SIMD", Journal of Graphics Tools 2008. The upper half of the sphere is the diamond in
//! the middle, the lower one is folded over its sides. Twin of `shaders/equal_area.slang`.

use crate::trigonometry::sincos_turns;
use glam::{Vec2, Vec3};

/// Angle of the point (`x`, `y`), neither below 0, from the x axis, in quarters of a turn, within 1.1e-7; 0 for the origin.
#[inline]
pub fn quarter_turns(x: f32, y: f32) -> f32 {
    let (small, large) = (x.min(y), x.max(y));
    let ratio = if large > 0.0 { small / large } else { 0.0 };
    let s = ratio * ratio;
    // atan(ratio) · 2/π: of least largest error among the odd polynomials of this degree.
    let tail = 0.061_384_156 + s * (-0.035_594_866 + s * (0.013_918_374 + s * -0.002_581_213));
    let turns = ratio * (0.636_619_3 + s * (-0.212_184_48 + s * (0.126_983_78 + s * (-0.088_545_08 + s * tail))));
    if y > x { 1.0 - turns } else { turns }
}

/// The place of a unit vector in the unit square.
#[inline]
pub fn square_of(direction: Vec3) -> Vec2 {
    let size = direction.abs();
    // √(1 − |z|), without the cancellation near the poles.
    let radius = ((size.x * size.x + size.y * size.y) / (1.0 + size.z)).sqrt();
    let v = quarter_turns(size.x, size.y) * radius;
    let u = radius - v;
    let is_below = direction.z < 0.0;
    let (u, v) = (if is_below { 1.0 - v } else { u }, if is_below { 1.0 - u } else { v });
    let u = if direction.x < 0.0 { -u } else { u };
    let v = if direction.y < 0.0 { -v } else { v };
    Vec2::new(u * 0.5 + 0.5, v * 0.5 + 0.5)
}

/// The unit vector of a place in the unit square.
#[inline]
pub fn direction_of(square: Vec2) -> Vec3 {
    let (u, v) = (square.x * 2.0 - 1.0, square.y * 2.0 - 1.0);
    let height = 1.0 - (u.abs() + v.abs());
    let radius = 1.0 - height.abs();
    let turns = if radius > 0.0 { ((v.abs() - u.abs()) / radius + 1.0) * 0.125 } else { 0.0 };
    let (sin, cos) = sincos_turns(turns);
    let across = radius * (2.0 - radius * radius).sqrt();
    let (x, y, z) = (cos * across, sin * across, 1.0 - radius * radius);
    let x = if u < 0.0 { -x } else { x };
    let y = if v < 0.0 { -y } else { y };
    Vec3::new(x, y, if height < 0.0 { -z } else { z })
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec2Swizzles;

    const STEPS: i32 = 300;

    /// The middles of the cells of a grid over the square.
    fn places() -> impl Iterator<Item = Vec2> {
        let at = |step: i32| (step as f32 + 0.5) / STEPS as f32;
        (0..STEPS * STEPS).map(move |step| Vec2::new(at(step % STEPS), at(step / STEPS)))
    }

    #[test]
    fn angles_agree_with_the_library() {
        let error = |quarter_turns: fn(f32, f32) -> f32| {
            let angles = (0..=100_000).map(|step| step as f32 / 100_000.0 * std::f32::consts::FRAC_PI_2);
            let errors = angles.map(|angle| {
                let (y, x) = angle.sin_cos();
                let expected = f64::from(y).atan2(f64::from(x)) * std::f64::consts::FRAC_2_PI;
                (f64::from(quarter_turns(x.max(0.0), y.max(0.0))) - expected).abs()
            });
            errors.fold(0.0, f64::max)
        };
        assert!(error(quarter_turns) < 2e-7, "{}", error(quarter_turns));
        assert!(error(|x, y| quarter_turns(x, y) * 1.000_001) > 2e-7);
        assert_eq!((quarter_turns(0.0, 0.0), quarter_turns(0.0, 2.0)), (0.0, 1.0));
    }

    #[test]
    fn places_become_directions_and_the_same_places_again() {
        let error = |direction_of: fn(Vec2) -> Vec3| {
            let errors = places().map(|place| {
                let direction = direction_of(place);
                assert!((direction.length() - 1.0).abs() < 1e-6, "{place}");
                square_of(direction).distance(place)
            });
            errors.fold(0.0, f32::max)
        };
        assert!(error(direction_of) < 1e-6, "{}", error(direction_of));
        assert!(error(|place| direction_of(place.yx())) > 0.1);
        // The poles, the axes, and the seam of the lower half.
        for (direction, place) in [
            (Vec3::Z, Vec2::splat(0.5)),
            (Vec3::X, Vec2::new(1.0, 0.5)),
            (Vec3::NEG_Y, Vec2::new(0.5, 0.0)),
            (Vec3::NEG_Z, Vec2::ONE),
        ] {
            assert!(square_of(direction).distance(place) < 1e-6, "{direction}: {}", square_of(direction));
        }
    }

    #[test]
    fn equal_areas_are_equal_solid_angles() {
        // Directions of places at equal distances are uniform on the sphere: their coordinates have the moments of that.
        let moments = |direction_of: fn(Vec2) -> Vec3| {
            let sums = places().fold([Vec3::ZERO; 3], |[first, second, fourth], place| {
                let direction = direction_of(place);
                let squared = direction * direction;
                [first + direction, second + squared, fourth + squared * squared]
            });
            sums.map(|sum| sum / (STEPS * STEPS) as f32)
        };
        let is_uniform = |[first, second, fourth]: [Vec3; 3]| {
            first.abs_diff_eq(Vec3::ZERO, 1e-4)
                && second.abs_diff_eq(Vec3::splat(1.0 / 3.0), 1e-4)
                && fourth.abs_diff_eq(Vec3::splat(0.2), 1e-4)
        };
        assert!(is_uniform(moments(direction_of)), "{:?}", moments(direction_of));
        // The octahedral map of Praun and Hoppe, whose areas are not equal.
        let octahedral = |place: Vec2| {
            let (u, v) = (place.x * 2.0 - 1.0, place.y * 2.0 - 1.0);
            let z = 1.0 - u.abs() - v.abs();
            let folded = Vec2::new((1.0 - v.abs()) * u.signum(), (1.0 - u.abs()) * v.signum());
            (if z < 0.0 { folded.extend(z) } else { Vec3::new(u, v, z) }).normalize()
        };
        assert!(!is_uniform(moments(octahedral)));
    }
}
