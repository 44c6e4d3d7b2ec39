//! Undo and redo of the camera.

use super::*;

fn drag(navigator: &mut Navigator) -> Camera {
    navigator.begin_gesture();
    for _ in 0..30 {
        navigator.apply(Motion::Look(Vec2::new(5.0, 1.0)));
    }
    navigator.end_gesture();
    navigator.camera().clone()
}

#[test]
fn undo_takes_back_one_gesture_and_redo_brings_it_back_to_the_bit() {
    let mut navigator = at(Camera::look_at(Vec3::new(0.1, -90.3, 9.7), Vec3::ZERO));
    let start = navigator.camera().clone();
    let dragged = drag(&mut navigator);
    assert!(navigator.apply(Motion::View(AxisView::Top)));
    let top = navigator.camera().clone();
    assert!(navigator.apply(Motion::GoTo(Camera::look_at(Vec3::ONE, Vec3::ZERO))));
    for expected in [&top, &dragged, &start] {
        assert!(navigator.can_undo() && navigator.undo());
        assert_eq!(navigator.camera(), expected);
    }
    assert!(!navigator.can_undo() && !navigator.undo());
    for expected in [&dragged, &top] {
        assert!(navigator.redo());
        assert_eq!(navigator.camera(), expected);
    }
    let after = drag(&mut navigator);
    assert!(!navigator.can_redo() && !navigator.redo());
    assert_eq!(navigator.camera(), &after);
}

#[test]
fn a_flight_is_one_entry_until_it_rests() {
    let mut navigator = at(Camera::look_at(Vec3::new(0.0, -90.0, 9.0), Vec3::ZERO));
    let start = navigator.camera().clone();
    let fly = |navigator: &mut Navigator, rest: usize| {
        navigator.held.set(Movement::Forward, true);
        for _ in 0..60 {
            navigator.advance(1.0 / 60.0);
        }
        navigator.held.clear();
        for _ in 0..rest {
            navigator.advance(1.0 / 60.0);
        }
        navigator.camera().clone()
    };
    fly(&mut navigator, 20);
    let rested = fly(&mut navigator, 40);
    fly(&mut navigator, 0);
    navigator.undo();
    assert_eq!(navigator.camera(), &rested);
    navigator.undo();
    assert_eq!(navigator.camera(), &start, "a third of a second is no rest");
}

#[test]
fn steps_that_are_whole_do_not_join_the_gesture_before_them() {
    let mut navigator = at(Camera::look_at(Vec3::new(0.0, -90.0, 9.0), Vec3::ZERO));
    navigator.apply(Motion::Zoom { cursor: Vec2::ZERO, distance: Some(50.0), steps: 1.0 });
    let zoomed = navigator.camera().clone();
    navigator.apply(Motion::FrameAll);
    navigator.undo();
    assert_eq!(navigator.camera(), &zoomed);
}

#[test]
fn another_scene_starts_with_an_empty_history() {
    let mut navigator = at(Camera::look_at(Vec3::new(0.0, -90.0, 9.0), Vec3::ZERO));
    navigator.mode = Mode::Fly;
    drag(&mut navigator);
    let other = navigator.in_scene(Camera::look_at(Vec3::ONE, Vec3::ZERO), Some((Vec3::ZERO, Vec3::splat(1e4))));
    assert!(navigator.can_undo() && !other.can_undo());
    assert_eq!(other.mode, Mode::Fly);
    assert!(other.speed() > 10.0 * navigator.speed());
    let replaced = navigator.in_scene(Camera::look_at(Vec3::ONE, Vec3::ONE), None);
    assert!(is_usable(replaced.camera()) && !replaced.can_undo());
}
