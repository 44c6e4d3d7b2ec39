//! The walk of one ray through one grid, in plain code: the reference of every faster walk.
//!
//! Each step asks how large an empty box around the ray's voxel is known, and leaves it. The known boxes are cubes of
//! tree cells (by their skip distances), 4×4×4 blocks without a voxel ahead, 2×2×2 blocks, single voxels.

use super::exact;
use super::local_ray::{LocalRay, MAX_ORIGIN};
use crate::packed::{CELL_OCCUPIED, Geometry, PackedGrid, SKIP_DISTANCES, cell_in_node};
use glam::{IVec3, Vec3};

/// The first occupied voxel on a ray's path through a grid, not later than `t_max`.
pub fn first_voxel(geometry: &Geometry, grid: &PackedGrid, ray: &LocalRay) -> Option<IVec3> {
    let (cells, bricks) = (&*geometry.cells, &*geometry.bricks);
    let walk = Walk::new(ray, grid);
    let mut voxel = walk.enter(grid, walk.start_voxel())?;
    let top_stride = IVec3::new(1, grid.top_size.x, grid.top_size.x * grid.top_size.y);
    // The finest node visited last: most steps stay in it.
    let (mut node, mut node_at) = (0, IVec3::splat(i32::MIN));
    loop {
        let relative = voxel - grid.origin;
        let mut shift = 3;
        let cell = if relative >> 5 == node_at {
            cells[node + cell_in_node(relative, 3)]
        } else {
            let top = relative >> grid.top_shift as i32;
            if top.cmplt(IVec3::ZERO).any() || top.cmpge(grid.top_size).any() {
                return None;
            }
            shift = grid.top_shift;
            let mut cell = cells[grid.top_offset as usize + (top * top_stride).element_sum() as usize];
            while cell & CELL_OCCUPIED != 0 && shift > 3 {
                shift -= 2;
                node = (cell & !CELL_OCCUPIED) as usize * 64;
                cell = cells[node + cell_in_node(relative, shift)];
                if shift == 3 {
                    node_at = relative >> 5;
                }
            }
            cell
        };
        if cell & CELL_OCCUPIED == 0 {
            let distance = i32::from(SKIP_DISTANCES[(cell >> (3 * walk.octant) & 7) as usize]);
            voxel = walk.leave(grid, voxel, shift, distance)?;
            continue;
        }
        // Inside a brick.
        let record = (cell & !CELL_OCCUPIED) as usize * 2;
        let header = bricks[record];
        let brick_at = relative >> 3;
        loop {
            let relative = voxel - grid.origin;
            if relative >> 3 != brick_at {
                break;
            }
            let block = (relative.x >> 2 & 1 | (relative.y >> 2 & 1) << 1 | (relative.z >> 2 & 1) << 2) as usize;
            let ahead = u32::from(BLOCKS_AHEAD[walk.octant][block]);
            let mut size_shift = if header & ahead == 0 { 3 } else { 2 };
            if header >> block & 1 != 0 {
                let rank = (header & ((1 << block) - 1)).count_ones() as usize;
                let at = record + 2 + 2 * rank;
                let mask = u64::from(bricks[at]) | u64::from(bricks[at + 1]) << 32;
                let bit = cell_in_node(relative, 0);
                if mask >> bit & 1 != 0 {
                    return Some(voxel);
                }
                if mask & VOXELS_AHEAD[walk.octant][bit] != 0 {
                    let corner = bit & 0b10_10_10;
                    size_shift = u32::from(mask >> corner & 0x0033_0033 == 0);
                } else if header & (ahead & !(1 << block)) == 0 {
                    size_shift = 3;
                }
            }
            voxel = walk.leave(grid, voxel, size_shift, 1)?;
        }
    }
}

/// `BLOCKS_AHEAD[octant][block]`: the blocks of a brick that a ray of the octant may still meet from a block, itself
/// included.
static BLOCKS_AHEAD: [[u8; 8]; 8] = blocks_ahead();
/// `VOXELS_AHEAD[octant][bit]`: the voxels of a block that a ray of the octant may still meet from a voxel, itself
/// included.
static VOXELS_AHEAD: [[u64; 64]; 8] = voxels_ahead();

/// Whether coordinate `b` is at `a` or beyond it, as seen along an axis with the given sign.
const fn is_ahead(a: usize, b: usize, is_negative: bool) -> bool {
    if is_negative { b <= a } else { b >= a }
}

pub(super) const fn blocks_ahead() -> [[u8; 8]; 8] {
    let mut table = [[0; 8]; 8];
    let mut i = 0;
    while i < 8 * 8 * 8 {
        let (octant, from, to) = (i >> 6, i >> 3 & 7, i & 7);
        let x = is_ahead(from & 1, to & 1, octant & 1 != 0);
        let y = is_ahead(from >> 1 & 1, to >> 1 & 1, octant & 2 != 0);
        let z = is_ahead(from >> 2, to >> 2, octant & 4 != 0);
        if x && y && z {
            table[octant][from] |= 1 << to;
        }
        i += 1;
    }
    table
}

const fn voxels_ahead() -> [[u64; 64]; 8] {
    let mut table = [[0; 64]; 8];
    let mut i = 0;
    while i < 8 * 64 * 64 {
        let (octant, from, to) = (i >> 12, i >> 6 & 63, i & 63);
        let x = is_ahead(from & 3, to & 3, octant & 1 != 0);
        let y = is_ahead(from >> 2 & 3, to >> 2 & 3, octant & 2 != 0);
        let z = is_ahead(from >> 4, to >> 4, octant & 4 != 0);
        if x && y && z {
            table[octant][from] |= 1 << to;
        }
        i += 1;
    }
    table
}

/// What stays the same during a walk.
pub(super) struct Walk<'a> {
    ray: &'a LocalRay,
    pub(super) tolerance: Vec3,
    octant: usize,
    /// 1 where the direction is negative, else 0.
    is_negative: IVec3,
    t_end: f32,
}

impl<'a> Walk<'a> {
    #[inline]
    pub(super) fn new(ray: &'a LocalRay, grid: &PackedGrid) -> Self {
        let octant = ray.octant();
        let is_negative = IVec3::new(octant as i32 & 1, octant as i32 >> 1 & 1, octant as i32 >> 2);
        Self { ray, tolerance: ray.tolerance(grid), octant, is_negative, t_end: ray.t_end() }
    }

    /// The voxel that holds the ray's first point.
    #[inline]
    pub(super) fn start_voxel(&self) -> IVec3 {
        let start = self.ray.origin + self.ray.direction * self.ray.t_min;
        let (nearest, from_nearest) = nearest_integers(start);
        // At t = 0 the position is the origin, exactly.
        if self.ray.t_min > 0.0 && from_nearest.abs().cmple(self.tolerance).any() {
            return exact::start_voxel(self.ray);
        }
        nearest + IVec3::select(from_nearest.cmplt(Vec3::ZERO), IVec3::NEG_ONE, IVec3::ZERO)
    }

    /// From the start voxel to the first voxel of the path inside the grid's bounds.
    #[inline]
    pub(super) fn enter(&self, grid: &PackedGrid, mut voxel: IVec3) -> Option<IVec3> {
        loop {
            let (below, above) = (voxel.cmplt(grid.min), voxel.cmpge(grid.max));
            if !(below | above).any() {
                return Some(voxel);
            }
            // Outside along an axis means a whole half-space is empty; of several axes take the plane crossed last.
            let mut farthest: Option<(f32, usize, i32)> = None;
            for axis in (0..3).filter(|&axis| below.test(axis) || above.test(axis)) {
                let plane = if below.test(axis) { grid.min[axis] } else { grid.max[axis] };
                let moves_away = below.test(axis) == (self.is_negative[axis] == 1);
                if moves_away || self.ray.direction[axis] == 0.0 {
                    return None;
                }
                let t = self.crossing(axis, plane);
                if farthest.is_none_or(|(latest, ..)| t > latest) {
                    farthest = Some((t, axis, plane));
                }
            }
            let (t, axis, plane) = farthest?;
            // Half of the range: arriving there must not overflow.
            let far = |axis: usize| if self.is_negative[axis] == 1 { i32::MIN / 2 } else { i32::MAX / 2 };
            voxel = self.arrive(voxel, t, axis, plane, |other| if other == axis { plane } else { far(other) })?;
        }
    }

    /// The voxel in which the ray arrives when it leaves the box of `count`³ cells of `1 << shift` voxels that grows
    /// along its octant from the cell that holds `voxel`; `None` where the segment ends before.
    #[inline]
    fn leave(&self, grid: &PackedGrid, voxel: IVec3, shift: u32, count: i32) -> Option<IVec3> {
        let cell = (voxel - grid.origin) >> shift as i32;
        // Along +: the far side of the last cell. Along −: its near side.
        let last = cell + count + self.is_negative * (1 - 2 * count);
        let exit = (last << shift as i32) + grid.origin;
        let t = [self.crossing(0, exit.x), self.crossing(1, exit.y), self.crossing(2, exit.z)];
        let (t_first, axis) = if t[0] <= t[1] && t[0] <= t[2] {
            (t[0], 0)
        } else if t[1] <= t[2] {
            (t[1], 1)
        } else {
            (t[2], 2)
        };
        self.arrive(voxel, t_first, axis, exit[axis], |axis| exit[axis])
    }

    /// Time of the crossing of a plane ahead.
    #[inline]
    fn crossing(&self, axis: usize, plane: i32) -> f32 {
        (plane as f32 - self.ray.origin[axis]) * self.ray.inverse[axis]
    }

    /// The voxel in which the ray arrives when it crosses `plane` of `axis` at `t`. `exit` gives the exit planes of the
    /// box for the exact decision, where f32 is not sure.
    #[inline]
    fn arrive(&self, voxel: IVec3, t: f32, axis: usize, plane: i32, exit: impl Fn(usize) -> i32) -> Option<IVec3> {
        if t > self.t_end {
            return None;
        }
        let position = self.ray.origin + self.ray.direction * t;
        let (nearest, from_nearest) = nearest_integers(position);
        let mut is_unsure = from_nearest.abs().cmple(self.tolerance);
        is_unsure.set(axis, false);
        if is_unsure.any() {
            let exit = IVec3::new(exit(0), exit(1), exit(2));
            return exact::leave_box(self.ray, voxel, exit);
        }
        let mut arrival = nearest + IVec3::select(from_nearest.cmplt(Vec3::ZERO), IVec3::NEG_ONE, IVec3::ZERO);
        arrival[axis] = plane - self.is_negative[axis];
        Some(arrival)
    }
}

/// The nearest integers, and the exact differences from them, of coordinates that are clamped to ±2²¹, which is far
/// outside of every grid. Adding 1.5 × 2²³ leaves the nearest integer in the low bits: no instruction for rounding is
/// needed, which the oldest x86-64 processors lack.
#[inline]
fn nearest_integers(position: Vec3) -> (IVec3, Vec3) {
    const SHIFT: f32 = 12_582_912.0;
    const LIMIT: Vec3 = Vec3::splat(MAX_ORIGIN);
    let position = position.clamp(-LIMIT, LIMIT);
    let shifted = position + SHIFT;
    let bits = |value: f32| value.to_bits() as i32 - SHIFT.to_bits() as i32;
    let nearest = IVec3::new(bits(shifted.x), bits(shifted.y), bits(shifted.z));
    (nearest, position - (shifted - SHIFT))
}
