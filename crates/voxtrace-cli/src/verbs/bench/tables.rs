//! The report for people: one table over everything, the study's three tables beside ours, and the verdict.

use super::cells::Cell;
use super::results::{Results, Row};
use super::verdict::{self, Verdict};

/// The study's numbers on an RTX 3060 Ti: scene, exact and approximate milliseconds, MB of voxels and of structures.
pub const STUDY: [(&str, f64, f64, u32, u32); 3] =
    [("city", 3.07, 3.53, 139, 162), ("operating-room", 10.7, 10.0, 167, 195), ("church", 12.5, 12.4, 438, 513)];

/// A number, or a dash.
fn number(value: Option<f64>, digits: usize) -> String {
    value.map_or("–".into(), |value| format!("{value:.digits$}"))
}

fn percent(value: f64) -> String {
    format!("{value:+.1} %")
}

/// A Markdown table; columns but the first `left` are numbers.
fn table(head: &[&str], left: usize, lines: &[Vec<String>]) -> String {
    let rule = (0..head.len()).map(|i| if i < left { "---" } else { "---:" }).collect::<Vec<_>>().join("|");
    let mut text = format!("| {} |\n|{rule}|\n", head.join(" | "));
    for line in lines {
        text += &format!("| {} |\n", line.join(" | ").replace('\n', " "));
    }
    text
}

/// `report.md`.
pub fn report(results: &Results) -> String {
    let plan = &results.plan;
    let device = results.device.as_ref().map_or("no GPU".to_owned(), |info| {
        format!("{} (driver {}, Vulkan {})", info.name, info.driver, info.api_version)
    });
    let mut text = format!("# voxtrace bench: {device}\n\n**{}**\n\n", verdict::sentence(results));
    if !results.is_complete {
        text += "**Not complete: cells are missing.**\n\n";
    }
    text += &format!(
        "voxtrace {}, {} × {} pixels, integrator `essay`, at most {} bounces, seed {}, up to {} frames of one sample a \
         pixel each after up to {} of warm-up; {} threads ({}).\n\n",
        env!("CARGO_PKG_VERSION"),
        plan.width,
        plan.height,
        plan.max_bounces,
        plan.seed,
        plan.frames,
        plan.warm_up,
        rayon::current_num_threads(),
        voxtrace::walk::simd_name(),
    );
    let scenes: Vec<Vec<String>> = results
        .scenes
        .iter()
        .map(|facts| {
            vec![
                facts.name.clone(),
                facts.voxels.to_string(),
                facts.voxels_placed.to_string(),
                facts.camera.clone(),
                facts.hash.clone(),
            ]
        })
        .collect();
    text += &table(&["scene", "voxels", "placed", "camera", "content hash"], 1, &scenes);
    text += "\n## All cells\n\n";
    text += &table(
        &[
            "scene",
            "traversal",
            "primitive",
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
        ],
        4,
        &results.rows.iter().map(|row| line(results, row)).collect::<Vec<_>>(),
    );
    text += "\nTimes are the GPU's own (wall clock for `cpu`, which counts no rays). *primary*: a run of camera rays alone; \
             *bounce*: the rays and the time beyond it. *AS*: acceleration structures; *total*: with the records of primitives \
             and the scene's arrays (lights left out). *× voxel-exact*: median of `pipeline:voxel-exact` of the same scene \
             divided by the row's: more is faster. *95 %*: the median lies there with that certainty (bootstrap of blocks of \
             frames). *wrong voxels*: rays through the middles of pixels that meet another voxel than the exact one.\n";
    text + &notes(results) + &study(results) + &verdict(results) + &sweep(results)
}

fn line(results: &Results, row: &Row) -> Vec<String> {
    let facts = &results.scenes[row.scene];
    let (summary, speeds) = (row.summary(), row.speeds());
    let primitive = row.cell.primitive.map_or("–", |primitive| primitive.name());
    let mut cells =
        vec![facts.name.clone(), row.cell.traversal.name().into(), primitive.into(), results.rounding(row.cell).into()];
    let Some(summary) = summary else {
        let reason = row.measured.failure.as_deref().unwrap_or("interrupted");
        cells.extend(["0".into(), row.measured.lost.to_string(), reason.replace('|', "/")]);
        cells.resize(17, String::new());
        return cells;
    };
    let per_voxel = |bytes: u64| number(Some(bytes as f64 / facts.voxels.max(1) as f64), 3);
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
    ]);
    cells
}

/// Least and most, or a dash.
fn interval(ends: Option<[f64; 2]>) -> String {
    ends.map_or("–".into(), |[least, most]| format!("{least:.3} to {most:.3}"))
}

/// What went wrong on the way.
fn notes(results: &Results) -> String {
    let mut text = String::new();
    for row in &results.rows {
        let failure = row.measured.failure.iter().filter(|_| !row.measured.frames.is_empty());
        for note in failure.chain(&row.measured.notes) {
            text += &format!("- {} {}: {note}\n", results.scenes[row.scene].name, row.cell.name());
        }
    }
    if text.is_empty() { text } else { format!("\n## What went wrong\n\n{text}") }
}

/// Tables 1 to 3 of the study.
fn study(results: &Results) -> String {
    let mut tables: [Vec<Vec<String>>; 3] = Default::default();
    for (index, facts) in results.scenes.iter().enumerate() {
        let theirs = STUDY.iter().find(|(name, ..)| *name == facts.name);
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
            [number(exact, 0), number(approx, 0), change.unwrap_or("–".into())]
        };
        let bytes = |pair: Option<(f64, f64)>| {
            let change = pair.map(|(voxels, accel)| percent(100.0 * (accel / voxels - 1.0)));
            let all = [pair.map(|pair| pair.0), pair.map(|pair| pair.1), pair.map(|pair| pair.0 + pair.1)];
            let [voxels, accel, total] = all.map(|value| number(value, 0));
            [voxels, accel, total, change.unwrap_or("–".into())]
        };
        let name = || vec![facts.name.clone()];
        let (their_exact, their_approx) = (theirs.map(|row| row.1), theirs.map(|row| row.2));
        let (our_exact, our_approx) = (mean(exact), mean(approx));
        let join = |a: &[String], b: &[String]| [&name()[..], a, b].concat();
        tables[0].push(join(&times(their_exact, their_approx), &times(our_exact, our_approx)));
        tables[1].push(join(&rates(their_exact, their_approx), &rates(our_exact, our_approx)));
        let their_bytes = theirs.map(|row| (f64::from(row.3), f64::from(row.4)));
        let our_bytes = exact
            .map(|row| ((row.record_bytes() + row.scene_bytes(facts)) as f64 / 1e6, row.accel_bytes() as f64 / 1e6));
        tables[2].push(join(&bytes(their_bytes), &bytes(our_bytes)));
    }
    let [times, rates, bytes] = tables;
    let times_head = ["scene", "study exact", "study approx", "change", "exact", "approx", "change"];
    let bytes_head = ["scene", "study voxels", "study AS", "study total", "change", "voxels", "AS", "total", "change"];
    format!(
        "\n## The study's tables\n\nThe study's column is its RTX 3060 Ti with photogrammetry scans; ours are generated scenes of the same \
         kind and size, `pipeline:voxel-exact` and `pipeline:voxel-approx`.\n\n\
         Table 1: mean milliseconds a frame\n\n{}\nTable 2: frames a second\n\n{}\nTable 3: memory of `voxel-exact`, MB\n\n{}",
        table(&times_head, 1, &times),
        table(&times_head, 1, &rates),
        table(&bytes_head, 1, &bytes),
    )
}

/// Whether each scene meets the study's criteria with each cell.
fn verdict(results: &Results) -> String {
    let yes = |is: bool| if is { "yes" } else { "**no**" }.to_owned();
    let lines: Vec<Vec<String>> = results
        .rows
        .iter()
        .map(|row| {
            let facts = &results.scenes[row.scene];
            let (Some(summary), Some(verdict)) = (row.summary(), Verdict::of(results, row)) else {
                let no = ["**no** (it did not run)", "–", "–", "–"].map(str::to_owned);
                return [vec![facts.name.clone(), row.cell.name()], no.to_vec()].concat();
            };
            let bytes = row.traced_bytes(facts);
            let conformant = row.measured.conformance.zip(verdict.is_conformant);
            vec![
                facts.name.clone(),
                row.cell.name(),
                format!("{} ({:.0})", yes(verdict.is_fast), summary.fps),
                format!("{} ({:.0} MB)", yes(verdict.is_small), bytes as f64 / 1e6),
                format!("{} ({} proved, {} lost)", yes(verdict.is_stable), summary.frames, row.measured.lost),
                conformant
                    .map_or("–".into(), |(found, is)| format!("{} ({:.4} % wrong)", yes(is), 100.0 * found.share())),
            ]
        })
        .collect();
    let head = ["scene", "cell", "60 frames a second?", "at most 1 GB?", "stable: every frame proved?", "conformant?"];
    format!("\n## Verdict\n\n{}", table(&head, 2, &lines))
}

/// Frame time and memory against voxels.
fn sweep(results: &Results) -> String {
    if results.sweep.is_empty() {
        return String::new();
    }
    let line = |row: &super::results::SweepRow| {
        let failure = || row.failure.clone().unwrap_or_else(|| "no frame".into()).replace('|', "/");
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
    let lines: Vec<Vec<String>> = results.sweep.iter().map(line).collect();
    let head = ["scene", "cell", "voxels", "median ms", "MB", "frames", "lost"];
    format!("\n## Frame time and memory against voxels\n\n{}", table(&head, 2, &lines))
}

/// A table for a terminal.
pub fn compact(results: &Results) -> String {
    let mut text = format!(
        "{:<16} {:<22} {:<8} {:>7} {:>5} {:>10} {:>10} {:>8} {:>8} {:>8} {:>9} {:>8}\n",
        "scene",
        "cell",
        "shaders",
        "frames",
        "lost",
        "median ms",
        "p99 ms",
        "fps",
        "prim G/s",
        "bnce G/s",
        "B/voxel",
        "x exact"
    );
    for row in &results.rows {
        let facts = &results.scenes[row.scene];
        let start = format!("{:<16} {:<22} {:<8}", facts.name, row.cell.name(), results.rounding(row.cell));
        let Some(summary) = row.summary() else {
            text += &format!("{start} {}\n", row.measured.failure.as_deref().unwrap_or("interrupted"));
            continue;
        };
        let speeds = row.speeds();
        let dash = |value, digits| number(value, digits).replace('–', "-");
        text += &format!(
            "{start} {:>7} {:>5} {:>10.3} {:>10.3} {:>8.1} {:>8} {:>8} {:>9.3} {:>8}\n",
            summary.frames,
            row.measured.lost,
            summary.median,
            summary.p99,
            summary.fps,
            dash(speeds.primary, 3),
            dash(speeds.bounce, 3),
            row.traced_bytes(facts) as f64 / facts.voxels.max(1) as f64,
            dash(results.times_reference(row), 2),
        );
    }
    text
}
