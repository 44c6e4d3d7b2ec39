//! The dialog that plays a benchmark plan.

use super::{Click, buttons, path};
use crate::dialogs::PlanDialog;
use crate::session::Session;
use crate::tr;
use egui::{RichText, Ui};

pub fn show(ui: &mut Ui, session: &mut Session, dialog: &mut PlanDialog) -> Option<Click> {
    let clicked = path::show(ui, tr!("dialogs_plan.plan"), &mut dialog.plan, true);
    dialog.name_folder();
    ui.horizontal_wrapped(|ui| {
        let label = ui.label(tr!("dialogs_plan.report"));
        ui.add(egui::TextEdit::singleline(&mut dialog.folder.text).desired_width(420.0)).labelled_by(label.id);
    });
    ui.checkbox(&mut dialog.quick, tr!("dialogs_plan.quick"));
    ui.label(RichText::new(tr!("dialogs_plan.about")).weak());
    let busy = session.busy_for_command().map(str::to_owned);
    let missing = busy.or_else(|| dialog.request().err());
    let mut is_copied = false;
    let pressed = buttons(ui, tr!("dialogs.play"), missing.as_deref(), |ui| {
        is_copied = ui.button(tr!("dialogs.copy_its_command")).clicked()
    });
    if is_copied && let Ok(request) = dialog.request() {
        let words: Vec<String> = request.words.iter().map(|word| crate::render_command::quoted(word)).collect();
        session.copy(words.join(" "), tr!("dialogs_plan.copied"));
    }
    pressed.or(clicked)
}
