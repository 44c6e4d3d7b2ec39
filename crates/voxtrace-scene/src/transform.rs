//! Placement of a grid in the world: rotation, mirror, uniform scale and translation.

use bytemuck::{Pod, Zeroable};
use glam::{Mat3, Vec3};

/// An affine map `p ↦ linear · p + translation` whose linear part is a rotation or mirrored rotation times a uniform
/// scale.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Transform {
    /// Rotation, mirror and scale.
    pub linear: Mat3,
    /// Image of the origin.
    pub translation: Vec3,
}

impl Transform {
    /// The map that changes nothing.
    pub const IDENTITY: Self = Self { linear: Mat3::IDENTITY, translation: Vec3::ZERO };

    /// A translation.
    pub fn from_translation(translation: Vec3) -> Self {
        Self { linear: Mat3::IDENTITY, translation }
    }

    /// Image of a point.
    pub fn point(&self, point: Vec3) -> Vec3 {
        self.linear * point + self.translation
    }

    /// Image of a direction; its length changes by the scale.
    pub fn direction(&self, direction: Vec3) -> Vec3 {
        self.linear * direction
    }

    /// The uniform scale, > 0.
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
