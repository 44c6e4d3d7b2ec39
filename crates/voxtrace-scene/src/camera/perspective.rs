//! The pinhole: all rays start at one point, and straight lines stay straight.

use super::{Camera, Projection};
use crate::ray::Ray;
use glam::{Vec2, Vec3};

/// A pinhole made ready for one picture size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Perspective {
    /// Ray origin, world space.
    pub eye: Vec3,
    /// Direction of the upper left corner of the upper left pixel, not normalized.
    pub corner: Vec3,
    /// Step of one pixel to the right.
    pub pixel_x: Vec3,
    /// Step of one pixel down.
    pub pixel_y: Vec3,
}

impl Perspective {
    /// The pinhole of `camera` for pictures of `width` × `height` pixels.
    pub fn new(camera: &Camera, width: u32, height: u32) -> Self {
        let forward = (camera.target - camera.eye).normalize_or(Vec3::Y);
        let right = forward.cross(camera.up);
        // A view along `up` has no right-hand side of its own: take any.
        let right = right.try_normalize().unwrap_or_else(|| forward.any_orthonormal_vector());
        let up = right.cross(forward);
        let half_height = f64::from(camera.fov_y.to_radians() * 0.5).tan() as f32;
        let half_width = half_height * width as f32 / height as f32;
        Self {
            eye: camera.eye,
            corner: forward - right * half_width + up * half_height,
            pixel_x: right * (2.0 * half_width / width as f32),
            pixel_y: up * (-2.0 * half_height / height as f32),
        }
    }
}

impl Projection for Perspective {
    /// A pinhole has one place for all of `lens`.
    #[inline]
    fn ray(&self, position: Vec2, _lens: Vec2) -> Ray {
        let direction = self.corner + self.pixel_x * position.x + self.pixel_y * position.y;
        Ray::new(self.eye, direction * (1.0 / direction.length_squared().sqrt()))
    }
}
