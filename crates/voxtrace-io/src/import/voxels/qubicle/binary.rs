//! Qubicle Binary, `.qb` (specification by Minddesk): several matrices of colours, plain or as runs. The header says
//! where z points: to the viewer where it says 0, away from him where it says 1. The specification calls these left- and
//! right-handed, but figures whose left and right limbs have names, and letters, come out mirrored if it is taken at its word.

use super::{Matrix, Model, number, numbers};
use crate::import::source::input::Input;
use voxtrace_voxelize::ImportError;

/// Marks a run in compressed data.
const RUN: u32 = 2;
/// Ends a layer in compressed data.
const NEXT_LAYER: u32 = 6;
/// Bytes that a matrix takes at least.
const SMALLEST: u64 = 25;

struct Header {
    is_bgra: bool,
    /// Whether z points away from the viewer.
    is_away: bool,
    is_compressed: bool,
}

/// Reads a Qubicle Binary file.
pub(super) fn read(input: &mut Input, model: &mut Model) -> Result<(), ImportError> {
    let path = input.path();
    number(input)?;
    let mut flags = [false; 4];
    for (flag, what) in flags.iter_mut().zip(["colour format", "orientation", "compression", "mask"]) {
        let offset = input.offset();
        *flag = match number(input)? {
            0 => false,
            1 => true,
            other => {
                return Err(ImportError::malformed(
                    path,
                    offset,
                    format!("the {what} {other}, which is neither 0 nor 1"),
                ));
            }
        };
    }
    let header = Header { is_bgra: flags[0], is_away: flags[1], is_compressed: flags[2] };
    let count = u64::from(number(input)?);
    let least = count * SMALLEST;
    if input.remaining().is_some_and(|remaining| remaining < least) {
        return Err(ImportError::truncated(path, input.offset(), format!("{count} matrices")));
    }
    if count > model.limits.items {
        return Err(ImportError::limit(path, Some(20), "matrices", count, model.limits.items));
    }
    for _ in 0..count {
        matrix(input, &header, model)?;
    }
    Ok(())
}

fn matrix(input: &mut Input, header: &Header, model: &mut Model) -> Result<(), ImportError> {
    let path = input.path();
    let length = usize::from(input.take(1, "a name")?[0]);
    let name = String::from_utf8_lossy(input.take(length, "a name")?).into_owned();
    let offset = input.offset();
    let size @ [width, height, depth] = numbers(input)?;
    let position = numbers(input)?.map(|value: u32| value as i32);
    let matrix = Matrix { name, size, position, is_away: header.is_away };
    let mut slabs = model.slabs(&matrix, offset, 1)?;
    let mut set = |place: u64, z: u32, color: u32| {
        let [first, green, third, mask] = color.to_le_bytes();
        if mask == 0 {
            return;
        }
        let rgb = if header.is_bgra { [third, green, first] } else { [first, green, third] };
        let (x, up) = (place % u64::from(width), place / u64::from(width));
        slabs.set(matrix.place(x as u32, up as u32, z), model.paints.material(rgb));
    };
    let layer = u64::from(width) * u64::from(height);
    for z in 0..depth {
        if !header.is_compressed {
            for place in 0..layer {
                set(place, z, number(input)?);
            }
            continue;
        }
        let mut place = 0;
        loop {
            let offset = input.offset();
            let (count, color) = match number(input)? {
                NEXT_LAYER => break,
                RUN => (u64::from(number(input)?), number(input)?),
                color => (1, color),
            };
            if place + count > layer {
                let what = format!("a layer with more than its {layer} voxels");
                return Err(ImportError::malformed(path, offset, what));
            }
            (place..place + count).for_each(|place| set(place, z, color));
            place += count;
        }
    }
    let grid = slabs.finish();
    model.add(matrix, grid);
    Ok(())
}
