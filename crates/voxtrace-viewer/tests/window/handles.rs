//! Handles of the clip box and of the slice: dragged in the picture, as a hand does it.

use crate::common::{in_room, lit, words};
use voxtrace::glam::{Vec2, Vec3};
use voxtrace_viewer::clipping::{Grip, Of};
use voxtrace_viewer::cutting::{Cutting, Slice};
use voxtrace_viewer::input::{Button, Input};
use voxtrace_viewer::keys::{Key, Modifiers};
use voxtrace_viewer::session::{Command, Session};

fn drag(session: &mut Session, input: &mut Input, from: Vec2, to: Vec2) {
    input.move_to(from, session);
    input.press(Button::Left, session);
    input.move_to(from.midpoint(to), session);
    input.move_to(to, session);
    input.release(Button::Left, session);
}

fn place(session: &Session, of: Of, grip: Grip) -> Vec2 {
    let handle = session.handles().into_iter().find(|handle| handle.of == of && handle.grip == grip).unwrap();
    session.projection().place(handle.place).unwrap()
}

#[test]
fn a_side_of_the_box_is_dragged_along_its_axis_and_the_camera_stays() {
    let mut session = in_room("room.vxt");
    let mut input = Input::default();
    input.set_modifiers(Modifiers::SHIFT, &mut session);
    input.key(Key::Letter('B'), true, false, &mut session);
    input.set_modifiers(Modifiers::NONE, &mut session);
    assert_eq!(session.render_settings.cutting.clip_box, session.whole_box());
    assert_eq!(session.handles().len(), 7);
    session.take_commands();
    let camera = session.navigator.camera().clone();
    let upper_x = Grip::Side { axis: 0, is_upper: true };
    let from = place(&session, Of::Box, upper_x);
    // To where the axis through the side is at x = 15.
    let to = session.projection().place(Vec3::new(15.0, 12.0, 3.5)).unwrap();
    drag(&mut session, &mut input, from, to);
    let [min, max] = session.render_settings.cutting.clip_box.unwrap();
    assert_eq!((min, max), (Vec3::ZERO, Vec3::new(15.0, 24.0, 7.0)));
    assert_eq!((session.take_commands(), session.navigator.camera()), (vec![Command::SetScene], &camera));
    assert!(words(&session).contains("--clip-box 0,0,0,15,24,7"), "{}", words(&session));
    assert_eq!(lit(&session).cuts.planes().len(), 6);
    assert_eq!(session.picked, None, "a drag is no click");
    drag(&mut session, &mut input, from, to);
    assert_ne!(session.navigator.camera(), &camera, "where no handle is, dragging goes around");
}

#[test]
fn the_middle_moves_the_box_and_shift_goes_between_voxels() {
    let mut session = in_room("room.vxt");
    let mut input = Input::default();
    let small = [Vec3::new(8.0, 8.0, 1.0), Vec3::new(12.0, 12.0, 5.0)];
    session.set_cutting(Cutting { clip_box: Some(small), ..Cutting::default() });
    let from = place(&session, Of::Box, Grip::Middle);
    // The camera looks along +y: a drag to the right is along x.
    let to = session.projection().place(Vec3::new(13.3, 10.0, 3.0)).unwrap();
    drag(&mut session, &mut input, from, to);
    let [min, max] = session.render_settings.cutting.clip_box.unwrap();
    assert_eq!((min, max), (Vec3::new(11.0, 8.0, 1.0), Vec3::new(15.0, 12.0, 5.0)));
    session.set_cutting(Cutting { clip_box: Some(small), ..Cutting::default() });
    input.set_modifiers(Modifiers::SHIFT, &mut session);
    drag(&mut session, &mut input, from, to);
    let [min, _] = session.render_settings.cutting.clip_box.unwrap();
    assert!((min.x - 11.3).abs() < 0.05, "{min}");
}

#[test]
fn a_slice_is_dragged_through_the_scene_and_handles_can_be_hidden() {
    let mut session = in_room("room.vxt");
    let mut input = Input::default();
    let slice = Some(Slice { axis: 0, from: 4.0, thickness: 4.0 });
    session.set_cutting(Cutting { slice, ..Cutting::default() });
    let grips: Vec<Grip> = session.handles().iter().map(|handle| handle.grip).collect();
    assert_eq!(grips.len(), 3, "two sides and the middle: {grips:?}");
    let from = place(&session, Of::Slice, Grip::Middle);
    let to = session.projection().place(Vec3::new(16.0, 12.0, 3.5)).unwrap();
    drag(&mut session, &mut input, from, to);
    assert_eq!(session.render_settings.cutting.slice, Some(Slice { axis: 0, from: 14.0, thickness: 4.0 }));
    session.clipping.has_handles = false;
    assert!(session.handles().is_empty() && session.handle_at(to).is_none());
}
