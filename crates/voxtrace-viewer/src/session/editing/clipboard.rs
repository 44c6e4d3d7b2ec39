//! What is selected, copied and put down.

use crate::editing::{Act, Job, Pasting, Selection, Spot};
use crate::panels::{Noun, counted};
use crate::session::Session;
use crate::tr;
use std::sync::Arc;
use voxtrace::dynamic::{Clip, Edit};
use voxtrace::grid::VoxelBox;
use voxtrace::{Axis, Shape};

impl Session {
    fn selection(&mut self) -> Option<Selection> {
        let selection = self.editing.as_ref()?.selection;
        if selection.is_none() {
            self.say(tr!("edit.nothing_selected"), false);
        }
        selection
    }

    /// Copies what is selected, or takes it to be moved.
    pub fn copy_selection(&mut self, is_move: bool) {
        if let Some(Selection { grid, region, .. }) = self.selection() {
            self.send_job(Job::Copy { grid, region, is_move });
        }
    }

    /// Takes what was copied.
    pub(super) fn take_copied(&mut self, clip: Arc<Clip>, count: u64, from: Option<(u32, VoxelBox)>) {
        let Some(editing) = &mut self.editing else { return };
        editing.clip = Some(Arc::clone(&clip));
        match from {
            Some(_) => editing.pasting = Some(Pasting { clip, from }),
            None => self.say(tr!("edit.copied", what = counted(count, Noun::Voxel)), false),
        }
    }

    /// Takes what was turned.
    pub(super) fn take_turned(&mut self, clip: Arc<Clip>) {
        let Some(editing) = &mut self.editing else { return };
        editing.clip = Some(Arc::clone(&clip));
        if let Some(pasting) = &mut editing.pasting {
            pasting.clip = clip;
        }
    }

    /// Empties what is selected.
    pub fn clear_selection(&mut self, name: &'static str) {
        if let Some(Selection { grid, region, .. }) = self.selection() {
            let edits = vec![Act::Erase.edit(Shape::Box(region), 0)];
            self.send_job(Job::Edit { grid, edits, name, joins: false });
        }
    }

    /// Makes all of what is selected of the current material: empty voxels, too.
    pub fn fill_selection(&mut self) {
        let Some(Selection { grid, region, .. }) = self.selection() else { return };
        let Some(editing) = &self.editing else { return };
        let edits = vec![Edit::Fill { shape: Shape::Box(region), material: Some(editing.material) }];
        self.send_job(Job::Edit { grid, edits, name: tr!("edit.fill_box"), joins: false });
    }

    /// What was copied last is under the cursor, to be put down.
    pub fn paste(&mut self) {
        let Some(editing) = &mut self.editing else { return };
        match editing.clip.clone() {
            Some(clip) => editing.pasting = Some(Pasting { clip, from: None }),
            None => self.say(tr!("edit.nothing_copied"), false),
        }
    }

    pub(super) fn end_pasting(&mut self) {
        if let Some(editing) = &mut self.editing {
            editing.pasting = None;
        }
    }

    /// Turns what is to be put down by a quarter.
    pub fn turn_pasting(&mut self, axis: Axis) {
        self.change_pasting(axis, false);
    }

    /// Mirrors it.
    pub fn mirror_pasting(&mut self, axis: Axis) {
        self.change_pasting(axis, true);
    }

    fn change_pasting(&mut self, axis: Axis, is_mirror: bool) {
        match self.editing.as_ref().is_some_and(|editing| editing.pasting.is_some()) {
            true => self.send_job(Job::Turn { axis, is_mirror }),
            false => self.say(tr!("edit.nothing_pasted"), false),
        }
    }

    /// Puts down what is pasted or moved, on the face under the cursor.
    pub(super) fn put_down(&mut self, spot: &Spot) {
        let Some(editing) = &mut self.editing else { return };
        let Some(Pasting { clip, from }) = editing.pasting.clone() else { return };
        let at = spot.paste_corner(clip.size());
        let put = Edit::Paste { clip: Arc::clone(&clip), at, with_empty: false };
        let (edits, name) = match from {
            Some((grid, _)) if grid != spot.grid => {
                return self.say(tr!("edit.stays_in_model"), false);
            }
            Some((_, region)) => (vec![Act::Erase.edit(Shape::Box(region), 0), put], tr!("edit.move")),
            None => (vec![put], tr!("edit.paste")),
        };
        if from.is_some() {
            editing.pasting = None;
            let region = VoxelBox { min: at, max: at + clip.size() };
            let Spot { instance, grid, world_from_grid, .. } = *spot;
            editing.selection = Some(Selection { instance, grid, world_from_grid, region });
        }
        self.send_job(Job::Edit { grid: spot.grid, edits, name, joins: false });
    }
}
