//! The dialog that renders a picture.

use super::{Click, Status, buttons, estimate, path, quality};
use crate::dialogs::{PictureDialog, PictureKind};
use crate::session::Session;
use crate::tr;
use egui::Ui;

pub fn show(ui: &mut Ui, session: &mut Session, dialog: &mut PictureDialog, status: &Status) -> Option<Click> {
    let clicked = path::show(ui, tr!("dialogs.file"), &mut dialog.path, false);
    dialog.take_kind_of_path();
    let kind = dialog.kind();
    ui.horizontal_wrapped(|ui| {
        for own in PictureKind::ALL {
            if ui.radio(kind == Some(own), own.name()).clicked() {
                dialog.set_kind(own);
            }
        }
        ui.checkbox(&mut dialog.sixteen_bits, tr!("dialogs_picture.16_bits_a_channel"));
    });
    if kind == Some(PictureKind::Exr) {
        ui.checkbox(&mut dialog.aovs, tr!("dialogs_picture.also_albedo_normal_depth_instance"));
    }
    quality(ui, session, &mut dialog.quality);
    if dialog.is_there() {
        ui.checkbox(&mut dialog.replaces, tr!("dialogs_picture.write_over_the_file_that"));
    }
    estimate(ui, session, &dialog.quality, status, 1);
    let busy = session.busy_for_export().map(str::to_owned);
    let missing = busy.or_else(|| dialog.check(session).err());
    let mut is_copied = false;
    let pressed = buttons(ui, tr!("dialogs.render"), missing.as_deref(), |ui| {
        is_copied = ui.button(tr!("dialogs_picture.copy_its_command")).clicked()
    });
    if is_copied {
        session.copy_command_of(dialog.command(session), tr!("dialogs_picture.copied"));
    }
    pressed.or(clicked)
}
