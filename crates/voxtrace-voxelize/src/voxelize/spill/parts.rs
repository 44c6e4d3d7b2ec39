//! Spill buffers that several processes share: each writes a part, a log of its own, and whoever merges them reads all logs. Bricks
//! that are not finished, because points of several parts are in them, are finished then.

use super::record::add_sums;
use super::{
    Entry, SpillBuffer, Storage, TileRecords, listed, packed_coordinates, read_entries, take_frame,
    unpacked_coordinates,
};
use crate::voxelize::checkpoint::{CheckpointFile, Existing, Frame, FrameKind, Step};
use crate::voxelize::color_histogram::{ColorHistogram, Tally};
use crate::voxelize::points::{VOXEL_BITS, VoxelSums, finish_brick};
use crate::voxelize::{VoxelizeError, VoxelizeProgress};
use rayon::prelude::*;
use std::fs::File;
use std::io::{self, Write};
use std::ops::Range;
use std::path::{Path, PathBuf};
use voxtrace_core::atomic_file::TemporaryFile;

/// Bricks that are finished at a time.
const BATCH: usize = 1 << 10;

/// Bytes of frames that are gone through side by side.
const WAITING: usize = 4 << 20;

/// A log of a part, read to its end.
struct PartLog {
    file: File,
    /// The files that the part was made of, by their numbers.
    files: Range<u64>,
    finished: Vec<Entry>,
    sums: Vec<Entry>,
    voxels: u64,
}

impl SpillBuffer {
    /// A buffer in an empty file, which becomes a part of the work with this fingerprint.
    pub(crate) fn of_part(file: File, key: u128) -> io::Result<Self> {
        Ok(Self { storage: Storage::File(CheckpointFile::begin(file, key)?, Existing::Nothing), ..Self::in_memory() })
    }

    /// Writes the last frame of a part, which says what files it was made of.
    pub(crate) fn end_part(&mut self, files: Range<u64>) -> io::Result<()> {
        let Storage::File(file, _) = &mut self.storage else { return Ok(()) };
        let content = [files.start.to_le_bytes(), files.end.to_le_bytes()].concat();
        file.append(Step { part: u32::MAX, batch: u32::MAX }, FrameKind::End, &[], &content).map(drop)
    }

    /// Writes a frame of what is not finished of a batch, if there is anything.
    pub(super) fn push_sums(&mut self, step: Step, batch: &[TileRecords]) -> io::Result<()> {
        let (mut entries, mut content) = (Vec::new(), Vec::new());
        for TileRecords { sums: (bytes, bricks), .. } in batch {
            let mut start = 0;
            for &(at, end) in bricks {
                entries.extend(packed_coordinates(at).to_le_bytes());
                entries.extend((end - start).to_le_bytes());
                start = end;
            }
            content.extend_from_slice(bytes);
        }
        match &mut self.storage {
            _ if entries.is_empty() => Ok(()),
            Storage::File(file, _) => file.append(step, FrameKind::Sums, &entries, &content).map(drop),
            _ => Err(io::ErrorKind::Unsupported.into()),
        }
    }

    /// A buffer of all bricks in the parts of some work: `key` is its fingerprint, and `count` how many files, or what else, the parts were made of
    /// together. Appearances are added to the histogram; voxels of fewer points than `min_points` are left out. What is finished now
    /// lies in a file without a name beside `path`.
    ///
    /// # Errors
    /// If a part cannot be read, is damaged or of other work, or a file is in none or two of them; also if it was cancelled.
    pub(crate) fn of_parts(
        parts: &[PathBuf],
        (key, count, what): (u128, u64, &'static str),
        (histogram, min_points): (&ColorHistogram, u32),
        path: &Path,
        progress: &VoxelizeProgress,
    ) -> Result<Self, VoxelizeError> {
        let (mut own, mut files, mut sums) = (Self::in_memory(), Vec::new(), Vec::new());
        let mut ranges = Vec::new();
        let read = |path: &PathBuf| {
            if progress.is_cancelled() {
                Err(VoxelizeError::Cancelled)
            } else {
                PartLog::read(path, (key, what), histogram)
            }
        };
        let logs: Vec<Result<PartLog, VoxelizeError>> = parts.par_iter().map(read).collect();
        for (number, (path, log)) in parts.iter().zip(logs).enumerate() {
            let mut log = log?;
            log.finished.iter_mut().chain(&mut log.sums).for_each(|entry| entry.file = number as u32);
            own.entries.append(&mut log.finished);
            sums.append(&mut log.sums);
            own.voxels += log.voxels;
            ranges.push((log.files, path));
            files.push(log.file);
        }
        check_ranges(ranges, count, what)?;
        files.push(TemporaryFile::nameless(path)?.try_clone()?);
        // Who made a part, and in which order they are named, must not matter to anything.
        sums.par_sort_unstable_by_key(|entry| (entry.at, entry.file));
        own.storage = Storage::Parts(files);
        own.finish_sums(&sums, histogram, min_points, progress)?;
        Ok(own)
    }

    /// Finishes the bricks of sums, which are sorted by their places, and appends them to the last file.
    fn finish_sums(
        &mut self,
        sums: &[Entry],
        histogram: &ColorHistogram,
        min_points: u32,
        progress: &VoxelizeProgress,
    ) -> Result<(), VoxelizeError> {
        let Storage::Parts(files) = &mut self.storage else { return Ok(()) };
        let (last, mut end) = (files.len() - 1, 0u64);
        let bricks: Vec<&[Entry]> = sums.chunk_by(|a, b| a.at == b.at).collect();
        let mut out = files[last].try_clone()?;
        for batch in bricks.chunks(BATCH) {
            let entries = batch.concat();
            let (bytes, starts) = read_entries(files, &entries)?;
            let mut first = 0;
            let batch: Vec<(&[Entry], &[usize])> = batch
                .iter()
                .map(|brick| {
                    first += brick.len();
                    (*brick, &starts[first - brick.len()..first])
                })
                .collect();
            let work = |(scratch, tally): &mut (Vec<VoxelSums>, Tally<'_>), (brick, starts): &(&[Entry], &[usize])| {
                scratch.resize(1 << VOXEL_BITS, [0; 4]);
                let (mut occupancy, mut keys, mut records) = ([0; 8], Vec::new(), TileRecords::default());
                for (entry, &start) in brick.iter().zip(*starts) {
                    add_sums(&bytes[start..start + entry.size as usize], &mut occupancy, scratch)?;
                }
                finish_brick(&mut occupancy, scratch, min_points, &mut keys);
                if !keys.is_empty() {
                    tally.add(&keys, 1);
                    records.push(unpacked_coordinates(brick[0].at), &occupancy, &keys);
                }
                Some(records)
            };
            let made: Option<Vec<TileRecords>> =
                batch.par_iter().map_init(|| (Vec::new(), histogram.tally()), work).collect();
            let made = made.ok_or_else(|| VoxelizeError::Parts("sums in a part are not valid".into()))?;
            for records in made {
                for &(at, size) in &records.bricks {
                    let at = packed_coordinates(at);
                    self.entries.push(Entry { at, offset: end, size, file: last as u32 });
                }
                out.write_all(&records.bytes)?;
                end += records.bytes.len() as u64;
                self.voxels += records.voxels;
            }
            if progress.is_cancelled() {
                return Err(VoxelizeError::Cancelled);
            }
        }
        Ok(())
    }
}

impl PartLog {
    fn read(path: &Path, (key, what): (u128, &str), histogram: &ColorHistogram) -> Result<Self, VoxelizeError> {
        let fault = |what: &str| VoxelizeError::Parts(format!("{}: {what}", path.display()));
        let named = |error: io::Error| match error.raw_os_error() {
            Some(_) => fault(&error.to_string()),
            None => error.into(),
        };
        let log = CheckpointFile::open_to_read(path, key).map_err(named)?;
        let mut log = log.ok_or_else(|| fault(&format!("no part of these {what} with these options")))?;
        let (mut finished, mut sums, mut voxels) = (Vec::new(), Vec::new(), 0);
        let damaged = |at: u64| fault(&format!("the part is damaged at byte {at}"));
        // Frames are read one after the other, and gone through side by side.
        let (mut waiting, mut size) = (Vec::new(), 0);
        let mut take = |frames: &mut Vec<Frame>| -> Result<(), VoxelizeError> {
            let taken =
                frames.par_iter().map(|frame| take_frame(frame, histogram).ok_or_else(|| damaged(frame.content_at)));
            let taken: Result<Vec<_>, VoxelizeError> = taken.collect();
            for (entries, count) in taken? {
                finished.extend(entries);
                voxels += count;
            }
            frames.clear();
            Ok(())
        };
        let files = loop {
            let frame = match log.next_whole().map_err(named)? {
                Ok(Some(frame)) => frame,
                Ok(None) => return Err(fault("the part is not whole")),
                Err(at) => return Err(damaged(at)),
            };
            let broken = || damaged(frame.content_at);
            match frame.kind {
                FrameKind::Bricks => {
                    size += frame.content.len();
                    waiting.push(frame);
                    if size >= WAITING {
                        take(&mut waiting)?;
                        size = 0;
                    }
                }
                FrameKind::Sums => sums.extend(listed(&frame).ok_or_else(broken)?),
                FrameKind::End => match *frame.content.as_chunks::<8>().0 {
                    [start, end] => break u64::from_le_bytes(start)..u64::from_le_bytes(end),
                    _ => return Err(broken()),
                },
            }
        };
        take(&mut waiting)?;
        let file = log.into_file().ok_or_else(|| io::Error::from(io::ErrorKind::NotFound))?;
        Ok(Self { file, files, finished, sums, voxels })
    }
}

/// Checks that each of `count` files is in one part.
fn check_ranges(mut ranges: Vec<(Range<u64>, &PathBuf)>, count: u64, what: &str) -> Result<(), VoxelizeError> {
    ranges.sort_by_key(|(range, _)| (range.start, range.end));
    let wrong = |what: String| Err(VoxelizeError::Parts(what));
    let mut next = 0;
    for (range, path) in ranges {
        if range.start < next {
            return wrong(format!(
                "{}: {what} {}..{} are in another part, too",
                path.display(),
                range.start,
                next.min(range.end)
            ));
        }
        if range.start > next {
            return wrong(format!("{what} {next}..{} of {count} are in no part", range.start));
        }
        next = range.end;
    }
    if next < count { wrong(format!("{what} {next}..{count} of {count} are in no part")) } else { Ok(()) }
}
