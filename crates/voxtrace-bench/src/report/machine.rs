//! What the machine did while it measured: processors that cells had and waited for, clocks, load, heat; and when and by which command that was.

use super::table::Table;
use crate::results::{Results, Row};

/// What the columns of [`clocks`] mean.
pub const CLOCKS: &str = "processors: processor time of this program over wall time, of the processors that it may use; waited: part of the \
    time in which its threads could run that they had none; others: part of the processors that other programs had. Clocks and load before → \
    after the frames of each cell.";

/// Processors, clocks and heat, where any could be read.
pub fn clocks(results: &Results) -> Table {
    let names = ["cpu_mhz", "load", "sm_mhz", "memory_mhz", "celsius", "watts"];
    let part = |part: Option<f64>| part.map_or("–".into(), |part| format!("{:.0} %", 100.0 * part));
    let line = |row: &Row| {
        let [before, after] = &row.measured.clocks;
        let pair = |name: &str| match (before[name].as_f64(), after[name].as_f64()) {
            (Some(before), Some(after)) => format!("{before} → {after}"),
            _ => "–".into(),
        };
        let processor = &row.measured.processor;
        let share = processor.share().zip(processor.count);
        let share = share.map_or("–".into(), |(share, count)| format!("{share:.2} of {count}"));
        let start = vec![
            results.scenes[row.scene].name.clone(),
            row.cell.name(),
            share,
            part(processor.waited_part()),
            part(processor.others_part()),
        ];
        [start, names.map(pair).to_vec()].concat()
    };
    let head =
        ["scene", "cell", "processors", "waited", "others", "CPU MHz", "load", "SM MHz", "memory MHz", "°C", "W"];
    Table::new(&head, 2, results.rows.iter().map(line).collect())
}

/// When and by which command it was measured, a line for each run.
pub fn origins(results: &Results) -> String {
    results.runs.iter().map(|run| format!("Measured {}.\n", run.text())).collect()
}
