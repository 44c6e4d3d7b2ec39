//! Edits that outlive a window that was killed: a scene and a note about it, beside the settings, written while there are edits that no file
//! holds. While a window lives it has the lock of its note, so that others leave it alone.

use crate::tr;
use serde::{Deserialize, Serialize};
use std::fs::File;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::time::{SystemTime, UNIX_EPOCH};
use voxtrace::PackedScene;
use voxtrace_core::atomic_file::write_atomically;

/// The folder, beside the settings.
const FOLDER: &str = "recovery";

/// What is said about a scene that was left behind.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Note {
    /// The scene's name.
    pub name: String,
    /// The path or name that it was opened by.
    pub source: String,
    /// The file that edits were saved to, an earlier state of them.
    pub saved_to: Option<PathBuf>,
}

/// The recovery file of a window.
#[derive(Debug)]
pub struct Recovery {
    folder: PathBuf,
    /// Its names without their endings, once something was written.
    stem: Option<PathBuf>,
    /// The file whose lock says that the window lives.
    lock: Option<File>,
}

/// Edits that a window left behind.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Left {
    /// What is said about them.
    pub note: Note,
    /// The scene.
    pub scene: PathBuf,
    /// When it was written.
    pub written: Option<SystemTime>,
}

impl Left {
    /// Deletes them.
    pub fn discard(&self) {
        // What cannot be deleted is offered again.
        for ending in ["toml", "lock", "vxt"] {
            let _ = std::fs::remove_file(self.scene.with_extension(ending));
        }
    }
}

impl Recovery {
    /// Of a window whose settings are in a folder.
    pub fn new(settings: &Path) -> Self {
        Self { folder: settings.join(FOLDER), stem: None, lock: None }
    }

    /// Writes a scene, whole or not at all.
    ///
    /// # Errors
    /// One line: why it cannot be written.
    pub fn write(&mut self, scene: &PackedScene, note: &Note) -> Result<(), String> {
        let folder = self.folder.clone();
        let text = |error: &dyn std::fmt::Display| tr!("edit.not_kept", folder = folder.display(), error = error);
        let stem = match &self.stem {
            Some(stem) => stem.clone(),
            None => self.begin().map_err(|error| text(&error))?,
        };
        scene.save(&stem.with_extension("vxt")).map_err(|error| text(&error))?;
        let table = toml::to_string(note).map_err(|error| text(&error))?;
        write_atomically(&stem.with_extension("toml"), |file| file.write_all(table.as_bytes()))
            .map_err(|error| text(&error))
    }

    /// Finds a name and takes its lock.
    fn begin(&mut self) -> io::Result<PathBuf> {
        std::fs::create_dir_all(&self.folder)?;
        let since = SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default();
        let stem = self.folder.join(format!("{}-{}", std::process::id(), since.as_nanos()));
        let lock = File::create(stem.with_extension("lock"))?;
        // Where the system has no locks, others may offer what is still in use.
        let _ = lock.try_lock();
        (self.lock, self.stem) = (Some(lock), Some(stem.clone()));
        Ok(stem)
    }

    /// Deletes what was written: a file holds the edits, or nobody wants them.
    pub fn remove(&mut self) {
        self.lock = None;
        if let Some(stem) = self.stem.take() {
            for ending in ["toml", "lock", "vxt"] {
                // What cannot be deleted is offered at the next start.
                let _ = std::fs::remove_file(stem.with_extension(ending));
            }
        }
    }
}

/// What windows left behind that do not live any more, the newest first.
pub fn left_behind(settings: &Path) -> Vec<Left> {
    let Ok(entries) = std::fs::read_dir(settings.join(FOLDER)) else { return Vec::new() };
    let is_note = |path: &PathBuf| path.extension().is_some_and(|ending| ending == "toml");
    let mut all: Vec<Left> = entries.flatten().map(|entry| entry.path()).filter(is_note).filter_map(left_at).collect();
    all.sort_by_key(|left| std::cmp::Reverse(left.written));
    all
}

fn left_at(path: PathBuf) -> Option<Left> {
    let note = toml::from_str(&std::fs::read_to_string(&path).ok()?).ok()?;
    let scene = path.with_extension("vxt");
    let written = std::fs::metadata(&scene).ok()?.modified().ok();
    // Whose lock is held lives. One without a lock file was left by whoever could make none.
    let lives = File::open(path.with_extension("lock")).is_ok_and(|lock| lock.try_lock().is_err());
    (!lives).then_some(Left { note, scene, written })
}

#[cfg(test)]
mod tests {
    use super::*;
    use voxtrace::glam::IVec3;
    use voxtrace::{Material, Scene, VoxelGrid};

    fn scene(count: i32) -> PackedScene {
        let mut grid = VoxelGrid::new();
        (0..count).for_each(|x| _ = grid.set(IVec3::new(x, 0, 0), 0));
        PackedScene::pack(&Scene::from_grid("row", grid, vec![Material::default()])).unwrap()
    }

    fn note() -> Note {
        Note { name: "row".into(), source: "/x/row.vox".into(), saved_to: Some("/x/row-2.vxt".into()) }
    }

    #[test]
    fn what_a_window_leaves_behind_is_offered_once_it_is_gone_and_holds_its_last_state() {
        let folder = tempfile::tempdir().unwrap();
        let mut window = Recovery::new(folder.path());
        assert_eq!(left_behind(folder.path()), []);
        window.write(&scene(3), &note()).unwrap();
        window.write(&scene(5), &note()).unwrap();
        assert_eq!(left_behind(folder.path()), [], "the window lives");
        let mut other = Recovery::new(folder.path());
        other.write(&scene(7), &note()).unwrap();
        // A window that is killed deletes nothing.
        window.lock = None;
        // A process that another test starts just then has the lock, too, until its program begins.
        let mut left = left_behind(folder.path());
        for _ in 0..6000 {
            if !left.is_empty() {
                break;
            }
            std::thread::sleep(std::time::Duration::from_millis(20));
            left = left_behind(folder.path());
        }
        let [left] = &left[..] else { panic!("{left:?}") };
        assert_eq!(left.note, note());
        assert_eq!(PackedScene::open(&left.scene).unwrap().content_hash(), scene(5).content_hash());
        left.discard();
        assert_eq!(left_behind(folder.path()), []);
        other.remove();
        assert_eq!(std::fs::read_dir(folder.path().join(FOLDER)).unwrap().count(), 0, "nothing stays");
    }

    #[test]
    fn a_note_without_a_scene_and_a_damaged_one_are_left_alone() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::create_dir_all(folder.path().join(FOLDER)).unwrap();
        std::fs::write(folder.path().join(FOLDER).join("1.toml"), toml::to_string(&note()).unwrap()).unwrap();
        std::fs::write(folder.path().join(FOLDER).join("2.toml"), "name = ").unwrap();
        std::fs::write(folder.path().join(FOLDER).join("2.vxt"), "").unwrap();
        assert_eq!(left_behind(folder.path()), []);
        let mut window = Recovery::new(&folder.path().join(FOLDER).join("1.toml"));
        assert!(window.write(&scene(1), &note()).unwrap_err().starts_with("edits cannot be kept in "));
    }
}
