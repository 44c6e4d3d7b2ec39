//! The charts of a report: frame time over frames, and frame time and memory against voxels.

use super::plot::{Plot, Series};
use crate::numbers::FrameLine;
use crate::plan::Cell;
use crate::results::verdict::{BUDGET_BYTES, BUDGET_MS};
use crate::results::{Results, SweepRow};
use voxtrace_vulkan::{Primitive, Traversal};

/// Points of a line over frames; each stands for as many frames as it must.
const POINTS: usize = 100;
/// A chart whose values span more than this has a logarithmic axis.
const WIDE: f64 = 12.0;

/// All charts with something in them, by the name of their file.
pub fn all(results: &Results) -> Vec<(String, Plot)> {
    let mut charts = Vec::new();
    for (index, facts) in results.scenes.iter().enumerate() {
        charts.push((format!("frame-time-{}-{}.svg", index + 1, facts.name), over_frames(results, index)));
    }
    for scene in results.plan.sweep_scenes() {
        charts.push((format!("voxels-time-{scene}.svg"), against_voxels(results, &scene)));
    }
    if let Some(scene) = results.plan.sweep_scenes().last() {
        charts.push((format!("voxels-memory-{scene}.svg"), memory(results, scene)));
    }
    charts.retain(|(_, plot)| !plot.is_empty());
    charts
}

/// A cell has the same colour in every chart: that of its primitive or instructions, or its own.
fn color_of(cell: Cell) -> usize {
    match (cell.traversal, cell.primitive) {
        (Traversal::Cpu, _) => cell.instructions.map_or(7, |instructions| instructions as usize),
        (_, None) => 5,
        (_, Some(primitive)) => Primitive::ALL.iter().position(|&other| other == primitive).unwrap_or(6),
    }
}

/// An empty line of a cell.
fn series_of(cell: Cell) -> Series {
    let is_dashed = cell.traversal == Traversal::Query || cell.is_exact == Some(true);
    Series { name: cell.name(), color: color_of(cell), points: Vec::new(), band: Vec::new(), has_dots: true, is_dashed }
}

fn over_frames(results: &Results, scene: usize) -> Plot {
    let rows = results.rows.iter().filter(|row| row.scene == scene);
    let series: Vec<Series> = rows
        .filter(|row| !row.measured.frames.is_empty())
        .map(|row| {
            let (points, band) = thinned(&row.measured.frames);
            Series { has_dots: points.len() < 20, points, band, ..series_of(row.cell) }
        })
        .collect();
    Plot {
        title: format!("{}: frame time over frames, {}", results.scenes[scene].name, results.plan.integrator.name()),
        x_label: "frame".into(),
        y_label: "milliseconds (band: least and most)".into(),
        is_log_x: false,
        is_log_y: is_wide(&series, Some(BUDGET_MS)),
        series,
        rules: vec![(BUDGET_MS, "60 frames a second".into())],
    }
}

type Pairs = Vec<(f64, f64)>;

/// Medians of runs of frames, and the least and most of each.
fn thinned(frames: &[FrameLine]) -> (Pairs, Pairs) {
    let size = frames.len().div_ceil(POINTS).max(1);
    let of_run = |run: &[FrameLine]| {
        let mut ms: Vec<f64> = run.iter().map(FrameLine::ms).collect();
        ms.sort_by(f64::total_cmp);
        let middle = f64::from(run[run.len() / 2].frame);
        ((middle, ms[ms.len() / 2]), (ms[0], ms[ms.len() - 1]))
    };
    frames.chunks(size).map(of_run).unzip()
}

fn against_voxels(results: &Results, scene: &str) -> Plot {
    let series = lines(results, scene, |row| row.median);
    Plot {
        title: format!("{scene}: frame time against voxels, {}", results.plan.integrator.name()),
        x_label: "voxels".into(),
        y_label: "median milliseconds".into(),
        is_log_x: true,
        is_log_y: is_wide(&series, Some(BUDGET_MS)),
        series,
        rules: vec![(BUDGET_MS, "60 frames a second".into())],
    }
}

fn memory(results: &Results, scene: &str) -> Plot {
    let series = lines(results, scene, |row| row.failure.is_none().then_some(row.bytes as f64 / 1e6));
    Plot {
        title: format!("{scene}: memory against voxels"),
        x_label: "voxels".into(),
        y_label: "MB of what is traced".into(),
        is_log_x: true,
        is_log_y: true,
        series,
        rules: vec![(BUDGET_BYTES as f64 / 1e6, "1 GB".into())],
    }
}

/// A line for each cell of the sweep.
fn lines(results: &Results, scene: &str, value: impl Fn(&SweepRow) -> Option<f64>) -> Vec<Series> {
    let of_cell = |cell: Cell| {
        let rows = results.sweep.iter().filter(|row| row.scene == scene && row.cell == cell);
        let points = rows.filter_map(|row| Some((row.voxels as f64, value(row)?))).collect();
        Series { points, ..series_of(cell) }
    };
    let series = results.plan.sweep_cells().into_iter().map(of_cell);
    series.filter(|series| !series.points.is_empty()).collect()
}

fn is_wide(series: &[Series], rule: Option<f64>) -> bool {
    let values = series.iter().flat_map(|series| series.points.iter().map(|point| point.1)).chain(rule);
    let (least, most) = values.fold((f64::INFINITY, 0.0_f64), |(a, b), value| (a.min(value), b.max(value)));
    most > WIDE * least
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_single_slow_frame_among_thousands_is_in_the_band() {
        let frames: Vec<FrameLine> = (0..4096)
            .map(|frame| FrameLine::new(frame, Some(if frame == 777 { 50.0 } else { 5.0 }), 60.0, None, frame + 1))
            .collect();
        let (points, band) = thinned(&frames);
        assert!(points.len() <= POINTS && points.iter().all(|point| point.1 == 5.0));
        assert_eq!(band.iter().filter(|band| band.1 == 50.0).count(), 1);
        assert_eq!(thinned(&frames[..3]).0.len(), 3);
    }
}
