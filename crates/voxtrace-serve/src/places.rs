//! From names in addresses to files of the folder, and to no others. A name is judged after it was decoded, part by part; where it leads, behind links too,
//! must lie in the folder.

use crate::refusal::Refusal;
use axum::http::StatusCode;
use std::fs::Metadata;
use std::io;
use std::path::{Path, PathBuf};
use std::time::UNIX_EPOCH;
use voxtrace::import::READERS;

/// Longest name of a file, bytes.
const LONGEST: usize = 200;

/// Names that are devices on Windows, whatever their extension.
const DEVICES: [&str; 8] = ["con", "prn", "aux", "nul", "conin$", "conout$", "clock$", "config$"];

/// The folder that is served.
#[derive(Clone, Debug)]
pub struct Root(PathBuf);

/// A file or folder in it.
#[derive(Clone, Debug)]
pub struct Place {
    /// Its name as clients know it: below the folder, with slashes.
    pub name: String,
    /// Where it is, without links.
    pub path: PathBuf,
    pub metadata: Metadata,
}

impl Root {
    pub fn new(folder: &Path) -> io::Result<Self> {
        let folder = folder.canonicalize()?;
        if !folder.is_dir() {
            return Err(io::Error::new(io::ErrorKind::NotADirectory, "it is no folder"));
        }
        Ok(Self(folder))
    }

    pub fn path(&self) -> &Path {
        &self.0
    }

    /// What a name of an address, decoded, leads to.
    pub fn find(&self, name: &str) -> Result<Place, Refusal> {
        let nothing = || Refusal::nothing(name);
        if !name.is_empty() && !name.split('/').all(is_plain) {
            return Err(nothing());
        }
        let path = self.0.join(name).canonicalize().map_err(|_| nothing())?;
        if !path.starts_with(&self.0) {
            return Err(nothing());
        }
        let metadata = path.metadata().map_err(|_| nothing())?;
        // What is hidden stays hidden behind a link, and nothing else than files and folders is ever opened: others may block.
        let is_hidden = path
            .strip_prefix(&self.0)
            .is_ok_and(|below| below.components().any(|part| part.as_os_str().as_encoded_bytes().starts_with(b".")));
        if is_hidden || !(metadata.is_file() || metadata.is_dir()) {
            return Err(nothing());
        }
        Ok(Place { name: name.into(), path, metadata })
    }

    /// A file or folder that can be a scene.
    pub fn find_scene(&self, name: &str) -> Result<Place, Refusal> {
        let place = self.find(name)?;
        if place.metadata.is_file() && format_of(&place.path).is_none() {
            return Err(Refusal::nothing(&place.name));
        }
        Ok(place)
    }

    /// A folder and the name of a file in it that may not be there yet.
    pub fn find_new(&self, name: &str) -> Result<(Place, String), Refusal> {
        let (folder, file) = name.rsplit_once('/').unwrap_or(("", name));
        if !is_plain(file) {
            let line = format!("{file:?} is no name for a file: letters, digits and most signs, up to {LONGEST} bytes");
            return Err(Refusal::new(StatusCode::BAD_REQUEST, line));
        }
        let place = self.find(folder)?;
        if !place.metadata.is_dir() {
            return Err(Refusal::nothing(folder));
        }
        Ok((place, file.into()))
    }
}

impl Place {
    /// Changes when the file does: its length and when it was written, nanoseconds.
    pub fn version(&self) -> (u64, u128) {
        stamp_of(&self.metadata)
    }
}

/// The length of a file and when it was written, nanoseconds.
pub fn stamp_of(metadata: &Metadata) -> (u64, u128) {
    let written = metadata.modified().ok().and_then(|time| time.duration_since(UNIX_EPOCH).ok());
    (metadata.len(), written.map_or(0, |time| time.as_nanos()))
}

/// Whether a part of a path is a name as people give them on every system: nothing that leads elsewhere, is hidden, or means a device.
pub fn is_plain(part: &str) -> bool {
    let stem = part.split('.').next().unwrap_or_default().trim_end().to_ascii_lowercase();
    let is_port = |kind: &str| stem.strip_prefix(kind).is_some_and(|rest| rest.chars().count() == 1);
    let is_device = DEVICES.contains(&stem.as_str()) || is_port("com") || is_port("lpt");
    let is_strange = |c: char| c.is_control() || matches!(c, '/' | '\\' | ':' | '*' | '?' | '"' | '<' | '>' | '|');
    !part.is_empty()
        && part.len() <= LONGEST
        && !part.starts_with('.')
        && !part.ends_with(['.', ' '])
        && !is_device
        && !part.chars().any(is_strange)
}

/// The format that a file's extension names. Pictures may be heightmaps, but most are not: they are no scenes here.
pub fn format_of(path: &Path) -> Option<&'static str> {
    let name = path.file_name()?.to_str()?.to_ascii_lowercase();
    let has = |extension: &&str| *extension != "png" && name.ends_with(&format!(".{extension}"));
    let reader = READERS.iter().find(|reader| reader.extensions.iter().any(has))?;
    Some(reader.name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_that_lead_elsewhere_are_hidden_or_devices_are_not_plain() {
        for name in ["castle.vox", "a b.vxt", "Größe.vox", "com.vox", "console.vox", "a..b", "日本.vox", "lpt10.vox"]
        {
            assert!(is_plain(name), "{name}");
        }
        for name in [
            "", ".", "..", ".ssh", "a/b", "a\\b", "c:", "a:b", "nul", "NUL.vox", "Com1.vox", "lpt9", "aux .vox", "a.",
            "a ", "a\0b", "a\nb", "a*", "con.a.b",
        ] {
            assert!(!is_plain(name), "{name:?}");
        }
        assert!(!is_plain(&"a".repeat(LONGEST + 1)));
    }

    #[test]
    fn formats_are_told_by_extensions_whatever_their_case() {
        assert!(format_of(Path::new("a.VOX")).is_some());
        assert!(format_of(Path::new("scan.nii.gz")).is_some());
        assert!(format_of(Path::new("picture.png")).is_none());
        assert!(format_of(Path::new("vox")).is_none());
        assert!(format_of(Path::new("id_rsa")).is_none());
    }

    #[test]
    fn nothing_outside_of_the_folder_is_found() {
        let folder = tempfile::tempdir().unwrap();
        let root_path = folder.path().join("root");
        std::fs::create_dir_all(root_path.join("inner/.hidden")).unwrap();
        std::fs::write(folder.path().join("secret.vox"), "x").unwrap();
        std::fs::write(root_path.join("inner/a.vox"), "x").unwrap();
        std::fs::write(root_path.join("inner/.hidden/b.vox"), "x").unwrap();
        let root = Root::new(&root_path).unwrap();
        assert_eq!(root.find("inner/a.vox").unwrap().metadata.len(), 1);
        assert!(root.find("").unwrap().metadata.is_dir());
        for name in ["../secret.vox", "inner/../../secret.vox", "inner/.hidden/b.vox", "none.vox", "inner//a.vox"] {
            assert!(root.find(name).is_err(), "{name}");
        }
        #[cfg(unix)]
        {
            use std::os::unix::fs::symlink;
            symlink(folder.path(), root_path.join("out")).unwrap();
            symlink(folder.path().join("secret.vox"), root_path.join("link.vox")).unwrap();
            symlink(root_path.join("inner/.hidden/b.vox"), root_path.join("shown.vox")).unwrap();
            symlink("/dev/zero", root_path.join("zero.vox")).unwrap();
            symlink(root_path.join("inner/a.vox"), root_path.join("within.vox")).unwrap();
            for name in ["out/secret.vox", "link.vox", "shown.vox", "zero.vox"] {
                assert!(root.find(name).is_err(), "{name}");
            }
            assert!(root.find("within.vox").is_ok());
        }
    }
}
