//! What somebody changes about the scene that is shown: materials, and which parts are seen. The command that renders the picture says
//! all of it.

use crate::editing::{Editing, Steps};
use crate::scale::Scale;
use crate::session::{Command, Session};
use crate::tr;
use voxtrace::changes::MaterialChange;
use voxtrace::packed::PackedMaterial;

impl Session {
    /// A material as it is now.
    pub fn material(&self, number: usize) -> Option<PackedMaterial> {
        let mut material = self.open.as_ref()?.alone.materials().get(number).copied()?;
        if let Some(editing) = &self.editing {
            // Those that are on their way.
            let changes = [&editing.materials_sent, &editing.materials].into_iter().filter_map(|own| own.get(&number));
            for change in changes {
                material.base_color = change.base_color;
                material.emission = change.emission.unwrap_or(material.emission);
            }
        }
        Some(material)
    }

    /// Changes a material.
    pub fn set_material(&mut self, change: MaterialChange) {
        if self.is_edited_by_now() {
            return self.edit_material(change);
        }
        let Some(open) = &mut self.open else { return };
        let original = open.original.materials().get(change.number);
        let is_same = |original: &PackedMaterial| {
            original.base_color == change.base_color && change.emission.is_none_or(|own| own == original.emission)
        };
        match original.is_some_and(is_same) {
            true => _ = open.materials.remove(&change.number),
            false => _ = open.materials.insert(change.number, change),
        }
        self.update_scene();
    }

    /// Makes a material what it was.
    pub fn reset_material(&mut self, number: usize) {
        let Some(open) = &mut self.open else { return };
        if open.materials.remove(&number).is_some() {
            self.update_scene();
        }
    }

    /// Shows objects or hides them. What the file hides is read when it is to be seen.
    pub fn set_visible(&mut self, objects: &[usize], is_visible: bool) {
        let Some(open) = &mut self.open else { return };
        for &object in objects {
            if let Some(own) = open.is_visible.get_mut(object) {
                *own = is_visible;
            }
        }
        match open.lacks_objects() {
            true if self.editing.as_ref().is_some_and(Editing::has_edits_beside_file) => {
                open.hide_unread();
                self.say(tr!("edit.show_first"), true);
            }
            true => self.ask(Command::LoadAgain),
            false => self.update_scene(),
        }
    }

    /// Whether the scene is another one than the one that was read, so that the thread that owns it has to change its materials. One that has no
    /// edits yet is begun with anew.
    fn is_edited_by_now(&mut self) -> bool {
        let has_edits = self.editing.as_ref().is_some_and(|editing| {
            editing.has_edits() || !editing.steps.undone.is_empty() || !editing.materials_sent.is_empty()
        });
        if !has_edits {
            self.restart_editing();
        }
        has_edits
    }

    /// Whether the scene has edits that would be lost if its file were read again; says so.
    pub(crate) fn refuses_to_read_again(&mut self) -> bool {
        let refuses = self.editing.as_ref().is_some_and(Editing::has_edits_beside_file);
        if refuses {
            self.say(tr!("edit.not_read_again"), true);
        }
        refuses
    }

    /// Where nothing was edited yet, editing begins anew with the scene as it is changed.
    fn restart_editing(&mut self) {
        if let Some(editing) = &mut self.editing {
            (editing.editor, editing.is_ready, editing.stroke) = (None, false, None);
            (editing.before, editing.steps, editing.recovered) = (None, Steps::default(), None);
            editing.has_failed = false;
            editing.pending.clear();
            // Steps are counted anew: none of them is the one that a file holds.
            let files = [&mut editing.saved, &mut editing.saving];
            for saved in files.into_iter().flatten().filter(|saved| saved.state != (0, 0)) {
                saved.state = (u64::MAX, u64::MAX);
            }
            self.ask(Command::Edit);
        }
    }

    /// Traces the scene as it is changed now.
    fn update_scene(&mut self) {
        let has_lines = !self.render_settings.drawn_lines().is_none();
        let Some(open) = &mut self.open else { return };
        match open.update(has_lines) {
            Ok(()) => self.change_surroundings(),
            Err(error) => self.say(error.to_string(), true),
        }
    }

    /// Lines end where an instance does: with the first of them, instances that were merged come apart, and after the last they are merged again.
    pub(crate) fn keep_apart_for_lines(&mut self, had_lines: bool) {
        let has_lines = !self.render_settings.drawn_lines().is_none();
        if has_lines != had_lines && self.open.as_ref().is_some_and(|open| open.original.is_merged()) {
            self.update_scene();
        }
    }

    /// Other points may lie elsewhere in the scene, and in voxels of another size: the camera goes with the map.
    fn stay_on_map(&mut self, scene: &voxtrace::PackedScene) {
        let Some(open) = &self.open else { return };
        let (old, new) = (Scale::of(&open.original), Scale::of(scene));
        if old == new {
            return;
        }
        let new_from_old = new.world_from_other(&old);
        let scale = Scale::times_as_long(&new_from_old);
        let moved = |point: voxtrace::glam::Vec3| new_from_old.transform_point3(point.as_dvec3()).as_vec3();
        let camera = self.navigator.camera().clone();
        let (eye, target, lens) = (moved(camera.eye), moved(camera.target), camera.lens.scaled(scale));
        let camera = voxtrace::Camera { eye, target, lens, ..camera };
        self.navigator = self.navigator.in_scene(camera, scene.bounds());
        self.ask(Command::SetView);
    }

    /// Takes the scene that was read again with parts that its file hides; the view stays.
    pub fn show_again(&mut self, scene: std::sync::Arc<voxtrace::PackedScene>) {
        // Nothing was edited: what has edits is not read again.
        self.restart_editing();
        self.stay_on_map(&scene);
        self.measure_in(&scene);
        self.open = self.open.take().map(|open| open.read_again(scene));
        self.picked = None;
        self.update_scene();
    }
}
