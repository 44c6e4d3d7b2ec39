//! `cargo bench -p voxtrace-tests --bench realtime`: how near real-time light is to the picture of many samples, and what each of its parts is worth: after a cut,
//! along a way of the camera, after an edit, after the lamps were dimmed, and while things move. Prints the tables of `docs/realtime.md`. Pictures of many samples are made by `--device` where
//! there is one; the real-time pictures are the processor's, or with `--on-device` those of that device. `--timing` prints how long each of its steps takes.

#[path = "../common/mod.rs"]
mod common;
mod maker;
mod quality;
mod references;
mod results;
mod situations;
mod timing;

use clap::Parser;
use common::{DeviceArgs, Outcome};
use glam::Vec3;
use maker::Maker;
use quality::{Quality, Totals};
use references::{References, StillFilter};
use results::{Line, Results};
use situations::{Situation, Step};
use std::path::PathBuf;
use voxtrace::import::{Content, ImportOptions, load};
use voxtrace::{Frame, Material, PackedScene, Scene};
use voxtrace_realtime::Parts;
use voxtrace_tests::still_lifes;

#[derive(Parser)]
struct Args {
    /// Scenes; NAME+balls: with 64 balls before the camera, NAME+glass: half of them glass, half metal
    #[arg(long, value_delimiter = ',', default_value = "church,operating-room,city,forest,glass")]
    scenes: Vec<String>,
    /// Voxels of each built-in scene; its own number by default
    #[arg(long)]
    voxels: Option<u64>,
    /// Situations
    #[arg(long, value_enum, value_delimiter = ',', default_values_t = Situation::ALL)]
    situations: Vec<Situation>,
    /// Parts of real-time light: raw, temporal, cache, filter, all; after a cut also as many samples filtered as stills: denoise, oidn
    #[arg(long, value_delimiter = ',', default_value = "raw,temporal,cache,filter,all,denoise,oidn")]
    parts: Vec<String>,
    /// Size of the pictures
    #[arg(long, default_value = "240x136")]
    size: String,
    /// Samples of the pictures to compare with
    #[arg(long, default_value_t = 4096)]
    samples: u32,
    /// Last frame of each situation
    #[arg(long, default_value_t = u32::MAX)]
    frames: u32,
    /// Seeds of which values are the means: one alone may be a per cent of light beside what many are
    #[arg(long, default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..))]
    seeds: u32,
    /// Folder that keeps scenes, pictures of many samples and what was measured
    #[arg(long, default_value = "target/realtime")]
    cache: PathBuf,
    /// Makes real-time pictures on the device, too
    #[arg(long)]
    on_device: bool,
    /// Measures how long the steps take on the device, and nothing else
    #[arg(long)]
    timing: bool,
    /// Prints the table of what was measured, and measures nothing
    #[arg(long)]
    table: bool,
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
        "cache" => Parts { cache: true, candidates: true, visibility: true, ..memory },
        "filter" => Parts { filter: true, ..memory },
        "all" => Parts::ALL,
        _ => return Err(format!("no parts {name:?}: raw, temporal, cache, filter, all").into()),
    })
}

/// Half of the balls of NAME+glass are of glass, half of metal.
fn add_glass(scene: &mut Scene) -> Outcome<()> {
    let glass = Material { base_color: Vec3::new(0.9, 0.95, 0.9), transmission: 1.0, ior: 1.5, ..Material::default() };
    let metal = Material { base_color: Vec3::new(0.9, 0.7, 0.4), metallic: 1.0, roughness: 0.2, ..Material::default() };
    situations::add_balls(scene, &[glass, metal])
}

/// A built-in scene, and its view; with what moves in a situation.
fn scene_of(args: &Args, name: &str, situation: Option<Situation>) -> Outcome<(PackedScene, Frame)> {
    let (name, more) = name.split_once('+').unwrap_or((name, ""));
    let add = |suffix: &str, add: fn(&mut Scene) -> Outcome<()>| {
        common::packed_scene_with(&args.cache, (name, suffix), args.voxels, add)
    };
    let path = match (more, situation) {
        ("balls", _) | ("", Some(Situation::Moving)) => add("-moving", situations::add_moving)?,
        ("glass", None) => add("-glass", add_glass)?,
        ("", _) => common::packed_scene(&args.cache, name, args.voxels)?,
        _ => return Err(format!("{name}+{more}: +balls, or for times +glass").into()),
    };
    let scene = match load(&path, &ImportOptions::default())?.content {
        Content::Packed(packed) => *packed,
        Content::Scene(scene) => PackedScene::pack(&scene)?,
    };
    let (width, height) = args.size.split_once('x').ok_or("a size is WIDTHxHEIGHT")?;
    let camera = scene.cameras.first().ok_or("a scene without a camera")?.clone();
    let frame = Frame::new(camera, width.parse()?, height.parse()?).max_bounces(still_lifes::max_bounces(name));
    Ok((scene, frame))
}

/// What of a filter of stills has a name.
fn still_filter(name: &str) -> Option<StillFilter> {
    match name {
        "denoise" => Some(StillFilter::Ours),
        "oidn" => Some(StillFilter::Oidn),
        _ => None,
    }
}

/// One of the columns that are compared.
struct Column<'a> {
    name: &'a str,
    maker: Option<Maker>,
    totals: Totals,
}

impl Column<'_> {
    /// The picture of a step; `None` where its filter is not asked for it.
    fn picture(&mut self, references: &mut References, of: (&str, Situation, &Step)) -> Outcome<Option<Vec<Vec3>>> {
        let step = of.2;
        match (&mut self.maker, still_filter(self.name)) {
            (Some(maker), _) => maker.frame(step).map(Some),
            (None, Some(filter)) if step.samples > 0 => references.filtered(of, step.label.parse()?, filter).map(Some),
            _ => Ok(None),
        }
    }
}

/// Values of each label and part, one for each seed.
type Measured<'a> = Vec<((String, &'a str), Vec<[f64; 4]>)>;

/// Measures what of a situation was not measured yet.
fn measure(
    args: &Args,
    (name, situation): (&str, Situation),
    references: &mut References,
    results: &mut Results,
) -> Outcome<()> {
    let is_wanted = |parts: &&String| {
        let has = still_filter(parts).is_none_or(|filter| situation.is_still() && references.has(filter));
        has && !results.has(name, &situation.to_string(), parts)
    };
    let wanted: Vec<&str> = args.parts.iter().filter(is_wanted).map(String::as_str).collect();
    if wanted.is_empty() {
        return Ok(());
    }
    let mut measured = Measured::new();
    for seed in 0..args.seeds {
        measure_seed(args, (name, situation, seed), &wanted, references, &mut measured)?;
    }
    for ((frame, parts), values) in measured {
        let mean = |value: usize| values.iter().map(|values| values[value]).sum::<f64>() / values.len() as f64;
        let (scene, situation, parts) = (name.to_owned(), situation.to_string(), parts.to_owned());
        results.add(Line { scene, situation, frame, parts, values: std::array::from_fn(mean) })?;
    }
    Ok(())
}

/// The values of one seed. Filters of stills have those of the first alone.
fn measure_seed<'a>(
    args: &Args,
    (name, situation, seed): (&str, Situation, u32),
    wanted: &[&'a str],
    references: &mut References,
    measured: &mut Measured<'a>,
) -> Outcome<()> {
    let (scene, frame) = scene_of(args, name, Some(situation))?;
    let Some(steps) = situation.steps(scene, &frame.seed(seed))? else { return Ok(()) };
    let column = |&name: &&'a str| {
        let maker = if still_filter(name).is_some() { None } else { Some(Maker::new(args, parts(name)?)?) };
        Ok(Column { name, maker, totals: Totals::default() })
    };
    let is_asked = |name: &&&str| seed == 0 || still_filter(name).is_none();
    let mut columns: Vec<Column> = wanted.iter().filter(is_asked).map(column).collect::<Outcome<_>>()?;
    let mut add = |label: &str, parts: &'a str, values: [f64; 4]| {
        let key = (label.to_owned(), parts);
        match measured.iter_mut().find(|(other, _)| *other == key) {
            Some((_, all)) => all.push(values),
            None => measured.push((key, vec![values])),
        }
    };
    for step in &steps {
        let is_over = step.label.parse::<u32>().is_ok_and(|number| number > args.frames);
        if is_over {
            break;
        }
        let of = (name, situation, step);
        let reference = if step.samples > 0 { Some(references.picture(of)?) } else { None };
        for column in &mut columns {
            let Some(picture) = column.picture(references, of)? else { continue };
            if column.maker.is_some() {
                column.totals.follow(&picture, &step.frame, situation.is_still());
            }
            let Some(reference) = &reference else { continue };
            let quality = Quality::of(reference, &picture, &step.frame)?;
            if let Some(folder) = args.pictures.as_ref().filter(|_| seed == 0) {
                quality.write(folder, &format!("{name}-{situation}-{}-{}", column.name, step.label))?;
            }
            column.totals.add(&quality);
            if situation.has_each_step() {
                add(&step.label, column.name, quality.values());
            }
        }
    }
    for column in &columns {
        add("mean", column.name, column.totals.values(situation));
    }
    Ok(())
}

fn main() -> Outcome<()> {
    let args = Args::parse();
    std::fs::create_dir_all(&args.cache)?;
    if args.timing {
        return timing::measure(&args);
    }
    let mut results = Results::open(args.cache.join("results.tsv"))?;
    if args.table {
        print!("{}", results.table());
        return Ok(());
    }
    let mut references = References::new(&args);
    for name in &args.scenes {
        for &situation in &args.situations {
            measure(&args, (name, situation), &mut references, &mut results)?;
        }
    }
    Ok(())
}
