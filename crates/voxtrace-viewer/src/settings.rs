//! What the window remembers: one TOML file, `voxtrace/viewer.toml` in the user's folder of configuration (XDG_CONFIG_HOME, ~/.config,
//! or what the system has instead), or the file that `VOXTRACE_SETTINGS` names.

use crate::engine::RealTimeChoice;
use crate::tr;
use etcetera::BaseStrategy;
use serde::{Deserialize, Serialize};
use std::ffi::OsString;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use toml::{Table, Value};
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
    /// Colours of the panels: `system`, `dark` or `light`.
    pub theme: String,
    /// Whether views that move are shown in real-time light: `auto`, which is where a device traces that is not software, `on` or `off`.
    pub real_time: String,
    /// Whether a view that stands shows its film at once, however noisy it is.
    pub bare_film: bool,
    /// Language of the window, where it is not that of the system.
    pub language: Option<String>,
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
            theme: "system".into(),
            real_time: RealTimeChoice::Auto.name().into(),
            bare_film: false,
            language: None,
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
    /// What the file held when it was read or written last: what differs from it is what this window changed.
    base: Settings,
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
        (Self { base: settings.clone(), settings, path, may_write }, warning)
    }

    /// The folder of the file, where the bookmarks of built-in scenes lie too. It need not be there yet.
    pub fn folder(&self) -> Option<&Path> {
        self.path.as_deref()?.parent()
    }

    /// Writes what was changed, where there is a file for it. What other windows and people changed there meanwhile stays, and so do keys
    /// that the program does not know; comments do not.
    ///
    /// # Errors
    /// What the operating system reports.
    pub fn save(&mut self) -> io::Result<()> {
        self.settings.tidy();
        let Some(path) = self.path.as_ref().filter(|_| self.may_write) else { return Ok(()) };
        let mut table = match std::fs::read_to_string(path) {
            Ok(text) => text.parse::<Table>().ok(),
            Err(error) if error.kind() == io::ErrorKind::NotFound => Some(Table::new()),
            Err(error) if error.kind() == io::ErrorKind::InvalidData => None,
            Err(error) => return Err(error),
        };
        let theirs = table.as_ref().and_then(|table| Value::Table(table.clone()).try_into().ok());
        if theirs.is_none() {
            // Damaged meanwhile: somebody may want it back, and what it was when it was sound is known.
            std::fs::rename(path, kept_as(path))?;
            table = None;
        }
        let (mut table, theirs) = (table.unwrap_or_default(), theirs.unwrap_or_else(|| self.base.clone()));
        let mut merged = merged(&self.base, &self.settings, theirs);
        merged.tidy();
        table.remove("device");
        table.extend(Table::try_from(&merged).map_err(io::Error::other)?);
        if let Some(folder) = path.parent() {
            std::fs::create_dir_all(folder)?;
        }
        write_atomically(path, |file| file.write_all(table.to_string().as_bytes()))?;
        (self.settings, self.base) = (merged.clone(), merged);
        Ok(())
    }
}

/// The settings of the file by now, with what this window changed since `base`.
fn merged(base: &Settings, ours: &Settings, theirs: Settings) -> Settings {
    fn one<T: PartialEq + Clone>(base: &T, ours: &T, theirs: &T) -> T {
        if ours == base { theirs.clone() } else { ours.clone() }
    }
    Settings {
        recent: merged_recent(&base.recent, &ours.recent, theirs.recent),
        window: one(&base.window, &ours.window, &theirs.window),
        device: one(&base.device, &ours.device, &theirs.device),
        exposure_step: one(&base.exposure_step, &ours.exposure_step, &theirs.exposure_step),
        invert_look: one(&base.invert_look, &ours.invert_look, &theirs.invert_look),
        ui_scale: one(&base.ui_scale, &ours.ui_scale, &theirs.ui_scale),
        real_time: one(&base.real_time, &ours.real_time, &theirs.real_time),
        bare_film: one(&base.bare_film, &ours.bare_film, &theirs.bare_film),
        theme: one(&base.theme, &ours.theme, &theirs.theme),
        language: one(&base.language, &ours.language, &theirs.language),
    }
}

/// The files that this window opened, before those of the file; without those that this window forgot.
fn merged_recent(base: &[PathBuf], ours: &[PathBuf], mut theirs: Vec<PathBuf>) -> Vec<PathBuf> {
    // What follows the files that were opened stands in the order that it had.
    let is_in_order = |tail: &[PathBuf]| {
        let mut rest = base.iter();
        tail.iter().all(|path| rest.any(|other| other == path))
    };
    let opened = (0..=ours.len()).find(|&start| is_in_order(&ours[start..])).unwrap_or(0);
    // A full list drops its last files by itself.
    let is_forgotten = |path: &PathBuf| ours.len() < MOST_RECENT && base.contains(path) && !ours.contains(path);
    theirs.retain(|path| !is_forgotten(path) && !ours[..opened].contains(path));
    ours[..opened].iter().cloned().chain(theirs).collect()
}

fn path_of(named: Option<OsString>) -> Option<PathBuf> {
    let of_user =
        || etcetera::choose_base_strategy().ok().map(|strategy| strategy.config_dir().join("voxtrace/viewer.toml"));
    named.filter(|path| !path.is_empty()).map(PathBuf::from).or_else(of_user)
}

/// Where a damaged file is kept.
fn kept_as(path: &Path) -> PathBuf {
    let mut kept = path.as_os_str().to_owned();
    kept.push(".bak");
    PathBuf::from(kept)
}

/// The settings of a file, a warning, and whether the file may be written over.
fn read(path: &Path) -> (Settings, Option<String>, bool) {
    let name = path.display();
    let reason = match std::fs::read(path) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => return (Settings::default(), None, true),
        Err(error) => {
            let warning = tr!("said.settings_unread", name = name, error = error);
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
    let kept = kept_as(path);
    match std::fs::rename(path, &kept) {
        Ok(()) => {
            let kept = kept.display();
            let warning = tr!("said.settings_kept", name = name, reason = reason, kept = kept);
            (Settings::default(), Some(warning), true)
        }
        Err(error) => {
            let warning = tr!("said.settings_stuck", name = name, reason = reason, error = error);
            (Settings::default(), Some(warning), false)
        }
    }
}

#[cfg(test)]
mod tests;
