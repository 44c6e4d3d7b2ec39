//! A made-up survey from the air as LAZ tiles: hills, houses and trees, in lines as a scanner sweeps them, with colours and classes.
//! `cargo run --release -p voxtrace-tests --example scan_tiles -- FOLDER 64 100000000` writes 64 tiles of 10⁸ points together. With `meshes` after it tiles are
//! meshes of so many triangles (binary PLY, with colours), each of which ends where the next ones begin.

#[path = "../../voxtrace/tests/files/compressed_points/mod.rs"]
mod compressed_points;

use rayon::prelude::*;
use std::path::{Path, PathBuf};

/// Edge of a tile in metres.
const EDGE: f64 = 500.0;
/// Coordinates on the map of the first tile's corner.
const CORNER: [f64; 3] = [690_000.0, 5_330_000.0, 400.0];
/// Steps of coordinates, metres.
const STEP: f64 = 0.01;
/// Bytes of a LAS 1.2 header, and of a point of format 2.
const HEAD: usize = 227;
const RECORD: usize = 26;

/// A number from 0 to 1 that looks random (the finalizer of splitmix64).
fn random(seed: u64) -> f64 {
    let mut hash = seed.wrapping_add(0x9e37_79b9_7f4a_7c15);
    hash = (hash ^ hash >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    hash = (hash ^ hash >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
    (hash ^ hash >> 31) as f64 / u64::MAX as f64
}

/// Height of the ground in metres.
fn ground(x: f64, y: f64) -> f64 {
    60.0 + 40.0 * (x / 700.0).sin() * (y / 900.0).cos() + 6.0 * (x / 83.0 + y / 61.0).sin() + 0.8 * (x / 9.0).sin()
}

/// Height, colour and class of what a pulse meets: each cell of 25 m has a house, a tree or neither.
fn surface(x: f64, y: f64, pulse: u64) -> (f64, [u8; 3], u8) {
    let cell = [(x / 25.0).floor(), (y / 25.0).floor()];
    let of_cell = |number: u64| random(cell[0] as u64 ^ (cell[1] as u64) << 20 ^ number << 40);
    let inside = [x - cell[0] * 25.0 - 12.5, y - cell[1] * 25.0 - 12.5];
    let floor = ground(cell[0] * 25.0 + 12.5, cell[1] * 25.0 + 12.5);
    let shade = (random(pulse ^ 1 << 60) * 24.0) as u8;
    if of_cell(1) < 0.15 && inside[0].abs() < 7.0 && inside[1].abs() < 5.0 {
        let ridge = 3.0 * (1.0 - inside[1].abs() / 5.0);
        return (floor + 5.0 + ridge, [150 + shade, 70 + shade, 60], 6);
    }
    let (radius, distance) = (3.0 + 4.0 * of_cell(2), inside[0].hypot(inside[1]));
    // Some pulses go through the leaves.
    if of_cell(1) > 0.6 && distance < radius && random(pulse ^ 1 << 61) < 0.8 {
        let height = 14.0 * (1.0 - (distance / radius).powi(2)) * random(pulse ^ 1 << 62).sqrt();
        return (floor + 2.0 + height, [40 + shade, 90 + shade * 2, 40], 5);
    }
    let dry = (ground(x, y) - 30.0).clamp(0.0, 60.0) as u8;
    (ground(x, y), [90 + dry + shade, 130 + shade, 70], 2)
}

/// A tile as LAS: `count` points, in lines.
fn tile([column, row]: [usize; 2], count: usize, seed: u64) -> Vec<u8> {
    let mut bytes = vec![0; HEAD + count * RECORD];
    let corner = [column as f64 * EDGE, row as f64 * EDGE];
    let lines = (count as f64).sqrt().ceil() as usize;
    let (mut low, mut high) = ([i32::MAX; 3], [i32::MIN; 3]);
    for (number, record) in bytes[HEAD..].chunks_exact_mut(RECORD).enumerate() {
        let pulse = seed << 36 | number as u64;
        let (line, along) = (number / lines, number % lines);
        let along = if line % 2 == 0 { along } else { lines - 1 - along };
        let x = corner[0] + (along as f64 + random(pulse)) * EDGE / lines as f64;
        let y = corner[1] + (line as f64 + random(pulse ^ 1 << 63)) * EDGE / lines as f64;
        let (z, color, class) = surface(x, y, pulse);
        let place = [x, y, z].map(|value| (value / STEP).round() as i32);
        for axis in 0..3 {
            (low[axis], high[axis]) = (low[axis].min(place[axis]), high[axis].max(place[axis]));
        }
        record[..12].copy_from_slice(place.map(i32::to_le_bytes).as_flattened());
        record[12..14].copy_from_slice(&((random(pulse ^ 1 << 59) * 4000.0) as u16).to_le_bytes());
        record[15] = class;
        record[20..26].copy_from_slice(color.map(|byte| (u16::from(byte) * 257).to_le_bytes()).as_flattened());
    }
    let mut put = |at: usize, value: &[u8]| bytes[at..at + value.len()].copy_from_slice(value);
    put(0, b"LASF");
    put(24, &[1, 2]);
    put(94, &(HEAD as u16).to_le_bytes());
    put(96, &(HEAD as u32).to_le_bytes());
    put(104, &[2]);
    put(105, &(RECORD as u16).to_le_bytes());
    put(107, &(count as u32).to_le_bytes());
    for axis in 0..3 {
        put(131 + 8 * axis, &STEP.to_le_bytes());
        put(155 + 8 * axis, &CORNER[axis].to_le_bytes());
        let ends = [high[axis], low[axis]].map(|end| f64::from(end) * STEP + CORNER[axis]);
        put(179 + 16 * axis, ends.map(f64::to_le_bytes).as_flattened());
    }
    bytes
}

/// A tile as a mesh, PLY: at least `count` triangles, in a grid.
fn mesh([column, row]: [usize; 2], count: usize) -> Vec<u8> {
    let side = ((count as f64 / 2.0).sqrt().ceil() as usize).max(1);
    let step = EDGE / side as f64;
    let corners = (side + 1) * (side + 1);
    let axes = ["x", "y", "z"].map(|axis| format!("property float {axis}\n")).concat();
    let channels = ["red", "green", "blue"].map(|channel| format!("property uchar {channel}\n")).concat();
    let head = format!("ply\nformat binary_little_endian 1.0\nelement vertex {corners}\n{axes}{channels}");
    let faces = format!("element face {}\nproperty list uchar int vertex_indices\nend_header\n", 2 * side * side);
    let mut bytes = (head + &faces).into_bytes();
    for at in 0..corners {
        let place = [at % (side + 1), at / (side + 1)];
        let (x, y) = (column as f64 * EDGE + place[0] as f64 * step, row as f64 * EDGE + place[1] as f64 * step);
        let (z, color, _) = surface(x, y, (x * 1e3) as u64 ^ ((y * 1e3) as u64) << 28);
        bytes.extend([x, y, z].map(|value| (value as f32).to_le_bytes()).as_flattened());
        bytes.extend(color);
    }
    for cell in 0..side * side {
        let first = (cell / side * (side + 1) + cell % side) as u32;
        let above = first + side as u32 + 1;
        for corners in [[first, first + 1, above], [first + 1, above + 1, above]] {
            bytes.push(3);
            bytes.extend(corners.map(u32::to_le_bytes).as_flattened());
        }
    }
    bytes
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args().skip(1);
    let folder = PathBuf::from(arguments.next().unwrap_or("scan".into()));
    let tiles: usize = arguments.next().map_or(Ok(16), |text| text.parse())?;
    let points: usize = arguments.next().map_or(Ok(1_000_000), |text| text.parse())?;
    let are_meshes = match arguments.next().as_deref() {
        None => false,
        Some("meshes") => true,
        Some(other) => return Err(format!("{other:?} is not meshes").into()),
    };
    std::fs::create_dir_all(&folder)?;
    let side = (tiles as f64).sqrt().ceil() as usize;
    let write = |number: usize| {
        let place = [number % side, number / side];
        let count = points * (number + 1) / tiles - points * number / tiles;
        if are_meshes {
            return std::fs::write(folder.join(format!("{}_{}.ply", place[0], place[1])), mesh(place, count));
        }
        let las = tile(place, count, number as u64 + 1);
        let name = format!("{}_{}.laz", place[0], place[1]);
        std::fs::write(Path::new(&folder).join(name), compressed_points::compressed(&las, 2, 50_000))
    };
    (0..tiles).into_par_iter().try_for_each(write)?;
    println!("{tiles} tiles of {points} {} in {}", if are_meshes { "triangles" } else { "points" }, folder.display());
    Ok(())
}
