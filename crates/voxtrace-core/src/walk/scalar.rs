//! The walk of one ray through one grid, in plain code: the reference of every faster walk.
//!
//! Each step asks how large an empty box around the ray's voxel is known, and leaves it. The known boxes are cubes of
//! tree cells (by their skip distances), 4×4×4 blocks without a voxel ahead, 2×2×2 blocks, single voxels.

use super::beams::Entry;
use super::exact;
use super::local_ray::{LocalRay, MAX_ORIGIN};
use crate::packed::{CELL_OCCUPIED, Geometry, PackedGrid, SKIP_DISTANCES, cell_in_node};
use glam::{IVec3, Vec3};

/// The first occupied voxel on a ray's path through a grid, not later than `t_max`.
pub fn first_voxel(geometry: &Geometry, grid: &PackedGrid, ray: &LocalRay) -> Option<IVec3> {
    let walk = Walk::new(ray, grid);
    let voxel = walk.begin(grid, Entry::Start)?;
    follow(geometry, grid, &walk, walk.octant, voxel)
}

/// How a ray leaves a box that is known to be empty.
pub(super) trait Leave {
    /// The voxel in which the ray arrives when it leaves the box of `count`³ cells of `1 << shift` voxels that grows
    /// along its octant from the cell that holds `voxel`; `None` where the segment ends before.
    fn leave(&self, grid: &PackedGrid, voxel: IVec3, shift: u32, count: i32) -> Option<IVec3>;
}

/// Follows a ray of an octant from a voxel within the grid to the first occupied one.
#[inline(always)]
fn follow(geometry: &Geometry, grid: &PackedGrid, walk: &impl Leave, octant: usize, voxel: IVec3) -> Option<IVec3> {
    let mut place = Place::at(voxel);
    loop {
        match place.step((&geometry.cells, &geometry.bricks), grid, walk, octant) {
            Step::On => {}
            Step::Hit => return Some(place.voxel),
            Step::Out => return None,
        }
    }
}

/// Where a ray has come to.
#[derive(Clone)]
pub(super) struct Place {
    pub voxel: IVec3,
    /// The finest node visited last, and where it lies: most steps stay in it.
    node: usize,
    node_at: IVec3,
    /// The brick visited last, its record, and that one's header.
    brick_at: IVec3,
    record: usize,
    header: u32,
}

/// What a step leads to.
pub(super) enum Step {
    /// The next voxel to look at.
    On,
    /// The voxel is occupied.
    Hit,
    /// The ray ends, or leaves the grid.
    Out,
}

/// A box that is known to be empty.
#[derive(Clone, Copy)]
pub(super) struct Empty {
    /// log₂ of the size of the cell around the voxel all of which is empty.
    pub own: u32,
    /// log₂ of the size of the cells that are empty from the voxel on, along the octant.
    pub shift: u32,
    /// How many of these there are along each axis.
    pub count: i32,
}

/// What is around a voxel.
pub(super) enum Around {
    /// An empty box.
    Empty(Empty),
    /// The voxel is occupied.
    Voxel,
    /// The end of the grid.
    Nothing,
}

impl Place {
    pub fn at(voxel: IVec3) -> Self {
        let nowhere = IVec3::splat(i32::MIN);
        Self { voxel, node: 0, node_at: nowhere, brick_at: nowhere, record: 0, header: 0 }
    }

    /// Leaves the largest box around the voxel that is known to be empty.
    #[inline(always)]
    pub fn step(&mut self, arrays: (&[u32], &[u32]), grid: &PackedGrid, walk: &impl Leave, octant: usize) -> Step {
        let empty = match self.around(arrays, grid, self.voxel - grid.origin, octant) {
            Around::Empty(empty) => empty,
            Around::Voxel => return Step::Hit,
            Around::Nothing => return Step::Out,
        };
        match walk.leave(grid, self.voxel, empty.shift, empty.count) {
            Some(voxel) => self.voxel = voxel,
            None => return Step::Out,
        }
        Step::On
    }

    /// What is around a voxel, which is given from the grid's origin, and ahead of it.
    #[inline(always)]
    pub fn around(
        &mut self,
        (cells, bricks): (&[u32], &[u32]),
        grid: &PackedGrid,
        relative: IVec3,
        octant: usize,
    ) -> Around {
        if relative >> 3 != self.brick_at {
            let Some((cell, shift)) = self.cell(cells, grid, relative) else { return Around::Nothing };
            if cell & CELL_OCCUPIED == 0 {
                let count = i32::from(SKIP_DISTANCES[(cell >> (3 * octant) & 7) as usize]);
                return Around::Empty(Empty { own: shift, shift, count });
            }
            self.brick_at = relative >> 3;
            self.record = (cell & !CELL_OCCUPIED) as usize * 2;
            self.header = bricks[self.record];
        }
        match self.empty_in_brick(bricks, relative, octant) {
            Some((own, shift)) => Around::Empty(Empty { own, shift, count: 1 }),
            None => Around::Voxel,
        }
    }

    /// The cell that holds a voxel, of the finest level that is stored, and log₂ of its size; `None` outside of the grid.
    #[inline(always)]
    fn cell(&mut self, cells: &[u32], grid: &PackedGrid, relative: IVec3) -> Option<(u32, u32)> {
        if relative >> 5 == self.node_at {
            return Some((cells[self.node + cell_in_node(relative, 3)], 3));
        }
        let top = relative >> grid.top_shift as i32;
        if top.cmplt(IVec3::ZERO).any() || top.cmpge(grid.top_size).any() {
            return None;
        }
        let row = top.z * grid.top_size.y + top.y;
        let mut shift = grid.top_shift;
        let mut cell = cells[grid.top_offset as usize + (row * grid.top_size.x + top.x) as usize];
        while cell & CELL_OCCUPIED != 0 && shift > 3 {
            shift -= 2;
            let node = (cell & !CELL_OCCUPIED) as usize * 64;
            cell = cells[node + cell_in_node(relative, shift)];
            if shift == 3 {
                (self.node, self.node_at) = (node, relative >> 5);
            }
        }
        Some((cell, shift))
    }

    /// log₂ of the sizes of an empty cell around a voxel of the brick, and of one that is empty from it on; `None` where the voxel is occupied.
    #[inline(always)]
    fn empty_in_brick(&self, bricks: &[u32], relative: IVec3, octant: usize) -> Option<(u32, u32)> {
        let header = self.header;
        let block = (relative.x >> 2 & 1 | (relative.y >> 2 & 1) << 1 | (relative.z >> 2 & 1) << 2) as usize;
        let ahead = u32::from(BLOCKS_AHEAD[octant][block]);
        if header >> block & 1 == 0 {
            return Some((2, if header & ahead == 0 { 3 } else { 2 }));
        }
        let rank = (header & ((1 << block) - 1)).count_ones() as usize;
        let at = self.record + 2 + 2 * rank;
        let mask = u64::from(bricks[at]) | u64::from(bricks[at + 1]) << 32;
        let bit = cell_in_node(relative, 0);
        if mask >> bit & 1 != 0 {
            return None;
        }
        if mask & VOXELS_AHEAD[octant][bit] != 0 {
            let corner = bit & 0b10_10_10;
            let own = u32::from(mask >> corner & 0x0033_0033 == 0);
            return Some((own, own));
        }
        Some((0, if header & (ahead & !(1 << block)) == 0 { 3 } else { 2 }))
    }
}

/// 1.5 × 2²³: added to a number, it leaves the nearest integer in the low bits.
pub(super) const SHIFT: f32 = 12_582_912.0;

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
    pub(super) octant: usize,
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
            voxel = self.arrive_at_plane(voxel, t, axis, plane)?;
        }
    }

    /// The first voxel inside the grid's bounds, where nothing is met before it: from the start voxel or behind a plane ahead of it.
    #[inline]
    pub(super) fn begin(&self, grid: &PackedGrid, entry: Entry) -> Option<IVec3> {
        let start = self.start_voxel();
        match entry {
            Entry::Start => self.enter(grid, start),
            Entry::Plane { axis, plane } => {
                let t = self.crossing(axis, plane);
                // A segment may begin behind the plane.
                let is_ahead = t >= self.ray.t_min;
                self.enter(grid, if is_ahead { self.arrive_at_plane(start, t, axis, plane)? } else { start })
            }
            Entry::Never => None,
        }
    }

    /// The voxel in which the ray arrives when it crosses a plane ahead, whatever is before it.
    #[inline]
    fn arrive_at_plane(&self, voxel: IVec3, t: f32, axis: usize, plane: i32) -> Option<IVec3> {
        // Half of the range: arriving there must not overflow.
        let far = |axis: usize| if self.is_negative[axis] == 1 { i32::MIN / 2 } else { i32::MAX / 2 };
        self.arrive(voxel, t, axis, plane, |other| if other == axis { plane } else { far(other) })
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

impl Leave for Walk<'_> {
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
}

/// The nearest integers, and the exact differences from them, of coordinates that are clamped to ±2²¹, which is far
/// outside of every grid. Adding 1.5 × 2²³ leaves the nearest integer in the low bits: no instruction for rounding is
/// needed, which the oldest x86-64 processors lack.
#[inline]
fn nearest_integers(position: Vec3) -> (IVec3, Vec3) {
    const LIMIT: Vec3 = Vec3::splat(MAX_ORIGIN);
    let position = position.clamp(-LIMIT, LIMIT);
    let shifted = position + SHIFT;
    let bits = |value: f32| value.to_bits() as i32 - SHIFT.to_bits() as i32;
    let nearest = IVec3::new(bits(shifted.x), bits(shifted.y), bits(shifted.z));
    (nearest, position - (shifted - SHIFT))
}
