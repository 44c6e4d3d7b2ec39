//! Tests of the settings: what is read, kept, and merged with what other windows wrote.

use super::*;
use std::fs;

fn open(path: &Path) -> (SettingsFile, Option<String>) {
    SettingsFile::open(Some(path.to_path_buf()))
}

#[test]
fn settings_are_read_as_they_were_saved() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("new/viewer.toml");
    let (mut file, warning) = open(&path);
    assert_eq!((&file.settings, warning), (&Settings::default(), None));
    assert!(!path.exists());
    file.settings = Settings {
        recent: vec!["/a b/\"c\".vox".into()],
        window: [640, 480],
        device: Some("llvmpipe".into()),
        exposure_step: 0.1,
        invert_look: true,
        ui_scale: 1.3,
        theme: "light".into(),
        real_time: "off".into(),
        bare_film: true,
        language: Some("en".into()),
    };
    file.save().unwrap();
    let (read, warning) = open(&path);
    assert_eq!((&read.settings, warning), (&file.settings, None));
    assert_ne!(read.settings, Settings::default(), "the comparison sees other settings");
    assert_eq!(read.folder(), Some(folder.path().join("new").as_path()));
}

#[test]
fn keys_may_be_missing_or_unknown_and_values_are_made_sensible() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("viewer.toml");
    fs::write(&path, "future = [1]\nui_scale = nan\nexposure_step = -inf\nwindow = [0, 4000000000]\n").unwrap();
    let (file, warning) = open(&path);
    assert_eq!(warning, None);
    let expected = Settings { window: [320, 16_384], exposure_step: 0.01, ..Settings::default() };
    assert_eq!(file.settings, expected);
}

#[test]
fn a_damaged_file_gives_the_defaults_and_is_kept() {
    let folder = tempfile::tempdir().unwrap();
    let (path, kept) = (folder.path().join("viewer.toml"), folder.path().join("viewer.toml.bak"));
    for damage in [&b"ui_scale = \"large\"\nrecent = []"[..], b"[", b"\xff"] {
        fs::write(&path, damage).unwrap();
        let (mut file, warning) = open(&path);
        assert_eq!(file.settings, Settings::default());
        let warning = warning.unwrap();
        assert!(warning.contains("viewer.toml.bak") && !warning.contains('\n'), "{warning}");
        assert_eq!(fs::read(&kept).unwrap(), damage);
        file.save().unwrap();
        assert_eq!(open(&path).1, None);
        assert_eq!(fs::read(&kept).unwrap(), damage, "saving leaves it");
    }
}

#[test]
fn what_cannot_be_set_aside_is_not_written_over() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("viewer.toml");
    fs::write(&path, "[").unwrap();
    fs::create_dir_all(folder.path().join("viewer.toml.bak/full")).unwrap();
    let (mut file, warning) = open(&path);
    assert!(warning.is_some());
    file.save().unwrap();
    assert_eq!(fs::read(&path).unwrap(), b"[");
    assert!(open(&folder.path().join("viewer.toml.bak")).1.is_some(), "a folder is no file");
}

#[test]
fn recent_files_are_ten_without_doubles_the_newest_first() {
    let mut settings = Settings::default();
    (0..15).for_each(|file| settings.add_recent(Path::new(&format!("/scenes/{file}.vox"))));
    settings.add_recent(Path::new("/scenes/9.vox"));
    let names: Vec<_> = settings.recent.iter().map(|path| path.file_stem().unwrap().to_str().unwrap()).collect();
    assert_eq!(names, ["9", "14", "13", "12", "11", "10", "8", "7", "6", "5"]);
    settings.forget_recent(Path::new("/scenes/14.vox"));
    assert_eq!(settings.recent.len(), 9);
    settings.add_recent(Path::new("here.vox"));
    assert!(settings.recent[0].is_absolute());
}

#[test]
fn the_variable_names_another_file_unless_it_is_empty() {
    assert_eq!(path_of(Some("/tmp/s.toml".into())), Some("/tmp/s.toml".into()));
    let usual = path_of(None);
    assert!(usual.as_ref().is_none_or(|path| path.ends_with("voxtrace/viewer.toml")));
    assert_eq!(path_of(Some(OsString::new())), usual);
}

#[test]
fn two_windows_keep_what_each_of_them_changed() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("viewer.toml");
    fs::write(&path, "recent = [\"/old.vox\", \"/gone.vox\"]\nfuture = [1]\n").unwrap();
    let (mut one, mut other) = (open(&path).0, open(&path).0);
    one.settings.add_recent(Path::new("/one.vox"));
    one.settings.ui_scale = 1.5;
    one.save().unwrap();
    other.settings.add_recent(Path::new("/other.vox"));
    other.settings.add_recent(Path::new("/old.vox"));
    other.settings.forget_recent(Path::new("/gone.vox"));
    other.settings.device = Some("llvmpipe".into());
    other.save().unwrap();
    let settings = open(&path).0.settings;
    let recent: Vec<&str> = settings.recent.iter().map(|path| path.to_str().unwrap()).collect();
    assert_eq!(recent, ["/old.vox", "/other.vox", "/one.vox"]);
    assert_eq!((settings.ui_scale, settings.device.as_deref()), (1.5, Some("llvmpipe")));
    one.settings.window = [800, 600];
    one.save().unwrap();
    let settings = open(&path).0.settings;
    assert_eq!((settings.window, settings.device.as_deref()), ([800, 600], Some("llvmpipe")), "a second time, too");
    assert_eq!(settings.recent.len(), 3);
    assert!(fs::read_to_string(&path).unwrap().contains("future"), "what nobody knows stays");
    // One that changed nothing changes nothing.
    let (before, mut third) = (fs::read(&path).unwrap(), open(&path).0);
    third.save().unwrap();
    assert_eq!(fs::read(&path).unwrap(), before);
}

#[test]
fn a_file_that_was_damaged_meanwhile_becomes_sound_again() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("viewer.toml");
    let (mut file, _) = open(&path);
    file.settings.ui_scale = 2.0;
    file.save().unwrap();
    fs::write(&path, "ui_scale = [").unwrap();
    file.settings.invert_look = true;
    file.save().unwrap();
    let settings = open(&path).0.settings;
    assert_eq!((settings.ui_scale, settings.invert_look), (2.0, true));
    assert_eq!(fs::read(folder.path().join("viewer.toml.bak")).unwrap(), b"ui_scale = [", "and is kept");
}
