//! Cameras, in world space (right-handed, z up), and the seam of projections: how a place in the picture becomes a ray. A lens is a file of
//! this folder, a variant of [`CameraFrame`] and a twin in `shaders/`.

mod flight;
mod perspective;
mod turntable;

use crate::ray::Ray;
pub use flight::Flight;
use glam::{Vec2, Vec3};
pub use perspective::Perspective;

/// The middle of the unit square of lens samples.
const LENS_CENTRE: Vec2 = Vec2::splat(0.5);

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

/// How a place in the picture becomes a ray.
pub trait Projection {
    /// The ray through `position`, in pixels from the upper left corner, and through the place `lens`, uniform in [0, 1)², of the lens,
    /// whose centre is (0.5, 0.5). Its direction has unit length.
    fn ray(&self, position: Vec2, lens: Vec2) -> Ray;
}

/// A camera made ready for one picture size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CameraFrame {
    /// A pinhole.
    Perspective(Perspective),
}

impl Camera {
    /// A camera at `eye` that looks at `target`, z up, with a vertical field of view of 45 degrees.
    pub fn look_at(eye: Vec3, target: Vec3) -> Self {
        Self { name: "default".into(), eye, target, up: Vec3::Z, fov_y: 45.0 }
    }

    /// The camera's frame for pictures of `width` × `height` pixels, computed once for each picture.
    pub fn frame(&self, width: u32, height: u32) -> CameraFrame {
        CameraFrame::Perspective(Perspective::new(self, width, height))
    }

    /// Checks that the camera can send rays.
    ///
    /// # Errors
    /// Says what is wrong: coordinates that are not finite, an angle out of range.
    pub fn check(&self) -> Result<(), &'static str> {
        if !(self.eye.is_finite() && self.target.is_finite() && self.up.is_finite()) {
            return Err("the camera is not finite");
        }
        if !(self.fov_y > 0.0 && self.fov_y < 180.0) {
            return Err("the field of view is not between 0 and 180 degrees");
        }
        Ok(())
    }
}

impl CameraFrame {
    /// The ray through `position`, in pixels from the upper left corner, and through the middle of the lens.
    #[inline]
    pub fn central_ray(&self, position: Vec2) -> Ray {
        self.ray(position, LENS_CENTRE)
    }
}

impl Projection for CameraFrame {
    #[inline]
    fn ray(&self, position: Vec2, lens: Vec2) -> Ray {
        match self {
            Self::Perspective(perspective) => perspective.ray(position, lens),
        }
    }
}
