//! Rays through scenes of several instances: each lane has a ray and the grid of one of its instances. Where a lane is done with one, it
//! goes on with the next instance of its ray, and then with the next ray.

use super::grids::OwnGrids;
use super::kernel::Kernel;
use super::{DIRECTION, INVERSE, Lanes, ORIGIN, SIGN_INDEX, SKIP_SHIFT, T_END, TOLERANCE, VOXEL};
use crate::packed::{PackedGrid, PackedScene};
use crate::walk::exact;
use crate::walk::instances::Nearby;
use crate::walk::local_ray::LocalRay;
use crate::walk::scalar::Walk;
use crate::walk::simd::{Bits, LANES, Simd, lanes_of};
use glam::IVec3;
use voxtrace_scene::ray::{Hit, Ray};

/// The ray in a lane, and how far it has come through the scene.
#[derive(Clone, Copy)]
struct Journey {
    /// Which of the rays.
    index: usize,
    /// The ray, up to the nearest hit so far.
    ray: Ray,
    nearest: Hit,
    nearby: Nearby,
    /// The instance in which the lane walks.
    instance: u32,
}

/// Sixteen lanes with their rays.
struct Group<'a> {
    scene: &'a PackedScene,
    lanes: Lanes,
    journeys: [Journey; LANES],
}

/// Rays to trace, and where their hits go.
struct Work<'a> {
    rays: &'a [Ray],
    hits: &'a mut [Hit],
    /// The next ray.
    next: usize,
    /// Whether any hit will do.
    any: bool,
}

/// Finds for each ray its first hit in a scene, or where `any` hit will do one that need not be the first.
///
/// # Safety
/// The scene must be valid.
#[inline(always)]
pub unsafe fn first_hits<S: Simd>(simd: S, scene: &PackedScene, rays: &[Ray], any: bool, hits: &mut [Hit]) {
    let kernel = Kernel::new(simd, &scene.geometry, OwnGrids);
    let mut work = Work { rays, hits, next: 0, any };
    let mut groups = [Group::new(scene), Group::new(scene)];
    for group in &mut groups {
        group.refill(Bits::MAX, &mut work);
    }
    while groups[0].lanes.active | groups[1].lanes.active != 0 {
        for group in &mut groups {
            // SAFETY: the scene is valid, so every position the kernel computes lies inside its array.
            unsafe { kernel.look_ahead(&mut group.lanes) };
        }
        for group in &mut groups {
            // SAFETY: as above.
            let step = unsafe { kernel.step(&mut group.lanes) };
            let done = group.lanes.active & !step.active;
            group.lanes.active = step.active;
            for lane in lanes_of(step.unsure) {
                let origin = group.grid_of(lane).origin;
                group.lanes.decide(lane, origin);
            }
            for lane in lanes_of(step.hit) {
                group.take_hit(lane, work.any);
            }
            if done != 0 {
                group.go_on(done, &mut work);
            }
        }
    }
}

impl<'a> Group<'a> {
    fn new(scene: &'a PackedScene) -> Self {
        let ray = Ray::new(glam::Vec3::ZERO, glam::Vec3::ZERO);
        let nowhere = Journey { index: 0, ray, nearest: Hit::MISS, nearby: Nearby::NONE, instance: 0 };
        Self { scene, lanes: Lanes::empty(), journeys: [nowhere; LANES] }
    }

    fn grid_of(&self, lane: usize) -> &'a PackedGrid {
        let placed = &self.scene.placement.instances[self.journeys[lane].instance as usize];
        &self.scene.geometry.grids[placed.grid as usize]
    }

    /// Keeps the hit of a lane where it is the nearest of its ray.
    #[inline(always)]
    fn take_hit(&mut self, lane: usize, any: bool) {
        let voxel = self.lanes.voxel_of(lane) + self.grid_of(lane).origin;
        let journey = &mut self.journeys[lane];
        let from_world = &self.scene.placement.instances[journey.instance as usize].grid_from_world;
        let Some(local) = LocalRay::new(&journey.ray, from_world) else { return };
        let hit = exact::hit_of(&local, voxel, journey.instance);
        let is_nearer =
            hit.t < journey.nearest.t || (hit.t == journey.nearest.t && hit.instance < journey.nearest.instance);
        if hit.t <= journey.ray.t_max && is_nearer {
            journey.nearest = hit;
            journey.ray.t_max = hit.t;
            if any {
                journey.nearby = Nearby::NONE;
            }
        }
    }

    /// Takes lanes that are done with an instance to the next one of their ray, and those whose ray is done to other rays.
    fn go_on(&mut self, done: Bits, work: &mut Work) {
        let mut free = 0;
        for lane in lanes_of(done) {
            if !self.begin_next(lane) {
                let journey = &self.journeys[lane];
                work.hits[journey.index] = journey.nearest;
                free |= 1 << lane;
            }
        }
        self.refill(free, work);
    }

    /// Puts rays into free lanes, as many as there are.
    fn refill(&mut self, free: Bits, work: &mut Work) {
        for lane in lanes_of(free) {
            while let Some(&ray) = work.rays.get(work.next) {
                let index = work.next;
                work.next += 1;
                let nearby = Nearby::new(self.scene, &ray);
                self.journeys[lane] = Journey { index, ray, nearest: Hit::MISS, nearby, instance: 0 };
                if self.begin_next(lane) {
                    break;
                }
                work.hits[index] = Hit::MISS;
            }
        }
    }

    /// Lets a lane begin with the next instance whose grid its ray enters. Returns false where there is none.
    #[inline(always)]
    fn begin_next(&mut self, lane: usize) -> bool {
        let journey = &mut self.journeys[lane];
        while let Some(instance) = journey.nearby.next(self.scene, &journey.ray) {
            let placed = &self.scene.placement.instances[instance as usize];
            let grid = &self.scene.geometry.grids[placed.grid as usize];
            let Some(local) = LocalRay::new(&journey.ray, &placed.grid_from_world) else { continue };
            let walk = Walk::new(&local, grid);
            let Some(voxel) = walk.enter(grid, walk.start_voxel()) else { continue };
            journey.instance = instance;
            self.lanes.put(lane, &local, &walk, grid, voxel - grid.origin);
            return true;
        }
        false
    }
}

impl Lanes {
    /// Puts a ray into a lane, in a voxel that counts from the grid's origin.
    #[inline(always)]
    fn put(&mut self, lane: usize, local: &LocalRay, walk: &Walk, grid: &PackedGrid, voxel: IVec3) {
        let octant = local.octant();
        for axis in 0..3 {
            self.floats[ORIGIN + axis][lane] = local.origin[axis];
            self.floats[DIRECTION + axis][lane] = local.direction[axis];
            self.floats[INVERSE + axis][lane] = local.inverse[axis];
            self.floats[TOLERANCE + axis][lane] = walk.tolerance[axis];
            self.integers[VOXEL + axis][lane] = voxel[axis];
            self.integers[SIGN_INDEX + axis][lane] = 4 * (octant as i32 >> axis & 1);
        }
        self.floats[T_END][lane] = local.t_end();
        self.integers[SKIP_SHIFT][lane] = 3 * octant as i32;
        // No voxel lies in such a node.
        self.node_at[0][lane] = i32::MIN;
        self.grids.set(lane, grid);
        self.active |= 1 << lane;
    }
}
