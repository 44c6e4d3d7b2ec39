//! Errors of reading files: where, what, and what was expected.

use std::path::{Path, PathBuf};
use voxtrace_core::packed::FileErrorKind;

/// A file could not be read as a scene.
#[derive(Debug, thiserror::Error)]
#[error("{}: {kind}{}", path.display(), at(*offset, kind))]
#[non_exhaustive]
pub struct ImportError {
    /// The file, or the name that was given for bytes in memory.
    pub path: PathBuf,
    /// Byte offset of the fault, where there is one.
    pub offset: Option<u64>,
    /// What is wrong.
    pub kind: ImportErrorKind,
}

impl ImportError {
    /// A fault of the file as a whole.
    pub fn of_file(path: &Path, kind: ImportErrorKind) -> Self {
        Self { path: path.into(), offset: None, kind }
    }

    /// The same fault at another place: `offset` is in bytes from the start of the file.
    #[must_use]
    pub fn with_offset(self, offset: Option<u64>) -> Self {
        Self { offset, ..self }
    }

    /// A fault at a byte of the file.
    pub fn at(path: &Path, offset: u64, kind: ImportErrorKind) -> Self {
        Self { path: path.into(), offset: Some(offset), kind }
    }

    /// The file contradicts its format.
    pub fn malformed(path: &Path, offset: u64, what: impl Into<String>) -> Self {
        Self::at(path, offset, ImportErrorKind::Malformed(what.into()))
    }

    /// The file ends inside something.
    pub fn truncated(path: &Path, offset: u64, what: impl Into<String>) -> Self {
        Self::at(path, offset, ImportErrorKind::Truncated(what.into()))
    }

    /// The file asks for more than it may.
    pub fn limit(path: &Path, offset: Option<u64>, what: impl Into<String>, value: u64, limit: u64) -> Self {
        Self { path: path.into(), offset, kind: ImportErrorKind::Limit { what: what.into(), value, limit } }
    }

    /// The operating system refused.
    pub fn io(path: &Path, error: std::io::Error) -> Self {
        let is_stopped = error.get_ref().is_some_and(|error| error.is::<Stopped>());
        let kind = if is_stopped { ImportErrorKind::Stopped } else { error.into() };
        Self { path: path.into(), offset: None, kind }
    }
}

/// Within an error of the system: reading ended because nobody waits for it any more.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, thiserror::Error)]
#[error("reading was stopped")]
pub struct Stopped;

fn at(offset: Option<u64>, kind: &ImportErrorKind) -> String {
    // Faults of native files say it themselves.
    let offset = offset.filter(|_| !matches!(kind, ImportErrorKind::Native(_)));
    offset.map(|offset| format!(" (at byte {offset})")).unwrap_or_default()
}

/// The kind of fault in an [`ImportError`].
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ImportErrorKind {
    /// The operating system refused.
    #[error("{0}")]
    Io(#[from] std::io::Error),
    /// No importer knows the file's name or first bytes.
    #[error("unknown format: {0}")]
    UnknownFormat(String),
    /// The file ends inside something.
    #[error("the file ends inside {0}")]
    Truncated(String),
    /// The file contradicts its format.
    #[error("malformed: {0}")]
    Malformed(String),
    /// A number in the file, or the scene that it describes, goes beyond [`crate::Limits`].
    #[error("{what}: {value} is more than the limit of {limit}")]
    Limit {
        /// What is limited, for example `voxels`.
        what: String,
        /// What the file asks for.
        value: u64,
        /// What is allowed.
        limit: u64,
    },
    /// A native file that this voxtrace cannot open.
    #[error("{0}")]
    Native(FileErrorKind),
    /// Valid, but not something that voxtrace reads.
    #[error("not supported: {0}")]
    Unsupported(String),
    /// None of the points is of the classes and in the box that are asked for, or they have no classes.
    #[error("{0}")]
    NothingChosen(String),
    /// Files that are to be one cloud do not fit together.
    #[error("{0}")]
    OtherTiles(String),
    /// Nobody waits for it any more.
    #[error("reading was stopped")]
    Stopped,
}
