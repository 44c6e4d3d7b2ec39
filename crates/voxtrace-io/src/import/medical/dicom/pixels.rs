//! Pixels of DICOM files as numbers: plain ones of 1 to 64 bits, run lengths (PS3.5, annex G), JPEG by the crate
//! `jpeg-decoder` or with 12 bits, JPEG-LS, and JPEG 2000 by `hayro-jpeg2000`.

use super::elements::{File, Pixels};
use super::pack_bits::unpack_bits;
use super::syntax::{ADVICE, Packing};
use super::tag;
use super::{jpeg_12, jpeg_ls, markers};
use crate::import::images::jpeg_2000;
use crate::import::source::guard::guarded;
use std::path::Path;
use voxtrace_voxelize::{ImportError, ImportErrorKind, Limits};

/// Bytes that may come out of anything.
const FREE: usize = 16 << 20;

/// How the pixels of one file are stored.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Layout {
    pub rows: usize,
    pub columns: usize,
    pub frames: usize,
    /// Numbers of a pixel: 1 or 3.
    samples: usize,
    /// Whether two pixels share their differences from brightness: two numbers for each pixel.
    is_thinned: bool,
    /// Whether each of the numbers has a plane of its own.
    is_planar: bool,
    is_rgb: bool,
    /// Whether three numbers are a brightness and two differences from it.
    is_ycc: bool,
    /// Whether large numbers are dark.
    is_inverted: bool,
    allocated: usize,
    stored: u32,
    shift: u32,
    is_signed: bool,
    is_float: bool,
}

impl Layout {
    /// What the elements say; pixels need not have been read.
    pub fn of(path: &Path, file: &File, limits: &Limits) -> Result<Self, ImportError> {
        let at = file.pixels_at;
        let malformed = |what: &str| ImportError::malformed(path, at, what);
        let unsupported = |what: String| super::unsupported(path, at, what);
        let main = &file.main;
        let short = |tag| main.short(tag).map(usize::from);
        let (Some(rows @ 1..), Some(columns @ 1..)) = (short(tag::ROWS), short(tag::COLUMNS)) else {
            let kind = main.text(tag::MODALITY).map(|modality| format!(" ({modality})")).unwrap_or_default();
            return Err(unsupported(format!("an instance{kind} without a picture: it has no rows and columns")));
        };
        let frames = main.decimal(tag::FRAMES).unwrap_or(1.0);
        if !(1.0..1e9).contains(&frames) || frames.fract() != 0.0 {
            return Err(malformed("an impossible number of frames"));
        }
        let size = rows as u64 * columns as u64;
        if size > limits.points {
            return Err(ImportError::limit(path, Some(at), "pixels of a picture", size, limits.points));
        }
        let samples = short(tag::SAMPLES).unwrap_or(1);
        let photometric = main.text(tag::PHOTOMETRIC).unwrap_or("MONOCHROME2");
        let is_thinned = photometric.contains("422") || photometric.contains("420");
        let is_plain = file.syntax.packing == Packing::None;
        // Of pixels without a compression only pairs along a row are thinned (PS3.3, C.7.6.3.1.2).
        let is_foreign = match file.syntax.packing {
            Packing::None => !photometric.ends_with("422"),
            packing => matches!(packing, Packing::Rle | Packing::JpegLs),
        };
        if !matches!(samples, 1 | 3) || is_thinned && is_foreign {
            return Err(unsupported(format!("pixels of {samples} numbers as {photometric:?}")));
        }
        let is_float = matches!(&file.pixels, Pixels::Plain { tag, .. } if *tag != tag::PIXELS);
        let allocated = short(tag::BITS_ALLOCATED).unwrap_or(16);
        let is_known = matches!(allocated, 1 | 8 | 16 | 32) || is_float && allocated == 64;
        if !is_known {
            return Err(unsupported(format!("pixels of {allocated} bits")));
        }
        let stored = short(tag::BITS_STORED).unwrap_or(allocated).clamp(1, allocated.min(32));
        let high = short(tag::HIGH_BIT).unwrap_or(stored - 1).clamp(stored - 1, allocated - 1);
        Ok(Self {
            rows,
            columns,
            frames: frames as usize,
            samples,
            is_thinned: is_thinned && is_plain && samples == 3,
            is_planar: main.short(tag::PLANAR) == Some(1),
            is_rgb: photometric == "RGB",
            is_ycc: photometric.starts_with("YBR_FULL") || photometric.starts_with("YBR_PARTIAL"),
            is_inverted: photometric == "MONOCHROME1",
            allocated,
            stored: stored as u32,
            shift: (high + 1 - stored) as u32,
            is_signed: main.short(tag::SIGNED) == Some(1),
            is_float,
        })
    }

    fn pixels(&self) -> usize {
        self.rows * self.columns
    }

    /// The frames as numbers, row by row, without rescaling.
    pub fn decode(&self, path: &Path, file: &File, limits: &Limits) -> Result<Vec<Vec<f32>>, ImportError> {
        let at = file.pixels_at;
        match &file.pixels {
            Pixels::Absent => Err(super::without_pixels(path, file, at)),
            Pixels::Plain { bytes, are_words, .. } => {
                // Bytes that were written as words are turned with them.
                let turned = (file.syntax.big_endian && *are_words && self.allocated <= 8).then(|| turned(bytes));
                let bytes = turned.as_ref().unwrap_or(bytes);
                let numbers = if self.is_thinned { 2 } else { self.samples };
                let count = (self.pixels() as u64).saturating_mul(self.frames as u64);
                let bits = count.saturating_mul((numbers * self.allocated) as u64);
                if (bytes.len() as u64) < bits.div_ceil(8) {
                    let what = format!("{} bytes of pixels where {} are needed", bytes.len(), bits.div_ceil(8));
                    return Err(ImportError::malformed(path, at, what));
                }
                let size = self.pixels() * numbers * self.allocated / 8;
                let frame = |n: usize| match self.allocated {
                    1 => self.bits(bytes, n),
                    _ if self.is_thinned => self.pairs(&bytes[n * size..(n + 1) * size], file.syntax.big_endian),
                    _ => self.numbers(&bytes[n * size..(n + 1) * size], file.syntax.big_endian, self.is_planar),
                };
                Ok((0..self.frames).map(frame).collect())
            }
            Pixels::Pieces(pieces) => {
                let frames = self.packed_frames(path, at, pieces)?;
                let malformed = ImportErrorKind::Malformed;
                let unpack = |packed: &Vec<u8>| {
                    self.check_growth(packed.len(), limits).map_err(malformed)?;
                    match file.syntax.packing {
                        Packing::Rle => self.run_lengths(packed).map_err(malformed),
                        Packing::Jpeg if jpeg_12::is_such(packed) => {
                            guarded(|| self.jpeg_12(packed)).map_err(malformed)
                        }
                        Packing::Jpeg => self.jpeg(packed),
                        Packing::JpegLs => guarded(|| self.jpeg_ls(packed)).map_err(malformed),
                        Packing::Jpeg2000 => guarded(|| self.jpeg_2000(packed)).map_err(malformed),
                        Packing::None => Err(malformed("pixels in pieces, but not compressed".into())),
                    }
                };
                frames.iter().map(|packed| unpack(packed).map_err(|kind| ImportError::at(path, at, kind))).collect()
            }
        }
    }

    fn check_growth(&self, packed: usize, limits: &Limits) -> Result<(), String> {
        let size = self.pixels() * self.samples * self.allocated.div_ceil(8);
        if size as u64 > limits.bytes || size > FREE && size as u64 / limits.ratio.max(1) > packed as u64 {
            return Err(format!("{size} bytes of pixels from {packed} are more than allowed"));
        }
        Ok(())
    }

    /// The compressed data of each frame.
    fn packed_frames(&self, path: &Path, at: u64, pieces: &[Vec<u8>]) -> Result<Vec<Vec<u8>>, ImportError> {
        let Some((table, data)) = pieces.split_first() else {
            return Err(ImportError::malformed(path, at, "an instance without pixels"));
        };
        if data.len() == self.frames {
            return Ok(data.to_vec());
        }
        // Where a piece begins that begins a frame: by the table, or by the mark of JPEG.
        let offsets: Vec<u32> = table.as_chunks().0.iter().map(|&bytes| u32::from_le_bytes(bytes)).collect();
        let mut frames: Vec<Vec<u8>> = Vec::new();
        let mut place = 0u64;
        for piece in data {
            let is_first = if self.frames == 1 {
                frames.is_empty()
            } else if offsets.len() == self.frames {
                offsets.iter().any(|&offset| u64::from(offset) == place)
            } else {
                piece.starts_with(&[0xff, 0xd8])
            };
            if is_first {
                frames.push(Vec::new());
            }
            if let Some(frame) = frames.last_mut() {
                frame.extend_from_slice(piece);
            }
            place += 8 + piece.len() as u64;
        }
        if frames.len() != self.frames {
            let what = format!("compressed pixels of {} frames where there are {}", frames.len(), self.frames);
            return Err(ImportError::malformed(path, at, what));
        }
        Ok(frames)
    }

    /// Pixels of one bit, the lowest first.
    fn bits(&self, bytes: &[u8], frame: usize) -> Vec<f32> {
        let first = frame * self.pixels();
        (first..first + self.pixels()).map(|n| f32::from(bytes[n / 8] >> (n % 8) & 1)).collect()
    }

    fn number(&self, bytes: &[u8], big_endian: bool, at: usize) -> f32 {
        let size = self.allocated / 8;
        let bytes = &bytes[at * size..(at + 1) * size];
        let join = |raw: u64, byte: &u8| raw << 8 | u64::from(*byte);
        let raw = if big_endian { bytes.iter().fold(0, join) } else { bytes.iter().rev().fold(0, join) };
        if self.is_float { float(raw, size) } else { self.whole(raw as u32) }
    }

    fn numbers(&self, bytes: &[u8], big_endian: bool, is_planar: bool) -> Vec<f32> {
        self.grey(|at| self.number(bytes, big_endian, at), is_planar)
    }

    /// The brightness of pairs of pixels: two, and the two differences that they share.
    fn pairs(&self, bytes: &[u8], big_endian: bool) -> Vec<f32> {
        (0..self.pixels()).map(|n| self.number(bytes, big_endian, n / 2 * 4 + n % 2)).collect()
    }

    /// A number from the bits that hold it.
    fn whole(&self, raw: u32) -> f32 {
        let free = 32 - self.stored;
        let bits = (raw >> self.shift) << free;
        match (self.is_signed, self.is_inverted) {
            (true, _) => (bits as i32 >> free) as f32,
            (false, true) => (u32::MAX >> free).wrapping_sub(bits >> free) as f32,
            (false, false) => (bits >> free) as f32,
        }
    }

    /// One number for each pixel: the brightness of colours.
    fn grey(&self, number: impl Fn(usize) -> f32, is_planar: bool) -> Vec<f32> {
        let count = self.pixels();
        let at = |pixel: usize, channel: usize| {
            if is_planar { channel * count + pixel } else { pixel * self.samples + channel }
        };
        let pixel = |n: usize| {
            if self.samples == 3 && self.is_rgb {
                brightness([0, 1, 2].map(|channel| number(at(n, channel))))
            } else {
                number(at(n, 0))
            }
        };
        (0..count).map(pixel).collect()
    }

    fn run_lengths(&self, packed: &[u8]) -> Result<Vec<f32>, String> {
        let word =
            |n: usize| packed.get(4 * n..4 * n + 4).and_then(|b| b.first_chunk()).map(|b| u32::from_le_bytes(*b));
        let planes = self.samples * self.allocated.div_ceil(8);
        let count = word(0).ok_or("a frame of run lengths without a header")? as usize;
        if count != planes || count > 15 {
            return Err(format!("{count} segments of run lengths where there are {planes}"));
        }
        let size = self.pixels();
        // Each plane is one byte of a number, the highest first; put them back the lowest first.
        let bytes_each = self.allocated / 8;
        let mut bytes = vec![0; planes * size];
        for plane in 0..planes {
            let start = word(plane + 1).ok_or("a frame of run lengths without a header")? as usize;
            let end = if plane + 1 < planes { word(plane + 2).map(|end| end as usize) } else { None };
            let segment = packed.get(start..end.unwrap_or(packed.len()).min(packed.len()));
            let unpacked = unpack_bits(segment.ok_or("run lengths outside of their frame")?, size)?;
            let (channel, byte) = (plane / bytes_each, bytes_each - 1 - plane % bytes_each);
            for (n, value) in unpacked.into_iter().enumerate() {
                bytes[(channel * size + n) * bytes_each + byte] = value;
            }
        }
        Ok(self.numbers(&bytes, false, true))
    }

    fn jpeg_ls(&self, packed: &[u8]) -> Result<Vec<f32>, String> {
        let picture = jpeg_ls::decode(packed, self.columns, self.rows).map_err(|fault| format!("JPEG-LS: {fault}"))?;
        Ok(self.of_components(&picture))
    }

    fn jpeg_12(&self, packed: &[u8]) -> Result<Vec<f32>, String> {
        let picture = jpeg_12::decode(packed, self.columns, self.rows).map_err(|fault| format!("JPEG: {fault}"))?;
        Ok(self.of_components(&picture))
    }

    /// Numbers from the samples of each component; the first of YCbCr is the brightness.
    fn of_components(&self, components: &[Vec<u16>]) -> Vec<f32> {
        match components {
            [red, green, blue] if self.is_rgb => {
                let channels = red.iter().zip(green).zip(blue);
                channels.map(|((&r, &g), &b)| brightness([r, g, b].map(f32::from))).collect()
            }
            [first, ..] => first.iter().map(|&sample| self.whole(sample.into())).collect(),
            [] => Vec::new(),
        }
    }

    fn jpeg_2000(&self, packed: &[u8]) -> Result<Vec<f32>, String> {
        let picture =
            jpeg_2000::decode(packed, self.columns, self.rows).map_err(|fault| format!("JPEG 2000: {fault}"))?;
        Ok(match &picture.components[..] {
            // Luma and chroma, which the codestream knows nothing of.
            [first, _, _] if self.is_ycc && !picture.was_mixed => first.iter().map(|&sample| sample as f32).collect(),
            // The decoder has undone what the codestream says about colours.
            [red, green, blue] => {
                let channels = red.iter().zip(green).zip(blue);
                channels.map(|((&r, &g), &b)| brightness([r, g, b].map(|sample| sample as f32))).collect()
            }
            [first] => first.iter().map(|&sample| self.whole(sample as u32)).collect(),
            others => return Err(format!("JPEG 2000: {} components", others.len())),
        })
    }

    fn jpeg(&self, packed: &[u8]) -> Result<Vec<f32>, ImportErrorKind> {
        let mut is_foreign = false;
        let pixels = guarded(|| {
            let mut text = |error: jpeg_decoder::Error| {
                let advice = if matches!(error, jpeg_decoder::Error::Unsupported(_)) {
                    is_foreign = true;
                    format!("; {ADVICE}")
                } else {
                    String::new()
                };
                format!("JPEG: {error}{advice}")
            };
            let mut decoder = jpeg_decoder::Decoder::new(packed);
            decoder.set_max_decoding_buffer_size(self.pixels() * 4);
            decoder.read_info().map_err(&mut text)?;
            let info = decoder.info().ok_or("JPEG: no header")?;
            if info.pixel_format == jpeg_decoder::PixelFormat::RGB24 {
                // The samples as they are: what they mean, the file says.
                decoder.set_color_transform(jpeg_decoder::ColorTransform::RGB);
            }
            let size = (usize::from(info.height), usize::from(info.width));
            if size != (self.rows, self.columns) {
                return Err(format!(
                    "JPEG: a picture of {} x {} in an instance of {} x {}",
                    size.1, size.0, self.columns, self.rows
                ));
            }
            let bytes = decoder.decode().map_err(&mut text)?;
            let needed = self.pixels() * info.pixel_format.pixel_bytes();
            if bytes.len() < needed {
                return Err("JPEG: the picture is not whole".into());
            }
            match info.pixel_format {
                jpeg_decoder::PixelFormat::L8 => {
                    Ok(bytes[..needed].iter().map(|&byte| self.whole(byte.into())).collect())
                }
                jpeg_decoder::PixelFormat::L16 => {
                    let numbers = bytes[..needed].as_chunks().0.iter();
                    Ok(numbers.map(|&bytes| self.whole(u16::from_ne_bytes(bytes).into())).collect())
                }
                jpeg_decoder::PixelFormat::RGB24 => {
                    let colors = bytes[..needed].as_chunks::<3>().0.iter();
                    let is_rgb = self.is_rgb && !markers::says_ycc(packed);
                    let grey = |color: [u8; 3]| if is_rgb { brightness(color.map(f32::from)) } else { color[0].into() };
                    Ok(colors.map(|&color| grey(color)).collect())
                }
                jpeg_decoder::PixelFormat::CMYK32 => Err("JPEG: four colours".into()),
            }
        });
        pixels.map_err(if is_foreign { ImportErrorKind::Unsupported } else { ImportErrorKind::Malformed })
    }
}

/// Bytes turned in pairs.
fn turned(bytes: &[u8]) -> Vec<u8> {
    let mut turned = bytes.to_vec();
    turned.as_chunks_mut::<2>().0.iter_mut().for_each(|pair| pair.reverse());
    turned
}

/// The brightness of red, green and blue (ITU-R BT.601).
pub(super) fn brightness([red, green, blue]: [f32; 3]) -> f32 {
    0.299 * red + 0.587 * green + 0.114 * blue
}

fn float(raw: u64, size: usize) -> f32 {
    if size == 8 { f64::from_bits(raw) as f32 } else { f32::from_bits(raw as u32) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_is_cut_out_of_its_bits_with_its_sign() {
        let layout = Layout {
            rows: 1,
            columns: 1,
            frames: 1,
            samples: 1,
            is_thinned: false,
            is_planar: false,
            is_rgb: false,
            is_ycc: false,
            is_inverted: false,
            allocated: 16,
            stored: 12,
            shift: 4,
            is_signed: true,
            is_float: false,
        };
        assert_eq!(layout.whole(0xfff7), -1.0);
        assert_eq!(layout.whole(0x7ff0), 2047.0);
        assert_eq!(Layout { is_signed: false, ..layout }.whole(0xfff7), 4095.0);
        assert_eq!(Layout { is_signed: false, is_inverted: true, ..layout }.whole(0x0017), 4094.0);
        assert_eq!(layout.numbers(&[0x00, 0x12], true, false), [1.0]);
    }
}
