//! Clips: the frames of an animation as one file that plays. GIF and APNG need nothing else; MP4 holds AV1, encoded by rav1e, with the
//! feature `mp4`. Frames come as 8-bit sRGB, one at a time, so that a clip is never in memory as a whole.

mod apng;
mod gif;
#[cfg(feature = "mp4")]
mod mp4;

use std::fs::File;
use std::io::{self, BufReader, Write};
use std::path::Path;

/// Formats of clips.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ClipFormat {
    /// `.mp4`: AV1 in MP4.
    Mp4,
    /// `.gif`: 256 colours.
    Gif,
    /// `.png`, `.apng`: animated PNG, lossless.
    Apng,
}

/// What a clip is like.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClipOptions {
    /// Width, pixels.
    pub width: u32,
    /// Height, pixels.
    pub height: u32,
    /// Number of frames, at least 1.
    pub frames: u32,
    /// Frames a second, > 0.
    pub fps: f64,
    /// Quality from 0 to 100 (MP4).
    pub quality: u8,
    /// Whether pixels may be transparent (APNG).
    pub alpha: bool,
}

/// The pixels of a frame, by its number from 0: red, green, blue and alpha of each, row by row, top to bottom.
pub type Frames<'f> = &'f mut dyn FnMut(u32) -> io::Result<Vec<[u8; 4]>>;

impl ClipFormat {
    /// The format that a file's extension names; `None` for any other.
    pub fn of(path: &Path) -> Option<Self> {
        match path.extension()?.to_str()?.to_ascii_lowercase().as_str() {
            "mp4" => Some(Self::Mp4),
            "gif" => Some(Self::Gif),
            "png" | "apng" => Some(Self::Apng),
            _ => None,
        }
    }

    /// Writes a clip. Frames are asked for in their order; a GIF asks twice.
    ///
    /// # Errors
    /// What the writer or `frames` reports; [`io::ErrorKind::InvalidInput`] for a frame of another size; [`io::ErrorKind::Unsupported`] for MP4
    /// without the feature `mp4`.
    pub fn encode(self, out: impl Write, options: &ClipOptions, frames: Frames) -> io::Result<()> {
        let size = options.width as usize * options.height as usize;
        let mut checked = |frame: u32| {
            let pixels = frames(frame)?;
            if pixels.len() == size { Ok(pixels) } else { Err(io::Error::from(io::ErrorKind::InvalidInput)) }
        };
        match self {
            Self::Gif => gif::encode(out, options, &mut checked),
            Self::Apng => apng::encode(out, options, &mut checked),
            #[cfg(feature = "mp4")]
            Self::Mp4 => mp4::encode(out, options, &mut checked),
            #[cfg(not(feature = "mp4"))]
            Self::Mp4 => Err(io::Error::new(io::ErrorKind::Unsupported, "built without its encoder of MP4")),
        }
    }
}

/// A picture that voxtrace wrote as PNG, of any depth: its width, height and pixels of 8 bits.
///
/// # Errors
/// What the operating system or the decoder reports.
pub fn read_png(path: &Path) -> io::Result<(u32, u32, Vec<[u8; 4]>)> {
    let mut decoder = png::Decoder::new(BufReader::new(File::open(path)?));
    decoder.set_transformations(png::Transformations::normalize_to_color8() | png::Transformations::ALPHA);
    let mut reader = decoder.read_info().map_err(io::Error::other)?;
    let bytes = reader.output_buffer_size().ok_or(io::ErrorKind::OutOfMemory)?;
    let mut pixels = vec![0; bytes];
    let info = reader.next_frame(&mut pixels).map_err(io::Error::other)?;
    let pixels = match info.color_type {
        png::ColorType::Rgba => pixels.chunks_exact(4).map(|pixel| [pixel[0], pixel[1], pixel[2], pixel[3]]).collect(),
        png::ColorType::GrayscaleAlpha => {
            pixels.chunks_exact(2).map(|pixel| [pixel[0], pixel[0], pixel[0], pixel[1]]).collect()
        }
        _ => return Err(io::ErrorKind::InvalidData.into()),
    };
    Ok((info.width, info.height, pixels))
}

/// A frame rate as a fraction: whole numbers as they are, those of film and television over 1001, others to a thousandth.
fn fraction(fps: f64) -> (u32, u32) {
    let over = |denominator: u32| (fps * f64::from(denominator)).round();
    for denominator in [1, 1001] {
        let numerator = over(denominator);
        if (numerator / f64::from(denominator) - fps).abs() < 1e-6 * fps {
            return (numerator as u32, denominator);
        }
    }
    (over(1000).max(1.0) as u32, 1000)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rates_are_fractions_as_players_know_them() {
        assert_eq!(
            (fraction(24.0), fraction(12.5), fraction(30000.0 / 1001.0)),
            ((24, 1), (12_500, 1000), (30_000, 1001))
        );
    }

    #[test]
    fn a_frame_of_another_size_is_refused_by_every_format() {
        let options = ClipOptions { width: 16, height: 16, frames: 1, fps: 10.0, quality: 80, alpha: false };
        for format in [ClipFormat::Gif, ClipFormat::Apng, ClipFormat::Mp4] {
            let mut short = |_| Ok(vec![[0; 4]; 16 * 15]);
            assert!(format.encode(Vec::new(), &options, &mut short).is_err(), "{format:?}");
        }
    }
}
