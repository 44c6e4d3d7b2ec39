//! `cargo build --release && cargo bench -p voxtrace-tests --bench noise`: whether `voxtrace render --noise` keeps its word: how many tiles of 32 × 32
//! pixels have more error than was asked for, against pictures of many samples with another seed. Prints the table of `docs/denoising.md`. Of
//! tiles that `--spp` stopped nothing was promised. The noise of the picture to compare with is in the errors; the column beside has them
//! without it, of which each of its samples is known to have as much as each of the other's.

mod common;

use clap::Parser;
use common::{DeviceArgs, Outcome, packed_scene};
use std::path::{Path, PathBuf};
use std::process::Command;
use voxtrace::Film;
use voxtrace::output::FilmFile;
use voxtrace_tests::still_lifes;

/// Edge of a tile, pixels.
const TILE: usize = 32;

#[derive(Parser)]
struct Args {
    /// Scenes
    #[arg(long, value_delimiter = ',', default_value = "church,operating-room,city,glass,cloud")]
    scenes: Vec<String>,
    /// Voxels of each built-in scene; its own number by default
    #[arg(long)]
    voxels: Option<u64>,
    /// Size of the pictures
    #[arg(long, default_value = "960x540")]
    size: String,
    /// Errors to ask for
    #[arg(long, value_delimiter = ',', default_value = "0.1,0.05")]
    noise: Vec<f64>,
    /// Samples of the picture to compare with, and the most that a pixel gets
    #[arg(long, default_value_t = 4096)]
    samples: u32,
    /// Folder for scenes and films
    #[arg(long, default_value = "target/noise")]
    cache: PathBuf,
    /// The program to measure, in place of the one that was built beside this one
    #[arg(long)]
    program: Option<PathBuf>,
    #[command(flatten)]
    renderer: DeviceArgs,
}

impl Args {
    /// A film that the program renders.
    fn film(&self, name: &str, what: &str, options: &[&str]) -> Outcome<Film> {
        let path = self.cache.join(format!("{name}-{}-{what}.vxf", self.size));
        if !path.exists() {
            let beside = || Ok::<_, std::io::Error>(std::env::current_exe()?.with_file_name("../voxtrace"));
            let program = self.program.clone().map_or_else(beside, Ok)?;
            let bounces = still_lifes::max_bounces(name).to_string();
            let mut command = Command::new(&program);
            command.arg("render").arg(packed_scene(&self.cache, name, self.voxels)?).args([
                "--size",
                &self.size,
                "--max-bounces",
                &bounces,
                "-q",
            ]);
            command.args(options).arg("--checkpoint").arg(&path);
            match &self.renderer.device {
                Some(device) => command.args(["--traversal", "walk", "--device", device]),
                None => command.args(["--traversal", "cpu"]),
            };
            let status = command.status().map_err(|error| format!("{}: {error}", program.display()))?;
            if !status.success() {
                return Err(format!("{command:?}: {status}").into());
            }
        }
        Ok(FilmFile::open(&path)?.film)
    }

    /// One scene's line for each error asked for.
    fn measure(&self, name: &str) -> Outcome<()> {
        let spp = self.samples.to_string();
        let mut options = vec!["--spp", &spp, "--seed", "1"];
        options.extend(self.renderer.fast.then_some("--fast"));
        let many = self.film(name, &format!("{spp}-samples"), &options)?;
        for noise in self.noise.iter().map(f64::to_string) {
            let film = self.film(name, &format!("noise-{noise}-{spp}"), &["--spp", &spp, "--noise", &noise])?;
            let tiles = tiles(&film, &many);
            let promised: Vec<&Tile> = tiles.iter().filter(|tile| tile.samples < self.samples).collect();
            let share = |is_above: &dyn Fn(&Tile) -> bool| {
                100.0 * promised.iter().filter(|tile| is_above(tile)).count() as f64 / promised.len().max(1) as f64
            };
            let asked: f64 = noise.parse()?;
            let above = share(&|tile| tile.error > asked);
            let own_above = share(&|tile| tile.own_error(self.samples) > asked);
            let mean = tiles.iter().map(|tile| f64::from(tile.samples)).sum::<f64>() / tiles.len().max(1) as f64;
            let (least, most) = film.sample_range();
            let (all, stopped) = (tiles.len(), tiles.len() - promised.len());
            println!(
                "| {name} | {noise} | {least} / {mean:.0} / {most} | {all} | {stopped} | {above:.1} | {own_above:.1} |"
            );
        }
        Ok(())
    }
}

/// What became of one tile.
struct Tile {
    /// Samples of its pixels.
    samples: u32,
    /// Root of the mean square difference of luminance from the picture to compare with, over that one's mean luminance.
    error: f64,
}

impl Tile {
    /// The error without that of a picture of `many` samples.
    fn own_error(&self, many: u32) -> f64 {
        self.error / (1.0 + f64::from(self.samples) / f64::from(many)).sqrt()
    }
}

fn tiles(film: &Film, many: &Film) -> Vec<Tile> {
    let (width, height) = (film.width as usize, film.height as usize);
    let luminance = |film: &Film, index: usize| {
        let mean = film.pixels[index].mean();
        f64::from(0.2126 * mean.x + 0.7152 * mean.y + 0.0722 * mean.z)
    };
    let tile = |(x0, y0): (usize, usize)| {
        let rows = y0..(y0 + TILE).min(height);
        let pixels: Vec<usize> = rows.flat_map(|y| (x0..(x0 + TILE).min(width)).map(move |x| y * width + x)).collect();
        let square: f64 = pixels.iter().map(|&index| (luminance(film, index) - luminance(many, index)).powi(2)).sum();
        let sum: f64 = pixels.iter().map(|&index| luminance(many, index)).sum();
        let count = pixels.len() as f64;
        let error = if sum > 0.0 { (square / count).sqrt() / (sum / count) } else { 0.0 };
        Tile { samples: film.pixels[pixels[0]].samples, error }
    };
    let corners = (0..height).step_by(TILE).flat_map(|y| (0..width).step_by(TILE).map(move |x| (x, y)));
    corners.map(tile).collect()
}

fn main() -> Outcome<()> {
    let args = Args::parse();
    std::fs::create_dir_all(Path::new(&args.cache))?;
    println!(
        "| scene | error asked for | samples, least / mean / most | tiles | stopped by `--spp` | above it, % | without the noise of what it is compared with, % |"
    );
    println!("|---|---:|---:|---:|---:|---:|---:|");
    args.scenes.iter().try_for_each(|name| args.measure(name))
}
