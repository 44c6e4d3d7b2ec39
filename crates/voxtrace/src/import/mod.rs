//! Reading scenes from files.

mod error;
mod limits;
pub mod vox;

pub use error::{ImportError, ImportErrorKind};
pub use limits::Limits;

use crate::scene::Scene;
use std::{fs::File, io::Read, path::Path};

/// How files are read.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ImportOptions {
    /// What a file may at most ask for.
    pub limits: Limits,
}

/// Reads a scene from a file whose format is told by its first bytes, or where they say nothing by its extension.
///
/// # Errors
/// If the file cannot be read, has no known format, or is not what its format says.
pub fn open(path: &Path, options: &ImportOptions) -> Result<Scene, ImportError> {
    let bytes = read_bytes(path, &options.limits)?;
    let extension = path.extension().unwrap_or_default().to_ascii_lowercase();
    if bytes.starts_with(b"VOX ") || extension == "vox" {
        return vox::read_bytes(&bytes, path, &options.limits);
    }
    let what = "MagicaVoxel (.vox) is what voxtrace reads";
    Err(ImportError::at(path, 0, ImportErrorKind::UnknownFormat(what.into())))
}

/// The whole content of a file, as long as it is within the limit.
fn read_bytes(path: &Path, limits: &Limits) -> Result<Vec<u8>, ImportError> {
    let io = |error| ImportError::io(path, error);
    let file = File::open(path).map_err(io)?;
    let length = file.metadata().map_err(io)?.len();
    let mut bytes = Vec::new();
    if length <= limits.bytes {
        // A pipe has no length: read one byte more than allowed to notice what is too long.
        bytes.reserve_exact(usize::try_from(length).unwrap_or(0));
        file.take(limits.bytes.saturating_add(1)).read_to_end(&mut bytes).map_err(io)?;
    }
    let length = length.max(bytes.len() as u64);
    if length > limits.bytes {
        return Err(ImportError::limit(path, None, "bytes of input", length, limits.bytes));
    }
    Ok(bytes)
}
