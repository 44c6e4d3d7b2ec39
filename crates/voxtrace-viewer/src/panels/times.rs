//! What frames take, over the picture: their passes by name, rays, and memory by name.

use super::statistics::{mebibytes, memory_grid};
use super::status::Status;
use crate::engine::{Lit, Shown};
use crate::session::Session;
use crate::tr;
use egui::{Align2, Color32, Frame, Grid, Margin, ScrollArea, Ui, Window};
use voxtrace_vulkan::Rate;

/// Shows it in the corner of the picture.
pub fn times(ui: &Ui, session: &mut Session, status: &Status) {
    let Some(shown) = status.shown.as_ref().filter(|_| session.has_times && session.open.is_some()) else { return };
    let fill = match ui.visuals().dark_mode {
        true => Color32::from_black_alpha(205),
        false => Color32::from_white_alpha(225),
    };
    let frame = Frame::NONE.fill(fill).inner_margin(Margin::same(8)).corner_radius(4);
    let mut is_open = session.has_times;
    Window::new(tr!("times.title"))
        .anchor(Align2::LEFT_TOP, [8.0, 8.0])
        .open(&mut is_open)
        .collapsible(false)
        .resizable(false)
        .frame(frame)
        .show(ui.ctx(), |ui| {
            ScrollArea::vertical().max_height(ui.ctx().content_rect().height() - 80.0).show(ui, |ui| {
                contents(ui, session, status, shown);
            });
        });
    session.has_times = is_open;
}

fn contents(ui: &mut Ui, session: &Session, status: &Status, shown: &Shown) {
    if let Some(lit) = &shown.lit {
        real_time(ui, status, lit);
    }
    let (done, all) = (shown.samples, session.render_settings.samples);
    ui.label(tr!("times.film", done = done, all = all));
    if let (Some(median), Some(p99)) = (status.percentile(0.5), status.percentile(0.99)) {
        let (median, p99) = (format!("{median:.2}"), format!("{p99:.2}"));
        ui.label(tr!("times.sample", median = median, p99 = p99));
    }
    let Some((statistics, memory)) = &shown.device else { return };
    if statistics.gpu_ms > 0.0 {
        let rays = [statistics.camera_rays, statistics.bounce_rays, statistics.shadow_rays];
        let millions = |rays: u64| format!("{:.1}", rays as f64 / statistics.gpu_ms / 1e3);
        ui.label(tr!("times.rays", rays = millions(rays.iter().sum())));
        let [camera, bounce, shadow] = rays.map(millions);
        ui.label(tr!("times.kinds", camera = camera, bounce = bounce, shadow = shadow));
    }
    ui.separator();
    ui.label(tr!("times.memory", total = format!("{:.1}", mebibytes(memory.total_bytes()))));
    memory_grid(ui, memory, "times.memory");
}

/// The frame that is seen, and its passes.
fn real_time(ui: &mut Ui, status: &Status, lit: &Lit) {
    let Lit { frame, quality, film_weight } = lit;
    ui.label(tr!("times.real_time", ms = format!("{:.2}", frame.gpu_ms)));
    if let (Some(median), Some(p99)) = (status.frame_percentile(0.5), status.frame_percentile(0.99)) {
        let (median, p99) = (format!("{median:.2}"), format!("{p99:.2}"));
        ui.label(tr!("times.frames", median = median, p99 = p99));
    }
    let rate = if quality.rate == Rate::Half { tr!("times.half") } else { tr!("times.full") };
    ui.label(tr!("times.quality", rate = rate, scale = quality.scale));
    if *film_weight > 0.0 {
        ui.label(tr!("times.weight", share = format!("{:.0}", film_weight * 100.0)));
    }
    Grid::new("times.passes").show(ui, |ui| {
        for (name, ms) in lit.passes() {
            ui.label(name);
            ui.label(format!("{ms:.3} ms"));
            ui.end_row();
        }
    });
    ui.label(tr!("times.its_memory", total = format!("{:.1}", mebibytes(frame.bytes))));
    ui.separator();
}
