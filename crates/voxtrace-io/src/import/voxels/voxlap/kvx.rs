//! `.kvx`: up to five models of falling resolution, of which the first is read, and a palette of 256 colours of 6 bits behind them. A model
//! is its sizes, where the columns begin, and their slabs: runs of voxels.

use super::{File, Model};
use crate::import::reader::Voxels;
use crate::import::vox::slab6::{COLORS, from_six_bits};
use voxtrace_voxelize::{ImportError, Limits};

/// Most models of a file.
const MODELS: usize = 5;
/// Where the places of the columns begin.
const OFFSETS: usize = 28;

pub(super) fn read(file: &File, limits: &Limits) -> Result<Voxels, ImportError> {
    let length = file.word(0, "the header")? as usize;
    let model_bytes = file.part(4, length, "the voxels")?;
    let size = file.size(4, limits)?;
    // Further models may stand before the palette.
    let mut at = 4 + length;
    for _ in 1..MODELS {
        if file.bytes.len() - at > COLORS {
            let length = file.word(at, "a further model")? as usize;
            at += 4 + file.part(at + 4, length, "a further model")?.len();
        }
    }
    let colors = file.part(at, COLORS, "the palette")?;
    if file.bytes.len() - at > COLORS {
        return Err(file.malformed(at, "a palette that is not the end"));
    }
    let (width, depth) = (size.x as usize, size.y as usize);
    // The places are from the first of them on.
    let columns = OFFSETS + 4 * (width + 1);
    let place = |x: usize, y: usize| -> Result<usize, ImportError> {
        let start = file.word(OFFSETS + 4 * x, "the columns")? as usize;
        let column = u16::from_le_bytes(file.array(columns + 2 * (x * (depth + 1) + y), "the columns")?);
        Ok(OFFSETS.saturating_add(start).saturating_add(column.into()))
    };
    let mut model = Model::new(file, size, 0)?;
    for (x, y) in (0..width).flat_map(|x| (0..depth).map(move |y| (x, y))) {
        let (mut at, end) = (place(x, y)?, place(x, y + 1)?);
        if end > 4 + model_bytes.len() {
            return Err(file.malformed(columns + 2 * (x * (depth + 1) + y), "a column beyond the voxels"));
        }
        while at < end {
            let [top, count, _] = file.array(at, "a slab")?;
            let slab = file.part(at + 3, count.into(), "a slab")?;
            if i32::from(top) + i32::from(count) > size.z {
                return Err(
                    file.malformed(at, format!("a slab from {top} on, of {count} voxels, in a height of {}", size.z))
                );
            }
            for (z, &index) in (i32::from(top)..).zip(slab) {
                let color = [0, 1, 2].map(|channel| from_six_bits(colors[3 * usize::from(index) + channel]));
                model.set([x as i32, y as i32, z], color);
            }
            at += 3 + slab.len();
        }
    }
    Ok(model.finish())
}
