//! GIF89a: one palette for the whole clip, so that nothing that stands still changes its colour, and ordered dithering with a pattern that
//! stands still, so that it does not crawl. Where a pixel is what it was, the frame is transparent.
//!
//! The pattern is Bayer's 8 × 8 matrix ("An optimum method for two-level rendition of continuous-tone pictures", 1973).

use super::{ClipOptions, Frames};
use std::collections::HashMap;
use std::io::{self, Write};
use voxtrace_scene::material::srgb_from_linear;
use voxtrace_voxelize::voxelize::colors_of_texels;

/// Colours of the palette; one more entry is transparent.
const COLORS: usize = 255;
const TRANSPARENT: u8 = 255;
/// Pixels that the palette is made of, of all frames together.
const LOOKED_AT: usize = 1 << 20;
/// Largest change by dithering, in steps of sRGB.
const MOST_DITHER: i32 = 24;

/// Writes a GIF.
pub fn encode(out: impl Write, options: &ClipOptions, frames: Frames) -> io::Result<()> {
    let size = |length: u32| u16::try_from(length).map_err(|_| io::Error::from(io::ErrorKind::InvalidInput));
    let (width, height) = (size(options.width)?, size(options.height)?);
    let palette = palette_of(options, frames)?;
    let mut bytes: Vec<u8> = palette.iter().flatten().copied().collect();
    bytes.resize(3 * 256, 0);
    let mut encoder = gif::Encoder::new(out, width, height, &bytes).map_err(into_io)?;
    encoder.set_repeat(gif::Repeat::Infinite).map_err(into_io)?;
    let strength = strength_of(&palette);
    let mut nearest = Nearest { palette: &palette, known: HashMap::new() };
    let mut shown: Vec<u8> = Vec::new();
    for number in 0..options.frames {
        let pixels = frames(number)?;
        let indices: Vec<u8> = (pixels.iter().enumerate())
            .map(|(at, pixel)| nearest.of(dithered(pixel, strength, at % width as usize, at / width as usize)))
            .collect();
        let is_new = |at: usize| shown.get(at) != Some(&indices[at]);
        let buffer: Vec<u8> = (0..indices.len()).map(|at| if is_new(at) { indices[at] } else { TRANSPARENT }).collect();
        let mut frame = gif::Frame { width, height, transparent: Some(TRANSPARENT), ..gif::Frame::default() };
        frame.buffer = buffer.into();
        frame.dispose = gif::DisposalMethod::Keep;
        frame.delay = delay(number, options.fps);
        encoder.write_frame(&frame).map_err(into_io)?;
        shown = indices;
    }
    // Its end is written now: when the encoder is dropped, nobody learns that it could not be.
    encoder.into_inner().map(drop).map_err(into_io)
}

/// The error of the operating system as it is, so that whoever reads its kind is told of a full disk.
fn into_io(error: gif::EncodingError) -> io::Error {
    match error {
        gif::EncodingError::Io(error) => error,
        other => io::Error::other(other),
    }
}

/// Hundredths of a second that a frame is shown: rounded so that the clip as a whole keeps its time.
fn delay(frame: u32, fps: f64) -> u16 {
    let at = |frame: u32| (f64::from(frame) * 100.0 / fps).round();
    // Players take what is shorter than two hundredths for ten.
    (at(frame + 1) - at(frame)).clamp(2.0, 65_535.0) as u16
}

/// The palette of all frames, sRGB.
fn palette_of(options: &ClipOptions, frames: Frames) -> io::Result<Vec<[u8; 3]>> {
    let pixels = options.width as usize * options.height as usize;
    let each = (LOOKED_AT / options.frames as usize).clamp(1, pixels);
    // A step that shares no divisor with the width looks at all columns.
    let step = (pixels / each).max(1) | 1;
    let mut texels = Vec::new();
    for frame in 0..options.frames {
        texels.extend(
            frames(frame)?.into_iter().skip(frame as usize % step).step_by(step).map(|[r, g, b, _]| [r, g, b, 255]),
        );
    }
    let colors = colors_of_texels(&texels, COLORS);
    Ok(colors.into_iter().map(|color| color.to_array().map(srgb_from_linear)).collect())
}

/// How much dithering changes: as much as most colours of the palette are apart from the nearest other one, in steps of sRGB. Where there are
/// colours enough, nothing is to be seen of it.
fn strength_of(palette: &[[u8; 3]]) -> i32 {
    let apart = |one: &[u8; 3], other: &[u8; 3]| (0..3).map(|c| one[c].abs_diff(other[c])).max().unwrap_or(0);
    let others = |at: usize| palette.iter().enumerate().filter(move |&(other, _)| other != at).map(|(_, color)| color);
    let nearest = |at: usize| others(at).map(|other| apart(&palette[at], other)).min().unwrap_or(0);
    let mut distances: Vec<u8> = (0..palette.len()).map(nearest).collect();
    distances.sort_unstable();
    distances.get(distances.len() / 2).map_or(0, |&median| i32::from(median).min(MOST_DITHER))
}

/// A pixel with the pattern on it.
fn dithered(&[red, green, blue, _]: &[u8; 4], strength: i32, x: usize, y: usize) -> [u8; 3] {
    let (x, y) = (x as u32, y as u32);
    // Bits of x xor y and of y, interleaved and in reverse, number the cells of Bayer's matrix.
    let cell = (0..3).fold(0, |cell, bit| cell << 2 | ((x ^ y) >> bit & 1) << 1 | y >> bit & 1);
    let change = (2 * cell as i32 - 63) * strength / 126;
    [red, green, blue].map(|channel| (i32::from(channel) + change).clamp(0, 255) as u8)
}

/// The nearest colours of a palette, those that were asked for remembered.
struct Nearest<'p> {
    palette: &'p [[u8; 3]],
    known: HashMap<[u8; 3], u8>,
}

impl Nearest<'_> {
    fn of(&mut self, color: [u8; 3]) -> u8 {
        // Two steps of sRGB are one colour to the eye, and fewer are looked for.
        let key = color.map(|channel| channel & !1);
        let palette = self.palette;
        *self.known.entry(key).or_insert_with(|| {
            // Weights of the channels in luminance, softened: the eye sees green best.
            let distance = |entry: &[u8; 3]| -> i32 {
                let apart = |channel: usize| (i32::from(entry[channel]) - i32::from(color[channel])).pow(2);
                3 * apart(0) + 6 * apart(1) + 2 * apart(2)
            };
            (0..palette.len()).min_by_key(|&index| distance(&palette[index])).unwrap_or(0) as u8
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_cells_of_the_pattern_are_all_different_and_change_nothing_on_average() {
        let grey = [100, 100, 100, 255];
        let all: Vec<u8> = (0..64).map(|at| dithered(&grey, 12, at % 8, at / 8)[0]).collect();
        let mean = all.iter().map(|&value| f64::from(value)).sum::<f64>() / 64.0;
        assert!((mean - 100.0).abs() < 0.6 && all.iter().min() != all.iter().max(), "{mean}");
        // Neighbours differ: the pattern is fine.
        assert!((0..63).filter(|at| at % 8 != 7).all(|at| all[at] != all[at + 1]));
        // As strong as colours are apart.
        let greys: Vec<[u8; 3]> = (0..25).map(|step| [step * 10; 3]).collect();
        assert_eq!((strength_of(&greys), strength_of(&[[1, 2, 3]]), strength_of(&[])), (10, 0, 0));
    }

    #[test]
    fn a_clip_lasts_as_long_as_its_rate_says() {
        for fps in [10.0, 24.0, 30.0, 12.5] {
            let lasts: u32 = (0..48).map(|frame| u32::from(delay(frame, fps))).sum();
            assert!((f64::from(lasts) - 4800.0 / fps).abs() <= 1.0, "{fps}: {lasts}");
        }
    }
}
