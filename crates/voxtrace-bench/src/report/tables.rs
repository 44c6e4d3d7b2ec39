//! The tables of a report: one over everything, the study's three beside ours, the verdict, the sweep; and the report in
//! Markdown that they make up.

use super::machine::{CLOCKS, clocks, origins};
use super::table::Table;
use crate::measure::Walked;
use crate::plan::Cell;
use crate::results::verdict::{self, Verdict};
use crate::results::{Results, Row, SceneFacts, SweepRow};
use voxtrace_vulkan::Traversal;

/// The study's numbers on an RTX 3060 Ti.
struct Study {
    scene: &'static str,
    /// Milliseconds, exact and approximate.
    ms: [f64; 2],
    /// Frames a second, and their change, as it prints them.
    fps: [&'static str; 3],
    /// MB of voxels and of structures.
    megabytes: [f64; 2],
}

const STUDY: [Study; 3] = [
    Study { scene: "city", ms: [3.07, 3.53], fps: ["324", "282", "-13 %"], megabytes: [139.0, 162.0] },
    Study { scene: "operating-room", ms: [10.7, 10.0], fps: ["93", "100", "+7.5 %"], megabytes: [167.0, 195.0] },
    Study { scene: "church", ms: [12.5, 12.4], fps: ["80", "81", "+1.3 %"], megabytes: [438.0, 513.0] },
];

/// What the columns of [`all_cells`] mean.
pub const ALL_CELLS: &str = "Times are the GPU's own (wall clock for cpu). 95 %: the median lies there \
    with that certainty (bootstrap of blocks of frames). primary: a run of camera rays alone; bounce: the rays and the time \
    beyond it, with the integrator path also the rays towards lights. AS: acceleration structures; total: with the records of primitives and the scene's arrays (lights left \
    out). × voxel-exact: median of pipeline:voxel-exact of the same scene divided by the row's: more is faster. wrong \
    voxels: rays through the middles of pixels that meet another voxel than the exact one; from edge: the farthest that one \
    of them passes from an edge of one of the two, voxels.";

/// Whose numbers stand in the study's tables.
pub const STUDY_NOTE: &str = "The study's columns are its RTX 3060 Ti with photogrammetry scans; ours are generated scenes of \
    the same kind and size, by pipeline:voxel-exact and pipeline:voxel-approx.";

/// A number, or a dash.
pub fn number(value: Option<f64>, digits: usize) -> String {
    value.map_or("–".into(), |value| format!("{value:.digits$}"))
}

fn percent(value: f64) -> String {
    format!("{value:+.1} %")
}

/// Name and driver of what was measured.
pub fn device(results: &Results) -> String {
    results.device.as_ref().map_or("no GPU".to_owned(), |info| {
        format!("{} (driver {}, Vulkan {})", info.name, info.driver, info.api_version)
    })
}

/// The plan in a sentence.
pub fn settings(results: &Results) -> String {
    let plan = &results.plan;
    format!(
        "voxtrace {}, {} × {} pixels, integrator {}, at most {} bounces, seed {}, up to {} frames of one sample a pixel \
         each after up to {} of warm-up; {} threads.",
        env!("CARGO_PKG_VERSION"),
        plan.width,
        plan.height,
        plan.integrator.name(),
        plan.max_bounces,
        plan.seed,
        plan.frames,
        plan.warm_up,
        rayon::current_num_threads(),
    )
}

/// `report.md`.
pub fn report(results: &Results) -> String {
    let mut text = format!("# voxtrace bench: {}\n\n**{}**\n\n", device(results), verdict::sentence(results));
    if !results.is_complete {
        text += "**Not complete: cells are missing.**\n\n";
    }
    for caution in verdict::cautions(results) {
        text += &format!("{caution}\n\n");
    }
    text += &format!("{}\n\n{}\n{}", settings(results), origins(results), scenes(results).markdown());
    text += &format!("\n## All cells\n\n{}\n{ALL_CELLS}\n", all_cells(results).markdown());
    text += &format!("\n## The machine at work\n\n{}\n{CLOCKS}\n", clocks(results).markdown());
    let notes = notes(results);
    if !notes.is_empty() {
        text += "\n## What went wrong\n\n";
        text.extend(notes.iter().map(|note| format!("- {note}\n")));
    }
    let [times, rates, bytes] = study(results).map(|table| table.markdown());
    text += &format!("\n## The study's tables\n\n{STUDY_NOTE}\n\nTable 1: mean milliseconds a frame\n\n{times}");
    text += &format!("\nTable 2: frames a second\n\n{rates}\nTable 3: memory of `voxel-exact`, MB\n\n{bytes}");
    text += &format!("\n## Verdict\n\n{}", verdicts(results).markdown());
    if !results.sweep.is_empty() {
        text += &format!("\n## Frame time and memory against voxels\n\n{}", sweep(results).markdown());
    }
    if let Some(probes) = probes(results) {
        text += &format!("\n## The driver's probes\n\n{}", probes.markdown());
    }
    text
}

/// The scenes.
pub fn scenes(results: &Results) -> Table {
    let line = |facts: &SceneFacts| {
        let counts = [facts.voxels.to_string(), facts.voxels_placed.to_string()];
        [&[facts.name.clone()][..], &counts, &[facts.camera.clone(), facts.hash.clone()]].concat()
    };
    let head = ["scene", "voxels", "placed", "camera", "content hash"];
    Table::new(&head, 1, results.scenes.iter().map(line).collect())
}

/// Everything.
pub fn all_cells(results: &Results) -> Table {
    let head = [
        "scene",
        "traversal",
        "primitive or walk",
        "shaders",
        "frames",
        "lost",
        "median ms",
        "95 % of the median",
        "p1 ms",
        "p99 ms",
        "rays a frame",
        "Grays/s primary",
        "Grays/s bounce",
        "AS B/voxel",
        "total B/voxel",
        "× voxel-exact",
        "wrong voxels",
        "from edge",
    ];
    Table::new(&head, 4, results.rows.iter().map(|row| line(results, row)).collect())
}

fn line(results: &Results, row: &Row) -> Vec<String> {
    let facts = &results.scenes[row.scene];
    let (summary, speeds) = (row.summary(), row.speeds());
    let walk = || row.measured.walked.as_ref().map(Walked::text);
    let primitive = row.cell.primitive.map(|primitive| primitive.name().to_owned()).or_else(walk);
    let traversal =
        if row.cell.traversal == Traversal::Cpu { row.cell.name() } else { row.cell.traversal.name().into() };
    let primitive = primitive.unwrap_or("–".into());
    let mut cells = vec![facts.name.clone(), traversal, primitive, results.rounding(row.cell).into()];
    let Some(summary) = summary else {
        let reason = row.measured.failure.as_deref().unwrap_or("interrupted");
        cells.extend(["0".into(), row.measured.lost.to_string(), reason.to_owned()]);
        cells.resize(18, String::new());
        return cells;
    };
    let per_voxel = |bytes: u64| number(Some(bytes as f64 / facts.voxels.max(1) as f64), 3);
    let differs = row.measured.conformance.filter(|found| found.errors() > 0);
    let from_edge = differs.map(|found| found.from_edge).filter(|distance| distance.is_finite());
    cells.extend([
        summary.frames.to_string(),
        row.measured.lost.to_string(),
        number(Some(summary.median), 3),
        interval(summary.intervals.map(|intervals| intervals.median)),
        number(Some(summary.p1), 3),
        number(Some(summary.p99), 3),
        number(summary.rays, 0),
        number(speeds.primary, 3),
        number(speeds.bounce, 3),
        if row.cell.traversal.uses_primitives() { per_voxel(row.accel_bytes()) } else { "–".into() },
        per_voxel(row.traced_bytes(facts)),
        number(results.times_reference(row), 2),
        row.measured.conformance.map_or("–".into(), |found| found.errors().to_string()),
        from_edge.map_or("–".into(), |distance| format!("{distance:.1e}")),
    ]);
    cells
}

/// Least and most, or a dash.
fn interval(ends: Option<[f64; 2]>) -> String {
    ends.map_or("–".into(), |[least, most]| format!("{least:.3} to {most:.3}"))
}

/// What went wrong on the way.
pub fn notes(results: &Results) -> Vec<String> {
    let mut notes = Vec::new();
    for row in &results.rows {
        let failure = row.measured.failure.iter().filter(|_| !row.measured.frames.is_empty());
        for note in failure.chain(&row.measured.notes) {
            notes.push(format!("{} {}: {note}", results.scenes[row.scene].name, row.cell.name()));
        }
    }
    notes
}

/// Tables 1 to 3 of the study.
pub fn study(results: &Results) -> [Table; 3] {
    let mut tables: [Vec<Vec<String>>; 3] = Default::default();
    for (index, facts) in results.scenes.iter().enumerate() {
        let theirs = STUDY.iter().find(|study| study.scene == facts.name);
        let row = |cell| results.row(index, cell).filter(|row| row.summary().is_some());
        let (exact, approx) = (row(Cell::REFERENCE), row(Cell::APPROXIMATE));
        let mean = |row: Option<&Row>| row.and_then(Row::summary).map(|summary| summary.mean);
        let times = |exact: Option<f64>, approx: Option<f64>| {
            let change = exact.zip(approx).map(|(exact, approx)| format!("{:+.2}", approx - exact));
            [number(exact, 2), number(approx, 2), change.unwrap_or("–".into())]
        };
        let rates = |exact: Option<f64>, approx: Option<f64>| {
            let (exact, approx) = (exact.map(|ms| 1000.0 / ms), approx.map(|ms| 1000.0 / ms));
            let change = exact.zip(approx).map(|(exact, approx)| percent(100.0 * (approx / exact - 1.0)));
            {
                let show = |fps: Option<f64>| fps.map_or("–".into(), verdict::rate);
                [show(exact), show(approx), change.unwrap_or("–".into())]
            }
        };
        let bytes = |pair: Option<(f64, f64)>| {
            let change = pair.map(|(voxels, accel)| percent(100.0 * (accel / voxels - 1.0)));
            let all = [pair.map(|pair| pair.0), pair.map(|pair| pair.1), pair.map(|pair| pair.0 + pair.1)];
            let [voxels, accel, total] = all.map(|value| number(value, 0));
            [voxels, accel, total, change.unwrap_or("–".into())]
        };
        let name = || vec![facts.name.clone()];
        let (our_exact, our_approx) = (mean(exact), mean(approx));
        let join = |a: &[String], b: &[String]| [&name()[..], a, b].concat();
        let their_ms = |index: usize| theirs.map(|study| study.ms[index]);
        tables[0].push(join(&times(their_ms(0), their_ms(1)), &times(our_exact, our_approx)));
        let their_fps = theirs.map_or(["–"; 3], |study| study.fps).map(str::to_owned);
        tables[1].push(join(&their_fps, &rates(our_exact, our_approx)));
        let their_bytes = theirs.map(|study| study.megabytes.into());
        let our_bytes = exact
            .map(|row| ((row.record_bytes() + row.scene_bytes(facts)) as f64 / 1e6, row.accel_bytes() as f64 / 1e6));
        tables[2].push(join(&bytes(their_bytes), &bytes(our_bytes)));
    }
    let [times, rates, bytes] = tables;
    let times_head = ["scene", "study exact", "study approx", "change", "exact", "approx", "change"];
    let bytes_head = ["scene", "study voxels", "study AS", "study total", "change", "voxels", "AS", "total", "change"];
    [Table::new(&times_head, 1, times), Table::new(&times_head, 1, rates), Table::new(&bytes_head, 1, bytes)]
}

/// Whether each scene meets the study's criteria with each cell.
pub fn verdicts(results: &Results) -> Table {
    let yes = |is: bool| if is { "yes" } else { "**no**" }.to_owned();
    let line = |row: &Row| {
        let facts = &results.scenes[row.scene];
        let (Some(summary), Some(verdict)) = (row.summary(), Verdict::of(results, row)) else {
            let no = ["**no** (it did not run)", "–", "–", "–"].map(str::to_owned);
            return [vec![facts.name.clone(), row.cell.name()], no.to_vec()].concat();
        };
        let bytes = row.traced_bytes(facts);
        let conformant = row.measured.conformance.zip(verdict.is_conformant);
        let wrong = conformant.map(|(found, is)| format!("{} ({:.4} % wrong)", yes(is), 100.0 * found.share()));
        vec![
            facts.name.clone(),
            row.cell.name(),
            format!("{} ({})", yes(verdict.is_fast), verdict::rate(summary.fps)),
            format!("{} ({:.0} MB)", yes(verdict.is_small), bytes as f64 / 1e6),
            format!("{} ({} proved, {} lost)", yes(verdict.is_stable), summary.frames, row.measured.lost),
            wrong.unwrap_or("–".into()),
        ]
    };
    let head = ["scene", "cell", "60 frames a second?", "at most 1 GB?", "stable: every frame proved?", "conformant?"];
    Table::new(&head, 2, results.rows.iter().map(line).collect())
}

/// Frame time and memory against voxels.
pub fn sweep(results: &Results) -> Table {
    let line = |row: &SweepRow| {
        let failure = || row.failure.clone().unwrap_or_else(|| "no frame".into());
        vec![
            row.scene.clone(),
            row.cell.name(),
            row.voxels.to_string(),
            row.median.map_or_else(failure, |median| format!("{median:.3}")),
            format!("{:.1}", row.bytes as f64 / 1e6),
            row.frames.to_string(),
            row.lost.to_string(),
        ]
    };
    let head = ["scene", "cell", "voxels", "median ms", "MB", "frames", "lost"];
    Table::new(&head, 2, results.sweep.iter().map(line).collect())
}

/// What `voxtrace doctor` found out about the driver.
pub fn probes(results: &Results) -> Option<Table> {
    let probes = results.doctor.as_ref()?["probes"].as_array()?;
    let line = |probe: &serde_json::Value| {
        let text = |name: &str| probe[name].as_str().map_or_else(|| "–".to_owned(), str::to_owned);
        let outcome = text("outcome");
        let outcome = if outcome == "fails" { "**fails**".into() } else { outcome };
        vec![text("id"), text("name"), outcome, text("says")]
    };
    Some(Table::new(&["probe", "what", "outcome", "says"], 4, probes.iter().map(line).collect()))
}
