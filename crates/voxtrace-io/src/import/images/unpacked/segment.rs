//! Strips and tiles in compressions that the crate `tiff` does not read: Zstandard (libtiff, 50000) and JPEG 2000 (Aperio's 33003, of luma
//! and chroma, and 33005; Leica's 34712).

use super::directory::Order;
use crate::import::images::jpeg_2000;
use crate::import::source::zstd::zstd_start;

/// How the bytes of a segment are made of those in the file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Packing {
    /// They are the same.
    Copied,
    Zstd,
    Jpeg2000 {
        /// Whether the three components are luma and chroma.
        is_luma_chroma: bool,
    },
}

impl Packing {
    /// What a value of the tag `Compression` means.
    pub fn of(compression: u64) -> Self {
        match compression {
            50_000 | 34_926 => Self::Zstd,
            33_003 => Self::Jpeg2000 { is_luma_chroma: true },
            33_005 | 34_712 => Self::Jpeg2000 { is_luma_chroma: false },
            _ => Self::Copied,
        }
    }
}

/// What a segment is.
#[derive(Clone, Copy, Debug)]
pub struct Shape {
    /// Pixels.
    pub width: u64,
    pub height: u64,
    /// Samples of a pixel.
    pub channels: u64,
    /// Bits of a sample.
    pub bits: u64,
}

impl Shape {
    /// Bytes of the samples, each row from a byte on; `None` where they cannot be counted.
    pub fn size(&self) -> Option<u64> {
        let row = self.width.checked_mul(self.channels)?.checked_mul(self.bits)?.div_ceil(8);
        row.checked_mul(self.height)
    }
}

/// The samples of a segment.
///
/// # Errors
/// What is wrong with it.
pub fn unpack(packing: Packing, shape: &Shape, packed: &[u8], order: Order) -> Result<Vec<u8>, String> {
    let size = shape.size().and_then(|size| usize::try_from(size).ok()).ok_or("too large")?;
    // GDAL leaves out what is empty.
    if packed.is_empty() {
        return Ok(vec![0; size]);
    }
    match packing {
        Packing::Copied => Ok(packed.to_vec()),
        Packing::Zstd => {
            // Rows that pad the last strip may follow.
            let samples = zstd_start(packed, size as u64).map_err(|fault| format!("Zstandard: {fault}"))?;
            match samples.len() == size {
                true => Ok(samples),
                false => Err(format!("Zstandard: {} bytes of {size}", samples.len())),
            }
        }
        Packing::Jpeg2000 { is_luma_chroma } => {
            jpeg_2000_samples(packed, shape, order, is_luma_chroma).map_err(|fault| format!("JPEG 2000: {fault}"))
        }
    }
}

fn jpeg_2000_samples(packed: &[u8], shape: &Shape, order: Order, is_luma_chroma: bool) -> Result<Vec<u8>, String> {
    let mut picture = jpeg_2000::decode(packed, shape.width as usize, shape.height as usize)?;
    if picture.components.len() as u64 != shape.channels {
        return Err(format!("{} components where there should be {}", picture.components.len(), shape.channels));
    }
    if let ([luma, blue, red], true) = (&mut picture.components[..], is_luma_chroma && !picture.was_mixed) {
        for ((luma, blue), red) in luma.iter_mut().zip(blue).zip(red) {
            [*luma, *blue, *red] = red_green_blue([*luma, *blue, *red]);
        }
    }
    let bytes = match shape.bits {
        bits @ (8 | 16 | 32) => bits as usize / 8,
        bits => return Err(format!("samples of {bits} bits")),
    };
    let mut samples = Vec::with_capacity(bytes * shape.channels as usize * picture.components[0].len());
    for pixel in 0..picture.components[0].len() {
        for component in &picture.components {
            let sample = order.bytes::<4>(component[pixel] as u64);
            samples.extend(if order.is_big { &sample[4 - bytes..] } else { &sample[..bytes] });
        }
    }
    Ok(samples)
}

/// The colour of a luma and its chroma of eight bits (ITU-T T.871).
fn red_green_blue(pixel: [i32; 3]) -> [i32; 3] {
    let [luma, blue, red] = pixel.map(|sample| sample as f32);
    let (blue, red) = (blue - 128.0, red - 128.0);
    [luma + 1.402 * red, luma - 0.344_136 * blue - 0.714_136 * red, luma + 1.772 * blue]
        .map(|sample| (sample.round() as i32).clamp(0, 255))
}
