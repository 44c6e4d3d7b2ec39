//! Scripts of opening scenes: what is shown, from where, and what is left where nothing comes.

use crate::common;
use crate::common::hand::{floor, in_the_room};
use crate::common::panel::small_panels;
use crate::common::{in_room, packed, said};
use egui_kittest::kittest::Queryable;
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, mpsc};
use voxtrace::PackedScene;
use voxtrace::glam::{Vec2, Vec3};
use voxtrace_viewer::input::{Button, Input};
use voxtrace_viewer::keys::{Action, Key};
use voxtrace_viewer::load::Loading;
use voxtrace_viewer::navigation::Mode;
use voxtrace_viewer::render_settings::RenderSettings;
use voxtrace_viewer::session::{Command, Leaving, Session};
use voxtrace_viewer::{Loader, Motion, Plays, Reading, Told, Wanted};

const MIDDLE: Vec2 = Vec2::new(320.0, 240.0);

/// A loader by the test's word: scenes by name, and how often it was asked.
struct Words(AtomicUsize);

impl Loader for Words {
    fn save(&self, _: &PackedScene, _: &Path) -> Result<Vec<String>, String> {
        Ok(Vec::new())
    }

    fn load(
        &self,
        source: &str,
        _: &Reading,
        tell: Box<dyn Fn(Told) + Send>,
        _: &Wanted,
    ) -> Result<PackedScene, String> {
        self.0.fetch_add(1, Ordering::Relaxed);
        tell(Told::Progress { work: "reading".into(), share: Some(0.5), seconds_left: None });
        tell(Told::Note(format!("a note about {source}")));
        match source {
            "good.vxt" => Ok(PackedScene::clone(&packed())),
            "walk.vox" => {
                let (base, animation) = (common::room(), voxtrace::animation::Animation::default());
                tell(Told::Moves(Arc::new(Motion { base, animation, has_own_rate: false, shape_rate: None })));
                Ok(PackedScene::clone(&packed()))
            }
            "steps.vox" => {
                tell(Told::Plays(Plays::Keyframes(3)));
                Ok(PackedScene::clone(&packed()))
            }
            "bad.vxt" => Err("bad.vxt: the file ends too early".into()),
            _ => panic!("the loader has a fault"),
        }
    }

    fn built_in(&self) -> Vec<(String, String)> {
        Vec::new()
    }
}

/// Opens a scene in a session and waits until it is there, or is not.
fn load(session: &mut Session, source: &str) {
    let loader: Arc<dyn Loader> = Arc::new(Words(AtomicUsize::new(0)));
    let (sender, receiver) = mpsc::channel();
    session.loading = Some(Loading::start(
        &loader,
        source,
        Reading::default(),
        false,
        Arc::new(move || sender.send(()).unwrap_or_default()),
    ));
    while session.loading.is_some() {
        // The sender goes with the thread, so a loading that never ends fails here.
        receiver.recv().expect("the loader ended without an answer");
        session.take_loaded();
    }
}

#[test]
fn a_scene_that_comes_is_shown_from_its_first_camera_in_its_own_light() {
    let mut session = in_room("room.vxt");
    session.act(Action::NextCamera, None);
    session.set_render_settings(RenderSettings {
        light_intensity: Some(9.0),
        samples: 5,
        ..session.render_settings.clone()
    });
    session.take_commands();
    load(&mut session, "good.vxt");
    assert_eq!(session.take_commands(), [Command::SetScene, Command::SetView]);
    assert_eq!(session.open.as_ref().unwrap().source, "good.vxt");
    assert_eq!(session.navigator.camera().name, "front");
    assert_eq!(
        (session.render_settings.light_intensity, session.render_settings.samples),
        (None, 5),
        "how it is traced stays"
    );
    assert!(said(&mut session).contains(&"a note about good.vxt".to_owned()));
}

#[test]
fn a_scene_that_fails_leaves_the_old_one_and_says_why() {
    for (source, reason) in [("bad.vxt", "the file ends too early"), ("fault.vxt", "reading it failed")] {
        let mut session = in_room("room.vxt");
        let (camera, scene) = (session.navigator.camera().clone(), Arc::clone(&session.open.as_ref().unwrap().lit));
        load(&mut session, source);
        assert_eq!((session.take_commands(), session.navigator.camera()), (vec![], &camera));
        let open = session.open.as_ref().unwrap();
        assert!(open.source == "room.vxt" && Arc::ptr_eq(&open.lit, &scene));
        let error = session.messages().last().unwrap();
        assert!(error.is_error && error.text.contains(source) && error.text.contains(reason), "{error:?}");
    }
}

#[test]
fn a_camera_inside_the_scene_begins_in_flight_and_one_outside_in_orbit() {
    let mut session = in_room("room.vxt");
    assert_eq!(session.navigator.mode, Mode::Orbit);
    let mut scene = common::room();
    scene.cameras.insert(0, voxtrace::Camera::look_at(Vec3::new(4.0, 4.0, 4.0), Vec3::new(12.0, 12.0, 3.0)));
    session.show("inside.vxt".into(), Arc::new(PackedScene::pack(&scene).unwrap()));
    assert_eq!(session.navigator.mode, Mode::Fly);
    session.show("room.vxt".into(), packed());
    assert_eq!(session.navigator.mode, Mode::Orbit);
}

#[test]
fn escape_stops_loading_then_closes_the_list_then_drops_the_pick_then_leaves_full_screen() {
    let mut session = in_room("room.vxt");
    let mut input = Input::default();
    input.move_to(MIDDLE, &mut session);
    input.press(Button::Left, &mut session);
    input.release(Button::Left, &mut session);
    session.has_help = true;
    let loader: Arc<dyn Loader> = Arc::new(Words(AtomicUsize::new(0)));
    session.loading = Some(Loading::start(&loader, "good.vxt", Reading::default(), false, Arc::new(|| {})));
    let state = |session: &Session| (session.loading.is_some(), session.has_help, session.picked.is_some());
    let mut states = vec![state(&session)];
    for _ in 0..3 {
        input.key(Key::Escape, true, false, &mut session);
        states.push(state(&session));
        assert_eq!(session.take_commands(), []);
    }
    assert_eq!(states, [(true, true, true), (false, true, true), (false, false, true), (false, false, false)]);
    input.key(Key::Escape, true, false, &mut session);
    assert_eq!(session.take_commands(), [Command::LeaveFullscreen]);
    session.take_loaded();
    assert_eq!(session.open.as_ref().unwrap().source, "room.vxt", "what was stopped does not come");
}

#[test]
fn what_is_said_stands_above_what_is_opened_and_beside_the_side_panel_in_a_small_window_too() {
    let mut session = in_room("room.vxt");
    let loader: Arc<dyn Loader> = Arc::new(Words(AtomicUsize::new(0)));
    session.loading = Some(Loading::start(&loader, "good.vxt", Reading::default(), false, Arc::new(|| {})));
    let text = "a line that is longer than what the side panel leaves of a window of 600 points";
    session.say(text, false);
    let mut harness = small_panels(session);
    harness.run_steps(3);
    let [line, opened, side] = [text, "good.vxt", "New…"].map(|name| harness.get_by_label(name).rect());
    assert!(line.bottom() < opened.top() && line.left() >= 0.0, "{line} {opened}");
    assert!(line.right() < side.left(), "{line} {side}");
}

#[test]
fn edits_that_were_given_up_for_a_scene_that_does_not_come_are_asked_for_again() {
    let given_up = || {
        let mut hand = in_the_room();
        hand.click(floor(3, 4));
        hand.steps(1, 0);
        assert!(!hand.session.may_leave(Leaving::Load("bad.vxt".into())));
        hand.session.discard_and_leave();
        assert!(hand.session.may_leave(Leaving::Load("bad.vxt".into())));
        hand
    };
    let mut hand = given_up();
    load(&mut hand.session, "bad.vxt");
    assert!(hand.session.has_unsaved_edits() && !hand.session.may_leave(Leaving::Quit), "the file is damaged");
    let mut hand = given_up();
    let loader: Arc<dyn Loader> = Arc::new(Words(AtomicUsize::new(0)));
    hand.session.loading = Some(Loading::start(&loader, "good.vxt", Reading::default(), false, Arc::new(|| {})));
    hand.session.act(Action::Cancel, None);
    assert!(!hand.session.may_leave(Leaving::Quit), "opening was stopped");
    let mut hand = given_up();
    hand.click(floor(6, 4));
    hand.steps(2, 0);
    assert!(!hand.session.may_leave(Leaving::Quit), "there is another edit");
}

#[test]
fn what_is_edited_while_another_scene_is_read_is_not_lost_to_it() {
    let mut hand = in_the_room();
    let loader: Arc<dyn Loader> = Arc::new(Words(AtomicUsize::new(0)));
    let (sender, receiver) = mpsc::channel();
    let wake = Arc::new(move || sender.send(()).unwrap_or_default());
    hand.session.loading = Some(Loading::start(&loader, "good.vxt", Reading::default(), false, wake));
    hand.click(floor(3, 4));
    hand.steps(1, 0);
    while hand.session.loading.is_some() {
        receiver.recv().expect("the loader ended without an answer");
        hand.session.take_loaded();
    }
    assert_eq!(hand.session.leaving, Some(Leaving::Load("good.vxt".into())), "somebody is asked");
    assert!(hand.session.has_unsaved_edits() && hand.session.open.as_ref().unwrap().source == "room.vxt");
    hand.session.discard_and_leave();
    assert!(hand.session.take_commands().contains(&Command::Load("good.vxt".into())));
    load(&mut hand.session, "good.vxt");
    assert_eq!((hand.session.open.as_ref().unwrap().source.as_str(), hand.session.leaving.clone()), ("good.vxt", None));
}

#[test]
fn nothing_of_a_scene_that_moves_is_left_in_an_empty_one() {
    let mut session = in_room("room.vxt");
    load(&mut session, "walk.vox");
    assert!(session.has_motion());
    session.show_new([8; 3]);
    assert!(!session.has_motion());
    load(&mut session, "walk.vox");
    load(&mut session, "good.vxt");
    assert!(!session.has_motion());
}

#[test]
fn one_press_plays_the_keyframes_of_a_file() {
    let mut session = in_room("room.vxt");
    load(&mut session, "steps.vox");
    session.take_commands();
    session.act(Action::Play, None);
    assert!(session.timeline.is_playing(), "as soon as what moves is read");
    assert!(session.take_commands().contains(&Command::LoadAgain));
    session.act(Action::Play, None);
    assert!(!session.timeline.is_playing());
}

#[cfg(unix)]
#[test]
fn a_file_whose_name_is_no_text_is_refused_with_its_name() {
    use std::os::unix::ffi::OsStrExt;
    let mut session = in_room("room.vxt");
    session.take_commands();
    session.take_dropped(Path::new(std::ffi::OsStr::from_bytes(b"/a/b\xff.vox")));
    assert_eq!(session.take_commands(), []);
    assert!(said(&mut session).iter().any(|line| line.contains("/a/b") && line.contains("UTF-8")));
}
