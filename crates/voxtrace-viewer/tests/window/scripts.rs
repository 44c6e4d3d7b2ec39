//! Scripts of a user's hands: events in, commands out, without a window or a device.

use crate::common::{SIZE, in_room, packed, said};
use voxtrace::Integrator;
use voxtrace::glam::{Vec2, Vec3};
use voxtrace_viewer::engine::{Backend, Pause};
use voxtrace_viewer::input::{Button, Input};
use voxtrace_viewer::keys::{Action, Key, Modifiers};
use voxtrace_viewer::navigation::Mode;
use voxtrace_viewer::render_command::SunSetting;
use voxtrace_viewer::render_settings::RenderSettings;
use voxtrace_viewer::session::{Command, Session};
use voxtrace_vulkan::{Primitive, Settings, Traversal};

const MIDDLE: Vec2 = Vec2::new(320.0, 240.0);
/// A place in the sky.
const SKY: Vec2 = Vec2::new(10.0, 4.0);

fn hands(session: &mut Session, cursor: Vec2) -> Input {
    let mut input = Input::default();
    input.move_to(cursor, session);
    input
}

fn tap(input: &mut Input, key: Key, session: &mut Session) {
    input.key(key, true, false, session);
    input.key(key, false, false, session);
}

fn click(input: &mut Input, session: &mut Session) {
    input.press(Button::Left, session);
    input.release(Button::Left, session);
}

/// The pixel at which the picture shows a point.
fn pixel_of(session: &Session, point: Vec3) -> Vec2 {
    let camera = session.navigator.camera();
    let forward = (camera.target - camera.eye).normalize();
    let right = forward.cross(camera.up).normalize();
    let offset = point - camera.eye;
    let half = (camera.fov_y.to_radians() / 2.0).tan() * offset.dot(forward);
    let (width, height) = (SIZE.0 as f32, SIZE.1 as f32);
    let place = Vec2::new(offset.dot(right), -offset.dot(right.cross(forward))) / half * height;
    (place + Vec2::new(width, height)) * 0.5
}

#[test]
fn a_drag_orbits_around_what_was_under_the_cursor_and_is_one_step_back() {
    let mut session = in_room("room.vxt");
    let before = session.navigator.camera().clone();
    let mut input = hands(&mut session, MIDDLE);
    let held = session.pick(MIDDLE).unwrap().point;
    input.press(Button::Left, &mut session);
    input.move_to(MIDDLE + Vec2::new(2.0, 1.0), &mut session);
    assert_eq!(session.take_commands(), [], "a hand that trembles turns nothing");
    input.move_to(MIDDLE + Vec2::new(40.0, 0.0), &mut session);
    input.move_to(MIDDLE + Vec2::new(90.0, 20.0), &mut session);
    assert_eq!(session.take_commands(), [Command::SetView], "two motions are one view");
    assert!(session.is_moving());
    let now = session.navigator.camera().clone();
    assert!((now.eye.distance(held) - before.eye.distance(held)).abs() < 1e-3);
    assert!(now.eye.distance(before.eye) > 5.0 && pixel_of(&session, held).distance(MIDDLE) < 0.5);
    input.release(Button::Left, &mut session);
    assert_eq!((session.picked.clone(), input.is_dragging()), (None, false), "a drag is no click");
    input.move_to(SKY, &mut session);
    assert_eq!(session.navigator.camera(), &now, "the button is let go");
    session.act(Action::UndoCamera, None);
    assert_eq!(session.navigator.camera(), &before);
    session.act(Action::RedoCamera, None);
    assert_eq!(session.navigator.camera(), &now);
}

#[test]
fn a_click_picks_the_voxel_and_keeps_it_while_the_camera_moves() {
    let mut session = in_room("room.vxt");
    let mut input = hands(&mut session, MIDDLE);
    click(&mut input, &mut session);
    let picked = session.picked.clone().expect("the block is in the middle");
    let voxel = picked.hit.voxel;
    assert!((9..15).contains(&voxel.x) && (9..15).contains(&voxel.y) && (1..7).contains(&voxel.z), "{picked:?}");
    let red = session.open.as_ref().unwrap().lit.materials()[picked.material as usize].base_color;
    assert!(red.x > 0.7 && red.y < 0.1, "{red}");
    input.wheel(2.0, &mut session);
    assert_eq!(session.picked.as_ref(), Some(&picked));
    input.move_to(Vec2::new(320.0, 400.0), &mut session);
    click(&mut input, &mut session);
    assert_ne!(session.picked.as_ref(), Some(&picked), "another place has another voxel");
    input.move_to(SKY, &mut session);
    click(&mut input, &mut session);
    assert_eq!(session.picked, None);
    let right = |input: &mut Input, session: &mut Session| {
        input.move_to(MIDDLE, session);
        input.press(Button::Right, session);
        input.release(Button::Right, session);
    };
    right(&mut input, &mut session);
    assert_eq!(session.picked, None, "the left button picks");
}

#[test]
fn a_double_click_frames_the_voxel_and_keeps_it_picked() {
    let mut session = in_room("room.vxt");
    let far = Vec2::new(330.0, 330.0);
    let mut input = hands(&mut session, far);
    click(&mut input, &mut session);
    let picked = session.picked.clone().unwrap();
    session.take_commands();
    input.press(Button::Left, &mut session);
    input.double_click(&mut session);
    input.release(Button::Left, &mut session);
    assert_eq!(session.take_commands(), [Command::SetView]);
    assert!(pixel_of(&session, picked.point).distance(MIDDLE) < 1.0, "it is in the middle now");
    assert_eq!(session.picked, Some(picked), "not what lies under the cursor after the flight");
}

#[test]
fn the_wheel_zooms_to_the_cursor_in_orbit_and_sets_the_speed_in_flight() {
    let mut session = in_room("room.vxt");
    let cursor = Vec2::new(300.0, 260.0);
    let mut input = hands(&mut session, cursor);
    let under = session.pick(cursor).unwrap();
    input.wheel(3.0, &mut session);
    assert_eq!(session.take_commands(), [Command::SetView]);
    let nearer = session.navigator.camera().eye.distance(under.point);
    assert!(nearer < under.hit.t * 0.8 && pixel_of(&session, under.point).distance(cursor) < 0.5);
    input.wheel(-3.0, &mut session);
    assert!((session.navigator.camera().eye.distance(under.point) - under.hit.t).abs() < 1e-2, "and back");
    session.take_commands();

    tap(&mut input, Key::Letter('O'), &mut session);
    assert_eq!(session.navigator.mode, Mode::Fly);
    let (camera, speed) = (session.navigator.camera().clone(), session.navigator.speed());
    input.wheel(2.0, &mut session);
    assert_eq!((session.take_commands(), session.navigator.camera()), (vec![], &camera));
    assert!(session.navigator.speed() > speed * 1.5);
    input.wheel(1.0, &mut session);
    let lines = said(&mut session).iter().filter(|text| text.ends_with("voxels a second")).count();
    assert_eq!(lines, 1, "the last speed alone is to be read");
}

#[test]
fn a_held_key_moves_and_the_last_view_is_asked_for_once_more_at_rest() {
    let mut session = in_room("room.vxt");
    let mut input = hands(&mut session, MIDDLE);
    let before = session.navigator.camera().eye;
    input.key(Key::Letter('W'), true, false, &mut session);
    for step in 1..=3 {
        assert!(session.advance(0.1));
        assert_eq!(session.take_commands(), [Command::SetView], "step {step}");
    }
    let gone = session.navigator.camera().eye.distance(before);
    assert!((gone - session.navigator.speed() * 0.3).abs() < 1e-3, "{gone}");
    input.key(Key::Letter('W'), false, false, &mut session);
    assert!(session.advance(0.01) && session.take_commands().is_empty(), "a moment is no rest");
    assert!(!session.advance(0.1) && !session.is_moving());
    assert_eq!(session.take_commands(), [Command::SetView]);
    assert!(!session.advance(1.0) && session.take_commands().is_empty(), "once");

    input.set_modifiers(Modifiers::SHIFT, &mut session);
    input.key(Key::Letter('S'), true, false, &mut session);
    let before = session.navigator.camera().eye;
    session.advance(0.1);
    let fast = session.navigator.camera().eye.distance(before);
    assert!((fast - session.navigator.speed() * 0.4).abs() < 1e-3, "{fast}");
    input.set_modifiers(Modifiers::NONE, &mut session);
    input.lose_focus(&mut session);
    let before = session.navigator.camera().clone();
    session.advance(0.1);
    assert_eq!(session.navigator.camera(), &before, "a window that lost the keyboard flies nowhere");
}

#[test]
fn ctrl_q_quits_unless_a_key_of_flight_is_held() {
    let mut session = in_room("room.vxt");
    let mut input = hands(&mut session, MIDDLE);
    input.set_modifiers(Modifiers::CTRL, &mut session);
    input.key(Key::Letter('W'), true, false, &mut session);
    input.key(Key::Letter('Q'), true, false, &mut session);
    assert_eq!(session.take_commands(), []);
    input.key(Key::Letter('W'), false, false, &mut session);
    input.key(Key::Letter('Q'), false, false, &mut session);
    tap(&mut input, Key::Letter('Q'), &mut session);
    assert_eq!(session.take_commands(), [Command::Quit]);
}

#[test]
fn a_change_of_the_render_settings_asks_for_what_it_changes_and_for_nothing_else() {
    let mut session = in_room("room.vxt");
    let mut changed = |change: &dyn Fn(&mut RenderSettings)| {
        let mut settings = session.render_settings.clone();
        change(&mut settings);
        session.set_render_settings(settings);
        session.take_commands()
    };
    let device = |primitive, is_exact| {
        let settings = Settings { traversal: Traversal::Query, primitive, is_exact };
        vec![Command::SetBackend(Backend::Device(settings))]
    };
    assert_eq!(changed(&|_| {}), []);
    assert_eq!(changed(&|settings| settings.tone_map.exposure = 2.0), [], "exposure is of drawing");
    assert_eq!(changed(&|settings| settings.light_intensity = Some(3.0)), [Command::SetScene]);
    assert_eq!(changed(&|settings| settings.light_intensity = Some(3.0)), []);
    assert_eq!(changed(&|settings| settings.sky_brightness = Some(0.0)), [Command::SetScene]);
    let sun = SunSetting { bearing: 90.0, height: 30.0, strength: 2.0 };
    assert_eq!(changed(&|settings| settings.sun = Some(sun)), [Command::SetScene]);
    assert_eq!(changed(&|settings| settings.traversal = Traversal::Query), device(Primitive::default(), true));
    let approx = Primitive::VoxelApprox;
    assert_eq!(changed(&|settings| settings.primitive = approx), device(approx, true));
    assert_eq!(changed(&|settings| settings.fast = true), device(approx, false));
    assert_eq!(changed(&|settings| settings.samples = 7), [Command::SetView]);
    assert_eq!(changed(&|settings| settings.max_bounces = 2), [Command::SetView]);
    assert_eq!(changed(&|settings| settings.take_integrator(Integrator::Essay)), [Command::SetView]);
    assert_eq!(
        changed(&|settings| (settings.traversal, settings.samples, settings.sun) = (Traversal::Cpu, 9, None)),
        [Command::SetScene, Command::SetBackend(Backend::Cpu), Command::SetView]
    );
    let view = session.view();
    assert_eq!((view.samples, view.max_bounces, view.integrator), (9, 3, Integrator::Essay));
    let lit = &session.open.as_ref().unwrap().lit;
    assert_eq!((lit.light_intensity, lit.sky.brightness()), (3.0, 0.0));
    assert_eq!(session.open.as_ref().unwrap().original.light_intensity, 1.0, "the scene's own light is kept");
}

#[test]
fn of_commands_that_set_the_same_thing_the_last_one_counts_and_steps_are_all_done() {
    let mut session = in_room("room.vxt");
    for is_paused in [true, false, true] {
        session.set_paused(is_paused);
    }
    assert_eq!((session.take_commands(), session.is_paused), (vec![Command::Pause(Pause::Samples)], true));
    // Three traversals: four steps are one.
    for _ in 0..4 {
        session.act(Action::NextTraversal, None);
    }
    assert_eq!(session.take_commands(), [Command::SetBackend(session.backend())]);
    assert_eq!(session.render_settings.traversal, Traversal::Walk);
    for action in [Action::ToggleFullScreen, Action::ToggleFullScreen, Action::ScaleUp, Action::ScaleUp] {
        session.act(action, None);
    }
    let twice = [Command::ToggleFullscreen, Command::ToggleFullscreen, Command::Scale(1), Command::Scale(1)];
    assert_eq!(session.take_commands(), twice);
}

#[test]
fn keys_that_brighten_lead_out_of_darkness_and_back_to_where_they_began() {
    let mut session = in_room("room.vxt");
    let brightness = |session: &Session| session.open.as_ref().unwrap().lit.sky.brightness();
    let before = brightness(&session);
    (0..3).for_each(|_| session.act(Action::SkyUp, None));
    assert!((brightness(&session) - before * 2.0).abs() < before * 1e-4, "three steps are a stop");
    (0..3).for_each(|_| session.act(Action::SkyDown, None));
    assert!((brightness(&session) - before).abs() < before * 1e-4);
    session.set_render_settings(RenderSettings {
        sky_brightness: Some(0.0),
        light_intensity: Some(0.0),
        ..session.render_settings.clone()
    });
    session.act(Action::SkyDown, None);
    assert_eq!(brightness(&session), 0.0);
    (0..2).for_each(|_| session.act(Action::SkyUp, None));
    session.act(Action::LightUp, None);
    assert!(brightness(&session) > 0.01 && session.render_settings.light_intensity == Some(0.01));
}

#[test]
fn bookmarks_are_kept_beside_the_scene_and_gone_to() {
    let folder = tempfile::tempdir().unwrap();
    let scene = folder.path().join("room.vxt").display().to_string();
    let mut session = in_room(&scene);
    let mut input = hands(&mut session, MIDDLE);
    let kept = session.navigator.camera().clone();
    tap(&mut input, Key::Digit(4), &mut session);
    assert!(said(&mut session).last().unwrap().contains("bookmark 4 is empty"));
    input.set_modifiers(Modifiers::SHIFT, &mut session);
    tap(&mut input, Key::Digit(4), &mut session);
    input.set_modifiers(Modifiers::NONE, &mut session);
    assert!(folder.path().join("room.cameras.toml").exists(), "{:?}", said(&mut session));
    input.wheel(5.0, &mut session);
    assert_ne!(session.navigator.camera(), &kept);
    session.take_commands();
    tap(&mut input, Key::Digit(4), &mut session);
    assert_eq!((session.take_commands(), session.navigator.camera()), (vec![Command::SetView], &kept));
    let mut other = in_room(&scene);
    other.act(Action::NextCamera, None);
    other.act(Action::GoToBookmark(4), None);
    assert_eq!(other.navigator.camera(), &kept, "another window finds them");

    std::fs::write(folder.path().join("room.cameras.toml"), "[bookmarks").unwrap();
    session.act(Action::StoreBookmark(5), None);
    let error = session.messages().last().unwrap();
    assert!(error.is_error && error.text.contains("damaged"), "{error:?}");

    let mut built_in = in_room("city");
    built_in.settings_folder = Some(folder.path().join("voxtrace"));
    built_in.act(Action::StoreBookmark(1), None);
    assert!(folder.path().join("voxtrace/city.cameras.toml").exists(), "the settings' folder is made");
}

#[test]
fn the_scenes_cameras_are_gone_through_also_where_names_stand_twice() {
    let mut session = in_room("room.vxt");
    let cameras = session.open.as_ref().unwrap().original.cameras.clone();
    for expected in [1, 2, 0, 1] {
        session.act(Action::NextCamera, None);
        assert_eq!(session.navigator.camera(), &cameras[expected]);
    }
    session.act(Action::PreviousCamera, None);
    assert_eq!(session.navigator.camera(), &cameras[0]);
}

#[test]
fn the_copied_command_says_every_part_of_the_view() {
    let mut session = in_room("/scenes/my room.vxt");
    session.scene_options = vec!["--resolution".into(), "700".into()];
    session.resize(800, 600);
    let sun = SunSetting { bearing: 200.0, height: 12.5, strength: 2.0 };
    let mut settings = session.render_settings.clone();
    (settings.samples, settings.traversal, settings.primitive, settings.fast) =
        (16, Traversal::Query, Primitive::VoxelApprox, true);
    (settings.sun, settings.sky_brightness, settings.light_intensity) = (Some(sun), Some(0.5), Some(4.0));
    settings.tone_map.exposure = 1.5;
    settings.take_integrator(Integrator::Essay);
    session.set_render_settings(settings);
    let copied = |session: &mut Session| {
        session.take_commands();
        session.act(Action::CopyCommand, None);
        let commands = session.take_commands();
        let [Command::Print(printed), Command::Copy(line)] = &commands[..] else { panic!("{commands:?}") };
        assert_eq!(printed, line);
        line.clone()
    };
    let line = copied(&mut session);
    let rest = line.strip_prefix("voxtrace render '/scenes/my room.vxt' --resolution 700 ").expect(&line);
    assert_eq!(
        rest,
        "--size 800x600 --spp 16 --integrator essay --exposure 1.5 --sky-brightness 0.5 --sun 200,12.5,2 \
         --light-intensity 4 --traversal query --primitive voxel-approx --fast"
    );
    session.navigator.apply(voxtrace_viewer::navigation::Motion::FieldOfView(33.0));
    let eye = session.navigator.camera().eye;
    assert!(copied(&mut session).contains(" --fov 33 ") && eye == packed().cameras[0].eye);
    session.act(Action::NextCamera, None);
    assert!(copied(&mut session).contains("--eye 50,12,14 --size"), "the other camera looks at the same target");

    let mut built_in = in_room("city");
    built_in.built_in_voxels = Some(5000);
    built_in.resize(1280, 720);
    assert_eq!(copied(&mut built_in), "voxtrace render city --voxels 5000 --spp 4096 --traversal cpu");
    let mut empty = Session::new(Traversal::Cpu);
    empty.act(Action::CopyCommand, None);
    assert_eq!(empty.take_commands(), []);
    assert_eq!(said(&mut empty), ["there is no scene to render yet"]);
}

#[test]
fn what_is_said_again_is_one_line() {
    let mut session = in_room("room.vxt");
    for text in ["a", "b", "a"] {
        session.say(text, false);
    }
    assert_eq!(said(&mut session), ["b", "a"]);
    session.has_panels = false;
    session.act(Action::NextIntegrator, None);
    assert_eq!(said(&mut session).last().unwrap(), "integrator essay", "no panel shows it");
    (0..20).for_each(|number| session.say(number.to_string(), false));
    assert_eq!(said(&mut session), ["14", "15", "16", "17", "18", "19"]);
}
