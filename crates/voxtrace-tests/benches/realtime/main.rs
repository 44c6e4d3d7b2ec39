//! `cargo bench -p voxtrace-tests --bench realtime`: how near real-time light is to the picture of many samples, and what each of its parts is worth: after a cut,
//! along a way of the camera, after an edit, after the lamps were dimmed, and while things move. Prints the tables of `docs/realtime.md`. Pictures of many samples are made by `--device` where
//! there is one; the real-time pictures are the processor's, or with `--on-device` those of that device. `--timing` prints how long each of its steps takes.

#[path = "../common/mod.rs"]
mod common;
mod maker;
mod quality;
mod situations;
mod timing;

use clap::Parser;
use common::{DeviceArgs, Outcome};
use maker::Maker;
use quality::{Quality, Totals};
use situations::Situation;
use std::path::PathBuf;
use std::sync::Arc;
use voxtrace::import::{Content, ImportOptions, load};
use voxtrace::{CpuTracer, Film, Frame, PackedScene, Progress, Tracer};
use voxtrace_realtime::Parts;
use voxtrace_tests::still_lifes;
use voxtrace_vulkan::{Request, Traversal, choose};

/// Seed of the pictures of many samples.
const REFERENCE_SEED: u32 = 1;

#[derive(Parser)]
struct Args {
    /// Scenes
    #[arg(long, value_delimiter = ',', default_value = "church,operating-room,city,forest,glass")]
    scenes: Vec<String>,
    /// Voxels of each built-in scene; its own number by default
    #[arg(long)]
    voxels: Option<u64>,
    /// Situations
    #[arg(long, value_enum, value_delimiter = ',', default_values_t = Situation::ALL)]
    situations: Vec<Situation>,
    /// Parts of real-time light: raw, temporal, cache, filter, all
    #[arg(long, value_delimiter = ',', default_value = "raw,temporal,cache,filter,all")]
    parts: Vec<String>,
    /// Size of the pictures
    #[arg(long, default_value = "240x136")]
    size: String,
    /// Samples of the pictures to compare with
    #[arg(long, default_value_t = 4096)]
    samples: u32,
    /// Folder that keeps scenes
    #[arg(long, default_value = "target/realtime")]
    cache: PathBuf,
    /// Makes real-time pictures on the device, too
    #[arg(long)]
    on_device: bool,
    /// Measures how long the steps take on the device, and nothing else
    #[arg(long)]
    timing: bool,
    /// Writes the pictures there, as PPM
    #[arg(long)]
    pictures: Option<PathBuf>,
    #[command(flatten)]
    renderer: DeviceArgs,
}

/// What a name of the column `parts` uses.
fn parts(name: &str) -> Outcome<Parts> {
    let memory = Parts { memory: true, ..Parts::NONE };
    Ok(match name {
        "raw" => Parts::NONE,
        "temporal" => memory,
        "cache" => Parts { cache: true, candidates: true, ..memory },
        "filter" => Parts { filter: true, ..memory },
        "all" => Parts::ALL,
        _ => return Err(format!("no parts {name:?}: raw, temporal, cache, filter, all").into()),
    })
}

/// Makes the pictures to compare with.
struct References {
    tracer: Box<dyn Tracer + Send>,
    samples: u32,
}

impl References {
    fn new(args: &Args) -> Outcome<Self> {
        let tracer: Box<dyn Tracer + Send> = match &args.renderer.device {
            None => Box::new(CpuTracer::new(None)),
            device => {
                let request =
                    Request { device: device.clone(), traversal: Some(Traversal::Walk), ..Request::default() };
                let choice = choose(&Request { is_fast: args.renderer.fast, ..request })?;
                eprintln!("{}", choice.reason);
                choice.tracer
            }
        };
        Ok(Self { tracer, samples: args.samples })
    }

    fn picture(&mut self, scene: &Arc<PackedScene>, frame: &Frame, samples: u32) -> Outcome<Vec<glam::Vec3>> {
        let frame = frame.clone().samples(samples.min(self.samples)).seed(REFERENCE_SEED);
        self.tracer.set_scene(scene)?;
        self.tracer.render(&frame, &Progress::default())?;
        let mut film = Film::new(1, 1, frame.region, 0);
        self.tracer.read(&mut film)?;
        Ok(film.pixels.iter().map(|pixel| pixel.mean()).collect())
    }
}

/// A built-in scene, and its view.
fn scene_of(args: &Args, name: &str) -> Outcome<(PackedScene, Frame)> {
    let path = common::packed_scene(&args.cache, name, args.voxels)?;
    let scene = match load(&path, &ImportOptions::default())?.content {
        Content::Packed(packed) => *packed,
        Content::Scene(scene) => PackedScene::pack(&scene)?,
    };
    let (width, height) = args.size.split_once('x').ok_or("a size is WIDTHxHEIGHT")?;
    let camera = scene.cameras.first().ok_or("a scene without a camera")?.clone();
    let frame = Frame::new(camera, width.parse()?, height.parse()?).max_bounces(still_lifes::max_bounces(name));
    Ok((scene, frame))
}

fn measure(args: &Args, name: &str, situation: Situation, references: &mut References) -> Outcome<()> {
    let (scene, frame) = scene_of(args, name)?;
    let Some(steps) = situation.steps(scene, &frame)? else { return Ok(()) };
    let mut all: Vec<(&String, Maker, Totals)> = args
        .parts
        .iter()
        .map(|name| Ok((name, Maker::new(args, parts(name)?)?, Totals::default())))
        .collect::<Outcome<_>>()?;
    for step in steps {
        let reference = match step.samples {
            0 => None,
            samples => Some(references.picture(&step.scene, &step.frame, samples)?),
        };
        for (parts, real_time, totals) in &mut all {
            let picture = real_time.frame(&step)?;
            totals.follow(&picture, &step.frame, situation.is_still());
            let Some(reference) = &reference else { continue };
            let quality = Quality::of(reference, &picture, &step.frame)?;
            if let Some(folder) = &args.pictures {
                quality.write(folder, &format!("{name}-{situation}-{parts}-{}", step.label))?;
            }
            totals.add(&quality);
            if situation.has_each_step() {
                println!("| {name} | {situation}, {} | {parts} | {quality} | |", step.label);
            }
        }
    }
    for (parts, _, totals) in &all {
        if let Some(line) = totals.line(situation) {
            println!("| {name} | {situation}, mean | {parts} | {line} |");
        }
    }
    Ok(())
}

fn main() -> Outcome<()> {
    let args = Args::parse();
    std::fs::create_dir_all(&args.cache)?;
    if args.timing {
        return timing::measure(&args);
    }
    let mut references = References::new(&args)?;
    println!("| scene | situation | parts | PSNR, dB | FLIP | energy | flicker |\n|---|---|---|---:|---:|---:|---:|");
    for name in &args.scenes {
        for &situation in &args.situations {
            measure(&args, name, situation, &mut references)?;
        }
    }
    Ok(())
}
