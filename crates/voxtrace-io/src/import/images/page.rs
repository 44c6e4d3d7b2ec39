//! A page of a TIFF as numbers, by the crate `tiff`.

use super::planes::Plane;
use std::io::{Read, Seek};
use tiff::decoder::{Decoder, DecodingResult};
use tiff::tags::Tag;
use tiff::{ColorType, TiffError};
use voxtrace_voxelize::Limits;

/// What the decoder may allocate for a page of so many pixels.
pub(super) fn decoder_limits(pixels: u64, own: &Limits) -> tiff::decoder::Limits {
    let mut limits = tiff::decoder::Limits::default();
    limits.decoding_buffer_size = usize::try_from(pixels.saturating_mul(32)).unwrap_or(usize::MAX);
    // Tiles may be larger than the page.
    limits.intermediate_buffer_size = limits.decoding_buffer_size.max(own.bytes.min(1 << 26) as usize);
    limits
}

/// Bits of a pixel as the file has them.
pub(super) fn bits_of(color: ColorType) -> u32 {
    match color {
        ColorType::Gray(bits) | ColorType::Palette(bits) => bits.into(),
        ColorType::GrayA(bits) => 2 * u32::from(bits),
        ColorType::RGB(bits) | ColorType::YCbCr(bits) | ColorType::Lab(bits) => 3 * u32::from(bits),
        ColorType::RGBA(bits) | ColorType::CMYK(bits) => 4 * u32::from(bits),
        ColorType::CMYKA(bits) => 5 * u32::from(bits),
        ColorType::Multiband { bit_depth, num_samples } => u32::from(bit_depth) * u32::from(num_samples),
        _ => 64,
    }
}

/// The page at which the decoder is.
pub(super) fn plane<R: Read + Seek>(decoder: &mut Decoder<R>, width: usize, height: usize) -> Result<Plane, TiffError> {
    let color = decoder.colortype()?;
    let channels = match color {
        ColorType::Gray(_) | ColorType::Palette(_) => 1,
        ColorType::GrayA(_) => 2,
        ColorType::RGB(_) | ColorType::YCbCr(_) | ColorType::Lab(_) => 3,
        ColorType::RGBA(_) | ColorType::CMYK(_) => 4,
        ColorType::CMYKA(_) => 5,
        ColorType::Multiband { num_samples, .. } => usize::from(num_samples),
        _ => 1,
    };
    let is_apart = channels > 1 && decoder.get_tag_u32(Tag::PlanarConfiguration).is_ok_and(|apart| apart == 2);
    // Of more channels only the first are looked at.
    let channels = if is_apart { channels.min(4) } else { channels };
    let numbers = match is_apart {
        true => numbers_of_channels(decoder, [width, height], channels)?,
        false => numbers(decoder.read_image()?),
    };
    let count = width * height;
    let numbers = match color {
        ColorType::Gray(bits @ (1 | 2 | 4)) | ColorType::Palette(bits @ (1 | 2 | 4)) => unpacked(&numbers, bits, width),
        _ => numbers,
    };
    let channels = if numbers.len() == count { 1 } else { channels };
    if numbers.len() < count * channels.max(1) {
        return Err(TiffError::IoError(std::io::Error::other("TIFF: a page that is not whole")));
    }
    let full = match color {
        ColorType::RGB(8) | ColorType::RGBA(8) => Some(255.0),
        ColorType::RGB(16) | ColorType::RGBA(16) => Some(65_535.0),
        _ => None,
    };
    Ok(Plane::new([width, height], &numbers[..count * channels.max(1)], channels.max(1), full))
}

/// Samples of any kind.
fn numbers(samples: DecodingResult) -> Vec<f32> {
    macro_rules! numbers {
        ($values:expr) => {
            $values.into_iter().map(|value| value as f32).collect()
        };
    }
    match samples {
        DecodingResult::U8(values) => numbers!(values),
        DecodingResult::U16(values) => numbers!(values),
        DecodingResult::U32(values) => numbers!(values),
        DecodingResult::U64(values) => numbers!(values),
        DecodingResult::I8(values) => numbers!(values),
        DecodingResult::I16(values) => numbers!(values),
        DecodingResult::I32(values) => numbers!(values),
        DecodingResult::I64(values) => numbers!(values),
        DecodingResult::F16(values) => values.into_iter().map(f32::from).collect(),
        DecodingResult::F32(values) => values,
        DecodingResult::F64(values) => numbers!(values),
    }
}

/// The numbers of pixels whose channels are in planes of their own, strip by strip or tile by tile. (The decoder reads all planes
/// at once, too, but takes tiles of all but the first for whole ones where the page ends within them.)
fn numbers_of_channels<R: Read + Seek>(
    decoder: &mut Decoder<R>,
    [width, height]: [usize; 2],
    channels: usize,
) -> Result<Vec<f32>, TiffError> {
    let not_whole = || TiffError::IoError(std::io::Error::other("TIFF: a page that is not whole"));
    let (columns, rows) = decoder.chunk_dimensions();
    if columns == 0 || rows == 0 {
        return Err(not_whole());
    }
    let (across, down) = (width.div_ceil(columns as usize), height.div_ceil(rows as usize));
    let mut pixels = vec![0.0; width * height * channels];
    for segment in 0..across * down * channels {
        let (channel, of_plane) = (segment / (across * down), segment % (across * down));
        let (left, top) = (of_plane % across * columns as usize, of_plane / across * rows as usize);
        let found = numbers(decoder.read_chunk(segment as u32)?);
        let (own_columns, own_rows) = ((columns as usize).min(width - left), (rows as usize).min(height - top));
        for row in 0..own_rows {
            let from = found.get(row * own_columns..(row + 1) * own_columns).ok_or_else(not_whole)?;
            let to = ((top + row) * width + left) * channels + channel;
            pixels[to..].iter_mut().step_by(channels).zip(from).for_each(|(pixel, number)| *pixel = *number);
        }
    }
    Ok(pixels)
}

/// The numbers of several pixels in a byte, the highest bits first; rows begin with a byte.
fn unpacked(bytes: &[f32], bits: u8, width: usize) -> Vec<f32> {
    let bits = usize::from(bits);
    let row = |bytes: &[f32]| -> Vec<f32> {
        let pixel = |n: usize| f32::from(bytes[n * bits / 8] as u8 >> (8 - bits - n * bits % 8) & (0xff >> (8 - bits)));
        (0..width).map(pixel).collect()
    };
    bytes.chunks_exact((width * bits).div_ceil(8).max(1)).flat_map(row).collect()
}
