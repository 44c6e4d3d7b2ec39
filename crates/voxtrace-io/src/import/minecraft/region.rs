//! A file of 32 × 32 chunks of a world, `r.X.Z.mca`: a table of places, then the chunks, each compressed by itself. A chunk that is damaged
//! does not lose the others.

use super::build::is_damage;
use super::chunk::{Section, sections};
use super::lz4;
use super::nbt::{self, Compound};
use super::places::{self, BLOCKS, Places};
use super::voxels::Blocks;
use crate::import::reader::ImportOptions;
use crate::import::source::folder::Folder;
use crate::import::source::inflate::{gunzip, unzlib};
use crate::import::source::input::Input;
use glam::{IVec2, IVec3};
use rayon::prelude::*;
use std::path::Path;
use voxtrace_scene::grid::VoxelGrid;
use voxtrace_voxelize::{ImportError, ImportErrorKind, Limits};

/// Bytes of a sector, the unit of places in the file.
const SECTOR: usize = 4096;
/// Chunks along an edge of a region.
const CHUNKS: usize = 32;
/// Chunks that are in memory at once.
const AT_ONCE: usize = 32;
/// Reads the region `at` so that the region `origin` lies at the origin. Both are (x, z) in regions.
pub(super) fn read(
    input: Input,
    folder: &Folder,
    options: &ImportOptions,
    at: IVec2,
    origin: IVec2,
    kinds: &mut Blocks,
) -> Result<VoxelGrid, ImportError> {
    let (path, limits) = (input.path(), &options.limits);
    let bytes = input.rest()?;
    if bytes.is_empty() {
        // The game makes such files for regions that nobody has been to.
        return Ok(VoxelGrid::new());
    }
    if bytes.len() < 2 * SECTOR {
        return Err(ImportError::truncated(path, bytes.len() as u64, "the table of chunks"));
    }
    let starts: Vec<(usize, usize)> = (0..CHUNKS * CHUNKS)
        .filter_map(|index| {
            let [a, b, c, count] = std::array::from_fn(|n| bytes[4 * index + n]);
            let sector = u32::from_be_bytes([0, a, b, c]) as usize;
            (count != 0).then_some((index, sector * SECTOR))
        })
        .collect();
    let (mut places, mut count, mut faults) = (Places::default(), 0, Vec::new());
    for group in starts.chunks(AT_ONCE) {
        let read = |&(index, start): &(usize, usize)| {
            let chunk = IVec2::new((index % CHUNKS) as i32, (index / CHUNKS) as i32);
            let tags = chunk_tags(path, &bytes, start, folder, limits, at * CHUNKS as i32 + chunk)?;
            let entities = tags.as_ref().map_or(0, Compound::entities);
            tags.map_or(Ok(Vec::new()), |tags| sections(path, start as u64, &tags))
                .map(|sections| ((at - origin) * CHUNKS as i32 + chunk, sections, entities))
        };
        for chunk in group.par_iter().map(read).collect::<Vec<_>>() {
            match chunk {
                Ok((chunk, sections, entities)) => {
                    kinds.entities += entities;
                    count += sections.into_iter().map(|section| put(section, chunk, kinds, &mut places)).sum::<u64>()
                }
                Err(error) if is_damage(&error) && !options.strict => faults.push(error),
                Err(error) => return Err(error),
            }
        }
        if count > limits.voxels {
            return Err(ImportError::limit(path, Some(0), "places of voxels", count, limits.voxels));
        }
    }
    let (left_out, all) = (faults.len(), starts.len());
    if let Some(fault) = faults.into_iter().next() {
        if left_out == all {
            return Err(fault);
        }
        kinds.notes.push(format!("{left_out} of the {all} chunks of the region are left out: {fault}"));
    }
    kinds.grid(places, path, limits)
}

/// Puts a section of a chunk in its place, and counts its blocks, seen or not.
fn put(section: Section, chunk: IVec2, kinds: &mut Blocks, places: &mut Places) -> u64 {
    let numbers: Vec<u16> = section.states.into_iter().map(|state| kinds.number(state)).collect();
    if numbers.iter().all(|&number| number == 0) {
        return 0;
    }
    let mut of = Box::new([0; BLOCKS]);
    for (place, number) in of.iter_mut().enumerate() {
        let at = places::local(place);
        // South is −y.
        let (x, y, z) = (at.x as usize, at.z as usize, 15 - at.y as usize);
        let state = section.blocks.get((y * 16 + z) * 16 + x).copied().unwrap_or(0);
        *number = numbers.get(usize::from(state)).copied().unwrap_or(0);
    }
    places.sections.insert(IVec3::new(chunk.x, -1 - chunk.y, section.height), of);
    BLOCKS as u64
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
