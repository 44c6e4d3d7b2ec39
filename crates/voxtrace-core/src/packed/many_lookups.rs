//! The materials of many hits: what one waits for memory, the others look for their bricks.

use super::lookup::{HEADER_INDEX_BITS, HEADER_PALETTE, bits_at};
use super::{Geometry, PackedGrid, PackedScene};
use glam::IVec3;
use voxtrace_scene::brick::{block_bit, block_index};
use voxtrace_scene::grid::local_of;
use voxtrace_scene::ray::Hit;

/// Hits at a time: as many as their places stay in registers and the first cache.
const AT_A_TIME: usize = 64;
/// Blocks of a brick.
const BLOCKS: usize = 8;

/// Where the material of a voxel is to be read.
#[derive(Clone, Copy, Default)]
struct Place {
    /// First bit of the brick's materials.
    start: u64,
    /// Bits from there to the voxel's index.
    offset: u32,
    index_bits: u32,
    /// Bits of an entry of the palette, 0 where indices are materials.
    entry_bits: u32,
}

impl PackedScene {
    /// Writes the indices of the materials of hits as tracers find them, for those that `wants` asks for; they must be no misses.
    pub(crate) fn packed_material_indices(&self, hits: &[Hit], wants: impl Fn(usize) -> bool, indices: &mut [u32]) {
        let (geometry, instances, grids) = (&*self.geometry, &*self.placement.instances, &*self.geometry.grids);
        let words = &*geometry.brick_materials;
        let mut places = [(0, Place::default()); AT_A_TIME];
        for first in (0..hits.len()).step_by(AT_A_TIME) {
            let mut count = 0;
            for index in first..hits.len().min(first + AT_A_TIME) {
                if wants(index) {
                    let hit = &hits[index];
                    let grid = &grids[instances[hit.instance as usize].grid as usize];
                    let place = geometry.material_place(grid, hit.voxel).expect("a hit's voxel is occupied");
                    places[count] = (index, place);
                    count += 1;
                }
            }
            for &(index, Place { start, offset, index_bits, entry_bits }) in &places[..count] {
                let own = bits_at(words, start + u64::from(offset), index_bits);
                let is_material = entry_bits == 0;
                indices[index] = match is_material {
                    true => own,
                    false => bits_at(words, start + u64::from(own * entry_bits), entry_bits),
                };
            }
        }
    }
}

impl Geometry {
    /// Where the material of a voxel is, `None` where it is empty.
    #[inline]
    fn material_place(&self, grid: &PackedGrid, voxel: IVec3) -> Option<Place> {
        let bricks = &*self.bricks;
        let record = self.find_brick(grid, voxel)?;
        let header = bricks[record];
        let local = local_of(voxel - grid.origin);
        let (block, bit) = (block_index(local), block_bit(local));
        if header >> block & 1 == 0 {
            return None;
        }
        let before = (header & ((1 << block) - 1)).count_ones() as usize;
        let present = (header & 0xff).count_ones() as usize;
        let masks = bricks.get(record + 2..record + 2 + 2 * present)?;
        let (mut rank, mut own) = (0, 0);
        // All of them, whichever come before: a loop that ends somewhere else each time is guessed wrongly.
        for index in 0..BLOCKS {
            let at = index.min(present - 1);
            let mask = u64::from(masks[2 * at]) | u64::from(masks[2 * at + 1]) << 32;
            let counted = if index < before { mask } else { 0 };
            own = if index == before { mask } else { own };
            rank += counted.count_ones();
        }
        if own >> bit & 1 == 0 {
            return None;
        }
        rank += (own & ((1 << bit) - 1)).count_ones();
        let (palette, index_bits) = (header >> HEADER_PALETTE, header >> HEADER_INDEX_BITS & 0xff);
        let entry_bits = if palette == 0 { 0 } else { grid.material_bits };
        let start = u64::from(bricks[record + 1]) * 32;
        Some(Place { start, offset: palette * grid.material_bits + rank * index_bits, index_bits, entry_bits })
    }
}
