//! JPEG with 12 bits a sample, sequential and with Huffman codes (ITU-T T.81, 1992, its extended process): what DICOM calls
//! "extended". Of 8 bits and lossless ones the crate `jpeg-decoder` takes care.

mod huffman;

use super::markers::{Markers, word};
use huffman::{Bits, Codes, huffman_codes};

/// Order in which the coefficients of a block are stored (T.81, figure A.6).
const ZIGZAG: [usize; 64] = [
    0, 1, 8, 16, 9, 2, 3, 10, 17, 24, 32, 25, 18, 11, 4, 5, 12, 19, 26, 33, 40, 48, 41, 34, 27, 20, 13, 6, 7, 14, 21,
    28, 35, 42, 49, 56, 57, 50, 43, 36, 29, 22, 15, 23, 30, 37, 44, 51, 58, 59, 52, 45, 38, 31, 39, 46, 53, 60, 61, 54,
    47, 55, 62, 63,
];
/// The sample in the middle, and the highest one.
const MIDDLE: f32 = 2048.0;
const MOST: f32 = 4095.0;

const START: u8 = 0xd8;
const END: u8 = 0xd9;
const BASELINE: u8 = 0xc0;
const EXTENDED: u8 = 0xc1;
const HUFFMAN: u8 = 0xc4;
const QUANTIZATION: u8 = 0xdb;
const INTERVAL: u8 = 0xdd;
const SCAN: u8 = 0xda;

/// Whether a picture has 12 bits a sample and is sequential.
pub(super) fn is_such(bytes: &[u8]) -> bool {
    let mut markers = Markers::new(bytes);
    while let Ok(marker) = markers.marker() {
        match marker {
            START => {}
            BASELINE | EXTENDED => return markers.segment().is_ok_and(|segment| segment.first() == Some(&12)),
            SCAN | END => return false,
            _ if markers.segment().is_err() => return false,
            _ => {}
        }
    }
    false
}

/// Decodes a picture of `columns` times `rows` pixels: the samples of each component, row by row.
pub(super) fn decode(bytes: &[u8], columns: usize, rows: usize) -> Result<Vec<Vec<u16>>, String> {
    let mut markers = Markers::new(bytes);
    let mut quantization = [[0u16; 64]; 4];
    let mut codes: [[Option<Codes>; 4]; 2] = Default::default();
    let (mut frame, mut interval) = (None, 0);
    loop {
        match markers.marker()? {
            START => {}
            QUANTIZATION => quantizations(markers.segment()?, &mut quantization)?,
            HUFFMAN => huffman_codes(markers.segment()?, &mut codes)?,
            BASELINE | EXTENDED => {
                let found = Frame::of(markers.segment()?)?;
                if (found.columns, found.rows) != (columns, rows) {
                    let Frame { columns: width, rows: height, .. } = found;
                    return Err(format!("a picture of {width} x {height} in an instance of {columns} x {rows}"));
                }
                frame = Some(found);
            }
            INTERVAL => {
                let segment = markers.segment()?;
                interval = segment.first_chunk().map_or(0, |&count| usize::from(u16::from_be_bytes(count)));
            }
            SCAN => {
                let frame = frame.ok_or("samples before the header of the frame")?;
                let segment = markers.segment()?;
                let scan = Scan { frame, quantization: &quantization, codes: &codes, interval };
                return scan.decode(segment, markers.rest());
            }
            END => return Err("a picture without samples".into()),
            0xc2..=0xcf => return Err("a process that is not sequential".into()),
            _ => drop(markers.segment()?),
        }
    }
}

fn quantizations(mut segment: &[u8], tables: &mut [[u16; 64]; 4]) -> Result<(), String> {
    while let Some((&head, rest)) = segment.split_first() {
        let width = if head >> 4 == 0 { 1 } else { 2 };
        let numbers = rest.get(..64 * width).ok_or("a short table of quantization")?;
        let table = tables.get_mut(usize::from(head & 15)).ok_or("a fifth table of quantization")?;
        for (entry, bytes) in table.iter_mut().zip(numbers.chunks_exact(width)) {
            *entry = bytes.iter().fold(0, |number, &byte| number << 8 | u16::from(byte));
        }
        segment = &rest[64 * width..];
    }
    Ok(())
}

struct Component {
    name: u8,
    /// Blocks of an interleaved unit, along columns and rows.
    blocks: [usize; 2],
    quantization: usize,
}

struct Frame {
    rows: usize,
    columns: usize,
    components: Vec<Component>,
}

impl Frame {
    fn of(segment: &[u8]) -> Result<Self, String> {
        let [precision, r0, r1, c0, c1, count, components @ ..] = segment else {
            return Err("a short header of the frame".into());
        };
        if *precision != 12 || !matches!(count, 1 | 3) {
            return Err(format!("{count} components of {precision} bits"));
        }
        let parts = components.as_chunks::<3>().0.iter().take(usize::from(*count));
        let components: Vec<Component> = parts
            .map(|&[name, blocks, quantization]| Component {
                name,
                blocks: [blocks >> 4, blocks & 15].map(usize::from),
                quantization: usize::from(quantization & 3),
            })
            .collect();
        let is_good = |component: &Component| component.blocks.iter().all(|blocks| (1..=4).contains(blocks));
        if components.len() != usize::from(*count) || !components.iter().all(is_good) {
            return Err("impossible components".into());
        }
        Ok(Self { rows: word(*r0, *r1), columns: word(*c0, *c1), components })
    }
}

struct Scan<'a> {
    frame: Frame,
    quantization: &'a [[u16; 64]; 4],
    codes: &'a [[Option<Codes>; 4]; 2],
    /// Units between restarts; 0 where there are none.
    interval: usize,
}

/// A component while it is decoded.
struct Plane<'a> {
    component: &'a Component,
    codes: [&'a Codes; 2],
    blocks: [usize; 2],
    width: usize,
    samples: Vec<u16>,
    /// The last block's mean.
    last: i32,
}

impl Scan<'_> {
    fn decode(&self, head: &[u8], data: &[u8]) -> Result<Vec<Vec<u16>>, String> {
        let Frame { rows, columns, components } = &self.frame;
        let count = components.len();
        let (Some((&announced, rest)), true) = (head.split_first(), head.len() > 2 * count) else {
            return Err("a short header of a scan".into());
        };
        if usize::from(announced) != count {
            return Err("components in scans of their own, which are not read".into());
        }
        // A component by itself goes block by block.
        let units = |component: &Component| if count == 1 { [1, 1] } else { component.blocks };
        let most =
            components.iter().map(units).fold([1, 1], |most, blocks| [most[0].max(blocks[0]), most[1].max(blocks[1])]);
        let (across, down) = (columns.div_ceil(8 * most[0]), rows.div_ceil(8 * most[1]));
        let mut planes = Vec::new();
        for (component, &[name, tables]) in components.iter().zip(rest.as_chunks::<2>().0) {
            let table = |kind: usize, number: u8| {
                self.codes[kind].get(usize::from(number)).and_then(Option::as_ref).ok_or("codes that are missing")
            };
            if name != component.name {
                return Err("components in another order than the frame's".into());
            }
            let (blocks, codes) = (units(component), [table(0, tables >> 4)?, table(1, tables & 15)?]);
            let width = across * blocks[0] * 8;
            let samples = vec![0; width * down * blocks[1] * 8];
            planes.push(Plane { component, codes, blocks, width, samples, last: 0 });
        }
        let cosines = cosines();
        let mut bits = Bits { bytes: data, at: 0, waiting: 0, count: 0 };
        for unit in 0..across * down {
            if self.interval > 0 && unit > 0 && unit % self.interval == 0 {
                bits.restart()?;
                planes.iter_mut().for_each(|plane| plane.last = 0);
            }
            for plane in &mut planes {
                let [columns, rows] = plane.blocks;
                for (y, x) in (0..rows).flat_map(|y| (0..columns).map(move |x| (y, x))) {
                    let block = self.block(&mut bits, plane)?;
                    let column = (unit % across * columns + x) * 8;
                    let row = (unit / across * rows + y) * 8;
                    for (line, samples) in samples_of(&block, &cosines).chunks_exact(8).enumerate() {
                        plane.samples[(row + line) * plane.width + column..][..8].copy_from_slice(samples);
                    }
                }
            }
        }
        let full = |plane: &Plane| {
            let at = |x: usize, y: usize| {
                let (x, y) = (x * plane.blocks[0] / most[0], y * plane.blocks[1] / most[1]);
                plane.samples[y * plane.width + x]
            };
            (0..*rows).flat_map(|y| (0..*columns).map(move |x| (x, y))).map(|(x, y)| at(x, y)).collect()
        };
        Ok(planes.iter().map(full).collect())
    }

    /// The coefficients of a block.
    fn block(&self, bits: &mut Bits, plane: &mut Plane) -> Result<[f32; 64], String> {
        let steps = &self.quantization[plane.component.quantization];
        let mut block = [0.0; 64];
        let size = bits.value(plane.codes[0])?;
        plane.last = plane.last.wrapping_add(bits.signed(size.into())?);
        block[0] = plane.last as f32 * f32::from(steps[0]);
        let mut at = 1;
        while at < 64 {
            let value = bits.value(plane.codes[1])?;
            let (zeros, size) = (usize::from(value >> 4), u32::from(value & 15));
            if size == 0 {
                if zeros < 15 {
                    break;
                }
                at += 16;
                continue;
            }
            at += zeros;
            if at > 63 {
                return Err("a block of more than 64 coefficients".into());
            }
            block[ZIGZAG[at]] = bits.signed(size)? as f32 * f32::from(steps[at]);
            at += 1;
        }
        Ok(block)
    }
}

/// Of each frequency its wave at eight places.
fn cosines() -> [[f32; 8]; 8] {
    let wave = |frequency: usize, place: usize| {
        let scale = if frequency == 0 { std::f64::consts::FRAC_1_SQRT_2 } else { 1.0 };
        (scale * 0.5 * ((2 * place + 1) as f64 * frequency as f64 * std::f64::consts::PI / 16.0).cos()) as f32
    };
    std::array::from_fn(|frequency| std::array::from_fn(|place| wave(frequency, place)))
}

/// The inverse transform of a block, rows first.
fn samples_of(block: &[f32; 64], cosines: &[[f32; 8]; 8]) -> [u16; 64] {
    let mut rows = [0.0; 64];
    for (row, x) in (0..8).flat_map(|row| (0..8).map(move |x| (row, x))) {
        rows[8 * row + x] = (0..8).map(|u| block[8 * row + u] * cosines[u][x]).sum();
    }
    std::array::from_fn(|place| {
        let (y, x) = (place / 8, place % 8);
        let sample: f32 = (0..8).map(|v| rows[8 * v + x] * cosines[v][y]).sum();
        (sample + MIDDLE).round().clamp(0.0, MOST) as u16
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers and how many bits each has, as the data of a scan.
    fn packed(numbers: &[(u32, u32)]) -> Vec<u8> {
        let bits =
            numbers.iter().flat_map(|&(number, count)| (0..count).rev().map(move |bit| (number >> bit & 1) as u8));
        let mut bits: Vec<u8> = bits.collect();
        bits.resize(bits.len().next_multiple_of(8), 1);
        let bytes = bits.chunks(8).map(|bits| bits.iter().fold(0, |byte, bit| byte << 1 | bit));
        bytes.flat_map(|byte| if byte == 0xff { vec![0xff, 0] } else { vec![byte] }).collect()
    }

    /// 16 × 8 samples: a block that is even, and one with a wave across; `restarts` puts a marker between them.
    fn picture(restarts: bool) -> Vec<u8> {
        let segment = |marker: u8, content: &[u8]| {
            let length = (content.len() as u16 + 2).to_be_bytes();
            [&[0xff, marker], &length[..], content].concat()
        };
        // Fifteen codes of four bits, each its own value.
        let codes = |head: u8| {
            let values: Vec<u8> = (0..15).collect();
            segment(HUFFMAN, &[&[head, 0, 0, 0, 15][..], &[0; 12], &values].concat())
        };
        // A mean of 800, the end; then 400 less, a wave of 1200, the end.
        let first = [(10, 4), (800, 10), (0, 4)];
        let second = if restarts { [(9, 4), (400, 9)] } else { [(9, 4), (511 - 400, 9)] };
        let second = [&second[..], &[(11, 4), (1200, 11), (0, 4)]].concat();
        let data = if restarts {
            [packed(&first), vec![0xff, 0xd0], packed(&second)].concat()
        } else {
            packed(&[&first[..], &second].concat())
        };
        [
            &[0xff, START][..],
            &segment(QUANTIZATION, &[&[0x10][..], &[0, 1].repeat(64)].concat()),
            &segment(EXTENDED, &[12, 0, 8, 0, 16, 1, 1, 0x11, 0]),
            &codes(0),
            &codes(0x10),
            &segment(INTERVAL, &[0, u8::from(restarts)]),
            &segment(SCAN, &[1, 1, 0, 0, 63, 0]),
            &data,
            &[0xff, END],
        ]
        .concat()
    }

    #[test]
    fn means_and_waves_become_samples_with_and_without_restarts() {
        for restarts in [false, true] {
            let bytes = picture(restarts);
            assert!(is_such(&bytes));
            let [samples] = &decode(&bytes, 16, 8).unwrap()[..] else { panic!() };
            for (place, &sample) in samples.iter().enumerate() {
                let x = place % 16;
                let wave = ((2 * (x % 8) + 1) as f64 * std::f64::consts::PI / 16.0).cos() / 4.0 * 0.5f64.sqrt();
                let wanted = if x < 8 { 2148.0 } else { 2098.0 + 1200.0 * wave };
                assert!((f64::from(sample) - wanted).abs() <= 0.51, "{place}: {sample} {wanted}");
            }
        }
    }

    #[test]
    fn a_picture_that_is_cut_or_changed_is_refused_or_read_and_never_a_panic() {
        let bytes = picture(true);
        for length in 0..bytes.len() - 5 {
            assert!(decode(&bytes[..length], 16, 8).is_err(), "{length}");
        }
        for (at, bit) in (0..bytes.len()).flat_map(|at| (0..8).map(move |bit| (at, bit))) {
            let mut damaged = bytes.clone();
            damaged[at] ^= 1 << bit;
            is_such(&damaged);
            drop(decode(&damaged, 16, 8));
        }
        assert!(decode(&bytes, 8, 8).err().unwrap().contains("16 x 8"));
    }
}
