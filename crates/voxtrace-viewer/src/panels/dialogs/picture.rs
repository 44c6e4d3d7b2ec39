//! The dialog that renders a picture.

use super::{Click, Status, buttons, estimate, path, quality};
use crate::dialogs::{PictureDialog, PictureKind};
use crate::session::Session;
use egui::Ui;

pub fn show(ui: &mut Ui, session: &mut Session, dialog: &mut PictureDialog, status: &Status) -> Option<Click> {
    let clicked = path::show(ui, "file", &mut dialog.path, false);
    dialog.take_kind_of_path();
    let kind = dialog.kind();
    ui.horizontal(|ui| {
        for own in PictureKind::ALL {
            if ui.radio(kind == Some(own), own.name()).clicked() {
                dialog.set_kind(own);
            }
        }
        ui.checkbox(&mut dialog.sixteen_bits, "16 bits a channel");
    });
    if kind == Some(PictureKind::Exr) {
        ui.checkbox(&mut dialog.aovs, "also albedo, normal, depth, instance and voxel");
    }
    quality(ui, session, &mut dialog.quality);
    if dialog.is_there() {
        ui.checkbox(&mut dialog.replaces, "write over the file that is there");
    }
    estimate(ui, session, &dialog.quality, status, 1);
    let missing = match session.exporting {
        Some(_) => Err("another picture is being rendered".into()),
        None => dialog.check(session),
    };
    let missing = missing.err();
    let mut is_copied = false;
    let pressed = buttons(ui, "Render", missing.as_deref(), |ui| is_copied = ui.button("Copy its command").clicked());
    if is_copied {
        session.copy_command_of(dialog.command(session), "the command that renders this file");
    }
    pressed.or(clicked)
}
