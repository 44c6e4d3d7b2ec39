//! Tests of the file: what is kept and read again, what is refused, and what others wrote there.

use super::*;
use std::fs;
use voxtrace::camera::Lens;
use voxtrace::glam::Vec3;

const NONE: Cameras = Cameras { of_scene: &[], bookmarks: None, scene: None };

fn timeline() -> Timeline {
    let mut timeline = Timeline::default();
    let camera = |x: f32| Camera { fov_y: 33.3, ..Camera::look_at(Vec3::new(x, 0.1, -7.7), Vec3::ZERO) };
    let lens = Lens::Thin { aperture: 1.5, focus: 9.0, blades: 5, blade_rotation: 10.0 };
    timeline.course = Course {
        keys: vec![
            TimeKey { at: 0.0, camera: camera(0.3) },
            TimeKey { at: 13.0 / 24.0, camera: camera(0.7).with_lens(lens) },
        ],
        fps: 23.976,
        seconds: 2.5,
        shutter: 0.5,
        ease: Ease::InOut,
        look_at: Some(Vec3::new(0.1, 2.0, 3.0)),
        focuses_on_target: true,
    };
    timeline
}

#[test]
fn what_is_kept_is_read_again_to_the_bit_and_other_keys_stay() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.animation.toml");
    let mut kept = timeline();
    kept.others.insert("note".into(), Value::String("mine".into()));
    kept.save(&path, &folder.path().join("room.vox").display().to_string(), None).unwrap();
    let mut read = Timeline { is_shown: true, ..Timeline::default() };
    read.open(&path, &NONE).unwrap();
    assert_eq!((&read.course, read.is_shown, read.is_changed), (&kept.course, true, false));
    assert_eq!(scene_of(&path).unwrap(), folder.path().join("room.vox").display().to_string());
    read.course.keys.pop();
    assert_ne!(read.course, kept.course, "the comparison sees a key");
    read.save(&path, "church", None).unwrap();
    let text = fs::read_to_string(&path).unwrap();
    assert!(text.contains("note = \"mine\"") && text.contains("scene = \"church\""), "{text}");
    assert_eq!(scene_of(&path).unwrap(), "church");
}

#[test]
fn a_scene_that_is_named_from_the_files_place_stays_so() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("shots/a.toml");
    fs::create_dir(folder.path().join("shots")).unwrap();
    fs::write(&path, "scene = \"../rooms/hall.vox\"\n").unwrap();
    let mut timeline = Timeline::default();
    timeline.open(&path, &NONE).unwrap();
    let scene = scene_of(&path).unwrap();
    timeline.save(&path, &scene, None).unwrap();
    assert!(fs::read_to_string(&path).unwrap().contains("scene = \"../rooms/hall.vox\""));
    let other = folder.path().join("other.vox").display().to_string();
    timeline.save(&path, &other, None).unwrap();
    assert_eq!(scene_of(&path).unwrap(), other, "of another scene it is said anew");
}

#[test]
fn what_others_wrote_meanwhile_stays_and_their_camera_goes_only_when_asked_again() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.animation.toml");
    let mut own = timeline();
    assert!(own.take_written(&path, &NONE).unwrap(), "nothing is there");
    own.save(&path, "church", None).unwrap();
    let text = fs::read_to_string(&path).unwrap();
    fs::write(&path, format!("{text}\n[sky]\nbrightness = 2\n")).unwrap();
    own.course.keys.pop();
    own.course.keys.push(TimeKey { at: 2.0, ..own.course.keys[0].clone() });
    assert!(own.take_written(&path, &NONE).unwrap(), "their camera is the one that was kept");
    own.save(&path, "church", None).unwrap();
    let text = fs::read_to_string(&path).unwrap();
    assert!(text.contains("brightness") && own.moves_more(), "{text}");
    fs::write(&path, text.replace("at = 2.0", "at = 2.25")).unwrap();
    assert!(!own.take_written(&path, &NONE).unwrap(), "another camera is there");
    assert!(own.take_written(&path, &NONE).unwrap(), "which is known by now");
    fs::write(&path, "[camera]\norbit = 1").unwrap();
    assert!(matches!(own.take_written(&path, &NONE), Err(TimelineError::NotOfKeys { .. })));
}

#[test]
fn cameras_are_found_by_name_and_among_the_bookmarks() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.toml");
    let (plain, kept) = (Camera::look_at(Vec3::X, Vec3::ZERO), Camera::look_at(Vec3::Y, Vec3::ZERO));
    let side = Camera { name: "side".into(), ..plain.clone() };
    let bookmarks = folder.path().join("a.cameras.toml");
    Bookmarks::open(&bookmarks).unwrap().store(3, &kept).unwrap();
    fs::write(
        &path,
        "frames = 48\n[camera]\npath = [{ at = 0, camera = \"side\" }, { at = 1, bookmark = 3, fov_y = 20 }]",
    )
    .unwrap();
    let mut timeline = Timeline::default();
    let cameras = Cameras { of_scene: std::slice::from_ref(&side), bookmarks: Some(bookmarks), scene: None };
    timeline.open(&path, &cameras).unwrap();
    let keys = &timeline.course.keys;
    assert_eq!((&keys[0].camera, &keys[1].camera), (&plain, &Camera { fov_y: 20.0, ..kept }));
    assert_eq!((timeline.course.frames(), timeline.course.seconds), (48, 2.0));
}

#[test]
fn what_is_no_course_of_keys_is_one_line_and_stays_as_it_is() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.toml");
    for (text, about) in [
        ("fps = [", "a.toml"),
        ("fps = 0", "fps"),
        ("shutter = 2", "shutter"),
        ("[camera]\norbit = 1", "camera.orbit"),
        ("[camera]\npath = [{ eye = [1, 0, 0], target = [0, 0, 0] }]", "at"),
        ("[camera]\npath = [{ at = 0, eye = [0, 0, 0], target = [0, 0, 0] }]", "target"),
        ("[camera]\npath = [{ at = 1, camera = \"x\" }]", "\"x\""),
        ("[camera]\npath = []\nlook_at = \"layer:dragon\"", "look_at"),
        ("[camera]\npath = []\nease = \"fast\"", "ease"),
    ] {
        fs::write(&path, text).unwrap();
        let mut own = timeline();
        let before = own.course.clone();
        let error = own.open(&path, &NONE).unwrap_err().to_string();
        assert!(error.contains(about) && !error.contains('\n'), "{text}: {error}");
        assert_eq!(own.course, before);
    }
    assert!(matches!(Timeline::default().open(&folder.path().join("none"), &NONE), Err(TimelineError::Read { .. })));
}
