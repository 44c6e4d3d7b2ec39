//! What must hold for any bytes that are read as a file of voxels; shared by the fuzz target and the tests.

use std::path::Path;
use voxtrace::PackedScene;
use voxtrace::import::{self, BlockOptions, BlockSize, ImportErrorKind, ImportOptions, Kind, Limits, READERS};

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

/// Either there is an error that says where, or a scene that can be packed; blocks as cubes, and, of Minecraft, with their shapes.
///
/// # Panics
/// If not.
pub fn check(name: &str, bytes: &[u8]) {
    let options = ImportOptions { limits: LIMITS, ..ImportOptions::default() };
    check_with(name, bytes, &options);
    let has_blocks = |reader: &&import::Reader| reader.name.starts_with("Minecraft");
    let is_build = READERS.iter().filter(has_blocks).any(|reader| reader.extension_of(Path::new(name)).is_some());
    // The bytes say whether and how, so that a file that fails fails again.
    let choice = bytes.iter().fold(0usize, |sum, &byte| sum + usize::from(byte)) % 32;
    if is_build && choice < 8 {
        let blocks = BlockOptions { size: BlockSize::ALL[1 + choice % 4], shell: choice < 4, resource_pack: None };
        check_with(name, bytes, &ImportOptions { blocks, strict: choice < 4, ..options });
    }
}

fn check_with(name: &str, bytes: &[u8], options: &ImportOptions) {
    match import::voxels_from_bytes(bytes, Path::new(name), options) {
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
