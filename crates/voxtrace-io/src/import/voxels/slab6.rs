//! Slab6 `.vox` (Ken Silverman, slab6.txt): three sizes, a byte for each voxel, x slowest and z fastest, then 256 colours of 6 bits. z points
//! down and y to the viewer. Only the extension is that of MagicaVoxel.

use super::paints::Paints;
use super::slab::Slabs;
use super::{Voxels, checked_size};
use crate::import::input::Input;
use crate::import::{ImportError, Limits};
use glam::IVec3;
use voxtrace_scene::scene::Scene;

/// The byte of a place without a voxel.
const EMPTY: u8 = 255;
/// Bytes of the sizes, and of the colours.
const HEAD: usize = 12;
const COLORS: usize = 768;

/// Whether the length is that of a Slab6 file.
pub(in crate::import) fn is_slab6(bytes: &[u8]) -> bool {
    let Some((sizes, _)) = bytes.split_first_chunk::<HEAD>() else { return false };
    let places = sizes.as_chunks::<4>().0.iter().map(|edge| u128::from(u32::from_le_bytes(*edge))).product::<u128>();
    places + (HEAD + COLORS) as u128 == bytes.len() as u128
}

/// Reads a Slab6 file.
pub(super) fn read(input: Input, limits: &Limits) -> Result<Voxels, ImportError> {
    let path = input.path();
    let bytes = input.rest()?;
    if !is_slab6(&bytes) {
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

fn from_six_bits(value: u8) -> u8 {
    let value = value & 63;
    value << 2 | value >> 4
}
