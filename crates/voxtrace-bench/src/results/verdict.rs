//! The answer: whether each scene meets the study's criteria, and all of it in one sentence.

use super::Results;
use super::facts::SceneFacts;
use super::row::Row;
use crate::plan::{Cell, STUDY_SIZE};
use crate::quantity::counted;
use serde_json::{Value, json};
use voxtrace::Integrator;
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
    let by_query = Cell::new(Traversal::Query, Some(Primitive::VoxelExact));
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

/// Frames a second with the digits that matter.
pub fn rate(fps: f64) -> String {
    if fps < 10.0 { format!("{fps:.1}") } else { format!("{fps:.0}") }
}

/// Least and most, as one where they look the same.
fn span(values: impl Iterator<Item = f64> + Clone, show: impl Fn(f64) -> String) -> String {
    let (least, most) = (values.clone().fold(f64::INFINITY, f64::min), values.fold(f64::NEG_INFINITY, f64::max));
    let (least, most) = (show(least), show(most));
    match (least.split_once(' '), most.split_once(' ')) {
        _ if least == most => least,
        // The unit once.
        (Some((number, unit)), Some((_, other))) if unit == other => format!("{number} to {most}"),
        _ => format!("{least} to {most}"),
    }
}

/// How a cell traces, in a sentence.
pub fn way(cell: Cell) -> &'static str {
    match (cell.traversal, cell.primitive) {
        (Traversal::Cpu, _) => "without a GPU",
        (Traversal::Walk, _) => "by a walk in a compute shader, without ray tracing hardware",
        (_, Some(Primitive::VoxelExact)) => "through the ray tracing interface with one box for each voxel",
        (_, Some(Primitive::VoxelApprox)) => "through the ray tracing interface by the nearest centre",
        (_, Some(Primitive::Brick)) => "through the ray tracing interface with one box for each brick of 8³ voxels",
        (_, Some(Primitive::Grid)) => "through the ray tracing interface with one box for each object",
        _ => "through the ray tracing interface with triangles",
    }
}

/// What did the work of a cell.
fn place(results: &Results, cell: Cell) -> String {
    match &results.device {
        Some(device) if cell.traversal != Traversal::Cpu => device.name.clone(),
        _ => "this processor".into(),
    }
}

/// The answer in one sentence, and which way is the best in another.
pub fn sentence(results: &Results) -> String {
    let rows = (0..results.scenes.len()).filter_map(|scene| asked(results, scene));
    let verdicts: Vec<(&Row, Verdict)> = rows.filter_map(|row| Some((row, Verdict::of(results, row)?))).collect();
    let [(first, _), ..] = verdicts[..] else { return "Nothing has been measured yet.".into() };
    let facts = |row: &Row| -> &SceneFacts { &results.scenes[row.scene] };
    let count = verdicts.len();
    let good = verdicts.iter().filter(|(_, verdict)| verdict.is_good()).count();
    let answer = match good {
        0 => "No".into(),
        good if good == count => "Yes".into(),
        _ => format!("In part ({good} of {count} scenes)"),
    };
    let fps = span(verdicts.iter().filter_map(|(row, _)| row.summary()).map(|summary| summary.fps), rate);
    let size = span(verdicts.iter().map(|(row, _)| facts(row).voxels as f64), |voxels| millions(voxels as u64));
    let bytes = verdicts.iter().map(|(row, _)| row.traced_bytes(facts(row)) as f64 / 1e6);
    let megabytes = span(bytes, |megabytes| format!("{megabytes:.0}"));
    let mut text = format!(
        "{answer}: {} path traces scenes of {size} voxels {}, at {fps} frames a second (60 are needed) in {megabytes} MB of \
         memory (1,000 are allowed){}.",
        place(results, first.cell),
        way(first.cell),
        proofs(&verdicts),
    );
    let gain = |scene| {
        let (asked, best) = (asked(results, scene)?, best(results, scene)?);
        Some((best.cell, asked.summary()?.median / best.summary()?.median))
    };
    let gains: Vec<(Cell, f64)> = (0..results.scenes.len()).filter_map(gain).collect();
    let is_one = gains.iter().all(|(cell, gain)| *cell == gains[0].0 && *gain > 1.05);
    if let (true, [(cell, _), ..]) = (is_one, &gains[..]) {
        let times = span(gains.iter().map(|(_, gain)| *gain), |gain| format!("{gain:.1}"));
        text += &format!(" The quickest way, {} ({}), is {times} times as fast.", cell.name(), way(*cell));
    }
    text
}

/// What is to be said about frames and voxels.
fn proofs(verdicts: &[(&Row, Verdict)]) -> String {
    let count = |is_bad: fn(&Verdict) -> bool| verdicts.iter().filter(|(_, verdict)| is_bad(verdict)).count();
    let (lost, wrong) = (count(|verdict| !verdict.is_stable), count(|verdict| verdict.is_conformant == Some(false)));
    let proved: usize = verdicts.iter().filter_map(|(row, _)| row.summary()).map(|summary| summary.frames).sum();
    match (lost, wrong) {
        (0, 0) => {
            // A cell that was interrupted was not compared.
            let is_compared = verdicts.iter().all(|(_, verdict)| verdict.is_conformant.is_some());
            let voxels = if is_compared { ", with the right voxels" } else { "" };
            format!("; all {proved} frames are proved to have been rendered{voxels}")
        }
        (0, _) => "; but it finds wrong voxels".into(),
        (_, 0) => "; but it is not stable: frames are not proved to have been rendered".into(),
        _ => "; but frames are not proved to have been rendered, and wrong voxels are found".into(),
    }
}

/// What keeps the answer from being the study's: other pictures, other scenes.
pub fn cautions(results: &Results) -> Vec<String> {
    let plan = &results.plan;
    let mut cautions = Vec::new();
    if (plan.width, plan.height) != STUDY_SIZE {
        let (width, height) = STUDY_SIZE;
        cautions.push(format!(
            "The pictures have {} × {} pixels, not the study's {width} × {height}: frame rates cannot be compared with it.",
            plan.width, plan.height
        ));
    }
    if plan.integrator != Integrator::Essay {
        cautions.push(format!(
            "The integrator is {}, not the study's essay: frame rates cannot be compared with it.",
            plan.integrator.name()
        ));
    }
    let is_small = |facts: &SceneFacts| {
        voxtrace::scenes::default_voxels(&facts.name).is_some_and(|usual| facts.voxels * 10 < usual * 9)
    };
    if results.scenes.iter().any(is_small) {
        cautions.push("Scenes are smaller than the study's 4.3, 5.2 and 13.6 million voxels.".into());
    }
    let fewest = results.rows.iter().filter_map(Row::summary).map(|summary| summary.frames).min();
    if let Some(fewest) = fewest.filter(|&fewest| fewest < 100) {
        let frames = if fewest == 1 { "one frame".into() } else { format!("no more than {fewest} frames") };
        cautions.push(format!("Some times rest on {frames}: take them as rough."));
    }
    let loud: Vec<(&Row, String)> =
        results.rows.iter().filter_map(|row| Some((row, results.disturbance(row)?))).collect();
    if let [(row, why), rest @ ..] = &loud[..] {
        let more =
            if rest.is_empty() { String::new() } else { format!(", and {} more", counted(rest.len() as u64, "cell")) };
        let name = format!("{} {}{more}", results.scenes[row.scene].name, row.cell.name());
        cautions.push(format!(
            "The machine was not quiet: {why} ({name}). Times are too long, and `compare` gives no verdict."
        ));
    }
    cautions
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::{Conformance, Measured, Processor};
    use crate::numbers::FrameLine;
    use crate::plan::Plan;

    /// One scene of the CPU with frames of so many milliseconds.
    fn results(ms: f64, spoil: impl Fn(&mut Measured)) -> Results {
        let plan = Plan {
            scenes: vec!["city".into()],
            cells: vec![Cell::new(Traversal::Cpu, None)],
            voxels: None,
            instances: None,
            sweep: Vec::new(),
            frames: 200,
            warm_up: 0,
            time_limit_s: None,
            width: 1980,
            height: 1080,
            max_bounces: 3,
            integrator: Integrator::Essay,
            seed: 1,
            is_exact: false,
            scene_options: None,
        };
        let facts = SceneFacts {
            name: "city".into(),
            voxels: 4_300_000,
            voxels_placed: 4_300_000,
            hash: "0".into(),
            camera: "default".into(),
            packed_bytes: 6_000_000,
            exact_figure: None,
            emulation: None,
        };
        let frames = (0..200).map(|frame| FrameLine::new(frame, None, ms, None, frame + 1)).collect();
        let conformance = Some(Conformance { rays: 1000, ..Conformance::default() });
        let mut measured = Measured { frames, film_checks: 1, conformance, ..Measured::default() };
        spoil(&mut measured);
        let row = Row::new(0, plan.cells[0], measured);
        let (sweep, doctor) = (Vec::new(), None);
        Results {
            plan,
            device: None,
            scenes: vec![facts],
            rows: vec![row],
            sweep,
            doctor,
            is_complete: true,
            runs: Vec::new(),
        }
    }

    #[test]
    fn sixty_frames_a_second_all_proved_is_a_yes() {
        let good = results(10.0, |_| {});
        assert!(sentence(&good).starts_with("Yes: this processor path traces scenes of 4.3 million voxels"));
        assert!(sentence(&good).contains(", at 100 frames a second") && sentence(&good).contains("in 6 MB"));
        assert!(sentence(&good).contains("all 200 frames are proved"));
        assert!(cautions(&good).is_empty());
        let slow = results(16.7, |_| {});
        assert!(sentence(&slow).starts_with("No: "), "{}", sentence(&slow));
    }

    #[test]
    fn a_lost_frame_an_unread_film_a_failure_and_wrong_voxels_are_a_no() {
        let lost = results(10.0, |measured| measured.lost = 1);
        assert!(sentence(&lost).starts_with("No: ") && sentence(&lost).contains("not stable"), "{}", sentence(&lost));
        let unread = results(10.0, |measured| measured.film_checks = 0);
        assert!(sentence(&unread).contains("not stable"));
        let failed = results(10.0, |measured| measured.failure = Some("device lost".into()));
        assert!(sentence(&failed).contains("not stable"));
        let wrong = results(10.0, |measured| {
            measured.conformance = Some(Conformance { rays: 1000, wrong: 1, ..Conformance::default() });
        });
        assert!(sentence(&wrong).starts_with("No: ") && sentence(&wrong).contains("wrong voxels"));
        let unknown = sentence(&results(10.0, |measured| measured.conformance = None));
        assert!(unknown.contains("all 200 frames are proved"), "{unknown}");
        assert!(!unknown.contains("right voxels"), "nobody looked: {unknown}");
        let nothing = results(10.0, |measured| measured.frames.clear());
        assert_eq!(sentence(&nothing), "Nothing has been measured yet.");
    }

    #[test]
    fn other_pictures_smaller_scenes_and_few_frames_are_said() {
        let mut other = results(10.0, |measured| measured.frames.truncate(3));
        other.plan.width = 495;
        other.scenes[0].voxels = 500_000;
        assert_eq!(cautions(&other).len(), 3);
        other.plan.integrator = Integrator::Path;
        assert!(cautions(&other)[1].starts_with("The integrator is path"), "{:?}", cautions(&other));
    }

    #[test]
    fn a_machine_that_was_not_quiet_is_said_once_of_work_on_the_processor() {
        let busy = |measured: &mut Measured| {
            measured.processor =
                Processor { wall: 4.0, own: Some(4.0), waited: Some(4.0), turns: 1, ..Default::default() };
        };
        let mut loud = results(10.0, busy);
        let row = loud.rows[0].clone();
        loud.rows.extend([row.clone(), row]);
        let said = cautions(&loud);
        assert_eq!(said.len(), 1);
        assert!(said[0].contains("waited 50 % of the time for a processor (city cpu, and 2 cells more)."), "{said:?}");
        loud.rows.iter_mut().for_each(|row| row.cell = Cell::REFERENCE);
        assert!(cautions(&loud).is_empty(), "a device has no part in it");
    }

    #[test]
    fn a_span_says_its_unit_once() {
        let show = |voxels: f64| millions(voxels as u64);
        assert_eq!(span([4.3e6, 13.6e6].into_iter(), show), "4.3 to 13.6 million");
        assert_eq!(span([4.3e6, 4.31e6].into_iter(), show), "4.3 million");
        assert_eq!(span([0.21, 146.2].into_iter(), rate), "0.2 to 146");
    }
}
