//! Timelines as the TOML that `voxtrace animate` reads (`docs/animation.md`). What else the file holds is kept, save comments.

use super::{Course, MOST_KEYS, TimeKey, Timeline};
use crate::bookmarks::{Bookmarks, Seen};
use crate::camera_toml;
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};
use toml::{Table, Value};
use voxtrace::animation::Ease;
use voxtrace::glam::DVec3;
use voxtrace::{Camera, scenes};
use voxtrace_core::atomic_file::write_atomically;

/// Largest file that is read.
const MOST_BYTES: u64 = 16 << 20;
/// First line of a file that we write.
const HEADER: &str = "# A camera's way, for `voxtrace animate`; docs/animation.md says what else can move.\n\n";
/// How the camera speeds up and slows down, by the words of the file.
pub(super) const EASES: [(&str, Ease); 4] =
    [("none", Ease::None), ("in", Ease::In), ("out", Ease::Out), ("in-out", Ease::InOut)];

/// Why a timeline cannot be read or kept.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum TimelineError {
    /// The operating system cannot read the file.
    #[error("cannot read the animation {}: {source}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// What the system says.
        source: io::Error,
    },
    /// The file is no animation, or its camera moves in a way that is not one of keys. It is never written over.
    #[error("{}: {reason}", path.display())]
    NotOfKeys {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        reason: String,
    },
    /// The operating system cannot write the file.
    #[error("cannot keep the animation {}: {source}", path.display())]
    Write {
        /// The file.
        path: PathBuf,
        /// What the system says.
        source: io::Error,
    },
}

/// Where named cameras are looked up.
pub struct Cameras<'c> {
    /// Those of the scene.
    pub of_scene: &'c [Camera],
    /// The scene's bookmarks.
    pub bookmarks: Option<PathBuf>,
    /// The scene that bookmarks are seen in, in its voxels.
    pub scene: Option<Seen>,
}

impl Timeline {
    /// Reads the file at `path`, in place of what is edited; the panel stays as it is.
    ///
    /// # Errors
    /// [`TimelineError::Read`] and [`TimelineError::NotOfKeys`].
    pub fn open(&mut self, path: &Path, cameras: &Cameras) -> Result<(), TimelineError> {
        let refused = |reason: String| TimelineError::NotOfKeys { path: path.to_path_buf(), reason };
        let text = read_text(path)?;
        let mut others = table_of(&text, path)?;
        let course = course_of(&mut others, path, cameras).map_err(refused)?;
        let (path, known) = (Some(path.to_path_buf()), Some(text));
        let Self { is_shown, repeats, .. } = *self;
        *self = Self { is_shown, repeats, course, others, path, known, frame: 1, ..Self::default() };
        Ok(())
    }

    /// Takes what others wrote into the file at `path` since it was read or written here. Returns whether it may be written over: where another camera's way
    /// is there by now, only when asked again.
    ///
    /// # Errors
    /// Those of [`Self::open`]: then it is never written over.
    pub(super) fn take_written(&mut self, path: &Path, cameras: &Cameras) -> Result<bool, TimelineError> {
        let text = match read_text(path) {
            Err(TimelineError::Read { source, .. }) if source.kind() == io::ErrorKind::NotFound => return Ok(true),
            text => text?,
        };
        if self.known.as_ref() == Some(&text) {
            return Ok(true);
        }
        let read = |text: &str| {
            let mut others = table_of(text, path)?;
            let course = course_of(&mut others, path, cameras);
            let refused = |reason| TimelineError::NotOfKeys { path: path.to_path_buf(), reason };
            course.map(|course| (course, others)).map_err(refused)
        };
        let (course, others) = read(&text)?;
        let before = self.known.as_ref().and_then(|known| read(known).ok());
        let is_same = course.keys.is_empty() || before.is_some_and(|(before, _)| before == course);
        (self.others, self.known) = (others, Some(text));
        Ok(is_same)
    }

    /// Keeps it at `path`, for a scene by its path or name; `still` is the camera of a scene that moves, where there are no two keys. What others wrote there
    /// beside the camera stays.
    ///
    /// # Errors
    /// [`TimelineError::Write`].
    pub fn save(&mut self, path: &Path, scene: &str, still: Option<Camera>) -> Result<(), TimelineError> {
        let text = self.text(path, scene, still);
        write_atomically(path, |file| file.write_all(text.as_bytes()))
            .map_err(|source| TimelineError::Write { path: path.to_path_buf(), source })?;
        (self.path, self.known, self.is_changed) = (Some(path.to_path_buf()), Some(text), false);
        Ok(())
    }

    /// The text of the file.
    pub fn text(&self, path: &Path, scene: &str, still: Option<Camera>) -> String {
        let Course { keys, fps, seconds, shutter, ease, look_at, focuses_on_target } = &self.course;
        let mut table = self.others.clone();
        // As somebody named it, where that is the scene: a path from here stays one.
        let whole = |path: PathBuf| std::path::absolute(&path).unwrap_or(path);
        let named = self.others.get("scene").and_then(Value::as_str);
        let is_named = named.is_some_and(|name| whole(scene_path(path, name)) == whole(scene.into()));
        if !is_named {
            table.insert("scene".into(), Value::String(scene_word(path, scene)));
        }
        table.insert("fps".into(), Value::Float(*fps));
        table.insert("seconds".into(), Value::Float(*seconds));
        table.remove("frames");
        if *shutter > 0.0 {
            table.insert("shutter".into(), Value::Float(*shutter));
        }
        // A camera that stands still is the same at two times.
        let at = |time: f64| still.as_ref().map(|camera| TimeKey::new(time, camera.clone()));
        let still: Vec<TimeKey> = at(0.0).into_iter().chain(at(*seconds)).collect();
        let keys = if keys.len() < 2 && !still.is_empty() { &still } else { keys };
        if !keys.is_empty() {
            let mut camera = Table::new();
            camera.insert("path".into(), Value::Array(keys.iter().map(entry_of).collect()));
            let ease = EASES.iter().find(|(_, own)| own == ease).filter(|(_, own)| *own != Ease::None);
            camera.extend(ease.map(|(word, _)| ("ease".into(), Value::String((*word).into()))));
            camera.extend(look_at.map(|point| ("look_at".into(), camera_toml::array_of(point))));
            camera.extend(focuses_on_target.then(|| ("focus".into(), Value::String("target".into()))));
            table.insert("camera".into(), Value::Table(camera));
        }
        format!("{HEADER}{table}")
    }
}

/// The scene as the file at `path` names it: by the name of a file beside it, else by its whole path.
fn scene_word(path: &Path, scene: &str) -> String {
    let file = Path::new(scene);
    let is_beside = path.parent() == file.parent() && !scenes::NAMES.contains(&scene);
    let name = file.file_name().filter(|_| is_beside).map(|name| name.to_string_lossy().into_owned());
    name.unwrap_or_else(|| scene.to_owned())
}

fn entry_of(key: &TimeKey) -> Value {
    let mut table = Table::new();
    table.insert("at".into(), Value::Float(key.at));
    camera_toml::write(&key.camera, &mut table);
    // The keys of a path have no names.
    table.remove("name");
    Value::Table(table)
}

/// The scene that an animation names: a path, or the name of a built-in one.
///
/// # Errors
/// Those of [`Timeline::open`].
pub fn scene_of(path: &Path) -> Result<String, TimelineError> {
    let table = read_table(path)?;
    let name = table.get("scene").and_then(Value::as_str);
    let name = name.ok_or_else(|| TimelineError::NotOfKeys {
        path: path.to_path_buf(),
        reason: "`scene` is missing: it names a file beside this one, or a built-in scene".into(),
    })?;
    Ok(scene_path(path, name).display().to_string())
}

/// What a word for a scene means in the file at `path`: the name of a built-in one, else a path from there.
fn scene_path(path: &Path, name: &str) -> PathBuf {
    if scenes::NAMES.contains(&name) { name.into() } else { path.parent().unwrap_or(Path::new("")).join(name) }
}

fn read_table(path: &Path) -> Result<Table, TimelineError> {
    table_of(&read_text(path)?, path)
}

fn read_text(path: &Path) -> Result<String, TimelineError> {
    let failed = |source| TimelineError::Read { path: path.to_path_buf(), source };
    let refused = |reason: String| TimelineError::NotOfKeys { path: path.to_path_buf(), reason };
    let mut text = String::new();
    let bytes = std::fs::File::open(path).and_then(|file| file.take(MOST_BYTES + 1).read_to_string(&mut text));
    if bytes.map_err(failed)? as u64 > MOST_BYTES {
        return Err(refused(format!("it has more than {MOST_BYTES} bytes")));
    }
    Ok(text)
}

fn table_of(text: &str, path: &Path) -> Result<Table, TimelineError> {
    let refused = |reason: String| TimelineError::NotOfKeys { path: path.to_path_buf(), reason };
    text.parse().map_err(|error: toml::de::Error| refused(error.message().to_owned()))
}

/// Takes what the window edits out of a table.
fn course_of(table: &mut Table, path: &Path, cameras: &Cameras) -> Result<Course, String> {
    let usual = Course::default();
    let fps = positive(table, "fps")?.unwrap_or(usual.fps);
    if fps > 1000.0 {
        return Err("`fps`: at most 1000 frames a second are possible".into());
    }
    let of_frames = positive(table, "frames")?.map(|frames| frames / fps);
    let said = of_frames.or(positive(table, "seconds")?);
    let shutter = number(table, "shutter")?.unwrap_or(0.0);
    if !(0.0..=1.0).contains(&shutter) {
        return Err("`shutter` is no share from 0 to 1".into());
    }
    let mut course = Course { fps, shutter, ..usual };
    let bookmarks = table.get("bookmarks").and_then(Value::as_str);
    let bookmarks = bookmarks.map(|name| path.with_file_name(name)).or_else(|| cameras.bookmarks.clone());
    let cameras = Cameras { bookmarks, scene: cameras.scene.clone(), ..*cameras };
    if let Some(camera) = table.get("camera") {
        let camera = camera.as_table().ok_or("`camera` is no table")?;
        read_camera(camera, &mut course, &cameras)?;
        table.remove("camera");
    }
    course.seconds = said.unwrap_or(course.keys.last().map_or(course.seconds, |key| key.at + 1.0 / fps));
    ["fps", "frames", "seconds", "shutter"].iter().for_each(|key| _ = table.remove(*key));
    Ok(course)
}

fn read_camera(camera: &Table, course: &mut Course, cameras: &Cameras) -> Result<(), String> {
    const KEYS: [&str; 4] = ["path", "ease", "look_at", "focus"];
    if let Some(key) = camera.keys().find(|key| !KEYS.contains(&key.as_str())) {
        return Err(format!(
            "`camera.{key}`: the timeline has cameras at times alone; `voxtrace animate` renders this"
        ));
    }
    let path = camera.get("path").and_then(Value::as_array).ok_or("`camera.path` is missing")?;
    if path.len() > MOST_KEYS {
        return Err(format!("`camera.path` has more than {MOST_KEYS} keys"));
    }
    for (number, entry) in path.iter().enumerate() {
        let fault = |reason: String| format!("`camera.path[{number}]`: {reason}");
        let entry = entry.as_table().ok_or_else(|| fault("it is no table".into()))?;
        let at = number_of(entry.get("at")).ok_or_else(|| fault("`at` is missing, the time in seconds".into()))?;
        if course.keys.last().is_some_and(|before| before.at >= at) {
            return Err(fault("`at` is not after the key before".into()));
        }
        course.keys.push(TimeKey::new(at, camera_of(entry, cameras).map_err(fault)?));
    }
    if let Some(word) = camera.get("ease") {
        let ease = EASES.iter().find(|(own, _)| Some(*own) == word.as_str());
        course.ease = ease.ok_or("`camera.ease` is none of none, in, out, in-out")?.1;
    }
    if let Some(point) = camera.get("look_at") {
        let numbers: Option<Vec<f64>> =
            point.as_array().and_then(|numbers| numbers.iter().map(|number| number_of(Some(number))).collect());
        let point = numbers.and_then(|numbers| <[f64; 3]>::try_from(numbers).ok());
        let point = point.ok_or("`camera.look_at` names a part: the timeline looks at points alone")?;
        course.look_at = Some(DVec3::from_array(point).as_vec3());
    }
    course.focuses_on_target = camera.get("focus").and_then(Value::as_str) == Some("target");
    Ok(())
}

/// A camera by its place, by name, or by the number of a bookmark, with what the entry changes about it.
fn camera_of(entry: &Table, cameras: &Cameras) -> Result<Camera, String> {
    let named = match (entry.get("camera").and_then(Value::as_str), entry.get("bookmark").and_then(Value::as_integer)) {
        (Some(name), _) => {
            let found = cameras.of_scene.iter().find(|camera| camera.name == name).cloned();
            Some(found.ok_or_else(|| format!("the scene has no camera {name:?} of its own"))?)
        }
        (None, Some(number)) => {
            let path = cameras.bookmarks.as_deref().ok_or("there are no bookmarks")?;
            let bookmarks = match cameras.scene.clone() {
                Some(scene) => Bookmarks::open_in(path, scene),
                None => Bookmarks::open(path),
            };
            let bookmarks = bookmarks.map_err(|error| error.to_string())?;
            let camera = u8::try_from(number).ok().and_then(|number| bookmarks.get(number).cloned());
            Some(camera.ok_or_else(|| format!("there is no bookmark {number}"))?)
        }
        (None, None) => None,
    };
    let mut table = Table::new();
    if let Some(camera) = &named {
        camera_toml::write(camera, &mut table);
    }
    let own = |key: &str| !["at", "camera", "bookmark"].contains(&key);
    table.extend(entry.iter().filter(|(key, _)| own(key)).map(|(key, value)| (key.clone(), value.clone())));
    if table.contains_key("aperture") && !table.contains_key("lens") {
        table.insert("lens".into(), Value::String("thin-lens".into()));
    }
    camera_toml::read(&table)
}

fn number_of(value: Option<&Value>) -> Option<f64> {
    let value = value?;
    value.as_float().or_else(|| value.as_integer().map(|value| value as f64)).filter(|value| value.is_finite())
}

fn number(table: &Table, key: &str) -> Result<Option<f64>, String> {
    let Some(value) = table.get(key) else { return Ok(None) };
    number_of(Some(value)).map(Some).ok_or_else(|| format!("`{key}` is no number"))
}

fn positive(table: &Table, key: &str) -> Result<Option<f64>, String> {
    match number(table, key)? {
        Some(number) if number <= 0.0 => Err(format!("`{key}` is not above 0")),
        number => Ok(number),
    }
}

#[cfg(test)]
mod tests;
