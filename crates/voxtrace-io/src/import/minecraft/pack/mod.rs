//! A resource pack of the game's Java edition, a folder or a `.zip`: the pictures of blocks below `assets/minecraft/textures/block`, which are
//! read when a block first asks for one. What is not there has our colours.

mod names;
pub(super) mod picture;
mod tint;

use super::looks::Face;
use super::state::State;
use crate::import::source::folder::{Folder, Refused};
use picture::Picture;
use rustc_hash::FxHashMap;
use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use voxtrace_voxelize::{ImportError, ImportErrorKind, Limits};
use zip::ZipArchive;

/// Where pictures of blocks lie: now, and before 1.13.
const FOLDERS: [&str; 2] = ["assets/minecraft/textures/block", "assets/minecraft/textures/blocks"];
/// Most bytes of a picture. Packs of the highest resolutions have some megabytes.
const PICTURE: u64 = 64 << 20;
/// Most files in a pack.
const FILES: usize = 1 << 18;

enum Files {
    Folder(Folder),
    Zip(Box<ZipArchive<File>>),
}

/// An open resource pack.
pub(in crate::import::minecraft) struct Pack {
    path: PathBuf,
    /// Where pictures of blocks lie in it.
    folder: String,
    files: Files,
    limits: Limits,
    pictures: FxHashMap<String, Option<Arc<Picture>>>,
    /// Pictures that are damaged, and the first fault.
    damaged: (usize, Option<String>),
}

impl Pack {
    /// Opens a pack.
    ///
    /// # Errors
    /// If there is none, or it has no pictures of blocks.
    pub fn open(path: &Path, limits: &Limits) -> Result<Self, ImportError> {
        let io = |error| ImportError::io(path, error);
        crate::import::source::opened::note(path);
        let unsupported = |what: String| ImportError::of_file(path, ImportErrorKind::Unsupported(what));
        let none = || unsupported(format!("a resource pack without pictures in {}", FOLDERS[0]));
        if path.is_dir() {
            let folder = FOLDERS.into_iter().find(|folder| path.join(folder).is_dir()).ok_or_else(none)?;
            return Ok(Self::of(path, folder.into(), Files::Folder(Folder::at(path, limits)), limits));
        }
        let archive = ZipArchive::new(File::open(path).map_err(io)?);
        let archive =
            archive.map_err(|error| unsupported(format!("a resource pack that is no folder and no ZIP: {error}")))?;
        if archive.len() > FILES {
            return Err(ImportError::limit(path, None, "files of a resource pack", archive.len() as u64, FILES as u64));
        }
        // Some packs are zipped with the folder around them.
        let inner = FOLDERS.into_iter().find_map(|folder| {
            let name = archive.file_names().flatten().find(|name| name.contains(&format!("{folder}/")))?;
            let end = name.find(folder)? + folder.len();
            Some(name[..end].to_owned())
        });
        let inner = inner.ok_or_else(none)?;
        Ok(Self::of(path, inner, Files::Zip(archive.into()), limits))
    }

    fn of(path: &Path, folder: String, files: Files, limits: &Limits) -> Self {
        let pictures = FxHashMap::default();
        Self { path: path.into(), folder, files, limits: *limits, pictures, damaged: (0, None) }
    }

    /// The picture of a face of a block, in the colours of the plains where the game chooses them by the biome.
    pub fn face(&mut self, state: &State, face: Face) -> Option<Arc<Picture>> {
        names::candidates(state, face).iter().find_map(|name| self.tinted(name, state))
    }

    /// The picture of a name, as a block has it.
    fn tinted(&mut self, name: &str, state: &State) -> Option<Arc<Picture>> {
        let key = format!("{name} {}", state.name);
        if let Some(known) = self.pictures.get(&key) {
            return known.clone();
        }
        let found = self.picture(name).map(|picture| match name {
            "grass_block_side" => match self.picture("grass_block_side_overlay") {
                Some(overlay) => Arc::new(picture.under(&overlay.tinted(tint::GRASS))),
                None => picture,
            },
            _ => match tint::of(name, &state.name) {
                Some(tint) => Arc::new(picture.tinted(tint)),
                None => picture,
            },
        });
        self.pictures.insert(key, found.clone());
        found
    }

    /// The picture of a name as it is in the pack.
    fn picture(&mut self, name: &str) -> Option<Arc<Picture>> {
        if let Some(known) = self.pictures.get(name) {
            return known.clone();
        }
        let found = match self.bytes(name) {
            None => None,
            Some(bytes) => match Picture::decode(&bytes, &self.limits) {
                Ok(picture) => Some(Arc::new(picture)),
                Err(fault) => {
                    self.damaged.0 += 1;
                    self.damaged.1.get_or_insert(format!("{name}.png: {fault}"));
                    None
                }
            },
        };
        self.pictures.insert(name.to_owned(), found.clone());
        found
    }

    fn bytes(&mut self, name: &str) -> Option<Vec<u8>> {
        let name = format!("{}/{name}.png", self.folder);
        let result = match &mut self.files {
            Files::Folder(folder) => match folder.read(&name) {
                Err(Refused::Io { error, .. }) if error.kind() == std::io::ErrorKind::NotFound => return None,
                other => other.map_err(|refused| refused.to_string()),
            },
            Files::Zip(archive) => {
                let index = archive.index_for_name(&name)?;
                unzipped(archive, index).map_err(|error| format!("{name}: {error}"))
            }
        };
        match result {
            Ok(bytes) => Some(bytes),
            Err(fault) => {
                self.damaged.0 += 1;
                self.damaged.1.get_or_insert(fault);
                None
            }
        }
    }

    /// What there is to say about the pack.
    pub fn note(&self) -> Option<String> {
        let (count, fault) = (self.damaged.0, self.damaged.1.as_ref()?);
        Some(format!("{count} pictures of {} are left out: {fault}", self.path.display()))
    }

    /// Whether any picture was found.
    pub fn is_used(&self) -> bool {
        self.pictures.values().any(Option::is_some)
    }
}

fn unzipped(archive: &mut ZipArchive<File>, index: usize) -> Result<Vec<u8>, String> {
    let file = archive.by_index(index).map_err(|error| error.to_string())?;
    let mut bytes = Vec::new();
    file.take(PICTURE + 1).read_to_end(&mut bytes).map_err(|error| error.to_string())?;
    if bytes.len() as u64 > PICTURE { Err("too large".into()) } else { Ok(bytes) }
}
