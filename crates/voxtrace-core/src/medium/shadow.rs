//! What of a light reaches a place through media. Rays to lights are straight: media whose index of refraction is that around them let them
//! pass, boundaries that refract block them, and the light behind those is found by paths. Where a frame asks for clear shadows
//! ([`crate::Frame::clear_shadows`]), smooth boundaries let pass what they do not reflect.

use super::{Inside, attenuation, unscattered};
use crate::bsdf::{Microfacets, above, straight_reflectance};
use crate::packed::PackedScene;
use crate::surface::{Surface, behind_face};
use glam::Vec3;
use voxtrace_scene::ray::{Hit, Ray};

/// Most boundaries on the way to a light.
pub const MAX_BOUNDARIES: u32 = 64;

/// Light on its way from the end of a ray's segment to its origin, which lies in `inside` or in air.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transit {
    /// What is left of the way.
    pub ray: Ray,
    /// The voxel in which it begins, `None` in air.
    pub inside: Option<Inside>,
    /// What of the light comes along as far as is known.
    pub light: Vec3,
    /// Whether what is cut away is not in its way.
    pub is_clipped: bool,
}

impl Transit {
    /// Takes it past what its ray met; `is_clear` says whether it passes clear glass. False where nothing is in the way any more, or no light is left.
    #[inline]
    pub fn advance(&mut self, scene: &PackedScene, hit: &Hit, is_clear: bool) -> bool {
        if let Some(inside) = &self.inside {
            self.light *= share_of_segment(scene, &self.ray, inside, hit.t.min(self.ray.t_max));
        }
        if hit.is_miss() {
            return false;
        }
        let beyond = Inside::beyond(scene, hit);
        self.light *= share_of_boundary(scene, (&self.ray, hit), self.inside.as_ref(), beyond.as_ref(), is_clear);
        if self.light.max_element() <= 0.0 {
            self.light = Vec3::ZERO;
            return false;
        }
        self.ray = rest_of(&self.ray, hit.t, behind_face(scene, &self.ray, hit));
        self.inside = beyond;
        true
    }
}

/// The rest of a ray from `t` on, which begins at `origin`, a little beside it: to the same end where it has one, or a lamp's own face, a margin behind
/// the end, would be in the way.
#[inline]
fn rest_of(ray: &Ray, t: f32, origin: Vec3) -> Ray {
    let left = ray.t_max - t;
    if !(left > 0.0 && left < f32::INFINITY) {
        return Ray { t_max: left, ..Ray::new(origin, ray.direction) };
    }
    let way = ray.at(ray.t_max) - origin;
    Ray { t_max: left, ..Ray::new(origin, Vec3::new(way.x / left, way.y / left, way.z / left)) }
}

/// Share of light that is neither absorbed nor scattered from the ray's origin to `t`.
#[inline]
pub fn share_of_segment(scene: &PackedScene, ray: &Ray, inside: &Inside, t: f32) -> Vec3 {
    let medium = inside.medium(scene);
    let voxels = t * inside.voxels_per_t(scene, ray);
    attenuation(medium, voxels) * unscattered(medium, voxels)
}

/// Share of light that passes straight from one medium into another, through the face that `ray` met; `None` is air. Where `is_clear`, smooth
/// boundaries that refract let pass what they do not reflect.
#[inline]
pub fn share_of_boundary(
    scene: &PackedScene,
    (ray, hit): (&Ray, &Hit),
    near: Option<&Inside>,
    far: Option<&Inside>,
    is_clear: bool,
) -> f32 {
    let ior = |inside: Option<&Inside>| inside.map_or(1.0, |inside| inside.medium(scene).ior);
    let mut share = 1.0;
    if ior(near) != ior(far) {
        // Leaving for air, the surface is that of what is left.
        let Some(surface_of) = far.or(near).filter(|_| is_clear) else { return 0.0 };
        if !Microfacets::of(surface_of.medium(scene).roughness).is_smooth() {
            return 0.0;
        }
        let cos = above(Surface::new(scene, ray, hit).local_direction(-ray.direction)).z;
        share = 1.0 - straight_reflectance(cos, ior(far) / ior(near));
    }
    share * far.map_or(1.0, |far| far.medium(scene).transmission * (1.0 - far.medium(scene).metallic))
}
