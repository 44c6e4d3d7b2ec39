//! The timeline: keys are set and moved by hand, the playhead moves the view, and what is recorded is asked for.

use crate::common::panel::{click, panels, sized_panels, small_panels};
use crate::common::{in_room, said};
use egui::accesskit::Role;
use egui::{Event, Modifiers as Held, PointerButton, Pos2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use voxtrace_viewer::dialogs::{Dialog, PathField};
use voxtrace_viewer::input::Input;
use voxtrace_viewer::keys::{Action, Key};
use voxtrace_viewer::navigation::Motion;
use voxtrace_viewer::panels::Status;
use voxtrace_viewer::session::{Command, Leaving, Session};
use voxtrace_viewer::timeline::TimeKey;

fn turn(session: &mut Session) {
    session.move_by(Motion::Orbit { delta: (60.0, 10.0).into(), pivot: None });
}

/// A session with a key at the beginning and one at 2 s, where the playhead is.
fn with_two_keys(source: &str) -> Session {
    let mut session = in_room(source);
    session.act(Action::Timeline, None);
    session.act(Action::DividerRight, None);
    session.set_time_frame(49);
    turn(&mut session);
    session.act(Action::DividerRight, None);
    session.take_commands();
    session
}

#[test]
fn k_sets_keys_at_the_playhead_and_space_plays_from_one_to_the_next_in_real_time() {
    let mut session = in_room("room.vxt");
    let mut input = Input::default();
    let mut tap = |key: Key, session: &mut Session| {
        input.key(key, true, false, session);
        input.key(key, false, false, session);
    };
    tap(Key::Space, &mut session);
    assert!(said(&mut session)[0].contains("two keys"));
    // Keys have no names.
    let unnamed = |session: &Session| TimeKey::new(0.0, session.navigator.camera().clone()).camera;
    let first = unnamed(&session);
    tap(Key::Letter('K'), &mut session);
    session.set_time_frame(49);
    assert_eq!(unnamed(&session), first, "one key moves nothing");
    turn(&mut session);
    let second = unnamed(&session);
    tap(Key::Letter('K'), &mut session);
    assert_eq!(session.timeline.course.keys.iter().map(|key| key.at).collect::<Vec<_>>(), [0.0, 2.0]);
    session.set_time_frame(1);
    assert_eq!(*session.navigator.camera(), first);
    tap(Key::Space, &mut session);
    session.advance(1.01);
    assert_eq!(session.timeline.frame(), 25, "24 frames a second");
    let halfway = session.navigator.camera().clone();
    assert!(halfway != first && halfway != second && session.is_moving());
    assert!(session.take_commands().contains(&Command::SetView));
    session.advance(60.0);
    assert!(!session.timeline.is_playing() && session.timeline.frame() == 120, "it ends with the clip");
    assert_eq!(*session.navigator.camera(), second);
    session.timeline.repeats = true;
    tap(Key::Space, &mut session);
    session.advance(6.01);
    assert_eq!((session.timeline.frame(), session.timeline.is_playing()), (25, true), "it begins again");
    tap(Key::Space, &mut session);
    assert!(!session.timeline.is_playing());
    // One step back leads to where the camera was before it played.
    session.undo_camera(true);
    assert_ne!(*session.navigator.camera(), halfway);
}

#[test]
fn escape_stops_what_plays_and_nothing_else() {
    let mut session = with_two_keys("room.vxt");
    session.act(Action::Play, None);
    assert!(session.timeline.is_playing());
    session.take_commands();
    session.act(Action::Cancel, None);
    assert!(!session.timeline.is_playing() && session.timeline.is_shown);
    assert_eq!(session.take_commands(), [], "full screen stays");
    session.act(Action::Cancel, None);
    assert_eq!(session.take_commands(), [Command::LeaveFullscreen]);
}

#[test]
fn while_two_tracers_are_compared_k_moves_their_divider() {
    let mut session = in_room("room.vxt");
    session.act(Action::Compare, None);
    session.act(Action::DividerRight, None);
    assert!(session.timeline.course.keys.is_empty());
    session.act(Action::Compare, None);
    session.act(Action::DividerRight, None);
    assert_eq!(session.timeline.course.keys.len(), 1);
}

/// Presses at a place, moves to another and lets go.
fn drag(harness: &mut Harness<Session>, from: Pos2, to: Pos2) {
    let button =
        |pos, pressed| Event::PointerButton { pos, button: PointerButton::Primary, pressed, modifiers: Held::NONE };
    let middle = from.lerp(to, 0.5);
    for event in [
        Event::PointerMoved(from),
        button(from, true),
        Event::PointerMoved(middle),
        Event::PointerMoved(to),
        button(to, false),
    ] {
        harness.event(event);
        harness.run_steps(2);
    }
}

#[test]
fn keys_are_dragged_in_time_clicked_replaced_deleted_and_brought_back() {
    let mut harness = panels(with_two_keys("room.vxt"), Status::default());
    let axis = harness.get_by_label("time").rect();
    let at =
        |seconds: f32| Pos2::new(axis.left() + 12.0 + seconds / 5.0 * (axis.width() - 24.0), axis.center().y + 8.0);
    let times =
        |harness: &Harness<Session>| harness.state().timeline.course.keys.iter().map(|key| key.at).collect::<Vec<_>>();
    drag(&mut harness, at(2.0), at(3.5));
    assert_eq!(times(&harness), [0.0, 3.5]);
    // The axis itself moves the playhead, and the view with it.
    drag(&mut harness, at(1.0), at(1.5));
    assert_eq!((times(&harness), harness.state().timeline.frame()), (vec![0.0, 3.5], 37));
    assert_eq!(harness.state().timeline.course.camera_of(37).as_ref(), Some(harness.state().navigator.camera()));
    click(&mut harness, "key 2 at 3.50 s");
    assert_eq!((harness.state().timeline.frame(), harness.state().timeline.selected), (85, Some(1)));
    turn(harness.state_mut());
    let camera = TimeKey::new(0.0, harness.state().navigator.camera().clone()).camera;
    click(&mut harness, "Replace key");
    assert_eq!(harness.state().timeline.course.keys[1].camera, camera);
    click(&mut harness, "Delete key");
    assert_eq!(times(&harness), [0.0]);
    for _ in 0..2 {
        click(&mut harness, "Undo");
    }
    assert_eq!(times(&harness), [0.0, 3.5]);
    assert_ne!(harness.state().timeline.course.keys[1].camera, camera);
    click(&mut harness, "Undo");
    assert_eq!(times(&harness), [0.0, 2.0], "a drag is one step");
}

#[test]
fn a_timeline_is_kept_beside_its_scene_found_again_and_recorded() {
    let folder = tempfile::tempdir().unwrap();
    let source = folder.path().join("room.vxt").display().to_string();
    let mut harness = panels(with_two_keys(&source), Status::default());
    click(&mut harness, "look at a point");
    assert!(harness.state().timeline.course.look_at.is_some());
    click(&mut harness, "Save *");
    let kept = harness.state().timeline.course.clone();
    let again = in_room(&source);
    assert_eq!((&again.timeline.course, again.timeline.is_shown), (&kept, false));
    click(&mut harness, "Record…");
    let Some(Dialog::Record(dialog)) = &mut harness.state_mut().dialog else { panic!("it is open") };
    assert_eq!(dialog.path.path(), Some(folder.path().join("room.mp4")));
    dialog.path = PathField::new(&folder.path().join("shots/a_####.exr"));
    dialog.quality.samples = 5;
    harness.run_steps(3);
    harness.state_mut().take_commands();
    click(&mut harness, "Record");
    let commands = harness.state_mut().take_commands();
    let [Command::Run(request)] = &commands[..] else { panic!("{commands:?}") };
    let line = request.words.join(" ");
    let file = folder.path().join("room.animation.toml");
    assert!(line.starts_with(&format!("voxtrace animate {} --output", file.display())), "{line}");
    assert!(line.contains("a_####.exr") && line.contains("--spp 5") && !line.contains("--eye"), "{line}");
    assert_eq!(request.folders, [folder.path().join("shots")]);
    // Frames that are there stay until somebody says otherwise, and a row goes on.
    std::fs::create_dir(folder.path().join("shots")).unwrap();
    std::fs::write(folder.path().join("shots/a_0003.exr"), "").unwrap();
    click(&mut harness, "Record…");
    let Some(Dialog::Record(dialog)) = &mut harness.state_mut().dialog else { panic!("it is open") };
    dialog.path = PathField::new(&folder.path().join("shots/a_####.exr"));
    harness.run_steps(3);
    assert!(harness.query_by_label("it is there already").is_some());
    click(&mut harness, "keep them, render the others");
    click(&mut harness, "Record");
    let commands = harness.state_mut().take_commands();
    let [Command::Run(request)] = &commands[..] else { panic!("{commands:?}") };
    assert!(request.words.contains(&"--skip-existing".to_owned()));
}

#[test]
fn a_file_whose_camera_moves_otherwise_is_never_written_over() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("room.animation.toml");
    std::fs::write(&file, "scene = \"room.vxt\"\n[camera]\norbit = 1\n").unwrap();
    let mut session = with_two_keys(&folder.path().join("room.vxt").display().to_string());
    assert_eq!(session.save_timeline(), None);
    assert!(said(&mut session).iter().any(|line| line.contains("camera.orbit")));
    assert!(std::fs::read_to_string(&file).unwrap().contains("orbit"));
}

#[test]
fn a_way_that_another_program_set_meanwhile_is_written_over_only_when_asked_again() {
    let folder = tempfile::tempdir().unwrap();
    let mut session = with_two_keys(&folder.path().join("room.vxt").display().to_string());
    let file = session.save_timeline().unwrap();
    let text = std::fs::read_to_string(&file).unwrap();
    assert!(text.contains("at = 2.0"), "{text}");
    std::fs::write(&file, text.replace("at = 2.0", "at = 2.5")).unwrap();
    turn(&mut session);
    session.act(Action::DividerRight, None);
    assert_eq!(session.save_timeline(), None);
    assert!(said(&mut session).iter().any(|line| line.contains("another program")));
    assert!(std::fs::read_to_string(&file).unwrap().contains("at = 2.5"));
    assert_eq!(session.save_timeline(), Some(file.clone()));
    assert!(!std::fs::read_to_string(&file).unwrap().contains("at = 2.5"));
}

#[test]
fn a_timeline_that_no_file_holds_is_left_only_after_a_question() {
    let folder = tempfile::tempdir().unwrap();
    let source = folder.path().join("room.vxt").display().to_string();
    let mut harness = panels(with_two_keys(&source), Status::default());
    let ask = |harness: &mut Harness<Session>, leaving: Leaving| {
        harness.state_mut().take_commands();
        assert!(!harness.state_mut().may_leave(leaving));
        harness.run_steps(3);
    };
    ask(&mut harness, Leaving::Quit);
    click(&mut harness, "Cancel");
    assert_eq!((harness.state().leaving.clone(), harness.state_mut().take_commands()), (None, vec![]));
    ask(&mut harness, Leaving::Quit);
    click(&mut harness, "Save");
    assert!(folder.path().join("room.animation.toml").is_file());
    assert!(harness.state_mut().take_commands().contains(&Command::Quit));
    assert!(harness.state_mut().may_leave(Leaving::Quit), "a file holds it");
    turn(harness.state_mut());
    harness.state_mut().act(Action::DividerRight, None);
    ask(&mut harness, Leaving::Load("city".into()));
    click(&mut harness, "Open without saving");
    assert!(harness.state_mut().take_commands().contains(&Command::Load("city".into())));
    assert!(harness.state_mut().may_leave(Leaving::Load("city".into())), "once is enough");
    harness.state_mut().undo_time();
    assert!(!harness.state_mut().may_leave(Leaving::Quit), "there is another change");
}

#[test]
fn the_timeline_of_a_scene_without_a_file_is_kept_with_the_scene() {
    let mut session = in_room("room.vxt");
    session.show_new([8; 3]);
    session.act(Action::Timeline, None);
    session.add_time_key();
    assert_eq!(session.save_timeline(), None);
    assert!(said(&mut session).iter().any(|line| line.contains("save it first")));
    assert!(session.may_leave(Leaving::Quit), "there is nothing that it could be kept with");
}

#[test]
fn bookmarks_become_keys_over_the_whole_clip() {
    let folder = tempfile::tempdir().unwrap();
    let mut session = in_room(&folder.path().join("room.vxt").display().to_string());
    session.act(Action::Timeline, None);
    session.take_bookmarks();
    assert!(said(&mut session).iter().any(|line| line.contains("fewer than two")));
    for number in [2, 4, 9] {
        turn(&mut session);
        session.act(Action::StoreBookmark(number), None);
    }
    let last = TimeKey::new(0.0, session.navigator.camera().clone()).camera;
    session.take_bookmarks();
    let course = &session.timeline.course;
    assert_eq!((course.keys.len(), course.camera_of(course.frames())), (3, Some(last)));
}

#[test]
fn all_of_the_timeline_is_there_in_a_small_window() {
    let harness = small_panels(with_two_keys("room.vxt"));
    let side = harness.get_by_label("New…").rect().left();
    for (role, name) in [(Role::ComboBox, "ease"), (Role::Slider, "motion blur"), (Role::Button, "Close")] {
        let rect = harness.get_by_role_and_label(role, name).rect();
        assert!(rect.right() < side && rect.bottom() < 400.0, "{name}: {rect}");
    }
}

#[test]
fn the_picture_stays_in_sight_above_the_timeline_of_a_window_that_is_as_small_as_can_be() {
    for size in [[400.0, 300.0], [480.0, 240.0]] {
        let harness = sized_panels(with_two_keys("room.vxt"), size);
        let below = harness.state().below;
        assert!(below > 60.0 && size[1] - below >= 100.0, "{size:?}: {below}");
        let play = harness.get_by_role_and_label(Role::Button, "Play").rect();
        // The harness leaves a margin around the panels.
        assert!(play.top() >= size[1] - 8.0 - below && play.bottom() < size[1], "{size:?}: {play}");
    }
}

#[test]
fn a_key_that_is_dragged_while_the_timeline_goes_stays_where_it_is_and_is_one_change() {
    let pressed =
        |pos| Event::PointerButton { pos, button: PointerButton::Primary, pressed: true, modifiers: Held::NONE };
    let begin = || {
        let mut harness = panels(with_two_keys("room.vxt"), Status::default());
        let axis = harness.get_by_label("time").rect();
        let at =
            |seconds: f32| Pos2::new(axis.left() + 12.0 + seconds / 5.0 * (axis.width() - 24.0), axis.center().y + 8.0);
        for event in
            [Event::PointerMoved(at(2.0)), pressed(at(2.0)), Event::PointerMoved(at(2.5)), Event::PointerMoved(at(3.5))]
        {
            harness.event(event);
            harness.run_steps(2);
        }
        let released = Event::PointerButton {
            pos: at(1.0),
            button: PointerButton::Primary,
            pressed: false,
            modifiers: Held::NONE,
        };
        (harness, [Event::PointerMoved(at(1.0)), released])
    };
    let times = |harness: &Harness<Session>| -> Vec<f64> {
        harness.state().timeline.course.keys.iter().map(|key| key.at).collect()
    };
    // A key hides it.
    let (mut harness, let_go) = begin();
    assert_eq!(times(&harness), [0.0, 3.5]);
    harness.state_mut().timeline.is_changed = false;
    harness.state_mut().act(Action::Timeline, None);
    harness.run_steps(2);
    assert!(harness.state().timeline.is_changed);
    let_go.into_iter().for_each(|event| harness.event(event));
    harness.run_steps(2);
    harness.state_mut().act(Action::Timeline, None);
    harness.run_steps(3);
    assert_eq!(times(&harness), [0.0, 3.5], "it does not go on where the cursor is by now");
    harness.state_mut().undo_time();
    assert_eq!(times(&harness), [0.0, 2.0]);
    // Another scene has come, with a timeline of its own.
    let (mut harness, let_go) = begin();
    harness.state_mut().timeline.course.keys.clear();
    harness.run_steps(2);
    let_go.into_iter().for_each(|event| harness.event(event));
    harness.run_steps(3);
    assert!(times(&harness).is_empty(), "{:?}", times(&harness));
}

#[test]
fn a_length_counts_once_it_is_typed() {
    let mut harness = panels(with_two_keys("room.vxt"), Status::default());
    harness.state_mut().set_time_frame(12);
    harness.run_steps(3);
    harness.get_by_role_and_label(Role::SpinButton, "seconds").click();
    harness.run_steps(3);
    for text in ["0", ".", "5"] {
        harness.event(Event::Text(text.into()));
        harness.run_steps(3);
    }
    assert_eq!(harness.state().timeline.course.seconds, 5.0, "on the way to 0.5 there is a clip of one frame");
    harness.key_press(egui::Key::Enter);
    harness.run_steps(3);
    assert_eq!((harness.state().timeline.course.seconds, harness.state().timeline.frame()), (0.5, 12));
}
