//! `cargo bench -p voxtrace-tests --bench rays`: how many rays a second one core casts through the built-in scenes, and with the
//! feature `embree` how many Embree 3 casts, same rays, same run. `docs/benchmarks.md` explains method and options.

mod by_instructions;
#[allow(unsafe_code, reason = "one call of the C library")]
mod clock;
mod contender;
#[cfg(feature = "embree")]
#[expect(unsafe_code, reason = "Embree is a C library")]
mod embree;
mod ray_sets;
mod report;
mod rounds;

use clap::Parser;
use contender::{Contender, Walk};
use ray_sets::Order;
use report::Report;
use std::error::Error;
use std::path::PathBuf;
use std::time::Instant;
use voxtrace::{PackedScene, scenes};

/// Largest share of rays for which Embree, which computes in single precision, may hit another voxel.
const MOST_MISMATCHES: f64 = 1e-3;

/// Measures rays on one core.
#[derive(Parser)]
struct Options {
    /// A built-in scene; may be given more than once [default: church and city].
    #[arg(long, value_name = "NAME")]
    scene: Vec<String>,
    /// About how many voxels the scenes have [default: those of the study].
    #[arg(long)]
    voxels: Option<u64>,
    /// About how many camera rays are cast [default: 1,048,576].
    #[arg(long)]
    rays: Option<usize>,
    /// Order of the pixels within a tile.
    #[arg(long, value_enum, default_value_t)]
    order: Order,
    /// Timed rounds for each set of rays [default: 7].
    #[arg(long, value_parser = clap::value_parser!(u64).range(1..))]
    rounds: Option<u64>,
    /// One table of ray after ray, AVX2 and AVX-512, beside Embree held to the same instructions [scenes: church, city and operating-room].
    #[arg(long)]
    by_instructions: bool,
    /// Also write the results to this file, as JSON.
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Given by `cargo bench`. Without it, as under `cargo test --benches`, everything runs once and small.
    #[arg(long, hide = true)]
    bench: bool,
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut options = Options::parse();
    if !options.bench {
        options.voxels = options.voxels.or(Some(50_000));
        options.rays = options.rays.or(Some(1 << 14));
        options.rounds = options.rounds.or(Some(1));
    }
    if options.scene.is_empty() {
        let names: &[&str] =
            if options.by_instructions { &["church", "city", "operating-room"] } else { &["church", "city"] };
        options.scene = names.iter().map(|&name| name.to_owned()).collect();
    }
    println!("Processor: {}\n", processor());
    if options.by_instructions {
        println!("{}", by_instructions::head());
    }
    let mut results = Vec::new();
    for scene in &options.scene {
        results.push(run(scene, &options)?);
    }
    if let Some(path) = &options.json {
        let document = serde_json::json!({ "processor": processor(), "scenes": results });
        std::fs::write(path, serde_json::to_string_pretty(&document)? + "\n")?;
    }
    Ok(())
}

/// Measures one scene, prints its table and returns its JSON.
fn run(name: &str, options: &Options) -> Result<serde_json::Value, Box<dyn Error>> {
    let scene = scenes::generate(name, options.voxels)?;
    let start = Instant::now();
    let packed = PackedScene::pack(&scene)?;
    let pack_time = start.elapsed();
    let sets = ray_sets::ray_sets(&packed, options.rays.unwrap_or(1 << 20), options.order);
    if options.by_instructions {
        let (lines, json) = by_instructions::rows(name, &scene, &packed, &sets, options.rounds.unwrap_or(7) as usize);
        println!("{lines}");
        return Ok(json);
    }
    let walks = Walk::all(&packed, pack_time);
    let ours = walks.len();
    let mut contenders: Vec<Box<dyn Contender>> =
        walks.into_iter().map(|walk| Box::new(walk) as Box<dyn Contender>).collect();
    #[cfg(feature = "embree")]
    {
        let [grid] = &scene.grids[..] else { return Err("the scene is not one grid".into()) };
        let table_bytes = size_of_val(packed.materials()) as u64;
        contenders.push(Box::new(embree::Boxes::build(grid, table_bytes, c"")));
        contenders.push(Box::new(embree::Quads::build(grid, table_bytes, c"")));
    }
    let rounds = options.rounds.unwrap_or(7) as usize;
    let measured = sets.iter().map(|set| rounds::measure(&mut contenders, set, rounds)).collect();
    let report = Report {
        scene: name,
        voxels: scene.grids.iter().map(|grid| grid.count()).sum(),
        sets: sets.iter().map(|set| (set.name, set.rays.len())).collect(),
        contenders: &contenders,
        measured,
    };
    println!("{}", report.markdown()?);
    for (index, contender) in contenders.iter().enumerate() {
        let share = report.mismatch_share(index);
        if share > MOST_MISMATCHES || (index < ours && share > 0.0) {
            return Err(format!("{}: {:.4} % of the rays met another voxel", contender.name(), share * 100.0).into());
        }
    }
    Ok(report.json())
}

/// The processor's name where the system tells it (Linux).
fn processor() -> String {
    let info = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let value = |key: &str| {
        let line = info.lines().find(|line| line.starts_with(key))?;
        Some(line.split_once(':')?.1.trim().to_owned())
    };
    match (value("model name"), value("cpu MHz")) {
        (Some(name), Some(clock)) => format!("{name}, {clock} MHz"),
        (Some(name), None) => name,
        _ => "unknown".into(),
    }
}
