//! What of a light reaches a place through media. Rays to lights are straight: media whose index of refraction is that around them let them
//! pass, boundaries that refract block them, and the light behind those is found by paths.

use super::{Inside, attenuation, unscattered};
use crate::cuts;
use crate::packed::PackedScene;
use crate::surface::behind_face;
use glam::Vec3;
use voxtrace_scene::ray::Ray;

/// Most boundaries on the way to a light.
pub const MAX_BOUNDARIES: u32 = 64;

/// What of `light` comes along the segment of `ray` from its end to its origin, which lies in `inside` or in air. `is_clipped` says whether
/// what is cut away is in its way.
pub fn transmitted(scene: &PackedScene, ray: &Ray, inside: Option<Inside>, light: Vec3, is_clipped: bool) -> Vec3 {
    let (mut ray, mut inside, mut light) = (*ray, inside, light);
    for _ in 0..MAX_BOUNDARIES {
        let hit = match &inside {
            Some(inside) => {
                let hit = cuts::cast_inside(scene, &ray, inside, is_clipped);
                light *= share_of_segment(scene, &ray, inside, hit.t.min(ray.t_max));
                hit
            }
            None => cuts::cast(scene, &ray, is_clipped),
        };
        if hit.is_miss() {
            return light;
        }
        let beyond = Inside::beyond(scene, &hit);
        light *= share_of_boundary(scene, inside.as_ref(), beyond.as_ref());
        if light.max_element() <= 0.0 {
            return Vec3::ZERO;
        }
        ray = Ray { t_max: ray.t_max - hit.t, ..Ray::new(behind_face(scene, &ray, &hit), ray.direction) };
        inside = beyond;
    }
    Vec3::ZERO
}

/// Share of light that is neither absorbed nor scattered from the ray's origin to `t`.
#[inline]
pub fn share_of_segment(scene: &PackedScene, ray: &Ray, inside: &Inside, t: f32) -> Vec3 {
    let medium = inside.medium(scene);
    let voxels = t * inside.voxels_per_t(scene, ray);
    attenuation(medium, voxels) * unscattered(medium, voxels)
}

/// Share of light that passes straight from one medium into another; `None` is air.
#[inline]
pub fn share_of_boundary(scene: &PackedScene, near: Option<&Inside>, far: Option<&Inside>) -> f32 {
    let ior = |inside: Option<&Inside>| inside.map_or(1.0, |inside| inside.medium(scene).ior);
    if ior(near) != ior(far) {
        return 0.0;
    }
    far.map_or(1.0, |far| far.medium(scene).transmission * (1.0 - far.medium(scene).metallic))
}
