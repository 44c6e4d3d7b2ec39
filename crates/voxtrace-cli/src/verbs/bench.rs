//! `voxtrace bench`: the study's measurement on this machine, by one command: frame times, rays and memory of each
//! traversal and primitive, as a report, JSON and CSV.

mod cells;
mod charts;
mod conformance;
mod driver;
mod figures;
mod html;
mod interval;
mod machine;
mod measure;
mod numbers;
mod plan_file;
mod plot;
mod proof;
mod results;
mod resume;
mod sweep;
mod table;
mod tables;
mod verdict;

use crate::camera_file;
use crate::edits::EditArgs;
use crate::failure::Failure;
use crate::interrupt;
use crate::load::{NativeArgs, SceneArgs};
use crate::mesh::MeshArgs;
use crate::parse::{self, Size};
use crate::report::{Report, clock};
use crate::volume::VolumeArgs;
use crate::voxels::HeightArgs;
use cells::Cell;
use conformance::{Conformance, Reference};
use measure::Effort;
use numbers::{FrameLine, write_csv};
use rayon::prelude::*;
use results::{Emulation, Figures, Plan, Results, Row, SceneFacts};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, Instant};
use voxtrace::output::write_atomically;
use voxtrace::{Camera, Frame, Hit, Integrator, PackedScene, Region, nearest_centre, scenes};
use voxtrace_vulkan::{Device, DeviceInfo, DeviceKind, Primitive, Traversal};

/// Frames of the study.
const FRAMES: u32 = 4096;
const QUICK_FRAMES: u32 = 256;
const QUICK_LIMIT: Duration = Duration::from_secs(4);
/// Longest time of a cell on the CPU or a device in software, where none is asked for.
const SOFTWARE_LIMIT: Duration = Duration::from_secs(60);
/// The same of the CPU beside a GPU.
const BESIDE_LIMIT: Duration = Duration::from_secs(20);
/// Voxels of the built-in scenes with `--quick` on a device in software, which takes no more than about four million.
const QUICK_SOFTWARE_VOXELS: u64 = 500_000;
/// Size of the study's pictures (sic), and of those with `--quick` on a device in software.
const SIZE: Size = (1980, 1080);
const QUICK_SOFTWARE_SIZE: Size = (495, 270);
/// How much larger boxes are where the nearest-centre rule is emulated, voxels.
const EMULATED_MARGIN: f32 = 1.0 / 128.0;
const SEED: u32 = 1;

/// Measure frame times, rays and memory, and write a report
#[derive(clap::Args, Clone, Debug)]
pub struct BenchArgs {
    /// Files or names of built-in scenes [default: city, operating-room and church]
    #[arg(value_name = "SCENE")]
    scenes: Vec<String>,
    /// A plan in TOML, ours or FastVoxels' config.toml; options have the last word
    #[arg(long, value_name = "FILE")]
    plan: Option<PathBuf>,
    /// Files with camera and light, of the scenes of a plan
    #[arg(skip)]
    cameras: Vec<Option<PathBuf>>,
    /// Size of the built-in scenes, for example 500000, 500k or 13.6M voxels
    #[arg(long, value_name = "N", value_parser = parse::voxels)]
    voxels: Option<u64>,
    /// Folder of the report, made if it is not there
    #[arg(short, long, value_name = "FOLDER", default_value = "voxtrace-bench")]
    output: PathBuf,
    /// Frames of each cell [default: 4096; with --quick 256]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    frames: Option<u32>,
    /// Frames before the first that counts [default: 20]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(0..=100_000))]
    warm_up: Option<u32>,
    /// Most time of each cell's frames [default: none on a GPU, 60s in software; with --quick 4s]
    #[arg(long, value_name = "TIME", value_parser = parse::duration)]
    time_limit: Option<Duration>,
    /// About a minute in all
    #[arg(long)]
    quick: bool,
    /// Every traversal and primitive that the device offers, and the CPU
    #[arg(long, conflicts_with = "cells")]
    full: bool,
    /// Go on with a benchmark that was stopped: what is in the folder is not measured again
    #[arg(long)]
    resume: bool,
    /// Sizes of the built-in scenes for frame time and memory against voxels; `none` leaves that out [default: 500k to
    /// 16M, with --quick none]
    #[arg(long, value_name = "N,…", value_delimiter = ',', value_parser = sweep_size)]
    sweep: Option<Vec<u64>>,
    /// What to measure: TRAVERSAL, TRAVERSAL:PRIMITIVE or TRAVERSAL:all [default: pipeline:voxel-exact,pipeline:voxel-approx]
    #[arg(long, value_name = "CELL", value_delimiter = ',')]
    cells: Vec<String>,
    /// Size of the picture [default: 1980x1080; with --quick on a device in software 495x270]
    #[arg(long, value_name = "WxH", value_parser = parse::size)]
    size: Option<Size>,
    /// Most surfaces that scatter one path [default: 3]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(0..=1024))]
    max_bounces: Option<u32>,
    /// Shaders that give the CPU's bits, not the quicker ones whose rounding is left to the driver
    #[arg(long)]
    precise: bool,
    /// Device by its number or a part of its name, as `voxtrace devices` lists them
    #[arg(long, value_name = "DEVICE", env = "VOXTRACE_DEVICE", hide_env_values = true)]
    device: Option<String>,
    /// Print results.json rather than a table
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    mesh: MeshArgs,
    #[command(flatten)]
    volume: VolumeArgs,
    #[command(flatten)]
    native: NativeArgs,
}

/// A size of the sweep; 0 for `none`.
fn sweep_size(text: &str) -> Result<u64, String> {
    if text == "none" { Ok(0) } else { parse::voxels(text) }
}

impl BenchArgs {
    pub fn run(mut self, report: &mut Report) -> Result<(), Failure> {
        if let Some(path) = &self.plan {
            let plan = plan_file::open(path)?;
            self.follow(plan);
        }
        let asked: Vec<Vec<Cell>> =
            self.cells.iter().map(|cell| cells::parse(cell)).collect::<Result<_, _>>().map_err(Failure::usage)?;
        let open = self.device(report)?;
        let device = open.as_ref().map(|device| device.info().clone());
        let mut cells = if asked.is_empty() { cells::planned(device.as_ref(), self.full) } else { asked.concat() };
        let mut seen = Vec::new();
        cells.retain(|cell| {
            !seen.contains(cell) && {
                seen.push(*cell);
                true
            }
        });
        let plan = self.plan(cells, device.as_ref());
        let mut results = Results {
            plan,
            device,
            scenes: Vec::new(),
            rows: Vec::new(),
            sweep: Vec::new(),
            doctor: None,
            is_complete: false,
        };
        std::fs::create_dir_all(&self.output).map_err(|error| Failure::output(&self.output, &error))?;
        if self.resume {
            resume::load(&self.output, &mut results)?;
        }
        if let (None, Some(device)) = (&results.doctor, &open) {
            results.doctor = driver::probed(device, report);
        }
        drop(open);
        let mut pace = Pace::new(&results);
        if pace.before > 0 {
            report.remark(&format!("{} of {} are measured already", pace.before, pace.all));
        }
        self.write_results(&results)?;
        let outcome = self.measure(&mut results, &mut pace, report);
        results.is_complete = outcome.is_ok() && pace.done() == pace.all && !interrupt::is_requested();
        self.write_results(&results)?;
        self.write_page(&results)?;
        outcome?;
        if self.json {
            crate::print(&format!("{:#}\n", results.json()));
        } else {
            crate::print(&tables::compact(&results));
        }
        report.remark(&format!("the report is {}", self.output.join("report.html").display()));
        if interrupt::is_requested() {
            return Err(measure::interrupted(&self.output));
        }
        Ok(())
    }

    /// Takes from a plan what no option says.
    fn follow(&mut self, plan: plan_file::PlanFile) {
        if self.scenes.is_empty() {
            (self.scenes, self.cameras) = plan.scenes.into_iter().map(|scene| (scene.name, scene.camera)).unzip();
        }
        if self.cells.is_empty() && !self.full {
            self.cells = plan.cells;
        }
        self.frames = self.frames.or(plan.frames);
        self.warm_up = self.warm_up.or(plan.warm_up);
        self.time_limit = self.time_limit.or(plan.time_limit);
        self.size = self.size.or(plan.size);
        self.max_bounces = self.max_bounces.or(plan.max_bounces);
        self.voxels = self.voxels.or(plan.voxels);
        self.sweep = self.sweep.take().or(plan.sweep);
        self.device = self.device.take().or(plan.device);
        self.precise |= plan.precise;
    }

    /// Measures what is missing: the scenes, then the sweep. Ends early where that is asked for.
    fn measure(&self, results: &mut Results, pace: &mut Pace, report: &mut Report) -> Result<(), Failure> {
        for (index, name) in results.plan.scenes.clone().iter().enumerate() {
            let is_missing = |cell: &Cell| results.row(index, *cell).is_none();
            let missing: Vec<Cell> = results.plan.cells.iter().copied().filter(is_missing).collect();
            if interrupt::is_requested() {
                return Ok(());
            }
            if missing.is_empty() && index < results.scenes.len() {
                continue;
            }
            self.measure_scene(index, name, &missing, results, pace, report)?;
            self.write_page(results)?;
        }
        self.measure_sweep(results, pace, report)
    }

    fn measure_scene(
        &self,
        index: usize,
        name: &str,
        missing: &[Cell],
        results: &mut Results,
        pace: &mut Pace,
        report: &mut Report,
    ) -> Result<(), Failure> {
        report.remark(&format!("loading {name}"));
        let (stem, mut scene) = self.load(name, results.plan.voxels, report)?;
        if let Some(Some(path)) = self.cameras.get(index) {
            let file = camera_file::open(path)?;
            scene.sky.brightness = file.sky_brightness.unwrap_or(scene.sky.brightness);
            scene.light_intensity = file.light_intensity.unwrap_or(scene.light_intensity);
            scene.cameras.insert(0, file.camera);
        }
        let frame = self.frame(&scene, &results.plan);
        let reference = Reference::of(&scene, &frame);
        let facts = SceneFacts::of(&stem, &scene, &frame.camera.name);
        match results.scenes.get(index) {
            Some(before) if before.hash != facts.hash => {
                let message = format!("{name} is another scene than before: {} and {}", before.hash, facts.hash);
                return Err(Failure::mismatch(message).hint("name another folder for the report"));
            }
            Some(_) => {}
            None => {
                let facts = self.with_figures(index, facts, &scene, &reference, &results.plan.cells)?;
                results.scenes.push(facts);
            }
        }
        let scene = Arc::new(scene);
        for &cell in missing {
            if interrupt::is_requested() {
                return Ok(());
            }
            let effort = self.effort(cell, results);
            let place = format!("{}/{}", pace.done() + 1, pace.all);
            report.begin_work(&format!("{place} {stem} {}", cell.name()), effort.frames.into());
            let mut measured = measure::measure(cell, &scene, &frame, Some(&reference), &effort, report);
            report.end();
            let (film, hits) = (measured.film.take(), std::mem::take(&mut measured.hits));
            let mut row = Row::new(index, cell, measured);
            self.write_row(&mut row, &stem)?;
            self.write_figures(&mut row, &stem, &scene, &reference, film.as_ref(), &hits)?;
            let told = match (row.summary(), &row.measured.failure) {
                (Some(summary), None) => format!("{:.3} ms median, {:.1} fps", summary.median, summary.fps),
                (_, Some(reason)) => format!("failed: {reason}"),
                (None, None) => "interrupted".into(),
            };
            if !row.measured.is_interrupted {
                pace.step();
            }
            report.remark(&format!("{place} {stem} {}: {told}; about {} left", cell.name(), pace.left()));
            results.insert(row);
            // So that what is measured is there whatever happens to the next cell.
            self.write_results(results)?;
        }
        Ok(())
    }

    /// Measures the sizes of the sweep that are missing.
    fn measure_sweep(&self, results: &mut Results, pace: &mut Pace, report: &mut Report) -> Result<(), Failure> {
        for name in results.plan.sweep_scenes() {
            for wanted in results.plan.sweep.clone() {
                let is_missing = |cell: &Cell| results.sweep_row(&name, *cell, wanted).is_none();
                let missing: Vec<Cell> = results.plan.sweep_cells().into_iter().filter(is_missing).collect();
                if interrupt::is_requested() {
                    return Ok(());
                }
                if missing.is_empty() {
                    continue;
                }
                let (_, scene) = self.load(&name, Some(wanted), report)?;
                let (frame, scene) = (self.frame(&scene, &results.plan), Arc::new(scene));
                for cell in missing {
                    let effort = self.effort(cell, results);
                    let Some(row) = sweep::measure(&name, cell, wanted, &scene, &frame, &effort, report) else {
                        return Ok(());
                    };
                    results.sweep.push(row);
                    pace.step();
                    self.write_results(results)?;
                }
                let size = verdict::millions(wanted);
                report.remark(&format!("sweep: {name} of {size} voxels; about {} left", pace.left()));
            }
        }
        Ok(())
    }

    /// The device to measure. Without one, and without being asked for one, the CPU is measured alone.
    fn device(&self, report: &Report) -> Result<Option<Arc<Device>>, Failure> {
        let wants_gpu = self.cells.iter().any(|cell| !cell.starts_with(Traversal::Cpu.name()));
        if self.device.is_none() && !self.cells.is_empty() && !wants_gpu {
            return Ok(None);
        }
        match measure::open_device(self.device.as_deref()) {
            Err(error) if self.device.is_some() => Err(crate::session::trace_failure(error)),
            Err(error) => {
                report.remark(&format!("no GPU: {error}"));
                Ok(None)
            }
            Ok(device) => {
                let is_software = device.info().kind == DeviceKind::Cpu;
                if is_software && self.device.is_none() && self.cells.is_empty() {
                    report.remark(&format!(
                        "measuring the CPU: {} is software (--device 0 measures it)",
                        device.info().name
                    ));
                    return Ok(None);
                }
                report.remark(&format!("measuring {}, driver {}", device.info().name, device.info().driver));
                Ok(Some(device))
            }
        }
    }

    fn plan(&self, cells: Vec<Cell>, device: Option<&DeviceInfo>) -> Plan {
        let names = match self.scenes.is_empty() {
            true => scenes::NAMES.map(str::to_owned).to_vec(),
            false => self.scenes.clone(),
        };
        let is_hardware = device.is_some_and(|device| device.kind != DeviceKind::Cpu);
        let is_slow = device.is_some() && !is_hardware;
        let (width, height) = self.size.unwrap_or(if self.quick && is_slow { QUICK_SOFTWARE_SIZE } else { SIZE });
        let most = if is_hardware { u64::MAX } else { sweep::MOST_IN_SOFTWARE };
        let usual = || sweep::SIZES.into_iter().filter(|&size| size <= most && !self.quick).collect();
        let mut sweep: Vec<u64> = self.sweep.clone().unwrap_or_else(usual);
        sweep.retain(|&size| size > 0);
        Plan {
            scenes: names,
            cells,
            voxels: self.voxels.or((self.quick && is_slow).then_some(QUICK_SOFTWARE_VOXELS)),
            sweep,
            frames: self.frames.unwrap_or(if self.quick { QUICK_FRAMES } else { FRAMES }),
            warm_up: self.warm_up.unwrap_or(20),
            time_limit_s: self.limit().map(|limit| limit.as_secs_f64()),
            width,
            height,
            max_bounces: self.max_bounces.unwrap_or(3),
            seed: SEED,
            is_exact: self.precise,
        }
    }

    fn limit(&self) -> Option<Duration> {
        self.time_limit.or(self.quick.then_some(QUICK_LIMIT))
    }

    fn effort(&self, cell: Cell, results: &Results) -> Effort {
        let is_software = results.device.as_ref().is_none_or(|device| device.kind == DeviceKind::Cpu);
        let own = match cell.traversal {
            Traversal::Cpu if !is_software => Some(BESIDE_LIMIT),
            _ => is_software.then_some(SOFTWARE_LIMIT),
        };
        Effort {
            frames: results.plan.frames,
            warm_up: results.plan.warm_up,
            time_limit: self.limit().or(own),
            is_exact: self.precise,
            device: self.device.clone(),
            is_brief: false,
        }
    }

    /// A scene and the name that its files are called after.
    fn load(&self, name: &str, voxels: Option<u64>, report: &mut Report) -> Result<(String, PackedScene), Failure> {
        let voxels = voxels.filter(|_| scenes::NAMES.contains(&name));
        let (mesh, volume) = (self.mesh.clone(), self.volume.clone());
        let args = SceneArgs {
            scene: name.to_owned(),
            voxels,
            mesh,
            volume,
            edits: EditArgs::default(),
            heights: HeightArgs::default(),
            native: self.native,
        };
        Ok((args.stem(), args.load(report)?.into_packed()?))
    }

    fn frame(&self, scene: &PackedScene, plan: &Plan) -> Frame {
        let (width, height) = (plan.width, plan.height);
        let auto = || Camera { name: "auto".into(), ..scene.overview(width as f32 / height as f32) };
        Frame {
            camera: scene.cameras.first().cloned().unwrap_or_else(auto),
            width,
            height,
            region: Region::full(width, height),
            first_sample: 0,
            samples: 0,
            seed: SEED,
            max_bounces: plan.max_bounces,
            integrator: Integrator::Essay,
            transparent: false,
            layers: false,
        }
    }

    /// Writes the frames of a cell.
    fn write_row(&self, row: &mut Row, stem: &str) -> Result<(), Failure> {
        let base = base_name(row.scene, stem, &row.cell.name());
        row.csv = self.write_frames(format!("{base}.csv"), &row.measured.frames)?;
        row.primary_csv = self.write_frames(format!("{base}-primary.csv"), &row.measured.primary)?;
        Ok(())
    }

    /// Writes the pictures of a cell: its film, and where it finds wrong voxels, those.
    fn write_figures(
        &self,
        row: &mut Row,
        stem: &str,
        scene: &PackedScene,
        reference: &Reference,
        film: Option<&voxtrace::Film>,
        hits: &[Hit],
    ) -> Result<(), Failure> {
        let base = base_name(row.scene, stem, &row.cell.name());
        let is_approximate = row.cell.primitive == Some(Primitive::VoxelApprox);
        if let Some(film) = film {
            row.figures.render = Some(self.write_picture(format!("{base}.jpg"), &figures::render(film))?);
        }
        if !hits.is_empty() && (is_approximate || row.measured.conformance.is_some_and(|found| !found.holds(false))) {
            (row.figures.voxels, row.figures.difference) = self.write_voxels(&base, scene, reference, hits)?;
        }
        Ok(())
    }

    fn write_voxels(
        &self,
        base: &str,
        scene: &PackedScene,
        reference: &Reference,
        hits: &[Hit],
    ) -> Result<(Option<String>, Option<String>), Failure> {
        let voxels = self.write_picture(format!("{base}-voxels.jpg"), &figures::voxels(scene, reference, hits))?;
        let difference = self.write_picture(format!("{base}-wrong.png"), &figures::difference(reference, hits))?;
        Ok((Some(voxels), Some(difference)))
    }

    /// Adds the picture of the right voxels, and where no cell of the plan approximates, what the study's rule would find.
    fn with_figures(
        &self,
        index: usize,
        mut facts: SceneFacts,
        scene: &PackedScene,
        reference: &Reference,
        cells: &[Cell],
    ) -> Result<SceneFacts, Failure> {
        let base = base_name(index, &facts.name, "exact");
        let picture = figures::voxels(scene, reference, &reference.hits);
        facts.exact_figure = Some(self.write_picture(format!("{base}-voxels.jpg"), &picture)?);
        if cells.iter().all(|cell| cell.primitive != Some(Primitive::VoxelApprox)) {
            let mut hits = vec![Hit::MISS; reference.rays.len()];
            let pieces = reference.rays.par_chunks(1 << 14).zip(hits.par_chunks_mut(1 << 14));
            pieces.for_each(|(rays, hits)| nearest_centre::cast_batch(scene, rays, EMULATED_MARGIN, hits));
            let base = base_name(index, &facts.name, "emulated");
            let (voxels, difference) = self.write_voxels(&base, scene, reference, &hits)?;
            facts.emulation = Some(Emulation {
                margin: EMULATED_MARGIN.into(),
                conformance: Conformance::of(scene, reference, &hits),
                figures: Figures { render: None, voxels, difference },
            });
        }
        Ok(facts)
    }

    fn write_picture(&self, name: String, picture: &figures::Picture) -> Result<String, Failure> {
        let path = self.output.join(&name);
        write_atomically(&path, |out| match name.ends_with(".jpg") {
            true => picture.write_jpeg(out),
            false => picture.write_png(out),
        })
        .map_err(|error| Failure::output(&path, &error))?;
        Ok(name)
    }

    fn write_frames(&self, name: String, frames: &[FrameLine]) -> Result<Option<String>, Failure> {
        if frames.is_empty() {
            return Ok(None);
        }
        let path = self.output.join(&name);
        write_atomically(&path, |out| write_csv(frames, out)).map_err(|error| Failure::output(&path, &error))?;
        Ok(Some(name))
    }

    fn write_results(&self, results: &Results) -> Result<(), Failure> {
        let json = format!("{:#}\n", results.json());
        self.write_text("results.json", &json)?;
        self.write_text("report.md", &tables::report(results))
    }

    /// Writes the page and its charts.
    fn write_page(&self, results: &Results) -> Result<(), Failure> {
        for (name, plot) in charts::all(results) {
            self.write_text(&name, &plot.svg(true))?;
        }
        self.write_text("report.html", &html::page(results, &self.output))
    }

    fn write_text(&self, name: &str, text: &str) -> Result<(), Failure> {
        let path: &Path = &self.output.join(name);
        let write = |out: &mut std::io::BufWriter<std::fs::File>| std::io::Write::write_all(out, text.as_bytes());
        write_atomically(path, write).map_err(|error| Failure::output(path, &error))
    }
}

/// What the files of a cell are called.
fn base_name(scene: usize, stem: &str, cell: &str) -> String {
    format!("{}-{stem}-{}", scene + 1, cell.replace(':', "-"))
}

/// How far the work is.
struct Pace {
    start: Instant,
    all: usize,
    /// Measured in an earlier run, and in this one.
    before: usize,
    now: usize,
}

impl Pace {
    fn new(results: &Results) -> Self {
        let plan = &results.plan;
        let sweep = plan.sweep_scenes().len() * plan.sweep.len() * plan.sweep_cells().len();
        let all = plan.scenes.len() * plan.cells.len() + sweep;
        Self { start: Instant::now(), all, before: results.rows.len() + results.sweep.len(), now: 0 }
    }

    fn done(&self) -> usize {
        self.before + self.now
    }

    fn step(&mut self) {
        self.now += 1;
    }

    /// The time that is left, if what is left takes as long as what was done.
    fn left(&self) -> String {
        let rest = self.all.saturating_sub(self.done());
        clock(self.start.elapsed().as_secs_f64() / self.now.max(1) as f64 * rest as f64)
    }
}
