//! Algorithm 1 of the study "Ray Tracing Voxels with Hardware Acceleration in Real-Time" (2024): colours multiply along a
//! path of cosine-weighted bounces, and the first emitter or the sky ends it. No light is sampled, and
//! all random numbers are independent.

use super::Path;
use crate::light::emitted;
use crate::math::cosine_hemisphere;
use crate::packed::PackedScene;
use crate::surface::Surface;
use glam::Vec3;
use voxtrace_scene::ray::{Hit, Ray};

/// Start of every ray's range in the study.
pub const T_MIN: f32 = 0.1;
/// End of every ray's range in the study.
pub const T_MAX: f32 = 10_000.0;

/// Clips a ray to the study's range.
pub fn clip(ray: Ray) -> Ray {
    Ray { t_min: T_MIN, t_max: T_MAX, ..ray }
}

/// Adds to `radiance` the light where `ray` ended. Returns the path's next ray, `None` where the path ends: at an
/// emitter, in the sky, or, black, at the surface after `max_bounces` others. The study has 4 rays, so 3 bounces. `material` is
/// `Path::material`, `draw` draws the independent random numbers of `Path::dimension_scatter`.
pub fn advance(
    scene: &PackedScene,
    max_bounces: u32,
    path: &mut Path,
    (ray, hit, material): (&Ray, &Hit, u32),
    draw: impl FnOnce(&Path) -> [f32; 4],
    radiance: &mut Vec3,
) -> Option<Ray> {
    if hit.is_miss() {
        *radiance += path.beta * scene.sky.radiance(ray.direction);
        return None;
    }
    let material = &scene.materials()[material as usize];
    if material.emission.max_element() > 0.0 {
        *radiance += path.beta * emitted(scene, material);
        return None;
    }
    if path.bounce == max_bounces {
        return None;
    }
    let [u, v, ..] = draw(path);
    let mut surface = Surface::new(scene, ray, hit);
    surface.smooth(scene, ray, hit, true);
    path.is_clipped = scene.cuts.clips_after(hit);
    path.beta *= material.base_color;
    path.bounce += 1;
    path.event += 1;
    Some(clip(Ray::new(surface.origin, surface.world_direction(cosine_hemisphere(u, v)))))
}
