//! Many rays at once: the widest walk that the processor has where one grid is all there is, else ray after ray.

use super::{cast, occluded};
use crate::packed::PackedScene;
use voxtrace_scene::ray::{Hit, Ray};

/// Finds for each ray its first hit. Both slices must have the same length.
pub fn cast_batch(scene: &PackedScene, rays: &[Ray], hits: &mut [Hit]) {
    assert_eq!(rays.len(), hits.len(), "one hit for each ray");
    if first_hits(scene, rays, hits) {
        return;
    }
    for (ray, hit) in rays.iter().zip(hits) {
        *hit = cast(scene, ray);
    }
}

/// Finds for each ray whether anything lies on its segment. Both slices must have the same length.
pub fn occluded_batch(scene: &PackedScene, rays: &[Ray], blocked: &mut [bool]) {
    assert_eq!(rays.len(), blocked.len(), "one answer for each ray");
    let mut hits = vec![Hit::MISS; rays.len()];
    if first_hits(scene, rays, &mut hits) {
        for (hit, blocked) in hits.iter().zip(blocked) {
            *blocked = !hit.is_miss();
        }
        return;
    }
    for (ray, blocked) in rays.iter().zip(blocked) {
        *blocked = occluded(scene, ray);
    }
}

/// Name of the instructions that batches use on this machine.
pub fn simd_name() -> &'static str {
    #[cfg(target_arch = "x86_64")]
    if super::avx512::is_available() {
        return "AVX-512";
    }
    "scalar"
}

/// Fills `hits` with vector instructions; returns false, with nothing done, where there are none for this scene.
#[cfg(target_arch = "x86_64")]
fn first_hits(scene: &PackedScene, rays: &[Ray], hits: &mut [Hit]) -> bool {
    use super::avx512;
    let [instance] = &*scene.placement.instances else { return false };
    let geometry = &*scene.geometry;
    if !avx512::is_available() || !geometry.is_within_gather_reach() {
        return false;
    }
    let grid = &geometry.grids[instance.grid as usize];
    #[expect(unsafe_code, reason = "vector instructions")]
    // SAFETY: the processor has the instructions; packing and opening give valid scenes only.
    unsafe {
        avx512::first_hits(geometry, grid, &instance.grid_from_world, rays, hits);
    }
    true
}

#[cfg(not(target_arch = "x86_64"))]
fn first_hits(_: &PackedScene, _: &[Ray], _: &mut [Hit]) -> bool {
    false
}
