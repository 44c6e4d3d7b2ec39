//! Bricks that wait for their materials: which colours there are is known only when the last tile is done. They wait as
//! bytes in memory, or in a part file beside the output, from which interrupted work goes on.

use super::VoxelizeProgress;
use super::census::Census;
use super::key::{Key, MAX_CLASSES};
use super::part::{Found, Frame, PartFile, Step};
use glam::IVec3;
use std::io::{self, Read, Seek, SeekFrom};
use std::path::Path;
use voxtrace_scene::brick::Brick;

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
    /// The last step whose bricks are here from earlier.
    done: Option<Step>,
}

enum Storage {
    /// Pieces and where each begins.
    Memory(Vec<(u64, Vec<u8>)>),
    File(PartFile, Found),
}

impl Spool {
    /// A spool in memory.
    pub fn in_memory() -> Self {
        Self { storage: Storage::Memory(Vec::new()), entries: Vec::new(), size: 0, voxels: 0, done: None }
    }

    /// A spool in the part file beside an output, which is removed with the spool. `key` stands for the whole work.
    pub fn beside(output: &Path, key: u128) -> io::Result<Self> {
        let (part, found) = PartFile::open(output, key)?;
        Ok(Self { storage: Storage::File(part, found), ..Self::in_memory() })
    }

    /// Leaves the part file, if there is one, for the next time.
    pub fn keep(&mut self, progress: &VoxelizeProgress) {
        if let Storage::File(part, _) = &mut self.storage {
            part.keep();
            if !self.entries.is_empty() {
                let path = part.path().display();
                progress.note(format!("what is done is kept in {path}: the same command goes on from there"));
            }
        }
    }

    /// Takes what earlier work left in the part file, and counts its looks.
    pub fn resume(&mut self, census: &Census, progress: &VoxelizeProgress) -> io::Result<()> {
        let Storage::File(part, found) = &mut self.storage else { return Ok(()) };
        let name = part.path().display().to_string();
        let length = part.file()?.metadata()?.len();
        let mut taken = 0;
        while let Some(frame) = part.next()? {
            let count = self.entries.len();
            let Some(voxels) = take_frame(&frame, census, &mut self.entries) else {
                self.entries.truncate(count);
                part.reject(&frame);
                part.cut()?;
                break;
            };
            self.voxels += voxels;
            self.done = Some(frame.step);
            taken += 1;
        }
        let kept = part.file()?.metadata()?.len();
        match found {
            Found::Nothing => {}
            Found::Other => progress.note(format!("{name} is left over from other work: starting over")),
            Found::Own if taken == 0 => progress.note(format!("nothing in {name} is whole: starting over")),
            Found::Own => {
                let cut = if kept < length { " (its end was not whole)" } else { "" };
                let count = self.entries.len();
                progress.note(format!("going on from {name}: {count} bricks are done{cut}"));
            }
        }
        Ok(())
    }

    /// Whether the bricks of a step are here from earlier.
    pub fn has(&self, step: Step) -> bool {
        self.done.is_some_and(|done| step <= done)
    }

    /// Whether all bricks of a part are here from earlier.
    pub fn is_past(&self, part: u32) -> bool {
        self.done.is_some_and(|done| part < done.part)
    }

    /// Voxels so far.
    pub fn voxels(&self) -> u64 {
        self.voxels
    }

    /// Bricks so far.
    pub fn brick_count(&self) -> usize {
        self.entries.len()
    }

    /// Adds the bricks of a step. Each brick comes once.
    pub fn push(&mut self, step: Step, batch: Vec<TileRecords>) -> io::Result<()> {
        let (mut entries, mut bytes) = (Vec::new(), Vec::new());
        let first = self.entries.len();
        for records in batch {
            let (mut start, base) = (0, self.size + bytes.len() as u64);
            for &(at, end) in &records.bricks {
                self.entries.push(Entry { at: packed(at), offset: base + u64::from(start), size: end - start });
                start = end;
            }
            self.voxels += records.voxels;
            match &mut self.storage {
                Storage::Memory(pieces) => {
                    if !records.bytes.is_empty() {
                        let at = self.size;
                        self.size += records.bytes.len() as u64;
                        pieces.push((at, records.bytes));
                    }
                }
                Storage::File(..) => bytes.extend_from_slice(&records.bytes),
            }
        }
        if let Storage::File(part, _) = &mut self.storage {
            for entry in &self.entries[first..] {
                entries.extend(entry.at.to_le_bytes());
                entries.extend(entry.size.to_le_bytes());
            }
            let content_at = part.append(step, &entries, &bytes)?;
            self.entries[first..].iter_mut().for_each(|entry| entry.offset += content_at);
        }
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
                Storage::File(part, _) => {
                    let starts = read_entries(part, entries, &mut bytes)?;
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
fn read_entries(part: &mut PartFile, entries: &[Entry], bytes: &mut Vec<u8>) -> io::Result<Vec<usize>> {
    let file = part.file()?;
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
        file.seek(SeekFrom::Start(first.offset))?;
        file.read_exact(&mut bytes[start..])?;
    }
    Ok(starts)
}

/// Bytes of an entry in a frame: coordinates and size of the record.
const ENTRY: usize = 12;

/// Takes the bricks of a frame and counts their looks; returns their voxels, `None` where the records are none.
fn take_frame(frame: &Frame, census: &Census, entries: &mut Vec<Entry>) -> Option<u64> {
    let (listed, rest) = frame.entries.as_chunks::<ENTRY>();
    let (mut at, mut voxels, mut looks) = (0usize, 0, Vec::new());
    for &[a, b, c, d, e, f, g, h, sizes @ ..] in listed {
        let size = u32::from_le_bytes(sizes);
        let record = frame.content.get(at..at.checked_add(size as usize)?)?;
        looks.push(looks_of(record)?);
        let place = u64::from_le_bytes([a, b, c, d, e, f, g, h]);
        entries.push(Entry { at: place, offset: frame.content_at + at as u64, size });
        at += size as usize;
    }
    if !rest.is_empty() || at != frame.content.len() {
        return None;
    }
    for (keys, times) in looks {
        voxels += keys.len() as u64 * u64::from(times);
        census.add(&keys, times);
    }
    Some(voxels)
}

/// The looks in a record and how many voxels have each, `None` where it is no record.
fn looks_of(record: &[u8]) -> Option<(Vec<Key>, u32)> {
    let (&[flags, blocks], rest) = record.split_first_chunk::<2>()?;
    let (masks, keys) = rest.split_at_checked(8 * blocks.count_ones() as usize)?;
    let voxels: u32 = masks.iter().map(|mask| mask.count_ones()).sum();
    let size = if flags & EMITS != 0 { 8 } else { 4 };
    let (count, times) = if flags & ONE_LOOK != 0 { (1, voxels) } else { (voxels as usize, 1) };
    let key = |bytes: &[u8]| bytes.iter().rev().fold(0, |key: Key, &byte| key << 8 | Key::from(byte));
    let keys: Vec<Key> = keys.chunks(size).map(key).collect();
    let is_known = keys.iter().all(|key| ((key >> 24 & 0xff) as usize) < MAX_CLASSES);
    let is_whole = rest.len() == masks.len() + count * size && voxels > 0;
    (is_known && is_whole).then_some((keys, times))
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
    let voxels = (0..8).flat_map(|block| voxtrace_scene::brick::bits(occupancy[block]).map(move |bit| (block, bit)));
    let materials = voxels.enumerate().map(|(rank, (block, bit))| {
        material(key(rank), at * voxtrace_scene::brick::BRICK_SIZE + voxtrace_scene::brick::voxel_of(block, bit))
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

    const STEP: Step = Step { part: 0, batch: 4 };

    fn content(mut spool: Spool) -> Vec<(IVec3, Vec<u16>)> {
        if !spool.has(STEP) {
            spool.push(STEP, records()).unwrap();
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

    fn expected() -> Vec<(IVec3, Vec<u16>)> {
        vec![(IVec3::new(-1, 0, 0), vec![5; 64]), (IVec3::ZERO, vec![301, 2]), (IVec3::new(1, 2, 3), vec![7, 8, 9])]
    }

    fn resumed(output: &Path) -> (Spool, Census, Vec<String>) {
        let (mut spool, census, progress) =
            (Spool::beside(output, 1).unwrap(), Census::default(), VoxelizeProgress::default());
        spool.resume(&census, &progress).unwrap();
        (spool, census, progress.take_notes())
    }

    #[test]
    fn bricks_come_back_in_order_from_memory_and_file_alike() {
        assert_eq!(content(Spool::in_memory()), expected());
        let folder = tempfile::tempdir().unwrap();
        let output = folder.path().join("out.vxt");
        let (spool, _, notes) = resumed(&output);
        assert_eq!((content(spool), notes), (expected(), vec![]));
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
    }

    #[test]
    fn bricks_and_their_looks_come_back_from_earlier_work() {
        let folder = tempfile::tempdir().unwrap();
        let output = folder.path().join("out.vxt");
        let (mut spool, ..) = resumed(&output);
        spool.push(STEP, records()).unwrap();
        spool.keep(&VoxelizeProgress::default());
        drop(spool);
        let (spool, census, notes) = resumed(&output);
        assert!(spool.has(STEP) && !spool.has(Step { part: 0, batch: 5 }) && !spool.is_past(0));
        assert!(notes[0].contains("3 bricks are done"), "{notes:?}");
        assert_eq!((census.looks(), census.emitting()), (vec![2, 5, 7, 8, 9], vec![(3 << 32 | 1, 1)]));
        // Looks 4 and 5, and 8 and 9, share a bin.
        assert_eq!(census.bins(0), vec![(1, 1), (2, 64), (3, 1), (4, 2)]);
        assert_eq!(content(spool), expected());
    }

    #[test]
    fn a_record_that_is_none_is_not_taken() {
        let good: Vec<u8> = records().remove(0).bytes;
        let end = records()[0].bricks[0].1 as usize;
        assert_eq!(looks_of(&good[..end]).unwrap(), (vec![7, 8, 9], 1));
        assert_eq!(looks_of(&good[end..]).unwrap(), (vec![5], 64));
        for end in [0, 1, 2, 9, end - 1, end + 1] {
            assert!(looks_of(&good[..end]).is_none(), "{end}");
        }
        let mut class = good[..end].to_vec();
        class[end - 1] = MAX_CLASSES as u8;
        assert!(looks_of(&class).is_none());
    }
}
