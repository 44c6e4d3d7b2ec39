//! Pictures as textures: PNG, JPEG and WebP, by the crates `png`, `zune-jpeg` and `image-webp`, with their sizes checked before they allocate.

use crate::import::images::allowance::{self, Packing, Refused};
use crate::import::source::guard::guarded;
use crate::import::source::input::Input;
use std::io::Cursor;
use std::path::Path;
use voxtrace_voxelize::mesh::Texture;
use voxtrace_voxelize::{ImportError, Limits};
use zune_jpeg::zune_core::{colorspace::ColorSpace, options::DecoderOptions};

/// Most texels along one edge.
const MAX_EDGE: u32 = 32_768;

/// Decodes a picture, told by its first bytes.
///
/// # Errors
/// What is wrong, or that it would be too large.
pub(crate) fn decode(bytes: &[u8], limits: &Limits) -> Result<Texture, Refused> {
    // What is too large is no fault of the decoder.
    guarded(|| match decode_unguarded(bytes, limits) {
        Err(Refused::Malformed(what)) => Err(what),
        other => Ok(other),
    })?
}

/// As [`decode`], of a picture that is kept beside others, which have `taken` so many bytes of those that all may take.
///
/// # Errors
/// As [`decode`].
#[cfg(feature = "mesh")]
pub(crate) fn decode_another(bytes: &[u8], taken: &mut u64, limits: &Limits) -> Result<Texture, Refused> {
    let left = Limits { bytes: limits.bytes.saturating_sub(*taken), ..*limits };
    let texture = decode(bytes, &left)?;
    *taken += texture.size_bytes() as u64;
    Ok(texture)
}

fn decode_unguarded(bytes: &[u8], limits: &Limits) -> Result<Texture, Refused> {
    if bytes.starts_with(b"\x89PNG\r\n\x1a\n") {
        decode_png(bytes, limits)
    } else if bytes.starts_with(&[0xff, 0xd8]) {
        decode_jpeg(bytes, limits)
    } else if bytes.starts_with(b"RIFF") && bytes.get(8..12) == Some(b"WEBP") {
        decode_webp(bytes, limits)
    } else {
        Err(Refused::Malformed("the picture is none of PNG, JPEG and WebP".into()))
    }
}

/// The sRGB texels, with opacity, of a picture (PNG, JPEG or WebP), row by row from the top.
///
/// # Errors
/// If the file cannot be read, is no such picture, or is too large.
pub fn read_picture(path: &Path, limits: &Limits) -> Result<Vec<[u8; 4]>, ImportError> {
    let bytes = Input::open(path, limits)?.rest()?;
    let texture = decode(&bytes, limits).map_err(|refused| refused.into_import_error(path))?;
    Ok(texture.texels().to_vec())
}

/// Checks that `width` × `height` texels of `texel_bits` may be unpacked from so many bytes.
fn check_size(
    (width, height): (u32, u32),
    texel_bits: u64,
    packed: usize,
    packing: Packing,
    limits: &Limits,
) -> Result<(), Refused> {
    if width > MAX_EDGE || height > MAX_EDGE {
        return Err(Refused::Malformed(format!("a picture of {width} x {height} texels is more than allowed")));
    }
    // As it is kept there are four bytes of each, whatever the file has.
    let kept = u64::from(width) * u64::from(height) * 4;
    if kept > limits.bytes {
        return Err(Refused::TooLarge { width, height, bytes: kept, limit: limits.bytes });
    }
    let count = u64::from(width) * u64::from(height);
    allowance::check((width, height, count), texel_bits, packed as u64, packing, limits)
}

fn decode_png(bytes: &[u8], limits: &Limits) -> Result<Texture, Refused> {
    let text = |error: png::DecodingError| Refused::Malformed(format!("PNG: {error}"));
    let mut decoder = png::Decoder::new_with_limits(Cursor::new(bytes), png::Limits { bytes: 1 << 30 });
    decoder.set_transformations(png::Transformations::normalize_to_color8());
    decoder.ignore_checksums(false);
    let mut reader = decoder.read_info().map_err(text)?;
    let (width, height) = reader.info().size();
    let info = reader.info();
    let bits = info.color_type.samples() as u64 * info.bit_depth as u64;
    check_size((width, height), bits, bytes.len(), Packing::Deflate, limits)?;
    let size = reader.output_buffer_size().ok_or_else(|| "PNG: too large".to_owned())?;
    let mut pixels = vec![0; size];
    let frame = reader.next_frame(&mut pixels).map_err(text)?;
    let pixels = &pixels[..frame.buffer_size()];
    let texels = match frame.color_type {
        png::ColorType::Grayscale => pixels.iter().map(|&v| [v, v, v, 255]).collect(),
        png::ColorType::GrayscaleAlpha => pixels.as_chunks().0.iter().map(|&[v, a]| [v, v, v, a]).collect(),
        png::ColorType::Rgb => pixels.as_chunks().0.iter().map(|&[r, g, b]| [r, g, b, 255]).collect(),
        png::ColorType::Rgba => pixels.as_chunks().0.to_vec(),
        png::ColorType::Indexed => return Err(Refused::Malformed("PNG: the palette is missing".into())),
    };
    Texture::new(width, height, texels).ok_or_else(|| Refused::Malformed("PNG: an empty picture".into()))
}

fn decode_jpeg(bytes: &[u8], limits: &Limits) -> Result<Texture, Refused> {
    let text = |error| Refused::Malformed(format!("JPEG: {error:?}"));
    let options = DecoderOptions::new_safe()
        .set_max_width(MAX_EDGE as usize)
        .set_max_height(MAX_EDGE as usize)
        .set_strict_mode(false)
        .jpeg_set_out_colorspace(ColorSpace::RGB);
    let mut decoder = zune_jpeg::JpegDecoder::new_with_options(Cursor::new(bytes), options);
    decoder.decode_headers().map_err(text)?;
    let info = decoder.info().ok_or_else(|| "JPEG: no header".to_owned())?;
    let (width, height) = (u32::from(info.width), u32::from(info.height));
    check_size((width, height), 24, bytes.len(), Packing::Jpeg, limits)?;
    let pixels = decoder.decode().map_err(text)?;
    let texels = pixels.as_chunks().0.iter().map(|&[r, g, b]| [r, g, b, 255]).collect();
    Texture::new(width, height, texels).ok_or_else(|| Refused::Malformed("JPEG: an unusual number of channels".into()))
}

fn decode_webp(bytes: &[u8], limits: &Limits) -> Result<Texture, Refused> {
    let text = |error| Refused::Malformed(format!("WebP: {error}"));
    let mut decoder = image_webp::WebPDecoder::new(Cursor::new(bytes)).map_err(text)?;
    let (width, height) = decoder.dimensions();
    check_size((width, height), 32, bytes.len(), Packing::Webp, limits)?;
    decoder.set_memory_limit(1 << 30);
    let size = decoder.output_buffer_size().ok_or_else(|| "WebP: too large".to_owned())?;
    let mut pixels = vec![0; size];
    // Of one that moves the first picture.
    decoder.read_image(&mut pixels).map_err(text)?;
    let texels = if decoder.has_alpha() {
        pixels.as_chunks().0.to_vec()
    } else {
        pixels.as_chunks().0.iter().map(|&[r, g, b]| [r, g, b, 255]).collect()
    };
    Texture::new(width, height, texels).ok_or_else(|| Refused::Malformed("WebP: an empty picture".into()))
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
        for packing in [Packing::Deflate, Packing::Jpeg, Packing::Webp] {
            let check = |packed| check_size((20_000, 20_000), 24, packed, packing, &Limits::default());
            assert!(check(1 << 20).is_err() && check(1 << 24).is_ok());
        }
    }

    #[cfg(feature = "mesh")]
    #[test]
    fn pictures_together_take_no_more_than_one_may() {
        let (bytes, limits, mut taken) = (png_of(16, 16, &[7; 768]), Limits { bytes: 2000, ..Limits::default() }, 0);
        assert!(decode_another(&bytes, &mut taken, &limits).is_ok());
        assert!((1024..2000).contains(&taken), "{taken}");
        let second = decode_another(&bytes, &mut taken, &limits);
        assert!(matches!(second, Err(Refused::TooLarge { .. })));
    }

    #[test]
    fn a_picture_of_one_colour_is_read() {
        // Some 25 million bytes from 25 thousand.
        let flat = png_of(2900, 2900, &vec![7; 3 * 2900 * 2900]);
        assert!(3 * 2900 * 2900 / flat.len() > 500, "{}", flat.len());
        assert_eq!(decode(&flat, &Limits::default()).unwrap().size(), [2900, 2900]);
    }
}
