//! The brightness of colours that pixels are numbers of (PS3.3, C.7.6.3.1.5 and C.7.6.3.1.6), also where their table is
//! told in segments (C.7.9.2).

use super::elements::File;
use super::pixels::brightness;
use super::tag;

/// A table of brightness.
pub(super) struct Palette {
    /// The pixel that has the first entry.
    first: f32,
    entries: Vec<f32>,
}

impl Palette {
    /// That of a file; `None` where its pixels are no such numbers or its table is not one of plain entries.
    pub fn of(file: &File) -> Option<Self> {
        let main = &file.main;
        if main.text(tag::PHOTOMETRIC) != Some("PALETTE COLOR") {
            return None;
        }
        let descriptor = main.shorts(tag::PALETTE_OF_RED)?;
        let &[count, first, bits] = descriptor.first_chunk()?;
        let count = if count == 0 { 1 << 16 } else { usize::from(count) };
        let is_signed = main.short(tag::SIGNED) == Some(1);
        let first = if is_signed { f32::from(first.cast_signed()) } else { f32::from(first) };
        let channel = |[plain, segments]: [u32; 2]| {
            let words = |tag| {
                let (bytes, words) = (main.bytes(tag)?, main.shorts(tag)?);
                // Numbers of 8 bits lie two to a word.
                let are_bytes = bits == 8 && (tag == segments || bytes.len() < 2 * count);
                let halves = |word: &u16| word.to_le_bytes().map(u16::from);
                Some(if are_bytes { words.iter().flat_map(halves).collect() } else { words })
            };
            let entries: Option<Vec<u16>> = words(plain).or_else(|| expanded(&words(segments)?, bits == 8, count));
            entries.filter(|entries| entries.len() >= count)
        };
        let red = channel([tag::RED_ENTRIES, tag::RED_SEGMENTS])?;
        let green = channel([tag::GREEN_ENTRIES, tag::GREEN_SEGMENTS])?;
        let blue = channel([tag::BLUE_ENTRIES, tag::BLUE_SEGMENTS])?;
        let entry = |n: usize| brightness([red[n], green[n], blue[n]].map(f32::from));
        Some(Self { first, entries: (0..count).map(entry).collect() })
    }

    /// Makes numbers of entries brightness. What is before the first or behind the last is like it.
    pub fn apply(&self, values: &mut [f32]) {
        let last = self.entries.len() - 1;
        values.iter_mut().for_each(|value| *value = self.entries[((*value - self.first) as usize).min(last)]);
    }
}

/// The entries that segments stand for: single ones, straight lines, and copies of earlier segments.
fn expanded(segments: &[u16], are_bytes: bool, most: usize) -> Option<Vec<u16>> {
    let mut entries = Vec::new();
    let mut at = 0;
    while entries.len() < most {
        let length = usize::from(*segments.get(at + 1)?);
        at = match segments.get(at)? {
            0 | 1 => segment(segments, at, &mut entries)?,
            2 => {
                // The place of the first one, in bytes, the lower half before.
                let half = |n: usize| {
                    let number = |n| segments.get(at + 2 + n).map(|&number| usize::from(number));
                    if are_bytes { Some(number(2 * n)? | number(2 * n + 1)? << 8) } else { number(n) }
                };
                let place = half(0)? | half(1)? << 16;
                let mut copied = if are_bytes { place } else { place / 2 };
                for _ in 0..length {
                    copied = segment(segments, copied, &mut entries)?;
                }
                at + if are_bytes { 6 } else { 4 }
            }
            _ => return None,
        };
    }
    Some(entries)
}

/// Adds the entries of a segment that is no copy. Returns the place behind it.
fn segment(segments: &[u16], at: usize, entries: &mut Vec<u16>) -> Option<usize> {
    let length = usize::from(*segments.get(at + 1)?);
    let start = at + 2;
    match segments.get(at)? {
        0 => {
            entries.extend(segments.get(start..start + length)?);
            Some(start + length)
        }
        1 => {
            let (from, to) = (f64::from(*entries.last()?), f64::from(*segments.get(start)?));
            let step = (to - from) / length as f64;
            entries.extend((1..=length).map(|n| (from + step * n as f64).round_ties_even() as u16));
            Some(start + 1)
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn segments_are_entries_lines_and_copies() {
        let words = [0, 2, 10, 20, 1, 4, 60, 2, 1, 0, 0];
        assert_eq!(expanded(&words, false, 8), Some(vec![10, 20, 30, 40, 50, 60, 10, 20]));
        // As bytes the place of a copy takes four numbers.
        assert_eq!(expanded(&[0, 1, 7, 1, 2, 9, 2, 2, 0, 0, 0, 0], true, 6), Some(vec![7, 8, 9, 7, 8, 9]));
        for wrong in
            [&[][..], &[0], &[0, 3, 1], &[1, 2, 5], &[3, 0], &[0, 1, 5, 2, 9, 0, 0, 9], &[0, 1, 5, 2, 1, 200, 0]]
        {
            assert_eq!(expanded(wrong, false, 1000), None, "{wrong:?}");
        }
    }
}
