//! All directions by longitude and latitude, for one eye or two.

use super::{Axes, Projection};
use crate::ray::Ray;
use crate::trigonometry::sincos_turns;
use glam::{Vec2, Vec3};

/// An equirectangular picture of one size made ready.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Panorama {
    /// Middle between the eyes, world space.
    pub eye: Vec3,
    /// Directions of the view.
    pub axes: Axes,
    /// One over the width of the picture, and over the height of one eye's picture, pixels.
    pub inverse_size: Vec2,
    /// Half the distance of the eyes, 0 for one eye.
    pub half_eye_distance: f32,
}

impl Projection for Panorama {
    /// All of `lens` is one place.
    #[inline]
    fn ray(&self, position: Vec2, _lens: Vec2) -> Ray {
        let Axes { forward, right, up } = self.axes;
        let latitude = position.y * self.inverse_size.y;
        // The picture of the right eye lies below that of the left one.
        let is_right_eye = latitude >= 1.0;
        let side = if is_right_eye { self.half_eye_distance } else { -self.half_eye_distance };
        let latitude = if is_right_eye { latitude - 1.0 } else { latitude };
        let (sin, cos) = sincos_turns(position.x * self.inverse_size.x);
        let (across, upwards) = sincos_turns(latitude * 0.5);
        let horizontal = -(forward * cos + right * sin);
        let direction = horizontal * across + up * upwards;
        let origin = self.eye + (forward * sin - right * cos) * side;
        Ray::new(origin, direction * (1.0 / direction.length_squared().sqrt()))
    }
}
