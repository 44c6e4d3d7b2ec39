//! What must hold for any bytes that are read as a file of voxels; shared by the fuzz target and the tests.

use std::path::Path;
use voxtrace::PackedScene;
use voxtrace::import::{self, ImportErrorKind, ImportOptions, Kind, Limits, READERS};

/// Limits small enough for a million runs.
const LIMITS: Limits =
    Limits { bytes: 1 << 20, voxels: 1 << 16, points: 1 << 14, items: 1 << 12, depth: 64, ratio: 200 };

/// Extensions that lead to each reader of this kind.
pub fn extensions() -> Vec<&'static str> {
    let readers = READERS.iter().filter(|reader| reader.kind == Kind::Voxels);
    let mut extensions: Vec<&str> = readers.flat_map(|reader| reader.extensions).copied().collect();
    // One page is a heightmap.
    extensions.push("tif");
    extensions
}

/// [`check`] by every reader that may be meant: the one that the first bytes tell, or where they say nothing, all.
pub fn check_all(bytes: &[u8]) {
    let is_told = READERS.open_bytes(bytes, Path::new("fuzzed"), &ImportOptions::default()).is_ok();
    let extensions = extensions();
    let asked = if is_told { 1 } else { extensions.len() };
    extensions.iter().take(asked).for_each(|extension| check(&format!("fuzzed.{extension}"), bytes));
}

/// Either there is an error that says where, or a scene that can be packed.
///
/// # Panics
/// If not.
pub fn check(name: &str, bytes: &[u8]) {
    let options = ImportOptions { limits: LIMITS, ..ImportOptions::default() };
    match import::voxels_from_bytes(bytes, Path::new(name), &options) {
        Err(error) => {
            let is_limit = matches!(error.kind, ImportErrorKind::Limit { .. });
            assert!(error.offset.is_some() || is_limit, "no offset: {error}");
            assert!(!error.to_string().contains("the decoder failed"), "a reader panicked: {error}");
        }
        Ok(voxels) => {
            let count: u64 = voxels.scene.grids.iter().map(|grid| grid.count()).sum();
            assert!(count <= LIMITS.voxels, "{count} voxels");
            PackedScene::pack(&voxels.scene).expect("readers make whole scenes");
        }
    }
}
