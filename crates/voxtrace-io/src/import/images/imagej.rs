//! What ImageJ keeps of the looks of channels, in two private tags (ij.io.TiffEncoder): their tables of colours and their ranges.

use super::hyperstack::Hyperstack;
use crate::import::samples::channels::Channel;
use std::io::{Read, Seek};
use tiff::decoder::Decoder;
use tiff::tags::Tag;

/// Tags of the lengths of the parts, and of the parts.
const COUNTS: u16 = 50_838;
const METADATA: u16 = 50_839;
/// The first word, and kinds of parts.
const MAGIC: &[u8; 4] = b"IJIJ";
const LUTS: &[u8; 4] = b"luts";
const RANGES: &[u8; 4] = b"rang";
/// Bytes of a table: red, green, blue.
const TABLE: usize = 768;

/// Adds what the page says to the channels of a stack.
pub(super) fn add_looks<R: Read + Seek>(decoder: &mut Decoder<R>, big_endian: bool, stack: &mut Hyperstack) {
    let counts = decoder.get_tag_u32_vec(Tag::Unknown(COUNTS)).unwrap_or_default();
    let bytes = decoder.get_tag_u8_vec(Tag::Unknown(METADATA)).unwrap_or_default();
    stack.channels = channels(&bytes, &counts, big_endian).unwrap_or_default();
}

/// The channels; `None` where the parts are not what they say.
fn channels(bytes: &[u8], counts: &[u32], big_endian: bool) -> Option<Vec<Channel>> {
    // Words are turned as all numbers of the file.
    let name = |at: usize| {
        let mut name: [u8; 4] = *bytes.get(at..)?.first_chunk()?;
        if !big_endian {
            name.reverse();
        }
        Some(name)
    };
    let number = |at: usize| {
        let word = *bytes.get(at..)?.first_chunk()?;
        Some(if big_endian { f64::from_be_bytes(word) } else { f64::from_le_bytes(word) })
    };
    let (&head, sizes) = counts.split_first()?;
    if name(0)? != *MAGIC {
        return None;
    }
    let (mut at, mut sizes) = (head as usize, sizes.iter());
    let (mut colors, mut windows) = (Vec::new(), Vec::new());
    for kind in (4..head as usize).step_by(8) {
        let count = name(kind + 4).map(u32::from_be_bytes)?;
        for _ in 0..count {
            let size = *sizes.next()? as usize;
            let part = bytes.get(at..at.checked_add(size)?)?;
            match &name(kind)? {
                LUTS if size == TABLE => colors.push([part[255], part[511], part[767]]),
                RANGES => windows.extend(
                    (0..size / 16).filter_map(|n| Some((number(at + 16 * n)? as f32, number(at + 16 * n + 8)? as f32))),
                ),
                _ => {}
            }
            at += size;
        }
    }
    let channel = |n: usize| Channel { color: colors.get(n).copied(), window: windows.get(n).copied() };
    Some((0..colors.len().max(windows.len())).map(channel).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_and_ranges_are_found_in_both_byte_orders() {
        let tables = [[9, 8, 7], [1, 2, 3]];
        for big_endian in [false, true] {
            let word = |value: u32| if big_endian { value.to_be_bytes() } else { value.to_le_bytes() };
            let double = |value: f64| if big_endian { value.to_be_bytes() } else { value.to_le_bytes() };
            let mut bytes: Vec<u8> = Vec::new();
            for name in [MAGIC, RANGES] {
                bytes.extend(word(u32::from_be_bytes(*name)));
            }
            bytes.extend(word(1));
            bytes.extend(word(u32::from_be_bytes(*LUTS)));
            bytes.extend(word(2));
            bytes.extend([0.5, 100.0, -3.0, 7.0].map(double).as_flattened());
            for table in tables {
                bytes.extend(table.map(|last: u8| [[0; 255].as_slice(), &[last]].concat()).concat());
            }
            let counts = [20, 32, 768, 768];
            let found = channels(&bytes, &counts, big_endian).unwrap();
            assert_eq!(found[1], Channel { color: Some([1, 2, 3]), window: Some((-3.0, 7.0)) });
            assert_eq!((found.len(), found[0].window), (2, Some((0.5, 100.0))));
            assert_eq!(channels(&bytes, &counts, !big_endian), None);
            for length in 0..bytes.len() {
                assert_eq!(channels(&bytes[..length], &counts, big_endian), None);
            }
        }
    }
}
