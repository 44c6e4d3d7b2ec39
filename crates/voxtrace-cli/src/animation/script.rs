//! An animation's TOML (`docs/animation.md`): what can be said before the scene is read. Objects and cameras are looked up once it is.

use super::table::{Table, Text};
use crate::failure::{Failure, reason};
use std::path::{Path, PathBuf};
use voxtrace::scenes;

/// Largest file that is read.
const MOST_BYTES: u64 = 16 << 20;
/// Keys at the top of the file.
const KEYS: [&str; 14] = [
    "scene",
    "fps",
    "frames",
    "seconds",
    "shutter",
    "key_fps",
    "animation",
    "animation_repeats",
    "bookmarks",
    "camera",
    "object",
    "sun",
    "sky",
    "note",
];

/// The file.
#[derive(Debug)]
pub struct Script {
    pub path: PathBuf,
    pub text: String,
    /// A path, or the name of a built-in scene.
    pub scene: Option<String>,
    pub fps: Option<f64>,
    pub frames: Option<u32>,
    pub seconds: Option<f64>,
    pub shutter: Option<f64>,
    pub key_fps: Option<f64>,
    /// Which of the file's animations moves it.
    pub animation: Option<String>,
    /// Whether that one begins again when it is over.
    pub animation_repeats: bool,
    /// The file of bookmarks that cameras are named by.
    pub bookmarks: Option<PathBuf>,
}

/// Whether a path names an animation.
pub fn is_script(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("toml"))
}

impl Script {
    /// Reads the file.
    pub fn open(path: &Path) -> Result<Self, Failure> {
        let cannot = |why: String| Failure::input(format!("cannot read the animation {}: {why}", path.display()));
        voxtrace::import::opened::note(path);
        let size = path.metadata().map_err(|error| cannot(reason(&error)))?.len();
        if size > MOST_BYTES {
            return Err(cannot(format!("it has {size} bytes, more than {MOST_BYTES}")));
        }
        let text = std::fs::read_to_string(path).map_err(|error| cannot(reason(&error)))?;
        Self::parse(path, text)
    }

    fn parse(path: &Path, text: String) -> Result<Self, Failure> {
        let whole = Text { path, text: &text }.parse()?;
        let top = Table::new(Text { path, text: &text }, &whole);
        top.only(&KEYS)?;
        let beside = |name: &str| path.parent().unwrap_or(Path::new("")).join(name);
        let scene = top.words("scene")?;
        let scene = scene.map(|name| match scenes::NAMES.contains(&name) {
            true => name.to_owned(),
            false => beside(name).display().to_string(),
        });
        let (frames, seconds) = (top.count("frames")?, top.positive("seconds")?);
        if frames.is_some() && seconds.is_some() {
            return Err(top.fault_at("seconds", "`frames` says already how long it lasts"));
        }
        let fps = top.positive("fps")?;
        if fps.is_some_and(|fps| fps > 1000.0) {
            return Err(top.fault_at("fps", "at most 1000 frames a second are possible"));
        }
        let shutter = top.number("shutter")?;
        if shutter.is_some_and(|share| !(0.0..=1.0).contains(&share)) {
            return Err(top.fault_at("shutter", "a share of a frame's time is needed, from 0 to 1"));
        }
        let animation = top.words("animation")?.map(str::to_owned);
        let animation_repeats = top.flag("animation_repeats")?.unwrap_or(false);
        let (key_fps, bookmarks) = (top.positive("key_fps")?, top.words("bookmarks")?.map(beside));
        let script = Self {
            path: path.to_owned(),
            scene,
            fps,
            frames,
            seconds,
            shutter,
            key_fps,
            animation,
            animation_repeats,
            bookmarks,
            text: String::new(),
        };
        drop(whole);
        Ok(Self { text, ..script })
    }

    /// Reads the whole file as a table, once more.
    pub fn with_table<R>(&self, read: impl FnOnce(Table) -> Result<R, Failure>) -> Result<R, Failure> {
        let text = Text { path: &self.path, text: &self.text };
        let whole = text.parse()?;
        read(Table::new(text, &whole))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fails(text: &str) -> String {
        Script::parse(Path::new("a/b.toml"), text.into()).unwrap_err().line()
    }

    #[test]
    fn scenes_are_files_beside_the_script_or_built_in() {
        let script = |text: &str| Script::parse(Path::new("a/b.toml"), text.into()).unwrap();
        assert_eq!(script("scene = \"deer.vox\"").scene.as_deref(), Some("a/deer.vox"));
        assert_eq!(script("scene = \"forest\"").scene.as_deref(), Some("forest"));
        let script = script("fps = 12.5\nframes = 1_00\nshutter = 0.5\nkey_fps = 8\n[camera]\norbit = 1");
        assert_eq!(
            (script.fps, script.frames, script.shutter, script.key_fps),
            (Some(12.5), Some(100), Some(0.5), Some(8.0))
        );
    }

    #[test]
    fn every_fault_names_file_line_and_key() {
        assert!(
            fails("fps = 24\nframes = 0").contains("a/b.toml:2: frames: a whole number"),
            "{}",
            fails("frames = 0")
        );
        assert!(fails("\n\nfps = nan").contains("a/b.toml:3: fps:"));
        assert!(fails("shutter = 2").contains("a/b.toml:1: shutter:"));
        assert!(
            fails("framez = 3").contains("a/b.toml:1: framez: nothing reads it")
                && fails("framez = 3").contains("frames")
        );
        assert!(fails("frames = 3\nseconds = 2").contains("a/b.toml:2: seconds:"));
        assert!(fails("a = 1\nfps = [").contains("a/b.toml:2"), "{}", fails("a = 1\nfps = ["));
        assert_eq!(fails("fps = [").lines().count(), 1);
    }
}
