//! A chunk: the bricks of one grid in a cube of 16³, as one piece of bytes.
//!
//! Its words are: the number of bricks; their places in the cube, two to a word; the header of each record; the masks of all; then for each brick its normals, where there
//! are any, and its materials. All in ascending order of the places. Positions of materials follow from these, so they are left out.

use super::super::PackedGrid;
use super::super::lookup::{HEADER_INDEX_BITS, HEADER_PALETTE, bits_at};
use super::super::normals::normal_words;
use bytemuck::{Pod, Zeroable};
use glam::IVec3;
use std::ops::Range;
use voxtrace_scene::Invalid;
use voxtrace_scene::brick::{Brick, bits};
use xxhash_rust::xxh3::xxh3_64;

/// log₂ of the bricks along an edge of a chunk.
pub const CHUNK_SHIFT: i32 = 4;
/// Bricks of a full chunk.
const MOST_BRICKS: usize = 1 << (3 * CHUNK_SHIFT);

/// A chunk as the section `INDX` tells of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct ChunkRecord {
    /// Index of the grid.
    pub grid: u32,
    /// Its place, in chunks from the grid's voxel 0.
    pub at: IVec3,
    /// Bricks.
    pub bricks: u32,
    /// Voxels.
    pub voxels: u32,
    /// Bytes, and of those that are stored, compressed.
    pub size: u32,
    pub stored: u32,
    /// XXH3-64 of the bytes that are not compressed, low word first.
    pub checksum: [u32; 2],
}

/// A brick of a chunk: where its words are.
pub struct StoredBrick {
    /// Coordinates, in bricks from the grid's voxel 0.
    pub at: IVec3,
    pub header: u32,
    masks: Range<usize>,
    /// Words of its normals before its materials.
    pub normals: usize,
    materials: Range<usize>,
}

/// A chunk that was read and checked, but for the materials that its voxels name.
pub struct Chunk {
    words: Vec<u32>,
    pub bricks: Vec<StoredBrick>,
    entry_bits: u32,
}

impl Chunk {
    /// Reads the bytes of a chunk of `grid`.
    ///
    /// # Errors
    /// One sentence where they are not those that the record tells of.
    pub fn read(bytes: &[u8], record: &ChunkRecord, grid: &PackedGrid, has_normals: bool) -> Result<Self, Invalid> {
        let sum = xxh3_64(bytes);
        if bytes.len() != record.size as usize || record.checksum != [sum as u32, (sum >> 32) as u32] {
            return Err("it has a wrong checksum".into());
        }
        if !bytes.len().is_multiple_of(4) {
            return Err("it is cut off".into());
        }
        let words: Vec<u32> = bytemuck::pod_collect_to_vec(bytes);
        let entry_bits = grid.material_bits;
        let bricks = bricks_of(&words, record, (entry_bits, has_normals)).ok_or("it contradicts itself")?;
        Ok(Self { words, bricks, entry_bits })
    }

    /// The masks of a brick's blocks, two words each.
    pub fn masks(&self, brick: &StoredBrick) -> &[u32] {
        &self.words[brick.masks.clone()]
    }

    /// Normals and materials of a brick.
    pub fn materials(&self, brick: &StoredBrick) -> &[u32] {
        &self.words[brick.materials.clone()]
    }

    /// The brick with other materials in the place of its own; `None` where it names one that is not there.
    pub fn brick(&self, brick: &StoredBrick, materials: &[u16]) -> Option<Brick> {
        let mut occupancy = [0u64; 8];
        let present = (0..8).filter(|block| brick.header >> block & 1 == 1);
        for (block, words) in present.zip(self.masks(brick).chunks_exact(2)) {
            occupancy[block] = u64::from(words[0]) | u64::from(words[1]) << 32;
        }
        let words = &self.materials(brick)[brick.normals..];
        let (index_bits, palette) = (brick.header >> HEADER_INDEX_BITS & 0xff, brick.header >> HEADER_PALETTE);
        let first = palette * self.entry_bits;
        let voxels: u32 = occupancy.iter().map(|&mask| bits(mask).count() as u32).sum();
        let material = |rank: u32| {
            let index = bits_at(words, u64::from(first + rank * index_bits), index_bits);
            let entry = match palette {
                0 => index,
                palette if index < palette => bits_at(words, u64::from(index * self.entry_bits), self.entry_bits),
                _ => return None,
            };
            materials.get(entry as usize).copied()
        };
        Some(Brick::new(occupancy, (0..voxels).map(material).collect::<Option<_>>()?))
    }
}

/// The bricks in the words of a chunk; `None` where they do not fill them.
fn bricks_of(words: &[u32], record: &ChunkRecord, (entry_bits, has_normals): (u32, bool)) -> Option<Vec<StoredBrick>> {
    let count = *words.first()? as usize;
    if count == 0 || count > MOST_BRICKS || count != record.bricks as usize {
        return None;
    }
    let headers = 1 + count.div_ceil(2);
    let mut at = headers + count;
    if at > words.len() {
        return None;
    }
    let mut bricks = Vec::with_capacity(count);
    let mut last = None;
    for index in 0..count {
        let place = (words[1 + index / 2] >> (16 * (index % 2)) & 0xffff) as i32;
        if place >= MOST_BRICKS as i32 || last.replace(place).is_some_and(|last| last >= place) {
            return None;
        }
        let header = words[headers + index];
        let blocks = (header & 0xff).count_ones() as usize;
        if blocks == 0 || header >> HEADER_INDEX_BITS & 0xff > 16 || header >> HEADER_PALETTE > 512 {
            return None;
        }
        let masks = at..at + 2 * blocks;
        at = masks.end;
        let local = IVec3::new(place & 15, place >> 4 & 15, place >> 8);
        bricks.push(StoredBrick { at: (record.at << CHUNK_SHIFT) + local, header, masks, normals: 0, materials: 0..0 });
    }
    let mut all = 0;
    for brick in &mut bricks {
        let masks = words.get(brick.masks.clone())?;
        if masks.chunks_exact(2).any(|words| words == [0, 0]) {
            return None;
        }
        let voxels: u32 = masks.iter().map(|word| word.count_ones()).sum();
        let (index_bits, palette) = (brick.header >> HEADER_INDEX_BITS & 0xff, brick.header >> HEADER_PALETTE);
        brick.normals = if has_normals { normal_words(voxels) } else { 0 };
        let own = (palette * entry_bits + voxels * index_bits).div_ceil(32) as usize;
        brick.materials = at..at + brick.normals + own;
        at = brick.materials.end;
        all += voxels;
    }
    (at == words.len() && all == record.voxels).then_some(bricks)
}
