//! Parallel rays from a plane: an orthographic, and by its view an isometric, projection.

use super::Projection;
use crate::ray::Ray;
use glam::{Vec2, Vec3};

/// Parallel rays made ready for one picture size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Orthographic {
    /// Where the ray of the upper left corner of the picture starts, world space.
    pub corner: Vec3,
    /// Step of one pixel to the right.
    pub pixel_x: Vec3,
    /// Step of one pixel down.
    pub pixel_y: Vec3,
    /// Direction of all rays, a unit vector.
    pub forward: Vec3,
}

impl Projection for Orthographic {
    /// All of `lens` is one place.
    #[inline]
    fn ray(&self, position: Vec2, _lens: Vec2) -> Ray {
        Ray::new(self.corner + self.pixel_x * position.x + self.pixel_y * position.y, self.forward)
    }
}
