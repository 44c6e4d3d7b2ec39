//! What the window remembers: one TOML file, `voxtrace/viewer.toml` in the user's folder of configuration (XDG_CONFIG_HOME, ~/.config,
//! or what the system has instead), or the file that `VOXTRACE_SETTINGS` names.

use etcetera::BaseStrategy;
use serde::{Deserialize, Serialize};
use std::ffi::OsString;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use voxtrace_core::atomic_file::write_atomically;

/// Most files that are remembered.
pub const MOST_RECENT: usize = 10;

/// What is remembered. Keys that the program does not know are ignored, values that make no sense become sensible.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Settings {
    /// Files that were open, the newest first.
    pub recent: Vec<PathBuf>,
    /// Width and height of the window, points, 320 to 16,384.
    pub window: [u32; 2],
    /// Device to trace on, as `--device` names it; else the best one.
    pub device: Option<String>,
    /// Stops that one step changes the exposure by, 0.01 to 4.
    pub exposure_step: f32,
    /// Whether looking up and down is exchanged.
    pub invert_look: bool,
    /// Size of text and buttons, 0.5 to 4.
    pub ui_scale: f32,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            recent: Vec::new(),
            window: [1280, 800],
            device: None,
            exposure_step: 0.25,
            invert_look: false,
            ui_scale: 1.0,
        }
    }
}

impl Settings {
    /// Puts a file at the head of those that were open. A path that is no Unicode cannot be remembered.
    pub fn add_recent(&mut self, path: &Path) {
        let path = std::path::absolute(path).unwrap_or_else(|_| path.to_path_buf());
        self.recent.retain(|recent| *recent != path);
        self.recent.insert(0, path);
        self.tidy();
    }

    /// Forgets a file, one that is gone for instance.
    pub fn forget_recent(&mut self, path: &Path) {
        self.recent.retain(|recent| recent != path);
    }

    fn tidy(&mut self) {
        let mut known: Vec<PathBuf> = Vec::new();
        for path in self.recent.drain(..) {
            if path.to_str().is_some_and(|text| !text.is_empty()) && !known.contains(&path) {
                known.push(path);
            }
        }
        known.truncate(MOST_RECENT);
        self.recent = known;
        self.window = self.window.map(|side| side.clamp(320, 16_384));
        let default = Self::default();
        let within = |value: f32, least, most, usual| if value.is_nan() { usual } else { value.clamp(least, most) };
        self.exposure_step = within(self.exposure_step, 0.01, 4.0, default.exposure_step);
        self.ui_scale = within(self.ui_scale, 0.5, 4.0, default.ui_scale);
    }
}

/// The settings and their file.
#[derive(Clone, Debug)]
pub struct SettingsFile {
    /// What is remembered.
    pub settings: Settings,
    path: Option<PathBuf>,
    may_write: bool,
}

impl SettingsFile {
    /// Where the file is: what `VOXTRACE_SETTINGS` names, else the user's; `None` where the system tells of no folder.
    pub fn usual_path() -> Option<PathBuf> {
        path_of(std::env::var_os("VOXTRACE_SETTINGS"))
    }

    /// Reads the settings. A file that cannot be read gives the defaults and a warning of one line. A damaged one is kept as
    /// `NAME.bak`; where even that fails, nothing is written over it.
    pub fn open(path: Option<PathBuf>) -> (Self, Option<String>) {
        let (settings, warning, may_write) = path.as_deref().map_or((Settings::default(), None, false), read);
        (Self { settings, path, may_write }, warning)
    }

    /// The folder of the file, where the bookmarks of built-in scenes lie too. It need not be there yet.
    pub fn folder(&self) -> Option<&Path> {
        self.path.as_deref()?.parent()
    }

    /// Writes the settings, where there is a file for them.
    ///
    /// # Errors
    /// What the operating system reports.
    pub fn save(&mut self) -> io::Result<()> {
        self.settings.tidy();
        let Some(path) = self.path.as_ref().filter(|_| self.may_write) else { return Ok(()) };
        let text = toml::to_string(&self.settings).map_err(io::Error::other)?;
        if let Some(folder) = path.parent() {
            std::fs::create_dir_all(folder)?;
        }
        write_atomically(path, |file| file.write_all(text.as_bytes()))
    }
}

fn path_of(named: Option<OsString>) -> Option<PathBuf> {
    let of_user =
        || etcetera::choose_base_strategy().ok().map(|strategy| strategy.config_dir().join("voxtrace/viewer.toml"));
    named.filter(|path| !path.is_empty()).map(PathBuf::from).or_else(of_user)
}

/// The settings of a file, a warning, and whether the file may be written over.
fn read(path: &Path) -> (Settings, Option<String>, bool) {
    let name = path.display();
    let reason = match std::fs::read(path) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => return (Settings::default(), None, true),
        Err(error) => {
            let warning = format!("the settings {name} cannot be read ({error}); the defaults hold");
            return (Settings::default(), Some(warning), false);
        }
        Ok(bytes) => match toml::from_slice::<Settings>(&bytes) {
            Ok(mut settings) => {
                settings.tidy();
                return (settings, None, true);
            }
            Err(error) => error.message().lines().next().unwrap_or_default().to_owned(),
        },
    };
    let mut kept = path.as_os_str().to_owned();
    kept.push(".bak");
    let kept = PathBuf::from(kept);
    match std::fs::rename(path, &kept) {
        Ok(()) => {
            let kept = kept.display();
            let warning = format!("the settings {name} are damaged ({reason}) and kept as {kept}; the defaults hold");
            (Settings::default(), Some(warning), true)
        }
        Err(error) => {
            let warning = format!("the settings {name} are damaged ({reason}) and cannot be set aside ({error})");
            (Settings::default(), Some(warning), false)
        }
    }
}

#[cfg(test)]
mod tests {
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
}
