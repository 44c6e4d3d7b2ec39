//! When a scene changes: with its file, and with what its reader looks for beside it. Which files these are only the reader knows, and some take whatever
//! lies in the folder (the slices of a series). So all of the folder counts, unless the file's format has everything in one file.

use crate::places::{Place, stamp_of};
use crate::upload;
use std::collections::VecDeque;
use std::fs::{self, DirEntry};
use std::path::Path;
use voxtrace::import::{ImportOptions, READERS};
use xxhash_rust::xxh3::Xxh3;

/// Formats whose readers look for no other file, by their names in the table of readers.
const ALONE: [&str; 20] = [
    "voxtrace",
    "STL",
    "LAS",
    "XYZ",
    "PCD",
    "E57",
    "Minecraft build",
    "Qubicle",
    "Slab6",
    "Voxlap",
    "Goxel",
    "binvox",
    "NumPy",
    "NumPy archive",
    "raw samples",
    "OpenVDB",
    "Zarr",
    "heightmap",
    "slices",
    "FreeSurfer",
];
/// Extensions of files that are scenes themselves and that no other file takes for its data: what is added beside a scene changes nothing of it.
const NEVER_BESIDE: [&str; 6] = ["glb", "gltf", "obj", "stl", "vox", "vxt"];
/// Files of a folder that count, those above first.
const MOST_FILES: usize = 50_000;

/// Whether a scene is in one file.
pub fn is_alone(place: &Place, options: &ImportOptions) -> bool {
    let reader = || READERS.open(&place.path, options).map(|opened| opened.reader().name);
    place.metadata.is_file() && reader().is_ok_and(|name| ALONE.contains(&name))
}

/// Changes when a scene may: a hash of names, lengths and times of all that it may be read from.
pub fn version(place: &Place, options: &ImportOptions) -> u128 {
    let mut hash = Xxh3::new();
    if place.metadata.is_file() {
        add_stamp(&mut hash, place.version());
    }
    if place.metadata.is_dir() {
        add_folder(&mut hash, &place.path, true);
    } else if !is_alone(place, options) {
        add_folder(&mut hash, place.path.parent().unwrap_or(&place.path), false);
    }
    hash.digest128()
}

/// Adds what is below a folder. Where the folder is the scene, every file of it counts, and links to folders in it are followed as readers do.
fn add_folder(hash: &mut Xxh3, top: &Path, is_scene: bool) {
    let mut folders = VecDeque::from([top.to_owned()]);
    let mut left = MOST_FILES;
    while let Some(folder) = folders.pop_front() {
        // A folder that nobody may list has nothing to say.
        let entries = fs::read_dir(&folder).into_iter().flatten().flatten();
        let mut entries: Vec<_> = entries.filter(|entry| counts(entry, is_scene)).take(left).collect();
        entries.sort_by_key(DirEntry::file_name);
        left -= entries.len();
        for entry in entries {
            let path = entry.path();
            let name = path.as_os_str().as_encoded_bytes();
            hash.update(&name.len().to_le_bytes());
            hash.update(name);
            // A link that leads nowhere is a name alone.
            let Ok(metadata) = fs::metadata(&path) else { continue };
            if !metadata.is_dir() {
                add_stamp(hash, stamp_of(&metadata));
            } else if entry.file_type().is_ok_and(|kind| kind.is_dir()) || (is_scene && folder == top) {
                folders.push_back(path);
            }
        }
    }
}

fn counts(entry: &DirEntry, is_scene: bool) -> bool {
    let name = entry.file_name();
    if name.as_encoded_bytes().starts_with(upload::HIDDEN.as_bytes()) {
        return false;
    }
    let extension = Path::new(&name).extension().and_then(|extension| extension.to_str()).unwrap_or_default();
    is_scene || !NEVER_BESIDE.iter().any(|never| extension.eq_ignore_ascii_case(never))
}

fn add_stamp(hash: &mut Xxh3, (length, written): (u64, u128)) {
    hash.update(&length.to_le_bytes());
    hash.update(&written.to_le_bytes());
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::places::Root;

    #[test]
    fn formats_of_one_file_are_in_the_table_of_readers() {
        for name in ALONE {
            assert!(READERS.iter().any(|reader| reader.name == name), "{name}");
        }
    }

    #[test]
    fn a_version_is_of_all_that_a_reader_may_open_and_of_nothing_else() {
        let folder = tempfile::tempdir().unwrap();
        let write = |name: &str, text: &str| {
            let path = folder.path().join(name);
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(path, text).unwrap();
        };
        let root = Root::new(folder.path()).unwrap();
        let version_of = |name: &str| version(&root.find(name).unwrap(), &ImportOptions::default());
        let now = || ["in/mesh.obj", "in/points.xyz", "in", "other/mesh.obj"].map(version_of);
        for mesh in ["in/mesh.obj", "other/mesh.obj"] {
            write(mesh, "mtllib colours.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        }
        write("in/points.xyz", "1 2 3\n4 5 6\n");
        let mut before = now();
        // What was written, and which of the four scenes may have changed by it.
        for (name, text, expected) in [
            ("in/colours.mtl", "newmtl a", [true, false, true, false]),
            ("in/pictures/wood.png", "picture", [true, false, true, false]),
            ("in/pictures/wood.png", "a picture", [true, false, true, false]),
            ("in/points.xyz", "1 2 3\n", [true, true, true, false]),
            ("in/mesh.obj", "v 0 0 0\n", [true, false, true, false]),
            ("in/more.VXT", "scene", [false, false, true, false]),
            (".voxtrace-upload-1/a.raw", "part", [false; 4]),
            ("in/.voxtrace-upload-1/a.raw", "part", [false; 4]),
        ] {
            write(name, text);
            let after = now();
            let changed: [bool; 4] = std::array::from_fn(|scene| before[scene] != after[scene]);
            assert_eq!(changed, expected, "{name}");
            before = after;
        }
        fs::remove_file(folder.path().join("in/colours.mtl")).unwrap();
        assert!(before[0] != version_of("in/mesh.obj") && before[1] == version_of("in/points.xyz"));
    }
}
