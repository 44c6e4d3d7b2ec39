//! What the window renders to files is what `render` makes, byte for byte: the dialogs' own commands are run and compared.

use crate::common::Folder;
use std::sync::Arc;
use voxtrace::PackedScene;
use voxtrace::animation::Ease;
use voxtrace::glam::Vec3;
use voxtrace::output::FilmFile;
use voxtrace_viewer::dialogs::{FramesDialog, PathField, PictureDialog, Quality, RecordDialog, Route};
use voxtrace_viewer::export::{End, Existing, ExportRequest, Source, Watch, export};
use voxtrace_viewer::keys::Action;
use voxtrace_viewer::navigation::Motion;
use voxtrace_viewer::render_command::{RenderCommand, SunSetting};
use voxtrace_viewer::session::Session;
use voxtrace_vulkan::Traversal;

/// A session that shows the room of a folder, from another place and in another light than its own.
fn session(folder: &Folder) -> Session {
    let path = folder.path("room.vox");
    let scene = voxtrace::import::load(&path, &Default::default()).unwrap().content.into_scene();
    let mut session = Session::new(Traversal::Cpu);
    session.resize(40, 30);
    session.show(path.display().to_string(), Arc::new(PackedScene::pack(&scene).unwrap()));
    session.move_by(Motion::Orbit { delta: (5.0, 2.0).into(), pivot: Some(Vec3::new(12.0, 12.0, 3.0)) });
    let mut settings = session.render_settings.clone();
    settings.sun = Some(SunSetting { bearing: 100.0, height: 40.0, strength: 2.0 });
    (settings.sky_brightness, settings.tone_map.exposure, settings.max_bounces) = (Some(0.75), 0.5, 5);
    session.set_render_settings(settings);
    session
}

fn run(session: &Session, request: &ExportRequest) -> voxtrace_viewer::export::Outcome {
    let open = session.open.as_ref().unwrap();
    let source = Source {
        changed: Arc::clone(&open.changed),
        lit: Arc::clone(&open.lit),
        backend: session.backend(),
        device: None,
    };
    export(request, source, &Watch::default())
}

/// Runs the command of a dialog, whose files are moved to another folder.
fn run_command(folder: &Folder, command: RenderCommand, to: &str) {
    let output = command.outputs[0].file_name().unwrap().to_owned();
    let words = RenderCommand { outputs: vec![folder.path(to).join(output)], ..command }.words().unwrap();
    std::fs::create_dir_all(folder.path(to)).unwrap();
    folder.succeed(&words[1..]);
}

fn small() -> Quality {
    Quality { size: [24, 18], samples: 3, transparent: false }
}

#[test]
fn a_picture_of_the_window_is_that_of_its_command_byte_for_byte() {
    let folder = Folder::new();
    let session = session(&folder);
    for (name, transparent, aovs, sixteen_bits) in
        [("a.png", false, false, false), ("b.png", true, false, true), ("c.exr", true, true, false)]
    {
        let mut dialog = PictureDialog::new(&session);
        assert!(dialog.path.text.ends_with("room-001.png"), "beside the scene: {}", dialog.path.text);
        dialog.path = PathField::new(&folder.path(name));
        dialog.quality = Quality { transparent, ..small() };
        (dialog.aovs, dialog.sixteen_bits) = (aovs, sixteen_bits);
        let outcome = run(&session, &dialog.request(&session).unwrap());
        assert_eq!((outcome.end, outcome.written), (End::Done, 1));
        run_command(&folder, dialog.command(&session).unwrap(), "theirs");
        let (ours, theirs) = (folder.bytes(name), folder.bytes(&format!("theirs/{name}")));
        assert!(ours == theirs, "{name}: {:?}", dialog.command(&session).unwrap().line());
        // The comparison sees one sample more.
        dialog.quality.samples += 1;
        run_command(&folder, dialog.command(&session).unwrap(), "theirs");
        assert!(ours != folder.bytes(&format!("theirs/{name}")), "{name}");
        // What is there stays until somebody says otherwise.
        assert_eq!(dialog.request(&session).unwrap_err(), "the file is there already");
        assert!(folder.bytes(name) == ours);
        dialog.replaces = true;
        assert_eq!(run(&session, &dialog.request(&session).unwrap()).end, End::Done);
        assert!(folder.bytes(name) != ours, "it was written over");
    }
}

#[test]
fn frames_of_the_window_are_those_of_its_commands_byte_for_byte() {
    let folder = Folder::new();
    let mut session = session(&folder);
    session.act(Action::StoreBookmark(2), None);
    session.move_by(Motion::Orbit { delta: (9.0, -2.0).into(), pivot: None });
    session.act(Action::StoreBookmark(5), None);
    session.act(Action::NextCamera, None);
    session.act(Action::StoreBookmark(7), None);
    for route in Route::ALL {
        let mut dialog = FramesDialog::new(&session);
        assert_eq!(dialog.route, Route::Flight, "where there are bookmarks");
        let name = format!("{route:?}");
        dialog.folder = PathField::new(&folder.path(&name));
        (dialog.route, dialog.seconds, dialog.rate, dialog.quality) = (route, 1.0, 4, small());
        let request = dialog.request(&session).unwrap();
        let outcome = run(&session, &request);
        assert_eq!((outcome.end, outcome.written), (End::Done, 4), "{route:?}");
        run_command(&folder, dialog.command(&session).unwrap(), &format!("their {name}"));
        let frame = |place: &str, number: u32| folder.bytes(&format!("{place}/room_{number:04}.png"));
        for number in 1..=4 {
            let theirs = frame(&format!("their {name}"), number);
            assert!(
                frame(&name, number) == theirs,
                "{route:?} {number}: {:?}",
                dialog.command(&session).unwrap().line()
            );
            assert!(number == 1 || frame(&name, number - 1) != theirs, "the comparison sees frames");
        }
        // An export that was stopped goes on with the frames that are missing.
        std::fs::remove_file(folder.path(&name).join("room_0003.png")).unwrap();
        let mut dialog = dialog.clone();
        dialog.seconds = 1.25;
        assert_eq!(
            (dialog.there(), dialog.request(&session).unwrap_err().as_str()),
            (3, "some frames are there already")
        );
        dialog.existing = Existing::Keep;
        let outcome = run(&session, &dialog.request(&session).unwrap());
        assert_eq!((outcome.end, outcome.written, outcome.kept), (End::Done, 2, 3));
    }
    assert!(FramesDialog::new(&session).ffmpeg().starts_with("ffmpeg -framerate 30 -i "));
}

#[test]
fn an_export_that_is_stopped_or_refused_leaves_no_half_file() {
    let folder = Folder::new();
    let session = session(&folder);
    let mut dialog = PictureDialog::new(&session);
    dialog.path = PathField::new(&folder.path("a.png"));
    dialog.quality = small();
    let request = dialog.request(&session).unwrap();
    let open = session.open.as_ref().unwrap();
    let source = || Source {
        changed: Arc::clone(&open.changed),
        lit: Arc::clone(&open.lit),
        backend: session.backend(),
        device: None,
    };
    let watch = Watch::default();
    watch.cancel();
    assert_eq!(export(&request, source(), &watch).end, End::Cancelled);
    assert!(!folder.exists("a.png"));
    // What was read, as a scene or for it, is never written over, whatever was said.
    std::fs::write(folder.path("slice.png"), "read").unwrap();
    voxtrace::import::opened::record();
    voxtrace::import::opened::note(&folder.path("slice.png"));
    let mut over = request.clone();
    (over.jobs[0].path, over.existing) = (folder.path("slice.png"), Existing::Replace);
    let End::Failed(reason) = run(&session, &over).end else { panic!("it was read") };
    assert!(reason.contains("this run reads it"), "{reason}");
    assert_eq!(folder.bytes("slice.png"), b"read");
    std::fs::write(folder.path("a.png"), "mine").unwrap();
    let End::Failed(reason) = run(&session, &request).end else { panic!("it was there") };
    assert!(reason.contains("is there already"), "{reason}");
    assert_eq!(folder.bytes("a.png"), b"mine");
}

/// The camera from which `animate` rendered a frame.
fn camera_of(folder: &Folder, frame: u32) -> voxtrace::Camera {
    FilmFile::open(&folder.path(&format!("f_{frame:04}.vxf"))).unwrap().frame.camera
}

#[test]
fn the_timeline_of_the_window_is_played_as_animate_renders_its_file() {
    let folder = Folder::new();
    let mut session = session(&folder);
    let mut cameras = vec![session.navigator.camera().clone()];
    for delta in [(9.0, -2.0), (40.0, 11.0)] {
        session.move_by(Motion::Orbit { delta: delta.into(), pivot: Some(Vec3::new(12.0, 12.0, 3.0)) });
        cameras.push(session.navigator.camera().clone());
    }
    for (ease, look_at, shutter) in [(Ease::None, None, 0.0), (Ease::InOut, Some(Vec3::new(1.5, 2.0, 0.1)), 0.5)] {
        session.timeline.edit(|course| {
            (course.fps, course.seconds) = (7.0, 1.3);
            course.spread(cameras.clone());
            (course.ease, course.look_at, course.shutter) = (ease, look_at, shutter);
        });
        let file = session.save_timeline().unwrap();
        assert_eq!(file, folder.path("room.animation.toml"));
        let mut dialog = RecordDialog::new(&session);
        dialog.path = PathField::new(&folder.path("f_####.png"));
        dialog.quality = Quality { samples: 1, ..small() };
        let words = dialog.request(&session, file.clone()).unwrap().words;
        let words: Vec<String> = words.into_iter().map(|word| word.replace("f_####.png", "f_####.vxf")).collect();
        folder.succeed(&words[1..]);
        assert_eq!(session.timeline.course.frames(), 9);
        assert!(!folder.exists("f_0010.vxf"));
        for frame in 1..=9 {
            session.set_time_frame(frame);
            let camera =
                voxtrace::Camera { name: camera_of(&folder, frame).name, ..session.navigator.camera().clone() };
            assert_eq!(camera, camera_of(&folder, frame), "{frame}");
            assert!(frame == 1 || camera != camera_of(&folder, frame - 1), "the comparison sees frames");
        }
        // Read again, it is the same to the bit.
        let course = session.timeline.course.clone();
        assert!(session.open_timeline(&file));
        assert_eq!(session.timeline.course, course);
    }
}
