//! A piece of land as an airplane scans it, points in rows over hills, houses and trees, with colours whose low bits are noise:
//! a LAS file of any number of points, made block by block on all threads.

use rayon::prelude::*;
use std::fs::File;
use std::io::{self, Seek, SeekFrom, Write};
use std::path::Path;

/// Bytes of a point of format 2, and of the header of LAS 1.2.
const RECORD: usize = 26;
const HEADER: usize = 227;
/// Points made by one task, and tasks whose points are written at once.
const BLOCK: u64 = 1 << 16;
const BLOCKS: u64 = 64;

/// Land about as long as it is wide.
#[derive(Clone, Copy, Debug)]
pub struct Terrain {
    points: u64,
    /// Points along a row of the scanner.
    row: u64,
}

/// Least and greatest of three coordinates.
type Bounds = ([i32; 3], [i32; 3]);
const NOWHERE: Bounds = ([i32::MAX; 3], [i32::MIN; 3]);

impl Terrain {
    /// Land of so many points, ten to a square metre.
    pub fn of(points: u64) -> Self {
        Self { points, row: ((points as f64 / 1.6).sqrt() as u64).max(1) }
    }

    /// Writes a LAS file, centimetres in UTM.
    ///
    /// # Errors
    /// If the file cannot be written, or a header has no number for so many points.
    pub fn write(&self, path: &Path) -> io::Result<()> {
        let count = u32::try_from(self.points).map_err(|_| io::Error::other("LAS 1.2 counts to 2^32 - 1"))?;
        let mut file = File::create(path)?;
        file.seek(SeekFrom::Start(HEADER as u64))?;
        let (mut ready, mut bounds) = (Vec::new(), NOWHERE);
        for start in (0..self.points).step_by((BLOCK * BLOCKS) as usize) {
            let mut next = vec![0; (BLOCK * BLOCKS).min(self.points - start) as usize * RECORD];
            let fill = || self.fill(start, &mut next);
            let (written, found) = rayon::join(|| file.write_all(&ready), fill);
            written?;
            (ready, bounds) = (next, joined(bounds, found));
        }
        file.write_all(&ready)?;
        file.seek(SeekFrom::Start(0))?;
        file.write_all(&header(count, bounds))
    }

    /// The points from one on.
    fn fill(&self, start: u64, bytes: &mut [u8]) -> Bounds {
        let block = |(number, block): (usize, &mut [u8])| {
            let first = start + number as u64 * BLOCK;
            let records = block.chunks_exact_mut(RECORD).zip(first..);
            records.fold(NOWHERE, |bounds, (record, at)| {
                let place = put_point(at, self.row, record);
                joined(bounds, (place, place))
            })
        };
        bytes.par_chunks_mut(BLOCK as usize * RECORD).enumerate().map(block).reduce(|| NOWHERE, joined)
    }
}

fn joined(a: Bounds, b: Bounds) -> Bounds {
    (std::array::from_fn(|axis| a.0[axis].min(b.0[axis])), std::array::from_fn(|axis| a.1[axis].max(b.1[axis])))
}

fn header(points: u32, (low, high): Bounds) -> [u8; HEADER] {
    let mut bytes = [0; HEADER];
    let mut put = |at: usize, value: &[u8]| bytes[at..at + value.len()].copy_from_slice(value);
    put(0, b"LASF");
    put(24, &[1, 2]);
    put(94, &(HEADER as u16).to_le_bytes());
    put(96, &(HEADER as u32).to_le_bytes());
    put(104, &[2]);
    put(105, &(RECORD as u16).to_le_bytes());
    put(107, &points.to_le_bytes());
    for (axis, offset) in [500_000.0f64, 4_000_000.0, 0.0].into_iter().enumerate() {
        put(131 + 8 * axis, &0.01f64.to_le_bytes());
        put(155 + 8 * axis, &offset.to_le_bytes());
        let ends = [high, low].map(|end| f64::from(end[axis]) * 0.01 + offset);
        put(179 + 16 * axis, ends.map(f64::to_le_bytes).as_flattened());
    }
    bytes
}

/// Point number `at`: rows a quarter of a metre apart, shaken by some centimetres. Returns its place in centimetres.
fn put_point(at: u64, row_length: u64, record: &mut [u8]) -> [i32; 3] {
    let (row, column) = (at / row_length, at % row_length);
    let x = row as f64 * 0.25 + shake(at, 0) * 0.05;
    let y = column as f64 * 0.4 + shake(at, 1) * 0.05;
    let ground = 30.0 * (x / 90.0).sin() + 20.0 * (y / 70.0).cos();
    // Houses on a grid of streets, trees where the ground is high.
    let is_house = x.rem_euclid(50.0) < 20.0 && y.rem_euclid(40.0) < 25.0 && ground < 0.0;
    let is_tree = ground > 20.0 && random(at, 2) < 0.4;
    let above = if is_house {
        8.0
    } else if is_tree {
        12.0 * random(at, 3)
    } else {
        0.0
    };
    let z = 100.0 + ground + above + shake(at, 4) * 0.1;
    let (class, color) = match (is_house, is_tree) {
        (true, _) => (6, [40_000, 22_000, 18_000]),
        (_, true) => (5, [12_000, 26_000, 9_000]),
        _ => (2, [26_000 + (8000.0 * (x / 50.0).sin()) as i32, 28_000 + (6000.0 * (y / 50.0).cos()) as i32, 16_000]),
    };
    let mut put = |place: usize, value: &[u8]| record[place..place + value.len()].copy_from_slice(value);
    let place = [x, y, z].map(|value| (value * 100.0).round() as i32);
    put(0, place.map(i32::to_le_bytes).as_flattened());
    put(12, &((1000.0 + 200.0 * (x / 5.0).sin() + 40.0 * shake(at, 5)) as u16).to_le_bytes());
    put(14, &[0b1001, class]);
    for (channel, value) in color.into_iter().enumerate() {
        put(20 + 2 * channel, &((value + (2000.0 * shake(at, 6 + channel)) as i32) as u16).to_le_bytes());
    }
    place
}

/// About a normal distribution, of variance 1.
fn shake(at: u64, what: usize) -> f64 {
    (0..3).map(|part| random(at, 100 + 3 * what + part)).sum::<f64>() * 2.0 - 3.0
}

/// From 0 to 1, without order.
pub fn random(at: u64, what: usize) -> f64 {
    let mut bits = at.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ (what as u64).wrapping_mul(0xd1b5_4a32_d192_ed03);
    bits = (bits ^ bits >> 32).wrapping_mul(0xd6e8_feb8_6659_fd93);
    bits = (bits ^ bits >> 32).wrapping_mul(0xd6e8_feb8_6659_fd93);
    ((bits ^ bits >> 32) >> 11) as f64 / (1u64 << 53) as f64
}
