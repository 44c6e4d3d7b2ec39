//! Small files of TOML that the window keeps beside a scene: read whole, changed in place, written atomically. What others wrote there
//! meanwhile and keys that nobody knows stay, comments do not; a damaged file is never written over.

use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};
use toml::Table;
use voxtrace_core::atomic_file::write_atomically;

/// Largest file that is read.
const MOST_BYTES: u64 = 1 << 20;

/// Why such a file cannot be read or kept.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum KeptError {
    /// The operating system cannot read the file.
    #[error("cannot read the {what} {}: {source}", path.display())]
    Read {
        /// What it holds.
        what: &'static str,
        /// The file.
        path: PathBuf,
        /// What the system says.
        source: io::Error,
    },
    /// The file is there, but is not one of its kind. It is never written over.
    #[error("the {what} {} are damaged: {reason}", path.display())]
    Damaged {
        /// What it should hold.
        what: &'static str,
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        reason: String,
    },
    /// The operating system cannot write the file.
    #[error("cannot keep the {what} {}: {source}", path.display())]
    Write {
        /// What it was to hold.
        what: &'static str,
        /// The file.
        path: PathBuf,
        /// What the system says.
        source: io::Error,
    },
}

/// Where a file beside a scene's file is: `rooms/church.vxt` has `rooms/church.ENDING`, and so has `rooms/church.vox`. `None` where the path
/// has no name.
pub fn beside(scene: &Path, ending: &str) -> Option<PathBuf> {
    let stem = scene.file_stem()?.to_string_lossy().into_owned();
    // `head.nii.gz` is `head`, as for pictures.
    let stem = stem.strip_suffix(".nii").unwrap_or(&stem);
    Some(scene.with_file_name(format!("{stem}.{ending}")))
}

/// Reads a file of `what`; where there is none, an empty table.
///
/// # Errors
/// [`KeptError::Read`] and [`KeptError::Damaged`].
pub fn read(what: &'static str, path: &Path) -> Result<Table, KeptError> {
    let mut text = String::new();
    let damaged = |reason| KeptError::Damaged { what, path: path.to_path_buf(), reason };
    let file = match std::fs::File::open(path) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(Table::new()),
        file => file,
    };
    match file.and_then(|file| file.take(MOST_BYTES + 1).read_to_string(&mut text)) {
        Ok(bytes) if bytes as u64 > MOST_BYTES => Err(damaged(format!("it has more than {MOST_BYTES} bytes"))),
        Ok(_) => text.parse().map_err(|error: toml::de::Error| damaged(error.message().to_owned())),
        Err(error) if error.kind() == io::ErrorKind::InvalidData => Err(damaged("it is no text".into())),
        Err(source) => Err(KeptError::Read { what, path: path.to_path_buf(), source }),
    }
}

/// Writes a file below a header of comments, whole or not at all.
///
/// # Errors
/// [`KeptError::Write`].
pub fn write(what: &'static str, path: &Path, header: &str, table: &Table) -> Result<(), KeptError> {
    let text = format!("{header}{table}");
    write_atomically(path, |file| file.write_all(text.as_bytes())).map_err(|source| KeptError::Write {
        what,
        path: path.to_path_buf(),
        source,
    })
}
