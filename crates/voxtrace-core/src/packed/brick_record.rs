//! Encoding of bricks: the record that traversal reads (header, position of the materials, masks of the blocks that
//! hold a voxel) and the materials beside it (the brick's palette, then one packed index for each voxel in rank order).

use super::lookup::{HEADER_INDEX_BITS, HEADER_PALETTE};
use glam::IVec3;
use rayon::prelude::*;
use std::borrow::Borrow;
use voxtrace_scene::brick::Brick;

/// Encoded bricks.
#[derive(Clone)]
pub(super) struct BrickWords {
    /// Brick records, each an even number of words.
    pub records: Vec<u32>,
    /// Palettes and packed indices.
    pub materials: Vec<u32>,
    /// Position of each brick's record, words.
    pub positions: Vec<usize>,
}

/// Bricks encoded by one task.
const CHUNK: usize = 256;

/// Encodes bricks in the order given. `entry_bits` (8 or 16) is the size of a palette entry.
pub(super) fn encode_bricks(bricks: &[(IVec3, impl Borrow<Brick> + Sync)], entry_bits: u32) -> BrickWords {
    let chunks: Vec<BrickWords> = bricks
        .par_chunks(CHUNK)
        .map(|chunk| {
            let mut words = BrickWords { records: vec![], materials: vec![], positions: vec![] };
            let mut palette = Palette::default();
            for (_, brick) in chunk {
                encode(brick.borrow(), entry_bits, &mut palette, &mut words);
            }
            words
        })
        .collect();
    let total = |size: fn(&BrickWords) -> usize| chunks.iter().map(size).sum();
    let mut all = BrickWords {
        records: Vec::with_capacity(total(|chunk| chunk.records.len())),
        materials: Vec::with_capacity(total(|chunk| chunk.materials.len())),
        positions: Vec::with_capacity(bricks.len()),
    };
    for mut chunk in chunks {
        for &position in &chunk.positions {
            // Whether 32 bits reach is asked when all are there.
            chunk.records[position + 1] = chunk.records[position + 1].wrapping_add(all.materials.len() as u32);
            all.positions.push(all.records.len() + position);
        }
        all.records.append(&mut chunk.records);
        all.materials.append(&mut chunk.materials);
    }
    all
}

/// The distinct materials of one brick, in ascending order, and the index of each voxel.
#[derive(Default)]
struct Palette {
    entries: Vec<u16>,
}

impl Palette {
    fn collect(&mut self, materials: &[u16]) {
        self.entries.clear();
        let mut last = None;
        for &material in materials {
            // Neighbours are often alike: most repetitions end here, before the sort.
            if last != Some(material) {
                self.entries.push(material);
                last = Some(material);
            }
        }
        self.entries.sort_unstable();
        self.entries.dedup();
    }

    /// Whether a brick of `count` voxels is smaller with the palette, and the bits of an index: without one indices are the materials
    /// themselves.
    fn coding(&self, count: u32, entry_bits: u32) -> (bool, u32) {
        let entries = self.entries.len() as u32;
        let palette_index_bits = u32::BITS - (entries - 1).leading_zeros();
        let has_palette = entries * entry_bits + count * palette_index_bits < count * entry_bits;
        (has_palette, if has_palette { palette_index_bits } else { entry_bits })
    }
}

/// Words of a brick's record and materials.
pub(super) fn brick_words(brick: &Brick, entry_bits: u32) -> u64 {
    let mut palette = Palette::default();
    palette.collect(brick.materials());
    let (entries, count) = (palette.entries.len() as u32, brick.materials().len() as u32);
    let (has_palette, index_bits) = palette.coding(count, entry_bits);
    let bits = count * index_bits + if has_palette { entries * entry_bits } else { 0 };
    let blocks = brick.occupancy().iter().filter(|&&mask| mask != 0).count();
    (2 + 2 * blocks) as u64 + u64::from(bits.div_ceil(32))
}

/// The record of a brick, without the position of its materials, and its materials.
pub(crate) fn encode_brick(brick: &Brick, entry_bits: u32) -> (Vec<u32>, Vec<u32>) {
    let mut words = BrickWords { records: vec![], materials: vec![], positions: vec![] };
    encode(brick, entry_bits, &mut Palette::default(), &mut words);
    (words.records, words.materials)
}

fn encode(brick: &Brick, entry_bits: u32, palette: &mut Palette, words: &mut BrickWords) {
    palette.collect(brick.materials());
    let entries = palette.entries.len() as u32;
    let (has_palette, index_bits) = palette.coding(brick.materials().len() as u32, entry_bits);

    let mut blocks = 0;
    for (block, &mask) in brick.occupancy().iter().enumerate() {
        blocks |= u32::from(mask != 0) << block;
    }
    words.positions.push(words.records.len());
    let palette_count = if has_palette { entries } else { 0 };
    words.records.push(blocks | index_bits << HEADER_INDEX_BITS | palette_count << HEADER_PALETTE);
    words.records.push(words.materials.len() as u32);
    for &mask in brick.occupancy().iter().filter(|&&mask| mask != 0) {
        words.records.extend([mask as u32, (mask >> 32) as u32]);
    }

    let mut bits = BitWriter::new(&mut words.materials);
    if has_palette {
        let mut index_of = [0u16; 256];
        let small = palette.entries[palette.entries.len() - 1] < 256;
        for (index, &entry) in palette.entries.iter().enumerate() {
            bits.push(u32::from(entry), entry_bits);
            if small {
                index_of[usize::from(entry)] = index as u16;
            }
        }
        for &material in brick.materials() {
            let index = if small {
                usize::from(index_of[usize::from(material)])
            } else {
                palette.entries.binary_search(&material).expect("the palette holds every material of the brick")
            };
            bits.push(index as u32, index_bits);
        }
    } else {
        for &material in brick.materials() {
            bits.push(u32::from(material), index_bits);
        }
    }
    bits.flush();
}

/// Appends fields of at most 16 bits, low bits first, and fills up the last word with zeros.
pub(super) struct BitWriter<'a> {
    words: &'a mut Vec<u32>,
    pending: u64,
    used: u32,
}

impl<'a> BitWriter<'a> {
    pub fn new(words: &'a mut Vec<u32>) -> Self {
        Self { words, pending: 0, used: 0 }
    }

    pub fn push(&mut self, value: u32, bits: u32) {
        self.pending |= u64::from(value) << self.used;
        self.used += bits;
        if self.used >= 32 {
            self.words.push(self.pending as u32);
            self.pending >>= 32;
            self.used -= 32;
        }
    }

    pub fn flush(self) {
        if self.used > 0 {
            self.words.push(self.pending as u32);
        }
    }
}
