//! The materials of many hits: what one waits for memory, the others look for their bricks.

#![cfg_attr(target_arch = "x86_64", expect(unsafe_code, reason = "calls of functions for certain processors"))]

use super::PackedScene;
use super::lookup::{HEADER_INDEX_BITS, HEADER_PALETTE, bits_at};
#[cfg(target_arch = "x86_64")]
use crate::walk::Instructions;
use crate::walk::simd::prefetch;
use voxtrace_scene::brick::{block_bit, block_index};
use voxtrace_scene::grid::local_of;
use voxtrace_scene::ray::Hit;

/// Hits at a time: as many as their places stay in registers and the first cache.
const AT_A_TIME: usize = 64;
/// Blocks of a brick.
const BLOCKS: usize = 8;

/// A voxel on the way to its material.
#[derive(Clone, Copy, Default)]
struct Place {
    /// Which hit it is.
    index: usize,
    /// Word position of its brick's record, its block of the brick and its bit of the block.
    record: usize,
    block: u32,
    bit: u32,
    /// Bits of a material's number in its grid.
    material_bits: u32,
    /// First bit of the brick's materials, and bits from there to the voxel's index.
    start: u64,
    offset: u32,
    index_bits: u32,
    /// Whether the index is one of the palette.
    has_palette: bool,
}

impl PackedScene {
    /// Writes the indices of the materials of `hits`, as [`Self::material_index`] gives them, and leaves alone those of misses.
    ///
    /// # Panics
    /// If a hit is not one of this scene, or there are fewer indices than hits.
    pub fn material_indices(&self, hits: &[Hit], indices: &mut [u32]) {
        let mut packed = [Hit::MISS; AT_A_TIME];
        for (hits, indices) in hits.chunks(AT_A_TIME).zip(indices.chunks_mut(AT_A_TIME)) {
            let packed = &mut packed[..hits.len()];
            for (packed, hit) in packed.iter_mut().zip(hits) {
                *packed = self.hit_of_packed(hit);
            }
            self.packed_material_indices(packed, |index| !hits[index].is_miss(), indices);
        }
    }

    /// Writes the indices of the materials of hits as tracers find them, for those that `wants` asks for; they must be no misses.
    pub(crate) fn packed_material_indices(&self, hits: &[Hit], wants: impl Fn(usize) -> bool, indices: &mut [u32]) {
        #[cfg(target_arch = "x86_64")]
        if matches!(Instructions::chosen(), Instructions::Avx2 | Instructions::Avx512) {
            // SAFETY: the processor has the instructions.
            return unsafe { by_avx2(self, hits, wants, indices) };
        }
        self.look_up(hits, wants, indices);
    }

    #[inline(always)]
    fn look_up(&self, hits: &[Hit], wants: impl Fn(usize) -> bool, indices: &mut [u32]) {
        let (geometry, instances, grids) = (&*self.geometry, &*self.placement.instances, &*self.geometry.grids);
        let (bricks, words) = (&*geometry.bricks, &*geometry.brick_materials);
        let mut places = [Place::default(); AT_A_TIME];
        for first in (0..hits.len()).step_by(AT_A_TIME) {
            let mut count = 0;
            for (index, hit) in hits.iter().enumerate().skip(first).take(AT_A_TIME) {
                if wants(index) {
                    let grid = &grids[instances[hit.instance as usize].grid as usize];
                    let record = geometry.find_brick(grid, hit.voxel).expect("a hit's voxel is in a brick");
                    prefetch(bricks.as_ptr().wrapping_add(record));
                    let local = local_of(hit.voxel - grid.origin);
                    let (block, bit) = (block_index(local) as u32, block_bit(local) as u32);
                    let material_bits = grid.material_bits;
                    places[count] = Place { index, record, block, bit, material_bits, ..Place::default() };
                    count += 1;
                }
            }
            for place in &mut places[..count] {
                place.find_index(bricks);
                prefetch(words.as_ptr().wrapping_add((place.start / 32) as usize));
                prefetch(words.as_ptr().wrapping_add(((place.start + u64::from(place.offset)) / 32) as usize));
            }
            for place in &places[..count] {
                let own = bits_at(words, place.start + u64::from(place.offset), place.index_bits);
                indices[place.index] = match place.has_palette {
                    true => bits_at(words, place.start + u64::from(own * place.material_bits), place.material_bits),
                    false => own,
                };
            }
        }
    }
}

/// # Safety
/// The processor must have the instructions.
#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,popcnt,bmi1,bmi2,lzcnt")]
unsafe fn by_avx2(scene: &PackedScene, hits: &[Hit], wants: impl Fn(usize) -> bool, indices: &mut [u32]) {
    scene.look_up(hits, wants, indices);
}

impl Place {
    /// Finds where the index of the voxel is, which must be occupied.
    #[inline(always)]
    fn find_index(&mut self, bricks: &[u32]) {
        let header = bricks[self.record];
        let before = (header & ((1 << self.block) - 1)).count_ones() as usize;
        let present = (header & 0xff).count_ones() as usize;
        let masks = &bricks[self.record + 2..self.record + 2 + 2 * present];
        let (mut rank, mut own) = (0, 0);
        // All of them, whichever come before: a loop that ends somewhere else each time is guessed wrongly.
        for index in 0..BLOCKS {
            let at = index.min(present - 1);
            let mask = u64::from(masks[2 * at]) | u64::from(masks[2 * at + 1]) << 32;
            let counted = if index < before { mask } else { 0 };
            own = if index == before { mask } else { own };
            rank += counted.count_ones();
        }
        rank += (own & ((1 << self.bit) - 1)).count_ones();
        let palette = header >> HEADER_PALETTE;
        self.index_bits = header >> HEADER_INDEX_BITS & 0xff;
        self.has_palette = palette != 0;
        self.start = u64::from(bricks[self.record + 1]) * 32;
        self.offset = palette * self.material_bits + rank * self.index_bits;
    }
}
