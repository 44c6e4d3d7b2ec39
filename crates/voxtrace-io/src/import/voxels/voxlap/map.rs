//! `.vxl`: maps, column by column. A column is a list of spans: how many words it has (0: the last one), where the colours of its top begin
//! and end, and where the air above it begins; behind the colours of the top stand those of what is seen from below. Ace of Spades
//! has 512 x 512 columns of 64 and no header. What lies between, which nobody sees, has no colours and is left out.

use super::{File, Model};
use crate::import::grids::checked_size;
use crate::import::reader::Voxels;
use glam::IVec3;
use voxtrace_voxelize::{ImportError, ImportErrorKind, Limits};

/// First bytes of a map with a header.
pub(super) const MAGIC: [u8; 4] = 0x0907_2000u32.to_le_bytes();
/// Bytes of the header: that number, two sizes, and where the player stands and looks.
const HEAD: usize = 12 + 4 * 24;
/// Columns along an edge, and voxels of one, in Ace of Spades.
const EDGE: u64 = 512;
const HEIGHT: i32 = 64;
/// Voxels of a column that a byte can tell.
const HIGHEST: i32 = 256;

pub(super) fn read(file: &File, limits: &Limits) -> Result<Voxels, ImportError> {
    if file.bytes.starts_with(b"Voxel Animation") {
        let what = "a .vxl of Westwood's games, which has only the name in common with Voxlap's";
        return Err(ImportError::at(file.path, 0, ImportErrorKind::Unsupported(what.into())));
    }
    let has_header = file.bytes.starts_with(&MAGIC);
    let [width, depth] = match has_header {
        true => [file.word(4, "the header")?.into(), file.word(8, "the header")?.into()],
        false => [EDGE; 2],
    };
    let start = if has_header { HEAD } else { 0 };
    // Each column has a span of four bytes.
    if file.bytes.len().saturating_sub(start) as u64 / 4 < width.saturating_mul(depth) {
        let what = format!("{width} x {depth} columns");
        return Err(ImportError::truncated(file.path, file.bytes.len() as u64, what));
    }
    let columns = Columns { file, start, width: width as i32, depth: depth as i32 };
    let (mut highest, mut count) = (0, 0u64);
    columns.for_each(&mut |[_, _, z], _| (highest, count) = (highest.max(z), count + 1))?;
    if count > limits.voxels {
        return Err(ImportError::limit(file.path, None, "voxels", count, limits.voxels));
    }
    let height = if highest < HEIGHT { HEIGHT } else { HIGHEST };
    let most = Limits { voxels: u64::MAX, ..*limits };
    let size: IVec3 = checked_size(file.path, 0, [width, depth, height as u64], &most)?;
    let mut model = Model::new(file, size, 1)?;
    columns.for_each(&mut |place, color| model.set(place, color))?;
    Ok(model.finish())
}

struct Columns<'a> {
    file: &'a File<'a>,
    start: usize,
    width: i32,
    depth: i32,
}

impl Columns<'_> {
    /// Hands on each voxel with a colour, row by row.
    fn for_each(&self, each: &mut dyn FnMut([i32; 3], [u8; 3])) -> Result<(), ImportError> {
        let mut at = self.start;
        for (x, y) in (0..self.depth).flat_map(|y| (0..self.width).map(move |x| (x, y))) {
            at = self.column(at, &mut |z, color| each([x, y, z], color))?;
        }
        Ok(())
    }

    /// Hands on the voxels of a column; gives where the next one begins.
    fn column(&self, mut at: usize, each: &mut dyn FnMut(i32, [u8; 3])) -> Result<usize, ImportError> {
        let file = self.file;
        loop {
            let [words, first, last, _] = file.array(at, "a column")?;
            let top = usize::from(last) + 1;
            let Some(top) = top.checked_sub(first.into()) else {
                return Err(file.malformed(at, format!("a span from {first} to {last}")));
            };
            let mut hand_on = |from: i32, at: usize, count: usize| -> Result<(), ImportError> {
                let colors = file.part(at, 4 * count, "a column")?.as_chunks::<4>().0;
                (from..).zip(colors).for_each(|(z, &[blue, green, red, _])| each(z, [red, green, blue]));
                Ok(())
            };
            hand_on(first.into(), at + 4, top)?;
            if words == 0 {
                return Ok(at + 4 + 4 * top);
            }
            let bottom = (usize::from(words) - 1).checked_sub(top);
            let next = at + 4 * usize::from(words);
            let [.., air] = file.array::<4>(next, "a column")?;
            let from = bottom.and_then(|bottom| usize::from(air).checked_sub(bottom));
            let (Some(bottom), Some(from)) = (bottom, from) else {
                return Err(
                    file.malformed(at, format!("a span of {words} words with {top} colours, and air from {air} on"))
                );
            };
            hand_on(from as i32, at + 4 + 4 * top, bottom)?;
            at = next;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    #[test]
    fn columns_have_what_is_seen_from_above_and_from_below() {
        // A bridge from 10 to 14, of which 12 nobody sees, over a floor at 60.
        let color = |shade: u8| [shade, 1, 2, 0x80];
        let bridge = [[5, 10, 11, 0], color(10), color(11), color(13), color(14)];
        let floor = [[0, 60, 60, 15], color(60)];
        let mut bytes = [MAGIC, 1u32.to_le_bytes(), 1u32.to_le_bytes()].concat();
        bytes.resize(HEAD, 0);
        bytes.extend(bridge.iter().chain(&floor).flatten());
        let path = Path::new("a.vxl");
        let voxels = read(&File { bytes: &bytes, path }, &Limits::default()).unwrap();
        let found: Vec<(i32, u16)> = voxels.scene.grids[0].voxels().map(|(at, material)| (at.z, material)).collect();
        let mut found: Vec<i32> = found.into_iter().map(|(z, _)| HEIGHT - 1 - z).collect();
        found.sort_unstable();
        assert_eq!(found, [10, 11, 13, 14, 60]);
        for end in 0..bytes.len() {
            let error = read(&File { bytes: &bytes[..end], path }, &Limits::default()).unwrap_err();
            assert!(error.offset.is_some(), "{end}: {error}");
        }
    }
}
