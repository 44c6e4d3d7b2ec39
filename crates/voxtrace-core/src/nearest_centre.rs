//! The study's approximate method, emulated on the CPU: of all candidate boxes the voxel whose centre is nearest to the ray's origin
//! wins, without an intersection test. Hardware may report boxes that the ray misses by a little (false candidates); here `margin`
//! is how much larger the boxes are. `docs/approximation.md` shows when the method is exact and when it fails.

use crate::packed::PackedScene;
use crate::walk;
use glam::Vec3;
use voxtrace_scene::ray::{Hit, Ray};

/// Finds for each ray the voxel with the nearest centre among those whose box, `margin` world units larger on every side, the ray
/// intersects. Both slices must have the same length. Where the ray misses the voxel itself, t and face are those of a displaced ray.
///
/// Candidates are the hits of the ray and of eight copies of it, displaced by ± the margin along all axes. A box within the margin is
/// hit by one of them, unless it lies behind another box that all of them hit.
pub fn cast_batch(scene: &PackedScene, rays: &[Ray], margin: f32, hits: &mut [Hit]) {
    assert_eq!(rays.len(), hits.len(), "one hit for each ray");
    walk::cast_batch(scene, rays, hits);
    if margin <= 0.0 {
        return;
    }
    let mut beside = vec![Hit::MISS; rays.len()];
    for corner in 0..8 {
        let sign = |bit: i32| if corner >> bit & 1 == 1 { margin } else { -margin };
        let offset = Vec3::new(sign(0), sign(1), sign(2));
        let displaced: Vec<Ray> = rays.iter().map(|ray| Ray { origin: ray.origin + offset, ..*ray }).collect();
        walk::cast_batch(scene, &displaced, &mut beside);
        for ((ray, hit), other) in rays.iter().zip(hits.iter_mut()).zip(&beside) {
            let is_other = !other.is_miss() && (other.voxel, other.instance) != (hit.voxel, hit.instance);
            if is_other && centre_distance(scene, ray, other) < centre_distance(scene, ray, hit) {
                *hit = *other;
            }
        }
    }
}

/// Distance from a ray's origin to the centre of the voxel that it hit, world units; infinite for a miss.
pub fn centre_distance(scene: &PackedScene, ray: &Ray, hit: &Hit) -> f64 {
    if hit.is_miss() {
        return f64::INFINITY;
    }
    let world_from_grid = &scene.placement.instances[hit.instance as usize].world_from_grid;
    let middle = world_from_grid.point(hit.voxel.as_vec3() + 0.5);
    (middle.as_dvec3() - ray.origin.as_dvec3()).length()
}
