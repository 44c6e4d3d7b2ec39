//! JPEG 2000 (ITU-T T.800), by the crate `hayro-jpeg2000`; what a picture asks for is checked before.

use hayro_jpeg2000::{DecodeSettings, DecoderContext, Image};

/// The start of a codestream and of its first segment, which says the sizes.
const START: &[u8] = b"\xff\x4f\xff\x51";
/// Most bits of a sample: the decoder works with f32.
const MOST_BITS: u8 = 24;
/// Numbers of tiles have 16 bits.
const MOST_TILES: u64 = 65_535;

/// A picture as it comes out of its codestream.
pub(crate) struct Picture {
    /// The samples of each component, row by row.
    pub components: Vec<Vec<i32>>,
    /// Whether three components had been mixed, which the decoder has undone: they are red, green and blue.
    pub was_mixed: bool,
}

/// Decodes a picture of `columns` times `rows` pixels.
pub(crate) fn decode(bytes: &[u8], columns: usize, rows: usize) -> Result<Picture, String> {
    let at = bytes.windows(START.len()).position(|window| window == START).ok_or("no start of a picture")?;
    let ranges = check(&bytes[at + START.len()..])?;
    let settings = DecodeSettings { resolve_palette_indices: false, ..DecodeSettings::default() };
    let image = Image::new(bytes, &settings).map_err(|error| error.to_string())?;
    let size = (image.width() as usize, image.height() as usize);
    if size != (columns, rows) {
        return Err(format!("a picture of {} x {} in an instance of {columns} x {rows}", size.0, size.1));
    }
    let mut context = DecoderContext::default();
    let decoded = image.decode(&mut context).map_err(|error| error.to_string())?;
    let components = decoded.components();
    if components.len() != ranges.len() || components.iter().any(|part| part.samples().len() != columns * rows) {
        return Err("components of different sizes".into());
    }
    let parts = components.iter().zip(ranges);
    let components = parts.map(|(part, range)| part.samples().iter().map(|&sample| range.whole(sample)).collect());
    Ok(Picture { components: components.collect(), was_mixed: is_mixed(&bytes[at + 2..]) })
}

/// Whether the segment of the coding style says that components are mixed; `segments` are those of the codestream.
fn is_mixed(mut segments: &[u8]) -> bool {
    const CODING: [u8; 2] = [0xff, 0x52];
    while let [0xff, marker, high, low, rest @ ..] = segments {
        if [0xff, *marker] == CODING {
            // Behind the style, the order of packets and the number of layers.
            return rest.get(4).is_some_and(|&mixing| mixing != 0);
        }
        let length = usize::from(u16::from_be_bytes([*high, *low]));
        segments = segments.get(2 + length..).unwrap_or_default();
    }
    false
}

/// What the samples of a component can be.
#[derive(Clone, Copy, Debug)]
struct Range {
    bits: u8,
    is_signed: bool,
}

impl Range {
    /// The whole number of a sample, at most those that the component has: what was lost can lie beyond them.
    fn whole(self, sample: f32) -> i32 {
        let half = if self.is_signed { 1 << (self.bits - 1) } else { 0 };
        // The decoder moves signed samples up too.
        (sample.round() as i32).clamp(0, (1 << self.bits) - 1) - half
    }
}

/// The ranges of the components; the segment of sizes is checked.
fn check(sizes: &[u8]) -> Result<Vec<Range>, String> {
    let word = |n: usize| {
        let word = sizes.get(4 + 4 * n..).and_then(|rest| rest.first_chunk());
        word.map(|&word| u32::from_be_bytes(word)).ok_or("a short header")
    };
    // The ends of the picture, its start, the size of a tile, and where the first one is.
    let [width, height, left, top, tile_width, tile_height, tiles_left, tiles_top] =
        [word(0)?, word(1)?, word(2)?, word(3)?, word(4)?, word(5)?, word(6)?, word(7)?];
    if tile_width == 0 || tile_height == 0 || left < tiles_left || top < tiles_top {
        return Err("impossible tiles".into());
    }
    let tiles = |end: u32, start: u32, size: u32| u64::from(end.saturating_sub(start).div_ceil(size));
    let count = tiles(width, tiles_left, tile_width) * tiles(height, tiles_top, tile_height);
    if count > MOST_TILES {
        return Err(format!("{count} tiles"));
    }
    let count = sizes.get(36..38).map_or(0, |count| u16::from_be_bytes([count[0], count[1]]));
    let components = sizes.get(38..38 + 3 * usize::from(count)).ok_or("a short header")?;
    if !(1..=4).contains(&count) {
        return Err(format!("{count} components"));
    }
    let range = |&[depth, ..]: &[u8; 3]| {
        let bits = (depth & 0x7f) + 1;
        if bits > MOST_BITS {
            return Err(format!("samples of {bits} bits"));
        }
        Ok(Range { bits, is_signed: depth & 0x80 != 0 })
    };
    components.as_chunks().0.iter().map(range).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Four by two pixels, lossless, by OpenJPEG: as luma and chroma, and as red, green and blue that were mixed.
    const PLAIN: &str = "ff4fff51002f000000000004000000020000000000000000000000040000000200000000000000000003070101070101\
        070101ff52000c00000001000004040001ff5c00044040ff90000a00000000002f0001ff93df80500c4866aa097850b2193fcfb41c0e19\
        c8b3b3e0d3cfb41c02fb5b8cdf7e11ffd9";
    const MIXED: &str = "ff4fff51002f000000000004000000020000000000000000000000040000000200000000000000000003070101070101\
        070101ff52000c00000001010004040001ff5c00044040ff90000a00000000002f0001ff93df80500c359a2cc99717e5c777df80380e19\
        6aab6e1daddf803802fb600b9e6ecfffd9";

    fn decoded(hex: &str) -> Picture {
        let digits: Vec<u8> = hex.bytes().map(|digit| char::from(digit).to_digit(16).unwrap() as u8).collect();
        let bytes: Vec<u8> = digits.as_chunks().0.iter().map(|[high, low]| high << 4 | low).collect();
        decode(&bytes, 4, 2).unwrap()
    }

    #[test]
    fn samples_beyond_their_bits_are_the_last_that_there_are() {
        let (plain, signed) = (Range { bits: 12, is_signed: false }, Range { bits: 12, is_signed: true });
        for (sample, wanted) in
            [(-3.2, 0), (-0.4, 0), (7.5, 8), (4095.4, 4095), (4099.0, 4095), (1e9, 4095), (f32::NAN, 0)]
        {
            assert_eq!((plain.whole(sample), signed.whole(sample)), (wanted, wanted - 2048), "{sample}");
        }
    }

    #[test]
    fn pictures_say_whether_their_components_were_mixed() {
        let plain = decoded(PLAIN);
        assert_eq!((plain.was_mixed, &plain.components[0][..]), (false, &[76, 149, 29, 124, 0, 255, 18, 128][..]));
        let mixed = decoded(MIXED);
        assert_eq!((mixed.was_mixed, &mixed.components[1][..4]), (true, &[0, 255, 0, 100][..]));
    }
}
