//! Fingers on a screen: one drags as the left button does and taps as it clicks, two move the picture sideways and zoom by parting.
//! Places are those of the picture, pixels.

use crate::input::{Button, Input};
use crate::session::Session;
use std::time::{Duration, Instant};
use voxtrace::glam::Vec2;

/// Two taps within this time, and this near, are a double tap.
const DOUBLE_TAP: Duration = Duration::from_millis(400);
const NEAR: f32 = 24.0;

/// What a finger does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Phase {
    /// It touches the screen.
    Down,
    /// It moves on it.
    Moved,
    /// It leaves it.
    Up,
    /// The system takes it for something else.
    Cancelled,
}

/// The fingers that touch the picture, in the order in which they came.
#[derive(Default)]
pub struct Touch {
    fingers: Vec<(u64, Vec2)>,
    /// Whether two fingers have touched since the last time that none did: what one of them does then is no drag.
    was_two: bool,
    /// Where the one finger came down, and when.
    last_tap: Option<(Instant, Vec2)>,
}

impl Touch {
    /// Whether a finger touches the picture.
    pub fn is_active(&self) -> bool {
        !self.fingers.is_empty()
    }

    /// A finger does something at a place, at some time.
    pub fn touch(
        &mut self,
        id: u64,
        phase: Phase,
        place: Vec2,
        now: Instant,
        input: &mut Input,
        session: &mut Session,
    ) {
        match phase {
            Phase::Down => self.down(id, place, now, input, session),
            Phase::Moved => self.moved(id, place, input, session),
            Phase::Up | Phase::Cancelled => self.up(id, phase, input, session),
        }
    }

    fn down(&mut self, id: u64, place: Vec2, now: Instant, input: &mut Input, session: &mut Session) {
        self.fingers.retain(|(other, _)| *other != id);
        self.fingers.push((id, place));
        match self.fingers.len() {
            1 => {
                self.was_two = false;
                input.move_to(place, session);
                input.press(Button::Left, session);
                let is_second =
                    self.last_tap.is_some_and(|(then, there)| now - then < DOUBLE_TAP && there.distance(place) < NEAR);
                self.last_tap = (!is_second).then_some((now, place));
                if is_second {
                    input.double_click(session);
                }
            }
            2 => {
                // The drag of the first finger ends where it is; it was no tap.
                input.abandon(session);
                (self.was_two, self.last_tap) = (true, None);
                session.navigator.begin_gesture();
            }
            _ => {}
        }
    }

    fn moved(&mut self, id: u64, place: Vec2, input: &mut Input, session: &mut Session) {
        let before = self.pair();
        let Some(finger) = self.fingers.iter_mut().find(|(other, _)| *other == id) else { return };
        finger.1 = place;
        match (before, self.pair()) {
            (Some(before), Some(now)) => {
                let (from, to) = (before.0.midpoint(before.1), now.0.midpoint(now.1));
                input.pan(from, to, session);
                let (apart, now_apart) = (before.0.distance(before.1), now.0.distance(now.1));
                if apart > 1.0 && now_apart > 1.0 {
                    input.move_to(to, session);
                    input.pinch(now_apart / apart - 1.0, session);
                }
            }
            _ if !self.was_two => input.move_to(place, session),
            _ => {}
        }
    }

    fn up(&mut self, id: u64, phase: Phase, input: &mut Input, session: &mut Session) {
        let before = self.fingers.len();
        self.fingers.retain(|(other, _)| *other != id);
        if before == self.fingers.len() {
            return;
        }
        match before {
            1 if !self.was_two && phase == Phase::Up => input.release(Button::Left, session),
            1 if !self.was_two => input.abandon(session),
            2 => session.navigator.end_gesture(),
            _ => {}
        }
        if self.fingers.is_empty() {
            // A finger that is gone is nowhere.
            input.leave(session);
        }
    }

    /// The places of the first two fingers.
    fn pair(&self) -> Option<(Vec2, Vec2)> {
        match self.fingers[..] {
            [(_, one), (_, other), ..] => Some((one, other)),
            _ => None,
        }
    }
}
