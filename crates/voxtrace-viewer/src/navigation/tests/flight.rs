//! Flight: what is held, how the view turns, and the horizon.

use super::*;
use voxtrace::glam::DVec3;

fn level() -> Navigator {
    at(Camera::look_at(Vec3::new(0.0, -100.0, 20.0), Vec3::new(0.0, 0.0, 20.0)))
}

fn way(navigator: &mut Navigator, seconds: f32) -> Vec3 {
    let before = navigator.camera().eye;
    navigator.advance(seconds);
    navigator.camera().eye - before
}

#[test]
fn held_keys_move_by_the_speed_times_the_time() {
    let mut navigator = level();
    assert!((navigator.speed() - (BOUNDS.1 - BOUNDS.0).length() / 8.0).abs() < 1e-3, "by the size of the scene");
    let step = navigator.speed() * 0.1;
    let expected = [
        (Movement::Forward, Vec3::Y),
        (Movement::Back, Vec3::NEG_Y),
        (Movement::Left, Vec3::NEG_X),
        (Movement::Right, Vec3::X),
        (Movement::Up, Vec3::Z),
        (Movement::Down, Vec3::NEG_Z),
    ];
    for (movement, direction) in expected {
        navigator.held.set(movement, true);
        assert!(navigator.held.is_moving());
        let moved = way(&mut navigator, 0.1);
        assert!(moved.distance(direction * step) < 1e-3, "{movement:?} {moved}");
        navigator.held.is_fast = true;
        assert!((way(&mut navigator, 0.1).length() / step - 4.0).abs() < 1e-3);
        (navigator.held.is_fast, navigator.held.is_slow) = (false, true);
        assert!((way(&mut navigator, 0.1).length() / step - 0.25).abs() < 1e-3);
        navigator.held.clear();
        assert!(!navigator.held.is_moving() && !navigator.advance(0.1));
    }
}

#[test]
fn opposite_keys_cancel_and_diagonals_are_no_quicker() {
    let mut navigator = level();
    navigator.held.set(Movement::Left, true);
    navigator.held.set(Movement::Right, true);
    assert!(!navigator.advance(0.1));
    navigator.held.set(Movement::Left, false);
    navigator.held.set(Movement::Forward, true);
    let step = navigator.speed() * 0.1;
    assert!((way(&mut navigator, 0.1).length() / step - 1.0).abs() < 1e-3);
    navigator.held.clear();
    navigator.held.stick = Vec3::new(0.0, 0.5, 0.0);
    assert!(way(&mut navigator, 0.1).distance(Vec3::Y * step * 0.5) < 1e-3, "a stick goes slower too");
}

#[test]
fn a_program_that_slept_does_not_jump_and_time_does_not_run_backwards() {
    let mut navigator = level();
    navigator.held.set(Movement::Forward, true);
    assert!(way(&mut navigator, 3600.0).length() <= navigator.speed() * 0.2501);
    for seconds in [0.0, -1.0, f32::NAN, f32::NEG_INFINITY] {
        assert_eq!(way(&mut navigator, seconds), Vec3::ZERO);
    }
}

#[test]
fn many_small_steps_go_as_far_as_one_large_one() {
    // Each is less than what single precision resolves there.
    let eye = Vec3::new(1e6, 1e6, 10.0);
    let mut navigator = Navigator::new(Camera::look_at(eye, eye + Vec3::Y), Some((Vec3::ZERO, eye)));
    navigator.held.set(Movement::Forward, true);
    let seconds = 0.01 / navigator.speed();
    for _ in 0..1000 {
        navigator.advance(seconds);
    }
    let moved = navigator.camera().eye - eye;
    assert!((moved.y - 10.0).abs() < 0.1, "{moved}");
    assert_eq!(eye.y + 0.01, eye.y, "the steps are that small");
}

#[test]
fn the_view_follows_the_mouse_and_can_be_inverted() {
    let mut navigator = level();
    navigator.apply(Motion::Look(Vec2::new(50.0, 0.0)));
    assert!(forward(&navigator).x > 0.01);
    navigator.apply(Motion::Look(Vec2::new(0.0, -50.0)));
    let up = forward(&navigator).z;
    assert!(up > 0.01);
    navigator.is_inverted = true;
    navigator.apply(Motion::Look(Vec2::new(0.0, -20.0)));
    assert!(forward(&navigator).z < up);
    navigator.held.set(Movement::TurnRight, true);
    let right = forward(&navigator).x;
    navigator.advance(0.1);
    assert!(forward(&navigator).x > right + 0.01);
}

/// How far the picture's right-hand side leaves the horizon.
fn roll(camera: &Camera, horizon: Vec3) -> f64 {
    let frame = (camera.target - camera.eye).as_dvec3().normalize();
    frame.cross(camera.up.as_dvec3()).normalize().dot(horizon.as_dvec3()).abs()
}

#[test]
fn the_horizon_stays_level_and_the_view_short_of_the_poles() {
    let mut random = Random(7);
    for up in [Vec3::Z, Vec3::Y, Vec3::new(0.2, -0.3, 0.8)] {
        let mut navigator = at(Camera { up, ..Camera::look_at(Vec3::new(3.0, -90.0, 9.0), Vec3::ZERO) });
        let horizon = up.normalize();
        for _ in 0..2000 {
            let delta = Vec2::new(random.within(-900.0, 900.0), random.within(-900.0, 900.0));
            match random.next() % 2 {
                0 => navigator.apply(Motion::Look(delta)),
                _ => navigator.apply(Motion::Orbit { delta, pivot: Some(Vec3::ONE) }),
            };
            let camera = navigator.camera();
            assert_eq!(camera.up, up, "it stays as it came");
            assert!(roll(camera, horizon) < 1e-6);
            let sine = (camera.target - camera.eye).normalize().dot(horizon).abs();
            assert!(sine < 89.95_f32.to_radians().sin(), "{sine}");
        }
        let rolled = Camera { up: up + Vec3::new(0.1, 0.1, 0.0), ..navigator.camera().clone() };
        assert!(roll(&rolled, horizon) > 1e-3, "the comparison sees a roll");
        let direction = forward(&navigator);
        navigator.apply(Motion::Level);
        assert_eq!(navigator.camera().up, Vec3::Z);
        assert!(forward(&navigator).distance(direction) < 0.01);
    }
}

#[test]
fn a_camera_that_looks_along_its_up_keeps_its_picture_while_it_pans() {
    for target in [Vec3::new(20.0, 20.0, 0.0), Vec3::new(20.0, 20.0, 200.0)] {
        let given = Camera::look_at(Vec3::new(20.0, 20.0, 100.0), target);
        let right = |camera: &Camera| {
            let navigator = at(camera.clone());
            let middle = HEIGHT as f32 / 2.0;
            let [left, right] = [0.0, WIDTH as f32].map(|x| navigator.ray(Vec2::new(x, middle)).direction);
            (right - left).normalize()
        };
        let mut navigator = at(given.clone());
        let (from, to) = (Vec2::new(640.0, 360.0), Vec2::new(700.0, 330.0));
        assert!(navigator.apply(Motion::Pan { from, to, anchor: Some(target) }));
        assert!(right(navigator.camera()).distance(right(&given)) < 1e-4);
        assert!(pixel_of(navigator.camera(), target).distance(to) < 0.1);
        navigator.apply(Motion::Look(Vec2::new(0.0, if target.z > 100.0 { 90.0 } else { -90.0 })));
        assert!(navigator.camera().up == Vec3::Z && forward(&navigator).z.abs() < 0.999);
    }
}

#[test]
fn directions_stay_fine_far_from_the_origin() {
    let eye = DVec3::new(40_000.0, 30_000.0, 0.0).as_vec3();
    let mut navigator = at(Camera::look_at(eye, eye + Vec3::Y * 0.01));
    navigator.apply(Motion::Look(Vec2::new(300.0, 0.0)));
    let mut last = forward(&navigator);
    for _ in 0..50 {
        navigator.apply(Motion::Look(Vec2::new(1.0, 0.0)));
        let now = forward(&navigator);
        let degrees = last.angle_between(now).to_degrees();
        assert!((degrees - 0.125).abs() < 0.02, "{degrees}");
        last = now;
    }
}

#[test]
fn the_field_of_view_and_the_speed_have_their_limits() {
    let mut navigator = level();
    assert!(navigator.apply(Motion::FieldOfView(90.0)));
    assert_eq!(navigator.camera().fov_y, 90.0);
    for (degrees, expected) in [(0.0, 1.0), (500.0, 170.0)] {
        navigator.apply(Motion::FieldOfView(degrees));
        assert_eq!(navigator.camera().fov_y, expected);
    }
    let speed = navigator.speed();
    navigator.apply(Motion::Speed(2.0));
    assert!((navigator.speed() / speed - 1.5625).abs() < 1e-4);
    for _ in 0..1000 {
        navigator.apply(Motion::Speed(-20.0));
    }
    assert!(navigator.speed() > 0.0 && navigator.speed() < 0.01);
}
