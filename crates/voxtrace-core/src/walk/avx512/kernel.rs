//! One step of sixteen rays, each in a place of its own: cells, headers and masks come by gathers.

use super::stream::{DIRECTION, INVERSE, Lanes, ORIGIN, SIGN, SKIP_SHIFT, T_END, TOLERANCE, VOXEL};
use super::vectors::{LANES, Mask, gather, load, loadf, store};
use crate::packed::{Geometry, PackedGrid, SKIP_DISTANCES};
use std::arch::x86_64::*;

/// What a step leaves to do.
pub struct Step {
    /// Lanes that go on.
    pub active: Mask,
    /// Lanes whose voxel is occupied; they do not go on.
    pub hit: Mask,
    /// Lanes that go on, whose voxel is still the old one: f32 is not sure where they leave the box.
    pub unsure: Mask,
}

/// What stays the same for all rays.
pub struct Kernel<'a> {
    cells: &'a [u32],
    bricks: &'a [u32],
    grid: &'a PackedGrid,
    origin: [__m512i; 3],
    skip_distances: __m512i,
    /// Bits of a block's half (32 voxels) ahead, by [sign × 4 + coordinate]: along x and y, and along z for the lower
    /// and the upper half.
    ahead: [__m512i; 4],
    /// Blocks of a brick ahead by [sign × 4 + coordinate] along x, y, z.
    blocks_ahead: [__m512i; 3],
}

impl<'a> Kernel<'a> {
    /// The kernel for a grid.
    #[target_feature(enable = "avx512f,avx512dq,avx512bw,avx512vl")]
    pub fn new(geometry: &'a Geometry, grid: &'a PackedGrid) -> Self {
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
        let skip_distances = std::array::from_fn(|code| i32::from(SKIP_DISTANCES[code & 7]));
        Self {
            cells: &geometry.cells,
            bricks: &geometry.bricks,
            grid,
            origin: grid.origin.to_array().map(|x| _mm512_set1_epi32(x)),
            skip_distances: load(&skip_distances),
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
    pub unsafe fn step(&self, lanes: &mut Lanes) -> Step {
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
        let code = _mm512_and_si512(_mm512_srlv_epi32(cell, load(&lanes.integers[SKIP_SHIFT])), _mm512_set1_epi32(7));
        let mut count = _mm512_permutexvar_epi32(code, self.skip_distances);

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
