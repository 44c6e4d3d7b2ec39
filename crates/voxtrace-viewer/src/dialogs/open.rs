//! Opening and writing scenes by the path of their file.

use super::PathField;
use crate::session::Session;
use crate::{text_key, tr};
use std::path::{Path, PathBuf};

/// Opening a scene.
#[derive(Clone, Debug, Default)]
pub struct OpenDialog {
    /// Where it is.
    pub path: PathField,
}

impl OpenDialog {
    /// Begins in the usual folder.
    pub fn new(session: &Session) -> Self {
        Self { path: PathField::new(&session.usual_folder().join("")) }
    }

    /// What is to be opened: a file, or a folder that is a scene (a series, a world, a stack of slices).
    ///
    /// # Errors
    /// One line: what is missing yet.
    pub fn request(&self) -> Result<PathBuf, String> {
        let path = self.path.path().ok_or(tr!("dialogs.name_a_file"))?;
        if path.exists() { Ok(path) } else { Err(tr!("dialogs.no_such_file").into()) }
    }
}

/// Writing the scene.
#[derive(Clone, Debug)]
pub struct SaveDialog {
    /// Where it is written.
    pub path: PathField,
    /// Whether a file that is there is written over.
    pub replaces: bool,
    replaces_what: String,
}

/// Endings of the files that scenes are written to, and what these hold.
pub const SCENE_KINDS: [(&str, &str); 2] =
    [("vxt", text_key!("dialogs_scene.vxt")), ("vox", text_key!("dialogs_scene.vox"))];

impl SaveDialog {
    /// Begins with a free name beside the scene.
    pub fn new(session: &Session) -> Self {
        let (folder, stem) = (session.usual_folder(), session.stem());
        let name =
            |number: u32| folder.join(if number < 2 { format!("{stem}.vxt") } else { format!("{stem}-{number}.vxt") });
        let free = (1..).map(name).find(|path| !path.exists()).unwrap_or_default();
        Self { path: PathField::new(&free), replaces: false, replaces_what: String::new() }
    }

    /// The ending of the file's name, in small letters.
    pub fn ending(&self) -> String {
        let ending = Path::new(self.path.text.trim()).extension().unwrap_or_default();
        ending.to_string_lossy().to_ascii_lowercase()
    }

    /// Gives the file's name another ending.
    pub fn set_ending(&mut self, ending: &str) {
        self.path.text = PathBuf::from(self.path.text.trim()).with_extension(ending).display().to_string();
    }

    /// Whether the file is there already. What was said of another file does not count for this one.
    pub fn is_there(&mut self) -> bool {
        if self.replaces_what != self.path.text {
            (self.replaces, self.replaces_what) = (false, self.path.text.clone());
        }
        self.path.path().is_some_and(|path| path.exists())
    }

    /// Where the scene is to be written.
    ///
    /// # Errors
    /// One line: what is missing yet.
    pub fn request(&mut self) -> Result<PathBuf, String> {
        let path = self.path.path().ok_or(tr!("dialogs.name_a_file"))?;
        if !SCENE_KINDS.iter().any(|(ending, _)| *ending == self.ending()) {
            return Err(tr!("dialogs_scene.endings").into());
        }
        if self.is_there() && !self.replaces {
            return Err(tr!("dialogs.file_there").into());
        }
        Ok(std::path::absolute(&path).unwrap_or(path))
    }
}
