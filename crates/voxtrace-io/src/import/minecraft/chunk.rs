//! A chunk of a world: sections of 16³ blocks, since 1.13 by palettes, before by numbers, before 1.2 a column of all heights.

use super::legacy_states;
use super::nbt::{Compound, Tag};
use super::packed::{Packed, bits_of};
use super::places::BLOCKS;
use super::state::State;
use std::path::Path;
use voxtrace_voxelize::ImportError;

/// Most sections of a chunk: as many as a byte has heights.
const SECTIONS: usize = 256;
/// Most states in the palettes of a chunk.
const STATES: usize = 1 << 16;
/// Blocks from the floor of a world to its top before 1.2.
const COLUMN: usize = 128;

/// A section as the file has it.
pub(super) struct Section {
    /// In sections above the world's zero.
    pub height: i32,
    pub states: Vec<State>,
    /// For each block, y, then z, then x, the index of its state; nothing where there is but one.
    pub blocks: Vec<u16>,
}

/// The sections of a chunk, whose bytes begin at `offset`.
pub(super) fn sections(path: &Path, offset: u64, tags: &Compound) -> Result<Vec<Section>, ImportError> {
    // Since 1.18 the sections are at the root and in small letters.
    let level = tags.compound("Level").unwrap_or(tags);
    if let Some(numbers) = level.bytes("Blocks") {
        return column(level, numbers)
            .ok_or_else(|| ImportError::malformed(path, offset, "a chunk with too few blocks"));
    }
    let list = level.list("sections").or_else(|| level.list("Sections")).unwrap_or_default();
    let malformed = |what: &str| ImportError::malformed(path, offset, what);
    if list.len() > SECTIONS {
        return Err(ImportError::limit(path, Some(offset), "sections of a chunk", list.len() as u64, SECTIONS as u64));
    }
    let (mut found, mut state_count) = (Vec::new(), 0);
    for tag in list {
        let Tag::Compound(section) = tag else { continue };
        let height = section.whole("Y").and_then(|y| i8::try_from(y).ok());
        let height = height.ok_or_else(|| malformed("a section without a height"))?;
        let height = i32::from(height);
        let packed = match section.compound("block_states") {
            Some(tags) => tags.list("palette").map(|palette| (palette, tags.longs("data"))),
            None => section.list("Palette").map(|palette| (palette, section.longs("BlockStates"))),
        };
        if let Some((palette, words)) = packed {
            state_count += palette.len();
            if state_count > STATES {
                return Err(ImportError::limit(
                    path,
                    Some(offset),
                    "states of a chunk",
                    state_count as u64,
                    STATES as u64,
                ));
            }
            let states = State::of_list(palette);
            let blocks = match words {
                None if states.len() == 1 => Vec::new(),
                None => return Err(malformed("a section without its blocks")),
                Some(words) => {
                    let packed = Packed::of_section(words, BLOCKS, bits_of(states.len(), 4));
                    let packed = packed.ok_or_else(|| malformed("a section with a wrong number of blocks"))?;
                    let blocks: Vec<u16> = (0..BLOCKS).map(|place| packed.get(place) as u16).collect();
                    if blocks.iter().any(|&block| usize::from(block) >= states.len()) {
                        return Err(malformed("a block that is not in its section's palette"));
                    }
                    blocks
                }
            };
            found.push(Section { height, states, blocks });
        } else if let Some(numbers) = section.bytes("Blocks") {
            found.push(numbered(section, height, numbers).ok_or_else(|| malformed("a section with too few blocks"))?);
        }
    }
    Ok(found)
}

/// A section from before 1.13.
fn numbered(section: &Compound, height: i32, numbers: &[u8]) -> Option<Section> {
    let numbers = numbers.get(..BLOCKS)?;
    let (data, more) = (section.bytes("Data"), section.bytes("Add"));
    let key = |place: usize| half(more, place) << 12 | u16::from(numbers[place]) << 4 | half(data, place);
    Some(of_keys(height, (0..BLOCKS).map(key).collect()))
}

/// Four bits for each place; the even one has the low half of a byte.
fn half(bytes: Option<&[u8]>, place: usize) -> u16 {
    u16::from(bytes.and_then(|bytes| bytes.get(place / 2)).map_or(0, |byte| byte >> (place % 2 * 4) & 15))
}

/// A chunk from before 1.2 (`.mcr`): one array of all heights, y fastest, then z, then x.
fn column(level: &Compound, numbers: &[u8]) -> Option<Vec<Section>> {
    let numbers = numbers.get(..COLUMN * 256)?;
    let data = level.bytes("Data");
    let section = |height: usize| {
        let key = |place: usize| {
            let (x, z, y) = (place % 16, place / 16 % 16, height * 16 + place / 256);
            let at = (x * 16 + z) * COLUMN + y;
            u16::from(numbers[at]) << 4 | half(data, at)
        };
        of_keys(height as i32, (0..BLOCKS).map(key).collect())
    };
    Some((0..COLUMN / 16).map(section).collect())
}

/// A section of numbers of blocks with four bits of data behind them.
fn of_keys(height: i32, keys: Vec<u16>) -> Section {
    let mut distinct = keys.clone();
    distinct.sort_unstable();
    distinct.dedup();
    let state = |key: &u16| match u8::try_from(key >> 4) {
        Ok(id) => legacy_states::state(id, *key as u8 & 15),
        Err(_) => State::new(format!("number_{}", key >> 4)),
    };
    let blocks = keys.iter().map(|key| distinct.binary_search(key).unwrap_or(0) as u16).collect();
    Section { height, states: distinct.iter().map(state).collect(), blocks }
}
