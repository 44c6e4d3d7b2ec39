//! `cargo bench -p voxtrace-tests --bench voxelize`: how long voxelizing meshes, clouds of points and volumes
//! takes, compared on the same files and in the same run with libraries from PyPI where a Python has them: trimesh's voxelizer, and
//! reading alone by laspy and nibabel. `docs/benchmarks.md` has the results.

mod cloud;
#[path = "../../../voxtrace/tests/files/compressed_points/mod.rs"]
mod compressed_points;
mod mesh;
mod stopwatch;
mod volume;

use clap::Parser;
use std::error::Error;
use std::path::PathBuf;

/// Measures voxelization.
#[derive(Parser)]
struct Options {
    /// What is measured.
    #[arg(long, value_delimiter = ',', default_value = "mesh,cloud,volume")]
    only: Vec<String>,
    /// Triangles of the mesh, about.
    #[arg(long, default_value_t = 1_000_000)]
    triangles: u32,
    /// Points of the cloud.
    #[arg(long, default_value_t = 10_000_000)]
    points: usize,
    /// Samples along each side of the volume.
    #[arg(long, default_value_t = 512)]
    samples: usize,
    /// Voxels along the mesh's longest side.
    #[arg(long, default_value_t = 1024)]
    resolution: u32,
    /// Rounds; the median counts.
    #[arg(long, default_value_t = 5)]
    rounds: usize,
    /// A Python that has trimesh, laspy with lazrs, and nibabel.
    #[arg(long, default_value = "python3")]
    python: PathBuf,
    /// Resolutions for trimesh, which takes much memory: at most 12 GB are allowed.
    #[arg(long, default_value = "256,512,1024")]
    trimesh_resolutions: String,
    /// Passed by cargo; ignored.
    #[arg(long, hide = true)]
    bench: bool,
}

fn main() -> Result<(), Box<dyn Error>> {
    let options = Options::parse();
    let folder = tempfile::tempdir()?;
    let load = std::fs::read_to_string("/proc/loadavg").unwrap_or_default();
    let load = load.split(' ').next().filter(|load| !load.is_empty()).unwrap_or("unknown");
    println!("{} threads, load before the start {load}", rayon::current_num_threads());
    for what in &options.only {
        match what.as_str() {
            "mesh" => mesh::measure(&options, folder.path())?,
            "cloud" => cloud::measure(&options, folder.path())?,
            "volume" => volume::measure(&options, folder.path())?,
            other => return Err(format!("{other} is none of mesh, cloud, volume").into()),
        }
    }
    Ok(())
}
