//! Editing in the window: what the hand does becomes jobs for the thread that owns the scene, and what that tells is followed.

mod clipboard;
mod gestures;
mod saving;

use super::{Command, Session};
use crate::editing::{Act, Done, Editing, Editor, Job, Spot, Symmetry, Told, Tool};
use crate::keys::{Action, EditAction};
use crate::tr;
use std::sync::Arc;
use voxtrace::changes::MaterialChange;
use voxtrace::dynamic::Patch;
use voxtrace::glam::{Vec2, Vec3};
use voxtrace::grid::VoxelBox;
use voxtrace::ray::FACES;
use voxtrace::{Material, Ray};

pub use gestures::extent;
pub use saving::Leaving;

/// A patch for what traces. Two are the same where they are one.
#[derive(Clone, Debug)]
pub struct Followed(pub Arc<Patch>);

impl PartialEq for Followed {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

impl Session {
    /// Whether the hand edits.
    pub fn is_editing(&self) -> bool {
        self.editing.as_ref().is_some_and(|editing| editing.is_on)
    }

    /// Begins to edit, or ends it: what was edited stays.
    pub fn toggle_editing(&mut self) {
        if self.open.is_none() {
            return self.say(tr!("said.there_is_no_scene_yet"), false);
        }
        match &mut self.editing {
            Some(editing) if editing.has_failed => {
                let reason = if editing.is_unsaved() { tr!("edit.fault") } else { tr!("edit.fault_saved") };
                return self.say(tr!("edit.cannot", reason = reason), true);
            }
            Some(editing) => {
                editing.is_on = !editing.is_on;
                if !editing.is_on {
                    self.end_stroke();
                }
            }
            None => {
                let material = self.picked.as_ref().map_or(0, |picked| picked.material as u16);
                self.editing = Some(Editing { material, ..Editing::default() });
                self.ask(Command::Edit);
            }
        }
        if self.is_editing() {
            (self.picked, self.has_panels) = (None, true);
        }
    }

    /// Starts the thread that owns the scene while it is edited. `wake` is called whenever it tells something.
    pub fn start_editor(&mut self, wake: Arc<dyn Fn() + Send + Sync>) {
        let (Some(open), Some(editing)) = (&self.open, &mut self.editing) else { return };
        if editing.editor.is_none() {
            let materials = open.materials.values().copied().collect();
            editing.editor = Some(match editing.begun.take() {
                Some(begun) => Editor::begun(*begun, Arc::clone(&open.original), wake),
                None => Editor::start(Arc::clone(&open.original), materials, wake),
            });
        }
    }

    /// Takes what that thread has told.
    pub fn take_edited(&mut self) {
        while let Some(told) = self.editing.as_ref().and_then(|editing| editing.editor.as_ref()?.take()) {
            match told {
                Told::Ready { base, is_same } => {
                    if !is_same {
                        self.replace_scene(base);
                    }
                    if let Some(editing) = &mut self.editing {
                        editing.is_ready = true;
                    }
                }
                Told::Failed(reason) => {
                    match self.editing.as_mut().filter(|editing| editing.is_unsaved()) {
                        // What was edited is still there to be saved.
                        Some(editing) => {
                            editing.editor = None;
                            (editing.is_on, editing.is_ready, editing.has_failed) = (false, false, true);
                        }
                        None => self.editing = None,
                    }
                    self.end_stroke();
                    self.say(tr!("edit.cannot", reason = reason), true);
                }
                Told::Done(done) => self.take_done(*done),
                Told::Copied { clip, count, grid, region, is_move } => {
                    self.take_copied(clip, count, is_move.then_some((grid, region)));
                }
                Told::Turned(clip) => self.take_turned(clip),
            }
        }
    }

    fn take_done(&mut self, done: Done) {
        if let Some(base) = done.base {
            self.settle_edits();
            match (done.is_other, &mut self.open, &mut self.editing) {
                (true, _, Some(editing)) => {
                    let had_steps = !editing.steps.done.is_empty() || !editing.steps.undone.is_empty();
                    self.replace_scene(base);
                    if had_steps {
                        self.say(tr!("edit.glow_changed"), false);
                    }
                }
                (false, Some(open), _) => open.take_base(base),
                _ => {}
            }
        }
        if let Some(editing) = &mut self.editing {
            editing.steps = done.steps;
            editing.rebased += u64::from(done.is_recolored);
        }
        if let Some(patch) = done.patch {
            // What is edited after somebody gave up the edits before is another matter.
            self.is_discarding = false;
            self.follow(patch);
        }
        if let (Some(added), Some(editing)) = (done.added, &mut self.editing) {
            editing.take_material(added);
        }
        if let (true, Some(editing)) = (done.is_recolored, &mut self.editing) {
            editing.materials_sent.clear();
            self.send_materials();
        }
        if let Some(error) = done.error {
            self.say(error, true);
        }
        self.stay_on_top_of_surroundings();
    }

    /// Shows an edited scene in the place of the one that was read, or of one with other materials.
    fn replace_scene(&mut self, base: Arc<voxtrace::PackedScene>) {
        if let Some(open) = &mut self.open {
            open.take_base(base);
            self.change_surroundings();
        }
    }

    /// Follows a patch: what traces at once, what is picked in when the stroke is over.
    fn follow(&mut self, patch: Arc<Patch>) {
        let (Some(open), Some(editing)) = (&mut self.open, &mut self.editing) else { return };
        if editing.stroke.is_some() && open.is_plain() {
            editing.pending.push(Arc::clone(&patch));
            return self.ask(Command::Follow(Followed(patch)));
        }
        if editing.stroke.is_some() && editing.before.is_none() {
            editing.before = Some(Arc::clone(&open.pickable));
        }
        self.settle_edits();
        self.follow_now(&patch);
    }

    fn follow_now(&mut self, patch: &Arc<Patch>) {
        let Some(open) = &mut self.open else { return };
        match open.follow(patch) {
            Ok(patch) if open.is_alone() => self.ask(Command::Follow(Followed(patch))),
            Ok(_) => {}
            // Both come from one thread in one order.
            Err(error) => self.say(error.to_string(), true),
        }
    }

    /// What is picked in follows the patches of the stroke.
    pub fn settle_edits(&mut self) {
        let Some(editing) = &mut self.editing else { return };
        let pending = std::mem::take(&mut editing.pending);
        let Some(open) = &mut self.open else { return };
        for patch in pending {
            if let Err(error) = open.follow(&patch) {
                return self.say(error.to_string(), true);
            }
        }
    }

    /// Ground and fog are made anew around the edited scene, when no stroke is under way.
    fn stay_on_top_of_surroundings(&mut self) {
        let is_idle = self.editing.as_ref().is_some_and(|editing| editing.stroke.is_none());
        if is_idle && self.open.as_ref().is_some_and(|open| !open.is_alone()) {
            self.change_surroundings();
        }
    }

    /// Asks for a job.
    pub(crate) fn send_job(&self, job: Job) {
        if let Some(editor) = self.editing.as_ref().and_then(|editing| editing.editor.as_ref()) {
            editor.send(job);
        }
    }

    /// Takes back, or does again, so many steps.
    pub fn travel(&mut self, count: usize, is_back: bool) {
        let Some(editing) = &self.editing else { return };
        let most = if is_back { editing.steps.done.len() } else { editing.steps.undone.len() };
        if most == 0 {
            let text = if is_back { tr!("edit.nothing_back") } else { tr!("edit.nothing_again") };
            return self.say(text, false);
        }
        self.end_stroke();
        self.send_job(if is_back { Job::Undo(count.min(most)) } else { Job::Redo(count.min(most)) });
    }

    /// Does what a key asks for while the hand edits.
    pub(crate) fn edit_act(&mut self, action: EditAction, cursor: Option<Vec2>) {
        let Some(editing) = &mut self.editing else { return };
        match action {
            EditAction::Use | EditAction::Erase | EditAction::Resize => {}
            EditAction::PickMaterial => self.pick_material(cursor),
            EditAction::Undo => self.travel(1, true),
            EditAction::Redo => self.travel(1, false),
            EditAction::Choose(act) => {
                editing.act = act;
                if !editing.tool.has_act() {
                    editing.tool = Tool::Brush;
                }
                self.end_pasting();
            }
            EditAction::Take(tool) => {
                editing.tool = tool;
                self.end_pasting();
            }
            EditAction::Larger => editing.brush = editing.brush.stepped(1),
            EditAction::Smaller => editing.brush = editing.brush.stepped(-1),
            EditAction::Copy => self.copy_selection(false),
            EditAction::Cut => {
                self.copy_selection(false);
                self.clear_selection(tr!("edit.cut"));
            }
            EditAction::Paste => self.paste(),
            EditAction::Move => self.copy_selection(true),
            EditAction::Clear => self.clear_selection(tr!("edit.clear")),
            EditAction::Turn(axis) => self.turn_pasting(axis.into()),
            EditAction::Mirror(axis) => self.mirror_pasting(axis.into()),
        }
    }

    /// Takes the material under the cursor.
    pub fn pick_material(&mut self, cursor: Option<Vec2>) {
        let spot = cursor.and_then(|cursor| self.voxel_spot(&self.navigator.ray(cursor)));
        if let (Some(spot), Some(editing)) = (spot, &mut self.editing) {
            editing.take_material(spot.material);
        }
    }

    /// The voxel under a place in the picture; of a scene that was begun here, else the wall of its box.
    pub fn edit_spot(&self, cursor: Vec2) -> Option<Spot> {
        let ray = self.navigator.ray(cursor);
        self.voxel_spot(&ray).or_else(|| self.canvas_spot(&ray))
    }

    fn voxel_spot(&self, ray: &Ray) -> Option<Spot> {
        let editing = self.editing.as_ref()?;
        let scene = editing.before.as_ref().unwrap_or(&self.open.as_ref()?.pickable);
        let hit = scene.cast(ray)?;
        let instance = scene.instance(&hit);
        let direction = instance.grid_from_world.direction(ray.direction);
        // On the face of a cut: the side of the voxel that looks at the camera most.
        let towards = |direction: Vec3| {
            let axis = direction.abs().max_position();
            FACES[2 * axis + usize::from(direction[axis] < 0.0)]
        };
        let face = if hit.cut().is_some() { towards(direction) } else { hit.face() };
        Some(Spot {
            instance: hit.instance,
            grid: instance.grid,
            world_from_grid: instance.world_from_grid,
            voxel: hit.voxel,
            face,
            material: scene.material_index(&hit) as u16,
            point: instance.grid_from_world.point(ray.at(hit.t)).as_dvec3(),
        })
    }

    /// The box around the voxels of a grid.
    pub fn grid_bounds(&self, grid: u32) -> Option<VoxelBox> {
        let packed = self.open.as_ref()?.original.grids().get(grid as usize)?;
        Some(VoxelBox { min: packed.min, max: packed.max })
    }

    /// How many times the model of a grid stands in the scene.
    pub fn copies_of(&self, grid: u32) -> usize {
        let count = |open: &crate::session::Open| {
            open.original.instances().iter().filter(|instance| instance.grid == grid).count()
        };
        self.open.as_ref().map_or(0, count)
    }

    /// What brush, line and box do now: with Ctrl held they erase.
    pub fn act_now(&self) -> Act {
        let is_erasing = self.navigator.held.is_slow && !self.navigator.held.is_moving();
        self.editing.as_ref().map_or(Act::Place, |editing| if is_erasing { Act::Erase } else { editing.act })
    }

    /// The planes of symmetry of what is at a spot: through its middle, unless a voxel of it was chosen.
    pub fn symmetry_at(&self, spot: &Spot) -> Symmetry {
        let Some(editing) = &self.editing else { return Symmetry::default() };
        if editing.symmetry_of == Some(spot.grid) {
            return editing.symmetry;
        }
        // What is built in a box is as symmetric as the box.
        let canvas = self.open.as_ref().and_then(|open| open.canvas);
        let bounds = canvas.or_else(|| self.grid_bounds(spot.grid));
        Symmetry { twice: bounds.map_or(editing.symmetry.twice, Symmetry::middle_of), ..editing.symmetry }
    }

    /// A material that is changed while the scene has edits: the thread that owns the scene has to take it.
    pub(crate) fn edit_material(&mut self, change: MaterialChange) {
        let Some(editing) = &mut self.editing else { return };
        editing.materials.insert(change.number, change);
        self.send_materials();
    }

    /// Adds a material, which is the current one from then on.
    pub fn add_material(&mut self, material: Material) {
        self.send_job(Job::AddMaterial(material));
    }

    fn send_materials(&mut self) {
        let Some(editing) = &mut self.editing else { return };
        if editing.materials.is_empty() || !editing.materials_sent.is_empty() {
            return;
        }
        editing.materials_sent = std::mem::take(&mut editing.materials);
        let materials = editing.materials_sent.values().copied().collect();
        self.send_job(Job::Materials(materials));
    }

    /// What Esc ends of editing. Returns whether there was something.
    pub(crate) fn cancel_editing(&mut self) -> bool {
        let Some(editing) = self.editing.as_mut().filter(|editing| editing.is_on) else { return false };
        if editing.stroke.is_some() {
            // What a brush has painted is a step that can be taken back.
            self.drop_stroke();
        } else if editing.pasting.take().is_some() || std::mem::take(&mut editing.picks_middle) {
            // That was it.
        } else if editing.selection.take().is_none() {
            editing.is_on = false;
            self.say(tr!("edit.ended", key = crate::keys::key_of(Action::ToggleEditing)), false);
        }
        true
    }
}
