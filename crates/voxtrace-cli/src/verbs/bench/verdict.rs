//! The answer: whether each scene meets the study's criteria, and all of it in one sentence.

use super::cells::Cell;
use super::results::{Results, Row, SceneFacts};
use serde_json::{Value, json};
use voxtrace_vulkan::{Primitive, Traversal};

/// Milliseconds a frame that 60 frames a second leave.
pub const BUDGET_MS: f64 = 1000.0 / 60.0;
/// Bytes that a scene may take.
pub const BUDGET_BYTES: u64 = 1_000_000_000;

/// What one cell of one scene comes to, measured against the study's criteria. `None` where nothing is known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Verdict {
    pub is_fast: bool,
    pub is_small: bool,
    /// Every frame was proved.
    pub is_stable: bool,
    /// The right voxels were found.
    pub is_conformant: Option<bool>,
}

impl Verdict {
    /// `None` where no frame was measured.
    pub fn of(results: &Results, row: &Row) -> Option<Self> {
        let summary = row.summary()?;
        let is_exact = results.rounding(row.cell) == "precise";
        Some(Self {
            is_fast: summary.mean <= BUDGET_MS,
            is_small: row.traced_bytes(&results.scenes[row.scene]) <= BUDGET_BYTES,
            is_stable: row.is_stable(),
            is_conformant: row.measured.conformance.map(|conformance| conformance.holds(is_exact)),
        })
    }

    pub fn is_good(&self) -> bool {
        self.is_fast && self.is_small && self.is_stable && self.is_conformant != Some(false)
    }
}

/// The cell of a scene that answers the study's question: its exact method on ray tracing hardware, or else the nearest
/// thing to it that was measured.
pub fn asked(results: &Results, scene: usize) -> Option<&Row> {
    let by_query = Cell { traversal: Traversal::Query, primitive: Some(Primitive::VoxelExact) };
    let measured = |cell| results.row(scene, cell).filter(|row| row.summary().is_some());
    let any = || results.rows.iter().find(|row| row.scene == scene && row.summary().is_some());
    measured(Cell::REFERENCE).or_else(|| measured(by_query)).or_else(any)
}

/// The quickest cell of a scene that meets every criterion, or else the quickest that finds the right voxels.
pub fn best(results: &Results, scene: usize) -> Option<&Row> {
    let rows = || results.rows.iter().filter(|row| row.scene == scene);
    let quickest = |is_good: &dyn Fn(&Verdict) -> bool| {
        let good = rows().filter(|row| Verdict::of(results, row).is_some_and(|verdict| is_good(&verdict)));
        good.filter_map(|row| Some((row, row.summary()?.median))).min_by(|a, b| a.1.total_cmp(&b.1)).map(|(row, _)| row)
    };
    quickest(&Verdict::is_good).or_else(|| quickest(&|verdict| verdict.is_conformant != Some(false)))
}

/// Numbers of voxels as people say them.
pub fn millions(voxels: u64) -> String {
    if voxels >= 100_000 { format!("{:.1} million", voxels as f64 / 1e6) } else { format!("{voxels}") }
}

/// Least and most, as one number where they look the same.
fn span(values: impl Iterator<Item = f64> + Clone, digits: usize) -> String {
    let least = format!("{:.digits$}", values.clone().fold(f64::INFINITY, f64::min));
    let most = format!("{:.digits$}", values.fold(f64::NEG_INFINITY, f64::max));
    if least == most { least } else { format!("{least} to {most}") }
}

/// What a row is called in a sentence.
fn way(cell: Cell) -> &'static str {
    match cell.traversal {
        Traversal::Cpu => "on the processor alone",
        Traversal::Walk => "with a walk in a compute shader",
        _ => "with ray tracing hardware's interface, by the study's exact method",
    }
}

/// The answer in one sentence.
pub fn sentence(results: &Results) -> String {
    let rows: Vec<&Row> = (0..results.scenes.len()).filter_map(|scene| asked(results, scene)).collect();
    let verdicts: Vec<(&Row, Verdict)> =
        rows.iter().filter_map(|&row| Some((row, Verdict::of(results, row)?))).collect();
    let [(first, _), ..] = verdicts[..] else { return "Nothing has been measured yet.".into() };
    let facts = |row: &Row| -> &SceneFacts { &results.scenes[row.scene] };
    let count = verdicts.len();
    let good = verdicts.iter().filter(|(_, verdict)| verdict.is_good()).count();
    let place = match (&results.device, first.cell.traversal) {
        (Some(device), traversal) if traversal != Traversal::Cpu => device.name.clone(),
        _ => "this processor".into(),
    };
    let answer = match good {
        0 => "No",
        good if good == count => "Yes",
        _ => "In part",
    };
    let fps = span(verdicts.iter().filter_map(|(row, _)| row.summary()).map(|summary| summary.fps), 0);
    let megabytes = span(verdicts.iter().map(|(row, _)| row.traced_bytes(facts(row)) as f64 / 1e6), 0);
    let voxels: Vec<u64> = verdicts.iter().map(|(row, _)| facts(row).voxels).collect();
    let (least, most) = (millions(*voxels.iter().min().unwrap_or(&0)), millions(*voxels.iter().max().unwrap_or(&0)));
    let size = if least == most { most } else { format!("{least} to {most}") };
    let scenes = if count == 1 { "the one scene measured".into() } else { format!("{good} of {count} scenes") };
    let reason = complaints(&verdicts);
    let met = if count == 1 && good == 0 {
        "does not meet"
    } else if count == 1 {
        "meets"
    } else {
        "meet"
    };
    let mut text = format!(
        "{answer}: on {place}, {scenes} ({size} voxels) {met} the study's demands {}: {fps} frames a second where 60 are asked, \
         {megabytes} MB where 1,000 are allowed{reason}.",
        way(first.cell),
    );
    let gains: Vec<f64> = (0..results.scenes.len())
        .filter_map(|scene| {
            let (asked, best) = (asked(results, scene)?, best(results, scene)?);
            Some(asked.summary()?.median / best.summary()?.median).filter(|gain| *gain > 1.05)
        })
        .collect();
    if gains.len() == count && first.cell.traversal != Traversal::Cpu {
        let best = best(results, first.scene).map_or_else(String::new, |row| row.cell.name());
        text += &format!(" The quickest way measured, {best}, is {} times as fast.", span(gains.iter().copied(), 1));
    }
    text
}

/// What else than speed and memory is wrong.
fn complaints(verdicts: &[(&Row, Verdict)]) -> String {
    let count = |is_bad: fn(&Verdict) -> bool| verdicts.iter().filter(|(_, verdict)| is_bad(verdict)).count();
    let (lost, wrong) = (count(|verdict| !verdict.is_stable), count(|verdict| verdict.is_conformant == Some(false)));
    let proved: usize = verdicts.iter().filter_map(|(row, _)| row.summary()).map(|summary| summary.frames).sum();
    match (lost, wrong) {
        (0, 0) => format!(", with all {proved} frames proved and the right voxels found"),
        (0, _) => ", but wrong voxels are found".into(),
        (_, 0) => ", but not every frame is proved to have run".into(),
        _ => ", but frames are lost and wrong voxels found".into(),
    }
}

/// The verdicts of all scenes, for programs.
pub fn json(results: &Results) -> Value {
    let scenes: Vec<Value> = (0..results.scenes.len())
        .filter_map(|scene| {
            let row = asked(results, scene)?;
            let verdict = Verdict::of(results, row)?;
            Some(json!({
                "scene": results.scenes[scene].name, "cell": row.cell.name(), "fast": verdict.is_fast,
                "small": verdict.is_small, "stable": verdict.is_stable, "conformant": verdict.is_conformant,
            }))
        })
        .collect();
    json!({ "sentence": sentence(results), "scenes": scenes })
}
