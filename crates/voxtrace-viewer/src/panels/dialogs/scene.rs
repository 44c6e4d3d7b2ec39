//! The dialogs that open a scene by its path, and write the one that is shown.

use super::{Click, buttons, path};
use crate::canvas::LARGEST;
use crate::dialogs::{OpenDialog, SCENE_KINDS, SaveDialog};
use crate::strings::text;
use crate::tr;
use egui::{DragValue, RichText, Ui};

pub fn show_save(ui: &mut Ui, dialog: &mut SaveDialog) -> Option<Click> {
    let clicked = path::show(ui, tr!("dialogs.file"), &mut dialog.path, false);
    let ending = dialog.ending();
    for (own, about) in SCENE_KINDS {
        ui.horizontal_wrapped(|ui| {
            if ui.radio(ending == own, format!(".{own}")).clicked() {
                dialog.set_ending(own);
            }
            ui.label(RichText::new(text(about)).weak());
        });
    }
    if dialog.is_there() {
        ui.checkbox(&mut dialog.replaces, tr!("dialogs_scene.write_over_the_file_that"));
    }
    let missing = dialog.request().err();
    buttons(ui, tr!("dialogs.write"), missing.as_deref(), |_| {}).or(clicked)
}

pub fn show_new(ui: &mut Ui, size: &mut [u32; 3]) -> Option<Click> {
    ui.label(tr!("dialogs_new.about"));
    ui.horizontal_wrapped(|ui| {
        for (name, side) in ["x", "y", "z"].into_iter().zip(size) {
            let label = ui.label(name);
            ui.add(DragValue::new(side).range(1..=LARGEST)).labelled_by(label.id);
        }
    });
    let is_confirmed = ui.input(|input| input.key_pressed(egui::Key::Enter));
    buttons(ui, tr!("dialogs_new.begin"), None, |_| {}).or(is_confirmed.then_some(Click::Go))
}

pub fn show_open(ui: &mut Ui, dialog: &mut OpenDialog) -> Option<Click> {
    let clicked = path::show(ui, tr!("dialogs.path"), &mut dialog.path, true);
    let missing = dialog.request().err();
    buttons(ui, tr!("dialogs.do_open"), missing.as_deref(), |_| {}).or(clicked)
}
