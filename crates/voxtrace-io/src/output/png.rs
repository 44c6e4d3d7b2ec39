//! PNG pictures (W3C PNG, third edition): 8 or 16 bits a channel, sRGB, straight alpha where the background is
//! transparent, and what is known about the picture as text chunks.

use super::{Metadata, ToneBytes, ToneMap};
use glam::Vec3;
use rayon::prelude::*;
use std::io::{self, Write};
use voxtrace_core::Film;

/// How a film becomes a PNG.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PngOptions {
    /// Exposure and operator.
    pub tone_map: ToneMap,
    /// Bits of a channel.
    pub depth: PngDepth,
    /// Whether to write an alpha channel. The film must then come from a transparent [`voxtrace_core::Frame`].
    pub alpha: bool,
}

/// Bits of a channel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum PngDepth {
    /// 8 bits: for looking at.
    #[default]
    Eight,
    /// 16 bits: for further work.
    Sixteen,
}

/// Writes the region of a film as a PNG.
///
/// # Errors
/// What the writer reports.
pub fn write_png(writer: impl Write, film: &Film, options: &PngOptions, metadata: &Metadata) -> io::Result<()> {
    write(writer, film, None, options, metadata)
}

/// As [`write_png`], with the radiance of `denoised` for the film's, where there is one.
pub fn write(
    writer: impl Write,
    film: &Film,
    denoised: Option<&[Vec3]>,
    options: &PngOptions,
    metadata: &Metadata,
) -> io::Result<()> {
    let mut encoder = png::Encoder::new(writer, film.region.width(), film.region.height());
    encoder.set_color(if options.alpha { png::ColorType::Rgba } else { png::ColorType::Rgb });
    encoder.set_depth(match options.depth {
        PngDepth::Eight => png::BitDepth::Eight,
        PngDepth::Sixteen => png::BitDepth::Sixteen,
    });
    encoder.set_compression(png::Compression::Balanced);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    for (name, text) in metadata.with_tone_map(&options.tone_map).entries() {
        // A tEXt chunk holds Latin-1 and no zero byte; iTXt holds any text.
        let text = text.replace('\0', "");
        let added = if text.is_ascii() {
            encoder.add_text_chunk((*name).into(), text)
        } else {
            encoder.add_itxt_chunk((*name).into(), text)
        };
        added.map_err(into_io)?;
    }
    let mut encoder = encoder.write_header().map_err(into_io)?;
    encoder.write_image_data(&samples(film, denoised, options)).map_err(into_io)?;
    encoder.finish().map_err(into_io)
}

/// The picture's samples as PNG orders them: by row, pixel, channel, high byte first.
fn samples(film: &Film, denoised: Option<&[Vec3]>, options: &PngOptions) -> Vec<u8> {
    let channels = if options.alpha { 4 } else { 3 };
    let bytes = if options.depth == PngDepth::Sixteen { 2 } else { 1 };
    let tone = ToneBytes::new(options.tone_map);
    let mut samples = vec![0; film.pixels.len() * channels * bytes];
    samples.par_chunks_exact_mut(channels * bytes).zip(&film.pixels).enumerate().for_each(|(index, (out, pixel))| {
        let radiance = denoised.map_or_else(|| pixel.mean(), |denoised| denoised[index]);
        let alpha = if options.alpha { pixel.alpha() } else { 1.0 };
        // Straight alpha: the colour of what covers the pixel, not darkened by how little of it that is.
        let color = if alpha > 0.0 { radiance / alpha } else { Vec3::ZERO };
        if options.depth == PngDepth::Sixteen {
            let signal = options.tone_map.signal(color).to_array().into_iter().chain([f64::from(alpha)]);
            for (out, value) in out.chunks_exact_mut(2).zip(signal) {
                out.copy_from_slice(&((value * 65_535.0).round() as u16).to_be_bytes());
            }
        } else {
            let [red, green, blue] = tone.of(color);
            let opacity = (alpha * 255.0).round() as u8;
            out.copy_from_slice(&[red, green, blue, opacity][..channels]);
        }
    });
    samples
}

/// The error of the operating system as it is, so that whoever reads its kind is told of a full disk.
pub fn into_io(error: png::EncodingError) -> io::Error {
    match error {
        png::EncodingError::IoError(error) => error,
        other => io::Error::other(other),
    }
}
