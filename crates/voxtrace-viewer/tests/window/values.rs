//! Values of volumes, points and plans: what a hand changes about them is asked for, coarse first, and stands in the command.

use crate::common::hand::{Hand, floor};
use crate::common::panel::{choose, click, panels};
use crate::common::{in_room, packed, room, said, words};
use egui::accesskit::Role;
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT, Queryable};
use std::path::Path;
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};
use voxtrace::glam::{DVec3, IVec3, Vec2, Vec3};
use voxtrace::points::Attributes;
use voxtrace::{PackedScene, Transform, Volume};
use voxtrace_viewer::dialogs::{Dialog, PathField};
use voxtrace_viewer::engine::Pause;
use voxtrace_viewer::input::{Button, Input};
use voxtrace_viewer::keys::{Action, Key};
use voxtrace_viewer::load::{Loader, Loading, Reading, Told, Wanted};
use voxtrace_viewer::measuring::{Component, Kind, Measure};
use voxtrace_viewer::panels::Status;
use voxtrace_viewer::session::{Command, Session};
use voxtrace_viewer::transfer::ValueCurve;
use voxtrace_viewer::{PointsChoice, PointsSeen, ValuesSeen};

/// Gives a room whatever it is asked for, shows nothing above 250, and keeps how it was asked.
#[derive(Default)]
struct Scanner(Mutex<Vec<Reading>>);

fn seen() -> ValuesSeen {
    let values: Vec<f32> = (0..4000).map(|i| i as f32 / 20.0).collect();
    let volume = Volume::new([4000, 1, 1], values);
    let statistics = volume.statistics();
    ValuesSeen { histogram: volume.histogram(statistics.lowest, statistics.highest), statistics }
}

impl Loader for Scanner {
    fn load(
        &self,
        _: &str,
        reading: &Reading,
        tell: Box<dyn Fn(Told) + Send>,
        _: &Wanted,
    ) -> Result<PackedScene, String> {
        self.0.lock().unwrap().push(reading.clone());
        tell(Told::Values(Arc::new(seen())));
        let attributes = Attributes { classes: true, ..Attributes::default() };
        let classes = vec![(2, 1500), (6, 300), (77, 1)];
        tell(Told::Points(Arc::new(PointsSeen { count: 1801, attributes, classes })));
        if reading.transfer.as_ref().is_some_and(|word| word.contains("threshold=999")) {
            return Err("no sample is to be seen".into());
        }
        if reading.coarse.is_none() && reading.transfer.as_ref().is_some_and(|word| word.contains("threshold=998")) {
            return Err("these are too many voxels".into());
        }
        let mut scene = room();
        scene.instances[0].world_from_grid = Transform::from_translation(Vec3::Z * reading.coarse.map_or(0.0, |_| 1.0));
        Ok(PackedScene::pack(&scene).unwrap())
    }

    fn save(&self, _: &PackedScene, path: &Path) -> Result<Vec<String>, String> {
        Err(path.display().to_string())
    }

    fn built_in(&self) -> Vec<(String, String)> {
        Vec::new()
    }
}

/// A session with a scan, as the window opens it.
fn opened(loader: &Arc<dyn Loader>) -> Session {
    let mut session = in_room("scan.nii");
    session.loading = Some(Loading::start(loader, "scan.nii", Reading::default(), false, Arc::new(|| {})));
    until(&mut session, |session| {
        session.take_loaded();
        session.loading.is_none()
    });
    session.take_commands();
    session
}

fn until(session: &mut Session, mut holds: impl FnMut(&mut Session) -> bool) {
    let start = Instant::now();
    while !holds(session) {
        assert!(start.elapsed() < Duration::from_secs(300));
        std::thread::sleep(Duration::from_millis(1));
    }
}

/// Carries out what is asked for about voxels until nothing is.
fn settle(session: &mut Session, loader: &Arc<dyn Loader>) -> Vec<Command> {
    let mut all = Vec::new();
    loop {
        let commands = session.take_commands();
        let reshapes = commands.contains(&Command::Reshape);
        all.extend(commands);
        if !reshapes {
            return all;
        }
        session.reshape(loader, Arc::new(|| {}));
        until(session, |session| {
            session.take_reshaped();
            !session.values.as_ref().unwrap().is_shaping()
        });
    }
}

fn asked(scanner: &Scanner) -> Vec<(Option<u32>, Option<String>)> {
    std::mem::take(&mut *scanner.0.lock().unwrap())
        .into_iter()
        .map(|reading| (reading.coarse, reading.transfer))
        .collect()
}

#[test]
fn a_drag_in_the_picture_is_window_and_level_with_coarse_voxels_first() {
    let scanner = Arc::new(Scanner::default());
    let loader: Arc<dyn Loader> = Arc::clone(&scanner) as Arc<dyn Loader>;
    let mut session = opened(&loader);
    asked(&scanner);
    let camera = session.navigator.camera().clone();
    let mut input = Input::default();
    input.key(Key::Function(9), true, false, &mut session);
    assert!(session.drags_values());
    let before = session.values.as_ref().unwrap().curve().unwrap();
    input.move_to(Vec2::new(300.0, 300.0), &mut session);
    input.press(Button::Left, &mut session);
    input.move_to(Vec2::new(380.0, 300.0), &mut session);
    let wider = session.values.as_ref().unwrap().curve().unwrap();
    let width = |(from, to): (f32, f32)| to - from;
    assert!(width(wider.window()) > 1.3 * width(before.window()), "to the right it is wider");
    input.move_to(Vec2::new(380.0, 240.0), &mut session);
    let higher = session.values.as_ref().unwrap().curve().unwrap();
    assert!(higher.window().0 > wider.window().0 && higher.low > wider.low, "upwards its level is higher");
    input.release(Button::Left, &mut session);
    let commands = settle(&mut session, &loader);
    assert!(commands.contains(&Command::Pause(Pause::Everything)) && commands.contains(&Command::SetScene));
    assert_eq!(
        commands.iter().rfind(|command| matches!(command, Command::Pause(_))),
        Some(&Command::Pause(Pause::Nothing))
    );
    let word = Some(higher.word());
    assert_eq!(asked(&scanner), [(Some(96), word.clone()), (None, word)], "the last one alone, coarse and whole");
    assert_eq!(*session.navigator.camera(), camera, "the view stays");
    let line = words(&session);
    assert!(line.contains("--transfer 'stops:") && line.contains(&higher.word()), "{line}");
    session.act(Action::Cancel, None);
    assert!(!session.drags_values(), "Esc ends it");
    input.press(Button::Left, &mut session);
    input.move_to(Vec2::new(420.0, 200.0), &mut session);
    assert_ne!(*session.navigator.camera(), camera);
}

#[test]
fn the_panel_has_presets_an_automatic_ramp_and_a_way_back_from_nothing() {
    let scanner = Arc::new(Scanner::default());
    let loader: Arc<dyn Loader> = Arc::clone(&scanner) as Arc<dyn Loader>;
    let session = opened(&loader);
    let mut harness = panels(session, Status::default());
    click(&mut harness, "Values");
    choose(&mut harness, "preset", "hot");
    let hot = harness.state().values.as_ref().unwrap().chosen.clone().unwrap();
    assert!(hot.word().starts_with("stops:") && hot.word().contains("=#6e0800"), "{}", hot.word());
    let named = |harness: &Harness<Session>| {
        harness.get_by_role_and_label(Role::ComboBox, "preset").accesskit_node().value().unwrap_or_default()
    };
    assert_eq!(named(&harness), "hot");
    settle(harness.state_mut(), &loader);
    harness.get_by_label_contains("stop 2 at ").click();
    harness.run_steps(3);
    assert_eq!(harness.state().values.as_ref().unwrap().selected, Some(1));
    click(&mut harness, "delete stop");
    assert_eq!(harness.state().values.as_ref().unwrap().chosen.as_ref().unwrap().stops.len(), 3);
    harness.run_steps(3);
    assert_eq!(named(&harness), "choose", "it is none any more");
    // Nothing is as high as that.
    let mut nothing = hot.clone();
    nothing.low = 999.0;
    harness.state_mut().set_curve(Some(nothing));
    let shown = Arc::clone(&harness.state().open.as_ref().unwrap().original);
    settle(harness.state_mut(), &loader);
    assert!(Arc::ptr_eq(&shown, &harness.state().open.as_ref().unwrap().original), "what was shown stays");
    harness.run_steps(3);
    assert!(harness.query_by_label_contains("no value is shown").is_some());
    click(&mut harness, "Automatic");
    let (from, to) = harness.state().values.as_ref().unwrap().chosen.as_ref().unwrap().window();
    assert!((from - 2.0).abs() < 0.5 && (to - 198.0).abs() < 0.5, "{from} {to}");
    settle(harness.state_mut(), &loader);
    harness.run_steps(3);
    assert!(harness.query_by_label_contains("no value is shown").is_none());
    click(&mut harness, "Reset");
    assert_eq!(harness.state_mut().take_commands(), [Command::LoadAgain]);
    assert!(!words(harness.state()).contains("--transfer"));
}

#[test]
fn coarse_voxels_that_are_not_followed_by_all_are_told_of() {
    let loader: Arc<dyn Loader> = Arc::new(Scanner::default());
    let mut session = opened(&loader);
    let automatic = session.values.as_ref().unwrap().seen.automatic();
    for (low, is_left_coarse, has_error) in [(998.0, true, true), (automatic.low, false, false), (999.0, false, true)] {
        session.set_curve(Some(ValueCurve { low, ..automatic.clone() }));
        settle(&mut session, &loader);
        let values = session.values.as_ref().unwrap();
        assert_eq!((values.is_left_coarse, values.error.is_some()), (is_left_coarse, has_error), "{low}");
    }
}

#[test]
fn classes_of_points_are_ticked_by_name_and_the_file_is_read_again() {
    let scanner = Arc::new(Scanner::default());
    let loader: Arc<dyn Loader> = Arc::clone(&scanner) as Arc<dyn Loader>;
    let mut session = opened(&loader);
    session.scene_options = vec!["--classes=1".into(), "--resolution".into(), "64".into()];
    let mut harness = panels(session, Status::default());
    click(&mut harness, "Points");
    click(&mut harness, "6 building: 300 points");
    assert_eq!(harness.state_mut().take_commands(), [Command::LoadAgain]);
    let line = words(harness.state());
    assert!(line.contains("--resolution 64 --classes 2,77") && !line.contains("--classes=1"), "{line}");
    choose(&mut harness, "coloured by", "classification");
    assert!(words(harness.state()).contains("--color-by classification"));
    assert!(harness.query_by_label("intensity").is_none(), "these points have none");
    for name in ["2 ground: 1,500 points", "class 77: 1 point"] {
        click(&mut harness, name);
    }
    assert!(said(harness.state_mut()).iter().any(|line| line.contains("no class would be left")));
    assert!(words(harness.state()).contains("--classes 77"));
}

#[test]
fn the_camera_stays_on_the_map_where_other_points_lie_elsewhere_in_the_scene() {
    use voxtrace::georeference::Georeference;
    let with = |at: f64, size: f64| {
        let mut scene = room();
        scene.georeference = Some(Georeference::of_grid(Vec3::splat(at as f32).as_dvec3(), size, ""));
        Arc::new(PackedScene::pack(&scene).unwrap())
    };
    let mut session = in_room("a.laz");
    session.show("a.laz".into(), with(100.0, 0.5));
    let camera = session.navigator.camera().clone();
    session.show_again(with(90.0, 0.25));
    let moved = session.navigator.camera();
    assert_eq!(moved.eye, camera.eye * 2.0 + Vec3::splat(40.0));
    session.show_again(with(90.0, 0.25));
    assert_eq!(session.navigator.camera().eye, camera.eye * 2.0 + Vec3::splat(40.0), "nothing moved");
}

#[test]
fn what_was_measured_stays_in_its_place_where_the_voxels_have_another_size() {
    use voxtrace::georeference::Georeference;
    use voxtrace::scene::Unit;
    let folder = tempfile::tempdir().unwrap();
    let source = folder.path().join("a.laz").display().to_string();
    let with = |origin: f64, size: f64, has_map: bool| {
        let mut scene = room();
        (scene.voxel_size, scene.unit) = (size, Unit::Metre);
        scene.georeference = has_map.then(|| Georeference::of_grid(DVec3::splat(origin), size, ""));
        Arc::new(PackedScene::pack(&scene).unwrap())
    };
    for (has_map, shift) in [(true, 40.0), (false, 0.0)] {
        let mut session = in_room(&source);
        session.show(source.clone(), with(100.0, 0.5, has_map));
        let edges = [DVec3::X, DVec3::Y, DVec3::Z];
        let component = Component { voxels: 1, volume: 1.0, exposed: 6.0, corner: DVec3::ONE, edges };
        let (points, kind) = (vec![DVec3::ONE], Kind::Component);
        let measure = Measure { name: "one".into(), is_hidden: false, kind, points, component: Some(component) };
        session.measuring.list.insert(1, measure);
        session.show_again(with(90.0, 0.25, has_map));
        let measure = &session.measuring.list[&1];
        let component = measure.component.as_ref().unwrap();
        assert_eq!((measure.points[0], component.corner), (DVec3::splat(2.0 + shift), DVec3::splat(2.0 + shift)));
        assert!((component.volume - 8.0).abs() < 1e-9 && (component.exposed - 24.0).abs() < 1e-9, "{component:?}");
        assert_eq!((component.edges[2], component.voxels), (DVec3::Z * 2.0, 1));
        // What is kept from now on is kept with the size of the new voxels.
        session.change_measure(1, |measure| measure.name = "two".into());
        let mut other = in_room(&source);
        other.show(source.clone(), with(90.0, 0.25, has_map));
        assert!(other.measuring.list[&1].points[0].distance(DVec3::splat(2.0 + shift)) < 1e-9);
        std::fs::remove_file(folder.path().join("a.measurements.toml")).unwrap();
    }
}

#[test]
fn edits_are_not_lost_to_other_values_other_points_or_the_file_read_again() {
    let scanner = Arc::new(Scanner::default());
    let loader: Arc<dyn Loader> = Arc::clone(&scanner) as Arc<dyn Loader>;
    let mut hand = Hand::on(opened(&loader));
    // The file is on its way when the first edit is made, and so are all voxels of another curve.
    let curve = hand.session.values.as_ref().unwrap().seen.automatic();
    hand.session.set_curve(Some(curve.clone()));
    hand.session.take_commands();
    hand.session.reshape(&loader, Arc::new(|| {}));
    hand.session.loading = Some(Loading::start(&loader, "scan.nii", Reading::default(), true, Arc::new(|| {})));
    hand.click(floor(3, 4));
    hand.steps(1, 0);
    hand.asked.clear();
    hand.session.take_reshaped();
    assert!(!hand.session.values.as_ref().unwrap().is_shaping());
    assert_eq!(hand.session.take_commands(), [Command::Pause(Pause::Nothing)], "what is edited is traced");
    until(&mut hand.session, |session| {
        session.take_loaded();
        session.loading.is_none()
    });
    hand.session.set_curve(Some(curve));
    hand.session.set_points(PointsChoice { min_points: Some(3), ..PointsChoice::default() });
    assert_eq!(hand.session.take_commands(), [], "nothing is read again");
    let chosen = hand.session.chosen_points().unwrap();
    assert!(chosen.min_points.is_none() && hand.session.chosen_transfer().is_none(), "what is chosen is what is shown");
    assert!(said(&mut hand.session).last().unwrap().contains("edits would be lost"));
    assert_eq!(hand.material_at(IVec3::new(3, 4, 1)), Some(0));
    // Without edits the file is read again.
    let mut hand = Hand::on(opened(&loader));
    hand.session.set_points(PointsChoice { min_points: Some(3), ..PointsChoice::default() });
    assert_eq!(hand.session.take_commands(), [Command::LoadAgain]);
}

#[test]
fn tracing_goes_on_where_nobody_waits_for_coarse_voxels_any_more() {
    let scanner = Arc::new(Scanner::default());
    let loader: Arc<dyn Loader> = Arc::clone(&scanner) as Arc<dyn Loader>;
    let shaping = || {
        let mut session = opened(&loader);
        let curve = session.values.as_ref().unwrap().seen.automatic();
        session.set_curve(Some(curve));
        assert!(session.take_commands().contains(&Command::Pause(Pause::Everything)));
        session.reshape(&loader, Arc::new(|| {}));
        session
    };
    let mut session = shaping();
    session.set_curve(None);
    assert_eq!(session.take_commands(), [Command::Pause(Pause::Nothing), Command::LoadAgain]);
    let mut session = shaping();
    session.loading = Some(Loading::start(&loader, "other.nii", Reading::default(), false, Arc::new(|| {})));
    until(&mut session, |session| {
        session.take_loaded();
        session.loading.is_none()
    });
    assert!(session.take_commands().contains(&Command::Pause(Pause::Nothing)), "another scene is traced");
    let mut session = shaping();
    session.show_new([8; 3]);
    assert!(session.take_commands().contains(&Command::Pause(Pause::Nothing)), "and an empty one");
}

#[test]
fn a_plan_is_played_by_bench_with_nothing_else_traced() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("work.toml"), "").unwrap();
    let mut session = in_room("room.vxt");
    session.act(Action::Plan, None);
    let mut harness = panels(session, Status::default());
    let Some(Dialog::Plan(dialog)) = &mut harness.state_mut().dialog else { panic!("it is open") };
    dialog.plan = PathField::new(&folder.path().join("work.toml"));
    harness.run_steps(3);
    click(&mut harness, "Play");
    let commands = harness.state_mut().take_commands();
    let [Command::Run(request)] = &commands[..] else { panic!("{commands:?}") };
    assert!(request.measures && request.name.ends_with("work-report/report.html"), "{request:?}");
    assert!(packed().bounds().is_some());
}
