//! Cameras, in world space (right-handed, z up), and the seam of projections: how a place in the picture becomes a ray. A lens is a variant of
//! [`Lens`], a file of this folder, a variant of [`CameraFrame`] and a twin in `shaders/`.

mod fisheye;
mod flight;
mod handles;
mod lens;
mod orthographic;
mod panorama;
mod perspective;
mod pose;
mod thin_lens;
mod turntable;

use crate::ray::Ray;
pub use fisheye::Fisheye;
pub use flight::Flight;
use glam::{Vec2, Vec3};
pub use handles::Handles;
pub use lens::Lens;
pub use orthographic::Orthographic;
pub use panorama::Panorama;
pub use perspective::Perspective;
pub use thin_lens::ThinLens;

/// The middle of the unit square of lens samples.
const LENS_CENTRE: Vec2 = Vec2::splat(0.5);

/// A named camera.
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
    /// Vertical field of view of a pinhole and of a thin lens, degrees, in (0, 180).
    pub fov_y: f32,
    /// What its lens does.
    pub lens: Lens,
}

/// Directions of a view: unit vectors at right angles, world space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axes {
    /// Into the picture.
    pub forward: Vec3,
    /// To the right of the picture.
    pub right: Vec3,
    /// To the top of the picture.
    pub up: Vec3,
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
    /// A thin lens.
    ThinLens(ThinLens),
    /// Parallel rays.
    Orthographic(Orthographic),
    /// Longitude and latitude.
    Panorama(Panorama),
    /// An equidistant fisheye.
    Fisheye(Fisheye),
}

impl Camera {
    /// A camera at `eye` that looks at `target`, z up, with a vertical field of view of 45 degrees.
    pub fn look_at(eye: Vec3, target: Vec3) -> Self {
        Self { name: "default".into(), eye, target, up: Vec3::Z, fov_y: 45.0, lens: Lens::Pinhole }
    }

    /// The same camera with another lens.
    #[must_use]
    pub fn with_lens(self, lens: Lens) -> Self {
        Self { lens, ..self }
    }

    /// Height of what the picture shows at the camera's target, world units: an orthographic lens with it shows the target as large as a
    /// pinhole does.
    pub fn height_at_target(&self) -> f32 {
        2.0 * self.tan_half_fov() * self.eye.distance(self.target)
    }

    /// Distance along the view at which `point` lies, world units: what is in focus there is sharp.
    pub fn focus_on(&self, point: Vec3) -> f32 {
        (point - self.eye).dot(self.axes().forward)
    }

    /// The camera's frame for pictures of `width` × `height` pixels, computed once for each picture.
    pub fn frame(&self, width: u32, height: u32) -> CameraFrame {
        let (axes, size) = (self.axes(), Vec2::new(width as f32, height as f32));
        match self.lens {
            Lens::Pinhole => CameraFrame::Perspective(Perspective::new(self, width, height)),
            Lens::Thin { aperture, focus, blades, blade_rotation } => {
                let Perspective { eye, corner, pixel_x, pixel_y } = Perspective::new(self, width, height);
                let (sin, cos) = f64::from(blade_rotation).to_radians().sin_cos();
                let (sin, cos) = (aperture * sin as f32, aperture * cos as f32);
                CameraFrame::ThinLens(ThinLens {
                    perspective: Perspective {
                        eye,
                        corner: corner * focus,
                        pixel_x: pixel_x * focus,
                        pixel_y: pixel_y * focus,
                    },
                    lens_x: axes.right * cos + axes.up * sin,
                    lens_y: axes.up * cos - axes.right * sin,
                    blades,
                })
            }
            Lens::Orthographic { view_height } => {
                let (half_height, half_width) = (0.5 * view_height, 0.5 * view_height * size.x / size.y);
                CameraFrame::Orthographic(Orthographic {
                    corner: self.eye - axes.right * half_width + axes.up * half_height,
                    pixel_x: axes.right * (2.0 * half_width / size.x),
                    pixel_y: axes.up * (-2.0 * half_height / size.y),
                    forward: axes.forward,
                })
            }
            Lens::Panorama { eye_distance } => {
                let eyes = if eye_distance > 0.0 { 2.0 } else { 1.0 };
                CameraFrame::Panorama(Panorama {
                    eye: self.eye,
                    axes,
                    inverse_size: Vec2::new(1.0 / size.x, eyes / size.y),
                    half_eye_distance: 0.5 * eye_distance,
                })
            }
            Lens::Fisheye { fisheye_angle } => CameraFrame::Fisheye(Fisheye {
                eye: self.eye,
                axes,
                middle: size * 0.5,
                turns_per_pixel: fisheye_angle / 360.0 / size.y,
            }),
        }
    }

    /// The directions of the view.
    pub fn axes(&self) -> Axes {
        let forward = (self.target - self.eye).normalize_or(Vec3::Y);
        let right = forward.cross(self.up);
        // A view along `up` has no right-hand side of its own: take any.
        let right = right.try_normalize().unwrap_or_else(|| forward.any_orthonormal_vector());
        Axes { forward, right, up: right.cross(forward) }
    }

    fn tan_half_fov(&self) -> f32 {
        f64::from(self.fov_y.to_radians() * 0.5).tan() as f32
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
        self.lens.check()
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
            Self::ThinLens(thin_lens) => thin_lens.ray(position, lens),
            Self::Orthographic(orthographic) => orthographic.ray(position, lens),
            Self::Panorama(panorama) => panorama.ray(position, lens),
            Self::Fisheye(fisheye) => fisheye.ray(position, lens),
        }
    }
}
