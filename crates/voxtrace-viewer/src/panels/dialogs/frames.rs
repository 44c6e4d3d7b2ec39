//! The dialog that renders a turntable or a flight.

use super::{Click, Status, buttons, estimate, path, quality};
use crate::dialogs::{FramesDialog, Route};
use crate::export::Existing;
use crate::session::Session;
use crate::tr;
use egui::{DragValue, RichText, TextEdit, Ui};

pub fn show(ui: &mut Ui, session: &mut Session, dialog: &mut FramesDialog, status: &Status) -> Option<Click> {
    for route in Route::ALL {
        if ui.radio_value(&mut dialog.route, route, route.name()).changed() {
            dialog.refresh(session);
        }
    }
    let clicked = path::show(ui, tr!("dialogs.folder"), &mut dialog.folder, false);
    ui.horizontal_wrapped(|ui| {
        let label = ui.label(tr!("dialogs_frames.name"));
        ui.add(TextEdit::singleline(&mut dialog.name).desired_width(160.0)).labelled_by(label.id);
        ui.label(RichText::new(tr!("dialogs_frames.name_and_on", name = dialog.name)).weak());
    });
    ui.horizontal_wrapped(|ui| {
        let label = ui.label(tr!("dialogs_frames.seconds"));
        ui.add(DragValue::new(&mut dialog.seconds).range(0.1..=3600.0).speed(0.1)).labelled_by(label.id);
        let label = ui.label(tr!("dialogs_frames.frames_a_second"));
        ui.add(DragValue::new(&mut dialog.rate).range(1..=240)).labelled_by(label.id);
        ui.label(tr!("dialogs_frames.frames", frames = dialog.frames()));
    });
    quality(ui, session, &mut dialog.quality);
    let there = dialog.there();
    if there > 0 {
        ui.horizontal_wrapped(|ui| {
            ui.label(tr!("dialogs.frames_there", there = there));
            ui.radio_value(&mut dialog.existing, Existing::Keep, tr!("dialogs_frames.keep_them_render_the_others"));
            ui.radio_value(&mut dialog.existing, Existing::Replace, tr!("dialogs_frames.write_over_them"));
        });
    }
    estimate(ui, session, &dialog.quality, status, dialog.frames() as usize);
    let busy = session.busy_for_export().map(str::to_owned);
    let missing = busy.or_else(|| dialog.check(session).err());
    let ffmpeg = dialog.ffmpeg();
    let (mut is_command, mut is_ffmpeg) = (false, false);
    ui.horizontal_wrapped(|ui| {
        ui.label(RichText::new(tr!("dialogs_frames.then_a_film")).weak());
        is_ffmpeg = ui.button(tr!("dialogs_frames.copy_ffmpeg")).on_hover_text(&ffmpeg).clicked();
    });
    ui.add(egui::Label::new(RichText::new(&ffmpeg).monospace().small()).truncate());
    let pressed = buttons(ui, tr!("dialogs.render"), missing.as_deref(), |ui| {
        is_command = ui.button(tr!("dialogs_frames.copy_its_command")).clicked()
    });
    if is_command {
        match dialog.settle(session) {
            Ok(()) => session.copy_command_of(dialog.command(session), tr!("dialogs_frames.copied")),
            Err(error) => session.say(error, true),
        }
    }
    if is_ffmpeg {
        session.copy(ffmpeg, tr!("dialogs_frames.ffmpeg_copied"));
    }
    pressed.or(clicked)
}
