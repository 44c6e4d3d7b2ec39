//! The equidistant fisheye: the angle to the view grows with the distance from the middle of the picture.

use super::{Axes, Projection};
use crate::ray::Ray;
use crate::trigonometry::sincos_turns;
use glam::{Vec2, Vec3};

/// A fisheye made ready for one picture size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fisheye {
    /// Origin of the rays, world space.
    pub eye: Vec3,
    /// Directions of the view.
    pub axes: Axes,
    /// Middle of the picture, pixels.
    pub middle: Vec2,
    /// Angle to the view of one pixel, turns.
    pub turns_per_pixel: f32,
}

impl Projection for Fisheye {
    /// All of `lens` is one place.
    #[inline]
    fn ray(&self, position: Vec2, _lens: Vec2) -> Ray {
        let Axes { forward, right, up } = self.axes;
        let (x, y) = (position.x - self.middle.x, position.y - self.middle.y);
        let radius = (x * x + y * y).sqrt();
        // Corners beyond a full turn show what lies ahead again.
        let (sin, cos) = sincos_turns((radius * self.turns_per_pixel).min(1.0));
        let scale = if radius > 0.0 { sin / radius } else { 0.0 };
        let direction = forward * cos + right * (x * scale) - up * (y * scale);
        Ray::new(self.eye, direction * (1.0 / direction.length_squared().sqrt()))
    }
}
