//! Which files were opened for reading, for whoever is about to write files and must not write over these. Readers work on
//! many threads and call each other through many hands, so the record is one for the process; it is kept only from the moment
//! that somebody asks for it.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::Mutex;

static OPENED: Mutex<Option<BTreeSet<PathBuf>>> = Mutex::new(None);

/// Begins to record, if nobody has before.
pub fn record() {
    if let Ok(mut opened) = OPENED.lock() {
        opened.get_or_insert_default();
    }
}

/// Notes a file or folder that is read, or looked for by the name that a file gives it. Readers of this crate do so by
/// themselves.
pub fn note(path: &Path) {
    if let Ok(mut opened) = OPENED.lock()
        && let Some(opened) = opened.as_mut()
        && !opened.contains(path)
    {
        opened.insert(path.into());
    }
}

/// What was noted since [`record`], in the spelling of whoever asked for it.
pub fn files() -> Vec<PathBuf> {
    OPENED
        .lock()
        .ok()
        .and_then(|opened| opened.as_ref().map(|opened| opened.iter().cloned().collect()))
        .unwrap_or_default()
}

/// What makes two paths the same file: links and spellings do not count.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Identity {
    /// Device and number of a file that is there.
    #[cfg(unix)]
    Node(u64, u64),
    /// Where a file is, or would be if it were there.
    Place(PathBuf),
}

/// What this run reads, as far as it is known by now.
pub struct Inputs {
    files: Vec<Identity>,
    /// Folders that are read whole.
    folders: Vec<PathBuf>,
}

impl Inputs {
    /// All that was noted by the command line and opened by readers.
    pub fn now() -> Self {
        let noted = files();
        let folders = noted.iter().filter(|path| path.is_dir()).filter_map(|path| path.canonicalize().ok());
        Self { folders: folders.collect(), files: noted.iter().filter_map(|path| identity(path)).collect() }
    }

    /// Refuses a file to write that this run reads.
    ///
    /// # Errors
    /// Where it does.
    pub fn refuse(&self, path: &Path) -> Result<(), IsInput> {
        if identity(path).is_some_and(|identity| self.files.contains(&identity)) {
            return Err(IsInput::File);
        }
        let place = place_of(path);
        match self.folders.iter().find(|folder| place.as_ref().is_some_and(|place| place.starts_with(folder))) {
            Some(folder) => Err(IsInput::Folder(folder.clone())),
            None => Ok(()),
        }
    }
}

/// Why a file is not to be written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum IsInput {
    /// It is read, under this name or another.
    #[error("this run reads it")]
    File,
    /// It lies in a folder that is read whole.
    #[error("this run reads the whole folder {}", .0.display())]
    Folder(PathBuf),
}

/// Whether two paths lead to one file.
pub fn is_same(a: &Path, b: &Path) -> bool {
    identity(a).is_some_and(|place| identity(b) == Some(place))
}

fn identity(path: &Path) -> Option<Identity> {
    match std::fs::metadata(path) {
        #[cfg(unix)]
        Ok(metadata) if metadata.is_file() => {
            use std::os::unix::fs::MetadataExt;
            Some(Identity::Node(metadata.dev(), metadata.ino()))
        }
        // A pipe or a terminal may be both.
        Ok(metadata) if !metadata.is_file() => None,
        _ => place_of(path).map(Identity::Place),
    }
}

/// Where a path leads, also where its file is not there yet.
fn place_of(path: &Path) -> Option<PathBuf> {
    let whole = path.canonicalize();
    let beside = || {
        let parent = path.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."));
        Some(parent.canonicalize().ok()?.join(path.file_name()?))
    };
    whole.ok().or_else(beside)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    #[test]
    fn a_file_is_the_same_by_any_name() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        fs::create_dir(at("b")).unwrap();
        fs::write(at("a"), "a").unwrap();
        fs::write(at("c"), "a").unwrap();
        fs::hard_link(at("a"), at("hard")).unwrap();
        assert_eq!(identity(&at("a")), identity(&at("b/../a")));
        #[cfg(unix)]
        {
            std::os::unix::fs::symlink("a", at("soft")).unwrap();
            assert_eq!(identity(&at("a")), identity(&at("soft")));
            assert_eq!(identity(&at("a")), identity(&at("hard")));
            assert_eq!(identity(Path::new("/dev/null")), None);
        }
        assert_eq!(identity(&at("no")), identity(&at("b/../no")));
        assert_ne!(identity(&at("a")), identity(&at("c")), "the comparison sees another file");
        assert_ne!(identity(&at("no")), identity(&at("none")));
    }
}
