//! What moves the camera as long as it is held: keys of flight and the sticks of a gamepad.

use super::pose::Pose;
use super::walking::Wish;
use voxtrace::glam::{DVec3, Vec2, Vec3};

/// Factor on the speed with Shift.
const FAST: f64 = 4.0;
/// Factor on the speed with Ctrl.
const SLOW: f64 = 0.25;
/// Fields of view a second that keys and sticks turn by.
const TURN: f64 = 1.5;

/// What one key does while it is held.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Movement {
    /// Along the view.
    Forward,
    /// Against the view.
    Back,
    /// To the left.
    Left,
    /// To the right.
    Right,
    /// Upwards, at right angles to the horizon.
    Up,
    /// Downwards.
    Down,
    /// Turns the view to the left.
    TurnLeft,
    /// Turns the view to the right.
    TurnRight,
    /// Turns the view up.
    TurnUp,
    /// Turns the view down.
    TurnDown,
}

impl Movement {
    /// All of them.
    pub const ALL: [Self; 10] = [
        Self::Forward,
        Self::Back,
        Self::Left,
        Self::Right,
        Self::Up,
        Self::Down,
        Self::TurnLeft,
        Self::TurnRight,
        Self::TurnUp,
        Self::TurnDown,
    ];
}

/// What is held now.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Held {
    /// The keys, by [`Movement`].
    keys: [bool; 10],
    /// Shift: four times the speed.
    pub is_fast: bool,
    /// Ctrl: a quarter of the speed.
    pub is_slow: bool,
    /// A stick that moves: to the right, forward, up, each from -1 to 1.
    pub stick: Vec3,
    /// A stick that turns: to the right, up, each from -1 to 1.
    pub turn: Vec2,
}

impl Held {
    /// Says that a key is held or not any more.
    pub fn set(&mut self, movement: Movement, is_held: bool) {
        self.keys[movement as usize] = is_held;
    }

    /// Lets everything go: when the window loses the keyboard.
    pub fn clear(&mut self) {
        *self = Self::default();
    }

    /// Whether time moves the camera.
    pub fn is_moving(&self) -> bool {
        self.direction() != DVec3::ZERO || self.turning() != (0.0, 0.0)
    }

    fn axis(&self, less: Movement, more: Movement, stick: f32) -> f64 {
        let keys = f64::from(i8::from(self.keys[more as usize]) - i8::from(self.keys[less as usize]));
        let stick = if stick.is_finite() { f64::from(stick) } else { 0.0 };
        (keys + stick).clamp(-1.0, 1.0)
    }

    /// To the right, forward, up; at most of length 1.
    fn direction(&self) -> DVec3 {
        let direction = DVec3::new(
            self.axis(Movement::Left, Movement::Right, self.stick.x),
            self.axis(Movement::Back, Movement::Forward, self.stick.y),
            self.axis(Movement::Down, Movement::Up, self.stick.z),
        );
        direction.clamp_length_max(1.0)
    }

    fn turning(&self) -> (f64, f64) {
        let right = self.axis(Movement::TurnLeft, Movement::TurnRight, self.turn.x);
        (right, self.axis(Movement::TurnDown, Movement::TurnUp, self.turn.y))
    }

    /// What somebody who walks is to do.
    pub(super) fn wish(&self) -> Wish {
        let direction = self.direction();
        let speed = if self.is_fast { FAST } else { 1.0 } * if self.is_slow { SLOW } else { 1.0 };
        Wish { direction: direction.truncate().clamp_length_max(1.0), speed, jumps: direction.z > 0.5 }
    }

    /// The pose turned for so many seconds.
    pub(super) fn turned(&self, pose: Pose, seconds: f64) -> Pose {
        let angle = f64::from(pose.fov_y).to_radians() * TURN * seconds;
        let (right, up) = self.turning();
        if (right, up) == (0.0, 0.0) { pose } else { pose.turned(right * angle, up * angle) }
    }

    /// The pose after so many seconds at `speed`, voxels a second.
    pub(super) fn moved(&self, pose: Pose, speed: f64, seconds: f64) -> Pose {
        let speed = speed * if self.is_fast { FAST } else { 1.0 } * if self.is_slow { SLOW } else { 1.0 };
        let pose = self.turned(pose, seconds);
        let (basis, direction) = (pose.basis(), self.direction());
        let step = basis.x_axis * direction.x + basis.z_axis * direction.y + pose.horizon * direction.z;
        Pose { eye: pose.eye + step * (speed * seconds), ..pose }
    }
}
