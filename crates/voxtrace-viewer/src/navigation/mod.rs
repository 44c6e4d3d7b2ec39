//! The camera of the window: flight, orbit, zoom, pan and framing as functions of the state and one input, with undo. It knows no
//! window, no clock and no scene but its bounds; what is under the cursor, the caller says.
//!
//! Space is right-handed, z up, in voxels. A camera's `up` stays upright in the picture (no roll) until [`Motion::Level`] takes z for it.

mod fit;
mod held;
mod history;
mod motion;
mod parallel;
mod pose;
#[cfg(test)]
mod tests;
pub mod walking;

pub use held::{Held, Movement};
pub use motion::{AxisView, FIELDS_OF_VIEW, Motion, ZOOM_STEP, steps_of_pinch};

use fit::Bounds;
use history::History;
use motion::{Surroundings, clean_steps};
use pose::Pose;
use voxtrace::glam::{DVec3, Vec2, Vec3};
use voxtrace::{Camera, Ray};
use walking::{Ground, Walker};

/// Longest step of flight, seconds: after a pause of the program nobody wakes up elsewhere.
const LONGEST_STEP: f64 = 0.25;
/// Seconds from corner to corner of the scene at the first speed.
const CROSSING: f64 = 8.0;
/// Factor of one step on the speed.
const SPEED_STEP: f64 = 1.25;
/// Largest coordinate of a camera that is taken, voxels.
const LARGEST: f32 = 1e12;

/// What dragging with the left button does.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Mode {
    /// Turns the view.
    Fly,
    /// Goes around what is under the cursor.
    #[default]
    Orbit,
    /// Turns the view of somebody who walks on surfaces.
    Walk,
}

/// The camera and how it moves.
#[derive(Clone, Debug)]
pub struct Navigator {
    /// What dragging does.
    pub mode: Mode,
    /// What is held now.
    pub held: Held,
    /// Whether looking by dragging is upside down.
    pub is_inverted: bool,
    /// Who walks, where somebody does.
    pub walker: Walker,
    now: State,
    bounds: Bounds,
    viewport: (u32, u32),
    /// Voxels a second.
    speed: f64,
    history: History<State>,
}

/// The camera as the tracer sees it, and the pose that it is made of: a camera that was given stays as it is to the bit until it moves.
#[derive(Clone, Debug)]
struct State {
    camera: Camera,
    pose: Pose,
}

/// States are the same where their pictures are.
impl PartialEq for State {
    fn eq(&self, other: &Self) -> bool {
        self.camera == other.camera
    }
}

impl State {
    fn of(camera: Camera) -> Self {
        Self { pose: Pose::of(&camera), camera }
    }
}

impl Navigator {
    /// A navigator at `camera` in a scene within `bounds`, the corners of a box (see `PackedScene::bounds`). A camera that cannot send
    /// rays is replaced by a view of everything, a box that is none by that of one voxel.
    pub fn new(camera: Camera, bounds: Option<(Vec3, Vec3)>) -> Self {
        let bounds = bounds.and_then(|(min, max)| Bounds::new(min.as_dvec3(), max.as_dvec3()));
        let bounds = bounds.unwrap_or(Bounds { min: DVec3::ZERO, max: DVec3::ONE });
        let is_usable = is_usable(&camera);
        let camera = if is_usable { camera } else { Camera::look_at(Vec3::new(0.62, -1.0, 0.55), Vec3::ZERO) };
        let mut navigator = Self {
            mode: Mode::default(),
            held: Held::default(),
            is_inverted: false,
            walker: Walker::default(),
            now: State::of(camera),
            bounds,
            viewport: (16, 9),
            speed: bounds.diagonal() / CROSSING,
            history: History::default(),
        };
        if !is_usable {
            navigator.apply(Motion::FrameAll);
            navigator.history = History::default();
        }
        navigator
    }

    /// The same in another scene: size of the picture, mode and settings stay, speed and history start anew.
    pub fn in_scene(&self, camera: Camera, bounds: Option<(Vec3, Vec3)>) -> Self {
        let other = Self::new(camera, bounds);
        Self { mode: self.mode, held: self.held, is_inverted: self.is_inverted, viewport: self.viewport, ..other }
    }

    /// The camera now.
    pub fn camera(&self) -> &Camera {
        &self.now.camera
    }

    /// Voxels a second of flight, without Shift and Ctrl.
    pub fn speed(&self) -> f32 {
        self.speed as f32
    }

    /// From corner to corner of the scene, voxels.
    pub fn diagonal(&self) -> f32 {
        self.bounds.diagonal() as f32
    }

    /// Says how large the picture is, in the unit of cursors.
    pub fn set_viewport(&mut self, width: u32, height: u32) {
        self.viewport = (width.max(1), height.max(1));
    }

    /// The ray of the picture under a cursor.
    pub fn ray(&self, cursor: Vec2) -> Ray {
        self.now.camera.frame(self.viewport.0, self.viewport.1).central_ray(cursor)
    }

    /// The point on that ray at this distance from the eye: what [`Motion::Orbit`] and [`Motion::Pan`] hold on to.
    pub fn point_at(&self, cursor: Vec2, distance: f32) -> Vec3 {
        let ray = self.ray(cursor);
        ray.origin + ray.direction * distance
    }

    /// Moves the camera. Returns whether it changed, so that the picture starts anew.
    pub fn apply(&mut self, motion: Motion) -> bool {
        match motion {
            Motion::Speed(steps) => {
                let (least, most) = (self.bounds.diagonal() * 1e-5, self.bounds.diagonal() * 10.0);
                self.speed = (self.speed * SPEED_STEP.powf(clean_steps(steps))).clamp(least, most);
                false
            }
            Motion::GoTo(camera) if is_usable(&camera) => self.jump(State::of(camera)),
            Motion::Look(_)
            | Motion::Orbit { .. }
            | Motion::Pan { .. }
            | Motion::Zoom { .. }
            | Motion::Lens(_)
            | Motion::FieldOfView(_) => {
                let pose = self.surroundings().moved(self.now.pose, &motion);
                self.take(pose)
            }
            _ => {
                let pose = self.surroundings().moved(self.now.pose, &motion);
                self.jump(self.state(pose))
            }
        }
    }

    /// Stands where a camera is that moves by itself, the timeline's: a step back leads to where it was before. Returns whether the camera changed.
    pub fn follow(&mut self, camera: Camera) -> bool {
        if !is_usable(&camera) || camera == self.now.camera {
            return false;
        }
        self.history.note(&self.now);
        self.now = State::of(camera);
        true
    }

    /// Lets time go by: what is held moves the camera, and a pause ends a gesture. Returns whether the camera changed.
    pub fn advance(&mut self, seconds: f32) -> bool {
        let seconds = if seconds > 0.0 { f64::from(seconds) } else { 0.0 };
        let mut pose = self.held.moved(self.now.pose, self.speed, seconds.min(LONGEST_STEP));
        pose.eye = self.surroundings().reached(pose.eye, self.now.pose.eye);
        let has_changed = self.take(pose);
        if !has_changed {
            self.history.pass(seconds, &self.now);
        }
        has_changed
    }

    /// As [`Self::advance`], of somebody who walks.
    pub fn walk(&mut self, seconds: f32, ground: &dyn Ground) -> bool {
        let seconds = if seconds > 0.0 { f64::from(seconds).min(LONGEST_STEP) } else { 0.0 };
        let turned = self.held.turned(self.now.pose, seconds);
        let mut wish = self.held.wish();
        // The wheel and its keys set the speed of walking, too.
        wish.speed *= self.speed * CROSSING / self.bounds.diagonal();
        let pose = self.walker.moved(turned, wish, seconds, ground);
        let has_changed = self.take(pose);
        if !has_changed {
            self.history.pass(seconds, &self.now);
        }
        has_changed
    }

    /// Puts somebody who walks where the camera is, on the ground. Returns whether there is one.
    pub fn step_down(&mut self, ground: &dyn Ground) -> bool {
        let level = self.now.pose.levelled();
        let Some(eye) = self.walker.dropped(level.eye, ground) else { return false };
        self.jump(self.state(Pose { eye, ..level }));
        true
    }

    /// Walks to a point by itself.
    pub fn walk_to(&mut self, point: Vec3) {
        self.walker.walk_to(point.as_dvec3(), self.now.pose.eye);
    }

    /// A gesture begins, a drag say: until its end, it is one entry of the history.
    pub fn begin_gesture(&mut self) {
        self.history.begin(&self.now);
    }

    /// The gesture ends.
    pub fn end_gesture(&mut self) {
        self.history.end(&self.now);
    }

    /// Goes back to the camera before the last gesture. Returns whether there was one.
    pub fn undo(&mut self) -> bool {
        let before = self.history.undo(&self.now);
        before.map(|before| self.now = before).is_some()
    }

    /// Goes to the camera that was undone last. Returns whether there was one.
    pub fn redo(&mut self) -> bool {
        let after = self.history.redo(&self.now);
        after.map(|after| self.now = after).is_some()
    }

    /// Whether [`Self::undo`] would go somewhere.
    pub fn can_undo(&self) -> bool {
        self.history.can_undo(&self.now)
    }

    /// Whether [`Self::redo`] would go somewhere.
    pub fn can_redo(&self) -> bool {
        self.history.can_redo()
    }

    fn surroundings(&self) -> Surroundings {
        let (width, height) = (f64::from(self.viewport.0), f64::from(self.viewport.1));
        Surroundings { bounds: self.bounds, width, height, is_inverted: self.is_inverted }
    }

    fn state(&self, pose: Pose) -> State {
        // A pose that stays is the camera that was given, without rounding.
        let camera = if pose == self.now.pose { self.now.camera.clone() } else { pose.camera(&self.now.camera.name) };
        State { camera, pose }
    }

    /// A small step of a gesture.
    fn take(&mut self, pose: Pose) -> bool {
        if pose == self.now.pose {
            return false;
        }
        let after = self.state(pose);
        let has_changed = after != self.now;
        if has_changed {
            self.history.note(&self.now);
        }
        self.now = after;
        has_changed
    }

    /// A step that is a gesture of its own.
    fn jump(&mut self, after: State) -> bool {
        if after == self.now {
            return false;
        }
        self.history.close(&self.now);
        self.history.note(&self.now);
        self.now = after;
        self.history.close(&self.now);
        true
    }
}

/// Whether a camera can send rays, and its numbers leave room for calculation.
fn is_usable(camera: &Camera) -> bool {
    let vectors = [camera.eye, camera.target, camera.up];
    camera.check().is_ok() && camera.eye != camera.target && vectors.iter().all(|v| v.abs().max_element() <= LARGEST)
}
