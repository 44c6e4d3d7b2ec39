//! Writing scenes to files of other programs.

pub mod native;
pub mod vox;

use std::path::PathBuf;

/// A scene could not be written to a file.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ExportError {
    /// The operating system refused.
    #[error("{}: {error}", path.display())]
    Io {
        /// The file.
        path: PathBuf,
        /// What the system says.
        #[source]
        error: std::io::Error,
    },
    /// The format cannot place an instance so.
    #[error("instance {instance} {name:?}: {format} {reason}")]
    Placement {
        /// The format, for example `.vox`.
        format: &'static str,
        /// Index of the instance.
        instance: usize,
        /// Its name.
        name: String,
        /// What the format lacks.
        reason: &'static str,
    },
    /// The scene does not fit the format.
    #[error("{what} do not fit {format}")]
    TooLarge {
        /// The format, for example `.vox`.
        format: &'static str,
        /// What is too much.
        what: &'static str,
    },
}
