//! One step of sixteen rays, each in a place of its own: cells, headers and masks come by gathers.

use super::grids::Grids;
use super::{DIRECTION, INVERSE, Lanes, ORIGIN, SIGN_INDEX, SKIP_SHIFT, T_END, TOLERANCE, VOXEL};
use crate::packed::{Geometry, SKIP_DISTANCES};
use crate::walk::exact;
use crate::walk::local_ray::LocalRay;
use crate::walk::simd::{Bits, LANES, Simd, prefetch};
use glam::IVec3;
use voxtrace_scene::ray::Hit;

/// What a step leaves to do.
pub struct Step {
    /// Lanes that go on.
    pub active: Bits,
    /// Lanes whose voxel is occupied; they do not go on.
    pub hit: Bits,
    /// Lanes that go on, whose voxel is still the old one: f32 is not sure where they leave the box.
    pub unsure: Bits,
}

/// What stays the same for all rays.
pub struct Kernel<'a, S: Simd, G> {
    simd: S,
    cells: &'a [u32],
    bricks: &'a [u32],
    grids: G,
    skip_distances: S::Table,
    /// Bits of a block's half (32 voxels) ahead, by [sign × 4 + coordinate]: along x and y, and along z for the lower
    /// and the upper half.
    ahead: [S::Table; 4],
    /// Blocks of a brick ahead by [sign × 4 + coordinate] along x, y, z.
    blocks_ahead: [S::Table; 3],
}

/// The empty box around each lane.
#[derive(Clone, Copy)]
struct Boxes<S: Simd> {
    /// log₂ of the size of its cells.
    shift: S::Ints,
    /// Its edges, in cells.
    count: S::Ints,
    /// Lanes in the grid.
    inside: S::Mask,
    /// Lanes in a voxel.
    hit: S::Mask,
}

/// An entry for each coordinate and direction: those of positive directions first.
fn entries(entry: impl Fn(u32, bool) -> u32) -> [i32; 8] {
    std::array::from_fn(|index| entry(index as u32 & 3, index >= 4) as i32)
}

impl<'a, S: Simd, G: Grids<S>> Kernel<'a, S, G> {
    /// The kernel for the grids of lanes.
    #[inline(always)]
    pub fn new(simd: S, geometry: &'a Geometry, grids: G) -> Self {
        // Bits of `all` from coordinate c on, or up to it, where a coordinate step is `stride` bits.
        let ahead = |all: u64, stride: u32, c: u32, is_negative: bool| {
            if is_negative { all >> (stride * (3 - c)) } else { all << (stride * c) & all }
        };
        let x = entries(|c, is_negative| ahead(0xf, 1, c, is_negative) as u32 * 0x1111_1111);
        let y = entries(|c, is_negative| ahead(0xffff, 4, c, is_negative) as u32 * 0x1_0001);
        let lower_z = entries(|c, is_negative| ahead(u64::MAX, 16, c, is_negative) as u32);
        let upper_z = entries(|c, is_negative| (ahead(u64::MAX, 16, c, is_negative) >> 32) as u32);
        let blocks = |near: u32, far: u32| {
            entries(|c, is_negative| match (c >> 1, is_negative) {
                (0, false) | (1, true) => near | far,
                (0, true) => near,
                _ => far,
            })
        };
        let skip_distances = std::array::from_fn(|code| i32::from(SKIP_DISTANCES[code]));
        Self {
            simd,
            cells: &geometry.cells,
            bricks: &geometry.bricks,
            grids,
            skip_distances: simd.table(&skip_distances),
            ahead: [simd.table(&x), simd.table(&y), simd.table(&lower_z), simd.table(&upper_z)],
            blocks_ahead: [
                simd.table(&blocks(0b0101_0101, 0b1010_1010)),
                simd.table(&blocks(0b0011_0011, 0b1100_1100)),
                simd.table(&blocks(0b0000_1111, 0b1111_0000)),
            ],
        }
    }

    /// Finds the cells that the active lanes are in, and lets those that are bricks be fetched.
    ///
    /// # Safety
    /// The scene must be valid, and the voxels of active lanes must be ones that earlier steps or `enter` gave.
    #[inline(always)]
    pub unsafe fn look_ahead(&self, lanes: &mut Lanes) {
        let s = self.simd;
        let voxel =
            [s.load(&lanes.integers[VOXEL]), s.load(&lanes.integers[VOXEL + 1]), s.load(&lanes.integers[VOXEL + 2])];
        // SAFETY: the caller's duty.
        let (cell, shift, inside) = unsafe { self.cells_of(lanes, voxel) };
        s.store(&mut lanes.cell, cell);
        s.store(&mut lanes.shift, shift);
        lanes.inside = s.bits(inside);
        let in_brick = s.both(inside, s.is_negative(cell));
        let record = s.select(in_brick, s.shl(cell, 1), s.ints(0));
        let known = s.load(&lanes.record);
        if s.any(s.except(in_brick, s.eq(record, known))) {
            s.store(&mut lanes.record, record);
            for record in lanes.record {
                prefetch(self.bricks.as_ptr().wrapping_add(record as u32 as usize));
            }
        }
    }

    /// One step of all active lanes.
    ///
    /// # Safety
    /// As for [`Self::look_ahead`], which must have been called since they came there.
    #[inline(always)]
    pub unsafe fn step(&self, lanes: &mut Lanes) -> Step {
        let s = self.simd;
        let voxel =
            [s.load(&lanes.integers[VOXEL]), s.load(&lanes.integers[VOXEL + 1]), s.load(&lanes.integers[VOXEL + 2])];
        let sign = [
            s.load(&lanes.integers[SIGN_INDEX]),
            s.load(&lanes.integers[SIGN_INDEX + 1]),
            s.load(&lanes.integers[SIGN_INDEX + 2]),
        ];
        let (cell, shift, inside) = (s.load(&lanes.cell), s.load(&lanes.shift), s.mask(lanes.inside));
        // SAFETY: the caller's duty.
        let boxes = unsafe { self.boxes_of(lanes, voxel, sign, cell, shift, inside) };
        self.leave(lanes, voxel, sign, &boxes)
    }

    /// The cell of the finest level that is stored, log₂ of its size, and the lanes that are in the grid.
    ///
    /// # Safety
    /// As for [`Self::look_ahead`].
    #[inline(always)]
    unsafe fn cells_of(&self, lanes: &mut Lanes, voxel: [S::Ints; 3]) -> (S::Ints, S::Ints, S::Mask) {
        let s = self.simd;
        let active = s.mask(lanes.active);
        let node_at = [s.shr(voxel[0], 5), s.shr(voxel[1], 5), s.shr(voxel[2], 5)];
        let mut shift = s.ints(3);
        let mut cell = s.ints(0);
        let mut same_node = active;
        for axis in 0..3 {
            same_node = s.both(same_node, s.eq(node_at[axis], s.load(&lanes.node_at[axis])));
        }
        let (mut inside, mut in_node) = (active, same_node);
        let mut node = s.load(&lanes.node);
        let moved = s.except(active, same_node);
        if s.any(moved) {
            let top = self.grids.top(s, lanes, voxel);
            let mut known = moved;
            for axis in 0..3 {
                known = s.both(known, s.is_below(top[axis], self.grids.size(s, lanes, axis)));
            }
            inside = s.either(same_node, known);
            let row = s.add(s.mul(top[2], self.grids.size(s, lanes, 1)), top[1]);
            let index = s.add(s.mul(row, self.grids.size(s, lanes, 0)), top[0]);
            // SAFETY: `known` lanes are inside the top array of their grid.
            cell = unsafe { s.gather(cell, known, s.add(index, self.grids.offset(s, lanes)), self.cells) };
            // SAFETY: the caller's duty.
            let descent = unsafe { self.grids.descend(s, lanes, self.cells, voxel, cell, known) };
            cell = descent.cell;
            shift = s.select(known, descent.shift, shift);
            // These are in a node whose cells are bricks.
            let below = descent.in_node;
            if s.any(below) {
                node = s.select(below, s.shl(cell, 6), node);
                s.store(&mut lanes.node, node);
                for axis in 0..3 {
                    let at = s.select(below, node_at[axis], s.load(&lanes.node_at[axis]));
                    s.store(&mut lanes.node_at[axis], at);
                }
                shift = s.select(below, s.ints(3), shift);
                in_node = s.either(in_node, below);
            }
        }
        // SAFETY: `in_node` lanes have a node of bricks.
        cell = unsafe { s.gather(cell, in_node, s.add(node, cell_index(s, voxel, 3)), self.cells) };
        (cell, shift, inside)
    }

    /// The empty boxes around the lanes, and which lanes are in a voxel: within bricks, an empty 2³ or 4³ block, or all of the brick where
    /// nothing is ahead.
    ///
    /// # Safety
    /// As for [`Self::step`].
    #[inline(always)]
    unsafe fn boxes_of(
        &self,
        lanes: &Lanes,
        voxel: [S::Ints; 3],
        sign: [S::Ints; 3],
        cell: S::Ints,
        mut shift: S::Ints,
        inside: S::Mask,
    ) -> Boxes<S> {
        let s = self.simd;
        let (zero, one, three) = (s.ints(0), s.ints(1), s.ints(3));
        let in_brick = s.both(inside, s.is_negative(cell));
        let code = s.and(s.shr_each_unsigned(cell, s.load(&lanes.integers[SKIP_SHIFT])), s.ints(7));
        let mut count = s.choose(self.skip_distances, code);
        let mut hit = s.mask(0);
        if s.any(in_brick) {
            count = s.select(in_brick, one, count);
            let record = s.shl(cell, 1);
            // SAFETY: children of a valid scene's finest cells are brick records; the mask words that their headers
            // announce follow.
            let header = unsafe { s.gather(zero, in_brick, record, self.bricks) };
            let [x, y, z] = voxel;
            // Coordinate of the block, 0 or 2 for the table.
            let outer = [s.and(s.shr(x, 1), s.ints(2)), s.and(s.shr(y, 1), s.ints(2)), s.and(s.shr(z, 1), s.ints(2))];
            let block = s.or(s.shr(outer[0], 1), s.or(outer[1], s.shl(outer[2], 1)));
            let mut ahead = header;
            for axis in 0..3 {
                ahead = s.and(ahead, s.choose(self.blocks_ahead[axis], s.or(outer[axis], sign[axis])));
            }
            let own = s.shl_each(one, block);
            let others_ahead = s.test(s.and_not(own, ahead), s.ints(0xff));
            let has_block = s.both(in_brick, s.test(header, own));
            // Where no block ahead holds a voxel the brick is done, else the block is.
            shift = s.select(in_brick, s.select(others_ahead, s.ints(2), three), shift);
            if s.any(has_block) {
                let rank = popcount8(s, s.and(header, s.sub(own, one)));
                let at = s.add(record, s.add(s.shl(rank, 1), s.ints(2)));
                // SAFETY: as above.
                let (low, high) = unsafe {
                    (s.gather(zero, has_block, at, self.bricks), s.gather(zero, has_block, s.add(at, one), self.bricks))
                };
                let inner = [s.and(x, three), s.and(y, three), s.and(z, three)];
                let key = [s.or(inner[0], sign[0]), s.or(inner[1], sign[1]), s.or(inner[2], sign[2])];
                let plane = s.and(s.choose(self.ahead[0], key[0]), s.choose(self.ahead[1], key[1]));
                let low_ahead = s.and(low, s.choose(self.ahead[2], key[2]));
                let high_ahead = s.and(high, s.choose(self.ahead[3], key[2]));
                let any = s.and(plane, s.or(low_ahead, high_ahead));
                let is_ahead = s.both(has_block, s.test(any, any));
                // The half that holds the voxel.
                let half = s.select(s.test(inner[2], s.ints(2)), high, low);
                let bit = s.or(inner[0], s.or(s.shl(inner[1], 2), s.shl(s.and(inner[2], one), 4)));
                hit = s.both(is_ahead, s.test(half, s.shl_each(one, bit)));
                let eight = s.shr_each_unsigned(half, s.and(bit, s.ints(0b01010)));
                let is_small = s.both(is_ahead, s.test(eight, s.ints(0x0033_0033)));
                shift = s.select(is_small, zero, s.select(is_ahead, one, shift));
            }
        }
        Boxes { shift, count, inside, hit }
    }

    /// Where lanes meet the voxels that they are in: the face is that of the last of the planes through which they came.
    #[inline(always)]
    pub fn meet(&self, lanes: &Lanes) -> Met {
        let s = self.simd;
        let (mut t, mut sign) = ([s.floats(0.0); 3], [s.ints(0); 3]);
        for axis in 0..3 {
            sign[axis] = s.load(&lanes.integers[SIGN_INDEX + axis]);
            // Along − the far side of the voxel.
            let first = s.add(s.load(&lanes.integers[VOXEL + axis]), self.grids.origin(s, lanes, axis));
            let entry = s.to_floats(s.add(first, s.shr(sign[axis], 2)));
            let distance = s.sub_floats(entry, s.load_floats(&lanes.floats[ORIGIN + axis]));
            t[axis] = s.mul_floats(distance, s.load_floats(&lanes.floats[INVERSE + axis]));
        }
        let latest = s.max(s.max(t[0], t[1]), t[2]);
        // Three roundings each, of numbers that may be too small for their precision.
        let (scale, least) = (s.floats(4.0 * f32::EPSILON), s.floats(4.0 * f32::MIN_POSITIVE));
        let surely_before = s.sub_floats(latest, s.multiply_add(s.abs(latest), scale, least));
        let mut may_be_last = [s.mask(0); 3];
        for axis in 0..3 {
            let until = s.add_floats(t[axis], s.multiply_add(s.abs(t[axis]), scale, least));
            may_be_last[axis] = s.except(s.mask(Bits::MAX), s.lt_floats(until, surely_before));
        }
        let [x, y, z] = may_be_last;
        let several = s.either(s.both(x, y), s.both(z, s.either(x, y)));
        for axis in 0..3 {
            sign[axis] = s.add(s.ints(2 * axis as i32), s.shr(sign[axis], 2));
        }
        let face = s.select(z, sign[2], s.select(y, sign[1], sign[0]));
        let mut met = Met { t: [0.0; LANES], face: [0; LANES], sure: !s.bits(several) };
        s.store(bytemuck::cast_mut(&mut met.t), s.bits_of(latest));
        s.store(&mut met.face, face);
        met
    }

    /// Takes the lanes out of their boxes.
    #[inline(always)]
    fn leave(&self, lanes: &mut Lanes, voxel: [S::Ints; 3], sign: [S::Ints; 3], boxes: &Boxes<S>) -> Step {
        let s = self.simd;
        let one = s.ints(1);
        let last_negative = s.sub(one, boxes.count);
        let (mut exit, mut t) = ([one; 3], [s.floats(0.0); 3]);
        let mut is_negative = [boxes.hit; 3];
        for axis in 0..3 {
            is_negative[axis] = s.test(sign[axis], sign[axis]);
            let step = s.select(is_negative[axis], last_negative, boxes.count);
            let last = s.add(s.shr_each(voxel[axis], boxes.shift), step);
            exit[axis] = s.add(s.shl_each(last, boxes.shift), self.grids.origin(s, lanes, axis));
            let distance = s.sub_floats(s.to_floats(exit[axis]), s.load_floats(&lanes.floats[ORIGIN + axis]));
            t[axis] = s.mul_floats(distance, s.load_floats(&lanes.floats[INVERSE + axis]));
        }
        let first = s.min(t[0], s.min(t[1], t[2]));
        let all = s.mask(Bits::MAX);
        let on_x = s.eq_floats(t[0], first);
        let on_y = s.except(s.eq_floats(t[1], first), on_x);
        let on_axis = [on_x, on_y, s.except(all, s.either(on_x, on_y))];
        let in_segment = s.le_floats(first, s.load_floats(&lanes.floats[T_END]));
        let going = s.both(s.except(boxes.inside, boxes.hit), in_segment);
        let mut unsure = s.mask(0);
        let mut arrival = [one; 3];
        for axis in 0..3 {
            let step = s.mul_floats(s.load_floats(&lanes.floats[DIRECTION + axis]), first);
            let position = s.add_floats(s.load_floats(&lanes.floats[ORIGIN + axis]), step);
            let nearest = s.nearest(position);
            let difference = s.sub_floats(position, s.to_floats(nearest));
            let is_near = s.le_floats(s.abs(difference), s.load_floats(&lanes.floats[TOLERANCE + axis]));
            unsure = s.either(unsure, s.except(is_near, on_axis[axis]));
            let is_below = s.lt_floats(difference, s.floats(0.0));
            let floor = s.select(is_below, s.sub(nearest, one), nearest);
            let beyond = s.select(is_negative[axis], s.sub(exit[axis], one), exit[axis]);
            let reached = s.select(on_axis[axis], beyond, floor);
            arrival[axis] = s.sub(reached, self.grids.origin(s, lanes, axis));
        }
        let unsure = s.both(unsure, going);
        let sure = s.except(going, unsure);
        for axis in 0..3 {
            s.store(&mut lanes.integers[VOXEL + axis], s.select(sure, arrival[axis], voxel[axis]));
        }
        if s.any(unsure) {
            for axis in 0..3 {
                s.store(&mut lanes.exit[axis], exit[axis]);
            }
        }
        Step { active: s.bits(going), hit: s.bits(boxes.hit), unsure: s.bits(unsure) }
    }
}

/// Where the rays of lanes meet their voxels.
pub struct Met {
    t: [f32; LANES],
    face: [i32; LANES],
    /// Lanes of which f32 is sure.
    sure: Bits,
}

impl Met {
    /// The hit of a lane, as [`exact::hit_of`] finds it, of a segment that starts at `t_min`.
    #[inline(always)]
    pub fn hit(&self, lanes: &Lanes, lane: usize, voxel: IVec3, t_min: f32, instance: u32) -> Hit {
        if self.sure >> lane & 1 == 0 {
            return exact::hit_of(&LocalRay { t_min, ..lanes.local_ray(lane) }, voxel, instance);
        }
        let t = self.t[lane];
        Hit { t: if t > t_min { t } else { t_min }, instance, voxel, face: self.face[lane] as u32 }
    }
}

/// Position within its node of the cell of `1 << shift` voxels that holds a voxel.
#[inline(always)]
pub fn cell_index<S: Simd>(s: S, [x, y, z]: [S::Ints; 3], shift: u32) -> S::Ints {
    let three = s.ints(3);
    let [x, y, z] = [s.and(s.shr(x, shift), three), s.and(s.shr(y, shift), three), s.and(s.shr(z, shift), three)];
    s.or(x, s.or(s.shl(y, 2), s.shl(z, 4)))
}

/// Number of set bits among the lowest eight, which are the only ones set.
#[inline(always)]
fn popcount8<S: Simd>(s: S, bits: S::Ints) -> S::Ints {
    let pairs = s.sub(bits, s.and(s.shr(bits, 1), s.ints(0x55)));
    let fours = s.add(s.and(pairs, s.ints(0x33)), s.and(s.shr(pairs, 2), s.ints(0x33)));
    s.and(s.add(fours, s.shr(fours, 4)), s.ints(0xf))
}
