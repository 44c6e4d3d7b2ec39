//! Many rays at once, by the vector instructions that the processor has, or ray after ray.

#![expect(unsafe_code, reason = "calls of functions for certain processors")]

#[cfg(target_arch = "x86_64")]
use super::avx512;
use super::counts::WalkCounts;
use super::groups::Groups;
use super::instructions::Instructions;
use super::local_ray::turned;
#[cfg(not(all(target_arch = "wasm32", target_os = "unknown", target_feature = "simd128")))]
use super::simd::Portable;
use super::simd::{LANES, Simd};
use super::{axes, cast_whole, occluded, stream};
use crate::cuts;
use crate::packed::{Geometry, PackedGrid, PackedScene, WideTree};
use voxtrace_scene::ray::{Hit, Ray};

/// Finds for each ray its first hit in what cuts keep. Both slices must have the same length.
pub fn cast_batch(scene: &PackedScene, rays: &[Ray], hits: &mut [Hit]) -> WalkCounts {
    match scene.cuts.is_none() {
        true => cast_batch_whole(scene, rays, hits),
        false => cuts::cast_batch(scene, rays, hits, |_| true),
    }
}

/// Finds for each ray its first hit in the whole scene. Both slices must have the same length.
pub fn cast_batch_whole(scene: &PackedScene, rays: &[Ray], hits: &mut [Hit]) -> WalkCounts {
    cast_batch_with(Instructions::chosen(), scene, rays, hits)
}

/// As [`cast_batch_whole`], with the instructions that are named, or ray after ray where the processor has them not.
pub fn cast_batch_with(instructions: Instructions, scene: &PackedScene, rays: &[Ray], hits: &mut [Hit]) -> WalkCounts {
    assert_eq!(rays.len(), hits.len(), "one hit for each ray");
    if let Some(counts) = first_hits(scene, instructions, rays, false, hits) {
        return counts;
    }
    match &*scene.placement.instances {
        [instance] => axes::first_hits(&scene.geometry, instance, rays, hits),
        _ => rays.iter().zip(hits).for_each(|(ray, hit)| *hit = cast_whole(scene, ray)),
    }
    WalkCounts { scalar: rays.len() as u64, ..WalkCounts::default() }
}

/// Finds for each ray whether anything of the whole scene lies on its segment. Both slices must have the same length.
pub fn occluded_batch(scene: &PackedScene, rays: &[Ray], blocked: &mut [bool]) -> WalkCounts {
    occluded_batch_with(Instructions::chosen(), scene, rays, blocked)
}

/// As [`occluded_batch`], with the instructions that are named, or ray after ray where the processor has them not.
pub fn occluded_batch_with(
    instructions: Instructions,
    scene: &PackedScene,
    rays: &[Ray],
    blocked: &mut [bool],
) -> WalkCounts {
    assert_eq!(rays.len(), blocked.len(), "one answer for each ray");
    let mut hits = vec![Hit::MISS; rays.len()];
    if let Some(counts) = first_hits(scene, instructions, rays, true, &mut hits) {
        for (hit, blocked) in hits.iter().zip(blocked) {
            *blocked = !hit.is_miss();
        }
        return counts;
    }
    match &*scene.placement.instances {
        [instance] => {
            axes::first_hits(&scene.geometry, instance, rays, &mut hits);
            blocked.iter_mut().zip(&hits).for_each(|(blocked, hit)| *blocked = !hit.is_miss());
        }
        _ => rays.iter().zip(blocked).for_each(|(ray, blocked)| *blocked = occluded(scene, ray)),
    }
    WalkCounts { scalar: rays.len() as u64, ..WalkCounts::default() }
}

/// Fills `hits` with vector instructions, where `any` hit will do with one that need not be the first; returns `None`, with nothing done,
/// where there are none.
fn first_hits(
    scene: &PackedScene,
    instructions: Instructions,
    rays: &[Ray],
    any: bool,
    hits: &mut [Hit],
) -> Option<WalkCounts> {
    if !instructions.is_available() || instructions == Instructions::Scalar || !scene.geometry.is_within_gather_reach()
    {
        return None;
    }
    let tree = match scene.placement.instances.len() {
        1 => None,
        _ => Some(scene.placement.wide_tree()?),
    };
    let batch = Batch { scene, tree, rays, any };
    // SAFETY: the processor has the instructions; packing and opening give valid scenes only.
    let packets = unsafe {
        match instructions {
            #[cfg(not(all(target_arch = "wasm32", target_os = "unknown", target_feature = "simd128")))]
            Instructions::Portable => batch.cast(Portable, hits, Batch::no_packets),
            #[cfg(target_arch = "x86_64")]
            Instructions::Avx2 => by_avx2(&batch, hits),
            #[cfg(target_arch = "x86_64")]
            Instructions::Avx512 => by_avx512(&batch, hits),
            #[cfg(target_arch = "aarch64")]
            Instructions::Neon => batch.cast(super::simd::Neon, hits, Batch::no_packets),
            #[cfg(target_feature = "simd128")]
            Instructions::Simd128 => batch.cast(super::simd::Simd128, hits, Batch::no_packets),
            // What this build has not is never available.
            #[allow(unreachable_patterns, reason = "all of them where there is only one kind")]
            _ => return None,
        }
    } as u64;
    Some(WalkCounts { packets, streams: rays.len() as u64 - packets, scalar: 0 })
}

/// Rays through a valid scene.
struct Batch<'a> {
    scene: &'a PackedScene,
    /// Over its instances, where it has not one alone.
    tree: Option<&'a WideTree>,
    rays: &'a [Ray],
    /// Whether any hit will do.
    any: bool,
}

impl Batch<'_> {
    /// Finds the hits of all rays. `packets` finds those of some groups of rays in the space of the grid, where there is one alone. Returns how many
    /// rays those are.
    ///
    /// # Safety
    /// The scene must be valid.
    #[inline(always)]
    unsafe fn cast<S: Simd>(
        &self,
        simd: S,
        hits: &mut [Hit],
        packets: impl FnOnce((&Geometry, &PackedGrid), &[Ray], &mut [Hit]) -> Groups,
    ) -> usize {
        let (scene, rays) = (self.scene, self.rays);
        if let Some(tree) = self.tree {
            // SAFETY: the caller's duty.
            unsafe { stream::first_hits(simd, (scene, tree), rays, self.any, hits) };
            return 0;
        }
        let instance = &scene.placement.instances[0];
        let (grid, rays) = (&scene.geometry.grids[instance.grid as usize], &*turned(rays, &instance.grid_from_world));
        let done = packets((&scene.geometry, grid), rays, hits);
        for (group, hits) in hits.chunks_mut(LANES).enumerate() {
            if !done.contains(group) {
                hits.fill(Hit::MISS);
            }
        }
        let grid = (&*scene.geometry, grid);
        // SAFETY: the caller's duty.
        unsafe { stream::first_hits_in_grid(simd, grid, rays, &done, hits) };
        done.count_of(rays.len())
    }

    /// Where there are no instructions for packets.
    fn no_packets(_: (&Geometry, &PackedGrid), rays: &[Ray], _: &mut [Hit]) -> Groups {
        Groups::none_of(rays.len())
    }
}

/// # Safety
/// The processor must have the instructions, and the scene must be valid.
#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma,popcnt,bmi1,bmi2,lzcnt")]
unsafe fn by_avx2(batch: &Batch, hits: &mut [Hit]) -> usize {
    // SAFETY: the caller's duty.
    unsafe { batch.cast(super::simd::Avx2::assume(), hits, Batch::no_packets) }
}

/// # Safety
/// The processor must have the instructions, and the scene must be valid.
#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx512dq,avx512bw,avx512vl,popcnt,bmi1,bmi2,lzcnt,fma,avx2")]
unsafe fn by_avx512(batch: &Batch, hits: &mut [Hit]) -> usize {
    let packets = |(geometry, grid): (&Geometry, &PackedGrid), rays: &[Ray], hits: &mut [Hit]| {
        let mut done = Groups::none_of(rays.len());
        // SAFETY: the caller's duty.
        unsafe { avx512::cast(geometry, grid, rays, hits, &mut done) };
        done
    };
    // SAFETY: the caller's duty.
    unsafe { batch.cast(super::simd::Avx512::assume(), hits, packets) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::{IVec3, Vec3};
    use std::sync::Arc;
    use voxtrace_scene::transform::Transform;
    use voxtrace_scene::{Instance, Material, Scene, VoxelGrid};

    /// What the interpreter for undefined behaviour runs: it knows no vector instructions.
    #[test]
    fn arrays_find_what_ray_after_ray_finds() {
        let mut grid = VoxelGrid::new();
        for i in 0..60 {
            grid.set(IVec3::new(i * 7 % 19, i * 5 % 17, i * 11 % 13), 0);
        }
        let one = Scene::from_grid("one", grid.clone(), vec![Material::default()]);
        let mut two = one.clone();
        let place = Transform { translation: Vec3::new(11.5, 0.25, 3.0), ..Transform::IDENTITY };
        two.grids.push(Arc::new(grid));
        two.instances.push(Instance::new(1, place));
        for scene in [one, two] {
            let packed = PackedScene::pack(&scene).expect("the scene is sound");
            let origin = |i: usize| Vec3::new(-3.0, (i * 3 % 17) as f32 + 0.25, (i % 13) as f32 + 0.75);
            let direction = |i: usize| Vec3::new(1.0, (i % 7) as f32 * 0.1 - 0.3, (i % 5) as f32 * 0.1 - 0.2);
            let rays: Vec<Ray> = (0..210).map(|i| Ray::new(origin(i), direction(i))).collect();
            let expected: Vec<Hit> = rays.iter().map(|ray| cast_whole(&packed, ray)).collect();
            assert!(expected.iter().any(|hit| !hit.is_miss()) && expected.iter().any(Hit::is_miss));
            // Longer than what is prepared at a time, and than what is under way together.
            for count in [0, 1, 40, 70, 140, rays.len()] {
                // What nobody writes is noticed.
                let mut hits = vec![Hit { t: -1.0, ..Hit::MISS }; count];
                cast_batch_with(Instructions::Portable, &packed, &rays[..count], &mut hits);
                assert_eq!(hits, expected[..count], "{count} rays");
            }
        }
    }
}
