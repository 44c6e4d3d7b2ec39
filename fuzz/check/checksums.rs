//! The checksums of a native file (`docs/format.md`) after somebody changed its bytes.

use std::ops::Range;
use xxhash_rust::xxh3::xxh3_64;

/// Writes the checksums that the sections and their table have, as far as they lie in the file; those of levels of detail, which are as files of their own, first.
pub fn mend(bytes: &mut [u8]) {
    if bytes.len() < 64 {
        return;
    }
    for entry in table(bytes).step_by(32) {
        let is_level = bytes.get(entry..entry + 2) == Some(b"LV");
        if let Some(level) = section(bytes, entry).filter(|_| is_level) {
            mend_one(&mut bytes[level]);
        }
    }
    mend_one(bytes);
}

/// As [`mend`], but for levels.
fn mend_one(bytes: &mut [u8]) {
    if bytes.len() < 64 {
        return;
    }
    let table = table(bytes);
    for entry in table.clone().step_by(32) {
        let Some(sum) = section(bytes, entry).map(|section| xxh3_64(&bytes[section])) else { continue };
        if let Some(place) = bytes.get_mut(entry + 24..entry + 32) {
            place.copy_from_slice(&sum.to_le_bytes());
        }
    }
    if let Some(sum) = bytes.get(table).map(xxh3_64) {
        bytes[16..24].copy_from_slice(&sum.to_le_bytes());
    }
}

/// Where the section table lies; of one that is longer than the file, about as much as fits.
pub fn table(bytes: &[u8]) -> Range<usize> {
    let count = u32::from_le_bytes(bytes[12..16].try_into().expect("four bytes")) as usize;
    64..64 + 32 * count.min(bytes.len() / 32)
}

/// Where the section with an entry lies, if that is in the file.
pub fn section(bytes: &[u8], entry: usize) -> Option<Range<usize>> {
    let number = |at: usize| usize::try_from(u64::from_le_bytes(*bytes.get(at..at + 8)?.first_chunk()?)).ok();
    let (start, size) = (number(entry + 8)?, number(entry + 16)?);
    let section = start..start.checked_add(size)?;
    bytes.get(section.clone()).map(|_| section)
}
