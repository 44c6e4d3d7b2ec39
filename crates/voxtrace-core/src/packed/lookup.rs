//! Finding the brick, and the material, of a voxel in the packed arrays.

use super::{CELL_OCCUPIED, Geometry, PackedGrid};
use glam::IVec3;
use voxtrace_scene::brick::{block_bit, block_index};
use voxtrace_scene::grid::local_of;

/// Position in the header word of the number of bits of a packed index, 0 to 16.
pub(super) const HEADER_INDEX_BITS: u32 = 8;
/// Position in the header word of the number of palette entries, 0 (indices are materials) to 512.
pub(super) const HEADER_PALETTE: u32 = 16;

impl Geometry {
    /// Word position of the record of the brick that holds `voxel`, `None` where there is no brick.
    pub fn find_brick(&self, grid: &PackedGrid, voxel: IVec3) -> Option<usize> {
        let relative = voxel - grid.origin;
        let top = relative >> grid.top_shift as i32;
        if top.cmplt(IVec3::ZERO).any() || top.cmpge(grid.top_size).any() {
            return None;
        }
        let cells = &*self.cells;
        let in_top = (top.z * grid.top_size.y + top.y) * grid.top_size.x + top.x;
        let mut cell = cells[grid.top_offset as usize + in_top as usize];
        let mut shift = grid.top_shift;
        while cell & CELL_OCCUPIED != 0 && shift > 3 {
            shift -= 2;
            cell = cells[(cell & !CELL_OCCUPIED) as usize * 64 + cell_in_node(relative, shift)];
        }
        (cell & CELL_OCCUPIED != 0).then_some((cell & !CELL_OCCUPIED) as usize * 2)
    }

    /// Word position of the record of the brick that holds a voxel, and how many voxels of the brick come before it; `None` where it is empty.
    #[inline]
    pub(super) fn rank_at(&self, grid: &PackedGrid, voxel: IVec3) -> Option<(usize, u32)> {
        let record = self.find_brick(grid, voxel)?;
        Some((record, self.rank_in(record, local_of(voxel - grid.origin))?))
    }

    /// How many voxels of the brick of a record come before the one at `local`; `None` where it is empty.
    #[inline]
    pub(super) fn rank_in(&self, record: usize, local: IVec3) -> Option<u32> {
        let (present_before, mask) = self.block_of(record, local)?;
        let rank_of_block = (0..present_before).map(|index| self.mask(record, index).count_ones()).sum::<u32>();
        Some(rank_of_block + (mask & ((1 << block_bit(local)) - 1)).count_ones())
    }

    /// How many blocks of the brick of a record come before that of the occupied voxel at `local`, and its mask; `None` where the voxel is empty.
    #[inline]
    pub(super) fn block_of(&self, record: usize, local: IVec3) -> Option<(usize, u64)> {
        let (header, block) = (self.bricks[record], block_index(local));
        if header >> block & 1 == 0 {
            return None;
        }
        let present_before = (header & ((1 << block) - 1)).count_ones() as usize;
        let mask = self.mask(record, present_before);
        (mask >> block_bit(local) & 1 != 0).then_some((present_before, mask))
    }

    /// The mask of one of the blocks that are there.
    #[inline]
    fn mask(&self, record: usize, index: usize) -> u64 {
        u64::from(self.bricks[record + 2 + 2 * index]) | u64::from(self.bricks[record + 3 + 2 * index]) << 32
    }

    /// Index of the material of a voxel, `None` where it is empty.
    pub fn material_at(&self, grid: &PackedGrid, voxel: IVec3) -> Option<u32> {
        let (record, rank) = self.rank_at(grid, voxel)?;
        Some(self.material_of_rank(grid, record, rank))
    }

    /// Index of the material of the voxel of the brick of a record before which `rank` others come.
    #[inline]
    pub(super) fn material_of_rank(&self, grid: &PackedGrid, record: usize, rank: u32) -> u32 {
        let header = self.bricks[record];
        let index_bits = header >> HEADER_INDEX_BITS & 0xff;
        let palette_count = header >> HEADER_PALETTE;
        let entry_bits = grid.material_bits;
        let start = u64::from(self.bricks[record + 1]) * 32;
        let index = self.read_bits(start + u64::from(palette_count * entry_bits + rank * index_bits), index_bits);
        match palette_count {
            0 => index,
            _ => self.read_bits(start + u64::from(index * entry_bits), entry_bits),
        }
    }

    /// The `count` ≤ 16 bits from bit `position` of the materials on.
    pub(super) fn read_bits(&self, position: u64, count: u32) -> u32 {
        bits_at(&self.brick_materials, position, count)
    }
}

/// The `count` ≤ 16 bits from bit `position` of some words on, low bits first.
#[inline]
pub(super) fn bits_at(words: &[u32], position: u64, count: u32) -> u32 {
    if count == 0 {
        return 0;
    }
    let (word, shift) = ((position / 32) as usize, (position % 32) as u32);
    let low = words[word] >> shift;
    let high = if shift + count > 32 { words[word + 1] << (32 - shift) } else { 0 };
    (low | high) & ((1 << count) - 1)
}

/// Position within its node of the cell, `1 << shift` voxels wide, that holds the voxel at `relative`.
#[inline]
pub(crate) fn cell_in_node(relative: IVec3, shift: u32) -> usize {
    let cell = relative >> shift as i32 & 3;
    (cell.x | cell.y << 2 | cell.z << 4) as usize
}
