//! Files that cannot be read: what is said of them, and what may help.

use crate::failure::{Failure, reason};
use crate::interrupt;
use std::path::Path;
use voxtrace::import::{ImportError, ImportErrorKind};
use voxtrace::scenes;

/// The failure of reading a file.
pub fn import_failure(error: &ImportError) -> Failure {
    let failure = Failure::input(error);
    match &error.kind {
        ImportErrorKind::Io(io) => unreadable(&error.path, io),
        ImportErrorKind::UnknownFormat(_) => failure.hint("`voxtrace formats` lists what can be read"),
        ImportErrorKind::Truncated(_) | ImportErrorKind::Malformed(_) => {
            failure.hint("the file is damaged; try to export it again")
        }
        ImportErrorKind::NothingChosen(_) => failure.hint("--classes and --bounds say which points are read"),
        ImportErrorKind::OtherTiles(_) => failure.hint("make a scene of each, or name the files that belong together"),
        ImportErrorKind::Native(_) => failure.hint("convert the scene again with this version of voxtrace"),
        ImportErrorKind::Stopped => interrupt::failure(),
        ImportErrorKind::Limit { .. } => failure.hint("the limit protects from hostile files; --trusted lifts it"),
        _ => failure,
    }
}

fn unreadable(path: &Path, error: &std::io::Error) -> Failure {
    let failure = Failure::input(format!("cannot read {}: {}", path.display(), reason(error)));
    if error.kind() == std::io::ErrorKind::NotFound && path.exists() {
        return failure.hint("a file that it names is looked for in its folder");
    }
    if error.kind() == std::io::ErrorKind::NotFound {
        return failure.hint(format!("a scene is a file or one of the built-in {}", scenes::NAMES.join(", ")));
    }
    failure
}
