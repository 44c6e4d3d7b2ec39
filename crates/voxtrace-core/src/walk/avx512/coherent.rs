//! Finds packets in a batch and casts them, four at a time where they agree.

use super::beam::{BEAMS, End, Slopes, follow, minor_axes};
use super::cells::Map;
use super::hits::Hits;
use super::packet::{Packet, step};
use super::records::{load_rays, store_hits};
use super::shared::Shared;
use super::vectors::{LANES, Mask};
use crate::packed::{Geometry, PackedGrid};
use crate::walk::groups::Groups;
use crate::walk::local_ray::MAX_ORIGIN;
use glam::Vec3;
use std::arch::x86_64::*;
use voxtrace_scene::ray::{Hit, Ray};

/// Casts all groups of sixteen rays that start at one point, writes their hits and adds them to `done`. The rays are in
/// the space of the grid.
///
/// # Safety
/// The processor must have the instructions, and the scene must be valid.
#[target_feature(enable = "avx512f,avx512dq,avx512bw,avx512vl,popcnt,bmi1,bmi2,lzcnt,fma,avx2")]
pub unsafe fn cast(geometry: &Geometry, grid: &PackedGrid, rays: &[Ray], hits: &mut [Hit], done: &mut Groups) {
    let Some(map) = Map::new(geometry, grid) else { return };
    let (rays, _) = rays.as_chunks::<LANES>();
    let (hits, _) = hits.as_chunks_mut::<LANES>();
    let mut packets = [Packet::EMPTY; BEAMS];
    for (bundle, (rays, hits)) in rays.chunks(BEAMS).zip(hits.chunks_mut(BEAMS)).enumerate() {
        let mut groups = [None; BEAMS];
        for (slot, rays) in rays.iter().enumerate() {
            groups[slot] = Group::load(rays, &mut packets[slot]);
            if groups[slot].is_some() {
                done.insert(bundle * BEAMS + slot);
            }
        }
        // SAFETY: the caller's duty.
        unsafe {
            match groups {
                [Some(group), ..] if group.octant().is_some() && groups.iter().all(|other| *other == groups[0]) => {
                    cast_bundle(&map, &group, &mut packets, hits);
                }
                _ => {
                    for (slot, group) in groups.iter().enumerate() {
                        if let Some(group) = group {
                            cast_group(&map, group, &mut packets, slot, &mut hits[slot]);
                        }
                    }
                }
            }
        }
    }
}

/// What sixteen rays from one point have in common.
#[derive(Clone, Copy, PartialEq)]
struct Group {
    origin: Vec3,
    /// The axis along which the first ray moves fastest.
    main: usize,
    /// Lanes that move along the negative direction of each axis.
    negative: [Mask; 3],
}

impl Group {
    /// Loads rays into a packet. `None` where they do not start at one point or need special care: that do not start at t = 0
    /// or move along an axis not at all, or at no sensible speed.
    #[inline]
    #[target_feature(enable = "avx512f,avx512dq,avx512bw,avx512vl,popcnt,bmi1,bmi2,lzcnt,fma,avx2")]
    fn load(rays: &[Ray; LANES], packet: &mut Packet) -> Option<Self> {
        let Ray { origin, direction, .. } = rays[0];
        if origin != rays[1].origin || !origin.abs().cmple(Vec3::splat(MAX_ORIGIN)).all() {
            return None;
        }
        let [x, y, z, t_min, dx, dy, dz, t_max] = load_rays(rays);
        let mut good = _mm512_testn_epi32_mask(_mm512_castps_si512(t_min), _mm512_set1_epi32(-1));
        good = _mm512_mask_cmp_ps_mask::<_CMP_GE_OQ>(good, t_max, _mm512_setzero_ps());
        let mut negative = [0; 3];
        for (axis, (start, direction)) in [(x, dx), (y, dy), (z, dz)].into_iter().enumerate() {
            good = _mm512_mask_cmp_ps_mask::<_CMP_EQ_OQ>(good, start, _mm512_set1_ps(origin[axis]));
            // Speeds between 1e-18 and 1e18 along every axis satisfy all that `LocalRay::new` asks of them.
            let speed = _mm512_abs_ps(direction);
            good = _mm512_mask_cmp_ps_mask::<_CMP_GE_OQ>(good, speed, _mm512_set1_ps(1e-18));
            good = _mm512_mask_cmp_ps_mask::<_CMP_LE_OQ>(good, speed, _mm512_set1_ps(1e18));
            negative[axis] = _mm512_movepi32_mask(_mm512_castps_si512(direction));
        }
        if good != 0xffff {
            return None;
        }
        packet.set_rays([dx, dy, dz], t_max);
        Some(Self { origin, main: direction.abs().max_position(), negative })
    }

    /// The octant of all lanes, if there is one.
    #[inline]
    fn octant(&self) -> Option<usize> {
        self.negative.iter().all(|&lanes| lanes == 0 || lanes == 0xffff).then(|| self.octant_of(0))
    }

    fn octant_of(&self, lane: u32) -> usize {
        (0..3).fold(0, |octant, axis| octant | usize::from(self.negative[axis] >> lane & 1) << axis)
    }

    /// The lanes of an octant.
    fn lanes(&self, octant: usize) -> Mask {
        (0..3).fold(0xffff, |lanes, axis| {
            lanes & if octant >> axis & 1 == 1 { self.negative[axis] } else { !self.negative[axis] }
        })
    }
}

/// Casts packets that agree in everything.
#[target_feature(enable = "avx512f,avx512dq,avx512bw,avx512vl,popcnt,bmi1,bmi2,lzcnt,fma,avx2")]
unsafe fn cast_bundle(map: &Map, group: &Group, packets: &mut [Packet; BEAMS], hits: &mut [[Hit; LANES]]) {
    let shared = Shared::new(map, group.origin, group.octant_of(0), group.main);
    let slopes = std::array::from_fn(|beam| slopes_of(&packets[beam], 0xffff, group.main));
    // SAFETY: the caller's duty.
    let ends = unsafe { follow(&shared, map, slopes) };
    for (packet, end) in packets.iter_mut().zip(ends) {
        begin(&shared, map, packet, 0xffff, end);
    }
    // SAFETY: as above.
    unsafe { walk(&shared, map, packets) };
    for (packet, hits) in packets.iter().zip(hits) {
        let mut all = Hits::misses();
        all.add(&shared, map, packet);
        store_hits(all.0, hits);
    }
}

/// Casts the rays of the packet in a slot, octant by octant; no other packet is under way.
#[target_feature(enable = "avx512f,avx512dq,avx512bw,avx512vl,popcnt,bmi1,bmi2,lzcnt,fma,avx2")]
unsafe fn cast_group(map: &Map, group: &Group, packets: &mut [Packet; BEAMS], slot: usize, hits: &mut [Hit; LANES]) {
    let mut all = Hits::misses();
    let mut rest: Mask = 0xffff;
    while rest != 0 {
        let octant = group.octant_of(rest.trailing_zeros());
        let lanes = group.lanes(octant);
        rest &= !lanes;
        let shared = Shared::new(map, group.origin, octant, group.main);
        // SAFETY: the caller's duty.
        unsafe {
            let [end, ..] = follow(&shared, map, [slopes_of(&packets[slot], lanes, group.main); BEAMS]);
            begin(&shared, map, &mut packets[slot], lanes, end);
            walk(&shared, map, packets);
            all.add(&shared, map, &packets[slot]);
        }
    }
    store_hits(all.0, hits);
}

#[inline]
#[target_feature(enable = "avx512f,avx512dq,avx512bw,avx512vl,popcnt,bmi1,bmi2,lzcnt,fma,avx2")]
fn slopes_of(packet: &Packet, lanes: Mask, main: usize) -> Slopes {
    let [u, v] = minor_axes(main);
    [packet.slopes(lanes, main, u), packet.slopes(lanes, main, v)]
}

/// Puts some lanes of a packet where their beam ended.
#[inline]
#[target_feature(enable = "avx512f,avx512dq,avx512bw,avx512vl,popcnt,bmi1,bmi2,lzcnt,fma,avx2")]
fn begin(shared: &Shared, map: &Map, packet: &mut Packet, lanes: Mask, end: End) {
    match end {
        End::At(plane) => packet.start(shared, map, lanes, plane),
        End::Left => (packet.active, packet.hit) = (0, 0),
    }
}

/// Takes packets to what they hit, two at a time.
///
/// # Safety
/// The scene of the map must be valid.
#[inline]
#[target_feature(enable = "avx512f,avx512dq,avx512bw,avx512vl,popcnt,bmi1,bmi2,lzcnt,fma,avx2")]
unsafe fn walk(shared: &Shared, map: &Map, packets: &mut [Packet; BEAMS]) {
    let mut under_way = [0, 1];
    let mut next = 2;
    loop {
        for slot in &mut under_way {
            while packets[*slot].active == 0 && next < BEAMS {
                *slot = next;
                next += 1;
            }
        }
        let [a, b] = packets.get_disjoint_mut(under_way).expect("two packets");
        if a.active | b.active == 0 {
            return;
        }
        // SAFETY: the caller's duty.
        unsafe { step([a, b], shared, map) };
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::packed::PackedScene;
    use crate::walk;
    use glam::IVec3;
    use voxtrace_scene::Material;
    use voxtrace_scene::Scene;
    use voxtrace_scene::VoxelGrid;

    fn scene() -> PackedScene {
        let mut grid = VoxelGrid::new();
        for i in 0..4000 {
            grid.set(IVec3::new(i * 7 % 61, i * 13 % 53, i * 29 % 47), 0);
        }
        PackedScene::pack(&Scene::from_grid("test", grid, vec![Material::default()])).expect("the scene is sound")
    }

    /// Rays from one point through a grid of pixels around the direction −x.
    fn camera_rays(count: usize) -> Vec<Ray> {
        let direction = |i: usize| Vec3::new(-1.0, (i % 8) as f32 * 0.01 - 0.0345, (i / 8) as f32 * 0.01 - 0.0845);
        (0..count).map(|i| Ray::new(Vec3::new(90.5, 20.25, 20.125), direction(i))).collect()
    }

    /// Which groups of these rays are cast as packets.
    fn packets(rays: &[Ray]) -> Option<Vec<bool>> {
        if !walk::Instructions::Avx512.is_available() {
            return None;
        }
        let scene = scene();
        let mut hits = vec![Hit::MISS; rays.len()];
        let mut done = Groups::none_of(rays.len());
        // SAFETY: the processor has the instructions, and packing gives valid scenes.
        unsafe { cast(scene.geometry(), &scene.grids()[0], rays, &mut hits, &mut done) };
        let groups = (0..rays.len() / LANES).map(|group| done.contains(group));
        for (group, (rays, hits)) in rays.chunks_exact(LANES).zip(hits.chunks_exact(LANES)).enumerate() {
            for (ray, hit) in rays.iter().zip(hits).filter(|_| done.contains(group)) {
                assert_eq!(*hit, walk::cast(&scene, ray), "{ray:?}");
            }
        }
        Some(groups.collect())
    }

    #[test]
    fn camera_rays_are_packets_whatever_their_octants() {
        let rays = camera_rays(16 * 9);
        let octants = rays.iter().map(|ray| ray.direction.cmplt(Vec3::ZERO).bitmask());
        assert_eq!(octants.collect::<std::collections::BTreeSet<_>>().len(), 4);
        assert!(packets(&rays).is_none_or(|groups| groups == [true; 9]));
    }

    #[test]
    fn packets_enter_the_grid_from_outside_along_every_axis() {
        let origins = [(90.5, 20.25, 20.125), (90.5, 80.25, 70.125), (-30.0, 25.5, 90.0), (-1e4, -2e4, -1.5e4)];
        for origin in origins.map(Vec3::from) {
            // Past its edges as well, some as near to them as f32 can say, and some that end before.
            let target = |i: usize| {
                Vec3::new((i % 16) as f32 * 7.0 - 20.0, (i / 16) as f32 * 7.0 - 20.0, (i % 7) as f32 * 10.0 - 5.0)
            };
            let corner =
                |i: usize| Vec3::new((i % 2) as f32 * 61.0, (i / 2 % 2) as f32 * 53.0, (i / 4 % 2) as f32 * 47.0);
            let rays: Vec<Ray> = (0..16 * 40)
                .map(|i| Ray {
                    t_max: if i % 5 == 0 { 0.9 + (i % 3) as f32 * 0.1 } else { f32::INFINITY },
                    ..Ray::new(origin, if i % 3 == 0 { corner(i) } else { target(i % 256) } - origin)
                })
                .collect();
            assert!(packets(&rays).is_none_or(|groups| groups.iter().filter(|&&done| done).count() > 20), "{origin}");
        }
    }

    #[test]
    fn rays_that_need_care_are_no_packets() {
        let spoil: [fn(&mut Ray); 5] = [
            |ray| ray.origin.y += 1.0,
            |ray| ray.direction.z = 0.0,
            |ray| ray.t_min = 1.0,
            |ray| ray.t_max = f32::NAN,
            |ray| ray.direction.x = f32::NAN,
        ];
        for spoil in spoil {
            let mut rays = camera_rays(16 * 5);
            spoil(&mut rays[16 + 7]);
            let groups = packets(&rays);
            assert!(groups.as_ref().is_none_or(|groups| *groups == [true, false, true, true, true]), "{groups:?}");
        }
    }
}
