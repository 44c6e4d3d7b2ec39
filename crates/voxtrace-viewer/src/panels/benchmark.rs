//! The panel of the benchmark: measuring the view, and what it gave.

use super::statistics::mebibytes;
use super::{Noun, counted, heading};
use crate::benchmark::FRAMES;
use crate::keys::{Action, key_of};
use crate::session::Session;
use crate::tr;
use egui::{Button, Grid, ProgressBar, RichText, Ui};
use voxtrace_bench::Measurement;

pub fn benchmark(ui: &mut Ui, session: &mut Session) {
    heading(ui, tr!("benchmark.benchmark"));
    let has_scene = session.open.is_some();
    ui.horizontal_wrapped(|ui| {
        let label = if session.benchmark.is_some() { tr!("benchmark.stop") } else { tr!("benchmark.start") };
        let about = tr!("benchmark.about", frames = FRAMES);
        if ui.add_enabled(has_scene, Button::new(label)).on_hover_text(about).clicked() {
            session.act(Action::Benchmark, None);
        }
        if ui.button(tr!("benchmark.plan")).on_hover_text(key_of(Action::Plan)).clicked() {
            session.act(Action::Plan, None);
        }
        if ui.add_enabled(has_scene, Button::new(tr!("benchmark.copy_bench_command"))).clicked() {
            session.act(Action::CopyBenchmark, None);
        }
    });
    if let Some(benchmark) = &session.benchmark {
        let (done, all) = benchmark.frames;
        let share = if all > 0 { done as f32 / all as f32 } else { 0.0 };
        ui.add(ProgressBar::new(share).text(benchmark.work.as_str()));
    }
    let Some(measured) = session.measured.clone() else { return };
    for row in &measured {
        ui.label(RichText::new(format!("{}{}", scene(row, &measured), cell(row))).strong());
        Grid::new(("measured", &row.scene, &row.cell)).num_columns(2).show(ui, |ui| {
            for (name, value) in lines(row) {
                ui.label(name);
                ui.label(value);
                ui.end_row();
            }
        });
        if let Some(failure) = &row.failure {
            ui.label(failure);
        }
    }
    if measured.is_empty() {
        ui.label(tr!("benchmark.stopped_before_the_first_frame"));
    }
}

/// The name of a row's scene, where there are several.
fn scene(row: &Measurement, all: &[Measurement]) -> String {
    let is_one = all.iter().all(|other| other.scene == row.scene);
    if is_one { String::new() } else { format!("{}, ", row.scene) }
}

/// A row's cell with its rounding, which the names of some have already.
fn cell(row: &Measurement) -> String {
    match row.cell.split(':').any(|word| word == row.rounding) {
        true => row.cell.clone(),
        false => format!("{}, {}", row.cell, row.rounding),
    }
}

/// What is told of a cell.
fn lines(row: &Measurement) -> Vec<(&'static str, String)> {
    let mut lines = Vec::new();
    if let Some(times) = row.times {
        lines.push((tr!("benchmark.frames"), times.frames.to_string()));
        lines.push((tr!("benchmark.median"), format!("{:.3} ms", times.median_ms)));
        lines.push(("99 %", format!("{:.3} ms", times.p99_ms)));
        let rays = times.rays_per_second.map(|rays| format!("{:.4} G/s", rays / 1e9));
        lines.push((tr!("benchmark.rays"), rays.unwrap_or(tr!("benchmark.not_counted").into())));
    }
    lines.push((tr!("benchmark.traced"), format!("{:.1} MiB", mebibytes(row.traced_bytes))));
    if let Some(peak) = row.peak_bytes {
        lines.push((tr!("benchmark.peak"), format!("{:.1} MiB", mebibytes(peak))));
    }
    if let Some((wrong, rays)) = row.wrong_voxels {
        lines.push((tr!("benchmark.wrong"), tr!("benchmark.wrong_of", wrong = wrong, rays = counted(rays, Noun::Ray))));
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rounding_is_told_once() {
        let row = |cell: &str, rounding| Measurement {
            scene: "city".into(),
            cell: cell.into(),
            rounding,
            times: None,
            traced_bytes: 0,
            peak_bytes: None,
            wrong_voxels: None,
            failure: None,
        };
        assert_eq!(cell(&row("cpu:avx2", "precise")), "cpu:avx2, precise");
        assert_eq!(cell(&row("query:brick:fast", "fast")), "query:brick:fast");
    }
}
