//! Why reports cannot be compared.

use super::SCHEMA;
use crate::reason::reason;
use std::io;
use std::path::PathBuf;

/// A report that cannot be compared.
#[derive(Debug, thiserror::Error)]
#[error("{}", self.text())]
#[non_exhaustive]
pub struct CompareError {
    /// The report's `results.json`.
    pub path: PathBuf,
    /// What is wrong with it.
    pub kind: CompareErrorKind,
}

/// What is wrong with a report.
#[derive(Debug)]
#[non_exhaustive]
pub enum CompareErrorKind {
    /// It cannot be read.
    Io(io::Error),
    /// It is no JSON.
    Json(serde_json::Error),
    /// It has a schema of another version, this one.
    Schema(u64),
    /// It is something else.
    NoReport,
}

impl CompareError {
    fn text(&self) -> String {
        let path = self.path.display();
        match &self.kind {
            CompareErrorKind::Io(error) => format!("cannot read {path}: {}", reason(error)),
            CompareErrorKind::Json(error) => format!("{path}: {error}"),
            CompareErrorKind::Schema(other) => format!("{path}: schema {other}, but {SCHEMA} can be read"),
            CompareErrorKind::NoReport => format!("{path}: this is no report of `voxtrace bench`"),
        }
    }
}
