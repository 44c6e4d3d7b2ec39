//! Pictures as textures: PNG, JPEG and WebP, by the crates `png`, `zune-jpeg` and `image-webp`, with their sizes checked before they allocate.

use crate::import::source::guard::guarded;
use crate::import::source::input::Input;
use std::io::Cursor;
use std::path::Path;
use voxtrace_voxelize::mesh::Texture;
use voxtrace_voxelize::{ImportError, Limits};
use zune_jpeg::zune_core::{colorspace::ColorSpace, options::DecoderOptions};

/// Most texels along one edge.
const MAX_EDGE: u32 = 32_768;
/// Pictures beyond this many bytes may not unpack to more than [`Limits::ratio`] times their file.
const FREE_BYTES: u64 = 16 << 20;

/// Decodes a picture, told by its first bytes.
///
/// # Errors
/// One sentence about what is wrong.
pub(crate) fn decode(bytes: &[u8], limits: &Limits) -> Result<Texture, String> {
    if bytes.starts_with(b"\x89PNG\r\n\x1a\n") {
        guarded(|| decode_png(bytes, limits))
    } else if bytes.starts_with(&[0xff, 0xd8]) {
        guarded(|| decode_jpeg(bytes, limits))
    } else if bytes.starts_with(b"RIFF") && bytes.get(8..12) == Some(b"WEBP") {
        guarded(|| decode_webp(bytes, limits))
    } else {
        Err("the picture is none of PNG, JPEG and WebP".into())
    }
}

/// The sRGB texels, with opacity, of a picture (PNG, JPEG or WebP), row by row from the top.
///
/// # Errors
/// If the file cannot be read, is no such picture, or is too large.
pub fn read_picture(path: &Path, limits: &Limits) -> Result<Vec<[u8; 4]>, ImportError> {
    let bytes = Input::open(path, limits)?.rest()?;
    let texture = decode(&bytes, limits).map_err(|what| ImportError::malformed(path, 0, what))?;
    Ok(texture.texels().to_vec())
}

/// Checks that `width` × `height` texels may be unpacked from so many bytes.
fn check_size(width: u32, height: u32, packed: usize, limits: &Limits) -> Result<(), String> {
    let size = u64::from(width) * u64::from(height) * 4;
    let is_bomb = size > FREE_BYTES && size / limits.ratio.max(1) > packed as u64;
    if width > MAX_EDGE || height > MAX_EDGE || size > limits.bytes || is_bomb {
        return Err(format!("a picture of {width} x {height} texels is more than allowed"));
    }
    Ok(())
}

fn decode_png(bytes: &[u8], limits: &Limits) -> Result<Texture, String> {
    let text = |error: png::DecodingError| format!("PNG: {error}");
    let mut decoder = png::Decoder::new_with_limits(Cursor::new(bytes), png::Limits { bytes: 1 << 30 });
    decoder.set_transformations(png::Transformations::normalize_to_color8());
    decoder.ignore_checksums(false);
    let mut reader = decoder.read_info().map_err(text)?;
    let (width, height) = reader.info().size();
    check_size(width, height, bytes.len(), limits)?;
    let size = reader.output_buffer_size().ok_or("PNG: too large")?;
    let mut pixels = vec![0; size];
    let frame = reader.next_frame(&mut pixels).map_err(text)?;
    let pixels = &pixels[..frame.buffer_size()];
    let texels = match frame.color_type {
        png::ColorType::Grayscale => pixels.iter().map(|&v| [v, v, v, 255]).collect(),
        png::ColorType::GrayscaleAlpha => pixels.as_chunks().0.iter().map(|&[v, a]| [v, v, v, a]).collect(),
        png::ColorType::Rgb => pixels.as_chunks().0.iter().map(|&[r, g, b]| [r, g, b, 255]).collect(),
        png::ColorType::Rgba => pixels.as_chunks().0.to_vec(),
        png::ColorType::Indexed => return Err("PNG: the palette is missing".into()),
    };
    Texture::new(width, height, texels).ok_or_else(|| "PNG: an empty picture".into())
}

fn decode_jpeg(bytes: &[u8], limits: &Limits) -> Result<Texture, String> {
    let text = |error| format!("JPEG: {error:?}");
    let options = DecoderOptions::new_safe()
        .set_max_width(MAX_EDGE as usize)
        .set_max_height(MAX_EDGE as usize)
        .set_strict_mode(false)
        .jpeg_set_out_colorspace(ColorSpace::RGB);
    let mut decoder = zune_jpeg::JpegDecoder::new_with_options(Cursor::new(bytes), options);
    decoder.decode_headers().map_err(text)?;
    let info = decoder.info().ok_or("JPEG: no header")?;
    let (width, height) = (u32::from(info.width), u32::from(info.height));
    check_size(width, height, bytes.len(), limits)?;
    let pixels = decoder.decode().map_err(text)?;
    let texels = pixels.as_chunks().0.iter().map(|&[r, g, b]| [r, g, b, 255]).collect();
    Texture::new(width, height, texels).ok_or_else(|| "JPEG: an unusual number of channels".into())
}

fn decode_webp(bytes: &[u8], limits: &Limits) -> Result<Texture, String> {
    let text = |error| format!("WebP: {error}");
    let mut decoder = image_webp::WebPDecoder::new(Cursor::new(bytes)).map_err(text)?;
    let (width, height) = decoder.dimensions();
    check_size(width, height, bytes.len(), limits)?;
    decoder.set_memory_limit(1 << 30);
    let size = decoder.output_buffer_size().ok_or("WebP: too large")?;
    let mut pixels = vec![0; size];
    // Of one that moves the first picture.
    decoder.read_image(&mut pixels).map_err(text)?;
    let texels = if decoder.has_alpha() {
        pixels.as_chunks().0.to_vec()
    } else {
        pixels.as_chunks().0.iter().map(|&[r, g, b]| [r, g, b, 255]).collect()
    };
    Texture::new(width, height, texels).ok_or_else(|| "WebP: an empty picture".into())
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::{Vec2, Vec4};
    use voxtrace_voxelize::mesh::Wrap;

    fn png_of(width: u32, height: u32, rgb: &[u8]) -> Vec<u8> {
        let mut bytes = Vec::new();
        let mut encoder = png::Encoder::new(&mut bytes, width, height);
        encoder.set_color(png::ColorType::Rgb);
        encoder.write_header().unwrap().write_image_data(rgb).unwrap();
        bytes
    }

    #[test]
    fn a_png_keeps_its_texels() {
        let texture = decode(&png_of(2, 1, &[255, 0, 0, 0, 0, 255]), &Limits::default()).unwrap();
        let sample = |u| texture.sample(Vec2::new(u, 0.5), [Wrap::Clamp; 2], true, 0.0);
        assert_eq!((sample(0.2), sample(0.8)), (Vec4::new(1.0, 0.0, 0.0, 1.0), Vec4::new(0.0, 0.0, 1.0, 1.0)));
    }

    fn webp_of(width: u32, height: u32, texels: &[u8], kind: image_webp::ColorType) -> Vec<u8> {
        let mut bytes = Vec::new();
        image_webp::WebPEncoder::new(&mut bytes).encode(texels, width, height, kind).unwrap();
        bytes
    }

    #[test]
    fn a_webp_keeps_its_texels_and_where_they_are_clear() {
        let texels = [255, 0, 0, 255, 0, 0, 255, 64];
        let clear = decode(&webp_of(2, 1, &texels, image_webp::ColorType::Rgba8), &Limits::default()).unwrap();
        assert_eq!(clear.texels(), [[255, 0, 0, 255], [0, 0, 255, 64]]);
        let rgb = webp_of(1, 2, &[9, 8, 7, 6, 5, 4], image_webp::ColorType::Rgb8);
        let opaque = decode(&rgb, &Limits::default()).unwrap();
        assert_eq!((opaque.size(), opaque.texels()), ([1, 2], &[[9, 8, 7, 255], [6, 5, 4, 255]][..]));
        for end in 0..rgb.len() - 1 {
            assert!(decode(&rgb[..end], &Limits::default()).is_err(), "{end}");
        }
    }

    #[test]
    fn cut_off_and_foreign_pictures_are_errors() {
        let whole = png_of(16, 16, &[7; 768]);
        for end in 0..whole.len() - 12 {
            assert!(decode(&whole[..end], &Limits::default()).is_err(), "{end}");
        }
        assert!(decode(b"GIF89a", &Limits::default()).is_err());
        assert!(decode(&[0xff, 0xd8, 0xff, 0xe0, 0, 16], &Limits::default()).is_err());
    }

    #[test]
    fn a_picture_beyond_the_limits_is_refused_before_it_is_unpacked() {
        assert!(decode(&png_of(16, 16, &[7; 768]), &Limits { bytes: 1000, ..Limits::default() }).is_err());
        assert!(check_size(20_000, 20_000, 1 << 20, &Limits::default()).is_err());
        assert!(check_size(20_000, 20_000, 1 << 24, &Limits::default()).is_ok());
    }
}
