//! The table of a report for a terminal.

use super::tables::number;
use crate::results::{Results, verdict};

impl Results {
    /// All cells, and the answer, as a table for a terminal.
    pub fn table(&self) -> String {
        compact(self)
    }
}

/// A table for a terminal.
fn compact(results: &Results) -> String {
    let mut text = format!(
        "{:<16} {:<22} {:<8} {:>7} {:>5} {:>10} {:>10} {:>8} {:>8} {:>8} {:>9} {:>8} {:>7}\n",
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
        "x exact",
        "wrong"
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
            "{start} {:>7} {:>5} {:>10.3} {:>10.3} {:>8.1} {:>8} {:>8} {:>9.3} {:>8} {:>7}\n",
            summary.frames,
            row.measured.lost,
            summary.median,
            summary.p99,
            summary.fps,
            dash(speeds.primary, 3),
            dash(speeds.bounce, 3),
            row.traced_bytes(facts) as f64 / facts.voxels.max(1) as f64,
            dash(results.times_reference(row), 2),
            row.measured.conformance.map_or("-".into(), |found| found.errors().to_string()),
        );
    }
    text += "\n";
    for (row, walked) in results.rows.iter().filter_map(|row| Some((row, row.measured.walked.as_ref()?))) {
        text += &format!("{} {}: {}\n", results.scenes[row.scene].name, row.cell.name(), walked.text());
    }
    text += &format!("\n{}\n", verdict::sentence(results));
    text.extend(verdict::cautions(results).iter().map(|caution| format!("{caution}\n")));
    text
}
