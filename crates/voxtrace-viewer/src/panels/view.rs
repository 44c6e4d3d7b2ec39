//! The panel of the camera.

use super::{heading, slider};
use crate::keys::Action;
use crate::navigation::{Mode, Motion};
use crate::scale::{Quantity, Scale};
use crate::session::Session;
use crate::tr;
use egui::{Button, ComboBox, Ui};

pub fn view(ui: &mut Ui, session: &mut Session) {
    heading(ui, tr!("view.view"));
    let cameras: Vec<voxtrace::Camera> =
        session.open.as_ref().map(|open| open.original.cameras.clone()).unwrap_or_default();
    if !cameras.is_empty() {
        let here = session.navigator.camera().name.clone();
        let is_known = cameras.iter().any(|camera| camera.name == here);
        // A timeline's, or one that was read from elsewhere.
        let shown = if is_known { here.as_str() } else { tr!("view.another") };
        ComboBox::from_label(tr!("view.camera")).selected_text(shown).show_ui(ui, |ui| {
            for camera in &cameras {
                if ui.selectable_label(camera.name == here, &camera.name).clicked() {
                    session.move_by(Motion::GoTo(camera.clone()));
                }
            }
        });
    }
    ui.horizontal_wrapped(|ui| {
        let modes = [
            (Mode::Orbit, tr!("walk.mode_orbit")),
            (Mode::Fly, tr!("walk.mode_fly")),
            (Mode::Walk, tr!("walk.mode_walk")),
        ];
        for (mode, name) in modes {
            if ui.selectable_label(session.navigator.mode == mode, name).clicked() {
                session.set_mode(mode);
            }
        }
        if ui.add_enabled(session.open.is_some(), Button::new(tr!("view.show_all"))).clicked() {
            session.act(Action::FrameAll, None);
        }
        if ui.add_enabled(session.navigator.can_undo(), Button::new(tr!("view.back"))).clicked() {
            session.act(Action::UndoCamera, None);
        }
        if ui.add_enabled(session.navigator.can_redo(), Button::new(tr!("view.forward"))).clicked() {
            session.act(Action::RedoCamera, None);
        }
    });
    if session.navigator.mode == Mode::Walk {
        eye_height(ui, session);
    }
}

/// How tall somebody is who walks, in the unit of the scene.
fn eye_height(ui: &mut Ui, session: &mut Session) {
    let Some(scale) = session.open.as_ref().map(|open| Scale::of(&open.original)) else { return };
    let one = scale.in_units(Quantity::Length, 1.0);
    let most = f64::from(session.navigator.diagonal()) * one;
    let unit = if scale.symbol().is_empty() { tr!("walk.voxels") } else { scale.symbol() };
    let mut height = session.navigator.walker.eye_height * one;
    let name = tr!("walk.eye_height", unit = unit);
    if ui.add(slider(&mut height, one..=most.max(2.0 * one), &name).logarithmic(true).max_decimals(2)).changed() {
        session.navigator.walker.eye_height = height / one;
        session.move_by(Motion::Level);
    }
}
