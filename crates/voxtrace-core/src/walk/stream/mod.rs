//! Rays in any order: a ray a lane, lanes refilled as soon as their rays are done. The steps are those of [`super::scalar`], sixteen rays at
//! once; those that are too near to a plane go to [`super::exact`], as there, so the voxels are the same.

#![expect(unsafe_code, reason = "gathers")]
#![expect(clippy::needless_range_loop, reason = "an axis indexes several arrays")]

mod arrivals;
mod grids;
mod journeys;
mod kernel;
mod of_scene;
mod waiting;

use super::exact;
use super::groups::Groups;
use super::local_ray::LocalRay;
use super::simd::{Bits, LANES, Simd, lanes_of};
use crate::packed::{Geometry, PackedGrid};
use glam::{IVec3, Vec3};
use grids::{GridOfEach, OneGrid};
use kernel::Kernel;
pub use of_scene::first_hits;
use voxtrace_scene::ray::{Hit, Ray};
use waiting::Waiting;

/// Lanes without a ray before the kernel stops to refill them.
const REFILL_AT: u32 = 5;

/// Vectors of rays that are stepped in turn: while the bricks of one are fetched the others compute.
const GROUPS: usize = 6;

/// Quantities of a ray that are f32: origin, direction, inverse and tolerance for each axis, end of the segment.
const FLOATS: usize = 13;
/// Quantities of a ray that are integers: the voxel (from the grid's origin) and the table index of the sign for each
/// axis, the position of the octant's skip distance in an empty cell, the ray's index.
const INTEGERS: usize = 8;

const ORIGIN: usize = 0;
const DIRECTION: usize = 3;
const INVERSE: usize = 6;
const TOLERANCE: usize = 9;
const T_END: usize = 12;

const VOXEL: usize = 0;
/// 4 where the direction is negative, else 0, for the tables of voxels ahead.
const SIGN_INDEX: usize = 3;
/// 3 × the octant's number.
const SKIP_SHIFT: usize = 6;
const RAY: usize = 7;

/// Sixteen lanes and the rays in them: one array for each quantity.
#[derive(Clone, Copy)]
#[repr(C, align(64))]
pub struct Lanes {
    pub floats: [[f32; LANES]; FLOATS],
    pub integers: [[i32; LANES]; INTEGERS],
    /// Position of the finest node visited last, in cells, and where it lies: its first voxel divided by 32.
    pub node: [i32; LANES],
    pub node_at: [[i32; LANES]; 3],
    /// The cells that the lanes are in, log₂ of their sizes, and the lanes that are in the grid: what [`Kernel::look_ahead`] finds.
    pub cell: [i32; LANES],
    pub shift: [i32; LANES],
    pub inside: Bits,
    /// The brick records that were fetched last.
    pub record: [i32; LANES],
    /// Exit planes of the lanes' boxes, in grid space, as of the last step that left a lane unsure.
    pub exit: [[i32; LANES]; 3],
    /// The grids of the lanes, where they have not all the same.
    grids: GridOfEach,
    pub active: Bits,
}

/// Finds the first hit of each ray, in the space of a grid, in that, which has the number 0, but of those in groups that are done. `hits` of rays that meet
/// nothing are left as they are.
///
/// # Safety
/// `geometry` must be valid as [`Geometry::validate`] says.
#[inline(always)]
pub unsafe fn first_hits_in_grid<S: Simd>(
    simd: S,
    (geometry, grid): (&Geometry, &PackedGrid),
    rays: &[Ray],
    done: &Groups,
    hits: &mut [Hit],
) {
    let kernel = Kernel::new(simd, geometry, OneGrid(grid));
    let mut waiting = Waiting::new(rays, done, (geometry, grid));
    let mut groups = [Lanes::empty(); GROUPS];
    let mut is_under_way = true;
    while is_under_way {
        is_under_way = false;
        for lanes in &mut groups {
            if lanes.active != 0 {
                // SAFETY: the scene is valid, so every position the kernel computes lies inside its array.
                let step = unsafe { kernel.step(lanes) };
                lanes.active = step.active;
                for lane in lanes_of(step.unsure) {
                    lanes.decide(lane, grid.origin);
                }
                if step.hit != 0 {
                    let met = kernel.meet(lanes);
                    for lane in lanes_of(step.hit) {
                        let index = lanes.integers[RAY][lane] as usize;
                        let hit = met.hit(lanes, lane, lanes.voxel_of(lane) + grid.origin, rays[index].t_min, 0);
                        hits[index] = if hit.t <= rays[index].t_max { hit } else { Hit::MISS };
                    }
                }
            }
            if lanes.active.count_zeros() >= REFILL_AT {
                waiting.fill(simd, lanes);
            }
            if lanes.active != 0 {
                // SAFETY: as above.
                unsafe { kernel.look_ahead(lanes) };
                is_under_way = true;
            }
        }
    }
}

impl Lanes {
    fn empty() -> Self {
        Self {
            floats: [[0.0; LANES]; FLOATS],
            integers: [[0; LANES]; INTEGERS],
            node: [0; LANES],
            node_at: [[i32::MIN; LANES]; 3],
            cell: [0; LANES],
            shift: [0; LANES],
            inside: 0,
            record: [0; LANES],
            exit: [[0; LANES]; 3],
            grids: GridOfEach::NONE,
            active: 0,
        }
    }

    #[inline(always)]
    fn voxel_of(&self, lane: usize) -> IVec3 {
        IVec3::new(self.integers[VOXEL][lane], self.integers[VOXEL + 1][lane], self.integers[VOXEL + 2][lane])
    }

    /// A quantity of a lane that has a number for each axis.
    #[inline(always)]
    fn vector(&self, first: usize, lane: usize) -> Vec3 {
        Vec3::new(self.floats[first][lane], self.floats[first + 1][lane], self.floats[first + 2][lane])
    }

    /// The ray of a lane, without its ends.
    fn local_ray(&self, lane: usize) -> LocalRay {
        let (origin, direction) = (self.vector(ORIGIN, lane), self.vector(DIRECTION, lane));
        LocalRay { origin, direction, inverse: self.vector(INVERSE, lane), t_min: 0.0, t_max: f32::INFINITY }
    }

    /// Takes the step of a lane that f32 is not sure about.
    #[cold]
    fn decide(&mut self, lane: usize, origin: IVec3) {
        let local = self.local_ray(lane);
        let exit = IVec3::from_array(std::array::from_fn(|axis| self.exit[axis][lane]));
        let arrival = exact::leave_box(&local, self.voxel_of(lane) + origin, exit);
        // A local ray crosses some plane of every box.
        let relative = arrival.map_or(IVec3::NEG_ONE, |voxel| voxel - origin);
        for axis in 0..3 {
            self.integers[VOXEL + axis][lane] = relative[axis];
        }
    }
}
