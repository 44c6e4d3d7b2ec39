//! Animated PNG (APNG 1.0): every frame whole and lossless, played again and again.

use super::{ClipOptions, Frames, fraction};
use crate::output::png_error;
use std::io::{self, Write};

/// Writes an animated PNG.
pub fn encode(out: impl Write, options: &ClipOptions, frames: Frames) -> io::Result<()> {
    let mut encoder = png::Encoder::new(out, options.width, options.height);
    encoder.set_color(if options.alpha { png::ColorType::Rgba } else { png::ColorType::Rgb });
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    encoder.set_animated(options.frames, 0).map_err(png_error)?;
    // Seconds of a frame, as a fraction of 16-bit numbers.
    let (numerator, denominator) = fraction(options.fps);
    let delay = u16::try_from(denominator).ok().zip(u16::try_from(numerator).ok());
    let milliseconds = || ((1000.0 / options.fps).round().clamp(1.0, 65_535.0) as u16, 1000);
    let (seconds, per) = delay.unwrap_or_else(milliseconds);
    encoder.set_frame_delay(seconds, per).map_err(png_error)?;
    encoder
        .add_text_chunk("Software".into(), concat!("voxtrace ", env!("CARGO_PKG_VERSION")).into())
        .map_err(png_error)?;
    let mut writer = encoder.write_header().map_err(png_error)?;
    for frame in 0..options.frames {
        let pixels = frames(frame)?;
        let bytes: Vec<u8> = match options.alpha {
            true => pixels.into_iter().flatten().collect(),
            false => pixels.into_iter().flat_map(|[red, green, blue, _]| [red, green, blue]).collect(),
        };
        writer.write_image_data(&bytes).map_err(png_error)?;
    }
    writer.finish().map_err(png_error)
}
