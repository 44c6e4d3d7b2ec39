//! The pinhole: all rays start at one point, and straight lines stay straight.

use super::{Axes, Camera, Projection};
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
        let Axes { forward, right, up } = camera.axes();
        let half_height = camera.tan_half_fov();
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
