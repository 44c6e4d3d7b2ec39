//! The list of keys and gestures.

use super::heading;
use crate::keys::{self, Group};
use crate::session::Session;
use crate::tr;
use egui::{Grid, RichText, ScrollArea, Ui};

/// The font of keys: the proportional one has no arrows.
const KEYS: egui::FontId = egui::FontId::monospace(11.0);
/// Points between the columns.
const BETWEEN: f32 = 16.0;

pub fn help(ui: &Ui, session: &mut Session) {
    let mut is_open = true;
    egui::Window::new(tr!("help.keys_and_gestures"))
        .open(&mut is_open)
        .default_pos([24.0, 24.0])
        .default_size([920.0, 560.0])
        .show(ui.ctx(), |ui| {
            ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
                // Two columns that wrap what does not fit: nothing lies beyond the edge of a small window.
                let column = (ui.available_width() - BETWEEN) / 2.0;
                // One grid for all groups: their columns stand one below the other.
                Grid::new("keys").striped(true).spacing([BETWEEN, 4.0]).max_col_width(column).show(ui, |ui| {
                    for group in Group::ALL {
                        heading(ui, group.name());
                        ui.end_row();
                        for row in keys::rows(group) {
                            ui.label(RichText::new(row.keys).font(KEYS).strong());
                            ui.label(row.about);
                            ui.end_row();
                        }
                    }
                });
            });
        });
    session.has_help = is_open;
}
