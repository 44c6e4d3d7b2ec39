//! Pictures as a screen shows them, read from the files that voxtrace writes: PNG (of any program), EXR, film files.

use crate::output::{FILM_MAGIC, FilmFile, FilmFileError, ToneMap};
use exr::prelude::{MetaData, ReadChannels, ReadLayers, read};
use glam::{Vec3, Vec4};
use rayon::prelude::*;
use std::fs::File;
use std::io::{self, Cursor, Read};
use std::path::Path;
use voxtrace_core::film::Pixel;
use voxtrace_core::frame::MAX_PIXELS;

const PNG_MAGIC: &[u8] = b"\x89PNG\r\n\x1a\n";
const EXR_MAGIC: &[u8] = &[0x76, 0x2f, 0x31, 0x01];

/// A picture's sRGB signal.
#[derive(Clone, Debug, PartialEq)]
pub struct Shown {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Red, green and blue of each pixel, in [0, 1], row by row from the top; what is transparent lies over black.
    pub signal: Vec<Vec3>,
}

/// A picture that cannot be read.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ShownError {
    /// The operating system refused.
    #[error(transparent)]
    Io(#[from] io::Error),
    /// Neither PNG nor EXR nor film.
    #[error("this is no PNG, EXR or film")]
    NoPicture,
    /// It is damaged, or of a kind that is not read.
    #[error("{0}")]
    Malformed(String),
}

/// Whether a file begins as a picture does that [`Shown::open`] reads. What cannot be read is none.
pub fn is_picture(path: &Path) -> bool {
    let mut head = [0; 8];
    let read = File::open(path).and_then(|mut file| file.read_exact(&mut head));
    read.is_ok() && begins_as_picture(&head)
}

/// Whether bytes begin as a picture does that [`Shown::from_bytes`] reads.
#[doc(hidden)]
pub fn begins_as_picture(bytes: &[u8]) -> bool {
    [PNG_MAGIC, EXR_MAGIC, FILM_MAGIC].iter().any(|magic| bytes.starts_with(magic))
}

impl Shown {
    /// Reads a file, told by its first bytes. Of an EXR it takes the channels `R`, `G`, `B` and, where there is one, `A`, by which the colours
    /// are multiplied. EXR and films have radiance, which `tone_map` makes visible; a PNG is what it is. What is transparent is shown alike,
    /// whichever file it comes from: tone-mapped for itself, as in a PNG, and then laid over black.
    ///
    /// # Errors
    /// [`ShownError`].
    pub fn open(path: &Path, tone_map: &ToneMap) -> Result<Self, ShownError> {
        Self::from_bytes(std::fs::read(path)?, tone_map)
    }

    /// As [`Self::open`], of the bytes of a file.
    ///
    /// # Errors
    /// As [`Self::open`].
    #[doc(hidden)]
    pub fn from_bytes(bytes: Vec<u8>, tone_map: &ToneMap) -> Result<Self, ShownError> {
        if bytes.starts_with(PNG_MAGIC) {
            return of_png(&bytes);
        }
        let (width, height, pixels) = if bytes.starts_with(EXR_MAGIC) {
            radiance_of_exr(bytes)?
        } else if bytes.starts_with(FILM_MAGIC) {
            let file = FilmFile::from_bytes(&bytes).map_err(|error| match error {
                FilmFileError::Io(error) => ShownError::Io(error),
                error => ShownError::Malformed(error.to_string()),
            })?;
            let region = file.film.region;
            let is_transparent = file.frame.transparent;
            let alpha = |pixel: &Pixel| if is_transparent { pixel.alpha() } else { 1.0 };
            let pixels = file.film.pixels.iter().map(|pixel| pixel.mean().extend(alpha(pixel))).collect();
            (region.width(), region.height(), pixels)
        } else {
            return Err(ShownError::NoPicture);
        };
        let signal = pixels.par_iter().map(|&pixel: &Vec4| over_black(pixel, tone_map)).collect();
        Ok(Self { width, height, signal })
    }

    /// What a screen shows of linear radiance, one value a pixel.
    pub fn of_radiance(width: u32, height: u32, radiance: &[Vec3], tone_map: &ToneMap) -> Self {
        let signal = radiance.par_iter().map(|&radiance| tone_map.signal(radiance).as_vec3()).collect();
        Self { width, height, signal }
    }
}

/// What a screen shows of radiance that is multiplied by its alpha, over black: the signal of what covers the pixel, as far as it does. Light
/// that nothing covers is added to what is behind it.
fn over_black(pixel: Vec4, tone_map: &ToneMap) -> Vec3 {
    let (radiance, alpha) = (pixel.truncate(), pixel.w);
    if alpha > 0.0 && alpha < 1.0 {
        tone_map.signal(radiance / alpha).as_vec3() * alpha
    } else {
        tone_map.signal(radiance).as_vec3()
    }
}

/// Refuses sizes that no picture of ours has, before anything of that size is allocated: a damaged file may say any.
fn check_size(width: u64, height: u64) -> Result<(), ShownError> {
    if width.saturating_mul(height) <= MAX_PIXELS {
        return Ok(());
    }
    Err(ShownError::Malformed(format!("{width} x {height} are more than {MAX_PIXELS} pixels")))
}

fn of_png(bytes: &[u8]) -> Result<Shown, ShownError> {
    let malformed = |error: png::DecodingError| ShownError::Malformed(error.to_string());
    let mut decoder = png::Decoder::new(Cursor::new(bytes));
    decoder.set_transformations(png::Transformations::EXPAND);
    let mut reader = decoder.read_info().map_err(malformed)?;
    let info = reader.info();
    check_size(info.width.into(), info.height.into())?;
    let size = reader.output_buffer_size().ok_or_else(|| ShownError::Malformed("the picture is too large".into()))?;
    let mut samples = vec![0; size];
    let frame = reader.next_frame(&mut samples).map_err(malformed)?;
    let channels = match frame.color_type {
        png::ColorType::Grayscale => 1,
        png::ColorType::GrayscaleAlpha => 2,
        png::ColorType::Rgb => 3,
        png::ColorType::Rgba => 4,
        png::ColorType::Indexed => return Err(ShownError::Malformed("the palette was not expanded".into())),
    };
    let bytes = if frame.bit_depth == png::BitDepth::Sixteen { 2 } else { 1 };
    let value = |sample: &[u8]| match sample {
        [byte] => f32::from(*byte) / 255.0,
        word => f32::from(u16::from_be_bytes([word[0], word[1]])) / 65_535.0,
    };
    let pixel = |pixel: &[u8]| {
        let at = |channel: usize| value(&pixel[channel * bytes..][..bytes]);
        match channels {
            1 => Vec3::splat(at(0)),
            2 => Vec3::splat(at(0)) * at(1),
            3 => Vec3::new(at(0), at(1), at(2)),
            _ => Vec3::new(at(0), at(1), at(2)) * at(3),
        }
    };
    let signal = samples[..frame.buffer_size()].chunks_exact(channels * bytes).map(pixel).collect();
    Ok(Shown { width: frame.width, height: frame.height, signal })
}

/// Radiance and alpha; the latter is 1 where the file has none.
fn radiance_of_exr(bytes: Vec<u8>) -> Result<(u32, u32, Vec<Vec4>), ShownError> {
    type Pixels = (usize, Vec<Vec4>);
    let malformed = |error: exr::error::Error| ShownError::Malformed(error.to_string());
    for header in MetaData::read_from_buffered(Cursor::new(&bytes), false).map_err(malformed)?.headers {
        check_size(header.layer_size.width() as u64, header.layer_size.height() as u64)?;
    }
    let image = read()
        .no_deep_data()
        .largest_resolution_level()
        .rgba_channels(
            |size, _| (size.width(), vec![Vec4::ZERO; size.area()]),
            |pixels: &mut Pixels, at, (r, g, b, a): (f32, f32, f32, f32)| {
                let index = at.y() * pixels.0 + at.x();
                pixels.1[index] = Vec4::new(r, g, b, a);
            },
        )
        .first_valid_layer()
        .all_attributes()
        .from_buffered(Cursor::new(bytes))
        .map_err(malformed)?;
    let size = image.layer_data.size;
    Ok((size.width() as u32, size.height() as u32, image.layer_data.channel_data.pixels.1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_that_says_that_it_is_huge_is_refused_before_it_has_room() {
        let of_size = |width: u32, height: u32| {
            let mut bytes = Vec::new();
            let mut writer = png::Encoder::new(&mut bytes, width, height).write_header().unwrap();
            writer.write_chunk(png::chunk::IDAT, &[0]).unwrap();
            drop(writer);
            of_png(&bytes).unwrap_err().to_string()
        };
        assert_eq!(of_size(200_000, 150_000), "200000 x 150000 are more than 268435456 pixels");
        assert!(!of_size(20, 15).contains("more than"), "a small one is read, and found to be damaged");
        check_size(1 << 14, 1 << 14).unwrap();
        check_size((1 << 14) + 1, 1 << 14).unwrap_err();
        check_size(u64::MAX, 2).unwrap_err();
    }

    #[test]
    fn what_is_transparent_is_tone_mapped_for_itself_and_then_laid_over_black() {
        let map = ToneMap::default();
        let (color, shown) = (Vec3::new(2.0, 0.5, 0.1), |pixel: Vec4| over_black(pixel, &map));
        let whole = map.signal(color).as_vec3();
        assert_eq!((shown(color.extend(1.0)), shown((color * 0.25).extend(0.25))), (whole, whole * 0.25));
        assert_ne!(map.signal(color * 0.25).as_vec3(), whole * 0.25);
        // Light that nothing covers, and alpha that is no share.
        for alpha in [0.0, -1.0, 2.0, f32::NAN] {
            assert_eq!(shown(color.extend(alpha)), whole, "{alpha}");
        }
    }
}
