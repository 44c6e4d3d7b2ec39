//! What can go wrong with a benchmark as a whole. What goes wrong with one cell stands in its results instead, so that the
//! other cells still run.

use crate::plan::{CellError, PlanError};
use crate::reason::reason;
use crate::results::ResumeError;
use std::io;
use std::path::{Path, PathBuf};
use voxtrace::TraceError;
use voxtrace::scenes::SceneError;

/// Why a benchmark ends early.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum BenchError {
    /// A plan that cannot be read or makes no sense.
    #[error(transparent)]
    Plan(#[from] PlanError),
    /// A cell that does not exist.
    #[error(transparent)]
    Cell(#[from] CellError),
    /// A built-in scene cannot be as large, or as small, as is asked for.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// The device that was asked for does not open.
    #[error(transparent)]
    Trace(#[from] TraceError),
    /// The folder holds a benchmark that cannot be gone on with.
    #[error(transparent)]
    Resume(#[from] ResumeError),
    /// A scene is not the one that was measured before.
    #[error("{name} is another scene than before: {before} and {now}")]
    OtherScene {
        /// The scene as the plan names it.
        name: String,
        /// Content hash in the results.
        before: String,
        /// Content hash now.
        now: String,
    },
    /// A file of the report cannot be written.
    #[error("cannot write {}: {}", path.display(), reason(source))]
    Output {
        /// The file or folder.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
}

impl BenchError {
    /// The error of writing a file.
    pub(crate) fn output(path: &Path, source: io::Error) -> Self {
        Self::Output { path: path.to_owned(), source }
    }
}
