//! The walk of one ray with its three axes in one vector of four, which every 64-bit processor has: what is used where there are no wider ones.
//! Its steps are those of [`super::scalar`], the reference, operation by operation. Some rays take turns: while one waits for its numbers the
//! others compute.

use super::beams::{Beams, Entry};
use super::exact;
use super::local_ray::{LocalRay, MAX_ORIGIN, turned};
use super::scalar::{Leave, Place, SHIFT, Step, Walk};
use super::simd::LANES;
use crate::packed::{Geometry, PackedGrid, PackedInstance};
use glam::{IVec3, Vec3A};
use voxtrace_scene::ray::{Hit, Ray};
use voxtrace_scene::transform::Transform;

/// Rays that take turns: of one alone each step waits for the one before, and what more need is no longer in registers and the nearest cache.
const TURNS: usize = 2;

/// A ray with its axes in vectors.
struct Axes {
    ray: LocalRay,
    origin: Vec3A,
    direction: Vec3A,
    inverse: Vec3A,
    tolerance: Vec3A,
    /// −1 where the direction is negative, else 0.
    signs: [i32; 3],
    octant: usize,
    t_end: f32,
}

/// A ray on its way.
struct Turn {
    index: usize,
    axes: Axes,
    place: Place,
}

/// Finds for each ray its first hit in one instance, which has the number 0.
pub fn first_hits(geometry: &Geometry, instance: &PackedInstance, rays: &[Ray], hits: &mut [Hit]) {
    let grid = &geometry.grids[instance.grid as usize];
    let arrays: (&[u32], &[u32]) = (&geometry.cells, &geometry.bricks);
    let rays = &*turned(rays, &instance.grid_from_world);
    let mut beams = Beams::new(geometry, grid, rays);
    let mut entry = Entry::Start;
    let mut next = 0;
    let mut begin = |hits: &mut [Hit]| {
        while let Some(ray) = rays.get(next) {
            let index = next;
            next += 1;
            if index.is_multiple_of(LANES) {
                entry = beams.entry(index / LANES);
            }
            if let Some(local) = LocalRay::new(ray, &Transform::IDENTITY)
                && let Some((axes, voxel)) = Axes::new(local, grid, entry)
            {
                return Some(Turn { index, axes, place: Place::at(voxel) });
            }
            hits[index] = Hit::MISS;
        }
        None
    };
    let mut turns: Vec<Turn> = Vec::with_capacity(TURNS);
    while turns.len() < TURNS
        && let Some(turn) = begin(hits)
    {
        turns.push(turn);
    }
    while !turns.is_empty() {
        let mut at = 0;
        while let Some(turn) = turns.get_mut(at) {
            let hit = match turn.place.step(arrays, grid, &turn.axes, turn.axes.octant) {
                Step::On => {
                    at += 1;
                    continue;
                }
                Step::Out => None,
                Step::Hit => Some(turn.axes.hit(turn.place.voxel)),
            };
            hits[turn.index] = hit.filter(|hit| hit.t <= turn.axes.ray.t_max).unwrap_or(Hit::MISS);
            match begin(hits) {
                Some(next) => *turn = next,
                None => _ = turns.swap_remove(at),
            }
        }
    }
}

impl Axes {
    /// A ray, and the voxel in which it enters a grid, if it does.
    #[inline(always)]
    fn new(ray: LocalRay, grid: &PackedGrid, entry: Entry) -> Option<(Self, IVec3)> {
        let walk = Walk::new(&ray, grid);
        let voxel = walk.begin(grid, entry)?;
        let (octant, tolerance) = (walk.octant, walk.tolerance.into());
        let signs = [-(octant as i32 & 1), -(octant as i32 >> 1 & 1), -(octant as i32 >> 2)];
        let (origin, direction, inverse) = (ray.origin.into(), ray.direction.into(), ray.inverse.into());
        Some((Self { origin, direction, inverse, tolerance, signs, octant, t_end: ray.t_end(), ray }, voxel))
    }

    /// The hit of a voxel, as [`exact::hit_of`] finds it.
    #[inline(always)]
    fn hit(&self, voxel: IVec3) -> Hit {
        // Along − the far side of the voxel.
        let entry = |axis: usize| (voxel[axis] - self.signs[axis]) as f32;
        let times = (Vec3A::new(entry(0), entry(1), entry(2)) - self.origin) * self.inverse;
        let latest = Vec3A::splat(times.max_element());
        // Three roundings each, of numbers that may be too small for their precision.
        let margin = |times: Vec3A| times.abs() * (4.0 * f32::EPSILON) + 4.0 * f32::MIN_POSITIVE;
        let may_be_last = !(times + margin(times)).cmplt(latest - margin(latest)).bitmask() & 0b111;
        if !may_be_last.is_power_of_two() {
            return exact::hit_of(&self.ray, voxel, 0);
        }
        let axis = may_be_last.trailing_zeros() as usize;
        let (t, t_min) = (times[axis], self.ray.t_min);
        let face = 2 * axis as u32 + u32::from(self.signs[axis] != 0);
        Hit { t: if t > t_min { t } else { t_min }, instance: 0, voxel, face }
    }
}

impl Leave for Axes {
    #[inline(always)]
    fn leave(&self, grid: &PackedGrid, voxel: IVec3, shift: u32, count: i32) -> Option<IVec3> {
        let mut exit = [0; 3];
        for axis in 0..3 {
            let sign = self.signs[axis];
            // Along +: the far side of the last cell. Along −: its near side.
            let last = ((voxel[axis] - grid.origin[axis]) >> shift) + (count ^ sign) - 2 * sign;
            exit[axis] = (last << shift) + grid.origin[axis];
        }
        let planes = Vec3A::new(exit[0] as f32, exit[1] as f32, exit[2] as f32);
        let times = (planes - self.origin) * self.inverse;
        let t = times.min_element();
        if t > self.t_end {
            return None;
        }
        // Of equal times that of the lowest axis.
        let axis = times.cmpeq(Vec3A::splat(t)).bitmask().trailing_zeros() as usize;
        let position = self.origin + self.direction * t;
        let limit = Vec3A::splat(MAX_ORIGIN);
        let position = position.max(-limit).min(limit);
        let shift = Vec3A::splat(SHIFT);
        let nearest = position + shift - shift;
        let from_nearest = position - nearest;
        let is_near = from_nearest.abs().cmple(self.tolerance).bitmask();
        if is_near & !(1 << axis) != 0 {
            return exact::leave_box(&self.ray, voxel, IVec3::from_array(exit));
        }
        let floor = nearest - Vec3A::select(from_nearest.cmplt(Vec3A::ZERO), Vec3A::ONE, Vec3A::ZERO);
        let bits = (floor + shift).to_array().map(f32::to_bits);
        let mut arrival = bits.map(|bits| bits as i32 - SHIFT.to_bits() as i32);
        arrival[axis] = exit[axis] + self.signs[axis];
        Some(IVec3::from_array(arrival))
    }
}
