//! The lens in the window: what the panel chooses and sets, what a key focuses on, and the command that renders the same.

use crate::common::panel::{choose, panels, set};
use crate::common::{SIZE, in_room, said, words};
use egui::accesskit::Role;
use egui_kittest::kittest::Queryable;
use voxtrace::Camera;
use voxtrace::camera::Lens;
use voxtrace::glam::Vec2;
use voxtrace_viewer::keys::Action;
use voxtrace_viewer::lens::LensChoice;
use voxtrace_viewer::panels::Status;
use voxtrace_viewer::session::{Command, Session};

const MIDDLE: Vec2 = Vec2::new(SIZE.0 as f32 * 0.5, SIZE.1 as f32 * 0.5);

fn camera(session: &Session) -> Camera {
    session.navigator.camera().clone()
}

/// What lies in the middle of the picture, from the eye along the view.
fn depth_of_middle(session: &Session) -> f32 {
    camera(session).focus_on(session.pick(MIDDLE).expect("the block is there").point)
}

#[test]
fn each_lens_can_be_chosen_and_has_the_sliders_that_set_it() {
    let mut harness = panels(in_room("room.vxt"), Status::default());
    let expected = [
        ("thin lens", "thin-lens", ["field of view °", "aperture, voxels", "focus, voxels"].as_slice(), "--aperture "),
        ("orthographic", "orthographic", &["height, voxels"], "--projection orthographic --view-height "),
        ("panorama", "panorama", &["eyes apart, voxels"], "--projection panorama"),
        ("fisheye", "fisheye", &["angle °"], "--projection fisheye --fisheye-angle 180"),
        ("isometric", "orthographic", &["height, voxels"], "--projection orthographic --view-height "),
    ];
    for (choice, lens, sliders, option) in expected {
        choose(&mut harness, "lens", choice);
        assert_eq!(camera(harness.state()).lens.name(), lens, "{choice}");
        assert_eq!(harness.state_mut().take_commands(), [Command::SetView], "{choice}");
        for name in ["field of view °", "aperture, voxels", "focus, voxels", "height, voxels", "angle °"] {
            let is_there = harness.query_by_role_and_label(Role::Slider, name).is_some();
            assert_eq!(is_there, sliders.contains(&name), "{choice}: {name}");
        }
        let line = words(harness.state());
        assert!(line.contains(option), "{choice}: {line}");
    }
    choose(&mut harness, "lens", "pinhole");
    assert!(!words(harness.state()).contains("--projection"));
}

#[test]
fn a_slider_sets_the_lens_and_blades_are_chosen_from_a_box() {
    let mut session = in_room("room.vxt");
    session.choose_lens(LensChoice::ThinLens);
    let mut harness = panels(session, Status::default());
    choose(&mut harness, "diaphragm", "6 blades");
    let Lens::Thin { aperture, blades: 6, .. } = camera(harness.state()).lens else { panic!("six blades") };
    set(&mut harness, "turned °", 30.0);
    set(&mut harness, "aperture, voxels", 1.5);
    let lens = camera(harness.state()).lens;
    assert!(matches!(lens, Lens::Thin { aperture: 1.5, blades: 6, blade_rotation: 30.0, .. }), "{lens:?} {aperture}");
    let line = words(harness.state());
    assert!(line.contains("--aperture 1.5 ") && line.contains("--blades 6 --blade-rotation 30"), "{line}");
    // What was set is there again when the lens is chosen again, in focus where one looks.
    choose(&mut harness, "lens", "fisheye");
    choose(&mut harness, "lens", "thin lens");
    assert!(matches!(camera(harness.state()).lens, Lens::Thin { aperture: 1.5, blades: 6, .. }));
}

#[test]
fn another_lens_shows_the_middle_as_large_and_the_way_back_leads_home() {
    let mut session = in_room("room.vxt");
    let (home, depth) = (camera(&session), depth_of_middle(&session));
    session.choose_lens(LensChoice::Orthographic);
    let Lens::Orthographic { view_height } = camera(&session).lens else { panic!("{:?}", camera(&session)) };
    let expected = 2.0 * depth * (0.5 * home.fov_y.to_radians()).tan();
    assert!((view_height - expected).abs() < 1e-3 * expected, "{view_height} {expected}");
    session.choose_lens(LensChoice::Pinhole);
    assert!(camera(&session).eye.distance(home.eye) < 1e-3 * depth, "{:?}", camera(&session));
    // Zoomed meanwhile, it is nearer afterwards.
    session.choose_lens(LensChoice::Orthographic);
    session.widen(-20.0);
    session.choose_lens(LensChoice::Pinhole);
    let nearer = depth_of_middle(&session);
    assert!((nearer - 0.5 * depth).abs() < 0.01 * depth, "{nearer} {depth}");
}

#[test]
fn focusing_on_what_is_under_the_cursor_makes_a_thin_lens_that_is_sharp_there() {
    let mut session = in_room("room.vxt");
    let far = Vec2::new(MIDDLE.x, MIDDLE.y - 60.0);
    for cursor in [MIDDLE, far] {
        let point = session.pick(cursor).expect("there is something").point;
        session.act(Action::FocusHere, Some(cursor));
        let now = camera(&session);
        let Lens::Thin { focus, .. } = now.lens else { panic!("{now:?}") };
        assert!((focus - now.focus_on(point)).abs() < 1e-3, "{focus}");
        assert_eq!(now.eye, camera(&in_room("room.vxt")).eye, "the camera stays");
    }
    assert_ne!(session.pick(MIDDLE).unwrap().point, session.pick(far).unwrap().point, "the comparison sees the place");
    session.take_commands();
    session.act(Action::FocusHere, Some(Vec2::new(2.0, 2.0)));
    assert_eq!((session.take_commands(), said(&mut session)), (vec![], vec!["there is nothing to focus on".into()]));
    session.choose_lens(LensChoice::Fisheye);
    session.act(Action::FocusHere, Some(MIDDLE));
    assert!(said(&mut session).iter().any(|line| line.contains("no focus")));
}

#[test]
fn the_button_focuses_on_the_middle_or_on_what_was_picked() {
    let mut harness = panels(in_room("room.vxt"), Status::default());
    for (pick, button) in [(None, "focus on the middle"), (Some(Vec2::new(320.0, 180.0)), "focus on the picked voxel")]
    {
        harness.state_mut().act(Action::Pick, pick);
        harness.run_steps(3);
        harness.get_by_role_and_label(Role::Button, button).click();
        harness.run_steps(3);
        let now = camera(harness.state());
        let point = harness.state().pick(pick.unwrap_or(MIDDLE)).unwrap().point;
        assert!(matches!(now.lens, Lens::Thin { focus, .. } if (focus - now.focus_on(point)).abs() < 1e-3), "{now:?}");
    }
}
