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
        ImportErrorKind::Unsupported(what) if what.starts_with("a film (.vxf)") => failure.hint(
            "`voxtrace merge FILM -o picture.png` makes a picture of it, `voxtrace info FILM` tells of its samples",
        ),
        ImportErrorKind::Truncated(_) | ImportErrorKind::Malformed(_) => {
            failure.hint("the file is damaged; try to export it again")
        }
        ImportErrorKind::NothingChosen(_) => failure.hint("--classes and --bounds say which points are read"),
        ImportErrorKind::OtherTiles(what) if what.ends_with("have different units") => {
            failure.hint("--unit says the one that the numbers of all of them are in")
        }
        ImportErrorKind::OtherTiles(_) => failure.hint("make a scene of each, or name the files that belong together"),
        ImportErrorKind::Native(_) => failure.hint("convert the scene again with this version of voxtrace"),
        ImportErrorKind::Stopped => interrupt::failure(),
        ImportErrorKind::Limit { what, .. } if can_be_lifted(what) => {
            failure.hint("the limit protects from hostile files; --trusted lifts it")
        }
        ImportErrorKind::Limit { .. } => failure.hint("the limit protects from hostile files, and nothing lifts it"),
        _ => failure,
    }
}

/// Whether `--trusted` lifts a limit: not that of depth, which takes from the stack, nor what formats and readers have room for.
pub fn can_be_lifted(what: &str) -> bool {
    const FIXED: [&str; 11] = [
        "bytes of a sample",
        "bytes of a table of label colours",
        "bytes of the header",
        "colours of volumes over each other",
        "depth",
        "files of a resource pack",
        "nesting",
        "sections of a chunk",
        "states of a chunk",
        "tiles of the grid",
        "voxels along an axis",
    ];
    !FIXED.iter().any(|fixed| what.starts_with(fixed))
}

fn unreadable(path: &Path, error: &std::io::Error) -> Failure {
    if path.as_os_str().is_empty() {
        return Failure::input("a scene's name is empty").hint("name a file, or one of the built-in scenes");
    }
    let failure = Failure::input(format!("cannot read {}: {}", path.display(), reason(error)));
    if error.kind() == std::io::ErrorKind::NotFound && path.exists() {
        return failure.hint("a file that it names is looked for in its folder");
    }
    if error.kind() == std::io::ErrorKind::NotFound {
        return failure.hint(format!("a scene is a file or one of the built-in {}", scenes::NAMES.join(", ")));
    }
    failure
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limits_that_nobody_can_lift_are_told_without_the_option_that_lifts_limits() {
        let told = |what: &str| import_failure(&ImportError::limit(Path::new("a.vox"), None, what, 9, 8)).line();
        for fixed in ["depth of the scene graph", "depth of nested tags", "nesting", "bytes of the header"] {
            assert!(!told(fixed).contains("--trusted") && told(fixed).contains("nothing lifts it"), "{}", told(fixed));
        }
        for lifted in ["voxels", "voxels of the whole box", "bytes of input", "points", "bytes of a chunk"] {
            assert!(told(lifted).contains("--trusted lifts it"), "{}", told(lifted));
        }
    }

    #[test]
    fn meshes_of_different_units_are_told_with_the_option_that_gives_them_one() {
        let told = |what: &str| {
            let kind = ImportErrorKind::OtherTiles(what.into());
            import_failure(&ImportError::of_file(Path::new("a.glb"), kind)).line()
        };
        assert!(told("a and b have different units").contains("--unit"));
        assert!(told("the tile is in the reference system A, and b.laz is in B").contains("belong together"));
    }
}
