//! `results.json`: everything that was measured, for programs. The schema is described in `docs/command-line.md`.

use super::cells::Cell;
use super::measure::Measured;
use super::numbers::{Speeds, Summary};
use serde_json::{Value, json};
use voxtrace::PackedScene;
use voxtrace_vulkan::DeviceInfo;

/// Version of the schema; it grows when a reader of the old one would misread.
pub const SCHEMA: u32 = 1;
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
    pub measured: Measured,
}

impl Row {
    pub fn summary(&self) -> Option<Summary> {
        Summary::of(&self.measured.frames)
    }

    pub fn primary(&self) -> Option<Summary> {
        Summary::of(&self.measured.primary)
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

/// What was asked for, the same for all cells.
#[derive(Clone, Debug)]
pub struct Plan {
    pub frames: u32,
    pub warm_up: u32,
    pub time_limit_s: Option<f64>,
    pub width: u32,
    pub height: u32,
    pub max_bounces: u32,
    pub seed: u32,
    pub is_exact: bool,
}

/// A whole benchmark, as far as it has come.
pub struct Results {
    pub plan: Plan,
    pub device: Option<DeviceInfo>,
    pub scenes: Vec<SceneFacts>,
    pub rows: Vec<Row>,
    pub is_complete: bool,
}

impl Results {
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

    pub fn json(&self) -> Value {
        let plan = &self.plan;
        let device = self.device.as_ref().map(|info| {
            json!({
                "name": info.name, "kind": info.kind.name(), "driver": info.driver, "vulkan": info.api_version,
                "memory_bytes": info.memory_bytes, "timestamp_period_ns": info.limits.timestamp_period_ns,
            })
        });
        let scenes: Vec<Value> = self.scenes.iter().map(scene_json).collect();
        json!({
            "schema": SCHEMA,
            "voxtrace": env!("CARGO_PKG_VERSION"),
            "complete": self.is_complete,
            "device": device,
            "host": {
                "os": std::env::consts::OS, "arch": std::env::consts::ARCH,
                "threads": rayon::current_num_threads(), "simd": voxtrace::walk::simd_name(),
            },
            "settings": {
                "width": plan.width, "height": plan.height, "frames": plan.frames, "warm_up": plan.warm_up,
                "time_limit_s": plan.time_limit_s, "max_bounces": plan.max_bounces, "integrator": "essay",
                "seed": plan.seed, "shaders": if plan.is_exact { "precise" } else { "fast" },
            },
            "scenes": scenes,
            "cells": self.rows.iter().map(|row| self.row_json(row)).collect::<Vec<Value>>(),
        })
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
            "cell": row.cell.name(),
            "traversal": row.cell.traversal.name(),
            "primitive": row.cell.primitive.map(|primitive| primitive.name()),
            "shaders": self.rounding(row.cell),
            "failure": measured.failure,
            "interrupted": measured.is_interrupted,
            "notes": measured.notes,
            "csv": row.csv,
            "primary_csv": row.primary_csv,
            "frames": measured.frames.len(),
            "lost": measured.lost,
            "clock": if row.cell.traversal == voxtrace_vulkan::Traversal::Cpu { "wall" } else { "gpu" },
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
        "content_hash": facts.hash, "camera": facts.camera,
    })
}

fn summary_json(summary: Summary) -> Value {
    json!({
        "mean": summary.mean, "median": summary.median, "p1": summary.p1, "p99": summary.p99, "fps": summary.fps,
        "wall_mean": summary.wall_mean, "rays_per_frame": summary.rays,
    })
}
