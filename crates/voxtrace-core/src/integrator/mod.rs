//! How light is gathered along paths. An integrator is a step function: it takes a path and what its ray met, adds the
//! light found there and says where the path goes next. Who traces the rays, one by one or in waves, is not its business.

pub mod essay;
pub mod path;

use crate::light::Receiver;
use crate::sampler::Sampler;
use glam::{Vec2, Vec3};
use voxtrace_scene::camera::{CameraFrame, Projection};
use voxtrace_scene::ray::Ray;

/// Dimension of the sampler that places the camera ray within its pixel.
pub const DIMENSION_CAMERA: u32 = 0;

/// A path under way, without its ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Path {
    /// Random numbers of this path.
    pub sampler: Sampler,
    /// Surfaces that have scattered the path so far.
    pub bounce: u32,
    /// Share of the light at the path's end that reaches the camera, per channel, over the path's probability.
    pub beta: Vec3,
    /// Density over solid angle of the last bounce; 0 where no other technique finds what the ray meets: after the camera and after mirrors.
    pub pdf: f32,
    /// Unit normal of the surface of the last bounce, world space.
    pub normal: Vec3,
}

/// Light on its way to the camera, unless something lies on the segment of `ray`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShadowRay {
    /// From a surface to a light.
    pub ray: Ray,
    /// What reaches the camera.
    pub radiance: Vec3,
}

impl Path {
    /// The path that leaves the camera through the place `jitter`, in [0, 1) each, of the pixel (`x`, `y`) of the whole
    /// picture (the first two) and of the lens, and its ray before clipping.
    pub fn from_camera(camera: &CameraFrame, x: u32, y: u32, sampler: Sampler, jitter: [f32; 4]) -> (Self, Ray) {
        let [u, v, lens_u, lens_v] = jitter;
        let ray = camera.ray(Vec2::new(x as f32 + u, y as f32 + v), Vec2::new(lens_u, lens_v));
        (Self { sampler, bounce: 0, beta: Vec3::ONE, pdf: 0.0, normal: Vec3::ZERO }, ray)
    }

    /// Dimension of the sampler that chooses how the next surface scatters the path.
    fn dimension_scatter(&self) -> u32 {
        1 + 2 * self.bounce
    }

    /// Dimension of the sampler that chooses the light for the next surface.
    fn dimension_light(&self) -> u32 {
        2 + 2 * self.bounce
    }

    /// The place where the last bounce sent `ray` from.
    fn receiver(&self, ray: &Ray) -> Receiver {
        Receiver { point: ray.origin, normal: self.normal }
    }
}
