//! A file of 32 × 32 chunks of a world, `r.X.Z.mca`: a table of places, then the chunks, each compressed by itself, each with
//! sections of 16³ blocks (1.13 and later by palettes, before by numbers).

use super::nbt::{self, Compound, Tag};
use super::packed::{Packed, bits_of};
use super::palette::{Palette, State, states};
use super::{legacy, lz4};
use crate::import::grids::dense;
use crate::import::source::folder::Folder;
use crate::import::source::inflate::{gunzip, unzlib};
use crate::import::source::input::Input;
use glam::{IVec2, IVec3};
use rayon::prelude::*;
use std::path::Path;
use voxtrace_scene::brick::{BRICK_SIZE, Brick};
use voxtrace_scene::grid::VoxelGrid;
use voxtrace_voxelize::{ImportError, ImportErrorKind, Limits};

/// Bytes of a sector, the unit of places in the file.
const SECTOR: usize = 4096;
/// Chunks along an edge of a region.
const CHUNKS: usize = 32;
/// Blocks in a section.
const BLOCKS: usize = 4096;
/// Chunks that are in memory at once.
const AT_ONCE: usize = 32;
/// Most sections of a chunk: as many as a byte has heights.
const SECTIONS: usize = 256;
/// Most states in the palettes of a chunk.
const STATES: usize = 1 << 16;

/// A section as the file has it.
struct Section {
    /// Bricks from the world's origin in ours: the lowest of two along each axis.
    brick: IVec3,
    states: Vec<State>,
    /// For each block, y, then z, then x, the index of its state; nothing where there is but one.
    blocks: Vec<u16>,
}

/// Reads the region `at` so that the region `origin` lies at the origin. Both are (x, z) in regions.
pub(super) fn read(
    input: Input,
    folder: &Folder,
    limits: &Limits,
    at: IVec2,
    origin: IVec2,
    palette: &mut Palette,
) -> Result<VoxelGrid, ImportError> {
    let path = input.path();
    let bytes = input.rest()?;
    if bytes.is_empty() {
        // The game makes such files for regions that nobody has been to.
        return Ok(VoxelGrid::new());
    }
    if bytes.len() < 2 * SECTOR {
        return Err(ImportError::truncated(path, bytes.len() as u64, "the table of chunks"));
    }
    let places: Vec<(usize, usize)> = (0..CHUNKS * CHUNKS)
        .filter_map(|index| {
            let [a, b, c, count] = std::array::from_fn(|n| bytes[4 * index + n]);
            let sector = u32::from_be_bytes([0, a, b, c]) as usize;
            (count != 0).then_some((index, sector * SECTOR))
        })
        .collect();
    let (mut found, mut count) = (Vec::new(), 0);
    for places in places.chunks(AT_ONCE) {
        let read = |&(index, start): &(usize, usize)| {
            let chunk = IVec2::new((index % CHUNKS) as i32, (index / CHUNKS) as i32);
            let Some(tags) = chunk_tags(path, &bytes, start, folder, limits, at * CHUNKS as i32 + chunk)? else {
                return Ok((Vec::new(), 0));
            };
            let entities = tags.entities();
            Ok((sections(path, start as u64, &tags, (at - origin) * CHUNKS as i32 + chunk)?, entities))
        };
        let chunks: Vec<(Vec<Section>, u64)> = places.par_iter().map(read).collect::<Result<_, _>>()?;
        let mut with_materials = Vec::new();
        palette.entities += chunks.iter().map(|(_, entities)| entities).sum::<u64>();
        for mut section in chunks.into_iter().flat_map(|(sections, _)| sections) {
            let states = std::mem::take(&mut section.states);
            let materials: Vec<_> = states.into_iter().map(|state| palette.material(state)).collect();
            if materials.iter().any(Option::is_some) {
                with_materials.push((section, materials));
            }
        }
        count += (with_materials.len() * BLOCKS) as u64;
        if count > limits.voxels {
            return Err(ImportError::limit(path, Some(0), "places of voxels", count, limits.voxels));
        }
        let bricks = with_materials.par_iter().flat_map_iter(|(section, materials)| bricks(section, materials));
        found.extend(bricks.collect::<Vec<(IVec3, Brick)>>());
    }
    Ok(VoxelGrid::from_bricks(found))
}

/// The eight bricks of a section.
fn bricks<'a>(section: &'a Section, materials: &'a [Option<u16>]) -> impl Iterator<Item = (IVec3, Brick)> + 'a {
    (0..8).map(move |part| {
        let corner = IVec3::new(part & 1, part >> 1 & 1, part >> 2);
        let material = |local: IVec3| {
            let voxel = corner * BRICK_SIZE + local;
            // South is −y.
            let (x, y, z) = (voxel.x as usize, voxel.z as usize, 15 - voxel.y as usize);
            let state = section.blocks.get((y * 16 + z) * 16 + x).copied().unwrap_or(0);
            materials[usize::from(state)]
        };
        (section.brick + corner, dense::brick(material))
    })
}

/// The tags of a chunk; `None` where the file knows of it, but nothing is there.
fn chunk_tags(
    path: &Path,
    bytes: &[u8],
    start: usize,
    folder: &Folder,
    limits: &Limits,
    chunk: IVec2,
) -> Result<Option<Compound>, ImportError> {
    let offset = start.min(bytes.len()) as u64;
    let head = bytes.get(start..).and_then(|rest| rest.split_first_chunk::<5>());
    let Some((&[a, b, c, d, kind], rest)) = head else {
        return Err(ImportError::truncated(path, bytes.len() as u64, "a chunk"));
    };
    let length = u32::from_be_bytes([a, b, c, d]) as usize;
    let Some(length) = length.checked_sub(1) else { return Ok(None) };
    let outside;
    let data = if kind & 0x80 != 0 {
        // Too long for the file: it lies in one of its own.
        let name = format!("c.{}.{}.mcc", chunk.x, chunk.y);
        outside = folder.read(&name).map_err(|refused| ImportError::malformed(path, offset, refused.to_string()))?;
        &outside[..]
    } else {
        rest.get(..length).ok_or_else(|| ImportError::truncated(path, bytes.len() as u64, "a chunk"))?
    };
    let input = Input::of_bytes(data, path, limits)?;
    let unpacked;
    let mut input = match kind & 0x7f {
        1 => gunzip(input, limits),
        2 => unzlib(input, limits),
        3 => input,
        4 => {
            unpacked = lz4::unpacked(data, limits).map_err(|what| ImportError::malformed(path, offset, what))?;
            Input::of_bytes(&unpacked, path, limits)?
        }
        kind => {
            let kind = ImportErrorKind::Unsupported(format!("a chunk with compression {kind}"));
            return Err(ImportError::at(path, offset, kind));
        }
    };
    nbt::read(&mut input, limits).map(Some).map_err(|error| error.with_offset(Some(offset)))
}

fn sections(path: &Path, offset: u64, tags: &Compound, chunk: IVec2) -> Result<Vec<Section>, ImportError> {
    // Since 1.18 the sections are at the root and in small letters.
    let level = tags.compound("Level").unwrap_or(tags);
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
        let brick = IVec3::new(chunk.x, -1 - chunk.y, height.into()) * 2;
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
            let states = states(palette);
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
            found.push(Section { brick, states, blocks });
        } else if let Some(numbers) = section.bytes("Blocks") {
            found.push(numbered(section, brick, numbers).ok_or_else(|| malformed("a section with too few blocks"))?);
        }
    }
    Ok(found)
}

/// A section from before 1.13.
fn numbered(section: &Compound, brick: IVec3, numbers: &[u8]) -> Option<Section> {
    let numbers = numbers.get(..BLOCKS)?;
    let half = |bytes: Option<&[u8]>, place: usize| {
        u16::from(bytes.and_then(|bytes| bytes.get(place / 2)).map_or(0, |byte| byte >> (place % 2 * 4) & 15))
    };
    let (data, more) = (section.bytes("Data"), section.bytes("Add"));
    let keys: Vec<u16> =
        (0..BLOCKS).map(|place| half(more, place) << 12 | u16::from(numbers[place]) << 4 | half(data, place)).collect();
    let mut distinct = keys.clone();
    distinct.sort_unstable();
    distinct.dedup();
    let state = |key: &u16| match u8::try_from(key >> 4) {
        Ok(id) => legacy::name(id, *key as u8 & 15),
        Err(_) => (format!("number_{}", key >> 4), false),
    };
    let blocks = keys.iter().map(|key| distinct.binary_search(key).unwrap_or(0) as u16).collect();
    Some(Section { brick, states: distinct.iter().map(state).collect(), blocks })
}
