//! A tile of an airborne laser scan, ten million points as LAZ and LAS: from the file to a native file, compared with reading alone
//! by laspy, which decompresses with the same crate.

use crate::Options;
use crate::compressed_points::compressed;
use crate::stopwatch::beside;
use std::error::Error;
use std::path::Path;
use voxtrace::import::{self, ImportOptions, Limits};
use voxtrace::voxelize::{Scale, VoxelizeOptions, VoxelizeProgress};
use voxtrace_tests::terrain::Terrain;

/// Measures and prints.
pub fn measure(options: &Options, folder: &Path) -> Result<(), Box<dyn Error>> {
    let (las, laz, out) = (folder.join("tile.las"), folder.join("tile.laz"), folder.join("tile.vxt"));
    Terrain::of(options.points as u64).write(&las)?;
    let plain = std::fs::read(&las)?;
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
