//! Opening files for streaming: all chunks of a level are inflated side by side.

use super::super::PackedScene;
use super::super::file_error::{FileErrorKind, damaged};
use super::super::levels::MAX_LEVELS;
use super::super::section_reader::Reader;
use super::head::{Front, StreamHead};
use super::whole::WholeLevel;
use super::{chunks_tag, front_tag};
use flate2::read::DeflateDecoder;
use rayon::prelude::*;
use std::io::Read;
use std::ops::Range;

/// Deflate makes of one byte at most so many.
const MOST_INFLATED: u64 = 1032;

/// The scene of a level; level 0 is the one that was saved.
pub fn scene_of(reader: &Reader, level: u32) -> Result<PackedScene, FileErrorKind> {
    let head = StreamHead::read(&section(reader, b"HEAD")?)?;
    let tail = if reader.has(b"TAIL") { Some(section(reader, b"TAIL")?) } else { None };
    let mut whole = WholeLevel::new(&head, level, &section(reader, &front_tag(level))?, tail.as_deref())?;
    let (range, _) = range_of(reader, level)?;
    let stored = reader.bytes(range.clone());
    let front = whole.front();
    let ranges: Vec<Range<u64>> = front.ranges().collect();
    if ranges.last().map_or(0, |last| last.end) != stored.len() as u64 {
        return Err(damaged(format!("the chunks of level {level} are not those of its index"), range.start as u64));
    }
    let chunk = |(number, range): (usize, &Range<u64>)| {
        let bytes = &stored[range.start as usize..range.end as usize];
        let inflated = inflated(bytes, u64::from(front.index[number].size))?;
        front.chunk(number as u32, &inflated)
    };
    let chunks = ranges.par_iter().enumerate().map(chunk).collect::<Result<Vec<_>, _>>()?;
    whole.fill(chunks);
    whole.finish()
}

/// Voxels that a level stores.
pub fn summary_of(reader: &Reader, level: u32) -> Result<u64, FileErrorKind> {
    let head = StreamHead::read(&section(reader, b"HEAD")?)?;
    let front = Front::read(&section(reader, &front_tag(level))?, level, &head)?;
    Ok(front.index.iter().map(|chunk| u64::from(chunk.voxels)).sum())
}

/// Where the coarser levels lie, from the first one on, and their checksums, which are not looked at.
pub fn ranges_of(reader: &Reader) -> Result<Vec<(Range<usize>, u64)>, FileErrorKind> {
    (1..=MAX_LEVELS).take_while(|&level| reader.has(&front_tag(level))).map(|level| range_of(reader, level)).collect()
}

/// Where the chunks of a level lie.
fn range_of(reader: &Reader, level: u32) -> Result<(Range<usize>, u64), FileErrorKind> {
    let missing = || FileErrorKind::Invalid(format!("the chunks of level {level} are missing").into());
    reader.unchecked_range(&chunks_tag(level))?.ok_or_else(missing)
}

/// A section, inflated.
fn section(reader: &Reader, tag: &[u8; 4]) -> Result<Vec<u8>, FileErrorKind> {
    let bytes = reader.section::<u8>(tag)?;
    inflated(&bytes, bytes.len() as u64 * MOST_INFLATED)
}

/// What bytes are when they are inflated, at most so many.
fn inflated(bytes: &[u8], most: u64) -> Result<Vec<u8>, FileErrorKind> {
    let mut inflated = Vec::new();
    let read = DeflateDecoder::new(bytes).take(most.saturating_add(1)).read_to_end(&mut inflated);
    match read {
        Ok(length) if length as u64 <= most => Ok(inflated),
        _ => Err(FileErrorKind::Invalid("what is compressed cannot be inflated".into())),
    }
}
