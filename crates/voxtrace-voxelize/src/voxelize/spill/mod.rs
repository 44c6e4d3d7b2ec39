//! The spill buffer: encoded bricks of finished tiles, until the last tile is done and the materials can be chosen. They are
//! kept in memory, or spilled to a checkpoint file beside the output, from which interrupted work resumes.

mod parts;
mod record;

pub use record::TileRecords;

use super::VoxelizeProgress;
use super::appearance::AppearanceKey;
use super::checkpoint::{CheckpointFile, Existing, Frame, FrameKind, Step};
use super::color_histogram::ColorHistogram;
use crate::read_at::read_exact_at;
use glam::IVec3;
use rayon::prelude::*;
use record::{appearances_of, decoded_brick, packed_coordinates, unpacked_coordinates};
use std::fs::File;
use std::io;
use std::path::Path;
use voxtrace_scene::brick::Brick;

/// Where the record of a brick lies.
#[derive(Clone, Copy)]
struct Entry {
    /// Packed brick coordinates.
    at: u64,
    offset: u64,
    size: u32,
    /// Which of several files it is in.
    file: u32,
}

/// The bricks of all tiles so far.
pub(crate) struct SpillBuffer {
    storage: Storage,
    entries: Vec<Entry>,
    size: u64,
    voxels: u64,
    /// The last step that was resumed from an earlier process.
    done: Option<Step>,
}

enum Storage {
    /// Byte strings, each with its offset in their concatenation.
    Memory(Vec<(u64, Vec<u8>)>),
    File(CheckpointFile, Existing),
    /// Files that others have written.
    Parts(Vec<File>),
}

impl SpillBuffer {
    /// A buffer in memory.
    pub fn in_memory() -> Self {
        Self { storage: Storage::Memory(Vec::new()), entries: Vec::new(), size: 0, voxels: 0, done: None }
    }

    /// A buffer in the checkpoint file beside an output; dropping it removes the file unless [`Self::keep`] was called. `key` is
    /// the fingerprint of the work.
    pub fn beside(output: &Path, key: u128) -> io::Result<Self> {
        let (file, found) = CheckpointFile::open(output, key)?;
        Ok(Self { storage: Storage::File(file, found), ..Self::in_memory() })
    }

    /// Keeps the checkpoint file, if there is one, to be resumed.
    pub fn keep(&mut self, progress: &VoxelizeProgress) {
        if let Storage::File(file, _) = &mut self.storage {
            file.keep();
            if !self.entries.is_empty() {
                let path = file.path().display();
                progress.note(format!("what is done is kept in {path}: the same command goes on from there"));
            }
        }
    }

    /// As [`Self::resume`], of bricks whose materials are known already.
    pub fn resume_settled(&mut self, progress: &VoxelizeProgress) -> io::Result<()> {
        self.resume(&ColorHistogram::default(), progress)
    }

    /// Resumes: takes the intact frames of the checkpoint file and adds their appearances to the histogram.
    pub(in crate::voxelize) fn resume(
        &mut self,
        histogram: &ColorHistogram,
        progress: &VoxelizeProgress,
    ) -> io::Result<()> {
        let Storage::File(file, found) = &mut self.storage else { return Ok(()) };
        let name = file.path().display().to_string();
        let length = file.file()?.metadata()?.len();
        let mut taken = 0;
        while let Some(frame) = file.next()? {
            let bricks = if frame.kind == FrameKind::Bricks { take_frame(&frame, histogram) } else { None };
            let Some((entries, voxels)) = bricks else {
                file.reject(&frame);
                file.cut()?;
                break;
            };
            self.entries.extend(entries);
            self.voxels += voxels;
            self.done = Some(frame.step);
            taken += 1;
        }
        let kept = file.file()?.metadata()?.len();
        match found {
            Existing::Nothing => {}
            Existing::Other => progress.note(format!("{name} is left over from other work: starting over")),
            Existing::Own if taken == 0 => progress.note(format!("nothing in {name} is whole: starting over")),
            Existing::Own => {
                let cut = if kept < length { " (its end was not whole)" } else { "" };
                let count = self.entries.len();
                progress.note(format!("going on from {name}: {count} bricks are done{cut}"));
            }
        }
        Ok(())
    }

    /// Whether the bricks of a step were resumed.
    pub fn has(&self, step: Step) -> bool {
        self.done.is_some_and(|done| step <= done)
    }

    /// Whether nothing was resumed.
    pub fn is_new(&self) -> bool {
        self.done.is_none()
    }

    /// Whether all bricks of a part were resumed.
    pub fn is_past(&self, part: u32) -> bool {
        self.done.is_some_and(|done| part < done.part)
    }

    /// Number of voxels so far.
    pub fn voxels(&self) -> u64 {
        self.voxels
    }

    /// Number of bricks so far.
    pub fn brick_count(&self) -> usize {
        self.entries.len()
    }

    /// Adds the bricks of a step. No two bricks may have the same coordinates.
    pub fn push(&mut self, step: Step, batch: Vec<TileRecords>) -> io::Result<()> {
        let (mut entries, mut bytes) = (Vec::new(), Vec::new());
        let first = self.entries.len();
        self.push_sums(step, &batch)?;
        for records in batch {
            let (mut start, base) = (0, self.size + bytes.len() as u64);
            for &(at, end) in &records.bricks {
                self.entries.push(Entry {
                    at: packed_coordinates(at),
                    offset: base + u64::from(start),
                    size: end - start,
                    file: 0,
                });
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
                Storage::Parts(_) => return Err(io::ErrorKind::Unsupported.into()),
            }
        }
        if let Storage::File(file, _) = &mut self.storage {
            for entry in &self.entries[first..] {
                entries.extend(entry.at.to_le_bytes());
                entries.extend(entry.size.to_le_bytes());
            }
            let content_at = file.append(step, FrameKind::Bricks, &entries, &bytes)?;
            self.entries[first..].iter_mut().for_each(|entry| entry.offset += content_at);
        }
        Ok(())
    }

    /// Coordinates of all bricks, in the order of [`Self::for_each_piece`].
    pub fn coordinates(&self) -> impl ExactSizeIterator<Item = IVec3> + '_ {
        self.entries.iter().map(|entry| unpacked_coordinates(entry.at))
    }

    /// Sorts the bricks by a key of their coordinates.
    pub fn sort_by_key<K: Ord + Send>(&mut self, key: impl Fn(IVec3) -> K + Sync) {
        self.entries.par_sort_by_cached_key(|entry| key(unpacked_coordinates(entry.at)));
    }

    /// Decodes all bricks in their order and calls `each` with batches of them and their coordinates. `material` chooses the
    /// material by appearance and voxel.
    pub fn for_each_piece<T: Send>(
        &mut self,
        material: &(impl Fn(AppearanceKey, IVec3) -> u16 + Sync),
        make: impl Fn(Vec<(IVec3, Brick)>) -> T + Sync,
        mut each: impl FnMut(T) -> io::Result<()>,
    ) -> io::Result<()> {
        /// Bricks that one task reads and decodes.
        const PIECE: usize = 1 << 8;
        /// Pieces that are worked on together.
        const TOGETHER: usize = 1 << 6;
        let decode = |entry: &Entry, bytes: &[u8]| {
            let at = unpacked_coordinates(entry.at);
            (at, decoded_brick(&bytes[..entry.size as usize], at, material))
        };
        let (pieces, files): (&[(u64, Vec<u8>)], &[File]) = match &mut self.storage {
            Storage::Memory(pieces) => (pieces, &[]),
            Storage::File(file, _) => (&[], std::slice::from_ref(file.file()?)),
            Storage::Parts(files) => (&[], files),
        };
        let read = |entries: &[Entry]| -> io::Result<T> {
            if files.is_empty() {
                let bytes = |entry: &Entry| {
                    let piece = pieces.partition_point(|piece| piece.0 <= entry.offset) - 1;
                    &pieces[piece].1[(entry.offset - pieces[piece].0) as usize..]
                };
                return Ok(make(entries.iter().map(|entry| decode(entry, bytes(entry))).collect()));
            }
            let (bytes, starts) = read_entries(files, entries)?;
            Ok(make(entries.iter().zip(starts).map(|(entry, start)| decode(entry, &bytes[start..])).collect()))
        };
        for pieces in self.entries.chunks(PIECE * TOGETHER) {
            let made: io::Result<Vec<T>> = pieces.par_chunks(PIECE).map(read).collect();
            made?.into_iter().try_for_each(&mut each)?;
        }
        Ok(())
    }
}

/// Records that lie at most so many bytes apart are read at once.
const GAP: u64 = 1 << 10;

/// Reads the records of some entries; where each begins among the bytes. Several threads may read from the same files.
fn read_entries(files: &[File], entries: &[Entry]) -> io::Result<(Vec<u8>, Vec<usize>)> {
    let mut order: Vec<usize> = (0..entries.len()).collect();
    order.sort_unstable_by_key(|&index| (entries[index].file, entries[index].offset));
    let end_of = |index: usize| entries[index].offset + u64::from(entries[index].size);
    let is_near = |&a: &usize, &b: &usize| {
        entries[a].file == entries[b].file && entries[b].offset.saturating_sub(end_of(a)) <= GAP
    };
    let (mut bytes, mut starts) = (Vec::new(), vec![0; entries.len()]);
    for run in order.chunk_by(is_near) {
        let (first, start) = (entries[run[0]], bytes.len());
        run.iter().for_each(|&index| starts[index] = start + (entries[index].offset - first.offset) as usize);
        let end = run.iter().map(|&index| end_of(index)).max().unwrap_or(first.offset);
        bytes.resize(start + (end - first.offset) as usize, 0);
        let file = files.get(first.file as usize).ok_or(io::ErrorKind::NotFound)?;
        read_exact_at(file, &mut bytes[start..], first.offset)?;
    }
    Ok((bytes, starts))
}

/// Bytes of an entry in a frame: packed coordinates (8) and size of the record (4).
const ENTRY: usize = 12;

/// The bricks of a frame, and the number of their voxels, whose appearances are counted; `None` if a record is not valid.
fn take_frame(frame: &Frame, histogram: &ColorHistogram) -> Option<(Vec<Entry>, u64)> {
    let entries = listed(frame)?;
    let appearances: Option<Vec<_>> = entries.iter().map(|entry| appearances_of(record_of(frame, entry))).collect();
    let (mut voxels, mut tally) = (0, histogram.tally());
    for (keys, times) in appearances? {
        voxels += keys.len() as u64 * u64::from(times);
        tally.add(&keys, times);
    }
    Some((entries, voxels))
}

/// The entries of a frame; `None` where they are not those of its content.
fn listed(frame: &Frame) -> Option<Vec<Entry>> {
    let (listed, rest) = frame.entries.as_chunks::<ENTRY>();
    let mut at = 0usize;
    let mut entries = Vec::with_capacity(listed.len());
    for &[a, b, c, d, e, f, g, h, sizes @ ..] in listed {
        let (place, size) = (u64::from_le_bytes([a, b, c, d, e, f, g, h]), u32::from_le_bytes(sizes));
        entries.push(Entry { at: place, offset: frame.content_at + at as u64, size, file: 0 });
        at = at.checked_add(size as usize).filter(|&end| end <= frame.content.len())?;
    }
    (rest.is_empty() && at == frame.content.len()).then_some(entries)
}

/// The record of a frame's own entry.
fn record_of<'a>(frame: &'a Frame, entry: &Entry) -> &'a [u8] {
    &frame.content[(entry.offset - frame.content_at) as usize..][..entry.size as usize]
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

    fn content(mut spill: SpillBuffer) -> Vec<(IVec3, Vec<u16>)> {
        if !spill.has(STEP) {
            spill.push(STEP, records()).unwrap();
        }
        assert_eq!((spill.voxels(), spill.brick_count()), (69, 3));
        spill.sort_by_key(|at| (at.z, at.y, at.x));
        let mut all = Vec::new();
        let material =
            |key: AppearanceKey, voxel: IVec3| (key as u16) + 100 * (key >> 32) as u16 + 1000 * u16::from(voxel.x == 2);
        let collect = |batch: Vec<(IVec3, Brick)>| {
            all.extend(batch.into_iter().map(|(at, brick)| (at, brick.materials().to_vec())));
            Ok(())
        };
        spill.for_each_piece(&material, |piece| piece, collect).unwrap();
        all
    }

    fn expected() -> Vec<(IVec3, Vec<u16>)> {
        vec![(IVec3::new(-1, 0, 0), vec![5; 64]), (IVec3::ZERO, vec![301, 2]), (IVec3::new(1, 2, 3), vec![7, 8, 9])]
    }

    fn resumed(output: &Path) -> (SpillBuffer, ColorHistogram, Vec<String>) {
        let (mut spill, histogram, progress) =
            (SpillBuffer::beside(output, 1).unwrap(), ColorHistogram::default(), VoxelizeProgress::default());
        spill.resume(&histogram, &progress).unwrap();
        (spill, histogram, progress.take_notes())
    }

    #[test]
    fn bricks_come_back_in_order_from_memory_and_file_alike() {
        assert_eq!(content(SpillBuffer::in_memory()), expected());
        let folder = tempfile::tempdir().unwrap();
        let output = folder.path().join("out.vxt");
        let (spill, _, notes) = resumed(&output);
        assert_eq!((content(spill), notes), (expected(), vec![]));
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
    }

    #[test]
    fn bricks_and_their_appearances_come_back_from_earlier_work() {
        let folder = tempfile::tempdir().unwrap();
        let output = folder.path().join("out.vxt");
        let (mut spill, ..) = resumed(&output);
        spill.push(STEP, records()).unwrap();
        spill.keep(&VoxelizeProgress::default());
        drop(spill);
        let (spill, histogram, notes) = resumed(&output);
        assert!(spill.has(STEP) && !spill.has(Step { part: 0, batch: 5 }) && !spill.is_past(0));
        assert!(notes[0].contains("3 bricks are done"), "{notes:?}");
        assert_eq!((histogram.appearances(), histogram.emissive()), (vec![2, 5, 7, 8, 9], vec![(3 << 32 | 1, 1)]));
        // Colours 4 and 5, and 8 and 9, share a bin.
        assert_eq!(histogram.bins(0), vec![(1, 1), (2, 64), (3, 1), (4, 2)]);
        assert_eq!(content(spill), expected());
    }
}
