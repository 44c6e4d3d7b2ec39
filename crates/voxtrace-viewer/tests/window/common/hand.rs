//! A hand that edits in a session, with the thread that owns the scene, without a window.

use super::in_room;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, channel};
use std::time::Duration;
use voxtrace::VoxelGrid;
use voxtrace::glam::{IVec3, Vec2, Vec3};
use voxtrace::grid::VoxelBox;
use voxtrace_viewer::input::{Button, Input};
use voxtrace_viewer::keys::{Action, Key, Modifiers};
use voxtrace_viewer::projection::Projection;
use voxtrace_viewer::session::{Command, Session};

/// The middle of the upper face of a voxel of the floor.
pub fn floor(x: i32, y: i32) -> Vec3 {
    Vec3::new(x as f32 + 0.5, y as f32 + 0.5, 1.0)
}

/// A session with a hand that edits, and what the thread that owns the scene wakes.
pub struct Hand {
    pub session: Session,
    pub input: Input,
    woken: Receiver<()>,
    wake: Arc<dyn Fn() + Send + Sync>,
    /// What was asked for, but for patches.
    pub asked: Vec<Command>,
    pub patches: Vec<Arc<voxtrace::Patch>>,
}

impl Hand {
    /// Begins to edit.
    pub fn on(mut session: Session) -> Self {
        session.take_commands();
        session.act(Action::ToggleEditing, None);
        Self::at(session)
    }

    /// Goes on with a session that has begun to edit.
    pub fn at(session: Session) -> Self {
        let (sender, woken) = channel();
        let wake: Arc<dyn Fn() + Send + Sync> = Arc::new(move || sender.send(()).unwrap_or_default());
        let (asked, patches) = (Vec::new(), Vec::new());
        let mut hand = Self { session, input: Input::default(), woken, wake, asked, patches };
        hand.carry_out();
        hand.until("editing", |session| session.editing.as_ref().is_none_or(|editing| editing.is_ready));
        hand
    }

    /// Carries out what was asked for.
    pub fn carry_out(&mut self) {
        for command in self.session.take_commands() {
            match command {
                Command::Edit => self.session.start_editor(Arc::clone(&self.wake)),
                Command::Surround => self.session.make_surroundings(Arc::clone(&self.wake)),
                Command::Follow(followed) => self.patches.push(followed.0),
                command => self.asked.push(command),
            }
        }
    }

    /// Waits until something is so.
    pub fn until(&mut self, what: &str, is_so: impl Fn(&Session) -> bool) {
        loop {
            self.session.take_edited();
            self.session.take_surroundings();
            self.carry_out();
            if is_so(&self.session) {
                return;
            }
            self.woken.recv_timeout(Duration::from_secs(300)).unwrap_or_else(|_| panic!("{what} did not come"));
        }
    }

    /// Waits until there are so many steps, and so many that were undone.
    pub fn steps(&mut self, done: usize, undone: usize) {
        self.until("a step", |session| {
            let steps = &session.editing.as_ref().unwrap().steps;
            (steps.done.len(), steps.undone.len()) == (done, undone)
        });
    }

    /// Waits until all that was asked for so far is done: jobs are done in their order.
    pub fn settle(&mut self) {
        let region = VoxelBox { min: IVec3::ZERO, max: IVec3::ONE };
        let editing = self.session.editing.as_mut().unwrap();
        let (selection, clip) = (editing.selection, editing.clip.take());
        editing.selection = Some(voxtrace_viewer::editing::Selection {
            instance: 0,
            grid: 0,
            world_from_grid: voxtrace::Transform::IDENTITY,
            region,
        });
        self.session.copy_selection(false);
        self.until("a copy", |session| session.editing.as_ref().unwrap().clip.is_some());
        let editing = self.session.editing.as_mut().unwrap();
        (editing.selection, editing.clip) = (selection, clip);
    }

    pub fn key(&mut self, modifiers: Modifiers, key: Key) {
        self.input.set_modifiers(modifiers, &mut self.session);
        self.input.key(key, true, false, &mut self.session);
        self.input.key(key, false, false, &mut self.session);
        self.input.set_modifiers(Modifiers::NONE, &mut self.session);
        self.carry_out();
    }

    pub fn letter(&mut self, letter: char) {
        self.key(Modifiers::NONE, Key::Letter(letter));
    }

    pub fn ctrl(&mut self, letter: char) {
        self.key(Modifiers::CTRL, Key::Letter(letter));
    }

    /// Where the picture shows a point.
    pub fn place(&self, point: Vec3) -> Vec2 {
        Projection::new(self.session.navigator.camera(), self.session.size()).place(point).unwrap()
    }

    /// Drags over the points of the scene.
    pub fn drag(&mut self, points: &[Vec3]) {
        let places: Vec<Vec2> = points.iter().map(|&point| self.place(point)).collect();
        self.input.move_to(places[0], &mut self.session);
        self.input.press(Button::Left, &mut self.session);
        places[1..].iter().for_each(|&place| self.input.move_to(place, &mut self.session));
        self.input.release(Button::Left, &mut self.session);
        self.carry_out();
    }

    pub fn click(&mut self, point: Vec3) {
        self.drag(&[point]);
    }

    pub fn material_at(&self, voxel: IVec3) -> Option<u32> {
        let scene = &self.session.open.as_ref().unwrap().original;
        scene.geometry().material_at(&scene.grids()[0], voxel)
    }

    pub fn take_material(&mut self, material: u16) {
        self.session.editing.as_mut().unwrap().take_material(material);
    }

    /// Voxels of the first grid.
    pub fn voxels(&self) -> VoxelGrid {
        let scene = self.session.open.as_ref().unwrap().original.to_scene();
        (*scene.grids[0]).clone()
    }
}

/// A hand in the room.
pub fn in_the_room() -> Hand {
    Hand::on(in_room("room.vxt"))
}

/// Voxels that differ.
pub fn differing(before: &VoxelGrid, after: &VoxelGrid) -> Vec<IVec3> {
    let mut all: Vec<IVec3> = before.voxels().chain(after.voxels()).map(|(voxel, _)| voxel).collect();
    all.sort_unstable_by_key(|voxel| voxel.to_array());
    all.dedup();
    all.retain(|&voxel| before.get(voxel) != after.get(voxel));
    all
}
