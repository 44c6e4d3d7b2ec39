//! What can be wrong with a native file.

use super::file::STREAMED_VERSION;
use std::io;
use std::path::PathBuf;

/// A native file cannot be opened or saved.
#[derive(Debug, thiserror::Error)]
#[error("{}: {kind}", path.display())]
#[non_exhaustive]
pub struct FileError {
    /// The file.
    pub path: PathBuf,
    /// What is wrong.
    pub kind: FileErrorKind,
}

/// The kind of fault in a [`FileError`].
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum FileErrorKind {
    /// The operating system refused.
    #[error("{0}")]
    Io(#[from] io::Error),
    /// The first bytes are those of something else.
    #[error("not a voxtrace scene (at byte 0)")]
    NotVoxtrace,
    /// Written by another version of the format.
    #[error(
        "format version {0}, but this voxtrace reads versions 1 to {STREAMED_VERSION} (at byte 8); a newer one reads it"
    )]
    Version(u32),
    /// The file is shorter than it says, or its table is wrong.
    #[error("truncated or damaged: {what} (at byte {offset})")]
    Damaged {
        /// What is wrong.
        what: String,
        /// Where.
        offset: u64,
    },
    /// The sections are whole but contradict each other.
    #[error("inconsistent scene: {0}")]
    Invalid(voxtrace_scene::Invalid),
}

pub(super) fn damaged(what: impl Into<String>, offset: u64) -> FileErrorKind {
    FileErrorKind::Damaged { what: what.into(), offset }
}
