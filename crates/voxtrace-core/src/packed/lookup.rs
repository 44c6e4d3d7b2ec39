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
        let header = self.bricks[record];
        let local = local_of(voxel - grid.origin);
        let (block, bit) = (block_index(local), block_bit(local));
        if header >> block & 1 == 0 {
            return None;
        }
        let present_before = (header & ((1 << block) - 1)).count_ones() as usize;
        let mask = |index: usize| {
            u64::from(self.bricks[record + 2 + 2 * index]) | u64::from(self.bricks[record + 3 + 2 * index]) << 32
        };
        let own = mask(present_before);
        if own >> bit & 1 == 0 {
            return None;
        }
        let rank_of_block = (0..present_before).map(|index| mask(index).count_ones()).sum::<u32>();
        Some((record, rank_of_block + (own & ((1 << bit) - 1)).count_ones()))
    }

    /// Index of the material of a voxel, `None` where it is empty.
    pub fn material_at(&self, grid: &PackedGrid, voxel: IVec3) -> Option<u32> {
        let (record, rank) = self.rank_at(grid, voxel)?;
        let header = self.bricks[record];
        let index_bits = header >> HEADER_INDEX_BITS & 0xff;
        let palette_count = header >> HEADER_PALETTE;
        let entry_bits = grid.material_bits;
        let start = u64::from(self.bricks[record + 1]) * 32;
        let index = self.read_bits(start + u64::from(palette_count * entry_bits + rank * index_bits), index_bits);
        if palette_count == 0 {
            return Some(index);
        }
        Some(self.read_bits(start + u64::from(index * entry_bits), entry_bits))
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
