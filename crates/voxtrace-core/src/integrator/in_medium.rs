//! The way of a path within a medium: how far it goes, what is absorbed, and what the medium adds.

use super::Path;
use crate::cuts::cast_inside;
use crate::medium::{Inside, attenuation, emitting_length, free_path};
use crate::packed::PackedScene;
use glam::Vec3;
use voxtrace_scene::ray::{Hit, Ray};

/// What the ray of a path inside of a medium meets: where it leaves the medium, or a miss where it is scattered before, whose `voxel` is the
/// one where that happens.
pub fn cast_in_medium(scene: &PackedScene, path: &Path, inside: &Inside, ray: &Ray) -> Hit {
    cast_inside(scene, &unscattered_part(scene, path, inside, ray), inside, path.is_clipped)
}

/// The ray of a path inside of a medium up to where it is scattered.
pub fn unscattered_part(scene: &PackedScene, path: &Path, inside: &Inside, ray: &Ray) -> Ray {
    Ray { t_max: scattering_t(scene, path, inside, ray), ..*ray }
}

/// Where on its ray the path is scattered, if it gets there; infinite in clear media.
pub(super) fn scattering_t(scene: &PackedScene, path: &Path, inside: &Inside, ray: &Ray) -> f32 {
    let [u, ..] = path.sampler.independent(path.dimension_medium());
    free_path(inside.medium(scene), u) / inside.voxels_per_t(scene, ray)
}

impl Path {
    /// Light of the medium itself from the ray's origin to `t`, where it emits `intensity` times its material's emission: on average, over the
    /// places where the path may be scattered, that of the whole medium.
    #[inline]
    pub(super) fn glow(&self, scene: &PackedScene, intensity: f32, inside: &Inside, ray: &Ray, t: f32) -> Vec3 {
        let medium = inside.medium(scene);
        if medium.emission.max_element() <= 0.0 || !medium.is_without_surface() {
            return Vec3::ZERO;
        }
        self.beta * (medium.emission * intensity) * emitting_length(medium, t * inside.voxels_per_t(scene, ray))
    }

    /// Takes away what the medium absorbs from the ray's origin to `t`.
    pub fn absorb(&mut self, scene: &PackedScene, inside: &Inside, ray: &Ray, t: f32) {
        self.beta *= attenuation(inside.medium(scene), t * inside.voxels_per_t(scene, ray));
    }
}
