//! Writes the synthetic CT of the plan `work`, without noise so that it is small:
//! `cargo run --release -p voxtrace-tests --example ct -- docs/plans/ct.nii.gz 224`.

use flate2::{Compression, GzBuilder};
use std::error::Error;
use std::io::Write;
use voxtrace_tests::phantom;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [file, samples] = &arguments[..] else { return Err("usage: ct FILE SAMPLES".into()) };
    // No time of day: the same bytes each time.
    let mut encoder = GzBuilder::new().mtime(0).write(std::fs::File::create(file)?, Compression::best());
    encoder.write_all(&phantom::nifti(samples.parse()?, 0.0))?;
    encoder.finish()?;
    Ok(())
}
