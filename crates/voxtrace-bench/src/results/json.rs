//! `results.json`: everything that was measured, for programs. `docs/results-format.md` describes the schema; `resume`
//! reads it again.

use super::facts::SceneFacts;
use super::row::{Row, SweepRow};
use super::{Origin, Results, verdict};
use crate::measure::{Walked, host};
use crate::numbers::Summary;
use serde_json::{Value, json};

/// Version of the schema; it grows when a reader of the old one would misread.
const SCHEMA: u32 = 2;
impl Results {
    /// What every cell has in common; a benchmark that is resumed must have the same.
    pub(crate) fn conditions(&self) -> Value {
        let device = self.device.as_ref().map(|info| {
            json!({
                "name": info.name, "kind": info.kind.name(), "driver": info.driver, "vulkan": info.api_version,
                "memory_bytes": info.memory_bytes, "timestamp_period_ns": info.limits.timestamp_period_ns,
            })
        });
        json!({ "schema": SCHEMA, "voxtrace": env!("CARGO_PKG_VERSION"), "settings": self.plan.json(), "device": device })
    }

    /// Everything, as `results.json` has it.
    pub fn json(&self) -> Value {
        let mut json = self.conditions();
        json["complete"] = self.is_complete.into();
        json["runs"] = self.runs.iter().map(Origin::json).collect();
        json["host"] = host();
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
            "processor": measured.processor.json(),
            "disturbance": self.disturbance(row),
            "walk": measured.walked.as_ref().map(Walked::json),
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

impl SweepRow {
    fn json(&self) -> Value {
        json!({
            "scene": self.scene, "cell": self.cell.name(), "wanted": self.wanted, "voxels": self.voxels,
            "median_ms": self.median, "frames": self.frames, "lost": self.lost, "bytes": self.bytes,
            "failure": self.failure,
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
