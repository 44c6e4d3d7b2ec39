//! Going on with a benchmark that was stopped: what `results` wrote is read again, cells that were interrupted left out.

use super::Results;
use super::facts::{Emulation, Figures, SceneFacts};
use super::origin::Origin;
use super::row::{Row, SweepRow};
use crate::measure::{Conformance, Measured, Memory, Processor, Walked, host};
use crate::numbers::{FrameLine, read_csv};
use crate::plan::{self, Cell};
use crate::reason::reason;
use serde_json::Value;
use std::io;
use std::path::{Path, PathBuf};
use voxtrace_vulkan::AccelReport;

/// A benchmark that cannot be gone on with.
#[derive(Debug, thiserror::Error)]
#[error("{}", self.text())]
#[non_exhaustive]
pub struct ResumeError {
    /// The results of before.
    pub path: PathBuf,
    /// What is wrong with them.
    pub kind: ResumeErrorKind,
}

/// What is wrong with the results of before.
#[derive(Debug)]
#[non_exhaustive]
pub enum ResumeErrorKind {
    /// They cannot be read.
    Io(io::Error),
    /// They are not what a benchmark writes; in words.
    Damaged(String),
    /// They are of another plan, device or version; names of what differs, and how.
    OtherBenchmark(Vec<String>),
}

impl ResumeError {
    fn text(&self) -> String {
        let path = self.path.display();
        match &self.kind {
            ResumeErrorKind::Io(error) => format!("cannot read {path}: {}", reason(error)),
            ResumeErrorKind::Damaged(what) => format!("{path} is damaged: {what}"),
            ResumeErrorKind::OtherBenchmark(differing) => {
                format!("{path} is of another benchmark: {} differ", differing.join(", "))
            }
        }
    }
}

/// Fills `results`, which knows its plan and device, with what the folder holds; nothing where it holds nothing.
///
/// # Errors
/// Where the folder holds another benchmark, or files that cannot be read.
pub fn load(folder: &Path, results: &mut Results) -> Result<(), ResumeError> {
    let path = folder.join("results.json");
    fill(folder, &path, results).map_err(|kind| ResumeError { path, kind })
}

fn fill(folder: &Path, path: &Path, results: &mut Results) -> Result<(), ResumeErrorKind> {
    let text = match std::fs::read_to_string(path) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(()),
        text => text.map_err(ResumeErrorKind::Io)?,
    };
    let damaged = |what: &str| ResumeErrorKind::Damaged(what.to_owned());
    let json: Value = serde_json::from_str(&text).map_err(|error| damaged(&error.to_string()))?;
    let mut differing = differences(&json, &results.conditions());
    // What a device does needs none of it.
    if results.plan.cells.iter().any(|&cell| results.is_on_processor(cell)) {
        differing.extend(other_processor(&json["host"], &host()));
    }
    if !differing.is_empty() {
        return Err(ResumeErrorKind::OtherBenchmark(differing));
    }
    let list = |name: &str| json[name].as_array().cloned().unwrap_or_default();
    results.scenes =
        list("scenes").iter().map(scene).collect::<Option<_>>().ok_or_else(|| damaged("a scene cannot be read"))?;
    for json in list("cells").iter().filter(|json| json["interrupted"] == false) {
        results.rows.push(row(json, &results.scenes, folder).map_err(ResumeErrorKind::Damaged)?);
    }
    results.sweep =
        list("sweep").iter().map(sweep).collect::<Option<_>>().ok_or_else(|| damaged("the sweep cannot be read"))?;
    results.runs.splice(0..0, list("runs").iter().map(Origin::from_json));
    results.doctor = Some(json["doctor"].clone()).filter(|doctor| !doctor.is_null());
    Ok(())
}

/// Compares the conditions of two benchmarks and names what differs.
fn differences(theirs: &Value, ours: &Value) -> Vec<String> {
    let mut differing = Vec::new();
    for name in ["schema", "voxtrace", "device"] {
        if theirs[name] != ours[name] {
            let what = |json: &Value| match &json["name"] {
                Value::String(device) => format!("{device}, driver {}", json["driver"].as_str().unwrap_or("unknown")),
                _ if json.is_null() => "none".into(),
                _ => json.as_str().map_or_else(|| json.to_string(), str::to_owned),
            };
            differing.push(format!("{name} ({}, now {})", what(&theirs[name]), what(&ours[name])));
        }
    }
    let no_settings = serde_json::Map::new();
    for (name, value) in ours["settings"].as_object().unwrap_or(&no_settings) {
        if theirs["settings"][name] == *value {
            continue;
        }
        if name == "scene_options" {
            differing.push("options that say how scenes are read, seen or lit".into());
        } else {
            differing.push(format!("{name} ({}, now {value})", theirs["settings"][name]));
        }
    }
    differing
}

/// What differs of what cells on the processor are traced with.
fn other_processor(theirs: &Value, ours: &Value) -> Vec<String> {
    let names = ["processor", "threads", "simd"].into_iter().filter(|name| theirs[name] != ours[name]);
    names.map(|name| format!("{name} ({}, now {})", theirs[name], ours[name])).collect()
}

fn text(json: &Value) -> Option<String> {
    json.as_str().map(str::to_owned)
}

fn scene(json: &Value) -> Option<SceneFacts> {
    Some(SceneFacts {
        name: text(&json["name"])?,
        voxels: json["voxels"].as_u64()?,
        voxels_placed: json["voxels_placed"].as_u64()?,
        hash: text(&json["content_hash"])?,
        camera: text(&json["camera"])?,
        packed_bytes: json["packed_bytes"].as_u64()?,
        exact_figure: text(&json["exact_figure"]),
        emulation: emulation(&json["emulation"]),
    })
}

fn cell(json: &Value) -> Option<Cell> {
    let [cell] = plan::parse(json.as_str()?).ok()?[..] else { return None };
    Some(cell)
}

fn row(json: &Value, scenes: &[SceneFacts], folder: &Path) -> Result<Row, String> {
    let name = json["cell"].as_str().unwrap_or("a cell");
    let frames = |file: &Value| -> Result<Vec<FrameLine>, String> {
        let Some(file) = file.as_str() else { return Ok(Vec::new()) };
        let text = std::fs::read_to_string(folder.join(file)).map_err(|error| format!("{file}: {}", reason(&error)))?;
        read_csv(&text).map_err(|error| format!("{file}: {error}"))
    };
    let strings = json["notes"].as_array().map(|notes| notes.iter().filter_map(text).collect());
    let measured = Measured {
        frames: frames(&json["csv"])?,
        primary: frames(&json["primary_csv"])?,
        lost: json["lost"].as_u64().unwrap_or(0) as u32,
        failure: text(&json["failure"]),
        notes: strings.unwrap_or_default(),
        memory: memory(&json["bytes"]),
        film_checks: json["film_checks"].as_u64().unwrap_or(0) as u32,
        clocks: [json["clocks"]["before"].clone(), json["clocks"]["after"].clone()],
        processor: Processor::from_json(&json["processor"]).unwrap_or_default(),
        walked: Walked::from_json(&json["walk"]),
        conformance: Conformance::from_json(&json["conformance"]),
        has_gpu_clock: json["clock"] == "gpu",
        ..Measured::default()
    };
    if json["frames"] != measured.frames.len() {
        return Err(format!("{name} has {} frames, its CSV {}", json["frames"], measured.frames.len()));
    }
    let scene = json["scene_index"].as_u64().and_then(|index| usize::try_from(index).ok());
    let mut row = Row::new(
        scene.filter(|&index| index < scenes.len()).ok_or_else(|| format!("{name} has no scene"))?,
        cell(&json["cell"]).ok_or_else(|| format!("{name} is no cell"))?,
        measured,
    );
    (row.csv, row.primary_csv) = (text(&json["csv"]), text(&json["primary_csv"]));
    row.figures = figures(&json["figures"]);
    Ok(row)
}

fn figures(json: &Value) -> Figures {
    Figures { render: text(&json["render"]), voxels: text(&json["voxels"]), difference: text(&json["difference"]) }
}

fn emulation(json: &Value) -> Option<Emulation> {
    Some(Emulation {
        margin: json["margin"].as_f64()?,
        conformance: Conformance::from_json(&json["conformance"])?,
        figures: figures(&json["figures"]),
    })
}

fn memory(json: &Value) -> Option<Memory> {
    let names = json["by_name"].as_object()?;
    let number = |name: &str| json[name].as_u64();
    let accel = number("primitives").map(|primitives| AccelReport {
        primitives,
        structures: number("structures").unwrap_or(0),
        bytes_before_compaction: number("bottom_before_compaction").unwrap_or(0),
        bytes: number("bottom").unwrap_or(0),
        top_level_bytes: number("top").unwrap_or(0),
        record_bytes: number("records").unwrap_or(0),
    });
    Some(Memory {
        bytes: names.iter().filter_map(|(name, bytes)| Some((name.clone(), bytes.as_u64()?))).collect(),
        total: number("total")?,
        peak: number("peak")?,
        accel,
    })
}

fn sweep(json: &Value) -> Option<SweepRow> {
    Some(SweepRow {
        scene: text(&json["scene"])?,
        cell: cell(&json["cell"])?,
        wanted: json["wanted"].as_u64()?,
        voxels: json["voxels"].as_u64()?,
        median: json["median_ms"].as_f64(),
        frames: json["frames"].as_u64()? as usize,
        lost: json["lost"].as_u64()? as u32,
        bytes: json["bytes"].as_u64()?,
        failure: text(&json["failure"]),
    })
}
