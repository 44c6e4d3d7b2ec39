//! What must hold for any files in a folder of Zarr or N5; shared by the fuzz target and the tests.

use std::fs;
use std::path::Path;
use voxtrace::Volume;
use voxtrace::import::{self, ImportErrorKind, ImportOptions, Limits};
use voxtrace::volume::{self, VolumeError, VolumeOptions};
use voxtrace::voxelize::VoxelizeProgress;

/// Limits small enough for a million runs.
const LIMITS: Limits =
    Limits { bytes: 1 << 20, voxels: 1 << 14, points: 1 << 14, items: 1 << 10, depth: 64, ratio: 200 };

/// Files that a folder may have, by the byte that stands for them.
pub const FILES: [&str; 23] = [
    ".zarray",
    "zarr.json",
    ".zattrs",
    ".zgroup",
    "0/.zarray",
    "0/zarr.json",
    "1/.zarray",
    "0.0.0",
    "0/0/0",
    "0.0.1",
    "1.0.0",
    "c/0/0/0",
    "c/1/0/0",
    "c/0/0/1",
    "0/0.0.0",
    "0/c/0/0/0",
    "1/0.0.0",
    "attributes.json",
    "s0/attributes.json",
    "s1/attributes.json",
    "1/0/0",
    "s0/0/0/0",
    "s1/0/0/0",
];

/// The bytes are files one after the other: of each its place in [`FILES`], its length in two bytes, its content. Either
/// there is an error that says where, or a volume that holds together and becomes voxels, or shows nothing.
///
/// # Panics
/// If not.
pub fn check(mut bytes: &[u8]) {
    let folder = tempfile::Builder::new().suffix(".zarr").tempdir().unwrap();
    while let [number, low, high, rest @ ..] = bytes {
        let (content, rest) = rest.split_at(rest.len().min(usize::from(u16::from_le_bytes([*low, *high]))));
        write(&folder.path().join(FILES[usize::from(*number) % FILES.len()]), content);
        bytes = rest;
    }
    let options = ImportOptions { limits: LIMITS, ..ImportOptions::default() };
    match import::read_volume(folder.path(), &options) {
        Err(error) => {
            let is_of_folder = matches!(error.kind, ImportErrorKind::Limit { .. } | ImportErrorKind::UnknownFormat(_));
            let is_io = matches!(error.kind, ImportErrorKind::Io(_));
            assert!(error.offset.is_some() || is_of_folder || is_io, "no offset: {error}");
            assert!(!error.to_string().contains("the decoder failed"), "a reader panicked: {error}");
        }
        Ok(volume) => {
            volume.validate().expect("readers make whole volumes");
            check_layers(folder.path(), &options, &volume);
            match volume::voxelize(&volume, &VolumeOptions::default(), &LIMITS) {
                Ok(scene) => assert!(!scene.grids[0].is_empty() && scene.materials.len() <= 256),
                Err(VolumeError::Empty { .. } | VolumeError::BadScale(_) | VolumeError::TooLarge { .. }) => {}
                Err(error) => panic!("{error}"),
            }
        }
    }
}

/// What is read layer by layer has the values of what is read at once.
fn check_layers(path: &Path, options: &ImportOptions, volume: &Volume) {
    let Some(mut large) = import::open_large_volume(path, options, 1).expect("what is read at once is opened") else {
        return;
    };
    let survey = large.survey(&VolumeOptions::default(), &VoxelizeProgress::default());
    let survey = survey.expect("what is read at once is read by layers");
    let found = survey.values().expect("the automatic transfer function goes by the values").clone();
    let wanted = volume.statistics();
    assert_eq!((found.lowest, found.highest, found.labels), (wanted.lowest, wanted.highest, wanted.labels));
}

/// Writes a file, unless a name stands for a file as well as a folder.
fn write(path: &Path, content: &[u8]) {
    if let Some(parent) = path.parent() {
        let _ = fs::create_dir_all(parent);
    }
    let _ = fs::write(path, content);
}
