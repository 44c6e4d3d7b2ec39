//! ESRI ASCII grids, `.asc`: lines of a key and a number, then the heights, row by row from the north.

use super::{DEGREE, Heights, Map};
use crate::import::source::input::{Input, without_mark};
use voxtrace_scene::scene::LengthUnit;
use voxtrace_voxelize::{ImportError, Limits};

/// What stands for no height where the file does not say it.
const HOLE: f64 = -9999.0;
/// Cells smaller than this, in a grid that lies on a globe, are measured in degrees.
const MOST_DEGREES: f64 = 0.2;

#[derive(Default)]
struct Header {
    columns: Option<u64>,
    rows: Option<u64>,
    /// How far points are apart to the east and to the north.
    steps: [Option<f64>; 2],
    corner: [f64; 2],
    has_corner: bool,
    /// Whether it is the middle of a cell.
    is_centre: bool,
    hole: Option<f64>,
}

/// Whether a file begins as a grid does.
pub(super) fn is_grid(head: &[u8]) -> bool {
    let head = without_mark(head);
    let begins = |key: &[u8]| head.get(..key.len()).is_some_and(|head| head.eq_ignore_ascii_case(key));
    let behind = head.get(5).is_some_and(u8::is_ascii_whitespace);
    (begins(b"ncols") || begins(b"nrows")) && behind
}

/// Reads a grid.
pub(super) fn read(mut input: Input, limits: &Limits) -> Result<Heights, ImportError> {
    let path = input.path();
    let mut header = Header::default();
    while without_mark(input.peek(4)?).first().is_some_and(|byte| byte.is_ascii_alphabetic()) {
        let offset = input.offset();
        let line = input.line()?.unwrap_or_default();
        let text = String::from_utf8_lossy(line.get(..line.len().min(200)).unwrap_or_default()).into_owned();
        header.take(&text).ok_or_else(|| ImportError::malformed(path, offset, format!("the line {text:?}")))?;
    }
    let hole = header.hole.unwrap_or(HOLE);
    let offset = input.offset();
    let (Some(columns), Some(rows)) = (header.columns, header.rows) else {
        return Err(ImportError::malformed(path, offset, "a grid without ncols or nrows"));
    };
    let count = columns.saturating_mul(rows);
    if count > limits.points {
        return Err(ImportError::limit(path, Some(offset), "points", count, limits.points));
    }
    // A digit and a space each.
    if count == 0 || input.remaining().is_some_and(|left| left.saturating_add(1) / 2 < count) {
        return Err(ImportError::truncated(path, offset, format!("a grid of {columns} x {rows}")));
    }
    let mut values = Vec::new();
    while (values.len() as u64) < count {
        let offset = input.offset();
        let Some(line) = input.line()? else {
            let what = format!("the heights: {count} are announced, {} are there", values.len());
            return Err(ImportError::truncated(path, offset, what));
        };
        let numbers = line.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty());
        for word in numbers {
            let word = String::from_utf8_lossy(word.get(..word.len().min(40)).unwrap_or_default());
            let value =
                number(&word).ok_or_else(|| ImportError::malformed(path, offset, format!("the height {word:?}")))?;
            values.push(if value == hole { f32::NAN } else { value as f32 });
        }
    }
    if values.len() as u64 > count {
        return Err(ImportError::malformed(path, offset, format!("more than {count} heights")));
    }
    let mut notes = Vec::new();
    let is_global = header.corner[0].abs() <= 360.0 && header.corner[1].abs() <= 90.0;
    let [east, north] = header.steps;
    let steps = east.or(north).zip(north.or(east));
    let side = steps.map(|(east, north)| {
        let side = (east * north).sqrt();
        if (east - north).abs() > 0.01 * side {
            notes.push(format!("cells of {east} by {north} are taken for squares"));
        }
        side
    });
    let cell = side.map(|cell| {
        if cell < MOST_DEGREES && is_global {
            notes.push(format!("cells of {cell} are taken for degrees: {} m", (cell * DEGREE) as f32));
            return cell * DEGREE;
        }
        cell
    });
    let map = steps.filter(|_| header.has_corner).map(|(east, north)| {
        // A centre is that of the cell in the corner.
        let half = if header.is_centre { 0.5 } else { 0.0 };
        let [x, y] = header.corner;
        Map { south_west: [x - half * east, y - half * north], step: [east, north], crs: String::new() }
    });
    let unit = if cell == side { LengthUnit::UNKNOWN } else { LengthUnit::METRE };
    Ok(Heights { width: columns as usize, depth: rows as usize, values, cell, unit, map, notes })
}

/// A number with a decimal point, or a comma as some programs write where that is usual.
fn number(word: &str) -> Option<f64> {
    word.parse().ok().or_else(|| word.replacen(',', ".", 1).parse().ok())
}

impl Header {
    /// Takes a line; `None` where it makes no sense.
    fn take(&mut self, line: &str) -> Option<()> {
        let (key, value) = line.trim().split_once(|c: char| c.is_ascii_whitespace())?;
        let value = value.trim();
        let number = || number(value).filter(|number| number.is_finite());
        let key = key.to_ascii_lowercase();
        match key.as_str() {
            "ncols" => self.columns = Some(value.parse().ok()?),
            "nrows" => self.rows = Some(value.parse().ok()?),
            "cellsize" => self.steps = [Some(number().filter(|&cell| cell > 0.0)?); 2],
            "dx" => self.steps[0] = Some(number().filter(|&cell| cell > 0.0)?),
            "dy" => self.steps[1] = Some(number().filter(|&cell| cell > 0.0)?),
            "xllcorner" | "xllcenter" => self.corner[0] = number()?,
            "yllcorner" | "yllcenter" => {
                self.corner[1] = number()?;
                self.has_corner = true;
                self.is_centre = key.ends_with("center");
            }
            "nodata_value" => self.hole = Some(self::number(value)?),
            _ => return None,
        }
        Some(())
    }
}
