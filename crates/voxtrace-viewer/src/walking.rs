//! Walking in the scene that is shown: who walks, how tall, and where to.

use crate::navigation::Mode;
use crate::session::Session;
use crate::tr;
use voxtrace::glam::Vec2;
use voxtrace::scene::Unit;

/// Height of a person's eye, metres.
const PERSON: f64 = 1.7;
/// Where there is no unit, or the scene is no place for people: a share of its diagonal.
const SHARE: f64 = 1.0 / 30.0;
/// A person is at most as tall as this share of the diagonal.
const MOST: f64 = 0.2;
/// Least height of an eye, voxels.
const LEAST: f64 = 2.6;

impl Session {
    /// The height of an eye that suits the scene, voxels.
    pub fn usual_eye_height(&self) -> f64 {
        let diagonal = f64::from(self.navigator.diagonal());
        let metre = self.open.as_ref().and_then(|open| match open.original.unit {
            Unit::Voxel => None,
            Unit::Metre => Some(1.0 / open.original.voxel_size),
            Unit::Millimetre => Some(1000.0 / open.original.voxel_size),
        });
        let person = metre.map(|metre| PERSON * metre).filter(|height| *height <= MOST * diagonal);
        person.unwrap_or(SHARE * diagonal).max(LEAST)
    }

    /// Walks from where the camera is, or flies again.
    pub fn toggle_walking(&mut self) {
        match self.navigator.mode {
            Mode::Walk => self.set_mode(Mode::Fly),
            _ => self.set_mode(Mode::Walk),
        }
    }

    /// Flies, orbits or walks from now on; says so.
    pub fn set_mode(&mut self, mode: Mode) {
        if mode == Mode::Walk && !self.begin_walking() {
            return;
        }
        self.navigator.mode = mode;
        let text = match mode {
            Mode::Fly => tr!("walk.fly"),
            Mode::Orbit => tr!("walk.orbit"),
            Mode::Walk => tr!("walk.walk"),
        };
        self.say_instead(&[tr!("walk.fly"), tr!("walk.orbit"), tr!("walk.walk")], text);
    }

    /// Stands on what is below the camera, else below what is in the middle of the picture.
    fn begin_walking(&mut self) -> bool {
        let Some(scene) = self.open.as_ref().map(|open| std::sync::Arc::clone(&open.pickable)) else {
            self.say(tr!("walk.no_scene"), false);
            return false;
        };
        if !self.has_eye_height {
            self.navigator.walker.eye_height = self.usual_eye_height();
            self.has_eye_height = true;
        }
        let middle = Vec2::new(self.size().0 as f32, self.size().1 as f32) * 0.5;
        if !self.navigator.step_down(&*scene) {
            let Some(picked) = self.pick(middle) else {
                self.say(tr!("walk.nothing_below"), false);
                return false;
            };
            let up = self.navigator.walker.eye_height as f32;
            let camera = self.navigator.camera();
            let eye = picked.point + voxtrace::glam::Vec3::Z * up;
            let target = eye + (camera.target - camera.eye).with_z(0.0).normalize_or(voxtrace::glam::Vec3::Y) * up;
            let camera = voxtrace::Camera { eye, target, ..camera.clone() };
            self.move_by(crate::navigation::Motion::GoTo(camera));
            self.navigator.step_down(&*scene);
        }
        self.moved();
        true
    }

    /// Walks to what is under the cursor.
    pub fn walk_here(&mut self, cursor: Option<Vec2>) {
        match cursor.and_then(|cursor| self.pick(cursor)) {
            Some(picked) => {
                self.navigator.walk_to(picked.point);
                // Time goes on from here: nothing is held that would make it.
                self.moved();
            }
            None => self.say(tr!("walk.nothing_there"), false),
        }
    }

    /// Lets time go by. Returns whether the camera moved.
    pub(crate) fn advance_camera(&mut self, seconds: f32) -> bool {
        if self.navigator.mode != Mode::Walk {
            return self.navigator.advance(seconds);
        }
        let Some(scene) = self.open.as_ref().map(|open| std::sync::Arc::clone(&open.pickable)) else { return false };
        self.navigator.walk(seconds, &*scene)
    }
}
