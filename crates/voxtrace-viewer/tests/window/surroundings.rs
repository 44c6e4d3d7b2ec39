//! Ground, fog and clear shadows in the window: what the panel sets, the thread that makes it, and the command that renders the same.

use crate::common::panel::{click, panels, set};
use crate::common::{film, in_room, lit, packed, said, words};
use std::sync::Arc;
use std::sync::mpsc::channel;
use std::time::Duration;
use voxtrace::PackedScene;
use voxtrace::changes::MaterialChange;
use voxtrace::glam::{Vec2, Vec3};
use voxtrace::material::linear_color;
use voxtrace::surroundings::{Fog, Ground};
use voxtrace_viewer::panels::Status;
use voxtrace_viewer::session::{Command, Session};
use voxtrace_viewer::surroundings::Surroundings;

const MIDDLE: Vec2 = Vec2::new(320.0, 240.0);

/// Carries out what is asked for about the surroundings, and gives what is left to do.
fn make(session: &mut Session) -> Vec<Command> {
    let mut rest = session.take_commands();
    while rest.contains(&Command::Surround) {
        let (sender, woken) = channel();
        session.make_surroundings(Arc::new(move || _ = sender.send(())));
        assert!(session.is_surrounding());
        woken.recv_timeout(Duration::from_secs(120)).expect("the thread calls");
        session.take_surroundings();
        rest = session.take_commands();
    }
    rest
}

/// The room as `render` puts it into surroundings.
fn around(scene: &PackedScene, ground: Option<Ground>, fog: Option<Fog>) -> Arc<PackedScene> {
    Arc::new(scene.with_surroundings(ground.as_ref(), fog.as_ref()).unwrap())
}

#[test]
fn ground_and_fog_are_set_by_the_panel_and_the_film_is_that_of_render() {
    let mut harness = panels(in_room("room.vxt"), Status::default());
    let alone = film(&packed(), harness.state());
    click(&mut harness, "Surroundings");
    click(&mut harness, "ground");
    assert!(words(harness.state()).contains("--ground --ground-color "), "{}", words(harness.state()));
    assert_eq!(make(harness.state_mut()), [Command::SetScene]);
    let grey = linear_color([80; 3]);
    let ground = |height| Some(Ground { height, color: grey });
    let expected = film(&around(&packed(), ground(None), None), harness.state());
    assert!(film(&lit(harness.state()), harness.state()) == expected, "to the bit");
    assert!(expected != alone, "the comparison sees the ground");

    set(&mut harness, "ground's height", -3.5);
    click(&mut harness, "fog");
    set(&mut harness, "fog's density", 0.01);
    set(&mut harness, "light goes on", 0.5);
    assert_eq!(make(harness.state_mut()), [Command::SetScene]);
    let fog = |anisotropy| Some(Fog { density: 0.01, color: Vec3::ONE, anisotropy });
    let expected = film(&around(&packed(), ground(Some(-3.5)), fog(0.5)), harness.state());
    assert!(film(&lit(harness.state()), harness.state()) == expected, "to the bit");
    let other = film(&around(&packed(), ground(Some(-3.5)), fog(0.4)), harness.state());
    assert!(expected != other, "the comparison sees how light goes on");
    let line = words(harness.state());
    assert!(line.contains("--ground=-3.5 ") && line.contains("--fog 0.01,1,1,1,0.5"), "{line}");

    click(&mut harness, "below the lowest voxel");
    click(&mut harness, "fog");
    assert_eq!(make(harness.state_mut()), [Command::SetScene]);
    assert!(
        film(&lit(harness.state()), harness.state()) == film(&around(&packed(), ground(None), None), harness.state())
    );
    click(&mut harness, "ground");
    assert_eq!(harness.state_mut().take_commands(), [Command::SetScene], "nothing is to be made for nothing");
    assert!(film(&lit(harness.state()), harness.state()) == alone);
    assert!(!words(harness.state()).contains("--ground") && !words(harness.state()).contains("--fog"));
}

#[test]
fn clear_shadows_are_in_the_view_and_in_the_command() {
    let mut harness = panels(in_room("room.vxt"), Status::default());
    assert!(!harness.state().view().frame().clear_shadows && !words(harness.state()).contains("--clear-shadows"));
    click(&mut harness, "Limits");
    click(&mut harness, "clear shadows: light passes glass straight");
    assert!(harness.state().view().frame().clear_shadows && words(harness.state()).contains(" --clear-shadows"));
    assert_eq!(harness.state_mut().take_commands(), [Command::SetView]);
}

/// A session in the room with a fog that is made.
fn in_fog() -> Session {
    let mut session = in_room("room.vxt");
    let fog = Some(Fog { density: 0.01, color: Vec3::ONE, anisotropy: 0.0 });
    let ground = Some(Ground { height: None, color: Vec3::splat(0.2) });
    let mut settings = session.render_settings.clone();
    settings.surroundings = Surroundings { ground, fog };
    session.set_render_settings(settings);
    assert_eq!(make(&mut session), [Command::SetScene]);
    session
}

#[test]
fn what_is_picked_lies_in_the_scene_also_from_within_fog_and_above_a_ground() {
    let mut session = in_room("room.vxt");
    let clear = session.pick(MIDDLE).unwrap();
    session = in_fog();
    assert!(lit(&session).instances().len() > 2);
    assert_eq!(session.pick(MIDDLE), Some(clear));
    assert_eq!(session.pick(Vec2::new(2.0, 470.0)), None, "the ground");
}

#[test]
fn what_is_changed_about_the_scene_stays_in_its_surroundings() {
    let mut session = in_fog();
    let blue = MaterialChange { number: 1, base_color: Vec3::Z, emission: None };
    session.set_material(blue);
    assert_eq!(make(&mut session), [Command::SetScene]);
    let Surroundings { ground, fog } = session.render_settings.surroundings;
    let changed = session.open.as_ref().unwrap().changes().0.apply(&packed()).unwrap();
    let expected = film(&around(&changed, ground, fog), &session);
    assert!(film(&lit(&session), &session) == expected, "to the bit");
    assert!(expected != film(&around(&packed(), ground, fog), &session), "the comparison sees the material");
    assert!(session.render_command().unwrap().bench_line(&[], 1, 1).is_err(), "`bench` has no ground");
    // Another scene stands alone again.
    session.show("other.vxt".into(), packed());
    assert_eq!((make(&mut session).len(), lit(&session).instances().len()), (2, 1));
    assert_eq!(session.render_settings.surroundings, Surroundings::default());
}

#[test]
fn surroundings_that_were_made_for_what_is_gone_are_made_anew_or_forgotten() {
    let mut session = in_fog();
    let begun = |session: &mut Session| {
        let (sender, woken) = channel();
        session.make_surroundings(Arc::new(move || _ = sender.send(())));
        woken
    };
    let mut settings = session.render_settings.clone();
    settings.surroundings.fog.as_mut().unwrap().density = 0.02;
    session.set_render_settings(settings.clone());
    let woken = begun(&mut session);
    // Meanwhile the fog thickens further.
    settings.surroundings.fog.as_mut().unwrap().density = 0.05;
    session.set_render_settings(settings);
    session.take_commands();
    woken.recv_timeout(Duration::from_secs(120)).unwrap();
    session.take_surroundings();
    let commands = session.take_commands();
    assert_eq!(commands, [Command::SetScene, Command::Surround], "the one in between is shown");
    session.ask(Command::Surround);
    assert_eq!(make(&mut session), [Command::SetScene]);
    let Surroundings { ground, fog } = session.render_settings.surroundings;
    assert!(film(&lit(&session), &session) == film(&around(&packed(), ground, fog), &session), "to the bit");
    // And meanwhile another scene comes.
    let woken = begun(&mut session);
    session.show("other.vxt".into(), packed());
    session.take_commands();
    woken.recv_timeout(Duration::from_secs(120)).unwrap();
    session.take_surroundings();
    assert_eq!((session.take_commands(), lit(&session).instances().len()), (Vec::new(), 1));
    assert_eq!(said(&mut session), Vec::<String>::new());
}
