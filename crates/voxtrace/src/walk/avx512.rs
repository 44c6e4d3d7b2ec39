//! The walk of sixteen rays at once, with AVX-512: the same steps as [`super::scalar`], a ray a lane, lanes refilled as
//! soon as their rays are done. Steps that are too near to a plane go to [`super::exact`], as there, so the
//! voxels are the same.

#![expect(clippy::needless_range_loop, reason = "an axis or a lane indexes several arrays")]
#![expect(unsafe_code, reason = "gathers, and calls of functions for certain processors")]

use super::exact;
use super::local_ray::{LocalRay, TOLERANCE_SCALE};
use super::scalar::Walk;
use crate::packed::{LEAPS, PackedGrid, PackedScene};
use crate::ray::Ray;
use crate::transform::Transform;
use glam::{IVec3, Vec3};
use std::arch::x86_64::*;

/// Rays that one vector holds.
const LANES: usize = 16;
/// Lanes without a ray before the kernel stops to refill them.
const REFILL_AT: u32 = 5;

/// Whether this processor has what [`first_voxels`] needs.
pub(super) fn is_available() -> bool {
    is_x86_feature_detected!("avx512f")
        && is_x86_feature_detected!("avx512dq")
        && is_x86_feature_detected!("avx512bw")
        && is_x86_feature_detected!("avx512vl")
}

/// Quantities of a ray that are f32: origin, direction, inverse and tolerance for each axis, end of the segment.
const FLOATS: usize = 13;
/// Quantities of a ray that are integers: the voxel (from the grid's origin) and the table index of the sign for each
/// axis, the position of the octant's leap in an empty cell, the ray's index.
const INTEGERS: usize = 8;

const ORIGIN: usize = 0;
const DIRECTION: usize = 3;
const INVERSE: usize = 6;
const TOLERANCE: usize = 9;
const T_END: usize = 12;

const VOXEL: usize = 0;
/// 4 where the direction is negative, else 0, for the tables of voxels ahead.
const SIGN: usize = 3;
/// 3 × the octant's number.
const LEAP_SHIFT: usize = 6;
const RAY: usize = 7;

/// Sixteen lanes and the rays in them: one array for each quantity.
#[repr(C, align(64))]
struct Lanes {
    floats: [[f32; LANES]; FLOATS],
    integers: [[i32; LANES]; INTEGERS],
    /// Position of the finest node visited last, in cells, and where it lies: its first voxel divided by 32.
    node: [i32; LANES],
    node_at: [[i32; LANES]; 3],
    /// Exit planes of the lanes' boxes, in grid space, as of the last step that left a lane unsure.
    exit: [[i32; LANES]; 3],
    active: __mmask16,
}

/// Finds the first voxel on the path of each ray through a grid and hands it to `found` with the ray's index; rays that
/// meet nothing are not handed over.
///
/// # Safety
/// The processor must have what [`is_available`] asks for, and `scene` must be valid as [`PackedScene::validate`] says.
#[target_feature(enable = "avx512f,avx512dq,avx512bw,avx512vl,popcnt,bmi1,bmi2,lzcnt,fma,avx2")]
pub(super) unsafe fn first_voxels(
    scene: &PackedScene,
    grid: &PackedGrid,
    grid_from_world: &Transform,
    rays: &[Ray],
    found: &mut impl FnMut(usize, IVec3),
) {
    let kernel = Kernel::new(scene, grid);
    let mut waiting = Waiting::new(rays, grid, grid_from_world);
    // Two groups, stepped in turn: while one waits for memory the other computes.
    let mut groups = [Lanes::empty(), Lanes::empty()];
    loop {
        for lanes in &mut groups {
            if lanes.active.count_zeros() >= REFILL_AT {
                waiting.fill(lanes);
            }
        }
        let [first, second] = &mut groups;
        if first.active | second.active == 0 {
            return;
        }
        // SAFETY: the scene is valid, so every position the kernel computes lies inside its array.
        let steps = unsafe { [kernel.step(first), kernel.step(second)] };
        for (lanes, step) in groups.iter_mut().zip(steps) {
            lanes.active = step.active;
            for lane in lanes_of(step.unsure) {
                lanes.decide(lane, grid);
            }
            for lane in lanes_of(step.hit) {
                found(lanes.integers[RAY][lane] as usize, lanes.voxel_of(lane) + grid.origin);
            }
        }
    }
}

/// The set lanes of a mask.
#[inline(always)]
fn lanes_of(mut mask: __mmask16) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let lane = mask.trailing_zeros() as usize;
        mask &= mask.wrapping_sub(1);
        (lane < LANES).then_some(lane)
    })
}

impl Lanes {
    fn empty() -> Self {
        Self {
            floats: [[0.0; LANES]; FLOATS],
            integers: [[0; LANES]; INTEGERS],
            node: [0; LANES],
            node_at: [[i32::MIN; LANES]; 3],
            exit: [[0; LANES]; 3],
            active: 0,
        }
    }

    #[inline(always)]
    fn voxel_of(&self, lane: usize) -> IVec3 {
        IVec3::from_array(std::array::from_fn(|axis| self.integers[VOXEL + axis][lane]))
    }

    /// Takes the step of a lane that f32 is not sure about.
    #[cold]
    fn decide(&mut self, lane: usize, grid: &PackedGrid) {
        let vector = |first: usize| Vec3::from_array(std::array::from_fn(|axis| self.floats[first + axis][lane]));
        let local = LocalRay {
            origin: vector(ORIGIN),
            direction: vector(DIRECTION),
            inverse: vector(INVERSE),
            t_min: 0.0,
            t_max: f32::INFINITY,
        };
        let exit = IVec3::from_array(std::array::from_fn(|axis| self.exit[axis][lane]));
        let arrival = exact::leave_box(&local, self.voxel_of(lane) + grid.origin, exit);
        // A local ray crosses some plane of every box.
        let relative = arrival.map_or(IVec3::NEG_ONE, |voxel| voxel - grid.origin);
        for axis in 0..3 {
            self.integers[VOXEL + axis][lane] = relative[axis];
        }
    }
}

/// Rays prepared at a time.
const CHUNK: usize = 256;

/// Rays that are ready to be put into lanes, and those that are still to be prepared.
struct Waiting<'a> {
    rays: &'a [Ray],
    /// Rays prepared so far.
    prepared: usize,
    grid: &'a PackedGrid,
    grid_from_world: &'a Transform,
    /// One array for each quantity; a vector more than a chunk, so that whole vectors can be read and written.
    floats: [[f32; CHUNK + LANES]; FLOATS],
    integers: [[i32; CHUNK + LANES]; INTEGERS],
    /// The ready rays are `next..end`.
    next: usize,
    end: usize,
}

impl<'a> Waiting<'a> {
    fn new(rays: &'a [Ray], grid: &'a PackedGrid, grid_from_world: &'a Transform) -> Self {
        let (floats, integers) = ([[0.0; CHUNK + LANES]; FLOATS], [[0; CHUNK + LANES]; INTEGERS]);
        Self { rays, prepared: 0, grid, grid_from_world, floats, integers, next: 0, end: 0 }
    }

    /// Puts ready rays into all free lanes, or as many as there are.
    #[inline]
    #[target_feature(enable = "avx512f,avx512dq,avx512bw,avx512vl,popcnt,bmi1,bmi2,lzcnt,fma,avx2")]
    fn fill(&mut self, lanes: &mut Lanes) {
        while lanes.active != 0xffff {
            if self.next == self.end && !self.prepare() {
                return;
            }
            let free = !lanes.active;
            let count = (free.count_ones() as usize).min(self.end - self.next);
            // The lowest `count` free lanes.
            let mask = _pdep_u32((1 << count) - 1, u32::from(free)) as __mmask16;
            for (lane, ready) in lanes.floats.iter_mut().zip(&self.floats) {
                let ready = loadf(window(ready, self.next));
                let filled = _mm512_mask_expand_ps(loadf(lane), mask, ready);
                storef(lane, filled);
            }
            for (lane, ready) in lanes.integers.iter_mut().zip(&self.integers) {
                let filled = _mm512_mask_expand_epi32(load(lane), mask, load(window(ready, self.next)));
                store(lane, filled);
            }
            // No voxel lies in such a node.
            let nowhere = _mm512_mask_mov_epi32(load(&lanes.node_at[0]), mask, _mm512_set1_epi32(i32::MIN));
            store(&mut lanes.node_at[0], nowhere);
            lanes.active |= mask;
            self.next += count;
        }
    }

    /// Prepares the next rays. Returns false when there are none left.
    #[target_feature(enable = "avx512f,avx512dq,avx512bw,avx512vl,popcnt,bmi1,bmi2,lzcnt,fma,avx2")]
    fn prepare(&mut self) -> bool {
        (self.next, self.end) = (0, 0);
        let is_identity = *self.grid_from_world == Transform::IDENTITY;
        while self.end == 0 && self.prepared < self.rays.len() {
            let chunk_end = self.rays.len().min(self.prepared + CHUNK);
            while self.prepared < chunk_end {
                let count = LANES.min(chunk_end - self.prepared);
                let plain = if is_identity && count == LANES { self.prepare_vector() } else { 0 };
                for lane in lanes_of(!plain & (0xffff >> (LANES - count))) {
                    self.prepare_one(self.prepared + lane);
                }
                self.prepared += count;
            }
        }
        self.end > 0
    }

    /// Prepares those of the next sixteen rays that need no special care: that start within the grid's bounds, at t = 0,
    /// and move along every axis at a sensible speed. Returns which they are. The grid must not be transformed.
    #[target_feature(enable = "avx512f,avx512dq,avx512bw,avx512vl,popcnt,bmi1,bmi2,lzcnt,fma,avx2")]
    fn prepare_vector(&mut self) -> __mmask16 {
        let rays = &self.rays[self.prepared..self.prepared + LANES];
        let words: &[u32] = bytemuck::cast_slice(rays);
        let stride = _mm512_mullo_epi32(lane_numbers(), _mm512_set1_epi32(8));
        // SAFETY: sixteen rays of eight words each.
        let word = |at: i32| unsafe {
            let index = _mm512_add_epi32(stride, _mm512_set1_epi32(at));
            _mm512_castsi512_ps(gather(_mm512_setzero_si512(), 0xffff, index, words))
        };
        let (t_min, t_max) = (word(3), word(7));
        let zero = _mm512_setzero_ps();
        let mut plain = _mm512_cmp_ps_mask::<_CMP_EQ_OQ>(t_min, zero);
        plain = _mm512_mask_cmp_ps_mask::<_CMP_GE_OQ>(plain, t_max, zero);
        let end = self.end;
        let mut leap_shift = _mm512_setzero_si512();
        let mut floats = [zero; FLOATS];
        let mut integers = [_mm512_setzero_si512(); INTEGERS];
        for axis in 0..3 {
            let (origin, direction) = (word(axis as i32), word(4 + axis as i32));
            // Speeds between 1e-18 and 1e18 along every axis satisfy all that `LocalRay::new` asks of them.
            let speed = _mm512_abs_ps(direction);
            plain = _mm512_mask_cmp_ps_mask::<_CMP_GE_OQ>(plain, speed, _mm512_set1_ps(1e-18));
            plain = _mm512_mask_cmp_ps_mask::<_CMP_LE_OQ>(plain, speed, _mm512_set1_ps(1e18));
            let low = _mm512_set1_ps(self.grid.min[axis] as f32);
            let high = _mm512_set1_ps(self.grid.max[axis] as f32);
            plain = _mm512_mask_cmp_ps_mask::<_CMP_GE_OQ>(plain, origin, low);
            plain = _mm512_mask_cmp_ps_mask::<_CMP_LT_OQ>(plain, origin, high);
            let extent = self.grid.min[axis].abs().max(self.grid.max[axis].abs()) as f32 + 1.0;
            let reach = _mm512_add_ps(_mm512_abs_ps(origin), _mm512_set1_ps(extent));
            floats[ORIGIN + axis] = origin;
            floats[DIRECTION + axis] = direction;
            floats[INVERSE + axis] = _mm512_div_ps(_mm512_set1_ps(1.0), direction);
            floats[TOLERANCE + axis] = _mm512_mul_ps(reach, _mm512_set1_ps(TOLERANCE_SCALE));
            let floor = _mm512_cvt_roundps_epi32::<{ _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC }>(origin);
            integers[VOXEL + axis] = _mm512_sub_epi32(floor, _mm512_set1_epi32(self.grid.origin[axis]));
            let is_negative = _mm512_cmp_ps_mask::<_CMP_LT_OQ>(direction, zero);
            integers[SIGN + axis] = _mm512_maskz_set1_epi32(is_negative, 4);
            let bit = _mm512_maskz_set1_epi32(is_negative, 3 << axis);
            leap_shift = _mm512_add_epi32(leap_shift, bit);
        }
        let t_end = _mm512_mul_ps(t_max, _mm512_set1_ps(1.0 + 1e-6));
        floats[T_END] = _mm512_min_ps(t_end, _mm512_set1_ps(f32::MAX));
        integers[LEAP_SHIFT] = leap_shift;
        integers[RAY] = _mm512_add_epi32(lane_numbers(), _mm512_set1_epi32(self.prepared as i32));
        for (ready, values) in self.floats.iter_mut().zip(floats) {
            storef(window_mut(ready, end), _mm512_maskz_compress_ps(plain, values));
        }
        for (ready, values) in self.integers.iter_mut().zip(integers) {
            store(window_mut(ready, end), _mm512_maskz_compress_epi32(plain, values));
        }
        self.end += plain.count_ones() as usize;
        plain
    }

    /// Prepares any ray.
    #[cold]
    fn prepare_one(&mut self, index: usize) {
        let Some(local) = LocalRay::new(&self.rays[index], self.grid_from_world) else { return };
        let walk = Walk::new(&local, self.grid);
        let Some(voxel) = walk.enter(self.grid, walk.start_voxel()) else { return };
        let (relative, octant, at) = (voxel - self.grid.origin, local.octant(), self.end);
        for axis in 0..3 {
            self.floats[ORIGIN + axis][at] = local.origin[axis];
            self.floats[DIRECTION + axis][at] = local.direction[axis];
            self.floats[INVERSE + axis][at] = local.inverse[axis];
            self.floats[TOLERANCE + axis][at] = walk.tolerance[axis];
            self.integers[VOXEL + axis][at] = relative[axis];
            self.integers[SIGN + axis][at] = 4 * (octant as i32 >> axis & 1);
        }
        self.floats[T_END][at] = local.t_end();
        self.integers[LEAP_SHIFT][at] = 3 * octant as i32;
        self.integers[RAY][at] = index as i32;
        self.end += 1;
    }
}

/// The vector of an array that begins at `start`.
#[inline(always)]
fn window<T>(values: &[T; CHUNK + LANES], start: usize) -> &[T; LANES] {
    values[start..].first_chunk().expect("arrays are a vector longer than a chunk")
}

/// The vector of an array that begins at `start`, to be written.
#[inline(always)]
fn window_mut<T>(values: &mut [T; CHUNK + LANES], start: usize) -> &mut [T; LANES] {
    values[start..].first_chunk_mut().expect("arrays are a vector longer than a chunk")
}

#[inline]
#[target_feature(enable = "avx512f")]
fn lane_numbers() -> __m512i {
    _mm512_set_epi32(15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0)
}

/// What a step leaves to do.
struct Step {
    /// Lanes that go on.
    active: __mmask16,
    /// Lanes whose voxel is occupied; they do not go on.
    hit: __mmask16,
    /// Lanes that go on, whose voxel is still the old one: f32 is not sure where they leave the box.
    unsure: __mmask16,
}

/// What stays the same for all rays.
struct Kernel<'a> {
    cells: &'a [u32],
    bricks: &'a [u32],
    grid: &'a PackedGrid,
    origin: [__m512i; 3],
    leaps: __m512i,
    /// Bits of a block's half (32 voxels) ahead, by [sign × 4 + coordinate]: along x and y, and along z for the lower
    /// and the upper half.
    ahead: [__m512i; 4],
    /// Blocks of a brick ahead by [sign × 4 + coordinate] along x, y, z.
    blocks_ahead: [__m512i; 3],
}

impl<'a> Kernel<'a> {
    #[target_feature(enable = "avx512f,avx512dq,avx512bw,avx512vl")]
    fn new(scene: &'a PackedScene, grid: &'a PackedGrid) -> Self {
        let table = |entry: &dyn Fn(u32, bool) -> u32| {
            let mut entries = [0; LANES];
            for (index, value) in entries.iter_mut().enumerate().take(8) {
                *value = entry(index as u32 & 3, index >= 4) as i32;
            }
            load(&entries)
        };
        // Bits of `all` from coordinate c on, or up to it, where a coordinate step is `stride` bits.
        let ahead = |all: u64, stride: u32, c: u32, is_negative: bool| {
            if is_negative { all >> (stride * (3 - c)) } else { all << (stride * c) & all }
        };
        let x = |c, is_negative| ahead(0xf, 1, c, is_negative) as u32 * 0x1111_1111;
        let y = |c, is_negative| ahead(0xffff, 4, c, is_negative) as u32 * 0x1_0001;
        let z = |c, is_negative| ahead(u64::MAX, 16, c, is_negative);
        let blocks = |near: u32, far: u32| {
            move |c: u32, is_negative: bool| match (c >> 1, is_negative) {
                (0, false) | (1, true) => near | far,
                (0, true) => near,
                _ => far,
            }
        };
        let leaps = std::array::from_fn(|code| i32::from(LEAPS[code & 7]));
        Self {
            cells: &scene.cells,
            bricks: &scene.bricks,
            grid,
            origin: grid.origin.to_array().map(|x| _mm512_set1_epi32(x)),
            leaps: load(&leaps),
            ahead: [
                table(&x),
                table(&y),
                table(&|c, is_negative| z(c, is_negative) as u32),
                table(&|c, is_negative| (z(c, is_negative) >> 32) as u32),
            ],
            blocks_ahead: [
                table(&blocks(0b0101_0101, 0b1010_1010)),
                table(&blocks(0b0011_0011, 0b1100_1100)),
                table(&blocks(0b0000_1111, 0b1111_0000)),
            ],
        }
    }

    /// One step of all active lanes.
    ///
    /// # Safety
    /// The scene must be valid, and the voxels of active lanes must be ones that earlier steps or `enter` gave.
    #[inline]
    #[target_feature(enable = "avx512f,avx512dq,avx512bw,avx512vl")]
    unsafe fn step(&self, lanes: &mut Lanes) -> Step {
        let active = lanes.active;
        let one = _mm512_set1_epi32(1);
        let three = _mm512_set1_epi32(3);
        let integers = |first: usize| [0, 1, 2].map(|axis| load(&lanes.integers[first + axis]));
        let (voxel, sign) = (integers(VOXEL), integers(SIGN));

        // 1. The cell of the finest level that is stored, and log₂ of its size.
        let node_at =
            [_mm512_srai_epi32::<5>(voxel[0]), _mm512_srai_epi32::<5>(voxel[1]), _mm512_srai_epi32::<5>(voxel[2])];
        let mut shift = three;
        let mut cell = _mm512_setzero_si512();
        let mut inside = active;
        let mut same_node = active;
        for axis in 0..3 {
            same_node = _mm512_mask_cmpeq_epi32_mask(same_node, node_at[axis], load(&lanes.node_at[axis]));
        }
        let mut in_node = same_node;
        let mut node = load(&lanes.node);
        let moved = active & !same_node;
        if moved != 0 {
            let top_shift = _mm_cvtsi32_si128(self.grid.top_shift as i32);
            let top = voxel.map(|v| _mm512_sra_epi32(v, top_shift));
            let mut known = moved;
            for (axis, &coordinate) in top.iter().enumerate() {
                // Unsigned: what is below the origin is beyond the end.
                let size = _mm512_set1_epi32(self.grid.top_size[axis]);
                known = _mm512_mask_cmplt_epu32_mask(known, coordinate, size);
            }
            inside = same_node | known;
            let size = self.grid.top_size;
            let row = _mm512_mullo_epi32(top[2], _mm512_set1_epi32(size.y));
            let row = _mm512_mullo_epi32(_mm512_add_epi32(row, top[1]), _mm512_set1_epi32(size.x));
            let index = _mm512_add_epi32(row, top[0]);
            let index = _mm512_add_epi32(index, _mm512_set1_epi32(self.grid.top_offset as i32));
            // SAFETY: `known` lanes are inside the top array.
            cell = unsafe { gather(cell, known, index, self.cells) };
            let mut level = self.grid.top_shift;
            shift = _mm512_mask_mov_epi32(shift, known, _mm512_set1_epi32(level as i32));
            let mut below = _mm512_mask_cmplt_epi32_mask(known, cell, _mm512_setzero_si512());
            while level > 5 && below != 0 {
                level -= 2;
                let at = child_position(cell, voxel, level);
                // SAFETY: children of a valid scene's cells are nodes.
                cell = unsafe { gather(cell, below, at, self.cells) };
                shift = _mm512_mask_mov_epi32(shift, below, _mm512_set1_epi32(level as i32));
                below = _mm512_mask_cmplt_epi32_mask(below, cell, _mm512_setzero_si512());
            }
            if level == 5 {
                // These are in a node whose cells are bricks.
                node = _mm512_mask_slli_epi32::<6>(node, below, cell);
                store(&mut lanes.node, node);
                for axis in 0..3 {
                    let at = _mm512_mask_mov_epi32(load(&lanes.node_at[axis]), below, node_at[axis]);
                    store(&mut lanes.node_at[axis], at);
                }
                shift = _mm512_mask_mov_epi32(shift, below, three);
                in_node |= below;
            }
        }
        let local = cell_index(voxel, 3);
        // SAFETY: `in_node` lanes have a node of bricks.
        cell = unsafe { gather(cell, in_node, _mm512_add_epi32(node, local), self.cells) };
        let in_brick = _mm512_mask_cmplt_epi32_mask(inside, cell, _mm512_setzero_si512());
        let code = _mm512_and_si512(_mm512_srlv_epi32(cell, load(&lanes.integers[LEAP_SHIFT])), _mm512_set1_epi32(7));
        let mut count = _mm512_permutexvar_epi32(code, self.leaps);

        // 2. Within bricks: a voxel, an empty 2³ or 4³ block, or nothing ahead.
        let mut hit = 0;
        if in_brick != 0 {
            count = _mm512_mask_mov_epi32(count, in_brick, one);
            let record = _mm512_slli_epi32::<1>(cell);
            // SAFETY: children of a valid scene's finest cells are brick records; the mask words that their headers
            // announce follow.
            let header = unsafe { gather(_mm512_setzero_si512(), in_brick, record, self.bricks) };
            let inner: [__m512i; 3] = std::array::from_fn(|axis| _mm512_and_si512(voxel[axis], three));
            // Coordinate of the block, 0 or 2 for the table.
            let outer: [__m512i; 3] =
                std::array::from_fn(|axis| _mm512_and_si512(_mm512_srli_epi32::<1>(voxel[axis]), _mm512_set1_epi32(2)));
            let block = _mm512_or_si512(
                _mm512_srli_epi32::<1>(outer[0]),
                _mm512_or_si512(outer[1], _mm512_slli_epi32::<1>(outer[2])),
            );
            let look = |axis: usize| {
                _mm512_permutexvar_epi32(_mm512_or_si512(outer[axis], sign[axis]), self.blocks_ahead[axis])
            };
            let ahead = _mm512_and_si512(_mm512_and_si512(look(0), look(1)), _mm512_and_si512(look(2), header));
            let own = _mm512_sllv_epi32(one, block);
            let others_ahead = _mm512_test_epi32_mask(_mm512_andnot_si512(own, ahead), _mm512_set1_epi32(0xff));
            let has_block = _mm512_mask_test_epi32_mask(in_brick, header, own);
            // Where no block ahead holds a voxel the brick is done, else the block is.
            let size = _mm512_mask_mov_epi32(three, others_ahead, _mm512_set1_epi32(2));
            shift = _mm512_mask_mov_epi32(shift, in_brick, size);
            if has_block != 0 {
                let before = _mm512_and_si512(header, _mm512_sub_epi32(own, one));
                let rank = popcount8(before);
                let at = _mm512_add_epi32(record, _mm512_add_epi32(_mm512_slli_epi32::<1>(rank), _mm512_set1_epi32(2)));
                // SAFETY: as above.
                let low = unsafe { gather(_mm512_setzero_si512(), has_block, at, self.bricks) };
                // SAFETY: as above.
                let high = unsafe { gather(low, has_block, _mm512_add_epi32(at, one), self.bricks) };
                let key = |axis: usize| _mm512_or_si512(inner[axis], sign[axis]);
                let (kx, ky, kz) = (key(0), key(1), key(2));
                let plane = _mm512_and_si512(
                    _mm512_permutexvar_epi32(kx, self.ahead[0]),
                    _mm512_permutexvar_epi32(ky, self.ahead[1]),
                );
                let low_ahead = _mm512_and_si512(low, _mm512_permutexvar_epi32(kz, self.ahead[2]));
                let high_ahead = _mm512_and_si512(high, _mm512_permutexvar_epi32(kz, self.ahead[3]));
                let any = _mm512_and_si512(plane, _mm512_or_si512(low_ahead, high_ahead));
                let is_ahead = _mm512_mask_test_epi32_mask(has_block, any, any);
                // The half that holds the voxel.
                let is_upper = _mm512_test_epi32_mask(inner[2], _mm512_set1_epi32(2));
                let half = _mm512_mask_mov_epi32(low, is_upper, high);
                let bit = _mm512_or_si512(
                    inner[0],
                    _mm512_or_si512(
                        _mm512_slli_epi32::<2>(inner[1]),
                        _mm512_slli_epi32::<4>(_mm512_and_si512(inner[2], one)),
                    ),
                );
                hit = _mm512_mask_test_epi32_mask(is_ahead, half, _mm512_sllv_epi32(one, bit));
                let corner = _mm512_and_si512(bit, _mm512_set1_epi32(0b01010));
                let eight = _mm512_srlv_epi32(half, corner);
                let is_small = _mm512_mask_test_epi32_mask(is_ahead, eight, _mm512_set1_epi32(0x0033_0033));
                shift = _mm512_mask_mov_epi32(shift, is_ahead, one);
                shift = _mm512_mask_mov_epi32(shift, is_small, _mm512_setzero_si512());
            }
        }

        // 3. Leave the box.
        let last_negative = _mm512_sub_epi32(one, count);
        let mut exit = [_mm512_setzero_si512(); 3];
        let mut t = [_mm512_setzero_ps(); 3];
        let mut is_negative = [0; 3];
        for axis in 0..3 {
            is_negative[axis] = _mm512_test_epi32_mask(sign[axis], sign[axis]);
            let step = _mm512_mask_mov_epi32(count, is_negative[axis], last_negative);
            let last = _mm512_add_epi32(_mm512_srav_epi32(voxel[axis], shift), step);
            exit[axis] = _mm512_add_epi32(_mm512_sllv_epi32(last, shift), self.origin[axis]);
            let distance = _mm512_sub_ps(_mm512_cvtepi32_ps(exit[axis]), loadf(&lanes.floats[ORIGIN + axis]));
            t[axis] = _mm512_mul_ps(distance, loadf(&lanes.floats[INVERSE + axis]));
        }
        let first = _mm512_min_ps(t[0], _mm512_min_ps(t[1], t[2]));
        let on_x = _mm512_cmp_ps_mask::<_CMP_EQ_OQ>(t[0], first);
        let on_y = !on_x & _mm512_cmp_ps_mask::<_CMP_EQ_OQ>(t[1], first);
        let on_axis = [on_x, on_y, !(on_x | on_y)];
        let going = _mm512_mask_cmp_ps_mask::<_CMP_LE_OQ>(inside & !hit, first, loadf(&lanes.floats[T_END]));
        let mut unsure = 0;
        let mut arrival = [_mm512_setzero_si512(); 3];
        for axis in 0..3 {
            let step = _mm512_mul_ps(loadf(&lanes.floats[DIRECTION + axis]), first);
            let position = _mm512_add_ps(loadf(&lanes.floats[ORIGIN + axis]), step);
            let nearest = _mm512_cvtps_epi32(position);
            let difference = _mm512_sub_ps(position, _mm512_cvtepi32_ps(nearest));
            let is_near =
                _mm512_cmp_ps_mask::<_CMP_LE_OQ>(_mm512_abs_ps(difference), loadf(&lanes.floats[TOLERANCE + axis]));
            unsure |= is_near & !on_axis[axis];
            let is_below = _mm512_cmp_ps_mask::<_CMP_LT_OQ>(difference, _mm512_setzero_ps());
            let floor = _mm512_mask_sub_epi32(nearest, is_below, nearest, one);
            let beyond = _mm512_mask_sub_epi32(exit[axis], is_negative[axis], exit[axis], one);
            let reached = _mm512_mask_mov_epi32(floor, on_axis[axis], beyond);
            arrival[axis] = _mm512_sub_epi32(reached, self.origin[axis]);
        }
        let unsure = unsure & going;
        let sure = going & !unsure;
        for axis in 0..3 {
            store(&mut lanes.integers[VOXEL + axis], _mm512_mask_mov_epi32(voxel[axis], sure, arrival[axis]));
        }
        if unsure != 0 {
            for axis in 0..3 {
                store(&mut lanes.exit[axis], exit[axis]);
            }
        }
        Step { active: going, hit, unsure }
    }
}

/// Position, in cells, of the cell of `1 << shift` voxels that holds a voxel, in the node that a cell holds.
#[inline]
#[target_feature(enable = "avx512f")]
fn child_position(cell: __m512i, voxel: [__m512i; 3], shift: u32) -> __m512i {
    _mm512_add_epi32(_mm512_slli_epi32::<6>(cell), cell_index(voxel, shift))
}

/// Position within its node of the cell that holds a voxel.
#[inline]
#[target_feature(enable = "avx512f")]
fn cell_index(voxel: [__m512i; 3], shift: u32) -> __m512i {
    let count = _mm_cvtsi32_si128(shift as i32);
    let three = _mm512_set1_epi32(3);
    let [x, y, z] = voxel.map(|v| _mm512_and_si512(_mm512_srl_epi32(v, count), three));
    _mm512_or_si512(x, _mm512_or_si512(_mm512_slli_epi32::<2>(y), _mm512_slli_epi32::<4>(z)))
}

/// Number of set bits among the lowest eight, which are the only ones set.
#[inline]
#[target_feature(enable = "avx512f")]
fn popcount8(bits: __m512i) -> __m512i {
    let pairs = _mm512_sub_epi32(bits, _mm512_and_si512(_mm512_srli_epi32::<1>(bits), _mm512_set1_epi32(0x55)));
    let two = _mm512_set1_epi32(0x33);
    let fours = _mm512_add_epi32(_mm512_and_si512(pairs, two), _mm512_and_si512(_mm512_srli_epi32::<2>(pairs), two));
    _mm512_and_si512(_mm512_add_epi32(fours, _mm512_srli_epi32::<4>(fours)), _mm512_set1_epi32(0xf))
}

#[inline]
#[target_feature(enable = "avx512f")]
fn load(values: &[i32; LANES]) -> __m512i {
    // SAFETY: the array is as large as the vector; unaligned loads need no alignment.
    unsafe { _mm512_loadu_si512(values.as_ptr().cast()) }
}

#[inline]
#[target_feature(enable = "avx512f")]
fn loadf(values: &[f32; LANES]) -> __m512 {
    // SAFETY: as in `load`.
    unsafe { _mm512_loadu_ps(values.as_ptr()) }
}

#[inline]
#[target_feature(enable = "avx512f")]
fn store(values: &mut [i32; LANES], vector: __m512i) {
    // SAFETY: as in `load`.
    unsafe { _mm512_storeu_si512(values.as_mut_ptr().cast(), vector) }
}

#[inline]
#[target_feature(enable = "avx512f")]
fn storef(values: &mut [f32; LANES], vector: __m512) {
    // SAFETY: as in `load`.
    unsafe { _mm512_storeu_ps(values.as_mut_ptr(), vector) }
}

/// `words[index]` for the lanes of `mask`, `otherwise` for the rest.
///
/// # Safety
/// The indices of the lanes of `mask` must lie inside `words`.
#[inline]
#[target_feature(enable = "avx512f")]
unsafe fn gather(otherwise: __m512i, mask: __mmask16, index: __m512i, words: &[u32]) -> __m512i {
    // SAFETY: the caller's duty.
    unsafe { _mm512_mask_i32gather_epi32::<4>(otherwise, mask, index, words.as_ptr().cast()) }
}
