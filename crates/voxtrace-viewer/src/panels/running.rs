//! How far a command is that runs beside the window, with a button that stops it.

use crate::session::Session;
use crate::tr;
use egui::{Label, ProgressBar, Ui};

/// Points of the bar, and of the lines above it.
const WIDTH: f32 = 360.0;

/// Beside the side panel, of `side` points, and `below` above the lower edge. Returns how high it is.
pub fn running(ui: &Ui, session: &mut Session, side: f32, below: f32) -> f32 {
    let Some(running) = &mut session.running else { return 0.0 };
    let left = running.seconds_left.filter(|&seconds| seconds >= 1.0);
    let left = left.map_or(String::new(), |seconds| tr!("running.left", time = super::dialogs::duration(seconds)));
    let text = running.share.map_or(String::new(), |share| format!("{:.0} %{left}", share * 100.0));
    let title = if running.request.measures { tr!("running.measuring") } else { tr!("running.recording") };
    let height = super::under_way(ui, title, side, below, |ui| {
        ui.set_width(WIDTH);
        ui.label(&running.request.name);
        // As long as it may be: a bar cuts its text off. Always there, so that the bar stays in its place.
        ui.add(Label::new(&running.work).truncate());
        ui.add(ProgressBar::new(running.share.unwrap_or(0.0)).text(text));
        if running.is_stopping {
            ui.label(tr!("running.stopping"));
        } else if super::stop_button(ui, tr!("running.stop")) {
            running.cancel();
        }
    });
    ui.ctx().request_repaint_after(std::time::Duration::from_millis(250));
    height
}
