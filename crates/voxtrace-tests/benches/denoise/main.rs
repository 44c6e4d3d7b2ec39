//! `cargo bench -p voxtrace-tests --bench denoise`: how much of the noise is left in pictures of the built-in scenes and of glass, metal and
//! clouds, beside pictures of many samples: raw, by the filter of `voxtrace-core`, by Open Image Denoise where it is installed, and raw with
//! four times the samples. Prints the table of `docs/denoising.md`. The pictures of many samples take hours on few cores; they are kept in a
//! folder, and a run that was stopped goes on. Where another machine has a GPU, `--prepare --device 0` makes them there; the folder's `.exr`
//! are all that the table needs of it.

#[path = "../common/mod.rs"]
mod common;
mod films;
mod table;

use clap::Parser;
use common::{DeviceArgs, Outcome};
use films::Films;
use std::path::PathBuf;
use voxtrace_oidn::Oidn;

#[derive(Parser)]
struct Args {
    /// Scenes
    #[arg(long, value_delimiter = ',', default_value = "church,operating-room,city,glass,metal,cloud")]
    scenes: Vec<String>,
    /// Voxels of each built-in scene; its own number by default
    #[arg(long)]
    voxels: Option<u64>,
    /// Sizes of the pictures
    #[arg(long, value_delimiter = ',', default_value = "960x540,1280x720")]
    sizes: Vec<String>,
    /// Samples of the noisy picture
    #[arg(long, default_value_t = 16)]
    samples: u32,
    /// Samples of the picture to compare with
    #[arg(long, default_value_t = 2048)]
    reference: u32,
    /// Folder that keeps scenes and films
    #[arg(long, default_value = "target/denoise")]
    cache: PathBuf,
    /// Writes the pictures there, as PPM
    #[arg(long)]
    pictures: Option<PathBuf>,
    /// Renders pictures, compares nothing
    #[arg(long, num_args = 0..=1, default_missing_value = "many")]
    prepare: Option<Prepare>,
    #[command(flatten)]
    renderer: DeviceArgs,
}

/// What is rendered in advance.
#[derive(Clone, Copy, PartialEq, clap::ValueEnum)]
enum Prepare {
    /// Pictures of many samples: those to compare with, and those of four times the samples
    Many,
    /// Noisy films
    Noisy,
}

fn main() -> Outcome<()> {
    let args = Args::parse();
    std::fs::create_dir_all(&args.cache)?;
    let oidn = Oidn::open();
    if let Err(error) = &oidn {
        eprintln!("{error}");
    }
    if args.prepare.is_none() {
        println!("| scene | picture | PSNR, dB | FLIP | time | processor |\n|---|---|---:|---:|---:|---:|");
    }
    for size in &args.sizes {
        let (width, height) = size.split_once('x').ok_or("a size is WIDTHxHEIGHT")?;
        for name in &args.scenes {
            let films = Films::of(&args, name, (width.parse()?, height.parse()?))?;
            match args.prepare {
                Some(Prepare::Many) => _ = (films.reference()?, films.more()?),
                Some(Prepare::Noisy) => _ = films.noisy()?,
                None => table::print(&args, &films, oidn.as_ref().ok())?,
            }
        }
    }
    Ok(())
}
