//! The dialogs as a screen reader has them: what is there by its name, and what a click asks for.

use crate::common::panel::sized_panels;
use crate::common::{SIZE, in_room, said};
use egui::accesskit::Role;
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT, Queryable};
use voxtrace_viewer::dialogs::{Dialog, PathField, TabUse};
use voxtrace_viewer::export::Existing;
use voxtrace_viewer::keys::Action;
use voxtrace_viewer::navigation::Motion;
use voxtrace_viewer::panels::{self, DeviceChoice, Status};
use voxtrace_viewer::session::{Command, Session};

fn panels<'a>(session: Session, status: Status) -> Harness<'a, Session> {
    let show = move |ui: &mut egui::Ui, session: &mut Session| {
        panels::show(ui, session, &status);
    };
    let mut harness = Harness::builder().with_size([1280.0, 1400.0]).build_ui_state(show, session);
    harness.run_steps(3);
    harness
}

fn click(harness: &mut Harness<Session>, name: &str) {
    harness.get_by_label(name).click();
    harness.run_steps(3);
}

fn is_enabled(harness: &Harness<Session>, name: &str) -> bool {
    !harness.get_by_role_and_label(Role::Button, name).accesskit_node().is_disabled()
}

/// A room whose file lies in a folder that is empty else.
fn in_folder(folder: &tempfile::TempDir) -> Session {
    in_room(&folder.path().join("room.vxt").display().to_string())
}

#[test]
fn a_picture_is_asked_for_with_what_was_chosen_and_never_over_another_unasked() {
    let folder = tempfile::tempdir().unwrap();
    let mut harness = panels(in_folder(&folder), Status::default());
    click(&mut harness, "Render…");
    assert!(harness.query_by_label_contains("albedo").is_none(), "a PNG has no layers");
    click(&mut harness, "EXR");
    click(&mut harness, "also albedo, normal, depth, instance and voxel");
    click(&mut harness, "transparent background");
    click(&mut harness, "Render");
    assert!(harness.state().dialog.is_none());
    let commands = harness.state_mut().take_commands();
    let [Command::Export(request)] = &commands[..] else { panic!("{commands:?}") };
    let job = &request.jobs[0];
    assert_eq!((job.path.clone(), request.existing), (folder.path().join("room-001.exr"), Existing::Refuse));
    assert_eq!((job.frame.width, job.frame.height), SIZE);
    assert!(job.frame.aovs && job.frame.transparent);
    assert_eq!(job.frame.camera, *harness.state().navigator.camera());

    std::fs::write(folder.path().join("mine.png"), "").unwrap();
    click(&mut harness, "Render…");
    let Some(Dialog::Picture(dialog)) = &mut harness.state_mut().dialog else { panic!("it is open") };
    dialog.path = PathField::new(&folder.path().join("mine.png"));
    harness.run_steps(3);
    assert!(!is_enabled(&harness, "Render") && harness.query_by_label("the file is there already").is_some());
    click(&mut harness, "write over the file that is there");
    assert!(is_enabled(&harness, "Render"));
    let Some(Dialog::Picture(dialog)) = &mut harness.state_mut().dialog else { panic!("it is open") };
    std::fs::write(folder.path().join("other.png"), "").unwrap();
    dialog.path.set(&folder.path().join("other.png").display().to_string());
    harness.run_steps(3);
    assert!(!is_enabled(&harness, "Render"), "that was said of another file");
    click(&mut harness, "Cancel");
    assert!(harness.state().dialog.is_none() && harness.state_mut().take_commands().is_empty());
}

#[test]
fn a_dialog_is_as_wide_as_a_small_window() {
    let folder = tempfile::tempdir().unwrap();
    for action in [Action::RenderPicture, Action::RenderFrames, Action::Record, Action::SaveScene, Action::OpenByPath] {
        let mut session = in_folder(&folder);
        session.act(action, None);
        let harness = sized_panels(session, [400.0, 500.0]);
        for name in ["Browse…", "Cancel"] {
            let rect = harness.get_by_role_and_label(Role::Button, name).rect();
            let is_inside = rect.left() > 0.0 && rect.right() < 400.0 && rect.top() > 0.0 && rect.bottom() < 500.0;
            assert!(is_inside, "{action:?}, {name}: {rect}");
        }
    }
}

#[test]
fn enter_is_the_dialogs_own_button_unless_it_ends_a_field_or_something_is_missing() {
    let folder = tempfile::tempdir().unwrap();
    let mut harness = panels(in_folder(&folder), Status::default());
    let enter = |harness: &mut Harness<Session>| {
        harness.key_press(egui::Key::Enter);
        harness.run_steps(3);
        !harness.state_mut().take_commands().is_empty()
    };
    click(&mut harness, "Render…");
    click(&mut harness, "EXR");
    harness.get_by_role_and_label(Role::SpinButton, "samples a pixel").click();
    harness.run_steps(3);
    harness.event(egui::Event::Text("7".into()));
    assert!(!enter(&mut harness) && harness.state().dialog.is_some(), "it ends the number");
    let Some(Dialog::Picture(dialog)) = &mut harness.state_mut().dialog else { panic!("it is open") };
    assert_eq!(dialog.quality.samples, 7);
    std::fs::write(folder.path().join("mine.png"), "").unwrap();
    dialog.path = PathField::new(&folder.path().join("mine.png"));
    dialog.path.is_settled = true;
    harness.run_steps(3);
    assert!(!enter(&mut harness) && harness.state().dialog.is_some(), "that file is there already");
    click(&mut harness, "EXR");
    assert!(enter(&mut harness) && harness.state().dialog.is_none());
}

#[test]
fn a_flight_wants_two_bookmarks_and_says_so() {
    let folder = tempfile::tempdir().unwrap();
    let mut harness = panels(in_folder(&folder), Status::default());
    click(&mut harness, "Frames…");
    assert!(is_enabled(&harness, "Render"), "a turntable wants none");
    click(&mut harness, "flight through the bookmarks");
    assert!(!is_enabled(&harness, "Render") && harness.query_by_label_contains("two bookmarks").is_some());
    let session = harness.state_mut();
    session.act(Action::StoreBookmark(1), None);
    session.move_by(Motion::Orbit { delta: (50.0, 3.0).into(), pivot: None });
    session.act(Action::StoreBookmark(2), None);
    session.take_commands();
    harness.run_steps(3);
    assert!(is_enabled(&harness, "Render"), "bookmarks are seen as they are kept");
    let Some(Dialog::Frames(dialog)) = &mut harness.state_mut().dialog else { panic!("it is open") };
    (dialog.seconds, dialog.rate) = (0.5, 10);
    click(&mut harness, "Copy ffmpeg");
    let commands = harness.state_mut().take_commands();
    let [Command::Copy(line)] = &commands[..] else { panic!("{commands:?}") };
    assert!(line.starts_with("ffmpeg -framerate 10 -i ") && line.contains("room_%04d.png"), "{line}");
    click(&mut harness, "Copy its command");
    let commands = harness.state_mut().take_commands();
    let line = commands.iter().find_map(|command| match command {
        Command::Copy(line) => Some(line.clone()),
        _ => None,
    });
    let line = line.expect("a command");
    assert!(line.contains("--flight ") && line.contains("--flight-frames 5"), "{line}");
    click(&mut harness, "Render");
    let commands = harness.state_mut().take_commands();
    let [Command::Export(request)] = &commands[..] else { panic!("{commands:?}") };
    let seeds: Vec<u32> = request.jobs.iter().map(|job| job.frame.seed).collect();
    assert_eq!(seeds, [0, 1, 2, 3, 4]);
    assert_eq!(request.jobs[4].frame.camera, *harness.state().navigator.camera());
    assert_eq!(request.jobs[4].path, folder.path().join("room-frames/room_0005.png"));
}

#[test]
fn a_scene_is_written_as_what_its_ending_says() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("room.vxt"), "").unwrap();
    let mut harness = panels(in_folder(&folder), Status::default());
    click(&mut harness, "Save scene…");
    click(&mut harness, ".vox");
    click(&mut harness, "Write");
    assert_eq!(harness.state_mut().take_commands(), [Command::SaveScene(folder.path().join("room-2.vox"))]);
    harness.state_mut().act(Action::SaveScene, None);
    let Some(Dialog::Save(dialog)) = &mut harness.state_mut().dialog else { panic!("it is open") };
    dialog.path.set("room.obj");
    harness.run_steps(3);
    assert!(!is_enabled(&harness, "Write") && harness.query_by_label_contains(".vxt or .vox").is_some());
}

#[test]
fn a_path_is_clicked_together_where_the_system_has_no_dialog() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir(folder.path().join("scans")).unwrap();
    std::fs::write(folder.path().join("scans/head.vxt"), "").unwrap();
    let mut harness = panels(in_folder(&folder), Status::default());
    harness.state_mut().act(Action::OpenByPath, None);
    harness.run_steps(3);
    click(&mut harness, "scans/");
    click(&mut harness, "head.vxt");
    click(&mut harness, "Open");
    let path = folder.path().join("scans/head.vxt").display().to_string();
    assert_eq!(harness.state_mut().take_commands(), [Command::Load(path)]);
    harness.state_mut().act(Action::OpenByPath, None);
    let Some(Dialog::Open(dialog)) = &mut harness.state_mut().dialog else { panic!("it is open") };
    dialog.path.set("/nowhere/at all");
    harness.run_steps(3);
    assert!(!is_enabled(&harness, "Open") && harness.query_by_label("there is no such file").is_some());
    harness.state_mut().act(Action::Cancel, None);
    harness.run_steps(3);
    assert!(harness.query_by_label("Open a scene").is_none(), "Esc closes it");
}

#[test]
fn another_device_is_asked_for_by_its_name() {
    let choice =
        |index: usize, name: &str| DeviceChoice { index, value: name.into(), label: format!("{index}: {name}") };
    let devices = vec![choice(0, "small"), choice(1, "large")];
    let status = Status { devices, device_index: 0, ..Status::default() };
    let mut harness = panels(in_room("room.vxt"), status);
    harness.get_by_role_and_label(Role::ComboBox, "device").click();
    harness.run_steps(3);
    harness.get_by_role_and_label(Role::Button, "1: large").click();
    harness.run_steps(3);
    assert_eq!(harness.state_mut().take_commands(), [Command::SetDevice("large".into())]);
    assert_eq!(said(harness.state_mut()), Vec::<String>::new());
}

#[test]
fn tab_completes_the_path_that_is_typed_and_leads_on_where_nothing_can_follow() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir(folder.path().join("scans")).unwrap();
    for name in ["scans/head-1.vxt", "scans/head-2.vxt"] {
        std::fs::write(folder.path().join(name), "").unwrap();
    }
    let mut harness = panels(in_folder(&folder), Status::default());
    assert_eq!(harness.state_mut().take_tab(), TabUse::Window);
    harness.state_mut().act(Action::OpenByPath, None);
    harness.run_steps(3);
    let typed = |text: &str, harness: &mut Harness<Session>| {
        let Some(Dialog::Open(dialog)) = &mut harness.state_mut().dialog else { panic!("it is open") };
        dialog.path.text.push_str(text);
        harness.run_steps(3);
        let used = harness.state_mut().take_tab();
        let path = harness.state_mut().dialog.as_mut().and_then(Dialog::path_field).unwrap();
        (used, path.text[folder.path().display().to_string().len()..].to_owned())
    };
    assert_eq!(typed("", &mut harness), (TabUse::Completion, "/scans/".into()));
    assert_eq!(typed("", &mut harness), (TabUse::Completion, "/scans/head-".into()));
    assert_eq!(typed("", &mut harness), (TabUse::Completion, "/scans/head-".into()), "either could follow");
    assert_eq!(typed("2", &mut harness), (TabUse::Completion, "/scans/head-2.vxt".into()));
    assert_eq!(typed("", &mut harness), (TabUse::NextField, "/scans/head-2.vxt".into()));
    harness.state_mut().dialog = None;
    harness.state_mut().act(Action::New, None);
    harness.run_steps(3);
    assert_eq!(harness.state_mut().take_tab(), TabUse::NextField, "there is no path");
}
