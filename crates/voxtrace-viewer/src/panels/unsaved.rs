//! The questions about edits and timelines: what becomes of those that no file holds, and of edits that a window left behind.

use crate::session::{Leaving, Session};
use crate::tr;
use egui::{Align2, Ui};
use std::time::SystemTime;

/// Shows whichever question is open.
pub fn show(ui: &Ui, session: &mut Session, side: f32) {
    leaving(ui, session, side);
    left_behind(ui, session, side);
}

fn leaving(ui: &Ui, session: &mut Session, side: f32) {
    let Some(leaving) =
        session.leaving.clone().filter(|_| session.dialog.is_none() && session.written_file().is_none())
    else {
        return;
    };
    let name = session.open.as_ref().map_or(String::new(), |open| open.original.name.clone());
    // Of edits and timeline it is told what took longer to make; both are saved, or lost.
    let has_edits = session.has_unsaved_edits();
    let (discard, next) = match &leaving {
        Leaving::Quit if has_edits => (tr!("unsaved.close"), tr!("unsaved.closing", name = name)),
        Leaving::New(_) if has_edits => (tr!("unsaved.begin"), tr!("unsaved.beginning", name = name)),
        Leaving::Load(source) if has_edits => {
            (tr!("unsaved.open"), tr!("unsaved.opening", name = name, source = source))
        }
        Leaving::Quit => (tr!("unsaved.close"), tr!("unsaved.timeline_closing", name = name)),
        Leaving::New(_) => (tr!("unsaved.begin"), tr!("unsaved.timeline_beginning", name = name)),
        Leaving::Load(source) => (tr!("unsaved.open"), tr!("unsaved.timeline_opening", name = name, source = source)),
    };
    let title = if has_edits { tr!("unsaved.title") } else { tr!("unsaved.timeline_title") };
    egui::Window::new(title)
        .anchor(Align2::CENTER_CENTER, [-side / 2.0, 0.0])
        .collapsible(false)
        .resizable(false)
        .show(ui.ctx(), |ui| {
            ui.label(next);
            ui.horizontal(|ui| {
                if ui.button(tr!("unsaved.save")).clicked() {
                    session.save_and_leave();
                }
                if ui.button(discard).clicked() {
                    session.discard_and_leave();
                }
                if ui.button(tr!("unsaved.cancel")).clicked() {
                    session.stay();
                }
            });
        });
}

fn left_behind(ui: &Ui, session: &mut Session, side: f32) {
    if session.left_behind.is_empty() || session.leaving.is_some() || session.dialog.is_some() {
        return;
    }
    let left = session.left_behind[0].clone();
    let since = left.written.and_then(|written| SystemTime::now().duration_since(written).ok());
    let since = since.map_or(String::new(), |since| {
        let minutes = since.as_secs() / 60;
        match minutes {
            0..120 => tr!("unsaved.minutes", minutes = minutes),
            120..2880 => tr!("unsaved.hours", hours = minutes / 60),
            _ => tr!("unsaved.days", days = minutes / 1440),
        }
    });
    egui::Window::new(tr!("unsaved.left_title"))
        .anchor(Align2::CENTER_CENTER, [-side / 2.0, 0.0])
        .collapsible(false)
        .resizable(false)
        .show(ui.ctx(), |ui| {
            ui.label(tr!("unsaved.left_of", name = left.note.name, since = since));
            ui.label(tr!("unsaved.left_on", source = left.note.source));
            ui.horizontal(|ui| {
                if ui.button(tr!("unsaved.open_them")).clicked() {
                    session.left_behind.remove(0);
                    session.recover(left.clone());
                }
                if ui.button(tr!("unsaved.delete_them")).clicked() {
                    session.left_behind.remove(0).discard();
                }
                if ui.button(tr!("unsaved.later")).on_hover_text(tr!("unsaved.later_about")).clicked() {
                    session.left_behind.clear();
                }
            });
        });
}
