//! The dialog that records the timeline.

use super::{Click, Status, buttons, estimate, path, quality};
use crate::dialogs::{RecordDialog, RecordKind};
use crate::session::Session;
use egui::{RichText, Ui};

pub fn show(ui: &mut Ui, session: &mut Session, dialog: &mut RecordDialog, status: &Status) -> Option<Click> {
    let clicked = path::show(ui, "file", &mut dialog.path, false);
    let kind = dialog.kind();
    ui.horizontal(|ui| {
        for own in RecordKind::ALL {
            if ui.radio(kind == Some(own), own.name()).clicked() {
                dialog.set_kind(own);
            }
        }
    });
    quality(ui, session, &mut dialog.quality);
    let course = &session.timeline.course;
    let frames = course.frames();
    let text = format!("{frames} frames, {} a second, {:.2} s", course.fps, course.seconds);
    ui.label(RichText::new(text).weak());
    let there = dialog.there(frames);
    if there > 0 {
        ui.horizontal(|ui| {
            if kind.is_some_and(RecordKind::is_frames) {
                ui.label(format!("{there} frames are there:"));
                if ui.radio(dialog.keeps, "keep them, render the others").clicked() {
                    (dialog.keeps, dialog.replaces) = (true, false);
                }
                if ui.radio(dialog.replaces, "write over them").clicked() {
                    (dialog.keeps, dialog.replaces) = (false, true);
                }
            } else {
                ui.checkbox(&mut dialog.replaces, "write over the file that is there");
            }
        });
    }
    estimate(ui, session, &dialog.quality, status, frames as usize);
    let missing = match session.running.is_some() || session.exporting.is_some() {
        true => Some("something else is being made".to_owned()),
        false => dialog.check(session).err(),
    };
    let mut is_copied = false;
    let pressed = buttons(ui, "Record", missing.as_deref(), |ui| is_copied = ui.button("Copy its command").clicked());
    if is_copied && let Some(file) = session.save_timeline() {
        session.copy_command_of(dialog.command(session, file), "the command that records the timeline");
    }
    pressed.or(clicked)
}
