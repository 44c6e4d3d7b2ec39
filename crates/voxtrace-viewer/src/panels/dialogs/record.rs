//! The dialog that records the timeline.

use super::{Click, Status, buttons, estimate, path, quality};
use crate::dialogs::{RecordDialog, RecordKind};
use crate::session::Session;
use crate::tr;
use egui::{RichText, Ui};

pub fn show(ui: &mut Ui, session: &mut Session, dialog: &mut RecordDialog, status: &Status) -> Option<Click> {
    let clicked = path::show(ui, tr!("dialogs.file"), &mut dialog.path, false);
    let kind = dialog.kind();
    ui.horizontal_wrapped(|ui| {
        for own in RecordKind::ALL {
            if ui.radio(kind == Some(own), own.name()).clicked() {
                dialog.set_kind(own);
            }
        }
    });
    quality(ui, session, &mut dialog.quality);
    let course = &session.timeline.course;
    let frames = course.frames();
    let text =
        tr!("dialogs_record.length", frames = frames, fps = course.fps, seconds = format!("{:.2}", course.seconds));
    ui.label(RichText::new(text).weak());
    let there = dialog.there(frames);
    if there > 0 {
        ui.horizontal_wrapped(|ui| {
            if kind.is_some_and(RecordKind::is_frames) {
                ui.label(tr!("dialogs.frames_there", there = there));
                if ui.radio(dialog.keeps, tr!("dialogs_record.keep")).clicked() {
                    (dialog.keeps, dialog.replaces) = (true, false);
                }
                if ui.radio(dialog.replaces, tr!("dialogs_record.over")).clicked() {
                    (dialog.keeps, dialog.replaces) = (false, true);
                }
            } else {
                ui.checkbox(&mut dialog.replaces, tr!("dialogs_record.over_file"));
            }
        });
    }
    estimate(ui, session, &dialog.quality, status, frames as usize);
    let busy = session.busy_for_command().map(str::to_owned);
    let missing = busy.or_else(|| dialog.check(session).err());
    let mut is_copied = false;
    let pressed = buttons(ui, tr!("dialogs.do_record"), missing.as_deref(), |ui| {
        is_copied = ui.button(tr!("dialogs.copy_its_command")).clicked()
    });
    if is_copied && let Some(file) = session.save_timeline() {
        session.copy_command_of(dialog.command(session, file), tr!("dialogs_record.copied"));
    }
    pressed.or(clicked)
}
