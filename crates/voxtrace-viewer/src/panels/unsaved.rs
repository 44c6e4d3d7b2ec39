//! The questions about edits: what becomes of those that no file holds, and of those that a window left behind.

use crate::session::{Leaving, Session};
use egui::{Align2, Ui};
use std::time::SystemTime;

/// Shows whichever question is open.
pub fn show(ui: &Ui, session: &mut Session, side: f32) {
    leaving(ui, session, side);
    left_behind(ui, session, side);
}

fn leaving(ui: &Ui, session: &mut Session, side: f32) {
    let Some(leaving) = session.leaving.clone().filter(|_| session.dialog.is_none() && session.saving_scene.is_none())
    else {
        return;
    };
    let name = session.open.as_ref().map_or(String::new(), |open| open.original.name.clone());
    let (discard, next) = match &leaving {
        Leaving::Quit => ("Close without saving", "closing the window".to_owned()),
        Leaving::New(_) => ("Begin without saving", "beginning a new scene".to_owned()),
        Leaving::Load(source) => ("Open without saving", format!("opening {source}")),
    };
    egui::Window::new("Edits are not saved")
        .anchor(Align2::CENTER_CENTER, [-side / 2.0, 0.0])
        .collapsible(false)
        .resizable(false)
        .show(ui.ctx(), |ui| {
            ui.label(format!("{name} has edits that no file holds; {next} would lose them."));
            ui.horizontal(|ui| {
                if ui.button("Save").clicked() {
                    session.save_and_leave();
                }
                if ui.button(discard).clicked() {
                    session.discard_and_leave();
                }
                if ui.button("Cancel").clicked() {
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
            0..120 => format!(", {minutes} minutes ago"),
            120..2880 => format!(", {} hours ago", minutes / 60),
            _ => format!(", {} days ago", minutes / 1440),
        }
    });
    egui::Window::new("Edits that were not saved")
        .anchor(Align2::CENTER_CENTER, [-side / 2.0, 0.0])
        .collapsible(false)
        .resizable(false)
        .show(ui.ctx(), |ui| {
            ui.label(format!("A window ended before its edits of {} were saved{since}.", left.note.name));
            ui.label(format!("They were made on {}.", left.note.source));
            ui.horizontal(|ui| {
                if ui.button("Open them").clicked() {
                    session.left_behind.remove(0);
                    session.recover(left.clone());
                }
                if ui.button("Delete them").clicked() {
                    session.left_behind.remove(0).discard();
                }
                if ui.button("Later").on_hover_text("they are offered at the next start").clicked() {
                    session.left_behind.clear();
                }
            });
        });
}
