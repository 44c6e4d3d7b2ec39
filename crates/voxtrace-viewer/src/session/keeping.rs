//! What is kept beside the scene: where its files are, and the bookmarks.

use super::Session;
use crate::bookmarks::{BookmarkError, Bookmarks, Seen};
use crate::dialogs::Dialog;
use crate::kept_file;
use crate::navigation::Motion;
use crate::scale::Scale;
use crate::tr;
use std::path::{Path, PathBuf};
use voxtrace::scenes;

/// Whether a scene needs no file.
pub(crate) fn is_built_in(source: &str) -> bool {
    scenes::NAMES.contains(&source)
}

impl Session {
    /// The file of the scene's bookmarks.
    pub fn bookmark_path(&self) -> Option<PathBuf> {
        self.beside_scene("cameras.toml")
    }

    /// The bookmarks of the scene, in its voxels; `None` where there is no place for them.
    pub(crate) fn bookmarks(&self) -> Option<Result<Bookmarks, BookmarkError>> {
        Some(Bookmarks::open_in(&self.bookmark_path()?, self.scene_of_bookmarks()?))
    }

    /// The scene as bookmarks are seen in it.
    pub(crate) fn scene_of_bookmarks(&self) -> Option<Seen> {
        self.open.as_ref().map(|open| Seen::new(&open.source, Scale::of(&open.original)))
    }

    /// A file that is kept beside the scene: of built-in scenes beside the settings, whose folder may not be there yet.
    pub(crate) fn beside_scene(&self, ending: &str) -> Option<PathBuf> {
        let source = &self.open.as_ref()?.source;
        // What no file holds yet has no place for them.
        if self.is_untitled() {
            return None;
        }
        match is_built_in(source) {
            true => self.settings_folder.as_deref().map(|folder| folder.join(format!("{source}.{ending}"))),
            false => kept_file::beside(Path::new(source), ending),
        }
    }

    /// Makes the folder of such a file. That it cannot be made, writing says.
    pub(crate) fn make_kept_folder(&self) {
        let is_ours = self.open.as_ref().is_some_and(|open| is_built_in(&open.source));
        if let Some(folder) = self.settings_folder.as_deref().filter(|_| is_ours) {
            let _ = std::fs::create_dir_all(folder);
        }
    }

    pub(crate) fn go_to_bookmark(&mut self, number: u8) {
        match self.bookmarks() {
            None => {}
            Some(Ok(bookmarks)) => match bookmarks.get(number).cloned() {
                Some(camera) => self.move_by(Motion::GoTo(camera)),
                None => self.say(tr!("said.bookmark_is_empty_shift_keeps_this", number = number), false),
            },
            Some(Err(error)) => self.say(error.to_string(), true),
        }
    }

    pub(crate) fn store_bookmark(&mut self, number: u8) {
        let Some((path, bookmarks)) = self.bookmark_path().zip(self.bookmarks()) else {
            if self.is_untitled() {
                self.say(tr!("said.save_the_scene_first"), false);
            }
            return;
        };
        self.make_kept_folder();
        let camera = self.navigator.camera().clone();
        let stored = bookmarks.and_then(|mut bookmarks| bookmarks.store(number, &camera));
        match stored {
            Ok(()) => {
                self.say(tr!("said.bookmark_kept", number = number, path = path.display()), false);
                if let Some(Dialog::Frames(mut dialog)) = self.dialog.take() {
                    dialog.refresh(self);
                    self.dialog = Some(Dialog::Frames(dialog));
                }
            }
            Err(error) => self.say(error.to_string(), true),
        }
    }
}
