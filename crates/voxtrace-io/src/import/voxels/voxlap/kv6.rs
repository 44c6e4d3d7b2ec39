//! `.kv6`: sizes, the pivot, all voxels (colour, height, which sides are seen, direction), then how many there are in each layer
//! along x and in each column.

use super::{File, Model};
use crate::import::reader::Voxels;
use voxtrace_voxelize::{ImportError, Limits};

/// First bytes of a file.
pub(super) const MAGIC: &[u8] = b"Kvxl";
/// Bytes of the header, and of a voxel.
const HEAD: usize = 32;
const VOXEL: usize = 8;

pub(super) fn read(file: &File, limits: &Limits) -> Result<Voxels, ImportError> {
    if file.part(0, 4, "the header")? != MAGIC {
        return Err(file.malformed(0, "the file does not begin with Kvxl"));
    }
    let size = file.size(4, limits)?;
    let count = file.word(28, "the header")? as usize;
    let voxels = file.part(HEAD, count.saturating_mul(VOXEL), "the voxels")?;
    let (width, depth) = (size.x as usize, size.y as usize);
    // Counts of layers say nothing that those of columns do not.
    let columns_at = HEAD + voxels.len() + 4 * width;
    let counts = file.part(columns_at, 2 * width * depth, "the columns")?;
    let mut model = Model::new(file, size, 0)?;
    let mut left = voxels.as_chunks::<VOXEL>().0;
    for (column, &bytes) in counts.as_chunks().0.iter().enumerate() {
        let at = columns_at + 2 * column;
        let Some((own, others)) = left.split_at_checked(u16::from_le_bytes(bytes).into()) else {
            return Err(file.malformed(at, "columns of more voxels than there are"));
        };
        left = others;
        for &[blue, green, red, _, low, high, ..] in own {
            let z = i32::from(u16::from_le_bytes([low, high]));
            if z >= size.z {
                return Err(file.malformed(at, format!("a voxel at height {z} of {}", size.z)));
            }
            model.set([(column / depth) as i32, (column % depth) as i32, z], [red, green, blue]);
        }
    }
    Ok(model.finish())
}
