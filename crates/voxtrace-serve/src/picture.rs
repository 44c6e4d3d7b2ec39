//! Films as pictures for browsers.

use rayon::prelude::*;
use std::io;
use std::ops::Range;
use voxtrace::glam::Vec3;
use voxtrace::output::{ToneBytes, ToneMap};

/// Edge of the blocks of a JPEG without subsampling, pixels.
const BLOCK: u32 = 8;
/// Rows of pixels that a thread codes at a time: whole blocks.
const STRIPE: u32 = 64;
/// Second bytes of markers (ITU-T T.81, table B.1); those of restarts have their number in the lowest bits.
const BASELINE_FRAME: u8 = 0xC0;
const RESTART: u8 = 0xD0;
const END_OF_IMAGE: u8 = 0xD9;
const START_OF_SCAN: u8 = 0xDA;

/// What a screen shows: red, green and blue of sRGB, a byte each, row by row.
pub struct Shown {
    pub width: u32,
    pub height: u32,
    pub samples: Vec<u8>,
}

impl Shown {
    /// Of the mean radiance of each pixel, by the tone mapping of pictures that are saved.
    pub fn new(width: u32, height: u32, radiance: impl Fn(usize) -> Vec3 + Sync) -> Self {
        let tone = ToneBytes::new(ToneMap::default());
        let mut samples = vec![0; width as usize * height as usize * 3];
        samples.par_chunks_exact_mut(3).with_min_len(1024).enumerate().for_each(|(index, pixel)| {
            pixel.copy_from_slice(&tone.of(radiance(index)));
        });
        Self { width, height, samples }
    }

    /// As a JPEG of that quality, 1 to 100, behind what `bytes` has already. Threads code stripes of it, each of which begins anew behind a restart
    /// marker (ITU-T T.81, E.1.4); pixels are those of a file without.
    pub fn append_jpeg(&self, bytes: &mut Vec<u8>, quality: u8) -> io::Result<()> {
        let (width, height) = (length(self.width)?, length(self.height)?);
        let blocks_a_stripe = u16::try_from(self.width.div_ceil(BLOCK) * (STRIPE / BLOCK)).map_err(io::Error::other)?;
        let stripes: io::Result<Vec<Vec<u8>>> = self
            .samples
            .par_chunks((self.width * STRIPE * 3) as usize)
            .map(|samples| {
                let mut stripe = Vec::with_capacity(samples.len() / 4);
                let mut encoder = jpeg_encoder::Encoder::new(&mut stripe, quality);
                // Voxels are small and of strong colours: these must not run.
                encoder.set_sampling_factor(jpeg_encoder::SamplingFactor::R_4_4_4);
                encoder.set_restart_interval(blocks_a_stripe);
                let rows = length((samples.len() / 3) as u32 / self.width)?;
                encoder.encode(samples, width, rows, jpeg_encoder::ColorType::Rgb).map_err(io::Error::other)?;
                Ok(stripe)
            })
            .collect();
        for (index, stripe) in stripes?.iter().enumerate() {
            let parts =
                JpegParts::of(stripe).ok_or_else(|| io::Error::other("the encoder writes no JPEG of one scan"))?;
            if index == 0 {
                let start = bytes.len();
                bytes.extend(&stripe[..parts.scan.start]);
                bytes[start + parts.height..][..2].copy_from_slice(&height.to_be_bytes());
            } else {
                bytes.extend([0xFF, RESTART | ((index - 1) % 8) as u8]);
            }
            bytes.extend(&stripe[parts.scan]);
        }
        bytes.extend([0xFF, END_OF_IMAGE]);
        Ok(())
    }

    /// As a PNG, without loss, behind what `bytes` has already.
    pub fn append_png(&self, bytes: &mut Vec<u8>) -> io::Result<()> {
        let mut encoder = png::Encoder::new(bytes, self.width, self.height);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_compression(png::Compression::Fast);
        let mut writer = encoder.write_header().map_err(io::Error::other)?;
        writer.write_image_data(&self.samples).map_err(io::Error::other)?;
        writer.finish().map_err(io::Error::other)
    }
}

/// A length of a JPEG, which has 16 bits.
fn length(pixels: u32) -> io::Result<u16> {
    u16::try_from(pixels).map_err(io::Error::other)
}

/// Where a JPEG of one scan has what is taken from it.
struct JpegParts {
    /// The height of the picture.
    height: usize,
    /// The coded blocks.
    scan: Range<usize>,
}

impl JpegParts {
    /// `None` where it is none.
    fn of(file: &[u8]) -> Option<Self> {
        let (mut at, mut height) = (2, None);
        loop {
            let [0xFF, marker, high, low] = *file.get(at..)?.first_chunk()? else { return None };
            let next = at + 2 + usize::from(u16::from_be_bytes([high, low]));
            match marker {
                // Marker, length and precision come before it.
                BASELINE_FRAME => height = Some(at + 5),
                START_OF_SCAN => {
                    let end = file.len().checked_sub(2)?;
                    return file.ends_with(&[0xFF, END_OF_IMAGE]).then_some(Self { height: height?, scan: next..end });
                }
                _ => {}
            }
            at = next;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A picture of strong colours and fine detail.
    fn shown(width: u32, height: u32) -> Shown {
        Shown::new(width, height, |index| {
            let (x, y) = (index as u32 % width, index as u32 / width);
            Vec3::new((x % 7) as f32 / 7.0, (y % 5) as f32 / 3.0, ((x ^ y) % 64) as f32 / 32.0)
        })
    }

    fn decoded(jpeg: &[u8]) -> (usize, usize, Vec<u8>) {
        let mut decoder = zune_jpeg::JpegDecoder::new(io::Cursor::new(jpeg));
        let pixels = decoder.decode().unwrap();
        let (width, height) = decoder.dimensions().unwrap();
        (width, height, pixels)
    }

    #[test]
    fn a_jpeg_in_stripes_has_the_pixels_of_one_without() {
        // Whole stripes and blocks, and not; more of them than there are numbers of restarts.
        for (width, height) in [(64, 64), (67, 130), (1, 1), (16, 700), (200, 65)] {
            let shown = shown(width, height);
            let (mut stripes, mut whole) = (vec![1, 2, 3], Vec::new());
            shown.append_jpeg(&mut stripes, 80).unwrap();
            assert_eq!(stripes[..3], [1, 2, 3]);
            let mut encoder = jpeg_encoder::Encoder::new(&mut whole, 80);
            encoder.set_sampling_factor(jpeg_encoder::SamplingFactor::R_4_4_4);
            encoder.encode(&shown.samples, width as u16, height as u16, jpeg_encoder::ColorType::Rgb).unwrap();
            let expected = decoded(&whole);
            assert_eq!((expected.0, expected.1), (width as usize, height as usize));
            assert!(decoded(&stripes[3..]) == expected, "{width} x {height}");
            let restarts = stripes.windows(2).filter(|pair| pair[0] == 0xFF && pair[1] & 0xF8 == RESTART).count();
            assert_eq!(restarts as u32, height.div_ceil(STRIPE) - 1);
        }
    }

    #[test]
    fn what_is_no_jpeg_of_one_scan_has_no_parts() {
        let mut file = Vec::new();
        shown(20, 20).append_jpeg(&mut file, 80).unwrap();
        let parts = JpegParts::of(&file).unwrap();
        assert_eq!(file[parts.height..][..2], [0, 20]);
        for end in 0..file.len() {
            assert!(JpegParts::of(&file[..end]).is_none(), "{end}");
        }
        assert!(JpegParts::of(b"GIF89a").is_none());
    }
}
