//! Placement of a grid in the world: rotation, mirror, uniform scale and translation.

use bytemuck::{Pod, Zeroable};
use glam::{Mat3, Quat, Vec3};

/// An affine map `p ↦ linear · p + translation` whose linear part is a rotation or mirrored rotation times a uniform
/// scale.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Transform {
    /// Rotation, mirror and scale; its columns are the images of the axes.
    pub linear: Mat3,
    /// Image of the origin.
    pub translation: Vec3,
}

/// A coordinate axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// x.
    X,
    /// y.
    Y,
    /// z, upwards.
    Z,
}

impl Transform {
    /// The map that changes nothing.
    pub const IDENTITY: Self = Self { linear: Mat3::IDENTITY, translation: Vec3::ZERO };

    /// A translation.
    pub fn from_translation(translation: Vec3) -> Self {
        Self { linear: Mat3::IDENTITY, translation }
    }

    /// A rotation about the origin by a unit quaternion.
    pub fn from_rotation(rotation: Quat) -> Self {
        Self { linear: Mat3::from_quat(rotation), translation: Vec3::ZERO }
    }

    /// `turns` quarter turns about an axis through the origin, counter-clockwise seen from the axis' positive end. The matrix
    /// holds only −1, 0 and 1, so that voxels stay on the lattice.
    pub fn from_quarter_turns(axis: Axis, turns: i32) -> Self {
        let quarter = match axis {
            Axis::X => Mat3::from_cols(Vec3::X, Vec3::Z, Vec3::NEG_Y),
            Axis::Y => Mat3::from_cols(Vec3::NEG_Z, Vec3::Y, Vec3::X),
            Axis::Z => Mat3::from_cols(Vec3::Y, Vec3::NEG_X, Vec3::Z),
        };
        let linear = (0..turns.rem_euclid(4)).fold(Mat3::IDENTITY, |turned, _| quarter * turned);
        Self { linear, translation: Vec3::ZERO }
    }

    /// This transform followed by a translation.
    #[must_use]
    pub fn translated(self, by: Vec3) -> Self {
        Self { translation: self.translation + by, ..self }
    }

    /// This transform followed by a uniform scale about the origin, `factor` > 0.
    #[must_use]
    pub fn scaled(self, factor: f32) -> Self {
        Self { linear: self.linear * factor, translation: self.translation * factor }
    }

    /// Image of a point.
    #[inline]
    pub fn point(&self, point: Vec3) -> Vec3 {
        self.linear * point + self.translation
    }

    /// Image of a direction; its length changes by the scale.
    #[inline]
    pub fn direction(&self, direction: Vec3) -> Vec3 {
        self.linear * direction
    }

    /// The uniform scale, > 0.
    #[inline]
    pub fn scale(&self) -> f32 {
        self.linear.x_axis.length()
    }

    /// The map that undoes this one: the linear part transposed over the squared scale, so that quarter turns and
    /// mirrors invert exactly.
    pub fn inverse(&self) -> Self {
        let linear = self.linear.transpose() * (1.0 / self.linear.x_axis.length_squared());
        Self { linear, translation: -(linear * self.translation) }
    }

    /// `self` after `first`.
    pub fn after(&self, first: &Self) -> Self {
        Self { linear: self.linear * first.linear, translation: self.point(first.translation) }
    }

    /// Whether all numbers are finite and the linear part is a uniformly scaled rotation or mirror, to 1e-4 of its
    /// scale.
    pub fn is_similarity(&self) -> bool {
        let square = self.linear.transpose() * self.linear;
        let scale = square.x_axis.x;
        let expected = Mat3::from_diagonal(Vec3::splat(scale));
        self.translation.is_finite() && scale.is_normal() && square.abs_diff_eq(expected, 1e-4 * scale)
    }
}

impl Default for Transform {
    fn default() -> Self {
        Self::IDENTITY
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f32::consts::FRAC_PI_2;

    #[test]
    fn quarter_turns_are_rotations_without_rounding() {
        for (axis, about) in [(Axis::X, Vec3::X), (Axis::Y, Vec3::Y), (Axis::Z, Vec3::Z)] {
            for turns in -5..=5 {
                let exact = Transform::from_quarter_turns(axis, turns);
                let angle = turns as f32 * FRAC_PI_2;
                let rounded = Transform::from_rotation(Quat::from_axis_angle(about, angle));
                assert!(exact.linear.abs_diff_eq(rounded.linear, 1e-5), "{axis:?} {turns}");
                assert!(exact.linear.to_cols_array().iter().all(|value| value.fract() == 0.0), "{axis:?} {turns}");
                assert_eq!(exact.linear.determinant(), 1.0);
                // One quarter more is another rotation: the comparison sees it.
                let more = Transform::from_quarter_turns(axis, turns + 1);
                assert!(!more.linear.abs_diff_eq(rounded.linear, 1e-5));
            }
        }
    }

    #[test]
    fn a_translation_and_a_scale_come_after_what_stood_before() {
        let turned = Transform::from_quarter_turns(Axis::Z, 1).translated(Vec3::new(10.0, 0.0, 0.0)).scaled(2.0);
        assert_eq!(turned.point(Vec3::X), Vec3::new(20.0, 2.0, 0.0));
        assert_eq!(turned.inverse().point(Vec3::new(20.0, 2.0, 0.0)), Vec3::X);
        assert_eq!(turned.scale(), 2.0);
    }
}
