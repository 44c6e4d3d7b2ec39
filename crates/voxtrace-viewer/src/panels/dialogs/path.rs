//! A field for a path with what stands in its folder.

use super::super::text_width;
use super::Click;
use crate::dialogs::{MOST_OFFERED, PathField};
use crate::tr;
use egui::text::{CCursor, CCursorRange};
use egui::{Key, RichText, ScrollArea, TextEdit, Ui};

/// Width of the field, points: at most, and at least in a small window.
const WIDTH: f32 = 420.0;
const LEAST: f32 = 80.0;
/// Points of the margins of its text.
const MARGINS: f32 = 8.0;

/// Shows the field. Enter is the dialog's own button. `lists_files` says whether files of the folder are offered, too.
pub fn show(ui: &mut Ui, name: &str, field: &mut PathField, lists_files: bool) -> Option<Click> {
    let mut clicked = None;
    ui.horizontal_wrapped(|ui| {
        let label = ui.label(name);
        // The button stands beside the field, whatever the language calls it.
        let spacing = ui.spacing();
        let gaps = 2.0 * (spacing.button_padding.x + spacing.item_spacing.x) + MARGINS;
        let left = ui.available_size_before_wrap().x - text_width(ui, tr!("dialogs_path.browse")) - gaps;
        let edit = TextEdit::singleline(&mut field.text).desired_width(left.clamp(LEAST, WIDTH));
        let edit = ui.add(edit).labelled_by(label.id);
        if !std::mem::replace(&mut field.is_settled, true) {
            edit.request_focus();
            let end = CCursorRange::one(CCursor::new(field.text.chars().count()));
            let mut state = TextEdit::load_state(ui.ctx(), edit.id).unwrap_or_default();
            state.cursor.set_char_range(Some(end));
            state.store(ui.ctx(), edit.id);
        }
        field.is_focused = edit.has_focus();
        if edit.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter)) {
            clicked = Some(Click::Go);
        }
        if ui.button(tr!("dialogs_path.browse")).clicked() {
            clicked = Some(Click::Browse);
        }
    });
    if field.is_focused || lists_files {
        offers(ui, field, lists_files);
    }
    clicked
}

/// What could follow, each a click.
fn offers(ui: &mut Ui, field: &mut PathField, lists_files: bool) {
    let offered: Vec<_> = field.offers().iter().filter(|offer| lists_files || !offer.is_file).cloned().collect();
    if offered.is_empty() {
        return;
    }
    let most = if lists_files { offered.len() } else { MOST_OFFERED };
    ScrollArea::vertical().max_height(180.0).max_width(WIDTH).show(ui, |ui| {
        for offer in offered.iter().take(most) {
            let text = if offer.is_file { RichText::new(&offer.name) } else { RichText::new(&offer.name).strong() };
            if ui.selectable_label(offer.text == field.text, text).clicked() {
                field.set(&offer.text);
            }
        }
    });
    ui.label(RichText::new(tr!("dialogs_path.tab_completes_a_path_can")).weak());
}
