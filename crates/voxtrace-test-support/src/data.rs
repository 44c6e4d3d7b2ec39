//! Files that other programs have made: `shared/data` beside the repository, or the folder that `VOXTRACE_DATA` names.

use crate::{Need, skip_without};
use std::path::{Path, PathBuf};

/// The folder; where there is none, `None`, and the caller's test is skipped.
///
/// # Panics
/// There, with `VOXTRACE_REQUIRE_DATA=1`.
pub fn data() -> Option<PathBuf> {
    let beside = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/data");
    let folder = std::env::var_os("VOXTRACE_DATA").map_or(beside, PathBuf::from);
    if !folder.is_dir() {
        skip_without(Need::Data, &format!("no folder {}", folder.display()));
        return None;
    }
    Some(folder)
}

/// Files below a folder whose names end in a dot and one of `extensions` (in lower case), or if there are none, all; sorted.
///
/// # Panics
/// Where a folder cannot be read.
pub fn files_below(folder: &Path, extensions: &[&str]) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for path in std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
        if path.is_dir() {
            found.extend(files_below(&path, extensions));
            continue;
        }
        let name = path.file_name().unwrap_or_default().to_string_lossy().to_ascii_lowercase();
        let ends_in = |extension: &&str| name.strip_suffix(*extension).is_some_and(|stem| stem.ends_with('.'));
        if extensions.is_empty() || extensions.iter().any(ends_in) {
            found.push(path);
        }
    }
    found.sort();
    found
}
