//! What lanes read of the tree. The regions and bricks that lanes were in last are remembered: coherent rays mostly stay
//! in one or two, so that comparing keys and permuting registers replaces gathers.

use super::vectors::{LANES, Mask, first_of, load, load_wide, or3};
use crate::packed::{CELL_OCCUPIED, Geometry, PackedGrid, SKIP_DISTANCES, cell_in_node};
use glam::IVec3;
use std::arch::x86_64::*;

/// Bits of a region's coordinate along an axis, at most: f32 holds the planes of grids of 2²¹ voxels.
const MOST_BITS: u32 = 16;

/// Where cells are looked up, and how the key of a region of 32³ voxels holds its coordinates.
pub struct Map<'a> {
    cells: &'a [u32],
    bricks: &'a [u32],
    grid: &'a PackedGrid,
    /// Bits of x, and of x and y together.
    bits: [u32; 2],
}

impl<'a> Map<'a> {
    /// The map of a grid, `None` where a region's coordinates do not fit into a key.
    pub fn new(geometry: &'a Geometry, grid: &'a PackedGrid) -> Option<Self> {
        let voxels = grid.top_size.as_i64vec3() << grid.top_shift;
        let bits = voxels.to_array().map(|count| u64::BITS - ((count as u64 - 1) >> 5).leading_zeros());
        // The sign bit stays free for keys of nothing.
        let fits = bits.iter().sum::<u32>() < i32::BITS && bits.iter().all(|&bits| bits <= MOST_BITS);
        let bits = [bits[0], bits[0] + bits[1]];
        fits.then_some(Self { cells: &geometry.cells, bricks: &geometry.bricks, grid, bits })
    }

    /// Voxels along each axis that the cells cover.
    pub fn size(&self) -> IVec3 {
        self.grid.top_size << self.grid.top_shift as i32
    }

    /// The grid.
    pub fn grid(&self) -> &'a PackedGrid {
        self.grid
    }

    /// Keys of the regions that hold voxels, which must be inside.
    #[inline]
    #[target_feature(enable = "avx512f")]
    fn keys(&self, voxel: [__m512i; 3]) -> __m512i {
        let [x, y, z] = each!(v in [voxel[0], voxel[1], voxel[2]] => _mm512_srli_epi32::<5>(v));
        let y = _mm512_sll_epi32(y, _mm_cvtsi32_si128(self.bits[0] as i32));
        let z = _mm512_sll_epi32(z, _mm_cvtsi32_si128(self.bits[1] as i32));
        or3(x, y, z)
    }

    /// The coordinates of a region.
    #[inline]
    fn place(&self, key: i32) -> IVec3 {
        let [x, y] = self.bits;
        IVec3::new(key & ((1 << x) - 1), key >> x & ((1 << (y - x)) - 1), key >> y)
    }

    /// The word of a top cell, which must be inside.
    #[inline]
    fn top_word(&self, at: IVec3) -> u32 {
        let grid = self.grid;
        let index = (at.z * grid.top_size.y + at.y) * grid.top_size.x + at.x;
        self.cells[grid.top_offset as usize + index as usize]
    }
}

/// The cells of lanes.
#[derive(Clone, Copy)]
pub struct CellsOfLanes {
    /// Their words.
    pub cell: __m512i,
    /// log₂ of their sizes.
    pub shift: __m512i,
    /// Edges of the empty boxes, in cells; 1 for a brick.
    pub skip_distance: __m512i,
    /// Lanes in bricks.
    pub in_brick: Mask,
}

/// The blocks of lanes.
#[derive(Clone, Copy)]
pub struct Blocks {
    /// Lanes with a voxel in another block of their brick ahead.
    pub others_ahead: Mask,
    /// Masks of the lanes' blocks, 0 outside of bricks.
    pub low: __m512i,
    /// Their upper halves.
    pub high: __m512i,
}

/// The last regions and bricks of one packet, or of four beams.
#[derive(Clone, Copy)]
pub struct Memory<const KEPT: usize> {
    regions: [Region; KEPT],
    bricks: [Brick; KEPT],
}

/// 32³ voxels.
#[repr(C, align(64))]
#[derive(Clone, Copy)]
struct Region {
    /// The position of the node with its cells of 8³ voxels, or where it has none the cells.
    node: u32,
    copy: [u32; 64],
    key: i32,
    /// log₂ of the size of its cells, larger than 3 where all are one empty cell.
    shift: i32,
}

/// A brick.
#[repr(C, align(64))]
#[derive(Clone, Copy)]
struct Brick {
    /// The masks of all eight blocks.
    masks: [i64; 8],
    /// Position of its record.
    record: i32,
    header: i32,
}

impl<const KEPT: usize> Memory<KEPT> {
    /// Of nothing.
    pub const NONE: Self =
        Self { regions: [Region::NONE; KEPT], bricks: [Brick { masks: [0; 8], record: -1, header: 0 }; KEPT] };

    /// Forgets everything.
    #[inline]
    pub fn clear(&mut self) {
        for region in &mut self.regions {
            region.key = -1;
        }
        for brick in &mut self.bricks {
            brick.record = -1;
        }
    }

    /// Reads the masks of the blocks of lanes in bricks. `block` is the block of a brick that holds the lane's voxel, `ahead`
    /// the other blocks ahead of it.
    ///
    /// # Safety
    /// The scene of the map must be valid, and the cells of these lanes must be bricks of it.
    #[inline]
    #[target_feature(enable = "avx512f,avx512dq,avx512bw,avx512vl,popcnt,bmi1,bmi2,lzcnt,fma,avx2")]
    pub unsafe fn blocks(&mut self, map: &Map, lanes: Mask, cell: __m512i, block: __m512i, ahead: __m512i) -> Blocks {
        let zero = _mm512_setzero_si512();
        let mut blocks = Blocks { others_ahead: 0, low: zero, high: zero };
        let record = _mm512_slli_epi32::<1>(cell);
        let low_word = _mm512_slli_epi32::<1>(block);
        let high_word = _mm512_or_si512(low_word, _mm512_set1_epi32(1));
        let read = |blocks: &mut Blocks, brick: &Brick, same: Mask| {
            let masks = load_wide(&brick.masks);
            blocks.others_ahead |= _mm512_mask_test_epi32_mask(same, ahead, _mm512_set1_epi32(brick.header));
            blocks.low = _mm512_mask_permutexvar_epi32(blocks.low, same, low_word, masks);
            blocks.high = _mm512_mask_permutexvar_epi32(blocks.high, same, high_word, masks);
        };
        let mut rest = lanes;
        let mut victim = 0;
        for (index, brick) in self.bricks.iter().enumerate() {
            let same = _mm512_mask_cmpeq_epi32_mask(lanes, record, _mm512_set1_epi32(brick.record));
            read(&mut blocks, brick, same);
            rest &= !same;
            // What has no lanes goes first.
            victim = if same == 0 { index } else { victim };
        }
        while rest != 0 {
            let leader = first_of(rest, record);
            let same = _mm512_mask_cmpeq_epi32_mask(rest, record, _mm512_set1_epi32(leader));
            // SAFETY: the caller's duty.
            unsafe { self.bricks[victim].load(map, leader) };
            read(&mut blocks, &self.bricks[victim], same);
            rest &= !same;
            victim = (victim + 1) % KEPT;
        }
        blocks
    }

    /// The cells of 8³ voxels, or the larger empty cells around them, that hold the voxels of lanes.
    #[inline]
    #[target_feature(enable = "avx512f,avx512dq,avx512bw,avx512vl,popcnt,bmi1,bmi2,lzcnt,fma,avx2")]
    pub fn cells(&mut self, map: &Map, distances: &SkipDistances, lanes: Mask, voxel: [__m512i; 3]) -> CellsOfLanes {
        let key = map.keys(voxel);
        let [x, y, z] = voxel;
        let local = or3(
            _mm512_and_si512(_mm512_srli_epi32::<3>(x), _mm512_set1_epi32(0b11)),
            _mm512_and_si512(_mm512_srli_epi32::<1>(y), _mm512_set1_epi32(0b1100)),
            _mm512_and_si512(_mm512_slli_epi32::<1>(z), _mm512_set1_epi32(0b11_0000)),
        );
        let (mut cell, mut shift) = (_mm512_setzero_si512(), _mm512_setzero_si512());
        let mut read = |region: &Region, same: Mask| {
            let cells = match region.node {
                Region::NO_NODE => region.copy.as_ptr(),
                node => map.cells.as_ptr().wrapping_add(node as usize),
            };
            let part = |i: usize| {
                // SAFETY: the cells are four vectors; unaligned loads need no alignment.
                unsafe { _mm512_loadu_si512(cells.add(LANES * i).cast()) }
            };
            let lower = _mm512_permutex2var_epi32(part(0), local, part(1));
            let upper = _mm512_permutex2var_epi32(part(2), local, part(3));
            let is_upper = _mm512_test_epi32_mask(local, _mm512_set1_epi32(32));
            cell = _mm512_mask_mov_epi32(cell, same, _mm512_mask_mov_epi32(lower, is_upper, upper));
            shift = _mm512_mask_set1_epi32(shift, same, region.shift);
        };
        let mut rest = lanes;
        let mut victim = 0;
        for (index, region) in self.regions.iter().enumerate() {
            let same = _mm512_mask_cmpeq_epi32_mask(lanes, key, _mm512_set1_epi32(region.key));
            read(region, same);
            rest &= !same;
            victim = if same == 0 { index } else { victim };
        }
        while rest != 0 {
            let leader = first_of(rest, key);
            let same = _mm512_mask_cmpeq_epi32_mask(rest, key, _mm512_set1_epi32(leader));
            let region = &mut self.regions[victim];
            region.load(map, leader);
            read(region, same);
            rest &= !same;
            victim = (victim + 1) % KEPT;
        }
        let in_brick = _mm512_mask_cmplt_epi32_mask(lanes, cell, _mm512_setzero_si512());
        let distance = _mm512_permutexvar_epi32(_mm512_srl_epi32(cell, distances.shift), distances.table);
        CellsOfLanes { cell, shift, skip_distance: _mm512_mask_set1_epi32(distance, in_brick, 1), in_brick }
    }
}

/// Decodes the skip distances that empty cells store for one octant.
pub struct SkipDistances {
    shift: __m128i,
    table: __m512i,
}

impl SkipDistances {
    /// Those of an octant.
    #[inline]
    #[target_feature(enable = "avx512f")]
    pub fn new(octant: usize) -> Self {
        const TABLE: [i32; LANES] = {
            let mut table = [0; LANES];
            let mut i = 0;
            while i < LANES {
                // A permutation looks at four bits, of which the code is the lower three.
                table[i] = SKIP_DISTANCES[i & 7] as i32;
                i += 1;
            }
            table
        };
        Self { shift: _mm_cvtsi32_si128(3 * octant as i32), table: load(&TABLE) }
    }
}

impl Region {
    const NO_NODE: u32 = u32::MAX;
    const NONE: Self = Self { node: Self::NO_NODE, copy: [0; 64], key: -1, shift: 0 };

    #[inline]
    fn load(&mut self, map: &Map, key: i32) {
        let grid = map.grid;
        let region = map.place(key);
        self.key = key;
        if grid.top_shift < 5 {
            self.copy(map, region * 4);
            return;
        }
        let mut word = map.top_word(region >> (grid.top_shift as i32 - 5));
        let mut shift = grid.top_shift;
        while word & CELL_OCCUPIED != 0 && shift > 5 {
            shift -= 2;
            word = map.cells[(word & !CELL_OCCUPIED) as usize * 64 + cell_in_node(region, shift - 5)];
        }
        if word & CELL_OCCUPIED != 0 {
            (self.node, self.shift) = ((word & !CELL_OCCUPIED) * 64, 3);
        } else {
            (self.node, self.copy, self.shift) = (Self::NO_NODE, [word; 64], shift as i32);
        }
    }

    /// Where the top array's cells are bricks: the 4³ cells from `first` on that are inside.
    #[cold]
    fn copy(&mut self, map: &Map, first: IVec3) {
        (self.node, self.shift) = (Self::NO_NODE, 3);
        for index in 0..64 {
            let at = first + IVec3::new(index & 3, index >> 2 & 3, index >> 4);
            if at.cmplt(map.grid.top_size).all() {
                self.copy[index as usize] = map.top_word(at);
            }
        }
    }
}

impl Brick {
    /// # Safety
    /// The scene of the map must be valid.
    #[inline]
    #[target_feature(enable = "avx512f,avx512dq,avx512bw,avx512vl,popcnt,bmi1,bmi2,lzcnt,fma,avx2")]
    unsafe fn load(&mut self, map: &Map, record: i32) {
        let words = &map.bricks[record as usize..];
        self.record = record;
        self.header = words[0] as i32;
        let present = words[0] as u8;
        // SAFETY: in a valid scene as many masks follow the two words of the header as it announces.
        unsafe {
            let first = _bzhi_u32(0xff, present.count_ones()) as u8;
            let packed = _mm512_maskz_loadu_epi64(first, words.as_ptr().add(2).cast());
            _mm512_storeu_si512(self.masks.as_mut_ptr().cast(), _mm512_maskz_expand_epi64(present, packed));
        }
    }
}
