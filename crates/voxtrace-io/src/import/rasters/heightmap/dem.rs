//! Digital elevation models of the USGS, `.dem` (Standards for Digital Elevation Models, 1998): blocks of 1,024 characters, a
//! head and then a profile for each column, from south to north.

use super::map::Map;
use super::{DEGREE, Heights};
use crate::import::source::input::Input;
use voxtrace_scene::scene::LengthUnit;
use voxtrace_voxelize::{ImportError, ImportErrorKind, Limits};

const BLOCK: usize = 1024;
/// Heights in the first block of a profile, and in each one after it.
const IN_FIRST: usize = 146;
const IN_NEXT: usize = 170;
/// What stands for a point without a height.
const HOLE: f64 = -32_767.0;
/// Metres of a foot.
const FOOT: f64 = 0.3048;

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
    let map = Reference::of(&head);
    let mut notes = Vec::new();
    // Heights are metres where the map's lengths are told.
    let z_unit = if map.length.is_some() && head.code(534) == Some(1) { FOOT } else { 1.0 };
    let mut corner = None;
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
        if corner.is_none() {
            // The place of the lowest row, which need not be a whole number of steps from the corners.
            corner = Some([block.number(24, 24)?, block.number(48, 24)? - start * step[1]]);
        }
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
                values[(depth - 1 - row as usize) * width + column] = ((datum + height * z_step) * z_unit) as f32;
            }
        }
    }
    let cell = map.length.map(|length| step[0] * length);
    if let Some(cell) = cell.filter(|_| map.is_in_seconds) {
        notes.push(format!("cells of {} seconds of arc are taken for {} m", step[0], cell as f32));
    } else if step[0] != step[1] {
        notes.push(format!("cells of {} by {} are taken for squares", step[0], step[1]));
    }
    // Points are in the middles of their cells, and seconds are told as degrees.
    let scale = if map.is_in_seconds { 3600.0 } else { 1.0 };
    let unit = if map.length.is_some() { LengthUnit::METRE } else { LengthUnit::UNKNOWN };
    let map = corner.filter(|corner| corner.iter().all(|place| place.is_finite())).map(|corner| Map {
        south_west: [0, 1].map(|axis| (corner[axis] - 0.5 * step[axis]) / scale),
        step: step.map(|step| step / scale),
        crs: map.crs,
    });
    Ok(Heights { width, depth, values, cell, unit, map, notes })
}

/// Where the places of a model are told.
struct Reference {
    crs: String,
    /// Metres of the unit of places on the ground; `None` where nobody knows.
    length: Option<f64>,
    is_in_seconds: bool,
}

impl Reference {
    /// As the head says it: the kind of map, its zone, its unit, and in newer files the datum.
    fn of(head: &Block) -> Self {
        let unit = head.code(528);
        let is_in_seconds = unit == Some(3);
        let length = match unit {
            Some(1) => Some(FOOT),
            Some(2) => Some(1.0),
            Some(3) => Some(DEGREE / 3600.0),
            _ => None,
        };
        let datum = head.code(890);
        let zone = head.code(162).filter(|zone| (1..=60).contains(zone));
        let crs = match (head.code(156), datum, zone) {
            (Some(0), Some(1), _) => "EPSG:4267".into(),
            (Some(0), Some(3), _) => "EPSG:4326".into(),
            (Some(0), Some(4), _) => "EPSG:4269".into(),
            // In metres, as UTM is.
            (Some(1), Some(1), Some(zone)) if (3..=22).contains(&zone) => format!("EPSG:{}", 26_700 + zone),
            (Some(1), Some(3), Some(zone)) => format!("EPSG:{}", 32_600 + zone),
            (Some(1), Some(4), Some(zone)) if zone <= 23 => format!("EPSG:{}", 26_900 + zone),
            (Some(1), _, Some(zone)) => format!("UTM zone {zone}, whose datum the file does not say"),
            _ => String::new(),
        };
        Self { crs, length, is_in_seconds }
    }
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

    /// The whole number in the two or six characters of a code, if there is one.
    fn code(&self, at: usize) -> Option<i32> {
        let text = self.text.get(at..at + if at == 890 { 2 } else { 6 })?;
        std::str::from_utf8(text).ok()?.trim().parse().ok()
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
