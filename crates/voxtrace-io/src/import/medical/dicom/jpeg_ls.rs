//! JPEG-LS (ITU-T T.87, 1998), lossless and near-lossless, 2 to 16 bits: each sample is predicted from its neighbours, the
//! error corrected by what contexts have learned and stored as a Golomb code; flat parts are runs. Marker segments are here,
//! `scan` has the samples.

mod bits;
mod scan;

use super::markers::{Markers, word};
use bits::Bits;
use scan::{Coding, Scan};

const START: u8 = 0xd8;
const END: u8 = 0xd9;
const FRAME: u8 = 0xf7;
const PRESETS: u8 = 0xf8;
const SCAN: u8 = 0xda;
const RESTART: u8 = 0xdd;

/// What presets may say (T.87, C.2.4.1); 0 stands for the default.
#[derive(Clone, Copy, Default)]
struct Presets {
    most: u16,
    thresholds: [u16; 3],
    reset: u16,
}

/// What the header of a frame says.
struct Frame {
    precision: u32,
    rows: usize,
    columns: usize,
    /// The numbers that scans call the components by.
    names: Vec<u8>,
}

/// Decodes a picture of `columns` times `rows` pixels: the samples of each component, row by row.
pub(super) fn decode(bytes: &[u8], columns: usize, rows: usize) -> Result<Vec<Vec<u16>>, String> {
    let mut markers = Markers::new(bytes);
    if markers.marker()? != START {
        return Err("no start of a picture".into());
    }
    let (mut frame, mut presets) = (None, Presets::default());
    let mut components: Vec<Option<Vec<u16>>> = Vec::new();
    loop {
        match markers.marker()? {
            FRAME => {
                let found = frame_of(markers.segment()?)?;
                if (found.columns, found.rows) != (columns, rows) {
                    return Err(format!(
                        "a picture of {} x {} in an instance of {columns} x {rows}",
                        found.columns, found.rows
                    ));
                }
                components = vec![None; found.names.len()];
                frame = Some(found);
            }
            PRESETS => presets = presets_of(markers.segment()?)?,
            RESTART if markers.segment()?.iter().any(|&byte| byte != 0) => {
                return Err("restart intervals, which are not read".into());
            }
            SCAN => {
                let frame = frame.as_ref().ok_or("samples before the header of the frame")?;
                let scan = scan_of(markers.segment()?, frame, presets)?;
                let decoded = scan.decode(Bits::new(entropy_coded(&mut markers)))?;
                for (component, samples) in scan.components.iter().zip(decoded) {
                    components[*component] = Some(samples);
                }
                if components.iter().all(Option::is_some) {
                    return Ok(components.into_iter().flatten().collect());
                }
            }
            END => return Err("the picture ends before all of its components".into()),
            RESTART => {}
            _ => drop(markers.segment()?),
        }
    }
}

/// The samples up to the next marker: behind a byte of ones, the highest bit is stuffed with 0.
fn entropy_coded<'a>(markers: &mut Markers<'a>) -> &'a [u8] {
    let rest = markers.rest();
    let end = rest.windows(2).position(|pair| pair[0] == 0xff && pair[1] >= 0x80).unwrap_or(rest.len());
    markers.skip(end);
    &rest[..end]
}

fn frame_of(segment: &[u8]) -> Result<Frame, String> {
    let [precision, r0, r1, c0, c1, count, components @ ..] = segment else {
        return Err("a short header of the frame".into());
    };
    if !(2..=16).contains(precision) || !matches!(count, 1 | 3) || components.len() < 3 * usize::from(*count) {
        return Err(format!("{count} components of {precision} bits"));
    }
    let components = components.as_chunks::<3>().0.iter().take(usize::from(*count));
    if components.clone().any(|component| component[1] != 0x11) {
        return Err("components of different sizes".into());
    }
    let names = components.map(|component| component[0]).collect();
    Ok(Frame { precision: (*precision).into(), rows: word(*r0, *r1), columns: word(*c0, *c1), names })
}

fn presets_of(segment: &[u8]) -> Result<Presets, String> {
    match segment {
        [1, words @ ..] if words.len() >= 10 => {
            let word = |n: usize| u16::from_be_bytes([words[2 * n], words[2 * n + 1]]);
            Ok(Presets { most: word(0), thresholds: [word(1), word(2), word(3)], reset: word(4) })
        }
        _ => Err("presets other than those of the coding, which are not read".into()),
    }
}

fn scan_of(segment: &[u8], frame: &Frame, presets: Presets) -> Result<Scan, String> {
    let (count, rest) = segment.split_first().ok_or("a short header of a scan")?;
    let names = rest.get(..2 * usize::from(*count)).ok_or("a short header of a scan")?;
    let [near, interleave, ..] = rest[names.len()..] else { return Err("a short header of a scan".into()) };
    let mut components = Vec::new();
    for &[name, table] in names.as_chunks::<2>().0 {
        let index = frame.names.iter().position(|&known| known == name).filter(|index| !components.contains(index));
        components.push(index.ok_or_else(|| format!("a component {name} that is not in the frame"))?);
        if table != 0 {
            return Err("samples by a table, which are not read".into());
        }
    }
    let is_possible = match interleave {
        0 => components.len() == 1,
        1 | 2 => !components.is_empty(),
        _ => false,
    };
    if !is_possible {
        return Err(format!("an interleaving {interleave} of {} components", components.len()));
    }
    let coding = Coding::new(frame.precision, near.into(), presets.most, presets.thresholds, presets.reset)?;
    Ok(Scan { columns: frame.columns, rows: frame.rows, components, by_sample: interleave == 2, coding })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The example of T.87, annex H.3: 4 × 4 samples of 8 bits, lossless.
    const EXAMPLE: [u8; 57] = [
        0xff, 0xd8, 0xff, 0xf7, 0x00, 0x0b, 0x08, 0x00, 0x04, 0x00, 0x04, 0x01, 0x01, 0x11, 0x00, 0xff, 0xda, 0x00,
        0x08, 0x01, 0x01, 0x00, 0x00, 0x00, 0x00, 0xc0, 0x00, 0x00, 0x6c, 0x80, 0x20, 0x8e, 0x01, 0xc0, 0x00, 0x00,
        0x57, 0x40, 0x00, 0x00, 0x6e, 0xe6, 0x00, 0x00, 0x01, 0xbc, 0x18, 0x00, 0x00, 0x05, 0xd8, 0x00, 0x00, 0x91,
        0x60, 0xff, 0xd9,
    ];
    const SAMPLES: [u16; 16] = [0, 0, 90, 74, 68, 50, 43, 205, 64, 145, 145, 145, 100, 145, 145, 145];

    #[test]
    fn the_example_of_the_standard_has_its_samples() {
        assert_eq!(decode(&EXAMPLE, 4, 4).unwrap(), [SAMPLES]);
    }

    #[test]
    fn a_picture_that_is_cut_or_of_another_size_is_refused() {
        // The last bytes of the samples may be missing: their bits are taken to be 0.
        for length in 0..EXAMPLE.len() - 12 {
            assert!(decode(&EXAMPLE[..length], 4, 4).is_err(), "{length}");
        }
        assert!(decode(&EXAMPLE, 5, 4).err().unwrap().contains("4 x 4"));
        for (at, byte) in [(6, 1), (6, 17), (11, 2), (13, 0x21), (20, 9), (21, 1), (23, 3)] {
            let mut damaged = EXAMPLE;
            damaged[at] = byte;
            assert!(decode(&damaged, 4, 4).is_err(), "{at}");
        }
    }
}
