//! How far a command is that runs beside the window, with a button that stops it.

use crate::session::Session;
use crate::tr;
use egui::{Align2, ProgressBar, Ui};

/// Points above the lower edge.
const ABOVE: f32 = 24.0;

pub fn running(ui: &Ui, session: &mut Session, side: f32) {
    let Some(running) = &mut session.running else { return };
    let left = running.seconds_left.filter(|&seconds| seconds >= 1.0);
    let left = left.map_or(String::new(), |seconds| tr!("running.left", time = super::dialogs::duration(seconds)));
    let percent = running.share.map_or(String::new(), |share| format!(" {:.0} %", share * 100.0));
    let text = format!("{}{percent}{left}", running.work);
    let title = if running.request.measures { tr!("running.measuring") } else { tr!("running.recording") };
    egui::Window::new(title)
        .anchor(Align2::CENTER_BOTTOM, [-side / 2.0, -ABOVE - session.below])
        .collapsible(false)
        .resizable(false)
        .show(ui.ctx(), |ui| {
            ui.label(&running.request.name);
            ui.add(ProgressBar::new(running.share.unwrap_or(0.0)).desired_width(360.0).text(text));
            if running.is_stopping {
                ui.label(tr!("running.stopping"));
            } else if super::stop_button(ui, tr!("running.stop")) {
                running.cancel();
            }
        });
    ui.ctx().request_repaint_after(std::time::Duration::from_millis(250));
}
