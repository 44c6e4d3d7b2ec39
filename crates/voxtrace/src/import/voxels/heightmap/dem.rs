//! Digital elevation models of the USGS, `.dem` (Standards for Digital Elevation Models, 1998): blocks of 1,024 characters, a
//! head and then a profile for each column, from south to north.

use super::Heights;
use crate::import::input::Input;
use crate::import::{ImportError, ImportErrorKind, Limits};

const BLOCK: usize = 1024;
/// Heights in the first block of a profile, and in each one after it.
const IN_FIRST: usize = 146;
const IN_NEXT: usize = 170;
/// What stands for a point without a height.
const HOLE: f64 = -32_767.0;

/// Reads a model.
pub(super) fn read(mut input: Input, limits: &Limits) -> Result<Heights, ImportError> {
    let path = input.path();
    let head = Block::take(&mut input, "the head of a model")?;
    let step = [head.number(816, 12)?, head.number(828, 12)?];
    let z_step = head.number(840, 12)?;
    let columns = head.number(858, 6)?;
    let corners = [head.number(546, 24)?, head.number(570, 24)?, head.number(594, 24)?, head.number(618, 24)?];
    let south = corners[1].min(head.number(714, 24)?);
    let north = corners[3].max(head.number(666, 24)?);
    let is_sound = step.iter().all(|step| step.is_finite() && *step > 0.0) && z_step.is_finite() && columns >= 1.0;
    let rows = ((north - south) / step[1]).round() + 1.0;
    if !is_sound || !(1.0..1e6).contains(&rows) || columns >= 1e6 {
        return Err(ImportError::malformed(path, 816, "an impossible size of the model"));
    }
    let (width, depth) = (columns as usize, rows as usize);
    let count = (width * depth) as u64;
    if count > limits.points {
        return Err(ImportError::limit(path, Some(852), "points", count, limits.points));
    }
    if input.remaining().is_some_and(|left| left < (width as u64 - 1) * BLOCK as u64) {
        return Err(ImportError::truncated(path, input.offset(), format!("{width} profiles")));
    }
    let mut values = vec![f32::NAN; width * depth];
    for column in 0..width {
        let block = Block::take(&mut input, "a profile")?;
        let [m, n] = [block.number(12, 6)?, block.number(18, 6)?];
        let start = (block.number(48, 24)? - south) / step[1];
        let datum = block.number(72, 24)?;
        if n != 1.0 || !(0.0..1e6).contains(&m) || !start.is_finite() || !datum.is_finite() {
            return Err(ImportError::malformed(path, block.offset, "an impossible profile"));
        }
        let (m, start) = (m as usize, start.round());
        let mut block = block;
        let (mut first, mut within, mut at) = (0, IN_FIRST, 144);
        for index in 0..m {
            if index == first + within {
                (first, within, at) = (index, IN_NEXT, 0);
                block = Block::take(&mut input, "a profile")?;
            }
            let height = block.number(at + 6 * (index - first), 6)?;
            let row = start + index as f64;
            if height > HOLE && (0.0..depth as f64).contains(&row) {
                // Rows of ours come from the north.
                values[(depth - 1 - row as usize) * width + column] = (datum + height * z_step) as f32;
            }
        }
    }
    // Degrees and seconds of arc are no lengths.
    let is_length = matches!(head.number(528, 6)? as i32, 1 | 2);
    let cell = is_length.then_some(step[0]);
    let notes = if step[0] == step[1] || !is_length {
        Vec::new()
    } else {
        vec![format!("cells of {} by {} are taken for squares", step[0], step[1])]
    };
    Ok(Heights { width, depth, values, cell, map: None, notes })
}

/// A block of characters; the last one of a file may be short.
struct Block<'a> {
    text: Vec<u8>,
    offset: u64,
    path: &'a std::path::Path,
}

impl<'a> Block<'a> {
    fn take(input: &mut Input<'a>, what: &str) -> Result<Self, ImportError> {
        let (path, offset) = (input.path(), input.offset());
        let length = input.peek(BLOCK)?.len();
        if length == 0 {
            return Err(ImportError::truncated(path, offset, what));
        }
        let text = input.take(length, what)?.to_vec();
        Ok(Self { text, offset, path })
    }

    /// The number in `length` characters; Fortran writes exponents with D.
    fn number(&self, at: usize, length: usize) -> Result<f64, ImportError> {
        let offset = self.offset + at as u64;
        let Some(text) = self.text.get(at..at + length) else {
            return Err(ImportError::truncated(self.path, self.offset + self.text.len() as u64, "a block"));
        };
        let text = String::from_utf8_lossy(text).replace(['D', 'd'], "E");
        text.trim().parse().map_err(|_| {
            let kind = ImportErrorKind::Malformed(format!("{text:?} is no number"));
            ImportError::at(self.path, offset, kind)
        })
    }
}
