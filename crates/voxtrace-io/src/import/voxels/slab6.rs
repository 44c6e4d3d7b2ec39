//! Slab6 `.vox` (Ken Silverman, slab6.txt): three sizes, a byte for each voxel, x slowest and z fastest, then 256 colours of 6 bits. z points
//! down and y to the viewer. Only the extension is that of MagicaVoxel.

use crate::import::grids::checked_size;
use crate::import::grids::paints::Paints;
use crate::import::grids::slab::Slabs;
use crate::import::reader::Voxels;
use crate::import::reader::{FileClues, Kind, Reader, Recognition};
use crate::import::source::input::Input;
use crate::import::vox::slab6::{COLORS, HEAD, from_six_bits, is_slab6};
use glam::IVec3;
use voxtrace_scene::scene::Scene;
use voxtrace_voxelize::mesh::UpAxis;
use voxtrace_voxelize::{ImportError, Limits};

/// What the table of readers has of this format.
pub(crate) const READER: Reader = Reader::new(
    "Slab6",
    Kind::Voxels,
    &["vox"],
    "voxels of Slab6, told by the length of the file",
    |source, options| {
        let (input, _) = source.into_input()?;
        Ok(read(input, &options.limits)?.into())
    },
)
.with_up_axis(Some(UpAxis::Y))
.with_recognition(recognize);

/// The byte of a place without a voxel.
const EMPTY: u8 = 255;

/// MagicaVoxel has the same extension.
fn recognize(clues: &FileClues) -> Recognition {
    let has_length = clues.length.is_some_and(|length| is_slab6(clues.head, length));
    if has_length && READER.extension_of(clues.path).is_some() { Recognition::Sure } else { Recognition::Unknown }
}

/// Reads a Slab6 file.
fn read(input: Input, limits: &Limits) -> Result<Voxels, ImportError> {
    let path = input.path();
    let bytes = input.rest()?;
    if !is_slab6(&bytes, bytes.len() as u64) {
        return Err(ImportError::malformed(path, 0, "sizes that do not fit the length of the file"));
    }
    let (head, rest) = bytes.split_at(HEAD);
    let (voxels, colors) = rest.split_at(rest.len() - COLORS);
    let mut sizes = head.as_chunks().0.iter().map(|edge| u64::from(u32::from_le_bytes(*edge)));
    let mut edge = || sizes.next().unwrap_or(0);
    let size = checked_size(path, 0, [edge(), edge(), edge()], limits)?;
    let mut paints = Paints::default();
    let mut slabs = Slabs::new(path, 0, size, 0)?;
    for (place, &index) in voxels.iter().enumerate().filter(|&(_, &index)| index != EMPTY) {
        let (height, depth) = (size.z as usize, size.y as usize);
        let (x, y, z) = (place / (height * depth), place / height % depth, place % height);
        let color = &colors[3 * usize::from(index)..];
        let material = paints.material([0, 1, 2].map(|channel| from_six_bits(color[channel])));
        slabs.set(IVec3::new(x as i32, size.y - 1 - y as i32, size.z - 1 - z as i32), material);
    }
    Ok(Voxels { scene: Scene::from_grid("", slabs.finish(), paints.finish()), notes: Vec::new() })
}
