//! Rotations by + − × ÷ √ and our own sine alone.

use crate::trigonometry::sincos_turns;
use glam::{DQuat, DVec3};

/// Halvings of an arc: a part of it in 2⁴⁰.
const HALVINGS: u32 = 40;

/// The rotation by some turns (1 is a full circle) about an axis, counter-clockwise seen from its positive end. No axis: none.
pub fn rotation(axis: DVec3, turns: f64) -> DQuat {
    let Some(axis) = axis.try_normalize() else { return DQuat::IDENTITY };
    let half = (turns - turns.floor()) * 0.5;
    let (sin, cos) = sincos_turns(half as f32);
    DQuat::from_xyzw(axis.x * f64::from(sin), axis.y * f64::from(sin), axis.z * f64::from(sin), f64::from(cos))
        .normalize()
}

/// Spherical interpolation between two rotations, the shorter way, by halving the arc between them.
pub fn slerp(from: DQuat, to: DQuat, share: f64) -> DQuat {
    let (mut low, mut high) = (from, if from.dot(to) < 0.0 { -to } else { to });
    if share <= 0.0 || share >= 1.0 {
        return if share <= 0.0 { from } else { to };
    }
    let (mut start, mut end) = (0.0, 1.0);
    for _ in 0..HALVINGS {
        let (middle, half) = ((low + high).normalize(), 0.5 * (start + end));
        if share < half {
            (high, end) = (middle, half);
        } else {
            (low, start) = (middle, half);
        }
    }
    low
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn halving_an_arc_is_spherical_interpolation() {
        let one = rotation(DVec3::new(1.0, 2.0, -0.5), 0.1);
        let other = rotation(DVec3::new(-1.0, 0.3, 0.5), 0.45);
        for (from, to) in [(one, other), (one, -other), (other, one), (one, one)] {
            for step in 0..=16 {
                let share = f64::from(step) / 16.0;
                let (ours, library) = (slerp(from, to, share), from.slerp(to, share));
                assert!(ours.dot(library).abs() > 1.0 - 1e-12, "{share}: {ours} {library}");
            }
        }
        assert!(
            slerp(one, other, 0.5).dot(one.slerp(other, 0.6)).abs() < 1.0 - 1e-6,
            "the comparison sees another share"
        );
    }

    #[test]
    fn turns_are_those_of_the_library() {
        for turns in [-1.3, -0.25, 0.0, 0.1, 0.5, 2.75] {
            let expected = DQuat::from_axis_angle(DVec3::Z, turns * std::f64::consts::TAU);
            assert!(rotation(DVec3::Z * 3.0, turns).dot(expected).abs() > 1.0 - 1e-9, "{turns}");
        }
        assert_eq!(rotation(DVec3::ZERO, 0.3), DQuat::IDENTITY);
    }
}
