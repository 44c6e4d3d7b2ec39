//! Walking in the window: keys, double clicks, and other scenes.

use crate::common::{in_room, said};
use voxtrace::glam::{Vec2, Vec3};
use voxtrace_viewer::input::{Button, Input};
use voxtrace_viewer::keys::{Action, Key, Modifiers};
use voxtrace_viewer::navigation::Mode;
use voxtrace_viewer::session::{Command, Session};

fn pass(session: &mut Session, seconds: f32) {
    for _ in 0..(seconds / 0.02) as usize {
        session.advance(0.02);
    }
}

/// Somebody on the floor of the room, before its block or beside it.
fn walking(x: f32) -> (Session, Input) {
    let mut session = in_room("room.vxt");
    let eye = Vec3::new(x, 3.0, 9.0);
    let camera = voxtrace::Camera { eye, target: eye + Vec3::Y, ..session.navigator.camera().clone() };
    session.move_by(voxtrace_viewer::navigation::Motion::GoTo(camera));
    let mut input = Input::default();
    input.set_modifiers(Modifiers::SHIFT, &mut session);
    input.key(Key::Letter('O'), true, false, &mut session);
    input.set_modifiers(Modifiers::NONE, &mut session);
    session.navigator.walker.eye_height = 3.0;
    pass(&mut session, 2.0);
    (session, input)
}

#[test]
fn shift_o_stands_on_the_floor_and_w_walks_to_the_block_and_no_further() {
    let (mut session, mut input) = walking(12.0);
    assert_eq!(session.navigator.mode, Mode::Walk);
    assert!((session.navigator.camera().eye.z - 4.0).abs() < 1e-3, "{}", session.navigator.camera().eye);
    session.take_commands();
    pass(&mut session, 1.0);
    assert_eq!(session.take_commands(), [], "who stands asks for no new picture");
    input.key(Key::Letter('W'), true, false, &mut session);
    pass(&mut session, 4.0);
    input.key(Key::Letter('W'), false, false, &mut session);
    let eye = session.navigator.camera().eye;
    assert!(eye.y > 8.0 && eye.y < 9.0, "the block begins at 9: {eye}");
    assert_eq!(session.take_commands(), [Command::SetView]);
    session.set_visible(&[0], false);
    session.act(Action::ToggleMode, None);
    assert_eq!(session.navigator.mode, Mode::Fly);
}

#[test]
fn a_double_click_walks_there() {
    let (mut session, mut input) = walking(17.5);
    let target = Vec3::new(19.0, 14.0, 1.0);
    let place = session.projection().place(target);
    let place = place.filter(|at| at.x >= 0.0 && at.y >= 0.0 && at.x < 640.0 && at.y < 480.0);
    let Some(place) = place else { panic!("{target} is in sight: {:?}", session.navigator.camera()) };
    input.move_to(place, &mut session);
    input.press(Button::Left, &mut session);
    input.release(Button::Left, &mut session);
    input.press(Button::Left, &mut session);
    input.double_click(&mut session);
    pass(&mut session, 5.0);
    let eye = session.navigator.camera().eye;
    assert!(eye.truncate().distance(Vec2::new(19.0, 14.0)) < 1.0, "{eye}");
}

#[test]
fn where_nothing_is_to_stand_on_nobody_walks() {
    let mut session = in_room("room.vxt");
    let eye = Vec3::new(500.0, 3.0, 9.0);
    let camera = voxtrace::Camera { eye, target: eye + Vec3::X, ..session.navigator.camera().clone() };
    session.move_by(voxtrace_viewer::navigation::Motion::GoTo(camera));
    session.act(Action::ToggleWalking, None);
    assert_eq!(session.navigator.mode, Mode::Orbit);
    assert!(said(&mut session).iter().any(|line| line.contains("nothing to stand on")));
    session.act(Action::NextCamera, None);
    session.act(Action::ToggleWalking, None);
    assert_eq!(session.navigator.mode, Mode::Walk, "what is in the middle of the picture is a floor");
}
