//! `voxtrace bench`: the study's measurement on this machine, by one command: frame times, rays and memory of each
//! traversal and primitive, as a report, JSON and CSV.

mod cells;
mod measure;
mod numbers;
mod results;
mod tables;

use crate::failure::Failure;
use crate::interrupt;
use crate::load::SceneArgs;
use crate::mesh::MeshArgs;
use crate::parse::{self, Size};
use crate::report::{Report, clock};
use crate::volume::VolumeArgs;
use cells::Cell;
use measure::{Effort, Measured};
use numbers::{FrameLine, write_csv};
use results::{Plan, Results, Row, SceneFacts};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, Instant};
use voxtrace::output::write_atomically;
use voxtrace::{Camera, Frame, Integrator, PackedScene, Region, scenes};
use voxtrace_vulkan::{DeviceKind, Traversal};

/// Frames of the study.
const FRAMES: u32 = 4096;
const QUICK_FRAMES: u32 = 256;
const QUICK_LIMIT: Duration = Duration::from_secs(4);
/// Longest time of a cell on the CPU or a device in software, where none is asked for.
const SOFTWARE_LIMIT: Duration = Duration::from_secs(60);
const SEED: u32 = 1;

/// Measure frame times, rays and memory, and write a report
#[derive(clap::Args, Clone, Debug)]
pub struct BenchArgs {
    /// Files or names of built-in scenes [default: city, operating-room and church]
    #[arg(value_name = "SCENE")]
    scenes: Vec<String>,
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
    /// What to measure: TRAVERSAL, TRAVERSAL:PRIMITIVE or TRAVERSAL:all [default: pipeline:voxel-exact,pipeline:voxel-approx]
    #[arg(long, value_name = "CELL", value_delimiter = ',')]
    cells: Vec<String>,
    /// Size of the picture
    #[arg(long, value_name = "WxH", default_value = "1980x1080", value_parser = parse::size)]
    size: Size,
    /// Most surfaces that scatter one path
    #[arg(long, value_name = "N", default_value = "3", value_parser = clap::value_parser!(u32).range(0..=1024))]
    max_bounces: u32,
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
}

impl BenchArgs {
    pub fn run(self, report: &mut Report) -> Result<(), Failure> {
        let asked: Vec<Vec<Cell>> =
            self.cells.iter().map(|cell| cells::parse(cell)).collect::<Result<_, _>>().map_err(Failure::usage)?;
        let device = self.device(report)?;
        let cells = if asked.is_empty() { cells::planned(device.as_ref(), self.full) } else { asked.concat() };
        std::fs::create_dir_all(&self.output).map_err(|error| Failure::output(&self.output, &error))?;
        let names = match self.scenes.is_empty() {
            true => scenes::NAMES.map(str::to_owned).to_vec(),
            false => self.scenes.clone(),
        };
        let mut results =
            Results { plan: self.plan(), device, scenes: Vec::new(), rows: Vec::new(), is_complete: false };
        let (start, all) = (Instant::now(), names.len() * cells.len());
        self.write_results(&results)?;
        'scenes: for name in &names {
            if interrupt::is_requested() {
                break;
            }
            report.remark(&format!("loading {name}"));
            let (stem, scene) = self.load(name, report)?;
            let frame = self.frame(&scene);
            results.scenes.push(SceneFacts::of(&stem, &scene, &frame.camera.name));
            let scene = Arc::new(scene);
            for &cell in &cells {
                if interrupt::is_requested() {
                    break 'scenes;
                }
                let effort = self.effort(cell, &results);
                let place = format!("{}/{all}", results.rows.len() + 1);
                report.begin_work(&format!("{place} {stem} {}", cell.name()), effort.frames.into());
                let measured = measure::measure(cell, &scene, &frame, &effort, report);
                report.end();
                let row = self.row(results.scenes.len() - 1, &stem, cell, measured)?;
                let done = results.rows.len() + 1;
                let left = start.elapsed().as_secs_f64() / done as f64 * (all - done) as f64;
                let told = match (row.summary(), &row.measured.failure) {
                    (Some(summary), None) => format!("{:.3} ms median, {:.1} fps", summary.median, summary.fps),
                    (_, Some(reason)) => format!("failed: {reason}"),
                    (None, None) => "interrupted".into(),
                };
                report.remark(&format!("{place} {stem} {}: {told}; about {} left", cell.name(), clock(left)));
                results.rows.push(row);
                // So that what is measured is there whatever happens to the next cell.
                self.write_results(&results)?;
            }
        }
        results.is_complete = results.rows.len() == all && !interrupt::is_requested();
        self.write_results(&results)?;
        if self.json {
            crate::print(&format!("{:#}\n", results.json()));
        } else {
            crate::print(&tables::compact(&results));
        }
        report.remark(&format!("the report is {}", self.output.join("report.md").display()));
        if interrupt::is_requested() {
            return Err(measure::interrupted(&self.output));
        }
        Ok(())
    }

    /// The device to measure. Without one, and without being asked for one, the CPU is measured alone.
    fn device(&self, report: &Report) -> Result<Option<voxtrace_vulkan::DeviceInfo>, Failure> {
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
                Ok(Some(device.info().clone()))
            }
        }
    }

    fn plan(&self) -> Plan {
        let (width, height) = self.size;
        Plan {
            frames: self.frames.unwrap_or(if self.quick { QUICK_FRAMES } else { FRAMES }),
            warm_up: self.warm_up.unwrap_or(20),
            time_limit_s: self.limit().map(|limit| limit.as_secs_f64()),
            width,
            height,
            max_bounces: self.max_bounces,
            seed: SEED,
            is_exact: self.precise,
        }
    }

    fn limit(&self) -> Option<Duration> {
        self.time_limit.or(self.quick.then_some(QUICK_LIMIT))
    }

    fn effort(&self, cell: Cell, results: &Results) -> Effort {
        let is_software = cell.traversal == Traversal::Cpu
            || results.device.as_ref().is_some_and(|device| device.kind == DeviceKind::Cpu);
        Effort {
            frames: results.plan.frames,
            warm_up: results.plan.warm_up,
            time_limit: self.limit().or((is_software && self.frames.is_none()).then_some(SOFTWARE_LIMIT)),
            is_exact: self.precise,
            device: self.device.clone(),
        }
    }

    /// A scene and the name that its files are called after.
    fn load(&self, name: &str, report: &mut Report) -> Result<(String, PackedScene), Failure> {
        let is_builtin = scenes::NAMES.contains(&name);
        let args = SceneArgs {
            scene: name.to_owned(),
            voxels: self.voxels.filter(|_| is_builtin),
            mesh: self.mesh.clone(),
            volume: self.volume.clone(),
        };
        Ok((args.stem(), args.load(report)?.into_packed()?))
    }

    fn frame(&self, scene: &PackedScene) -> Frame {
        let (width, height) = self.size;
        let auto = || Camera { name: "auto".into(), ..scene.overview(width as f32 / height as f32) };
        Frame {
            camera: scene.cameras.first().cloned().unwrap_or_else(auto),
            width,
            height,
            region: Region::full(width, height),
            first_sample: 0,
            samples: 0,
            seed: SEED,
            max_bounces: self.max_bounces,
            integrator: Integrator::Essay,
            transparent: false,
            layers: false,
        }
    }

    /// Writes the frames of a cell.
    fn row(&self, scene: usize, stem: &str, cell: Cell, measured: Measured) -> Result<Row, Failure> {
        let base = format!("{}-{stem}-{}", scene + 1, cell.name().replace(':', "-"));
        let csv = self.write_frames(format!("{base}.csv"), &measured.frames)?;
        let primary_csv = self.write_frames(format!("{base}-primary.csv"), &measured.primary)?;
        Ok(Row { scene, cell, csv, primary_csv, measured })
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

    fn write_text(&self, name: &str, text: &str) -> Result<(), Failure> {
        let path: &Path = &self.output.join(name);
        let write = |out: &mut std::io::BufWriter<std::fs::File>| std::io::Write::write_all(out, text.as_bytes());
        write_atomically(path, write).map_err(|error| Failure::output(path, &error))
    }
}
