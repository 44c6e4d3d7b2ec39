//! Two tracers on one view, by a user's hands: what is asked for, the divider, and the commands. And the benchmark of the view.

use crate::common::{SIZE, in_room, said};
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, mpsc};
use voxtrace::PackedScene;
use voxtrace::glam::Vec2;
use voxtrace_viewer::benchmark::Benchmark;
use voxtrace_viewer::comparison::Comparison;
use voxtrace_viewer::engine::{Backend, Contrast, Pause};
use voxtrace_viewer::input::{Button, Input};
use voxtrace_viewer::keys::{Action, Key, Modifiers};
use voxtrace_viewer::running::{RunRequest, Running};
use voxtrace_viewer::session::{Command, Session};
use voxtrace_viewer::{Loader, Reading, Told, Wanted};
use voxtrace_vulkan::{Primitive, Settings, Traversal};

fn tap(input: &mut Input, key: Key, session: &mut Session) {
    input.key(key, true, false, session);
    input.key(key, false, false, session);
}

fn split(session: &Session) -> f32 {
    session.comparison.as_ref().unwrap().split
}

#[test]
fn a_key_begins_to_compare_and_ends_it_and_the_last_comparison_comes_back() {
    let mut session = in_room("room.vxt");
    let mut input = Input::default();
    tap(&mut input, Key::Letter('B'), &mut session);
    let walk = Backend::Device(Settings { traversal: Traversal::Walk, primitive: Primitive::Brick, is_exact: true });
    assert_eq!(session.take_commands(), [Command::CompareWith(Some(walk)), Command::SetContrast(Contrast::Beside)]);
    tap(&mut input, Key::Letter('U'), &mut session);
    let query = Backend::Device(Settings { traversal: Traversal::Query, primitive: Primitive::Brick, is_exact: true });
    assert_eq!(session.take_commands(), [Command::CompareWith(Some(query))]);
    tap(&mut input, Key::Letter('V'), &mut session);
    tap(&mut input, Key::Letter('V'), &mut session);
    assert_eq!(session.take_commands(), [Command::SetContrast(Contrast::Voxels)]);
    tap(&mut input, Key::Letter('B'), &mut session);
    assert_eq!(session.take_commands(), [Command::CompareWith(None)]);
    tap(&mut input, Key::Letter('B'), &mut session);
    assert_eq!(session.take_commands(), [Command::CompareWith(Some(query)), Command::SetContrast(Contrast::Voxels)]);
}

#[test]
fn an_engine_on_another_device_is_asked_for_the_comparison_unless_the_device_lacks_it() {
    let mut session = in_room("room.vxt");
    session.toggle_comparison();
    let asked = session.take_commands();
    session.ask_for_comparison();
    assert_eq!(session.take_commands(), asked);
    session.traversals = vec![Traversal::Cpu];
    session.ask_for_comparison();
    assert_eq!((session.take_commands(), session.comparison.is_none()), (vec![], true));
    session.ask_for_comparison();
    assert_eq!(session.take_commands(), []);
}

#[test]
fn the_divider_is_dragged_and_nothing_else_with_it() {
    let mut session = in_room("room.vxt");
    session.act(Action::Compare, None);
    session.take_commands();
    let camera = session.navigator.camera().clone();
    let mut input = Input::default();
    let middle = Vec2::new(SIZE.0 as f32 / 2.0 + 5.0, 200.0);
    input.move_to(middle, &mut session);
    input.press(Button::Left, &mut session);
    input.move_to(middle - Vec2::new(160.0, 30.0), &mut session);
    input.release(Button::Left, &mut session);
    assert!((split(&session) - 0.25).abs() < 1e-5, "{}", split(&session));
    assert_eq!((session.navigator.camera(), session.picked.clone()), (&camera, None), "neither orbit nor click");
    tap(&mut input, Key::Letter('K'), &mut session);
    assert!((split(&session) - 0.27).abs() < 1e-5);
    for _ in 0..40 {
        tap(&mut input, Key::Letter('J'), &mut session);
    }
    assert_eq!(split(&session), 0.0, "not beyond the window");
    assert_eq!(session.take_commands(), [], "what is traced does not depend on it");
    // Beside the divider, and where it is not shown, the mouse does what it always does.
    for (contrast, place) in [(Contrast::Beside, 300.0), (Contrast::Films, 2.0)] {
        let now = session.comparison.clone().unwrap();
        session.set_comparison(Some(Comparison { contrast, ..now }));
        session.take_commands();
        input.move_to(Vec2::new(place, 300.0), &mut session);
        input.press(Button::Left, &mut session);
        input.move_to(Vec2::new(place + 90.0, 300.0), &mut session);
        input.release(Button::Left, &mut session);
        assert_eq!((session.take_commands(), split(&session)), (vec![Command::SetView], 0.0), "{contrast:?}");
    }
}

#[test]
fn the_command_of_the_other_picture_differs_in_what_traces_alone() {
    let mut session = in_room("/x/room.vxt");
    let mut settings = session.render_settings.clone();
    settings.samples = 7;
    session.set_render_settings(settings);
    session.act(Action::Compare, None);
    session.take_commands();
    session.act(Action::CopyCommand, None);
    let own = session.take_commands();
    session.copy_other_command();
    let other = session.take_commands();
    let text = |commands: &[Command]| match &commands[1] {
        Command::Copy(text) => text.clone(),
        other => panic!("{other:?}"),
    };
    assert!(text(&own).ends_with("--traversal cpu"), "{own:?}");
    assert_eq!(text(&own).replace("--traversal cpu", "--traversal walk"), text(&other));
}

#[test]
fn a_benchmark_measures_the_view_while_nothing_is_traced() {
    let mut session = in_room("room.vxt");
    session.resize(48, 32);
    session.take_commands();
    session.act(Action::Benchmark, None);
    assert_eq!(session.take_commands(), [Command::Pause(Pause::Everything), Command::Benchmark]);
    let subject = session.bench_subject(None).unwrap();
    assert_eq!((subject.request.cells.clone(), subject.request.size), (vec!["cpu".to_owned()], Some((48, 32))));
    assert_eq!(&subject.scene.cameras[0], session.navigator.camera());
    let (sender, receiver) = mpsc::channel();
    session.benchmark = Some(Benchmark::start(subject, Arc::new(move || sender.send(()).unwrap_or_default())));
    session.set_paused(false);
    assert_eq!(session.take_commands(), [], "it goes on when that is done");
    let mut most = 0;
    while session.benchmark.is_some() {
        receiver.recv().expect("the benchmark ended without an answer");
        session.take_measured();
        most = most.max(session.benchmark.as_ref().map_or(0, |benchmark| benchmark.frames.0));
    }
    assert_eq!(session.take_commands(), [Command::Pause(Pause::Nothing)]);
    let measured = session.measured.clone().unwrap();
    let times = measured[0].times.expect("frames were proved");
    assert_eq!((measured.len(), measured[0].cell.as_str(), measured[0].failure.clone()), (1, "cpu", None));
    assert!(times.frames > 0 && times.median_ms > 0.0 && times.median_ms <= times.p99_ms && most > 0, "{times:?}");
    assert_eq!(measured[0].wrong_voxels, Some((0, 48 * 32)));
    assert!(measured[0].traced_bytes > 0);
}

#[test]
fn a_benchmark_measures_both_tracers_also_where_they_differ_in_their_rounding_alone() {
    let mut session = in_room("room.vxt");
    let mut settings = session.render_settings.clone();
    settings.traversal = Traversal::Walk;
    session.set_render_settings(settings.clone());
    let (traversal, primitive) = (Traversal::Walk, Primitive::Brick);
    let other = |fast| Comparison { traversal, primitive, fast, contrast: Contrast::Beside, split: 0.5 };
    session.set_comparison(Some(other(false)));
    assert_eq!(session.bench_cells(), ["walk"]);
    session.set_comparison(Some(other(true)));
    assert_eq!(session.bench_cells(), ["walk", "walk:fast"]);
    settings.fast = true;
    session.set_render_settings(settings.clone());
    assert_eq!(session.bench_cells(), ["walk"]);
    session.set_comparison(Some(Comparison { traversal: Traversal::Query, ..other(false) }));
    assert_eq!(session.bench_cells(), ["walk", "query:brick:precise"]);
    // The processor has one way to round.
    settings.traversal = Traversal::Cpu;
    session.set_render_settings(settings);
    assert_eq!(session.bench_cells(), ["cpu", "query:brick"]);
    assert!(session.bench_subject(None).unwrap().request.precise);
}

/// Runs a command as long as it is wanted.
struct Idle;

impl Loader for Idle {
    fn load(&self, _: &str, _: &Reading, _: Box<dyn Fn(Told) + Send>, _: &Wanted) -> Result<PackedScene, String> {
        Err("nothing is read here".into())
    }

    fn run(&self, _: &[String], _: Box<dyn Fn(Told) + Send>, wanted: &Wanted) -> Result<(), String> {
        while !wanted.is_over() {
            std::thread::sleep(std::time::Duration::from_millis(1));
        }
        Err("it was stopped".into())
    }

    fn save(&self, _: &PackedScene, path: &Path) -> Result<Vec<String>, String> {
        Err(path.display().to_string())
    }

    fn built_in(&self) -> Vec<(String, String)> {
        Vec::new()
    }
}

#[test]
fn nothing_is_measured_while_something_is_made_nor_made_while_something_is_measured() {
    let mut session = in_room("room.vxt");
    let loader: Arc<dyn Loader> = Arc::new(Idle);
    let run = |measures| {
        let (words, folders) = (vec!["voxtrace".to_owned()], Vec::new());
        let request = RunRequest { words, name: "a clip".into(), folders, measures };
        Some(Running::start(&loader, request, Arc::new(|| {})))
    };
    let busy = Some("something else is being made");
    session.running = run(false);
    session.act(Action::Benchmark, None);
    assert_eq!(session.take_commands(), []);
    assert!(said(&mut session).iter().any(|line| line.starts_with("something else is being made")));
    assert_eq!((session.busy_for_export(), session.busy_for_command()), (None, busy));
    session.running = run(true);
    assert_eq!((session.busy_for_export(), session.busy_for_command()), (busy, busy), "a plan is played");
    session.running = None;
    session.act(Action::Benchmark, None);
    assert_eq!(session.take_commands(), [Command::Pause(Pause::Everything), Command::Benchmark]);
}

#[test]
fn a_benchmark_with_a_fault_ends_and_tracing_goes_on() {
    let mut session = in_room("room.vxt");
    let subject = session.bench_subject(None).unwrap();
    let (sender, receiver) = mpsc::channel();
    let is_well = AtomicBool::new(false);
    let wake = move || {
        assert!(is_well.swap(true, Ordering::Relaxed), "the benchmark has a fault");
        sender.send(()).unwrap_or_default();
    };
    session.benchmark = Some(Benchmark::start(subject, Arc::new(wake)));
    while session.benchmark.is_some() {
        receiver.recv().expect("the benchmark ended without an answer");
        session.take_measured();
    }
    assert_eq!(session.take_commands(), [Command::Pause(Pause::Nothing)]);
    assert!(said(&mut session)[0].contains("measuring failed"));
}

#[test]
fn a_benchmark_that_is_stopped_ends_and_tracing_goes_on() {
    let mut session = in_room("room.vxt");
    let subject = session.bench_subject(None).unwrap();
    let (sender, receiver) = mpsc::channel();
    session.benchmark = Some(Benchmark::start(subject, Arc::new(move || sender.send(()).unwrap_or_default())));
    let mut input = Input::default();
    tap(&mut input, Key::Escape, &mut session);
    while session.benchmark.is_some() {
        receiver.recv().expect("the benchmark ended without an answer");
        session.take_measured();
    }
    assert_eq!(session.take_commands(), [Command::Pause(Pause::Nothing)]);
    assert!(session.measured.is_some());
    let mut empty = Session::new(Traversal::Cpu);
    input.set_modifiers(Modifiers::CTRL, &mut empty);
    tap(&mut input, Key::Letter('B'), &mut empty);
    assert_eq!(
        (empty.take_commands(), said(&mut empty)),
        (vec![], vec!["there is no scene to measure yet".to_owned()])
    );
}
