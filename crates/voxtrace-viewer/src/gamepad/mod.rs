//! Gamepads: sticks fly and look, triggers rise and sink, buttons do what the table of keys says of them. A thread listens where the system has
//! its gamepads; what it tells are plain values, which scripts tell just as well.

#[cfg(any(windows, target_os = "macos"))]
#[path = "gilrs.rs"]
mod system;
#[cfg(target_os = "linux")]
#[path = "linux.rs"]
mod system;

use crate::keys::{self, PadButton};
use crate::session::Session;
use voxtrace::glam::{Vec2, Vec3};

/// Share of a stick's way within which it counts as let go: worn sticks do not come back to the middle.
const DEAD: f32 = 0.15;

/// A part of a gamepad that has more than two states.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PadAxis {
    /// The left stick, to the right.
    LeftX,
    /// The left stick, away from the user.
    LeftY,
    /// The right stick, to the right.
    RightX,
    /// The right stick, away from the user.
    RightY,
    /// The left trigger, 0 to 1.
    LeftTrigger,
    /// The right trigger, 0 to 1.
    RightTrigger,
}

/// What a gamepad tells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PadEvent {
    /// A stick or a trigger moved, from -1 to 1.
    Axis(PadAxis, f32),
    /// A button was pressed.
    Press(PadButton),
    /// The gamepad is gone: everything is let go.
    Gone,
}

/// Where the parts of the gamepad are.
#[derive(Clone, Copy, Debug, Default)]
pub struct Gamepad {
    axes: [f32; 6],
}

impl Gamepad {
    /// Takes what a gamepad tells.
    pub fn take(&mut self, event: PadEvent, session: &mut Session) {
        match event {
            PadEvent::Axis(axis, value) => {
                self.axes[axis as usize] = if value.is_finite() { value.clamp(-1.0, 1.0) } else { 0.0 }
            }
            PadEvent::Press(button) => {
                if let Some(action) = keys::action_of_pad(button) {
                    // In the middle of the picture: a gamepad has no cursor.
                    let (width, height) = session.size();
                    session.act(action, Some(Vec2::new(width as f32, height as f32) * 0.5));
                }
                return;
            }
            PadEvent::Gone => *self = Self::default(),
        }
        let at = |axis: PadAxis| self.axes[axis as usize];
        let left = alive(Vec2::new(at(PadAxis::LeftX), at(PadAxis::LeftY)));
        let trigger = |axis| alive(Vec2::new(at(axis).max(0.0), 0.0)).x;
        let rise = trigger(PadAxis::RightTrigger) - trigger(PadAxis::LeftTrigger);
        session.navigator.held.stick = Vec3::new(left.x, left.y, rise);
        session.navigator.held.turn = alive(Vec2::new(at(PadAxis::RightX), at(PadAxis::RightY)));
    }
}

/// A stick without its dead middle, with finer control near it: the square of its way.
fn alive(stick: Vec2) -> Vec2 {
    let length = stick.length().min(1.0);
    if length <= DEAD {
        return Vec2::ZERO;
    }
    let way = (length - DEAD) / (1.0 - DEAD);
    stick.normalize_or_zero() * (way * way)
}

/// Listens to all gamepads of the system as long as `tell` returns true. Where there are none, it waits for one.
pub fn listen(tell: impl Fn(PadEvent) -> bool + Send + Sync + 'static) {
    #[cfg(any(windows, target_os = "macos", target_os = "linux"))]
    std::thread::spawn(move || system::listen(std::sync::Arc::new(tell)));
    #[cfg(not(any(windows, target_os = "macos", target_os = "linux")))]
    drop(tell);
}
