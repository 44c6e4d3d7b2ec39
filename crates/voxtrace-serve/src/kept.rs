//! Thumbnails that are kept between runs: pictures by what the scenes hold, and for each file that was asked for, in which version it was which scene. What
//! changes beside a file and makes no difference costs another reading, and no other picture.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// Bytes that are kept.
const MOST: u64 = 256 << 20;
/// Bytes that a small file takes on a disk.
const BLOCK: u64 = 4096;

/// What a thumbnail is found by before its scene is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Key {
    /// Of a file: by its content, or by its place.
    pub file: u128,
    /// Of all that the scene is read from.
    pub version: u128,
}

/// The folder of thumbnails, if they are kept at all.
#[derive(Clone, Debug)]
pub struct Kept(Option<PathBuf>);

impl Kept {
    /// Thumbnails in `folder`; the oldest go, beyond those that are kept.
    pub fn new(folder: Option<PathBuf>) -> Self {
        if let Some(folder) = &folder {
            prune(folder);
        }
        Self(folder)
    }

    /// The thumbnail of a file.
    pub fn of_file(&self, key: Key) -> Option<Vec<u8>> {
        let text = fs::read_to_string(self.0.as_ref()?.join(name_of_file(key))).ok()?;
        let (version, scene) = text.split_once(' ')?;
        let is_same = u128::from_str_radix(version, 16) == Ok(key.version);
        self.of_scene(u64::from_str_radix(scene, 16).ok().filter(|_| is_same)?)
    }

    /// The thumbnail of a scene, by the hash of its content.
    pub fn of_scene(&self, scene: u64) -> Option<Vec<u8>> {
        fs::read(self.0.as_ref()?.join(name_of_scene(scene))).ok()
    }

    /// Keeps the thumbnail of a scene.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn keep(&self, scene: u64, jpeg: &[u8]) -> io::Result<()> {
        self.write(&name_of_scene(scene), jpeg)
    }

    /// Keeps which scene a file is.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn keep_file(&self, key: Key, scene: u64) -> io::Result<()> {
        self.write(&name_of_file(key), format!("{:x} {scene:x}", key.version).as_bytes())
    }

    fn write(&self, name: &str, bytes: &[u8]) -> io::Result<()> {
        let Some(folder) = &self.0 else { return Ok(()) };
        fs::create_dir_all(folder)?;
        let mut file = tempfile::NamedTempFile::new_in(folder)?;
        io::Write::write_all(&mut file, bytes)?;
        file.persist(folder.join(name)).map_err(|error| error.error)?;
        Ok(())
    }
}

fn name_of_file(key: Key) -> String {
    format!("{:032x}.file", key.file)
}

fn name_of_scene(scene: u64) -> String {
    format!("{scene:016x}.jpg")
}

fn prune(folder: &Path) {
    let files = fs::read_dir(folder).into_iter().flatten().flatten();
    let of_file = |file: fs::DirEntry| {
        let metadata = file.metadata().ok().filter(fs::Metadata::is_file)?;
        Some((metadata.modified().ok()?, metadata.len().max(BLOCK), file.path()))
    };
    let mut files: Vec<_> = files.filter_map(of_file).collect();
    files.sort();
    let mut bytes: u64 = files.iter().map(|(_, length, _)| length).sum();
    for (_, length, path) in files {
        if bytes <= MOST {
            break;
        }
        let _ = fs::remove_file(path);
        bytes -= length;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_has_the_thumbnail_of_its_scene_in_that_version() {
        let folder = tempfile::tempdir().unwrap();
        let kept = Kept::new(Some(folder.path().join("thumbnails")));
        let key = Key { file: 1, version: 2 };
        assert_eq!((kept.of_file(key), kept.of_scene(3)), (None, None));
        kept.keep(3, b"picture").unwrap();
        assert_eq!(kept.of_file(key), None);
        kept.keep_file(key, 3).unwrap();
        assert_eq!(kept.of_file(key).as_deref(), Some(&b"picture"[..]));
        assert_eq!(kept.of_file(Key { version: 4, ..key }), None, "it may be another scene now");
        kept.keep_file(Key { version: 4, ..key }, 5).unwrap();
        assert_eq!(kept.of_file(key), None, "a file is one scene at a time");
        assert_eq!(kept.of_scene(3).as_deref(), Some(&b"picture"[..]));
        Kept::new(None).keep(3, b"picture").unwrap();
        assert_eq!(Kept::new(None).of_scene(3), None);
    }
}
