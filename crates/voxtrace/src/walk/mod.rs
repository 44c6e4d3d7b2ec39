//! Finding the first voxel along a ray, exactly.
//!
//! A ray is a path of cells: it starts in the voxel that holds its first point and crosses one grid plane after the
//! other, in order of the ray parameter t, at equal t first x, then y, then z. So the path never squeezes between two
//! voxels that share an edge. [`scalar`] follows that path in leaps over empty boxes: f32 arithmetic decides
//! almost always, and where it comes too near to a plane to be sure, [`exact`] decides in f64. `t` and the face of a
//! hit come from [`exact::hit_of`] alone, whatever found the voxel.

mod exact;
mod instances;
mod local_ray;
mod scalar;

pub use instances::{cast, occluded};
pub use local_ray::LocalRay;
pub use scalar::first_voxel;

use crate::packed::PackedScene;
use crate::ray::{Hit, Ray};

/// Finds for each ray its first hit. Both slices must have the same length.
pub fn cast_batch(scene: &PackedScene, rays: &[Ray], hits: &mut [Hit]) {
    assert_eq!(rays.len(), hits.len(), "one hit for each ray");
    for (ray, hit) in rays.iter().zip(hits) {
        *hit = cast(scene, ray);
    }
}

/// Finds for each ray whether anything lies on its segment. Both slices must have the same length.
pub fn occluded_batch(scene: &PackedScene, rays: &[Ray], blocked: &mut [bool]) {
    assert_eq!(rays.len(), blocked.len(), "one answer for each ray");
    for (ray, blocked) in rays.iter().zip(blocked) {
        *blocked = occluded(scene, ray);
    }
}
