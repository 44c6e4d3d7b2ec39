//! Many rays at once: by the vector instructions that the processor has where one grid is all there is, else ray after ray.

#![expect(unsafe_code, reason = "calls of functions for certain processors")]

#[cfg(target_arch = "x86_64")]
use super::avx512;
use super::groups::Groups;
use super::instructions::Instructions;
use super::local_ray::LocalRay;
use super::simd::{LANES, Portable, Simd};
use super::{cast, exact, occluded, stream};
use crate::packed::{Geometry, PackedGrid, PackedScene};
use glam::IVec3;
use voxtrace_scene::ray::{Hit, Ray};
use voxtrace_scene::transform::Transform;

/// Finds for each ray its first hit. Both slices must have the same length.
pub fn cast_batch(scene: &PackedScene, rays: &[Ray], hits: &mut [Hit]) {
    cast_batch_with(Instructions::chosen(), scene, rays, hits);
}

/// As [`cast_batch`], with the instructions that are named, or ray after ray where the processor has them not.
pub fn cast_batch_with(instructions: Instructions, scene: &PackedScene, rays: &[Ray], hits: &mut [Hit]) {
    assert_eq!(rays.len(), hits.len(), "one hit for each ray");
    if first_hits(scene, instructions, rays, hits) {
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
    if first_hits(scene, Instructions::chosen(), rays, &mut hits) {
        for (hit, blocked) in hits.iter().zip(blocked) {
            *blocked = !hit.is_miss();
        }
        return;
    }
    for (ray, blocked) in rays.iter().zip(blocked) {
        *blocked = occluded(scene, ray);
    }
}

/// Fills `hits` with vector instructions; returns false, with nothing done, where there are none for this scene.
fn first_hits(scene: &PackedScene, instructions: Instructions, rays: &[Ray], hits: &mut [Hit]) -> bool {
    let [instance] = &*scene.placement.instances else { return false };
    let geometry = &*scene.geometry;
    if !instructions.is_available() || !geometry.is_within_gather_reach() {
        return false;
    }
    let batch =
        Batch { geometry, grid: &geometry.grids[instance.grid as usize], from_world: &instance.grid_from_world, rays };
    // SAFETY: the processor has the instructions; packing and opening give valid scenes only.
    unsafe {
        match instructions {
            Instructions::Scalar => return false,
            Instructions::Portable => batch.cast(Portable, Groups::none_of(rays.len()), hits),
            #[cfg(target_arch = "x86_64")]
            Instructions::Avx2 => by_avx2(&batch, hits),
            #[cfg(target_arch = "x86_64")]
            Instructions::Avx512 => by_avx512(&batch, hits),
            #[cfg(not(target_arch = "x86_64"))]
            Instructions::Avx2 | Instructions::Avx512 => return false,
        }
    }
    true
}

/// Rays through the only grid of a valid scene.
struct Batch<'a> {
    geometry: &'a Geometry,
    grid: &'a PackedGrid,
    from_world: &'a Transform,
    rays: &'a [Ray],
}

impl Batch<'_> {
    /// Finds the hits of all rays but of those in groups that are done.
    ///
    /// # Safety
    /// The geometry must be valid.
    #[inline(always)]
    unsafe fn cast<S: Simd>(&self, simd: S, done: Groups, hits: &mut [Hit]) {
        for (group, hits) in hits.chunks_mut(LANES).enumerate() {
            if !done.contains(group) {
                hits.fill(Hit::MISS);
            }
        }
        let mut found = |index: usize, voxel: IVec3| {
            let ray = &self.rays[index];
            let entered = LocalRay::new(ray, self.from_world).map(|local| exact::hit_of(&local, voxel, 0));
            hits[index] = entered.filter(|hit| hit.t <= ray.t_max).unwrap_or(Hit::MISS);
        };
        let grid = (self.geometry, self.grid);
        // SAFETY: the caller's duty.
        unsafe { stream::first_voxels(simd, grid, self.from_world, self.rays, &done, &mut found) };
    }
}

/// # Safety
/// The processor must have the instructions, and the geometry must be valid.
#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,popcnt,bmi1,bmi2,lzcnt")]
unsafe fn by_avx2(batch: &Batch, hits: &mut [Hit]) {
    // SAFETY: the caller's duty.
    unsafe { batch.cast(super::simd::Avx2::assume(), Groups::none_of(batch.rays.len()), hits) };
}

/// # Safety
/// The processor must have the instructions, and the geometry must be valid.
#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx512dq,avx512bw,avx512vl,popcnt,bmi1,bmi2,lzcnt,fma,avx2")]
unsafe fn by_avx512(batch: &Batch, hits: &mut [Hit]) {
    let mut done = Groups::none_of(batch.rays.len());
    // SAFETY: the caller's duty.
    unsafe {
        if *batch.from_world == Transform::IDENTITY {
            avx512::cast(batch.geometry, batch.grid, batch.rays, hits, &mut done);
        }
        batch.cast(super::simd::Avx512::assume(), done, hits);
    }
}
