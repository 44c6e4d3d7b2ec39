//! The panel of what was measured: samples, times, rays, memory.

use super::heading;
use super::status::{FRAMES, Status};
use crate::session::Session;
use crate::tr;
use egui::{Grid, ProgressBar, Ui};
use std::collections::VecDeque;
use voxtrace_vulkan::MemoryReport;

pub fn statistics(ui: &mut Ui, session: &Session, status: &Status) {
    let Some(shown) = &status.shown else { return };
    heading(ui, tr!("statistics.measured"));
    let (width, height) = session.size();
    let scale = if shown.scale > 1 { tr!("statistics.scale", scale = shown.scale) } else { String::new() };
    let (samples, all) = (shown.samples, session.render_settings.samples);
    ui.label(tr!("statistics.samples", width = width, height = height, samples = samples, all = all, scale = scale));
    // There as long as passes are long, so that what stands below does not jump.
    if shown.step_ms > 500.0 {
        ui.add(ProgressBar::new(status.step_share.fract()).text(tr!("statistics.next_pass")));
    }
    if let (Some(median), Some(p99)) = (status.percentile(0.5), status.percentile(0.99)) {
        ui.label(tr!("times.sample", median = format!("{median:.2}"), p99 = format!("{p99:.2}")));
        graph(ui, &status.times);
    }
    if let Some((statistics, memory)) = &shown.device {
        let rays = statistics.camera_rays + statistics.bounce_rays + statistics.shadow_rays;
        if statistics.gpu_ms > 0.0 {
            let rays = format!("{:.1}", rays as f64 / statistics.gpu_ms / 1e3);
            ui.label(tr!("statistics.rays", rays = rays));
        }
        egui::CollapsingHeader::new(tr!(
            "statistics.memory",
            total = format!("{:.1}", mebibytes(memory.total_bytes()))
        ))
        .show(ui, |ui| {
            memory_grid(ui, memory, "memory");
        });
    }
}

/// What is allocated on the device, by name.
pub fn memory_grid(ui: &mut Ui, memory: &MemoryReport, id: &str) {
    Grid::new(id).show(ui, |ui| {
        for (name, &bytes) in &memory.entries {
            ui.label(name);
            ui.label(format!("{:.2} MiB", mebibytes(bytes)));
            ui.end_row();
        }
    });
}

pub fn mebibytes(bytes: u64) -> f64 {
    bytes as f64 / f64::from(1 << 20)
}

/// Times as bars, the longest as high as the graph.
fn graph(ui: &mut Ui, times: &VecDeque<f32>) {
    let (rect, _) = ui.allocate_exact_size(egui::vec2(ui.available_width().min(240.0), 36.0), egui::Sense::hover());
    let most = times.iter().copied().fold(f32::MIN_POSITIVE, f32::max);
    let painter = ui.painter_at(rect);
    painter.rect_filled(rect, 2.0, ui.visuals().extreme_bg_color);
    let step = rect.width() / FRAMES as f32;
    for (index, time) in times.iter().enumerate() {
        let x = rect.left() + (index as f32 + 0.5) * step;
        let top = rect.bottom() - time / most * rect.height();
        let stroke = egui::Stroke::new(step.max(1.0), ui.visuals().selection.bg_fill);
        painter.line_segment([egui::pos2(x, rect.bottom()), egui::pos2(x, top)], stroke);
    }
}
