//! Rays in any order: a ray a lane, lanes refilled as soon as their rays are done.

use super::Groups;
use super::kernel::Kernel;
use super::vectors::{LANES, Mask, gather, lanes_of, load, loadf, store, storef};
use crate::packed::{Geometry, PackedGrid};
use crate::walk::exact;
use crate::walk::local_ray::{LocalRay, T_END_SCALE, TOLERANCE_SCALE};
use crate::walk::scalar::Walk;
use glam::{IVec3, Vec3};
use std::arch::x86_64::*;
use voxtrace_scene::ray::Ray;
use voxtrace_scene::transform::Transform;

/// Lanes without a ray before the kernel stops to refill them.
const REFILL_AT: u32 = 5;

/// Quantities of a ray that are f32: origin, direction, inverse and tolerance for each axis, end of the segment.
const FLOATS: usize = 13;
/// Quantities of a ray that are integers: the voxel (from the grid's origin) and the table index of the sign for each
/// axis, the position of the octant's skip distance in an empty cell, the ray's index.
const INTEGERS: usize = 8;

pub const ORIGIN: usize = 0;
pub const DIRECTION: usize = 3;
pub const INVERSE: usize = 6;
pub const TOLERANCE: usize = 9;
pub const T_END: usize = 12;

pub const VOXEL: usize = 0;
/// 4 where the direction is negative, else 0, for the tables of voxels ahead.
pub const SIGN: usize = 3;
/// 3 × the octant's number.
pub const SKIP_SHIFT: usize = 6;
const RAY: usize = 7;

/// Sixteen lanes and the rays in them: one array for each quantity.
#[repr(C, align(64))]
pub struct Lanes {
    pub floats: [[f32; LANES]; FLOATS],
    pub integers: [[i32; LANES]; INTEGERS],
    /// Position of the finest node visited last, in cells, and where it lies: its first voxel divided by 32.
    pub node: [i32; LANES],
    pub node_at: [[i32; LANES]; 3],
    /// Exit planes of the lanes' boxes, in grid space, as of the last step that left a lane unsure.
    pub exit: [[i32; LANES]; 3],
    pub active: Mask,
}

/// Finds the first voxel on the path of each ray through a grid, but of those in groups that are done, and hands it to
/// `found` with the ray's index; rays that meet nothing are not handed over.
///
/// # Safety
/// The processor must have what [`super::is_available`] asks for, and `geometry` must be valid as [`Geometry::validate`] says.
#[target_feature(enable = "avx512f,avx512dq,avx512bw,avx512vl,popcnt,bmi1,bmi2,lzcnt,fma,avx2")]
pub unsafe fn first_voxels(
    geometry: &Geometry,
    grid: &PackedGrid,
    grid_from_world: &Transform,
    rays: &[Ray],
    done: &Groups,
    found: &mut impl FnMut(usize, IVec3),
) {
    let kernel = Kernel::new(geometry, grid);
    let mut waiting = Waiting::new(rays, done, grid, grid_from_world);
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
    done: &'a Groups,
    /// Rays prepared so far, or done before: always whole groups.
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
    fn new(rays: &'a [Ray], done: &'a Groups, grid: &'a PackedGrid, grid_from_world: &'a Transform) -> Self {
        let (floats, integers) = ([[0.0; CHUNK + LANES]; FLOATS], [[0; CHUNK + LANES]; INTEGERS]);
        Self { rays, done, prepared: 0, grid, grid_from_world, floats, integers, next: 0, end: 0 }
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
            let mask = _pdep_u32((1 << count) - 1, u32::from(free)) as Mask;
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
                if self.done.contains(self.prepared / LANES) {
                    self.prepared += count;
                    continue;
                }
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
    fn prepare_vector(&mut self) -> Mask {
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
        let mut skip_shift = _mm512_setzero_si512();
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
            skip_shift = _mm512_add_epi32(skip_shift, bit);
        }
        let t_end = _mm512_mul_ps(t_max, _mm512_set1_ps(T_END_SCALE));
        floats[T_END] = _mm512_min_ps(t_end, _mm512_set1_ps(f32::MAX));
        integers[SKIP_SHIFT] = skip_shift;
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
        self.integers[SKIP_SHIFT][at] = 3 * octant as i32;
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
