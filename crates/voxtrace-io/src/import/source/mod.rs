//! What readers are given: a file that is open, bytes in memory, or a folder, and beside it the files that it may name.

#[cfg(feature = "volumes")]
pub(crate) mod archive;
pub(crate) mod folder;
pub(crate) mod guard;
#[cfg(any(feature = "medical", feature = "minecraft", feature = "rasters", feature = "volumes", feature = "voxels"))]
pub(crate) mod inflate;
pub(crate) mod input;
pub(crate) mod listing;
pub mod opened;
pub(crate) mod watch;
#[cfg(any(feature = "rasters", feature = "volumes"))]
pub(crate) mod zstd;

use folder::Folder;
use input::Input;
use std::fs::File;
use std::path::{Path, PathBuf};
use voxtrace_voxelize::{ImportError, Limits};

/// What is to be read. A file is opened once, to be told apart and to be read.
pub struct Source<'a> {
    path: &'a Path,
    content: Content<'a>,
    folder: Folder,
}

enum Content<'a> {
    File(Input<'a>),
    Memory(Input<'a>),
    Folder,
    /// Several files that are read as one.
    Files(Vec<PathBuf>),
}

impl<'a> Source<'a> {
    /// Opens a file or a folder. How long a file may be is asked later, once its format is known.
    pub(crate) fn open(path: &'a Path, limits: &Limits) -> Result<Self, ImportError> {
        if path.is_dir() {
            return Ok(Self { path, content: Content::Folder, folder: Folder::at(path, limits) });
        }
        let input = Input::open(path, &Limits { bytes: u64::MAX, ..*limits })?;
        Ok(Self { path, content: Content::File(input), folder: Folder::of(path, limits) })
    }

    /// A file that is open and of which `head` was read already: a pipe gives its bytes once. As [`Self::open`], else.
    pub(crate) fn of_begun(head: Vec<u8>, file: File, path: &'a Path, limits: &Limits) -> Result<Self, ImportError> {
        let input = Input::of_begun(head, file, path, &Limits { bytes: u64::MAX, ..*limits })?;
        Ok(Self { path, content: Content::File(input), folder: Folder::of(path, limits) })
    }

    /// Several files that are read as one; `path` names them in errors.
    pub(crate) fn of_files(path: &'a Path, files: Vec<PathBuf>) -> Self {
        Self { path, content: Content::Files(files), folder: Folder::none() }
    }

    /// The several files that are read as one: those that were named, or those of a folder with these extensions. `None` where it
    /// is one file.
    pub(crate) fn tiles(&self, extensions: &[&str], limits: &Limits) -> Result<Option<Vec<PathBuf>>, ImportError> {
        match &self.content {
            Content::Files(files) => Ok(Some(files.clone())),
            Content::Folder => listing::files_with(self.path, extensions, limits).map(Some),
            Content::File(_) | Content::Memory(_) => Ok(None),
        }
    }

    /// Bytes in memory; `path` names them in errors. Files that they refer to are not looked for.
    pub(crate) fn of_bytes(bytes: &'a [u8], path: &'a Path, limits: &Limits) -> Result<Self, ImportError> {
        Ok(Self { path, content: Content::Memory(Input::of_bytes(bytes, path, limits)?), folder: Folder::none() })
    }

    /// The file or folder, or the name that was given for bytes in memory.
    pub fn path(&self) -> &'a Path {
        self.path
    }

    /// Whether it is a folder, which has no bytes.
    pub fn is_folder(&self) -> bool {
        matches!(self.content, Content::Folder)
    }

    /// Whether it is bytes in memory, with no files beside them.
    pub(crate) fn is_in_memory(&self) -> bool {
        matches!(self.content, Content::Memory(_))
    }

    /// What comes first, unless it is a folder.
    pub(crate) fn as_input(&mut self) -> Option<&mut Input<'a>> {
        match &mut self.content {
            Content::File(input) | Content::Memory(input) => Some(input),
            Content::Folder | Content::Files(_) => None,
        }
    }

    /// The bytes, and the files beside them.
    pub(crate) fn into_input(self) -> Result<(Input<'a>, Folder), ImportError> {
        match self.content {
            Content::File(input) | Content::Memory(input) => Ok((input, self.folder)),
            Content::Folder | Content::Files(_) => {
                Err(ImportError::io(self.path, std::io::ErrorKind::IsADirectory.into()))
            }
        }
    }

    /// All bytes.
    ///
    /// # Errors
    /// If there are more than [`Limits::bytes`], they cannot be read, or it is a folder.
    pub fn into_bytes(self) -> Result<Vec<u8>, ImportError> {
        self.into_input()?.0.rest()
    }
}
