//! Two reports of a benchmark side by side. A difference counts only where it is more than noise:
//! beyond the confidence intervals of both, and more than two runs of one plan on one idle machine may differ; and where the machine was quiet.

mod error;
pub(crate) mod rounds;

pub use error::{CompareError, CompareErrorKind};

use serde_json::{Value, json};
use std::path::Path;

/// Part by which two runs of the same plan may differ although nothing changed.
const BAND: f64 = 0.02;
/// What to do where the machine was not quiet.
const ADVICE: &str = "Measure again while nothing else runs; cells on the processor that one `bench --cells` names are measured in turns.\n";
/// The schema that is read.
const SCHEMA: u64 = 2;
/// Settings that must agree, or times mean different work.
const SETTINGS: [&str; 5] = ["width", "height", "max_bounces", "integrator", "seed"];

/// Reads the report of a folder, or a `results.json`.
pub(crate) fn read(path: &Path) -> Result<Value, CompareError> {
    let file = if path.is_dir() { path.join("results.json") } else { path.to_owned() };
    let parse = || {
        let bytes = std::fs::read(&file).map_err(CompareErrorKind::Io)?;
        if bytes.trim_ascii_start().first() != Some(&b'{') {
            return Err(CompareErrorKind::NoReport);
        }
        let json: Value = serde_json::from_slice(&bytes).map_err(CompareErrorKind::Json)?;
        match json["schema"].as_u64() {
            Some(SCHEMA) => Ok(json),
            Some(other) => Err(CompareErrorKind::Schema(other)),
            None => Err(CompareErrorKind::NoReport),
        }
    };
    parse().map_err(|kind| CompareError { path: file.clone(), kind })
}

/// What became of a cell from A to B.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Outcome {
    Equal,
    Faster,
    Slower,
    /// There are too few frames to tell.
    Unknown,
    /// Other programs used the machine.
    Disturbed,
    Incomparable,
}

impl Outcome {
    fn name(self) -> &'static str {
        match self {
            Self::Equal => "equal within noise",
            Self::Faster => "B is faster",
            Self::Slower => "B is slower",
            Self::Unknown => "too few frames to tell",
            Self::Disturbed => "no verdict",
            Self::Incomparable => "not comparable",
        }
    }
}

/// One cell of one scene.
struct Pair {
    scene: String,
    cell: String,
    /// Median milliseconds.
    ms: [Option<f64>; 2],
    /// Bytes of what is traced, for each voxel.
    bytes: [Option<f64>; 2],
    /// Rays that met a wrong voxel.
    wrong: [Option<u64>; 2],
    /// Median of B over that of A, and where it lies with a certainty of at least 95 %.
    ratio: Option<f64>,
    interval: Option<[f64; 2]>,
    outcome: Outcome,
    /// Why it cannot be compared, or there is no verdict.
    why: Option<String>,
}

/// Two reports side by side.
pub struct Comparison {
    names: [String; 2],
    pairs: Vec<Pair>,
    /// What is in one report alone.
    alone: Vec<String>,
}

impl Comparison {
    /// Compares two reports: folders, or their `results.json`.
    ///
    /// # Errors
    /// Where one cannot be read or is no report of this version.
    pub fn open(a: &Path, b: &Path) -> Result<Self, CompareError> {
        Ok(Self::of(&read(a)?, &read(b)?))
    }

    fn of(a: &Value, b: &Value) -> Self {
        let settings = differing_settings(a, b);
        let mut pairs = Vec::new();
        let mut alone = Vec::new();
        let cells = |json: &Value| json["cells"].as_array().cloned().unwrap_or_default();
        let (ours, mut theirs) = (cells(a), cells(b));
        for cell in ours {
            match theirs.iter().position(|other| key(other) == key(&cell)) {
                Some(at) => pairs.push(Pair::of((a, &cell), (b, &theirs.remove(at)), settings.as_deref())),
                None => alone.push(format!("only in A: {}", label(&cell))),
            }
        }
        alone.extend(theirs.iter().map(|cell| format!("only in B: {}", label(cell))));
        Self { names: [name(a), name(b)], pairs, alone }
    }

    fn count(&self, outcome: Outcome) -> usize {
        self.pairs.iter().filter(|pair| pair.outcome == outcome).count()
    }

    /// The result in one line.
    fn summary(&self) -> String {
        summary(&self.pairs.iter().map(|pair| pair.outcome).collect::<Vec<_>>())
    }

    /// Every cell, for people.
    pub fn text(&self) -> String {
        let mut text = format!("A: {}\nB: {}\n\n", self.names[0], self.names[1]);
        text += &format!(
            "{:<16} {:<22} {:>10} {:>10} {:>7} {:>16} {:>9} {:>9} {:>13}  {}\n",
            "scene", "cell", "A ms", "B ms", "B / A", "95 %", "A B/voxel", "B B/voxel", "wrong A, B", "outcome"
        );
        for pair in &self.pairs {
            let number = |value: Option<f64>| value.map_or("-".into(), |value| format!("{value:.3}"));
            let interval = pair.interval.map_or("-".into(), |[low, high]| format!("{low:.3} to {high:.3}"));
            let wrong = pair.wrong.map(|count| count.map_or("-".into(), |count| count.to_string())).join(", ");
            let why = pair.why.as_ref().map_or(String::new(), |why| format!(": {why}"));
            text += &format!(
                "{:<16} {:<22} {:>10} {:>10} {:>7} {interval:>16} {:>9} {:>9} {wrong:>13}  {}{why}\n",
                pair.scene,
                pair.cell,
                number(pair.ms[0]),
                number(pair.ms[1]),
                number(pair.ratio),
                number(pair.bytes[0]),
                number(pair.bytes[1]),
                pair.outcome.name(),
            );
        }
        for line in &self.alone {
            text += &format!("{line}\n");
        }
        let advice = if self.count(Outcome::Disturbed) > 0 { ADVICE } else { "" };
        format!("{text}\n{}\n{advice}", self.summary())
    }

    /// Every cell, for programs.
    pub fn json(&self) -> Value {
        let pair = |pair: &Pair| {
            json!({
                "scene": pair.scene, "cell": pair.cell, "median_ms": pair.ms, "bytes_per_voxel": pair.bytes,
                "wrong_voxels": pair.wrong, "ratio": pair.ratio, "ratio_95": pair.interval,
                "outcome": pair.outcome.name(), "why": pair.why,
            })
        };
        json!({
            "a": self.names[0], "b": self.names[1], "summary": self.summary(), "band": BAND,
            "cells": self.pairs.iter().map(pair).collect::<Vec<_>>(), "alone": self.alone,
        })
    }
}

/// What became of all cells, in one line.
fn summary(outcomes: &[Outcome]) -> String {
    use Outcome::{Disturbed, Equal, Faster, Incomparable, Slower, Unknown};
    let count = |outcome: Outcome| outcomes.iter().filter(|own| **own == outcome).count();
    let counts =
        [Equal, Faster, Slower, Unknown, Disturbed, Incomparable].map(|outcome| (count(outcome), outcome.name()));
    let told: Vec<String> =
        counts.iter().filter(|(count, _)| *count > 0).map(|(count, name)| format!("{count} {name}")).collect();
    match outcomes.len() {
        0 => "The reports have no cell in common.".into(),
        1 => format!("Of one cell: {}.", told.join(", ")),
        all => format!("Of {all} cells: {}.", told.join(", ")),
    }
}

impl Pair {
    fn of((a, ours): (&Value, &Value), (b, theirs): (&Value, &Value), settings: Option<&str>) -> Self {
        let both = |value: &dyn Fn(&Value) -> Option<f64>| [value(ours), value(theirs)];
        let ms = both(&|cell| cell["ms"]["median"].as_f64());
        let ratio = ms[0].zip(ms[1]).map(|(a, b)| b / a).filter(|ratio| ratio.is_finite());
        let ends = |cell: &Value| {
            let ends = &cell["ms"]["median_95"];
            Some([ends[0].as_f64()?, ends[1].as_f64()?])
        };
        let interval = ends(ours).zip(ends(theirs)).map(|(a, b)| [b[0] / a[1], b[1] / a[0]]);
        let why = obstacle((a, ours), (b, theirs), settings);
        let is_comparable = why.is_none();
        let disturbed = || disturbance(ours, theirs);
        let (outcome, why) = match why.map(|why| (Outcome::Incomparable, why)).or_else(disturbed) {
            Some((outcome, why)) => (outcome, Some(why)),
            None => (judge(ratio, interval), None),
        };
        Self {
            scene: text(&ours["scene"]),
            cell: text(&ours["cell"]),
            ms,
            bytes: both(&|cell| cell["bytes_per_voxel"]["total"].as_f64()),
            wrong: [ours, theirs].map(|cell| {
                let count = |name: &str| cell["conformance"][name].as_u64();
                Some(count("wrong")? + count("invented")? + count("missed")?)
            }),
            ratio: ratio.filter(|_| is_comparable),
            interval: interval.filter(|_| is_comparable),
            outcome,
            why,
        }
    }
}

/// The rule: a difference is more than noise when the interval of the ratio leaves out 1 and the ratio itself is off by
/// more than the band.
fn judge(ratio: Option<f64>, interval: Option<[f64; 2]>) -> Outcome {
    let Some(ratio) = ratio else { return Outcome::Unknown };
    if (ratio - 1.0).abs() <= BAND {
        return Outcome::Equal;
    }
    match interval {
        None => Outcome::Unknown,
        Some([low, high]) if low <= 1.0 && high >= 1.0 => Outcome::Equal,
        Some(_) if ratio < 1.0 => Outcome::Faster,
        Some(_) => Outcome::Slower,
    }
}

/// Why there is no verdict although two cells could be compared: what `bench` says of the machine while it measured them.
fn disturbance(ours: &Value, theirs: &Value) -> Option<(Outcome, String)> {
    let loud = [("A", ours), ("B", theirs)].into_iter();
    let loud = loud.filter_map(|(name, cell)| Some(format!("{name}: {}", cell["disturbance"].as_str()?)));
    let loud: Vec<String> = loud.collect();
    let why = format!("the machine was not quiet ({})", loud.join("; "));
    (!loud.is_empty()).then_some((Outcome::Disturbed, why))
}

/// Why two cells cannot be compared.
fn obstacle((a, ours): (&Value, &Value), (b, theirs): (&Value, &Value), settings: Option<&str>) -> Option<String> {
    let hash = |report: &Value, cell: &Value| {
        let index = cell["scene_index"].as_u64().and_then(|index| usize::try_from(index).ok()).unwrap_or(usize::MAX);
        text(&report["scenes"][index]["content_hash"])
    };
    for (name, cell) in [("A", ours), ("B", theirs)] {
        if let Some(failure) = cell["failure"].as_str() {
            return Some(format!("{name} failed: {failure}"));
        }
        if cell["interrupted"] == true || cell["ms"].is_null() {
            return Some(format!("{name} was not measured to its end"));
        }
        if cell["stable"] == false {
            return Some(format!("{name} is not stable: {} frames lost", cell["lost"]));
        }
    }
    let (ours_hash, theirs_hash) = (hash(a, ours), hash(b, theirs));
    if ours_hash != theirs_hash {
        return Some(format!("other scenes of the same name ({ours_hash}, {theirs_hash})"));
    }
    for (name, what) in [("shaders", "shaders"), ("clock", "clocks")] {
        if ours[name] != theirs[name] {
            return Some(format!("other {what} ({}, {})", text(&ours[name]), text(&theirs[name])));
        }
    }
    settings.map(str::to_owned)
}

fn differing_settings(a: &Value, b: &Value) -> Option<String> {
    let differing: Vec<String> = SETTINGS
        .into_iter()
        .filter(|name| a["settings"][name] != b["settings"][name])
        .map(|name| format!("{name} ({}, {})", a["settings"][name], b["settings"][name]))
        .collect();
    (!differing.is_empty()).then(|| format!("other settings: {}", differing.join(", ")))
}

fn text(json: &Value) -> String {
    json.as_str().unwrap_or("?").to_owned()
}

/// What makes two cells the same: names of scene and cell; of scenes of one name, their order.
fn key(cell: &Value) -> [String; 3] {
    [text(&cell["scene"]), text(&cell["cell"]), cell["scene_index"].to_string()]
}

fn label(cell: &Value) -> String {
    format!("{} {}", text(&cell["scene"]), text(&cell["cell"]))
}

/// Device, driver, integrator, version and commit of a report.
fn name(report: &Value) -> String {
    let device = &report["device"];
    let place = match device["name"].as_str() {
        Some(name) => format!("{name}, driver {}", text(&device["driver"])),
        None => {
            format!("{}, {} threads", report["host"]["processor"].as_str().unwrap_or("CPU"), report["host"]["threads"])
        }
    };
    let incomplete = if report["complete"] == true { "" } else { ", not complete" };
    let integrator = text(&report["settings"]["integrator"]);
    // Two builds of one version differ by it, where it is known.
    let commit = report["runs"].as_array().and_then(|runs| runs.last()?["commit"].as_str());
    let commit = commit.map_or(String::new(), |commit| format!(" ({})", commit.get(..10).unwrap_or(commit)));
    format!("{place}, integrator {integrator}, voxtrace {}{commit}{incomplete}", text(&report["voxtrace"]))
}

#[cfg(test)]
pub(crate) mod tests;
