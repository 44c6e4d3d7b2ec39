//! What stands where no scene is open: what can be opened.

use super::in_sight;
use super::status::Status;
use crate::keys::Action;
use crate::session::{Command, Session};
use crate::thumbnails::thumbnail;
use crate::tr;
use egui::{Align2, Button, RichText, Ui};

/// Points of a scene's button: a thumbnail and the longest name.
const WIDEST_NAME: f32 = 216.0;

pub fn welcome(ui: &Ui, session: &mut Session, status: &Status, side: f32) {
    // In the middle of what the side panel leaves.
    egui::Window::new("voxtrace")
        .anchor(Align2::CENTER_CENTER, [-side / 2.0, 0.0])
        .collapsible(false)
        .resizable(false)
        .default_height(ui.ctx().content_rect().height())
        .show(ui.ctx(), |ui| in_sight(ui, |ui| opened(ui, session, status)));
}

/// What can be opened.
fn opened(ui: &mut Ui, session: &mut Session, status: &Status) {
    ui.label(tr!("welcome.drop_a_file_here_or"));
    ui.add_space(6.0);
    for (name, about) in &status.built_in {
        ui.horizontal(|ui| {
            let button = match thumbnail(ui.ctx(), name) {
                Some(picture) => Button::image_and_text(&picture, name),
                None => Button::new(name),
            };
            // All as wide as the one with the longest name.
            if ui.add(button.min_size(egui::vec2(WIDEST_NAME, 0.0))).clicked() {
                session.ask(Command::Load(name.clone()));
            }
            ui.label(RichText::new(about).weak());
        });
    }
    ui.add_space(6.0);
    ui.horizontal(|ui| {
        if ui.button(tr!("welcome.open_a_file")).clicked() {
            session.act(Action::Open, None);
        }
        if ui.button(tr!("scene.new")).clicked() {
            session.act(Action::New, None);
        }
        if ui.button(tr!("welcome.by_its_path")).clicked() {
            session.act(Action::OpenByPath, None);
        }
    });
    if !status.recent.is_empty() {
        ui.separator();
        ui.label(tr!("welcome.opened_last"));
        for path in &status.recent {
            if ui.link(path).clicked() {
                session.ask(Command::Load(path.clone()));
            }
        }
    }
}
