//! The panel of the scene: what is open, and what can be done with it.

use super::{Noun, counted, heading};
use crate::keys::Action;
use crate::session::Session;
use crate::tr;
use egui::{Button, Ui};

pub fn scene(ui: &mut Ui, session: &mut Session) {
    heading(ui, tr!("scene.scene"));
    if let Some(open) = &session.open {
        ui.label(&open.original.name);
        let voxels = open.voxels;
        let objects = open.original.instance_count();
        ui.label(format!("{}, {}", counted(voxels, Noun::Voxel), counted(objects as u64, Noun::Object)));
    }
    ui.horizontal_wrapped(|ui| {
        if ui.button(tr!("scene.new")).clicked() {
            session.act(Action::New, None);
        }
        if ui.button(tr!("scene.open")).clicked() {
            session.act(Action::Open, None);
        }
        let has_scene = session.open.is_some();
        if ui.add_enabled(has_scene, Button::new(tr!("scene.picture_to_file"))).clicked() {
            session.act(Action::Screenshot, None);
        }
        if ui.add_enabled(has_scene, Button::new(tr!("scene.render"))).clicked() {
            session.act(Action::RenderPicture, None);
        }
        if ui.add_enabled(has_scene, Button::new(tr!("scene.frames"))).clicked() {
            session.act(Action::RenderFrames, None);
        }
        if ui.add_enabled(has_scene, Button::new(tr!("scene.save_scene"))).clicked() {
            session.act(Action::SaveScene, None);
        }
        if ui.add_enabled(has_scene, Button::new(tr!("scene.copy_command"))).clicked() {
            session.act(Action::CopyCommand, None);
        }
        if ui.button(tr!("scene.keys")).clicked() {
            session.act(Action::Help, None);
        }
    });
}
