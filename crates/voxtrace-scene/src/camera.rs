//! The pinhole camera, in world space (right-handed, z up).

use crate::ray::Ray;
use glam::{Vec2, Vec3};

/// A named pinhole camera.
#[derive(Clone, Debug, PartialEq)]
pub struct Camera {
    /// Name for the command line, for example `default` or `altar`.
    pub name: String,
    /// Position, world units.
    pub eye: Vec3,
    /// Point in the middle of the picture, world units.
    pub target: Vec3,
    /// Direction that points upwards in the picture; need not be a unit vector nor at right angles to the view.
    pub up: Vec3,
    /// Vertical field of view, degrees, in (0, 180).
    pub fov_y: f32,
}

impl Camera {
    /// A camera at `eye` that looks at `target`, z up, with a vertical field of view of 45 degrees.
    pub fn look_at(eye: Vec3, target: Vec3) -> Self {
        Self { name: "default".into(), eye, target, up: Vec3::Z, fov_y: 45.0 }
    }

    /// The camera's frame for pictures of `width` × `height` pixels, computed once for each picture.
    pub fn frame(&self, width: u32, height: u32) -> CameraFrame {
        let forward = (self.target - self.eye).normalize_or(Vec3::Y);
        let right = forward.cross(self.up);
        // A view along `up` has no right-hand side of its own: take any.
        let right = right.try_normalize().unwrap_or_else(|| forward.any_orthonormal_vector());
        let up = right.cross(forward);
        let half_height = f64::from(self.fov_y.to_radians() * 0.5).tan() as f32;
        let half_width = half_height * width as f32 / height as f32;
        CameraFrame {
            eye: self.eye,
            corner: forward - right * half_width + up * half_height,
            pixel_x: right * (2.0 * half_width / width as f32),
            pixel_y: up * (-2.0 * half_height / height as f32),
        }
    }
}

/// A camera made ready for one picture size: `corner` points at the upper left corner of the picture, `pixel_x` and
/// `pixel_y` step one pixel to the right and down.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CameraFrame {
    /// Ray origin, world space.
    pub eye: Vec3,
    /// Direction of the upper left corner of the upper left pixel, not normalized.
    pub corner: Vec3,
    /// Step of one pixel to the right.
    pub pixel_x: Vec3,
    /// Step of one pixel down.
    pub pixel_y: Vec3,
}

impl CameraFrame {
    /// The ray through `position`, in pixels from the upper left corner; its direction has unit length.
    pub fn ray(&self, position: Vec2) -> Ray {
        let direction = self.corner + self.pixel_x * position.x + self.pixel_y * position.y;
        Ray::new(self.eye, direction * (1.0 / direction.length_squared().sqrt()))
    }
}
