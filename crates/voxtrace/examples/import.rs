//! Any file becomes a picture: `cargo run --release --example import -- castle.vox castle.png`. Without a file, a mesh is
//! written to the temporary folder first and read from there.

use std::f32::consts::TAU;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use voxtrace::import::{self, ImportOptions};
use voxtrace::voxelize::{Scale, VoxelizeOptions};
use voxtrace::{Renderer, Scene};

/// A trefoil knot with coloured vertices, as OBJ: 240 rings of 24 vertices, upright.
fn knot() -> String {
    let mut obj = String::new();
    let (rings, sides) = (240, 24);
    for ring in 0..rings {
        let angle = TAU * ring as f32 / rings as f32;
        let (distance, depth) = (2.0 + (3.0 * angle).cos(), (3.0 * angle).sin());
        for side in 0..sides {
            let (front, outward) = (TAU * side as f32 / sides as f32).sin_cos();
            let (z, radius) = (depth + 0.55 * front, distance + 0.55 * outward);
            let (sine, cosine) = (2.0 * angle).sin_cos();
            let [red, green, blue] = [0.0, 1.0, 2.0].map(|third| 0.5 + 0.4 * (angle + third * TAU / 3.0).cos());
            let _ = writeln!(obj, "v {} {} {z} {red} {green} {blue}", radius * sine, radius * cosine);
        }
    }
    for (ring, side) in (0..rings).flat_map(|ring| (0..sides).map(move |side| (ring, side))) {
        // Vertices are counted from 1.
        let vertex = |ring, side| ring % rings * sides + side % sides + 1;
        let corners = [vertex(ring, side), vertex(ring + 1, side), vertex(ring + 1, side + 1), vertex(ring, side + 1)];
        let _ = writeln!(obj, "f {} {} {} {}", corners[0], corners[1], corners[2], corners[3]);
    }
    obj
}

/// Reads any file that voxtrace knows; a mesh becomes voxels, 200 along its longest side.
fn read(file: &Path) -> Result<Scene, import::ImportError> {
    let voxelize = VoxelizeOptions { scale: Scale::Resolution(200), ..VoxelizeOptions::default() };
    import::open(file, &ImportOptions { voxelize, ..ImportOptions::default() })
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args().skip(1);
    let (file, picture) = (arguments.next(), arguments.next().unwrap_or("import.png".into()));
    let scene = match file {
        Some(file) => read(Path::new(&file))?,
        None => {
            let file: PathBuf = std::env::temp_dir().join(format!("voxtrace-knot-{}.obj", std::process::id()));
            std::fs::write(&file, knot())?;
            let scene = read(&file);
            std::fs::remove_file(&file)?;
            scene?
        }
    };
    Renderer::new(&scene)?.size(400, 300).samples(40).render()?.save(&picture)?;
    let voxels: u64 = scene.grids.iter().map(|grid| grid.count()).sum();
    println!("{picture}: {voxels} voxels, {} materials", scene.materials.len());
    Ok(())
}
