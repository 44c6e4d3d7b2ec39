//! Clips: the frames of an animation as one file that plays. GIF and APNG need nothing else; MP4 holds AV1, encoded by rav1e, with the
//! feature `mp4`, or H.264 by [`ffmpeg`]. Frames come as 8-bit sRGB, one at a time, so that a clip is never in memory as a whole.

mod apng;
pub mod ffmpeg;
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
        let keeps_alpha = self == Self::Apng && options.alpha;
        let mut checked = |frame: u32| {
            let mut pixels = frames(frame)?;
            if pixels.len() != size {
                return Err(io::Error::from(io::ErrorKind::InvalidInput));
            }
            if !keeps_alpha {
                for pixel in pixels.iter_mut().filter(|pixel| pixel[3] < u8::MAX) {
                    let [red, green, blue] = over_black(*pixel);
                    *pixel = [red, green, blue, u8::MAX];
                }
            }
            Ok(pixels)
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

/// Whether pixels of a PNG may be transparent, by what it says at its beginning: one frame that happens to be opaque does not tell.
///
/// # Errors
/// What the operating system or the decoder reports.
#[doc(hidden)]
pub fn has_alpha(path: &Path) -> io::Result<bool> {
    let reader = png::Decoder::new(BufReader::new(File::open(path)?)).read_info().map_err(io::Error::other)?;
    let info = reader.info();
    Ok(info.trns.is_some() || matches!(info.color_type, png::ColorType::Rgba | png::ColorType::GrayscaleAlpha))
}

/// The colour of a pixel in formats where nothing is transparent: before black, as screens blend.
#[doc(hidden)]
pub fn over_black([red, green, blue, alpha]: [u8; 4]) -> [u8; 3] {
    [red, green, blue].map(|channel| ((u32::from(channel) * u32::from(alpha) + 127) / 255) as u8)
}

/// A frame rate as a fraction: whole numbers as they are, those of film and television over 1001, others to a thousandth.
fn fraction(fps: f64) -> (u32, u32) {
    let over = |denominator: u32| (fps * f64::from(denominator)).round();
    for denominator in [1, 1001] {
        let numerator = over(denominator);
        // People write 23.976 and 29.97, which are a millionth below. Over 1001 there are only thousands.
        let is_usual = denominator == 1 || numerator % 1000.0 == 0.0;
        if is_usual && (numerator / f64::from(denominator) - fps).abs() < 2e-6 * fps {
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
        let short = [23.976_f32, 29.97, 59.94, 23.98].map(|fps| fraction(fps.into()));
        assert_eq!(short, [(24_000, 1001), (30_000, 1001), (60_000, 1001), (23_980, 1000)]);
    }

    #[test]
    fn what_is_transparent_stays_so_or_lies_before_black() {
        let half = [200, 100, 51, 128];
        assert_eq!((over_black(half), over_black([200, 100, 51, 255])), ([100, 50, 26], [200, 100, 51]));
        let shown = |format: ClipFormat, alpha: bool| {
            let options = ClipOptions { width: 1, height: 1, frames: 1, fps: 10.0, quality: 80, alpha };
            let folder = tempfile::tempdir().unwrap();
            let path = folder.path().join("clip.png");
            let mut bytes = Vec::new();
            format.encode(&mut bytes, &options, &mut |_| Ok(vec![half])).unwrap();
            if format == ClipFormat::Gif {
                // The palette has the one colour.
                return vec![bytes[13], bytes[14], bytes[15]];
            }
            std::fs::write(&path, bytes).unwrap();
            assert_eq!(has_alpha(&path).unwrap(), alpha);
            read_png(&path).unwrap().2.concat()
        };
        assert_eq!(shown(ClipFormat::Apng, true), half);
        assert_eq!(shown(ClipFormat::Apng, false), [100, 50, 26, 255]);
        assert_eq!(shown(ClipFormat::Gif, true), [100, 50, 26]);
    }

    #[test]
    fn a_frame_of_another_size_is_refused_by_every_format() {
        let options = ClipOptions { width: 16, height: 16, frames: 1, fps: 10.0, quality: 80, alpha: false };
        for format in [ClipFormat::Gif, ClipFormat::Apng, ClipFormat::Mp4] {
            let mut short = |_| Ok(vec![[0; 4]; 16 * 15]);
            assert!(format.encode(Vec::new(), &options, &mut short).is_err(), "{format:?}");
        }
    }

    #[test]
    fn what_the_system_says_of_a_full_disk_stays_what_it_is() {
        /// A disk with room for so many bytes.
        struct Disk(usize);
        impl Write for Disk {
            fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
                self.0 = self.0.checked_sub(bytes.len()).ok_or(io::ErrorKind::StorageFull)?;
                Ok(bytes.len())
            }
            fn flush(&mut self) -> io::Result<()> {
                Ok(())
            }
        }
        let options = ClipOptions { width: 16, height: 16, frames: 2, fps: 10.0, quality: 80, alpha: false };
        let formats = [ClipFormat::Gif, ClipFormat::Apng];
        for format in formats.into_iter().chain(cfg!(feature = "mp4").then_some(ClipFormat::Mp4)) {
            let mut pixels = |frame: u32| Ok(vec![[40 * frame as u8, 9, 200, 255]; 256]);
            let mut whole = Vec::new();
            format.encode(&mut whole, &options, &mut pixels).unwrap();
            // Also where only the last byte has no room.
            for room in [0, whole.len() / 2, whole.len() - 1] {
                let error = format.encode(Disk(room), &options, &mut pixels).unwrap_err();
                assert_eq!(error.kind(), io::ErrorKind::StorageFull, "{format:?}, {room} bytes: {error}");
            }
        }
    }
}
