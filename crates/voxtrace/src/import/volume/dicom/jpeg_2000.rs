//! JPEG 2000 (ITU-T T.800), by the crate `hayro-jpeg2000`; what a picture asks for is checked before.

use hayro_jpeg2000::{DecodeSettings, DecoderContext, Image};

/// The start of a codestream and of its first segment, which says the sizes.
const START: &[u8] = b"\xff\x4f\xff\x51";
/// Most bits of a sample: the decoder works with f32.
const MOST_BITS: u8 = 24;
/// Numbers of tiles have 16 bits.
const MOST_TILES: u64 = 65_535;

/// Decodes a picture of `columns` times `rows` pixels: the samples of each component, row by row.
pub(super) fn decode(bytes: &[u8], columns: usize, rows: usize) -> Result<Vec<Vec<i32>>, String> {
    let at = bytes.windows(START.len()).position(|window| window == START).ok_or("no start of a picture")?;
    let offsets = check(&bytes[at + START.len()..])?;
    let settings = DecodeSettings { resolve_palette_indices: false, ..DecodeSettings::default() };
    let image = Image::new(bytes, &settings).map_err(|error| error.to_string())?;
    let size = (image.width() as usize, image.height() as usize);
    if size != (columns, rows) {
        return Err(format!("a picture of {} x {} in an instance of {columns} x {rows}", size.0, size.1));
    }
    let mut context = DecoderContext::default();
    let decoded = image.decode(&mut context).map_err(|error| error.to_string())?;
    let components = decoded.components();
    if components.len() != offsets.len() || components.iter().any(|part| part.samples().len() != columns * rows) {
        return Err("components of different sizes".into());
    }
    // The decoder moves signed samples up too.
    let whole = |sample: &f32, offset: i32| sample.round() as i32 - offset;
    let parts = components.iter().zip(offsets);
    Ok(parts.map(|(part, offset)| part.samples().iter().map(|sample| whole(sample, offset)).collect()).collect())
}

/// What is to be taken off the samples of each component; the segment of sizes is checked.
fn check(sizes: &[u8]) -> Result<Vec<i32>, String> {
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
    if !matches!(count, 1 | 3) {
        return Err(format!("{count} components"));
    }
    let offset = |&[depth, ..]: &[u8; 3]| {
        let bits = (depth & 0x7f) + 1;
        if bits > MOST_BITS {
            return Err(format!("samples of {bits} bits"));
        }
        Ok(if depth & 0x80 != 0 { 1 << (bits - 1) } else { 0 })
    };
    components.as_chunks().0.iter().map(offset).collect()
}
