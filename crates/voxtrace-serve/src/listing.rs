//! What is in a folder: scenes, and folders of it.

use crate::places::{Place, Root, format_of, is_plain};
use crate::refusal::Refusal;
use serde::Serialize;
use std::fs;
use voxtrace::import::{ImportOptions, READERS};

/// Most entries of a list, and most folders of it that are looked into.
const MOST_ENTRIES: usize = 5000;
const MOST_LOOKED_INTO: usize = 200;

/// A folder as JSON.
#[derive(Debug, Serialize)]
pub struct Listing {
    /// Below the folder that is served.
    pub path: String,
    pub folders: Vec<FolderEntry>,
    pub scenes: Vec<SceneEntry>,
    /// Whether there is more than is listed.
    pub is_cut: bool,
}

#[derive(Debug, Serialize)]
pub struct FolderEntry {
    pub name: String,
    /// The format where the folder as a whole is a scene: slices of a scan, regions of a world.
    pub format: Option<&'static str>,
}

#[derive(Debug, Serialize)]
pub struct SceneEntry {
    pub name: String,
    pub format: &'static str,
    pub bytes: u64,
    /// When it was written, milliseconds since 1970.
    pub written: u64,
}

impl Listing {
    /// What is in a folder of `root`. Of links those that lead to what clients are given.
    ///
    /// # Errors
    /// If the folder cannot be read.
    pub fn of(root: &Root, place: &Place, options: &ImportOptions) -> Result<Self, Refusal> {
        let failed = |error: std::io::Error| Refusal::failed(format!("{:?} cannot be listed: {error}", place.name));
        let mut listing = Self { path: place.name.clone(), folders: Vec::new(), scenes: Vec::new(), is_cut: false };
        for entry in fs::read_dir(&place.path).map_err(failed)? {
            let Ok(entry) = entry else { continue };
            let Some(name) = entry.file_name().to_str().filter(|name| is_plain(name)).map(str::to_owned) else {
                continue;
            };
            let Some(found) = found(root, place, &entry, &name) else { continue };
            if listing.folders.len() + listing.scenes.len() >= MOST_ENTRIES {
                listing.is_cut = true;
                break;
            }
            if found.metadata.is_dir() {
                let is_looked_into = listing.folders.len() < MOST_LOOKED_INTO;
                let opened = if is_looked_into { READERS.open(&found.path, options).ok() } else { None };
                let format = opened.map(|opened| opened.reader().name);
                listing.folders.push(FolderEntry { name, format });
            } else if found.metadata.is_file()
                && let Some(format) = format_of(&found.path)
            {
                let (bytes, written) = found.version();
                listing.scenes.push(SceneEntry { name, format, bytes, written: (written / 1_000_000) as u64 });
            }
        }
        Ok(listing)
    }
}

/// An entry of a folder, where it leads to what clients are given.
fn found(root: &Root, folder: &Place, entry: &fs::DirEntry, name: &str) -> Option<Place> {
    let name = if folder.name.is_empty() { name.to_owned() } else { format!("{}/{name}", folder.name) };
    if entry.file_type().ok()?.is_symlink() {
        return root.find(&name).ok();
    }
    Some(Place { name, path: entry.path(), metadata: entry.metadata().ok()? })
}
