//! What readers of builds share: unpacking, tags, boxes of blocks, and what is put up with.

use super::looks::Looks;
use super::nbt::{Compound, Order, read_in};
use super::pack::Pack;
use super::places::Places;
use super::voxels::{Blocks, Fineness};
use crate::import::grids::checked_size;
use crate::import::reader::ImportOptions;
use crate::import::source::inflate::GZIP;
use crate::import::source::input::{Input, beyond};
use flate2::bufread::{GzDecoder, MultiGzDecoder, ZlibDecoder};
use std::io::Read;
use std::path::Path;
use voxtrace_scene::grid::MAX_COORDINATE;
use voxtrace_scene::scene::Scene;
use voxtrace_scene::transform::Transform;
use voxtrace_voxelize::{ImportError, ImportErrorKind, Limits};

/// Where faults are, and what is allowed.
pub(super) struct Build<'a> {
    pub path: &'a Path,
    /// The byte of the uncompressed tags where they end.
    pub offset: u64,
    pub limits: &'a Limits,
}

/// Blocks that are to be voxels as the options say.
pub(super) fn blocks(options: &ImportOptions) -> Result<Blocks, ImportError> {
    let asked = &options.blocks;
    let pack = asked.resource_pack.as_ref().map(|path| Pack::open(path, &options.limits)).transpose()?;
    let fineness = Fineness { edge: asked.size.edge(), shell: asked.shell };
    Ok(Blocks::new(fineness, Looks { pack, ..Looks::default() }))
}

/// What a note or an error says of damage: the former where all is read that is whole.
pub(super) fn damage(
    options: &ImportOptions,
    blocks: &mut Blocks,
    note: impl FnOnce() -> String,
    error: ImportError,
) -> Result<(), ImportError> {
    if options.strict {
        return Err(error);
    }
    blocks.notes.push(note());
    Ok(())
}

/// Whether a fault is of the bytes, and not of what is allowed, or of the system.
pub(super) fn is_damage(error: &ImportError) -> bool {
    matches!(
        error.kind,
        ImportErrorKind::Malformed(_) | ImportErrorKind::Truncated(_) | ImportErrorKind::Unsupported(_)
    )
}

/// The tags of a file, gzip, zlib or as they are, with the byte where they end, and how many bytes stand behind all.
pub(super) fn tags(input: Input, limits: &Limits) -> Result<(Compound, u64, u64), ImportError> {
    let path = input.path();
    let bytes = input.rest()?;
    let mut left = &bytes[..];
    let (tags, offset, unread) = if bytes.starts_with(&GZIP) {
        match unpacked(path, &mut |rest| Box::new(GzDecoder::new(rest)), &mut left, limits) {
            // Several streams in a row are one.
            Err(_) if left.starts_with(&GZIP) => {
                left = &bytes;
                unpacked(path, &mut |rest| Box::new(MultiGzDecoder::new(rest)), &mut left, limits)?
            }
            other => other?,
        }
    } else if bytes.first() == Some(&0x78) {
        unpacked(path, &mut |rest| Box::new(ZlibDecoder::new(rest)), &mut left, limits)?
    } else {
        let read = unpacked(path, &mut |rest| Box::new(rest), &mut left, limits)?;
        left = &[];
        read
    };
    Ok((tags, offset, unread + left.len() as u64))
}

/// A decoder over what is left of a file.
type Decoder<'d, 'b> = dyn FnMut(&'d mut &'b [u8]) -> Box<dyn Read + 'd>;

fn unpacked<'d, 'b>(
    path: &'d Path,
    decoder: &mut Decoder<'d, 'b>,
    left: &'d mut &'b [u8],
    limits: &Limits,
) -> Result<(Compound, u64, u64), ImportError> {
    let mut input = Input::of_decoder(decoder(left), path, limits);
    // Both orders begin with a compound; the length of the first name, which is short, tells which it is.
    let order = match input.peek(6)? {
        [10, 0, 0, _, low, 0] if *low != 0 => Order::Little,
        _ => Order::Big,
    };
    let tags = read_in(order, &mut input, limits)?;
    let offset = input.offset();
    // What comes after the tags is only looked at so that a cut-off file is told.
    let unread = input.rest()?.len() as u64;
    Ok((tags, offset, unread))
}

impl Build<'_> {
    pub fn malformed(&self, what: impl Into<String>) -> ImportError {
        ImportError::malformed(self.path, self.offset, what)
    }

    pub fn unsupported(&self, what: &str) -> ImportError {
        ImportError::at(self.path, self.offset, ImportErrorKind::Unsupported(what.into()))
    }

    /// Width, height and length of a schematic, whose sizes are 16 bits without a sign.
    pub fn size(&self, tags: &Compound) -> Result<[usize; 3], ImportError> {
        let mut size = [0; 3];
        for (edge, name) in size.iter_mut().zip(["Width", "Height", "Length"]) {
            let value = tags.whole(name).ok_or_else(|| self.malformed(format!("a schematic without {name}")))?;
            *edge = u64::from(value as u16);
        }
        self.checked(size)
    }

    /// A size within the limits.
    pub fn checked(&self, size: [u64; 3]) -> Result<[usize; 3], ImportError> {
        checked_size(self.path, self.offset, size, self.limits)?;
        Ok(size.map(|edge| edge as usize))
    }

    /// Adds a box of blocks by their numbers: `state_at` gets the index of a place, x fastest, then z, then y.
    pub fn add(
        &self,
        blocks: &mut Blocks,
        scene: &mut Scene,
        size: [usize; 3],
        state_at: impl Fn(usize) -> u16 + Sync,
    ) -> Result<usize, ImportError> {
        let edge = size.into_iter().max().unwrap_or(0) as u64 * blocks.edge() as u64;
        if edge > MAX_COORDINATE as u64 {
            let most = MAX_COORDINATE as u64;
            return Err(beyond(self.path, Some(self.offset), "voxels along an edge", edge, most));
        }
        let grid = blocks.grid(Places::of_box(size, state_at), self.path, self.limits)?;
        Ok(scene.add_instance(grid, Transform::IDENTITY))
    }
}
