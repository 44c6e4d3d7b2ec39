//! Bricks that wait for their materials: which colours there are is known only when the last tile is done. They wait as
//! bytes in memory, or in a file beside the output.

use super::key::Key;
use crate::brick::Brick;
use crate::output::TemporaryFile;
use glam::IVec3;
use std::io::{self, Read, Seek, SeekFrom, Write};

/// Added to brick coordinates before they are packed into 21 bits each.
const BIAS: i32 = 1 << 20;
/// Set in a record's first byte: one look for all voxels.
const ONE_LOOK: u8 = 1;
/// Set where looks have an emission too.
const EMITS: u8 = 2;

/// The encoded bricks of a tile.
#[derive(Default)]
pub(super) struct TileRecords {
    bytes: Vec<u8>,
    /// Coordinates and end in `bytes` of each brick.
    bricks: Vec<(IVec3, u32)>,
    /// Voxels in all of them.
    pub voxels: u64,
}

impl TileRecords {
    /// Appends a brick; `keys` holds one look for each voxel in rank order, or a single one for all.
    pub fn push(&mut self, at: IVec3, occupancy: &[u64; 8], keys: &[Key]) {
        let is_one = keys.iter().all(|&key| key == keys[0]);
        let emits = keys.iter().any(|&key| key >> 32 != 0);
        let blocks = (0..8).filter(|&block| occupancy[block] != 0).fold(0, |blocks, block| blocks | 1 << block);
        let flags = if is_one { ONE_LOOK } else { 0 } | if emits { EMITS } else { 0 };
        self.bytes.push(flags);
        self.bytes.push(blocks);
        for &mask in occupancy.iter().filter(|&&mask| mask != 0) {
            self.bytes.extend(mask.to_le_bytes());
            self.voxels += u64::from(mask.count_ones());
        }
        for &key in if is_one { &keys[..1] } else { keys } {
            self.bytes.extend(&key.to_le_bytes()[..if emits { 8 } else { 4 }]);
        }
        self.bricks.push((at, self.bytes.len() as u32));
    }
}

/// Where a brick waits.
#[derive(Clone, Copy)]
struct Entry {
    /// Coordinates, z highest, 21 bits each.
    at: u64,
    offset: u64,
    size: u32,
}

/// All bricks so far.
pub(super) struct Spool {
    storage: Storage,
    entries: Vec<Entry>,
    size: u64,
    voxels: u64,
}

enum Storage {
    /// Pieces and where each begins.
    Memory(Vec<(u64, Vec<u8>)>),
    File(TemporaryFile),
}

impl Spool {
    /// A spool in memory.
    pub fn in_memory() -> Self {
        Self { storage: Storage::Memory(Vec::new()), entries: Vec::new(), size: 0, voxels: 0 }
    }

    /// A spool in a file of its own, which is gone when the spool is.
    pub fn in_file(file: TemporaryFile) -> Self {
        Self { storage: Storage::File(file), ..Self::in_memory() }
    }

    /// Voxels so far.
    pub fn voxels(&self) -> u64 {
        self.voxels
    }

    /// Bricks so far.
    pub fn brick_count(&self) -> usize {
        self.entries.len()
    }

    /// Adds the bricks of a tile. Each brick comes once.
    pub fn push(&mut self, records: TileRecords) -> io::Result<()> {
        let mut start = 0;
        for &(at, end) in &records.bricks {
            self.entries.push(Entry { at: packed(at), offset: self.size + u64::from(start), size: end - start });
            start = end;
        }
        self.voxels += records.voxels;
        let size = records.bytes.len() as u64;
        if size > 0 {
            match &mut self.storage {
                Storage::Memory(pieces) => pieces.push((self.size, records.bytes)),
                Storage::File(file) => file.file().write_all(&records.bytes)?,
            }
        }
        self.size += size;
        Ok(())
    }

    /// Coordinates of all bricks, in the order in which [`Self::for_each`] will give them.
    pub fn coordinates(&self) -> impl ExactSizeIterator<Item = IVec3> + '_ {
        self.entries.iter().map(|entry| unpacked(entry.at))
    }

    /// Puts the bricks into the order of a key.
    pub fn sort_by_key<K: Ord + Send>(&mut self, key: impl Fn(IVec3) -> K + Sync) {
        use rayon::prelude::*;
        self.entries.par_sort_by_cached_key(|entry| key(unpacked(entry.at)));
    }

    /// Gives all bricks in their order, in batches: coordinates and bricks whose materials `material` chose from look and
    /// voxel.
    pub fn for_each_batch(
        &mut self,
        material: &(impl Fn(Key, IVec3) -> u16 + Sync),
        mut each: impl FnMut(Vec<(IVec3, Brick)>) -> io::Result<()>,
    ) -> io::Result<()> {
        use rayon::prelude::*;
        /// Bricks in a batch.
        const BATCH: usize = 1 << 13;
        let mut bytes = Vec::new();
        for entries in self.entries.chunks(BATCH) {
            let bricks = match &mut self.storage {
                Storage::Memory(pieces) => entries
                    .par_iter()
                    .map(|entry| {
                        let piece = pieces.partition_point(|piece| piece.0 <= entry.offset) - 1;
                        let start = (entry.offset - pieces[piece].0) as usize;
                        let bytes = &pieces[piece].1[start..start + entry.size as usize];
                        (unpacked(entry.at), decoded(bytes, unpacked(entry.at), material))
                    })
                    .collect(),
                Storage::File(file) => {
                    let starts = read_entries(file, entries, &mut bytes)?;
                    let parts = entries.par_iter().zip(&starts);
                    let decode = |(entry, &start): (&Entry, &usize)| {
                        let bytes = &bytes[start..start + entry.size as usize];
                        (unpacked(entry.at), decoded(bytes, unpacked(entry.at), material))
                    };
                    parts.map(decode).collect()
                }
            };
            each(bricks)?;
        }
        Ok(())
    }
}

/// Reads the records of entries one after the other into `bytes`, neighbours in one go; returns where each begins.
fn read_entries(file: &mut TemporaryFile, entries: &[Entry], bytes: &mut Vec<u8>) -> io::Result<Vec<usize>> {
    bytes.clear();
    let mut starts = Vec::with_capacity(entries.len());
    let mut at = 0;
    while at < entries.len() {
        let first = entries[at];
        let mut end = first.offset;
        while at < entries.len() && entries[at].offset == end {
            starts.push(bytes.len() + (end - first.offset) as usize);
            end += u64::from(entries[at].size);
            at += 1;
        }
        let start = bytes.len();
        bytes.resize(start + (end - first.offset) as usize, 0);
        file.file().seek(SeekFrom::Start(first.offset))?;
        file.file().read_exact(&mut bytes[start..])?;
    }
    Ok(starts)
}

fn packed(at: IVec3) -> u64 {
    let [x, y, z] = at.to_array().map(|value| (value + BIAS) as u64 & 0x1f_ffff);
    x | y << 21 | z << 42
}

fn unpacked(at: u64) -> IVec3 {
    IVec3::from_array([0, 21, 42].map(|shift| (at >> shift & 0x1f_ffff) as i32 - BIAS))
}

/// A brick from its record, which this module wrote.
fn decoded(bytes: &[u8], at: IVec3, material: &impl Fn(Key, IVec3) -> u16) -> Brick {
    let (flags, blocks) = (bytes[0], bytes[1]);
    let mut occupancy = [0; 8];
    let mut rest = &bytes[2..];
    for (block, mask) in occupancy.iter_mut().enumerate() {
        if blocks >> block & 1 != 0 {
            let (word, after) = rest.split_at(8);
            *mask = word.iter().rev().fold(0, |mask, &byte| mask << 8 | u64::from(byte));
            rest = after;
        }
    }
    let size = if flags & EMITS != 0 { 8 } else { 4 };
    let key = |index: usize| {
        let start = if flags & ONE_LOOK != 0 { 0 } else { index * size };
        rest[start..start + size].iter().rev().fold(0, |key, &byte| key << 8 | u64::from(byte))
    };
    let voxels = (0..8).flat_map(|block| crate::brick::bits(occupancy[block]).map(move |bit| (block, bit)));
    let materials = voxels.enumerate().map(|(rank, (block, bit))| {
        material(key(rank), at * crate::brick::BRICK_SIZE + crate::brick::voxel_of(block, bit))
    });
    let materials = materials.collect();
    Brick::new(occupancy, materials)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn records() -> Vec<TileRecords> {
        let mut first = TileRecords::default();
        first.push(IVec3::new(1, 2, 3), &[0b101, 0, 0, 0, 0, 0, 0, 1 << 63], &[7, 8, 9]);
        first.push(IVec3::new(-1, 0, 0), &[u64::MAX, 0, 0, 0, 0, 0, 0, 0], &[5]);
        let mut second = TileRecords::default();
        second.push(IVec3::ZERO, &[0b11, 0, 0, 0, 0, 0, 0, 0], &[3 << 32 | 1, 2]);
        vec![first, TileRecords::default(), second]
    }

    fn content(mut spool: Spool) -> Vec<(IVec3, Vec<u16>)> {
        for tile in records() {
            spool.push(tile).unwrap();
        }
        assert_eq!((spool.voxels(), spool.brick_count()), (69, 3));
        spool.sort_by_key(|at| (at.z, at.y, at.x));
        let mut all = Vec::new();
        let material =
            |key: Key, voxel: IVec3| (key as u16) + 100 * (key >> 32) as u16 + 1000 * u16::from(voxel.x == 2);
        let collect = |batch: Vec<(IVec3, Brick)>| {
            all.extend(batch.into_iter().map(|(at, brick)| (at, brick.materials().to_vec())));
            Ok(())
        };
        spool.for_each_batch(&material, collect).unwrap();
        all
    }

    #[test]
    fn bricks_come_back_in_order_from_memory_and_file_alike() {
        let expected = vec![
            (IVec3::new(-1, 0, 0), vec![5; 64]),
            (IVec3::ZERO, vec![301, 2]),
            (IVec3::new(1, 2, 3), vec![7, 8, 9]),
        ];
        assert_eq!(content(Spool::in_memory()), expected);
        let folder = tempfile::tempdir().unwrap();
        let file = TemporaryFile::beside(&folder.path().join("out.vxt")).unwrap();
        assert_eq!(content(Spool::in_file(file)), expected);
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
    }
}
