//! How light is gathered along paths. An integrator is a step function: it takes a path and what its ray met, adds the
//! light found there and says where the path goes next. Who traces the rays, one by one or in waves, is not its business.

pub mod essay;
mod in_medium;
pub mod path;
pub mod seen;

pub use in_medium::{cast_in_medium, unscattered_part};

use crate::light::Receiver;
use crate::medium::Inside;
use crate::packed::PackedScene;
use crate::sampler::Sampler;
use glam::{Vec2, Vec3};
use voxtrace_scene::camera::{CameraFrame, Projection};
use voxtrace_scene::ray::{Hit, Ray};

/// Dimension of the sampler that places the camera ray within its pixel.
pub const DIMENSION_CAMERA: u32 = 0;

/// First dimension of the sampler for ways in media.
const DIMENSION_MEDIA: u32 = 1 << 31;

/// A path under way, without its ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Path {
    /// Random numbers of this path.
    pub sampler: Sampler,
    /// Times that the path was scattered so far. Boundaries of media that it only passed do not count.
    pub bounce: u32,
    /// Random choices that the path made so far: `bounce`, and the boundaries that it passed.
    pub event: u32,
    /// Bounces of each kind that is limited, as [`crate::BounceLimits::to_bits`] has them.
    pub kinds: u32,
    /// Bounces since, and with, the first that was no mirror's and no clear glass's: light is direct where there is at most one.
    pub scattered: u32,
    /// Share of the light at the path's end that reaches the camera, per channel, over the path's probability.
    pub beta: Vec3,
    /// Density over solid angle of the last bounce; 0 where no other technique finds what the ray meets: after the camera and after mirrors.
    pub pdf: f32,
    /// Unit normal of the surface of the last bounce, world space; 0 where a medium scattered the path.
    pub normal: Vec3,
    /// How far before its ray's origin the last bounce was, in units of t: boundaries that do not refract are passed on one line.
    pub passed_t: f32,
    /// The voxel that the path is in, `None` in air.
    pub inside: Option<Inside>,
    /// Whether the path's next ray, and that to a light, see only what cuts keep.
    pub is_clipped: bool,
}

/// Light on its way to the camera, unless something lies on the segment of `ray`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShadowRay {
    /// From a surface to a light.
    pub ray: Ray,
    /// The voxel in which it starts, `None` in air.
    pub inside: Option<Inside>,
    /// Whether it sees only what cuts keep.
    pub is_clipped: bool,
    /// What reaches the camera.
    pub radiance: Vec3,
}

impl Path {
    /// The path that leaves the camera through the place `jitter`, in [0, 1) each, of the pixel (`x`, `y`) of the whole
    /// picture (the first two) and of the lens, and its ray before clipping.
    pub fn from_camera(camera: &CameraFrame, x: u32, y: u32, sampler: Sampler, jitter: [f32; 4]) -> (Self, Ray) {
        (Self::from_sampler(sampler), Self::camera_ray(camera, x, y, jitter))
    }

    /// The ray of such a path.
    #[inline(always)]
    pub(crate) fn camera_ray(camera: &impl Projection, x: u32, y: u32, jitter: [f32; 4]) -> Ray {
        let [u, v, lens_u, lens_v] = jitter;
        camera.ray(Vec2::new(x as f32 + u, y as f32 + v), Vec2::new(lens_u, lens_v))
    }

    /// A path that begins in air.
    #[inline]
    pub fn from_sampler(sampler: Sampler) -> Self {
        let (beta, normal) = (Vec3::ONE, Vec3::ZERO);
        Self {
            sampler,
            bounce: 0,
            event: 0,
            kinds: 0,
            scattered: 0,
            beta,
            pdf: 0.0,
            normal,
            passed_t: 0.0,
            inside: None,
            is_clipped: true,
        }
    }

    /// The same path, where the scene has media: it begins in the one around the first point of its ray.
    pub fn in_medium(self, scene: &PackedScene, ray: &Ray) -> Self {
        let point = ray.at(ray.t_min);
        Self { inside: scene.medium_at(point).filter(|_| scene.cuts.keeps(point)), ..self }
    }

    /// Index of the material of what the path met in air; 0, which nobody asks for, where it met nothing or is in a medium.
    #[inline]
    pub fn material(&self, scene: &PackedScene, hit: &Hit) -> u32 {
        if self.meets_surface(hit) { scene.packed_material_index(hit) } else { 0 }
    }

    /// Whether the path comes through air to a surface.
    #[inline]
    pub(crate) fn meets_surface(&self, hit: &Hit) -> bool {
        self.inside.is_none() && !hit.is_miss()
    }

    /// Whether the path still is the camera's ray, which boundaries that do not refract let pass: surfaces leave it their normal, media a density.
    #[inline]
    fn is_straight(&self) -> bool {
        self.bounce == 0 && self.pdf == 0.0 && self.normal == Vec3::ZERO
    }

    /// The random numbers by which the next surface scatters a path of the integrator `path`.
    #[inline]
    pub fn scatter_numbers(&self) -> [f32; 4] {
        self.sampler.stratified(self.dimension_scatter())
    }

    /// Dimension of the sampler that chooses how the next surface scatters the path.
    pub(crate) fn dimension_scatter(&self) -> u32 {
        1 + 2 * self.event
    }

    /// Dimension of the sampler that chooses the light for the next surface.
    pub fn dimension_light(&self) -> u32 {
        2 + 2 * self.event
    }

    /// Dimension of the sampler that chooses how far the path goes in a medium.
    fn dimension_medium(&self) -> u32 {
        DIMENSION_MEDIA + self.event
    }

    /// The place where the last bounce sent `ray` from.
    fn receiver(&self, ray: &Ray) -> Receiver {
        let point = if self.passed_t > 0.0 { ray.at(-self.passed_t) } else { ray.origin };
        Receiver {
            point,
            normal: self.normal,
            slack: if self.normal == Vec3::ZERO { Receiver::ALL_AROUND } else { 0.0 },
        }
    }
}
