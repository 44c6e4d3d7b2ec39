//! `cargo run --release -p voxtrace-tests --example scan -- POINTS OUT.las`: a synthetic terrain scan with so many points (`1e9`
//! is 26 GB), to try out-of-core voxelization.

use std::error::Error;
use std::path::Path;
use voxtrace_tests::terrain::Terrain;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [points, out] = &arguments[..] else { return Err("say how many points, and the file to write".into()) };
    Ok(Terrain::of(points.parse::<f64>()? as u64).write(Path::new(out))?)
}
