//! The walk with AVX-512: the same steps as [`super::scalar`], sixteen rays at once. Steps that are too near to a plane
//! go to [`super::exact`], as there, so the voxels are the same.
//!
//! Sixteen neighbours in the batch that start at one point, as camera rays do, are a packet: `coherent` finds packets,
//! `beam` takes four of them through the empty space before them, `packet` takes them to their voxels with what `cells`
//! remembers, `hits` makes their hits. All other rays go through `stream`, a ray a lane in any order, with gathers in
//! `kernel`.

#![expect(clippy::needless_range_loop, reason = "an axis or a lane indexes several arrays")]
#![expect(unsafe_code, reason = "vector loads and gathers, and calls of functions for certain processors")]

mod beam;
mod cells;
mod coherent;
mod hits;
mod kernel;
mod octant;
mod packet;
mod records;
mod shared;
mod stream;
mod vectors;

use super::exact;
use super::local_ray::LocalRay;
use crate::packed::{Geometry, PackedGrid};
use vectors::LANES;
use voxtrace_scene::ray::{Hit, Ray};
use voxtrace_scene::transform::Transform;

/// Whether this processor has what [`first_hits`] needs.
pub(super) fn is_available() -> bool {
    is_x86_feature_detected!("avx512f")
        && is_x86_feature_detected!("avx512dq")
        && is_x86_feature_detected!("avx512bw")
        && is_x86_feature_detected!("avx512vl")
}

/// Finds the hit of each ray with the only instance of a scene. Both slices have the same length.
///
/// # Safety
/// The processor must have what [`is_available`] asks for, and `geometry` must be valid as [`Geometry::validate`] says.
#[target_feature(enable = "avx512f,avx512dq,avx512bw,avx512vl,popcnt,bmi1,bmi2,lzcnt,fma,avx2")]
pub(super) unsafe fn first_hits(
    geometry: &Geometry,
    grid: &PackedGrid,
    grid_from_world: &Transform,
    rays: &[Ray],
    hits: &mut [Hit],
) {
    let mut done = Groups::none_of(rays.len());
    if *grid_from_world == Transform::IDENTITY {
        // SAFETY: the caller's duty.
        unsafe { coherent::cast(geometry, grid, rays, hits, &mut done) };
    }
    for (group, hits) in hits.chunks_mut(LANES).enumerate() {
        if !done.contains(group) {
            hits.fill(Hit::MISS);
        }
    }
    let mut found = |index: usize, voxel| {
        let ray = &rays[index];
        let entered = LocalRay::new(ray, grid_from_world).map(|local| exact::hit_of(&local, voxel, 0));
        hits[index] = entered.filter(|hit| hit.t <= ray.t_max).unwrap_or(Hit::MISS);
    };
    // SAFETY: the caller's duty.
    unsafe { stream::first_voxels(geometry, grid, grid_from_world, rays, &done, &mut found) };
}

/// A set of groups of sixteen rays that follow each other.
struct Groups(Vec<u64>);

impl Groups {
    /// The empty set of the groups of so many rays.
    fn none_of(rays: usize) -> Self {
        Self(vec![0; rays.div_ceil(LANES * 64)])
    }

    fn insert(&mut self, group: usize) {
        self.0[group / 64] |= 1 << (group % 64);
    }

    #[inline(always)]
    fn contains(&self, group: usize) -> bool {
        self.0[group / 64] >> (group % 64) & 1 == 1
    }
}
