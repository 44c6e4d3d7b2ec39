//! The sky in the window: what the panel chooses, what is dropped on the window, and the thread that makes what takes its time.

use crate::common;
use crate::common::panel::{choose, panels, set};
use crate::common::{SIZE, in_room, lit, rendered, said, words};
use egui::accesskit::Role;
use egui_kittest::kittest::Queryable;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::mpsc::channel;
use std::time::Duration;
use voxtrace::changes::SunSetting;
use voxtrace::glam::Vec3;
use voxtrace::sky::{Background, Environment};
use voxtrace::{Film, Integrator, PackedScene};
use voxtrace_viewer::panels::Status;
use voxtrace_viewer::render_command::SkySetting;
use voxtrace_viewer::session::{Command, Session};

/// Carries out what is asked for about the sky, and gives what is left to do.
fn make(session: &mut Session) -> Vec<Command> {
    let mut rest = session.take_commands();
    while rest.contains(&Command::MakeSky) {
        let (sender, woken) = channel();
        session.make_sky(Arc::new(move || _ = sender.send(())));
        assert!(session.skies.is_making());
        woken.recv_timeout(Duration::from_secs(120)).expect("the thread calls");
        session.take_sky();
        rest = session.take_commands();
    }
    rest
}

/// A panorama that is red to the east and blue to the west.
fn panorama(folder: &Path) -> PathBuf {
    let mut bytes = b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 8 +X 16\n".to_vec();
    for pixel in 0..16 * 8 {
        bytes.extend(if pixel % 16 < 8 { [10, 20, 250, 128] } else { [250, 20, 10, 129] });
    }
    let path = folder.join("an evening.hdr");
    std::fs::write(&path, bytes).unwrap();
    path
}

fn film(scene: &Arc<PackedScene>, session: &Session) -> Film {
    rendered(scene, &session.view().frame().size(40, 30).samples(2).integrator(Integrator::Path))
}

#[test]
fn each_sky_can_be_chosen_and_the_command_says_it() {
    let mut harness = panels(in_room("room.vxt"), Status::default());
    choose(&mut harness, "sky", "one colour");
    assert_eq!(harness.state_mut().take_commands(), [Command::SetScene]);
    assert!(words(harness.state()).contains("--sky-color "), "{}", words(harness.state()));
    let mean = lit(harness.state()).sky.mean_radiance();
    let own = harness.state().open.as_ref().unwrap().original.sky.mean_radiance();
    assert!(mean.abs_diff_eq(own, 1e-6), "as bright as before: {mean}, {own}");
    choose(&mut harness, "sky", "physical sky");
    assert_eq!(make(harness.state_mut()), [Command::SetScene]);
    assert!(words(harness.state()).contains("--sky physical"), "{}", words(harness.state()));
    harness.run_steps(3);
    assert!(harness.query_by_role_and_label(Role::Slider, "sky turned by °").is_none(), "its sun turns it");
    choose(&mut harness, "sky", "the scene's own sky");
    assert_eq!(harness.state_mut().take_commands(), [Command::SetScene]);
    assert!(!words(harness.state()).contains("--sky"));
    assert_eq!(lit(harness.state()).sky, harness.state().open.as_ref().unwrap().original.sky);
}

#[test]
fn a_physical_sky_follows_its_sun_and_is_that_of_render() {
    let mut session = in_room("room.vxt");
    let sun = SunSetting { bearing: 30.0, height: 12.0, strength: 2.0 };
    let under = |sun| {
        let settings = session_settings(&in_room("room.vxt"));
        voxtrace_viewer::render_settings::RenderSettings { sky: Some(SkySetting::Physical), sun: Some(sun), ..settings }
    };
    session.set_render_settings(under(sun));
    assert_eq!(make(&mut session), [Command::SetScene]);
    let mut expected = (*common::packed()).clone();
    expected.sky = sun.physical_sky().unwrap().with_brightness(expected.sky.brightness());
    let expected = film(&Arc::new(expected), &session);
    assert_eq!(film(&lit(&session), &session), expected, "to the bit");
    let lower = SunSetting { height: 11.9, ..sun };
    session.set_render_settings(under(lower));
    assert_eq!(film(&lit(&session), &session), expected, "the sky before stays until the other is there");
    make(&mut session);
    assert_ne!(film(&lit(&session), &session), expected, "the comparison sees a tenth of a degree");
    assert!(words(&session).contains("--sky physical --sun 30,11.9,2"), "{}", words(&session));
}

fn session_settings(session: &Session) -> voxtrace_viewer::render_settings::RenderSettings {
    session.render_settings.clone()
}

#[test]
fn a_panorama_is_entered_or_dropped_turned_and_traced_as_render_does() {
    let folder = tempfile::tempdir().unwrap();
    let path = panorama(folder.path());
    let mut harness = panels(in_room("room.vxt"), Status::default());
    choose(&mut harness, "sky", "panorama");
    assert_eq!(harness.state_mut().take_commands(), [], "it needs a file first");
    let field = harness.get_by_role(Role::TextInput);
    field.focus();
    field.type_text(path.to_str().unwrap());
    harness.run_steps(3);
    harness.key_press(egui::Key::Enter);
    harness.run_steps(3);
    assert_eq!(make(harness.state_mut()), [Command::SetScene]);
    let entered = film(&lit(harness.state()), harness.state());
    harness.run_steps(3);
    set(&mut harness, "sky turned by °", 90.0);
    assert_eq!(harness.state_mut().take_commands(), [Command::SetScene], "a map is read once");
    let line = words(harness.state());
    assert!(line.contains("an evening.hdr'") && line.contains("--sky-rotation 90"), "{line}");

    let map = Arc::new(voxtrace::import::read_environment(&path, &voxtrace::import::Limits::default()).unwrap());
    let under = |rotation| {
        let mut scene = (*common::packed()).clone();
        scene.sky.set_background(Background::Environment(Environment::new(map.clone(), rotation)));
        scene.sky.set_sun(None);
        film(&Arc::new(scene), harness.state())
    };
    assert_eq!(film(&lit(harness.state()), harness.state()), under(90.0), "to the bit");
    assert_eq!(entered, under(0.0));
    assert_ne!(entered, under(90.0), "the comparison sees a turned sky");

    // The field names what is dropped later, and nothing once the scene has its own light again.
    let other = folder.path().join("another.hdr");
    std::fs::copy(&path, &other).unwrap();
    harness.state_mut().take_dropped(&other);
    make(harness.state_mut());
    harness.run_steps(3);
    let named = |session: &Session| session.panorama.as_ref().map(|field| field.text.clone());
    assert_eq!(named(harness.state()), Some(other.display().to_string()));
    harness.get_by_label("the scene's own light").click();
    harness.run_steps(3);
    assert_eq!((named(harness.state()), harness.state().render_settings.sky.clone()), (None, None));

    let mut session = in_room("room.vxt");
    session.take_dropped(&path);
    assert_eq!(make(&mut session), [Command::SetScene]);
    assert_eq!(film(&lit(&session), &session), entered, "dropped is as entered");
    session.take_dropped(Path::new("/x/other.vox"));
    assert_eq!(session.take_commands(), [Command::Load("/x/other.vox".into())], "what is no panorama is opened");
}

#[test]
fn a_file_that_is_no_panorama_is_told_of_and_the_scenes_own_sky_stays() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("no.hdr");
    std::fs::write(&path, "#?RADIANCE\n").unwrap();
    let mut session = in_room("room.vxt");
    session.set_panorama(&path);
    make(&mut session);
    assert!(said(&mut session).iter().any(|line| line.contains("no.hdr")), "{:?}", said(&mut session));
    assert_eq!((session.render_settings.sky.clone(), session.size()), (None, SIZE));
    assert_eq!(lit(&session).sky, session.open.as_ref().unwrap().original.sky);
}

#[test]
fn a_sky_that_fails_takes_nothing_away_that_was_chosen_meanwhile() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("no.hdr");
    std::fs::write(&path, "#?RADIANCE\n").unwrap();
    let mut session = in_room("room.vxt");
    session.set_panorama(&path);
    session.take_commands();
    let (sender, woken) = channel();
    session.make_sky(Arc::new(move || _ = sender.send(())));
    let color = SkySetting::Color(Vec3::new(0.1, 0.2, 0.3));
    let mut settings = session_settings(&session);
    settings.sky = Some(color.clone());
    session.set_render_settings(settings);
    woken.recv_timeout(Duration::from_secs(120)).unwrap();
    session.take_sky();
    assert!(said(&mut session).iter().any(|line| line.contains("no.hdr")), "{:?}", said(&mut session));
    assert_eq!(session.render_settings.sky, Some(color));
}

#[test]
fn while_one_sky_is_made_another_waits_for_its_turn() {
    let mut session = in_room("room.vxt");
    let sun = |height| SunSetting { bearing: 0.0, height, strength: 1.0 };
    let mut settings = session_settings(&session);
    (settings.sky, settings.sun) = (Some(SkySetting::Physical), Some(sun(60.0)));
    session.set_render_settings(settings.clone());
    session.take_commands();
    let (sender, woken) = channel();
    let wake: Arc<dyn Fn() + Send + Sync> = Arc::new(move || _ = sender.send(()));
    session.make_sky(wake.clone());
    settings.sun = Some(sun(5.0));
    session.set_render_settings(settings);
    session.make_sky(wake);
    woken.recv_timeout(Duration::from_secs(120)).unwrap();
    session.take_sky();
    assert_eq!(session.take_commands(), [Command::MakeSky], "the one that is asked for by now");
    assert!(woken.try_recv().is_err(), "one thread at a time");
    session.ask(Command::MakeSky);
    assert_eq!(make(&mut session), [Command::SetScene]);
    let low = lit(&session).sky.sun().unwrap().irradiance;
    let above = Vec3::ONE;
    assert!(low.z < 0.5 * low.x && low.x < above.x, "near the horizon the sun is red: {low}");
}
