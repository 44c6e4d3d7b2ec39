//! What must hold for any bytes that are read as a volume; shared by the fuzz target and the tests.

use std::path::Path;
use voxtrace::import::{self, ImportErrorKind, ImportOptions, Kind, Limits, READERS};
use voxtrace::volume::{self, VolumeError, VolumeOptions};

/// Limits small enough for a million runs.
const LIMITS: Limits =
    Limits { bytes: 1 << 20, voxels: 1 << 14, points: 1 << 14, items: 1 << 10, depth: 64, ratio: 200 };

/// Extensions that lead to each reader of this kind.
pub fn extensions() -> Vec<&'static str> {
    let readers = READERS.iter().filter(|reader| reader.kind == Kind::Volume);
    readers.flat_map(|reader| reader.extensions).copied().collect()
}

/// [`check`] by every reader that may be meant: the one that the first bytes tell, or where they say nothing, all.
pub fn check_all(bytes: &[u8]) {
    let is_told = READERS.open_bytes(bytes, Path::new("fuzzed"), &ImportOptions::default()).is_ok();
    let extensions = extensions();
    let asked = if is_told { 1 } else { extensions.len() };
    extensions.iter().take(asked).for_each(|extension| check(&format!("fuzzed.{extension}"), bytes));
}

/// Either there is an error that says where, or a volume that holds together and becomes voxels, or shows nothing.
///
/// # Panics
/// If not.
pub fn check(name: &str, bytes: &[u8]) {
    let options = ImportOptions { limits: LIMITS, ..ImportOptions::default() };
    match import::volume_from_bytes(bytes, Path::new(name), &options) {
        Err(error) => {
            let is_limit = matches!(error.kind, ImportErrorKind::Limit { .. });
            assert!(error.offset.is_some() || is_limit, "no offset: {error}");
            assert!(!error.to_string().contains("the decoder failed"), "a reader panicked: {error}");
        }
        Ok(volume) => {
            volume.validate().expect("readers make whole volumes");
            match volume::voxelize(&volume, &VolumeOptions::default(), &LIMITS) {
                Ok(scene) => assert!(!scene.grids[0].is_empty() && scene.materials.len() <= 256),
                Err(VolumeError::Empty { .. } | VolumeError::BadScale(_) | VolumeError::TooLarge { .. }) => {}
                Err(error) => panic!("{error}"),
            }
        }
    }
}
