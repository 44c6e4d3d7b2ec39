//! Editing with a hand: scripts of events, and what becomes of the scene.

use crate::common::hand::{differing, floor, in_the_room};
use crate::common::said;
use voxtrace::glam::{IVec3, Vec2, Vec3};
use voxtrace::grid::VoxelBox;
use voxtrace_viewer::editing::{Act, Tool};
use voxtrace_viewer::input::Button;
use voxtrace_viewer::keys::{Action, EditAction, EditAxis, Key, Modifiers};

#[test]
fn a_click_places_a_voxel_on_the_face_under_the_cursor_and_undo_takes_it_back() {
    let mut hand = in_the_room();
    assert!(hand.asked.is_empty(), "the scene as it was is the one that is edited: {:?}", hand.asked);
    let before = hand.voxels();
    hand.take_material(1);
    hand.click(floor(3, 4));
    hand.steps(1, 0);
    assert_eq!(differing(&before, &hand.voxels()), [IVec3::new(3, 4, 1)]);
    assert_eq!(hand.material_at(IVec3::new(3, 4, 1)), Some(1));
    assert_eq!((hand.patches.len(), hand.session.has_unsaved_edits()), (1, true));
    hand.ctrl('Z');
    hand.steps(0, 1);
    assert_eq!(differing(&before, &hand.voxels()), []);
    assert!(!hand.session.has_unsaved_edits(), "it is as it was");
    hand.key(Modifiers::CTRL_SHIFT, Key::Letter('Z'));
    hand.steps(1, 0);
    assert_eq!(hand.material_at(IVec3::new(3, 4, 1)), Some(1));
    // The camera's undo is its own.
    let camera = hand.session.navigator.camera().clone();
    hand.key(Modifiers::ALT, Key::Left);
    assert_eq!(hand.session.navigator.camera(), &camera);
    assert!(hand.session.editing.as_ref().unwrap().steps.done.len() == 1);
}

#[test]
fn a_stroke_follows_the_surface_that_there_was_and_is_one_step() {
    let mut hand = in_the_room();
    let before = hand.voxels();
    hand.drag(&[floor(2, 3), floor(6, 3), floor(20, 3)]);
    hand.steps(1, 0);
    hand.settle();
    let expected: Vec<IVec3> = (2..=20).map(|x| IVec3::new(x, 3, 1)).collect();
    assert_eq!(differing(&before, &hand.voxels()), expected, "no gap, and nothing grows towards the eye");
    assert_eq!(hand.session.editing.as_ref().unwrap().steps.done[0].voxels, 19);
    // Erasing does not dig deeper either.
    hand.key(Modifiers::NONE, Key::Digit(2));
    hand.drag(&[floor(2, 6), floor(20, 6)]);
    hand.steps(2, 0);
    hand.settle();
    let gone = differing(&before, &hand.voxels()).into_iter().filter(|voxel| voxel.z == 0).count();
    assert_eq!(gone, 19);
    hand.ctrl('Z');
    hand.ctrl('Z');
    hand.steps(0, 2);
    assert_eq!(differing(&before, &hand.voxels()), []);
}

#[test]
fn each_tool_does_what_it_says() {
    let mut hand = in_the_room();
    let before = hand.voxels();
    // Paint with a ball, which leaves empty voxels empty.
    hand.take_material(1);
    hand.key(Modifiers::NONE, Key::Digit(3));
    (0..4).for_each(|_| hand.key(Modifiers::NONE, Key::Plus));
    assert_eq!(hand.session.editing.as_ref().unwrap().brush.size, 5);
    hand.click(floor(4, 4));
    hand.steps(1, 0);
    let painted = differing(&before, &hand.voxels());
    assert!(painted.len() == 21 && painted.iter().all(|voxel| voxel.z == 0), "{painted:?}");
    // A box, made deeper by the wheel.
    hand.key(Modifiers::NONE, Key::Digit(1));
    hand.key(Modifiers::NONE, Key::Digit(6));
    let before = hand.voxels();
    let places = [hand.place(floor(1, 18)), hand.place(floor(4, 20))];
    hand.input.move_to(places[0], &mut hand.session);
    hand.input.press(Button::Left, &mut hand.session);
    hand.input.move_to(places[1], &mut hand.session);
    hand.input.wheel(1.0, &mut hand.session);
    hand.input.wheel(1.0, &mut hand.session);
    hand.input.release(Button::Left, &mut hand.session);
    hand.steps(2, 0);
    let block = differing(&before, &hand.voxels());
    assert_eq!(block.len(), 4 * 3 * 3);
    assert!(
        block.iter().all(|voxel| VoxelBox { min: IVec3::new(1, 18, 1), max: IVec3::new(5, 21, 4) }.contains(*voxel))
    );
    // Pull the upper face of the red block by the mouse, then push it back.
    let before = hand.voxels();
    hand.key(Modifiers::NONE, Key::Digit(7));
    let top = Vec3::new(12.2, 12.2, 7.0);
    hand.drag(&[top, top + Vec3::Z * 2.0, top + Vec3::Z * 4.0]);
    hand.steps(3, 0);
    assert_eq!(differing(&before, &hand.voxels()).len(), 36 * 4);
    let top = top + Vec3::Z * 4.0;
    hand.drag(&[top, top - Vec3::Z * 4.0]);
    hand.steps(4, 0);
    assert_eq!(differing(&before, &hand.voxels()), []);
    // Fill what is connected: the floor but for the painted disc.
    hand.take_material(1);
    hand.key(Modifiers::NONE, Key::Digit(8));
    hand.click(floor(20, 2));
    hand.steps(5, 0);
    assert!(hand.voxels().voxels().filter(|(voxel, _)| voxel.z == 0).all(|(_, material)| material == 1));
    hand.ctrl('Z');
    hand.steps(4, 1);
    // Beside a box that is selected nothing is filled, and it is said why.
    hand.key(Modifiers::NONE, Key::Digit(0));
    hand.drag(&[floor(2, 2), floor(4, 4)]);
    hand.key(Modifiers::NONE, Key::Digit(8));
    hand.click(floor(20, 2));
    assert!(said(&mut hand.session).iter().any(|line| line.contains("inside of what is selected")));
    hand.session.editing.as_mut().unwrap().selection = None;
    hand.steps(4, 1);
    // Replace one material everywhere, and erase one.
    hand.take_material(0);
    hand.key(Modifiers::NONE, Key::Digit(9));
    hand.click(floor(4, 4));
    hand.steps(5, 0);
    assert!(hand.voxels().voxels().all(|(_, material)| material == 0));
    hand.session.editing.as_mut().unwrap().act = Act::Erase;
    hand.click(floor(4, 4));
    hand.steps(6, 0);
    assert_eq!(hand.voxels().voxels().count(), 0);
    hand.ctrl('Z');
    hand.steps(5, 1);
    // A line of one voxel between two places.
    let before = hand.voxels();
    hand.session.editing.as_mut().unwrap().brush.size = 1;
    hand.key(Modifiers::NONE, Key::Digit(1));
    hand.key(Modifiers::NONE, Key::Digit(5));
    hand.drag(&[floor(14, 2), floor(22, 6)]);
    hand.steps(6, 0);
    let line = differing(&before, &hand.voxels());
    assert_eq!((line.len(), line[0], line[8]), (9, IVec3::new(14, 2, 1), IVec3::new(22, 6, 1)));
    // What is under the cursor is the material from now on.
    hand.input.set_modifiers(Modifiers::ALT, &mut hand.session);
    hand.take_material(1);
    hand.click(floor(20, 2));
    assert_eq!(hand.session.editing.as_ref().unwrap().material, 0);
    assert_eq!(said(&mut hand.session).iter().filter(|line| line.contains("error")).count(), 0);
}

#[test]
fn both_sides_of_the_planes_are_edited_in_one_step() {
    let mut hand = in_the_room();
    let before = hand.voxels();
    hand.session.editing.as_mut().unwrap().symmetry.axes = [true, true, false];
    hand.drag(&[floor(3, 2), floor(5, 2)]);
    hand.steps(1, 0);
    hand.settle();
    let placed = differing(&before, &hand.voxels());
    assert_eq!(placed.len(), 12, "through the middle of the model: {placed:?}");
    for voxel in &placed {
        assert!(
            placed.contains(&IVec3::new(23 - voxel.x, voxel.y, 1))
                && placed.contains(&IVec3::new(voxel.x, 23 - voxel.y, 1))
        );
    }
    hand.ctrl('Z');
    hand.steps(0, 1);
    // Through a voxel that was picked.
    hand.session.editing.as_mut().unwrap().symmetry.axes = [true, false, false];
    hand.session.editing.as_mut().unwrap().picks_middle = true;
    hand.click(floor(6, 2));
    hand.steps(0, 1);
    hand.click(floor(8, 2));
    hand.steps(1, 0);
    assert_eq!(differing(&before, &hand.voxels()), [IVec3::new(4, 2, 1), IVec3::new(8, 2, 1)]);
}

#[test]
fn what_is_selected_is_copied_turned_pasted_moved_and_cleared() {
    let mut hand = in_the_room();
    hand.key(Modifiers::NONE, Key::Digit(6));
    hand.take_material(1);
    hand.drag(&[floor(2, 2), floor(4, 2)]);
    hand.steps(1, 0);
    let before = hand.voxels();
    hand.key(Modifiers::NONE, Key::Digit(0));
    let row = |x: i32| Vec3::new(x as f32 + 0.5, 2.5, 2.0);
    hand.drag(&[row(2), row(4)]);
    let selection = hand.session.editing.as_ref().unwrap().selection.unwrap();
    assert_eq!(selection.region, VoxelBox { min: IVec3::new(2, 2, 1), max: IVec3::new(5, 3, 2) });
    hand.ctrl('C');
    hand.until("a copy", |session| session.editing.as_ref().unwrap().clip.is_some());
    hand.ctrl('V');
    hand.key(Modifiers::NONE, Key::Letter('R'));
    hand.until("a turn", |session| {
        session.editing.as_ref().unwrap().clip.as_ref().unwrap().size() == IVec3::new(1, 3, 1)
    });
    hand.click(floor(8, 5));
    hand.steps(2, 0);
    let pasted: Vec<IVec3> = (4..7).map(|y| IVec3::new(8, y, 1)).collect();
    assert_eq!(differing(&before, &hand.voxels()), pasted);
    hand.click(floor(20, 5));
    hand.steps(3, 0);
    hand.key(Modifiers::NONE, Key::Escape);
    assert!(hand.session.editing.as_ref().unwrap().pasting.is_none() && hand.session.is_editing());
    // Moved: gone there, and here, as one step.
    let before = hand.voxels();
    hand.letter('G');
    hand.until("a move", |session| session.editing.as_ref().unwrap().pasting.is_some());
    hand.click(floor(18, 20));
    hand.steps(4, 0);
    let moved: Vec<IVec3> = (2..5).map(|x| IVec3::new(x, 2, 1)).chain((17..20).map(|x| IVec3::new(x, 20, 1))).collect();
    assert_eq!(differing(&before, &hand.voxels()), moved);
    hand.ctrl('Z');
    hand.steps(3, 1);
    assert_eq!(differing(&before, &hand.voxels()), []);
    hand.session.editing.as_mut().unwrap().selection = Some(selection);
    hand.key(Modifiers::NONE, Key::Delete);
    hand.steps(4, 0);
    assert_eq!(differing(&before, &hand.voxels()).len(), 3);
}

#[test]
fn in_the_sky_the_hand_moves_the_camera_and_the_right_button_always_does() {
    let mut hand = in_the_room();
    hand.letter('O');
    let mut camera = hand.session.navigator.camera().clone();
    for (button, from) in [(Button::Left, Vec2::new(10.0, 4.0)), (Button::Right, Vec2::new(320.0, 240.0))] {
        hand.input.move_to(from, &mut hand.session);
        hand.input.press(button, &mut hand.session);
        hand.input.move_to(from + Vec2::new(60.0, 20.0), &mut hand.session);
        hand.input.release(button, &mut hand.session);
        let now = hand.session.navigator.camera().clone();
        assert_ne!(now, camera);
        camera = now;
    }
    hand.settle();
    assert_eq!(hand.session.editing.as_ref().unwrap().steps.done.len(), 0);
    hand.key(Modifiers::NONE, Key::Escape);
    assert!(!hand.session.is_editing());
    assert_eq!(said(&mut hand.session).last().unwrap(), "editing ended; Ctrl+E edits again");
    // Outside of editing a click picks, and Ctrl+Z is the camera's.
    hand.click(floor(3, 4));
    assert!(hand.session.picked.is_some());
    hand.ctrl('Z');
    assert_ne!(hand.session.navigator.camera(), &camera);
}

#[test]
fn esc_gives_up_a_box_and_the_tool_keys_choose() {
    let mut hand = in_the_room();
    let tools =
        [(4, Tool::Brush), (5, Tool::Line), (6, Tool::Box), (7, Tool::Extrude), (8, Tool::Fill), (9, Tool::Replace)];
    for (digit, tool) in tools {
        hand.key(Modifiers::NONE, Key::Digit(digit));
        assert_eq!(hand.session.editing.as_ref().unwrap().tool, tool);
    }
    hand.key(Modifiers::NONE, Key::Digit(6));
    let places = [hand.place(floor(1, 18)), hand.place(floor(4, 20))];
    hand.input.move_to(places[0], &mut hand.session);
    hand.input.press(Button::Left, &mut hand.session);
    hand.input.move_to(places[1], &mut hand.session);
    hand.key(Modifiers::NONE, Key::Escape);
    hand.input.release(Button::Left, &mut hand.session);
    hand.settle();
    assert_eq!((hand.session.editing.as_ref().unwrap().steps.done.len(), hand.session.is_editing()), (0, true));
    // Turning what is not there says so.
    hand.session.act(Action::Edit(EditAction::Turn(EditAxis::Z)), None);
    assert!(said(&mut hand.session).last().unwrap().contains("nothing is being pasted"));
}

#[test]
fn no_key_of_editing_does_two_things_and_each_does_what_its_table_says() {
    use voxtrace_viewer::keys::{EDIT_TABLE, Trigger, edit_action_of, edit_action_of_gesture, markdown};
    use voxtrace_viewer::navigation::Mode;
    for (index, binding) in EDIT_TABLE.iter().enumerate() {
        for trigger in binding.triggers {
            let is_alone = |other: &voxtrace_viewer::keys::Binding| !other.triggers.contains(trigger);
            assert!(EDIT_TABLE[index + 1..].iter().all(is_alone), "{trigger:?} stands twice");
            let action = match *trigger {
                Trigger::Key(chord) => edit_action_of(chord, false),
                Trigger::Gesture(gesture, modifiers, mode) => {
                    edit_action_of_gesture(gesture, modifiers, mode.unwrap_or(Mode::Fly))
                }
                Trigger::Digits(_) => None,
            };
            assert_eq!(action, Some(binding.action), "{trigger:?}");
        }
        assert!(markdown().contains(voxtrace_viewer::strings::text(binding.about)));
    }
    // In flight what is held beside a key means the speed.
    let undo = voxtrace_viewer::keys::Chord { key: Key::Letter('Z'), modifiers: Modifiers::CTRL };
    assert_eq!(edit_action_of(undo, true), None);
}
