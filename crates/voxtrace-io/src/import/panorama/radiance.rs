//! Radiance pictures (`.hdr`): a text header, then scanlines of red, green, blue and a common exponent, plain or run-length encoded, as
//! "Radiance File Formats" (Ward, 1991 to 2019) and Radiance's `color.c` say.

use super::{Picture, check_size};
use voxtrace_scene::glam::Vec3;
use voxtrace_voxelize::Limits;

/// Longest line of a header.
const LONGEST_LINE: usize = 4096;
/// Scanlines of these widths may be encoded channel by channel.
const ENCODED_WIDTHS: std::ops::RangeInclusive<usize> = 8..=0x7fff;

/// The pixels of a Radiance picture.
///
/// # Errors
/// One sentence about what is wrong.
pub fn decode(bytes: &[u8], limits: &Limits) -> Result<Picture, String> {
    let mut rest = bytes;
    let mut exposure = 1.0_f32;
    loop {
        let text = line(&mut rest)?;
        if text.is_empty() {
            break;
        }
        if let Some(format) = text.strip_prefix("FORMAT=") {
            if format.trim() != "32-bit_rle_rgbe" {
                return Err(format!("Radiance: the format {:?}, only 32-bit_rle_rgbe is read", format.trim()));
            }
        } else if let Some(value) = text.strip_prefix("EXPOSURE=") {
            // What the pixels were multiplied by; it may stand several times.
            let value: f32 = value.trim().parse().map_err(|_| "Radiance: the exposure is no number")?;
            exposure *= value;
        }
    }
    if !(exposure.is_normal() && exposure > 0.0) {
        return Err(format!("Radiance: an exposure of {exposure}"));
    }
    let size = line(&mut rest)?.to_owned();
    let words: Vec<&str> = size.split_ascii_whitespace().collect();
    let ["-Y", height, "+X", width] = words[..] else {
        return Err(format!("Radiance: the picture is stored as {size:?}, only -Y H +X W is read"));
    };
    let number = |word: &str| word.parse::<usize>().map_err(|_| format!("Radiance: {word:?} is no size"));
    let (width, height) = (number(width)?, number(height)?);
    check_size(width, height, bytes.len(), limits)?;
    let mut pixels = Vec::with_capacity(width * height);
    let mut scanline = vec![[0; 4]; width];
    for row in 0..height {
        read_scanline(&mut rest, &mut scanline).ok_or_else(|| format!("Radiance: row {row} is cut off or too long"))?;
        pixels.extend(scanline.iter().map(|&rgbe| color(rgbe) / exposure));
    }
    Ok(Picture { width, height, pixels })
}

/// Takes a line of the header.
fn line<'a>(rest: &mut &'a [u8]) -> Result<&'a str, String> {
    let end =
        rest.iter().take(LONGEST_LINE).position(|&byte| byte == b'\n').ok_or("Radiance: the header does not end")?;
    let (line, after) = (&rest[..end], &rest[end + 1..]);
    *rest = after;
    let text = std::str::from_utf8(line).map_err(|_| "Radiance: the header is no text")?;
    Ok(text.trim_end_matches('\r'))
}

/// Takes bytes from the front.
fn take<const N: usize>(rest: &mut &[u8]) -> Option<[u8; N]> {
    let (taken, after) = rest.split_first_chunk::<N>()?;
    *rest = after;
    Some(*taken)
}

/// Reads one scanline, however it is stored. `None` where the bytes end or a run goes beyond it.
fn read_scanline(rest: &mut &[u8], scanline: &mut [[u8; 4]]) -> Option<()> {
    let width = scanline.len();
    let is_encoded = ENCODED_WIDTHS.contains(&width)
        && matches!(**rest, [2, 2, high, low, ..] if usize::from(high) << 8 | usize::from(low) == width);
    if !is_encoded {
        return read_plain(rest, scanline);
    }
    take::<4>(rest)?;
    for channel in 0..4 {
        let mut at = 0;
        while at < width {
            let [count] = take(rest)?;
            let is_run = count > 128;
            let count = usize::from(if is_run { count & 127 } else { count });
            let part = scanline.get_mut(at..at + count).filter(|part| !part.is_empty())?;
            if is_run {
                let [value] = take(rest)?;
                part.iter_mut().for_each(|pixel| pixel[channel] = value);
            } else {
                let (values, after) = rest.split_at_checked(count)?;
                *rest = after;
                part.iter_mut().zip(values).for_each(|(pixel, &value)| pixel[channel] = value);
            }
            at += count;
        }
    }
    Some(())
}

/// Reads a scanline of whole pixels, of which (1, 1, 1, n) repeats the one before; several of them are the bytes of a number.
fn read_plain(rest: &mut &[u8], scanline: &mut [[u8; 4]]) -> Option<()> {
    let (mut at, mut shift) = (0, 0);
    while at < scanline.len() {
        let pixel: [u8; 4] = take(rest)?;
        if let [1, 1, 1, count] = pixel {
            let count = usize::from(count).checked_shl(shift)?;
            let last = *scanline.get(at.checked_sub(1)?)?;
            scanline.get_mut(at..at.checked_add(count)?)?.fill(last);
            (at, shift) = (at + count, shift + 8);
        } else {
            scanline[at] = pixel;
            (at, shift) = (at + 1, 0);
        }
    }
    Some(())
}

/// The colour of a pixel: mantissas below 1 with a common exponent, of which 0 is black.
fn color([red, green, blue, exponent]: [u8; 4]) -> Vec3 {
    if exponent == 0 {
        return Vec3::ZERO;
    }
    // 2^(exponent − 136); the smallest are below what a float of 32 bits holds.
    let scale = f64::from_bits((u64::from(exponent) + 1023 - 136) << 52);
    Vec3::from_array([red, green, blue].map(|mantissa| (f64::from(mantissa) * scale) as f32))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file(header: &str, pixels: &[u8]) -> Vec<u8> {
        [b"#?RADIANCE\n", header.as_bytes(), pixels].concat()
    }

    fn read(header: &str, pixels: &[u8]) -> Result<Vec<Vec3>, String> {
        decode(&file(header, pixels), &Limits::default()).map(|picture| picture.pixels)
    }

    const FORMAT: &str = "FORMAT=32-bit_rle_rgbe\n";

    #[test]
    fn plain_and_encoded_scanlines_are_read() {
        let header = format!("{FORMAT}\n-Y 1 +X 3\n");
        let plain = [[128, 64, 0, 129], [1, 1, 1, 2], [0, 0, 0, 0]].concat();
        let first = Vec3::new(1.0, 0.5, 0.0);
        // One pixel, repeated twice.
        assert_eq!(read(&header, &plain[..8]).unwrap(), [first; 3]);
        let three = [[128, 64, 0, 129], [255, 0, 0, 120], [9, 9, 9, 0]].concat();
        let expected = [first, Vec3::X * 255.0 / 65536.0, Vec3::ZERO];
        assert_eq!(read(&header, &three).unwrap(), expected);
        assert_eq!(read(&format!("EXPOSURE=2\nEXPOSURE=2\n{header}"), &three).unwrap()[0], first * 0.25);
        // Eight pixels: red a run, green three and five values, blue and the exponent runs of two.
        let mut encoded = vec![2, 2, 0, 8, 128 + 8, 128, 3, 1, 2, 3, 5, 4, 5, 6, 7, 8];
        [(0, [128 + 4, 10, 128 + 4, 20]), (1, [128 + 5, 129, 128 + 3, 130])]
            .iter()
            .for_each(|(_, runs)| encoded.extend(runs));
        let pixels = read(&format!("{FORMAT}\n-Y 1 +X 8\n"), &encoded).unwrap();
        assert_eq!(pixels[0], Vec3::new(128.0, 1.0, 10.0) / 128.0);
        assert_eq!(pixels[7], Vec3::new(128.0, 8.0, 20.0) / 64.0);
    }

    #[test]
    fn whatever_is_cut_off_or_foreign_is_refused() {
        let header = format!("{FORMAT}\n-Y 1 +X 8\n");
        let encoded = [2, 2, 0, 8, 136, 1, 136, 2, 136, 3, 136, 129];
        assert!(read(&header, &encoded).is_ok());
        for length in 0..encoded.len() {
            assert!(read(&header, &encoded[..length]).is_err(), "{length}");
        }
        for wrong in [&[2, 2, 0, 8, 0][..], &[2, 2, 0, 8, 137, 1], &[1, 1, 1, 8]] {
            assert!(read(&header, wrong).is_err(), "{wrong:?}");
        }
        for wrong in [
            "FORMAT=32-bit_rle_xyze\n\n-Y 1 +X 8\n",
            "\n+Y 1 +X 8\n",
            "\n-Y 1 +X 0\n",
            "\n-Y 99999999 +X 99999999\n",
            "EXPOSURE=0\n\n-Y 1 +X 8\n",
            "no end",
        ] {
            assert!(read(wrong, &encoded).is_err(), "{wrong}");
        }
    }
}
