//! The panel of the scene: what is open, and what can be done with it.

use super::{counted, heading};
use crate::keys::Action;
use crate::session::Session;
use egui::{Button, Ui};

pub fn scene(ui: &mut Ui, session: &mut Session) {
    heading(ui, "Scene");
    if let Some(open) = &session.open {
        ui.label(&open.original.name);
        let voxels = open.voxels;
        let objects = open.original.instance_count();
        ui.label(format!("{}, {}", counted(voxels, "voxel"), counted(objects as u64, "object")));
    }
    ui.horizontal_wrapped(|ui| {
        if ui.button("Open…").clicked() {
            session.act(Action::Open, None);
        }
        let has_scene = session.open.is_some();
        if ui.add_enabled(has_scene, Button::new("Picture to file")).clicked() {
            session.act(Action::Screenshot, None);
        }
        if ui.add_enabled(has_scene, Button::new("Render…")).clicked() {
            session.act(Action::RenderPicture, None);
        }
        if ui.add_enabled(has_scene, Button::new("Frames…")).clicked() {
            session.act(Action::RenderFrames, None);
        }
        if ui.add_enabled(has_scene, Button::new("Save scene…")).clicked() {
            session.act(Action::SaveScene, None);
        }
        if ui.add_enabled(has_scene, Button::new("Copy command")).clicked() {
            session.act(Action::CopyCommand, None);
        }
        if ui.button("Keys").clicked() {
            session.act(Action::Help, None);
        }
    });
}
