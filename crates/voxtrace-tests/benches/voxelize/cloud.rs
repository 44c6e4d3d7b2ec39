//! A tile as an airplane scans it, ten million points in rows over hills, houses and trees, as LAZ and LAS: from the file to a
//! scene on the disk, beside the bare reading by laspy, whose decompression is the same crate's.

use crate::Options;
use crate::compressed_points::compressed;
use crate::stopwatch::beside;
use rayon::prelude::*;
use std::error::Error;
use std::path::Path;
use voxtrace::import::{self, ImportOptions, Limits};
use voxtrace::voxelize::{Scale, VoxelizeOptions, VoxelizeProgress};

/// Points along a row of the scanner.
const ROW: usize = 2500;
/// Bytes of a point of format 2, and of the header of LAS 1.2.
const RECORD: usize = 26;
const HEADER: usize = 227;

/// Measures and prints.
pub fn measure(options: &Options, folder: &Path) -> Result<(), Box<dyn Error>> {
    let (las, laz, out) = (folder.join("tile.las"), folder.join("tile.laz"), folder.join("tile.vxt"));
    let plain = tile(options.points);
    std::fs::write(&las, &plain)?;
    let compressed = compressed(&plain, 2, 50_000);
    std::fs::write(&laz, &compressed)?;
    println!(
        "{} points, {} MB as LAS, {} as LAZ",
        options.points,
        plain.len() / 1_000_000,
        compressed.len() / 1_000_000
    );
    drop((plain, compressed));
    let scale = Scale::Resolution(512);
    for (name, file) in [("LAZ", &laz), ("LAS", &las)] {
        let voxelize = || -> Result<(), Box<dyn Error>> {
            let geometry = import::read_geometry(file, &ImportOptions::default())?;
            let how = VoxelizeOptions { scale, ..VoxelizeOptions::default() };
            geometry.voxelize_to_file(&how, &Limits::default(), &out, &VoxelizeProgress::default())?;
            Ok(())
        };
        let seconds = beside(options, name, file, voxelize)?;
        println!("{name}: {:.2} M points/s", options.points as f64 / 1e6 / seconds.wall);
    }
    Ok(())
}

/// A LAS file of the points, centimetres in UTM.
fn tile(points: usize) -> Vec<u8> {
    let mut bytes = vec![0; HEADER];
    let mut put = |at: usize, value: &[u8]| bytes[at..at + value.len()].copy_from_slice(value);
    put(0, b"LASF");
    put(24, &[1, 2]);
    put(94, &(HEADER as u16).to_le_bytes());
    put(96, &(HEADER as u32).to_le_bytes());
    put(104, &[2]);
    put(105, &(RECORD as u16).to_le_bytes());
    put(107, &(points as u32).to_le_bytes());
    for (axis, offset) in [500_000.0f64, 4_000_000.0, 0.0].into_iter().enumerate() {
        put(131 + 8 * axis, &0.01f64.to_le_bytes());
        put(155 + 8 * axis, &offset.to_le_bytes());
    }
    bytes.resize(HEADER + points * RECORD, 0);
    bytes[HEADER..].par_chunks_exact_mut(RECORD).enumerate().for_each(|(at, record)| put_point(at, record));
    bytes
}

/// Point number `at`: rows a quarter of a metre apart, shaken by some centimetres.
fn put_point(at: usize, record: &mut [u8]) {
    let (row, column) = (at / ROW, at % ROW);
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
    for (axis, value) in [x, y, z].into_iter().enumerate() {
        put(4 * axis, &((value * 100.0).round() as i32).to_le_bytes());
    }
    put(12, &((1000.0 + 200.0 * (x / 5.0).sin() + 40.0 * shake(at, 5)) as u16).to_le_bytes());
    put(14, &[0b1001, class]);
    for (channel, value) in color.into_iter().enumerate() {
        put(20 + 2 * channel, &((value + (2000.0 * shake(at, 6 + channel)) as i32) as u16).to_le_bytes());
    }
}

/// About a normal distribution, of variance 1.
fn shake(at: usize, what: usize) -> f64 {
    (0..3).map(|part| random(at, 100 + 3 * what + part)).sum::<f64>() * 2.0 - 3.0
}

/// From 0 to 1, without order.
pub fn random(at: usize, what: usize) -> f64 {
    let mut bits = (at as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ (what as u64).wrapping_mul(0xd1b5_4a32_d192_ed03);
    bits = (bits ^ bits >> 32).wrapping_mul(0xd6e8_feb8_6659_fd93);
    bits = (bits ^ bits >> 32).wrapping_mul(0xd6e8_feb8_6659_fd93);
    ((bits ^ bits >> 32) >> 11) as f64 / (1u64 << 53) as f64
}
