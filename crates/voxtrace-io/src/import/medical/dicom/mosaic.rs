//! Mosaics of Siemens: all slices of a volume as tiles of one picture. How many there are stands in an element of theirs or in their
//! "CSA header", whose layout is known from nibabel's description of it (nicom, "CSA format").

use super::elements::File;
use super::stack::Slice;
use super::tag;
use glam::DVec3;

/// The tiles of a mosaic.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Mosaic {
    /// Slices.
    count: usize,
    /// Tiles beside and below one another.
    across: usize,
    /// Pixels of a tile.
    pub columns: usize,
    pub rows: usize,
    /// From slice to slice, of length 1, where the file says it.
    normal: Option<DVec3>,
}

impl Mosaic {
    /// That of a file with a picture of so many columns and rows; `None` where it is none.
    pub fn of(file: &File, columns: usize, rows: usize) -> Option<Self> {
        let main = &file.main;
        if !main.text(tag::IMAGE_TYPE)?.split('\\').any(|word| word.trim() == "MOSAIC") {
            return None;
        }
        let csa = [tag::CSA_HEADER, tag::CSA_HEADER_BEHIND].iter().find_map(|&tag| main.bytes(tag)).unwrap_or_default();
        let count = main.short(tag::MOSAIC_COUNT).map(f64::from);
        let count = count.or_else(|| numbers(csa, "NumberOfImagesInMosaic")?.first().copied())?;
        let count = (1.0..=65_536.0).contains(&count).then_some(count as usize)?;
        let across = (count as f64).sqrt().ceil() as usize;
        if !columns.is_multiple_of(across) || !rows.is_multiple_of(across) {
            return None;
        }
        let normal = numbers(csa, "SliceNormalVector").filter(|normal| normal.len() == 3);
        let normal = normal.and_then(|normal| DVec3::from_slice(&normal).try_normalize());
        Some(Self { count, across, columns: columns / across, rows: rows / across, normal })
    }

    /// The slices of a picture whose first pixel lies where that of `whole` does. Columns and rows are counted along `directions`,
    /// and pixels and slices are `spacing` apart.
    pub fn slices(&self, whole: &Slice, spacing: DVec3) -> Vec<Slice> {
        let (x, y) = whole.directions;
        let normal = self.normal.unwrap_or_else(|| x.cross(y));
        // The place of the file is that of a single picture as large as the mosaic, in the middle of which the slices lie.
        let beside = (self.columns * (self.across - 1)) as f64 / 2.0 * spacing.x;
        let below = (self.rows * (self.across - 1)) as f64 / 2.0 * spacing.y;
        let stride = self.columns * self.across;
        let slice = |n: usize| {
            let start = n / self.across * self.rows * stride + n % self.across * self.columns;
            let row = |row: usize| &whole.values[start + row * stride..][..self.columns];
            Slice {
                position: whole.position.map(|at| at + x * beside + y * below + normal * (n as f64 * spacing.z)),
                values: (0..self.rows).flat_map(row).copied().collect(),
                frame: n,
                ..*whole
            }
        };
        (0..self.count).map(slice).collect()
    }
}

/// The numbers of a value in a CSA header.
fn numbers(bytes: &[u8], name: &str) -> Option<Vec<f64>> {
    let word = |at: usize| bytes.get(at..)?.first_chunk().map(|&word| u32::from_le_bytes(word) as usize);
    // The second version says so; in the first, lengths are larger by what the first value says.
    let is_second = bytes.starts_with(b"SV10");
    let mut at = if is_second { 8 } else { 0 };
    let count = word(at)?;
    at += 8;
    let mut extra = None;
    for _ in 0..count.min(1000) {
        let own = bytes.get(at..at + 64)?.split(|&byte| byte == 0).next()?;
        let items = word(at + 76)?;
        let extra = *extra.get_or_insert(if is_second { 0 } else { items });
        at += 84;
        let mut found = Vec::new();
        for _ in 0..items.min(1000) {
            let length = if is_second { word(at + 4)? } else { word(at)?.checked_sub(extra)? };
            at += 16;
            let text = bytes.get(at..at.checked_add(length)?)?;
            let text = String::from_utf8_lossy(text.split(|&byte| byte == 0).next()?).into_owned();
            found.extend(text.trim().parse::<f64>().ok());
            at += length.next_multiple_of(4);
        }
        if own == name.as_bytes() {
            return Some(found);
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A header of the second version with two values.
    fn header() -> Vec<u8> {
        let mut bytes = b"SV10\x04\x03\x02\x01\x02\0\0\0M\0\0\0".to_vec();
        for (name, values) in [("NumberOfImagesInMosaic", &["3"][..]), ("SliceNormalVector", &["0.0", " 0.0", "-1.0"])]
        {
            let mut own = name.as_bytes().to_vec();
            own.resize(76, 0);
            bytes.extend(own);
            bytes.extend((values.len() as u32).to_le_bytes());
            bytes.extend([0; 4]);
            for value in values {
                let length = value.len() as u32;
                bytes.extend([length, length, 77, length].map(u32::to_le_bytes).as_flattened());
                bytes.extend(value.as_bytes());
                bytes.resize(bytes.len().next_multiple_of(4), 0);
            }
        }
        bytes
    }

    #[test]
    fn headers_of_siemens_say_numbers_and_broken_ones_nothing() {
        let bytes = header();
        assert_eq!(numbers(&bytes, "NumberOfImagesInMosaic"), Some(vec![3.0]));
        assert_eq!(numbers(&bytes, "SliceNormalVector"), Some(vec![0.0, 0.0, -1.0]));
        assert_eq!(numbers(&bytes, "Other"), None);
        for length in 0..bytes.len() - 4 {
            assert_eq!(numbers(&bytes[..length], "SliceNormalVector").filter(|all| all.len() == 3), None, "{length}");
        }
        assert_eq!(numbers(&[0xff; 400], "a"), None);
    }

    #[test]
    fn tiles_are_slices_one_behind_the_other() {
        let mosaic = Mosaic { count: 3, across: 2, columns: 2, rows: 1, normal: Some(DVec3::NEG_Z) };
        let whole = Slice {
            position: Some(DVec3::new(1.0, 2.0, 3.0)),
            directions: (DVec3::X, DVec3::Y),
            number: 7.0,
            frame: 0,
            values: (0..8).map(|n| n as f32).collect(),
        };
        let slices = mosaic.slices(&whole, DVec3::new(2.0, 4.0, 5.0));
        let values: Vec<&[f32]> = slices.iter().map(|slice| &*slice.values).collect();
        assert_eq!(values, [[0.0, 1.0], [2.0, 3.0], [4.0, 5.0]]);
        // Half of the mosaic's size without a tile: 2 columns of 2 mm, a row of 4 mm.
        assert_eq!(slices[2].position, Some(DVec3::new(3.0, 4.0, -7.0)));
    }
}
