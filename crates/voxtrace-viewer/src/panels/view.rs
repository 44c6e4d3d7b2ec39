//! The panel of the camera.

use super::heading;
use crate::keys::Action;
use crate::navigation::{Mode, Motion};
use crate::session::Session;
use egui::{Button, ComboBox, Ui};

pub fn view(ui: &mut Ui, session: &mut Session) {
    heading(ui, "View");
    let cameras: Vec<voxtrace::Camera> =
        session.open.as_ref().map(|open| open.original.cameras.clone()).unwrap_or_default();
    if !cameras.is_empty() {
        let here = session.navigator.camera().name.clone();
        ComboBox::from_label("camera").selected_text(here.as_str()).show_ui(ui, |ui| {
            for camera in &cameras {
                if ui.selectable_label(camera.name == here, &camera.name).clicked() {
                    session.move_by(Motion::GoTo(camera.clone()));
                }
            }
        });
    }
    ui.horizontal_wrapped(|ui| {
        ui.selectable_value(&mut session.navigator.mode, Mode::Orbit, "orbit");
        ui.selectable_value(&mut session.navigator.mode, Mode::Fly, "fly");
        if ui.add_enabled(session.open.is_some(), Button::new("show all")).clicked() {
            session.act(Action::FrameAll, None);
        }
        if ui.add_enabled(session.navigator.can_undo(), Button::new("back")).clicked() {
            session.act(Action::UndoCamera, None);
        }
        if ui.add_enabled(session.navigator.can_redo(), Button::new("forward")).clicked() {
            session.act(Action::RedoCamera, None);
        }
    });
}
