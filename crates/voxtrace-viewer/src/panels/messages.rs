//! What lies over the picture: a scene that is being opened, and lines for people.

use crate::keys::Action;
use crate::session::Session;
use crate::tr;
use egui::{Align2, ProgressBar, RichText, Ui};

/// Points to which a message is as long as its text; then it is wrapped.
const WIDEST_MESSAGE: f32 = 560.0;
/// Points between them and the edge of the window.
const MARGIN: f32 = 10.0;

/// A scene that is being opened, beside the side panel, of `side` points, and `below` above the lower edge. Returns how high it is.
pub fn loading(ui: &Ui, session: &mut Session, side: f32, below: f32) -> f32 {
    let Some(loading) = &session.loading else { return 0.0 };
    let text = match loading.seconds_left {
        Some(seconds) if seconds >= 1.0 => tr!("messages.left", work = loading.work, seconds = format!("{seconds:.0}")),
        _ => loading.work.clone(),
    };
    let (source, share) = (loading.source.clone(), loading.share);
    let mut is_cancelled = false;
    let height = super::under_way(ui, tr!("messages.opening"), side, below, |ui| {
        ui.label(source);
        match share {
            Some(share) => ui.add(ProgressBar::new(share).desired_width(260.0).text(text)),
            None => ui.horizontal(|ui| (ui.spinner(), ui.label(text)).1).inner,
        };
        is_cancelled = super::stop_button(ui, tr!("messages.stop"));
    });
    if is_cancelled {
        session.act(Action::Cancel, None);
    }
    height
}

/// Lines for people, in what the side panel leaves of the width.
pub fn messages(ui: &Ui, session: &mut Session, side: f32, below: f32) {
    if !session.has_messages() {
        return;
    }
    let widest = WIDEST_MESSAGE.min(ui.ctx().content_rect().width() - side - 2.0 * MARGIN);
    let lines: Vec<(String, bool)> =
        session.messages().map(|message| (message.text.clone(), message.is_error)).collect();
    // Their time may be over; an area without lines would keep its width of none for the next.
    if lines.is_empty() {
        return;
    }
    let area = egui::Area::new("messages".into())
        .anchor(Align2::LEFT_BOTTOM, [MARGIN, -MARGIN - below])
        .interactable(false)
        .default_width(widest)
        .show(ui.ctx(), |ui| {
            for (text, is_error) in lines {
                egui::Frame::popup(ui.style()).show(ui, |ui| {
                    // The area is as wide as the last line was: a longer one is not to be wrapped for that.
                    ui.set_max_width(widest);
                    let text = RichText::new(text);
                    ui.label(if is_error { text.color(super::look::error_color(ui)) } else { text });
                });
            }
        });
    // An area is placed by the size that it had before: with another line its place is right in the next frame only.
    let bottom = ui.ctx().content_rect().bottom() - MARGIN - below;
    if (area.response.rect.bottom() - bottom).abs() > 0.5 {
        ui.ctx().request_repaint();
    }
}
