//! Scripts of fingers on a screen and on a gamepad: events in, commands out.

use crate::common::{SIZE, in_room, said};
use std::time::{Duration, Instant};
use voxtrace::glam::Vec2;
use voxtrace_viewer::gamepad::{Gamepad, PadAxis, PadEvent};
use voxtrace_viewer::input::Input;
use voxtrace_viewer::keys::{self, Action, PadButton};
use voxtrace_viewer::navigation::Mode;
use voxtrace_viewer::session::{Command, Session};
use voxtrace_viewer::touch::{Phase, Touch};

const MIDDLE: Vec2 = Vec2::new(320.0, 240.0);

/// Fingers with a clock of their own.
struct Hand {
    touch: Touch,
    input: Input,
    now: Instant,
}

impl Hand {
    fn new() -> Self {
        Self { touch: Touch::default(), input: Input::default(), now: Instant::now() }
    }

    fn touch(&mut self, id: u64, phase: Phase, place: Vec2, session: &mut Session) {
        self.now += Duration::from_millis(20);
        self.touch.touch(id, phase, place, self.now, &mut self.input, session);
    }

    fn tap(&mut self, place: Vec2, session: &mut Session) {
        self.touch(1, Phase::Down, place, session);
        self.touch(1, Phase::Up, place, session);
    }
}

#[test]
fn one_finger_goes_around_what_is_under_it_and_a_tap_picks() {
    let mut session = in_room("room.vxt");
    let mut hand = Hand::new();
    let held = session.pick(MIDDLE).unwrap().point;
    let before = session.navigator.camera().clone();
    hand.touch(7, Phase::Down, MIDDLE, &mut session);
    hand.touch(7, Phase::Moved, MIDDLE + Vec2::new(60.0, 10.0), &mut session);
    hand.touch(7, Phase::Up, MIDDLE + Vec2::new(60.0, 10.0), &mut session);
    assert_eq!(session.take_commands(), [Command::SetView]);
    let now = session.navigator.camera().clone();
    assert!((now.eye.distance(held) - before.eye.distance(held)).abs() < 1e-3 && now.eye.distance(before.eye) > 3.0);
    assert_eq!((session.picked.clone(), hand.touch.is_active(), hand.input.cursor()), (None, false, None));
    session.undo_camera(true);
    assert_eq!(session.navigator.camera(), &before, "it was one gesture");
    hand.now += Duration::from_secs(2);
    hand.tap(MIDDLE, &mut session);
    let picked = session.picked.clone().expect("the block is in the middle");
    session.take_commands();
    hand.tap(MIDDLE + Vec2::new(3.0, 2.0), &mut session);
    assert_eq!(session.take_commands(), [Command::SetView], "two taps frame it");
    assert_eq!(session.picked, Some(picked));
}

#[test]
fn two_fingers_move_sideways_and_zoom_and_are_no_tap() {
    let mut session = in_room("room.vxt");
    let mut hand = Hand::new();
    let before = session.navigator.camera().clone();
    let depth = session.pick(MIDDLE).unwrap().hit.t;
    let left = Vec2::new(-50.0, 0.0);
    hand.touch(1, Phase::Down, MIDDLE + left, &mut session);
    hand.touch(2, Phase::Down, MIDDLE - left, &mut session);
    // Both to the right: the picture follows.
    hand.touch(1, Phase::Moved, MIDDLE + left + Vec2::new(30.0, 0.0), &mut session);
    hand.touch(2, Phase::Moved, MIDDLE - left + Vec2::new(30.0, 0.0), &mut session);
    let panned = session.navigator.camera().clone();
    let side = (before.target - before.eye).cross(before.up).normalize();
    assert!((panned.eye - before.eye).dot(side) < -1.0, "{panned:?}");
    let view = |camera: &voxtrace::Camera| (camera.target - camera.eye).normalize();
    assert!(view(&panned).abs_diff_eq(view(&before), 1e-4), "it does not turn");
    // Apart: nearer.
    hand.touch(2, Phase::Moved, MIDDLE - left * 3.0 + Vec2::new(30.0, 0.0), &mut session);
    hand.touch(1, Phase::Moved, MIDDLE + left * 3.0 + Vec2::new(30.0, 0.0), &mut session);
    let near = session.navigator.camera().eye;
    assert!((near - panned.eye).dot(view(&before)) > depth * 0.3, "{near} {}", panned.eye);
    // The finger that stays does nothing more.
    hand.touch(1, Phase::Up, MIDDLE, &mut session);
    session.take_commands();
    hand.touch(2, Phase::Moved, MIDDLE, &mut session);
    hand.touch(2, Phase::Up, MIDDLE, &mut session);
    assert_eq!((session.take_commands(), session.picked.clone()), (vec![], None));
    session.undo_camera(true);
    assert_eq!(session.navigator.camera(), &before, "all of it was one gesture");
}

#[test]
fn a_finger_that_the_system_takes_away_picks_nothing() {
    let mut session = in_room("room.vxt");
    let mut hand = Hand::new();
    hand.touch(1, Phase::Down, MIDDLE, &mut session);
    hand.touch(1, Phase::Cancelled, MIDDLE, &mut session);
    hand.touch(9, Phase::Up, MIDDLE, &mut session);
    assert_eq!((session.picked.clone(), hand.input.is_dragging()), (None, false));
}

#[test]
fn turning_two_fingers_on_the_trackpad_goes_around_what_is_under_the_cursor() {
    let mut session = in_room("room.vxt");
    let mut input = Input::default();
    input.rotate(30.0, &mut session);
    assert_eq!(session.take_commands(), [], "where no cursor is, nothing is under it");
    input.move_to(MIDDLE, &mut session);
    let (held, before) = (session.pick(MIDDLE).unwrap().point, session.navigator.camera().eye);
    input.rotate(30.0, &mut session);
    let (from, to) = (before - held, session.navigator.camera().eye - held);
    let turned = from.with_z(0.0).angle_between(to.with_z(0.0)).to_degrees();
    assert!((turned - 30.0).abs() < 0.1, "{turned}");
}

#[test]
fn sticks_fly_and_look_triggers_rise_and_a_worn_stick_rests() {
    let mut session = in_room("room.vxt");
    let mut pad = Gamepad::default();
    let before = session.navigator.camera().clone();
    pad.take(PadEvent::Axis(PadAxis::LeftX, 0.1), &mut session);
    assert!(!session.advance(0.1) && session.take_commands().is_empty(), "near its middle a stick rests");
    pad.take(PadEvent::Axis(PadAxis::LeftX, 0.0), &mut session);
    pad.take(PadEvent::Axis(PadAxis::LeftY, 1.0), &mut session);
    assert!(session.advance(0.1));
    assert_eq!(session.take_commands(), [Command::SetView]);
    let gone = session.navigator.camera().eye - before.eye;
    let forward = (before.target - before.eye).normalize();
    assert!((gone.dot(forward) - session.navigator.speed() * 0.1).abs() < 1e-3, "{gone}");
    pad.take(PadEvent::Axis(PadAxis::LeftY, 0.5), &mut session);
    let here = session.navigator.camera().eye;
    session.advance(0.1);
    let slow = session.navigator.camera().eye.distance(here);
    assert!(slow > 0.0 && slow < gone.length() * 0.4, "half way is less than half the speed: {slow}");
    pad.take(PadEvent::Axis(PadAxis::LeftY, f32::NAN), &mut session);
    pad.take(PadEvent::Axis(PadAxis::RightTrigger, 1.0), &mut session);
    let here = session.navigator.camera().clone();
    session.advance(0.1);
    assert!(session.navigator.camera().eye.z > here.eye.z + 0.1);
    pad.take(PadEvent::Axis(PadAxis::RightX, 1.0), &mut session);
    pad.take(PadEvent::Gone, &mut session);
    let here = session.navigator.camera().clone();
    session.advance(0.1);
    assert_eq!(session.navigator.camera(), &here, "what is unplugged is let go");
    pad.take(PadEvent::Axis(PadAxis::RightX, -1.0), &mut session);
    session.advance(0.1);
    let left = (before.target - before.eye).cross(before.up) * -1.0;
    assert!((session.navigator.camera().target - session.navigator.camera().eye).dot(left) > 0.0);
}

#[test]
fn buttons_of_a_gamepad_do_what_the_table_says() {
    let mut session = in_room("room.vxt");
    let mut pad = Gamepad::default();
    pad.take(PadEvent::Press(PadButton::West), &mut session);
    assert_eq!(session.navigator.mode, Mode::Fly);
    assert!(said(&mut session)[0].contains("fly"));
    pad.take(PadEvent::Press(PadButton::Right), &mut session);
    assert_eq!(session.navigator.camera(), &session.open.as_ref().unwrap().original.cameras[1]);
    let (width, height) = SIZE;
    let picked = session.pick(Vec2::new(width as f32, height as f32) * 0.5).unwrap();
    pad.take(PadEvent::Press(PadButton::South), &mut session);
    let camera = session.navigator.camera();
    assert!((camera.target - camera.eye).normalize().dot((picked.point - camera.eye).normalize()) > 0.999);
    assert_eq!(keys::action_of_pad(PadButton::East), Some(Action::UndoCamera));
    session.act(Action::UndoCamera, None);
    let exposure = session.render_settings.tone_map.exposure;
    pad.take(PadEvent::Press(PadButton::Up), &mut session);
    assert_eq!(session.render_settings.tone_map.exposure, exposure + session.exposure_step);
}
