//! What formats are told by where extensions and first bytes do not say enough.

use super::options::ImportOptions;
use crate::import::source::listing;
use std::cell::OnceCell;
use std::path::{Path, PathBuf};
use voxtrace_voxelize::{ImportError, Limits};

/// Bytes of a file's head that readers may look at.
pub(crate) const HEAD: usize = 132;

/// What is known of a file before it is read.
#[derive(Clone, Copy, Debug)]
pub struct FileClues<'a> {
    /// Its name.
    pub path: &'a Path,
    /// Its first bytes: 132, or all.
    pub head: &'a [u8],
    /// How long it is, unless it is a pipe.
    pub length: Option<u64>,
    /// What was asked for.
    pub options: &'a ImportOptions,
}

/// How sure a reader is that a file is of its format.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Recognition {
    /// Whatever its first bytes and its name say.
    Sure,
    /// If neither first bytes nor the name say anything.
    Likely,
    /// No sign of it.
    Unknown,
}

/// What is known of a folder.
pub struct FolderClues<'a> {
    /// Its path.
    pub path: &'a Path,
    limits: &'a Limits,
    files: OnceCell<Vec<PathBuf>>,
}

impl<'a> FolderClues<'a> {
    pub(crate) fn new(path: &'a Path, limits: &'a Limits) -> Self {
        Self { path, limits, files: OnceCell::new() }
    }

    /// Its files without those in folders of it and hidden ones, as people count: 2 before 10.
    ///
    /// # Errors
    /// If they cannot be listed, or are more than [`Limits::items`].
    pub fn files(&self) -> Result<&[PathBuf], ImportError> {
        if let Some(files) = self.files.get() {
            return Ok(files);
        }
        let files = listing::files(self.path, self.limits)?;
        Ok(self.files.get_or_init(|| files))
    }

    /// What may at most be asked for.
    pub fn limits(&self) -> &Limits {
        self.limits
    }
}
