//! Beams: the rays of a packet followed together through the empty space before them (after the entry points of
//! Reshetov, Soupikov, Hurley, "Multi-Level Ray Tracing Algorithm", SIGGRAPH 2005).
//!
//! Four beams are followed at once, each in four lanes: the corners of the rectangle in which the beam's rays cross a
//! plane of the main axis. An empty box around each corner says how far the whole beam may go. All of it is conservative:
//! where a beam stops only decides where the exact walk of its rays begins.

use super::cells::{Map, Memory};
use super::octant::OCTANTS;
use super::packet::block_of;
use super::shared::Shared;
use super::vectors::{LANES, Mask, floor, load, store};
use std::arch::x86_64::*;

/// Beams followed at once.
pub const BEAMS: usize = 4;
/// A plane that is never reached.
const FAR: i32 = 1 << 28;
/// Lanes of the corners that are farther along the first and the second minor axis.
const FAR_CORNERS: [Mask; 2] = [0b1010_1010_1010_1010, 0b1100_1100_1100_1100];
/// Exchange a corner with the other one along the first and the second minor axis.
const SWAP: [i32; 2] = [0b10_11_00_01, 0b01_00_11_10];
/// Sixteen roundings, relative to the coordinates involved.
const MARGIN: f32 = 8.0 * f32::EPSILON;
/// Steepest slope that a beam may have.
const STEEPEST: f32 = 256.0;

/// Least and largest slopes of a beam's rays along the two minor axes: movement for each voxel along the main axis.
pub type Slopes = [[f32; 2]; 2];

/// Where a beam ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// Nothing is met before this turned plane of the main axis.
    At(i32),
    /// It left the grid and met nothing.
    Left,
}

/// The axes across the main axis.
pub fn minor_axes(main: usize) -> [usize; 2] {
    [(main + 1) % 3, (main + 2) % 3]
}

/// Follows beams from their origin as far as nothing is in their way.
///
/// # Safety
/// The scene of the map must be valid.
#[inline]
#[target_feature(enable = "avx512f,avx512dq,avx512bw,avx512vl,popcnt,bmi1,bmi2,lzcnt,fma,avx2")]
pub unsafe fn follow(shared: &Shared, map: &Map, slopes: [Slopes; BEAMS]) -> [End; BEAMS] {
    let one = _mm512_set1_epi32(1);
    let far_plane = _mm512_set1_epi32(FAR);
    let main = shared.main;
    let [u, v] = minor_axes(main);
    let axes = [main, u, v];
    let tables = &OCTANTS[shared.octant];
    let size = map.size();

    // Along the minor axes a corner is at base + slope × distance.
    let from_grid = each!(axis in [axes[0], axes[1], axes[2]] => shared.turned[axis] - shared.grid[axis] as f32);
    let reach = each!(axis in [axes[0], axes[1], axes[2]] => shared.turned[axis].abs() + shared.grid[axis].abs() as f32 + size[axis] as f32 + 1.0);
    let mut active: Mask = 0xffff;
    let (mut slope, mut base) = ([_mm512_setzero_ps(); 2], [_mm512_setzero_ps(); 2]);
    let (mut side, mut inverse) = ([_mm512_setzero_ps(); 2], [_mm512_setzero_ps(); 2]);
    for i in 0..2 {
        let low = per_beam(slopes.map(|slopes| slopes[i][0] * (1.0 - 1e-6)));
        let high = per_beam(slopes.map(|slopes| slopes[i][1] * (1.0 + 1e-6)));
        active &= _mm512_cmp_ps_mask::<_CMP_LE_OQ>(high, _mm512_set1_ps(STEEPEST));
        let reach = _mm512_fmadd_ps(high, _mm512_set1_ps(reach[0]), _mm512_set1_ps(reach[1 + i]));
        let margin = _mm512_mul_ps(reach, _mm512_set1_ps(MARGIN));
        let origin = _mm512_set1_ps(from_grid[1 + i]);
        side[i] = _mm512_add_ps(origin, margin);
        slope[i] = _mm512_mask_mov_ps(low, FAR_CORNERS[i], high);
        base[i] = _mm512_mask_add_ps(_mm512_sub_ps(origin, margin), FAR_CORNERS[i], side[i], margin);
        inverse[i] = _mm512_div_ps(_mm512_set1_ps(1.0), high);
    }
    let origin = _mm512_set1_ps(from_grid[0]);
    let origin_before = _mm512_set1_ps(from_grid[0] - reach[0] * MARGIN);
    let turn = each!(axis in [axes[0], axes[1], axes[2]] => _mm512_set1_epi32(shared.turn[axis]));

    let start = shared.origin[main].floor() as i32 - map.grid().origin[main];
    let mut layer = _mm512_set1_epi32(start ^ shared.turn[main]);
    let mut distance = _mm512_setzero_ps();
    let mut left = 0;
    let mut memory = Memory::<3>::NONE;
    while active != 0 {
        // 1. The cells of the corners.
        let at = [
            layer,
            floor(_mm512_fmadd_ps(slope[0], distance, base[0])),
            floor(_mm512_fmadd_ps(slope[1], distance, base[1])),
        ];
        let real = each!(i in [0, 1, 2] => _mm512_xor_si512(at[i], turn[i]));
        let voxel = match main {
            0 => real,
            1 => [real[2], real[0], real[1]],
            _ => [real[1], real[2], real[0]],
        };
        let mut inside = active;
        for axis in 0..3 {
            inside = _mm512_mask_cmplt_epu32_mask(inside, voxel[axis], _mm512_set1_epi32(size[axis]));
        }
        let block = block_of(voxel);
        let ahead = _mm512_permutexvar_epi32(block, load(&tables.blocks));
        let cells = memory.cells(map, &shared.skip_distances, inside, voxel);
        // SAFETY: the caller's duty.
        let blocks = unsafe { memory.blocks(map, cells.in_brick, cells.cell, block, ahead) };

        // 2. Whether the corners' boxes cover the rectangle: none is a block with voxels, and neighbours touch.
        let in_brick = cells.in_brick;
        let blocks_apart = _mm512_max_epi32(apart::<2, { SWAP[0] }>(at[1]), apart::<2, { SWAP[1] }>(at[2]));
        let cells_apart = _mm512_max_epi32(apart::<3, { SWAP[0] }>(at[1]), apart::<3, { SWAP[1] }>(at[2]));
        let blocked = _mm512_cmpgt_epi32_mask(cells_apart, one)
            | _mm512_mask_cmpgt_epi32_mask(any_of_beam(in_brick), blocks_apart, one)
            | _mm512_mask_test_epi32_mask(in_brick, _mm512_or_si512(blocks.low, blocks.high), _mm512_set1_epi32(-1));
        let clear = active & !any_of_beam(blocked);

        // 3. Where the beam leaves the boxes: what leaves a nearer corner's box sideways enters a farther one's.
        let shift = _mm512_mask_mov_epi32(cells.shift, blocks.others_ahead, _mm512_set1_epi32(2));
        let mut exit = each!(i in [0, 1, 2] => _mm512_sllv_epi32(_mm512_add_epi32(_mm512_srav_epi32(at[i], shift), cells.skip_distance), shift));
        let outside = active & !inside;
        if outside != 0 {
            let mut beyond = 0;
            for i in 0..3 {
                let first = _mm512_set1_epi32(shared.start[axes[i]]);
                beyond |= _mm512_mask_cmpge_epi32_mask(outside, at[i], _mm512_set1_epi32(shared.end[axes[i]]));
                let before = _mm512_mask_cmplt_epi32_mask(outside, at[i], first);
                exit[i] = _mm512_mask_mov_epi32(exit[i], outside, far_plane);
                exit[i] = _mm512_mask_mov_epi32(exit[i], before, first);
            }
            exit = each!(exit in [exit[0], exit[1], exit[2]] => _mm512_mask_mov_epi32(exit, beyond, far_plane));
        }
        let exit = [
            least_of_beam(exit[0]),
            least_of_beam(_mm512_mask_mov_epi32(far_plane, FAR_CORNERS[0], exit[1])),
            least_of_beam(_mm512_mask_mov_epi32(far_plane, FAR_CORNERS[1], exit[2])),
        ];
        let mut leaves = clear;
        for i in 0..3 {
            leaves = _mm512_mask_cmpeq_epi32_mask(leaves, exit[i], far_plane);
        }
        left |= leaves;
        let straight = _mm512_sub_ps(_mm512_cvtepi32_ps(exit[0]), origin);
        let sideways =
            each!(i in [0, 1] => _mm512_mul_ps(_mm512_sub_ps(_mm512_cvtepi32_ps(exit[1 + i]), side[i]), inverse[i]));
        let next = _mm512_min_ps(straight, _mm512_min_ps(sideways[0], sideways[1]));
        active = _mm512_mask_cmp_ps_mask::<_CMP_GT_OQ>(clear & !leaves, next, distance);
        let is_straight = _mm512_cmp_ps_mask::<_CMP_EQ_OQ>(next, straight);
        let within = _mm512_min_epi32(floor(_mm512_add_ps(origin_before, next)), _mm512_sub_epi32(exit[0], one));
        layer = _mm512_mask_mov_epi32(layer, active, _mm512_mask_mov_epi32(within, is_straight, exit[0]));
        distance = _mm512_mask_mov_ps(distance, active, next);
    }
    let mut planes = [0; LANES];
    store(&mut planes, layer);
    std::array::from_fn(|beam| if left >> (4 * beam) & 1 == 1 { End::Left } else { End::At(planes[4 * beam]) })
}

/// How many cells of `1 << SHIFT` voxels a corner is from the one that `SWAP` exchanges it with.
#[inline]
#[target_feature(enable = "avx512f")]
fn apart<const SHIFT: u32, const SWAP: i32>(at: __m512i) -> __m512i {
    let cell = _mm512_srai_epi32::<SHIFT>(at);
    _mm512_abs_epi32(_mm512_sub_epi32(cell, _mm512_shuffle_epi32::<SWAP>(cell)))
}

/// The least of each beam's lanes, in all of them.
#[inline]
#[target_feature(enable = "avx512f")]
fn least_of_beam(values: __m512i) -> __m512i {
    let values = _mm512_min_epi32(values, _mm512_shuffle_epi32::<{ SWAP[0] }>(values));
    _mm512_min_epi32(values, _mm512_shuffle_epi32::<{ SWAP[1] }>(values))
}

/// All lanes of the beams of which a lane is set.
#[inline(always)]
fn any_of_beam(mask: Mask) -> Mask {
    let pairs = mask | mask >> 1;
    ((pairs | pairs >> 2) & 0x1111) * 0xf
}

/// A value for each beam, in all of its lanes.
#[inline]
#[target_feature(enable = "avx512f")]
fn per_beam([a, b, c, d]: [f32; BEAMS]) -> __m512 {
    _mm512_setr_ps(a, a, a, a, b, b, b, b, c, c, c, c, d, d, d, d)
}
