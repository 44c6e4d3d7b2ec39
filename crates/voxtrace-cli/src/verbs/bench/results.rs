//! `results.json`: everything that was measured, for programs. `docs/results-format.md` describes the schema; `resume`
//! reads it again.

use super::cells::Cell;
use super::conformance::Conformance;
use super::machine;
use super::measure::Measured;
use super::numbers::{Speeds, Summary};
use super::sweep;
use super::verdict;
use serde_json::{Value, json};
use voxtrace::PackedScene;
use voxtrace_vulkan::DeviceInfo;

/// Version of the schema; it grows when a reader of the old one would misread.
pub const SCHEMA: u32 = 2;
/// Names of the device's allocations that hold no scene, see [`Row::scene_bytes`].
const SCENE_ARRAYS: [&str; 7] =
    ["cells", "bricks", "voxel materials", "grids", "instances", "instance nodes", "materials"];

/// A scene as the rows need it.
#[derive(Clone, Debug)]
pub struct SceneFacts {
    pub name: String,
    pub voxels: u64,
    pub voxels_placed: u64,
    pub hash: String,
    pub camera: String,
    /// Bytes of the packed arrays but the lights, on the host.
    pub packed_bytes: u64,
    /// The picture of the right voxels.
    pub exact_figure: Option<String>,
    /// What the nearest-centre rule would find, where no device was asked.
    pub emulation: Option<Emulation>,
}

/// The study's approximate method, emulated on the CPU.
#[derive(Clone, Debug)]
pub struct Emulation {
    /// How much larger than voxels their boxes are.
    pub margin: f64,
    pub conformance: Conformance,
    pub figures: Figures,
}

impl SceneFacts {
    pub fn of(name: &str, scene: &PackedScene, camera: &str) -> Self {
        let statistics = scene.statistics();
        Self {
            name: name.to_owned(),
            voxels: statistics.voxels,
            voxels_placed: statistics.voxels_placed,
            hash: format!("{:016x}", scene.content_hash()),
            camera: camera.to_owned(),
            packed_bytes: statistics.bytes.iter().filter(|(kind, _)| *kind != "lights").map(|(_, bytes)| bytes).sum(),
            exact_figure: None,
            emulation: None,
        }
    }
}

/// One cell of one scene.
#[derive(Clone, Debug)]
pub struct Row {
    /// Index of the scene.
    pub scene: usize,
    pub cell: Cell,
    pub csv: Option<String>,
    pub primary_csv: Option<String>,
    /// Names of the pictures of this cell.
    pub figures: Figures,
    pub measured: Measured,
    summary: Option<Summary>,
    primary: Option<Summary>,
}

/// Files of pictures, in the folder of the report.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Figures {
    /// The film.
    pub render: Option<String>,
    /// The voxels that it finds, wrong ones black.
    pub voxels: Option<String>,
    /// Where those are.
    pub difference: Option<String>,
}

impl Figures {
    fn json(&self) -> Value {
        json!({ "render": self.render, "voxels": self.voxels, "difference": self.difference })
    }
}

impl Row {
    pub fn new(scene: usize, cell: Cell, measured: Measured) -> Self {
        let (summary, primary) = (Summary::of(&measured.frames), Summary::of(&measured.primary));
        let (csv, primary_csv, figures) = (None, None, Figures::default());
        Self { scene, cell, csv, primary_csv, figures, measured, summary, primary }
    }

    pub fn summary(&self) -> Option<Summary> {
        self.summary
    }

    pub fn primary(&self) -> Option<Summary> {
        self.primary
    }

    /// Whether every frame that was begun was proved.
    pub fn is_stable(&self) -> bool {
        let measured = &self.measured;
        measured.lost == 0 && measured.failure.is_none() && measured.film_checks > 0 && self.summary.is_some()
    }

    pub fn speeds(&self) -> Speeds {
        self.summary().map_or_else(Speeds::default, |summary| Speeds::of(&summary, self.primary().as_ref()))
    }

    /// Bytes of the scene's arrays that a tracer of voxels reads, lights left out, as allocated; on the CPU as packed.
    pub fn scene_bytes(&self, facts: &SceneFacts) -> u64 {
        let memory = self.measured.memory.as_ref();
        memory.map_or(facts.packed_bytes, |memory| SCENE_ARRAYS.iter().filter_map(|name| memory.bytes.get(*name)).sum())
    }

    /// Bytes of the records of primitives.
    pub fn record_bytes(&self) -> u64 {
        self.accel().map_or(0, |accel| accel.record_bytes)
    }

    /// Bytes of all acceleration structures.
    pub fn accel_bytes(&self) -> u64 {
        self.accel().map_or(0, |accel| accel.bytes + accel.top_level_bytes)
    }

    /// Bytes of what is traced: structures, records and the scene's arrays.
    pub fn traced_bytes(&self, facts: &SceneFacts) -> u64 {
        self.accel_bytes() + self.record_bytes() + self.scene_bytes(facts)
    }

    fn accel(&self) -> Option<&voxtrace_vulkan::AccelReport> {
        self.measured.memory.as_ref()?.accel.as_ref()
    }
}

/// One size of a scene in the sweep.
#[derive(Clone, Debug)]
pub struct SweepRow {
    pub scene: String,
    pub cell: Cell,
    /// Voxels asked for.
    pub wanted: u64,
    /// Voxels there are.
    pub voxels: u64,
    /// Median milliseconds of the frames, `None` where it failed.
    pub median: Option<f64>,
    pub frames: usize,
    pub lost: u32,
    /// Bytes of what is traced.
    pub bytes: u64,
    pub failure: Option<String>,
}

impl SweepRow {
    fn json(&self) -> Value {
        json!({
            "scene": self.scene, "cell": self.cell.name(), "wanted": self.wanted, "voxels": self.voxels,
            "median_ms": self.median, "frames": self.frames, "lost": self.lost, "bytes": self.bytes,
            "failure": self.failure,
        })
    }
}

/// What was asked for, the same for all cells.
#[derive(Clone, Debug)]
pub struct Plan {
    /// Scenes as they were named.
    pub scenes: Vec<String>,
    pub cells: Vec<Cell>,
    /// Voxels of the built-in scenes, `None` for the study's.
    pub voxels: Option<u64>,
    /// Sizes of the sweep.
    pub sweep: Vec<u64>,
    pub frames: u32,
    pub warm_up: u32,
    pub time_limit_s: Option<f64>,
    pub width: u32,
    pub height: u32,
    pub max_bounces: u32,
    pub seed: u32,
    pub is_exact: bool,
}

impl Plan {
    /// Scenes of the sweep: the built-in ones, once each.
    pub fn sweep_scenes(&self) -> Vec<String> {
        let names = voxtrace::scenes::NAMES.iter().filter(|name| self.scenes.iter().any(|scene| scene == *name));
        names.map(ToString::to_string).collect()
    }

    /// Cells of the sweep.
    pub fn sweep_cells(&self) -> Vec<Cell> {
        self.cells.iter().copied().filter(|&cell| sweep::takes(cell, &self.cells)).collect()
    }

    fn json(&self) -> Value {
        json!({
            "scenes": self.scenes, "cells": self.cells.iter().map(|cell| cell.name()).collect::<Vec<_>>(),
            "voxels": self.voxels, "sweep": self.sweep,
            "width": self.width, "height": self.height, "frames": self.frames, "warm_up": self.warm_up,
            "time_limit_s": self.time_limit_s, "max_bounces": self.max_bounces, "integrator": "essay",
            "seed": self.seed, "shaders": if self.is_exact { "precise" } else { "fast" },
        })
    }
}

/// A whole benchmark, as far as it has come.
pub struct Results {
    pub plan: Plan,
    pub device: Option<DeviceInfo>,
    pub scenes: Vec<SceneFacts>,
    pub rows: Vec<Row>,
    pub sweep: Vec<SweepRow>,
    /// What the probes of the driver said, see `voxtrace doctor`.
    pub doctor: Option<Value>,
    pub is_complete: bool,
}

impl Results {
    /// Puts a row where the plan has it.
    pub fn insert(&mut self, row: Row) {
        let place = |row: &Row| (row.scene, self.plan.cells.iter().position(|&cell| cell == row.cell));
        let at = self.rows.partition_point(|other| place(other) <= place(&row));
        self.rows.insert(at, row);
    }

    pub fn sweep_row(&self, scene: &str, cell: Cell, wanted: u64) -> Option<&SweepRow> {
        self.sweep.iter().find(|row| (row.scene.as_str(), row.cell, row.wanted) == (scene, cell, wanted))
    }

    pub fn row(&self, scene: usize, cell: Cell) -> Option<&Row> {
        self.rows.iter().find(|row| row.scene == scene && row.cell == cell)
    }

    /// How the shaders round, for the rows on a device.
    pub fn rounding(&self, cell: Cell) -> &'static str {
        match (cell.traversal, self.plan.is_exact) {
            (voxtrace_vulkan::Traversal::Cpu, _) | (_, true) => "precise",
            _ => "fast",
        }
    }

    /// Median of the reference divided by the row's, so that more is faster.
    pub fn times_reference(&self, row: &Row) -> Option<f64> {
        let reference = self.row(row.scene, Cell::REFERENCE)?.summary()?;
        Some(reference.median / row.summary()?.median)
    }

    /// What every cell has in common; a benchmark that is resumed must have the same.
    pub fn conditions(&self) -> Value {
        let device = self.device.as_ref().map(|info| {
            json!({
                "name": info.name, "kind": info.kind.name(), "driver": info.driver, "vulkan": info.api_version,
                "memory_bytes": info.memory_bytes, "timestamp_period_ns": info.limits.timestamp_period_ns,
            })
        });
        json!({ "schema": SCHEMA, "voxtrace": env!("CARGO_PKG_VERSION"), "settings": self.plan.json(), "device": device })
    }

    pub fn json(&self) -> Value {
        let mut json = self.conditions();
        json["complete"] = self.is_complete.into();
        json["host"] = machine::host();
        json["verdict"] = verdict::json(self);
        json["doctor"] = self.doctor.clone().unwrap_or_default();
        json["scenes"] = self.scenes.iter().map(scene_json).collect();
        json["cells"] = self.rows.iter().map(|row| self.row_json(row)).collect();
        json["sweep"] = self.sweep.iter().map(SweepRow::json).collect();
        json
    }

    fn row_json(&self, row: &Row) -> Value {
        let (facts, measured) = (&self.scenes[row.scene], &row.measured);
        let speeds = row.speeds();
        let memory = measured.memory.as_ref().map(|memory| {
            json!({
                "by_name": memory.bytes, "total": memory.total, "peak": memory.peak,
                "primitives": memory.accel.map(|accel| accel.primitives),
                "structures": memory.accel.map(|accel| accel.structures),
                "bottom_before_compaction": memory.accel.map(|accel| accel.bytes_before_compaction),
                "bottom": memory.accel.map(|accel| accel.bytes),
                "top": memory.accel.map(|accel| accel.top_level_bytes),
                "records": memory.accel.map(|accel| accel.record_bytes),
            })
        });
        let per_voxel = |bytes: u64| bytes as f64 / facts.voxels.max(1) as f64;
        let is_measured = !measured.frames.is_empty();
        json!({
            "scene": facts.name,
            "scene_index": row.scene,
            "cell": row.cell.name(),
            "traversal": row.cell.traversal.name(),
            "primitive": row.cell.primitive.map(|primitive| primitive.name()),
            "shaders": self.rounding(row.cell),
            "failure": measured.failure,
            "interrupted": measured.is_interrupted,
            "notes": measured.notes,
            "csv": row.csv,
            "primary_csv": row.primary_csv,
            "figures": row.figures.json(),
            "frames": measured.frames.len(),
            "lost": measured.lost,
            "film_checks": measured.film_checks,
            "stable": row.is_stable(),
            "conformance": measured.conformance.map(|conformance| conformance.json()),
            "clocks": { "before": measured.clocks[0], "after": measured.clocks[1] },
            "clock": if measured.has_gpu_clock { "gpu" } else { "wall" },
            "ms": row.summary().map(summary_json),
            "primary_ms": row.primary().map(summary_json),
            "grays_per_second": { "all": speeds.all, "primary": speeds.primary, "bounce": speeds.bounce },
            "times_voxel_exact": self.times_reference(row),
            "bytes": memory,
            "bytes_per_voxel": is_measured.then(|| json!({
                "acceleration_structures": per_voxel(row.accel_bytes()),
                "records": per_voxel(row.record_bytes()),
                "scene": per_voxel(row.scene_bytes(facts)),
                "total": per_voxel(row.traced_bytes(facts)),
            })),
        })
    }
}

fn scene_json(facts: &SceneFacts) -> Value {
    json!({
        "name": facts.name, "voxels": facts.voxels, "voxels_placed": facts.voxels_placed,
        "content_hash": facts.hash, "camera": facts.camera, "packed_bytes": facts.packed_bytes,
        "exact_figure": facts.exact_figure,
        "emulation": facts.emulation.as_ref().map(|emulation| json!({
            "margin": emulation.margin, "conformance": emulation.conformance.json(), "figures": emulation.figures.json(),
        })),
    })
}

fn summary_json(summary: Summary) -> Value {
    json!({
        "mean": summary.mean, "median": summary.median, "p1": summary.p1, "p99": summary.p99, "fps": summary.fps,
        "wall_mean": summary.wall_mean, "rays_per_frame": summary.rays,
        "mean_95": summary.intervals.map(|intervals| intervals.mean),
        "median_95": summary.intervals.map(|intervals| intervals.median),
        "block_frames": summary.intervals.map(|intervals| intervals.block),
    })
}
