//! The dialog that plays a benchmark plan.

use super::{Click, buttons, path};
use crate::dialogs::PlanDialog;
use crate::session::Session;
use egui::{RichText, Ui};

pub fn show(ui: &mut Ui, session: &mut Session, dialog: &mut PlanDialog) -> Option<Click> {
    let clicked = path::show(ui, "plan", &mut dialog.plan, true);
    dialog.name_folder();
    ui.horizontal(|ui| {
        let label = ui.label("report");
        ui.add(egui::TextEdit::singleline(&mut dialog.folder.text).desired_width(420.0)).labelled_by(label.id);
    });
    ui.checkbox(&mut dialog.quick, "quick: fewer frames of each cell, no sweep");
    ui.label(RichText::new("Nothing else is traced meanwhile; a scene of the plan is read anew.").weak());
    let missing = match session.running.is_some() {
        true => Some("something else is being made".to_owned()),
        false => dialog.request().err(),
    };
    let mut is_copied = false;
    let pressed = buttons(ui, "Play", missing.as_deref(), |ui| is_copied = ui.button("Copy its command").clicked());
    if is_copied && let Ok(request) = dialog.request() {
        let words: Vec<String> = request.words.iter().map(|word| crate::render_command::quoted(word)).collect();
        session.copy(words.join(" "), "the command that plays the plan");
    }
    pressed.or(clicked)
}
