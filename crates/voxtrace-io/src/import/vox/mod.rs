//! MagicaVoxel .vox files. `document` is the file as it is, `parse` and `encode` go between it and bytes, and `scene` makes
//! a scene of it with the help of the other modules, one for each idea of the format.

mod attributes;
pub(crate) mod camera;
mod document;
mod encode;
mod graph;
pub(crate) mod light;
mod material;
mod model;
pub(crate) mod palette;
mod parse;
pub(crate) mod rotation;
mod scene;
pub(super) mod slab6;

pub use document::{Body, Chunk, Dict, GroupNode, Numbered, OldMaterial, ShapeNode, Text, TransformNode, VoxFile};
pub(crate) use graph::MAX_TRANSLATION;
pub(crate) use scene::MAX_EDGE;

/// The format of a [`voxtrace_scene::scene::Attachment`] that holds a .vox file without its voxels.
pub const ATTACHMENT: &str = "vox";

use crate::import::reader::{Data, Kind, Magic, Reader, Voxels};
use crate::import::source::input::Input;
use std::path::Path;
use voxtrace_scene::scene::Scene;
use voxtrace_voxelize::{ImportError, Limits};

/// What the table of readers has of this format.
pub(crate) const READER: Reader = Reader::new(
    "MagicaVoxel",
    Kind::Scene,
    &["vox"],
    "MagicaVoxel scene; read also as Slab6 writes it",
    |source, options| {
        let path = source.path();
        let scene = read_bytes(&source.into_bytes()?, path, &options.limits)?;
        Ok(Data::Voxels(Voxels { scene, notes: Vec::new() }))
    },
)
.with_magic(&[Magic::first(b"VOX ")])
.with_up_axis(None);

/// Reads a MagicaVoxel file.
///
/// # Errors
/// If the file cannot be read, is malformed or goes beyond `limits`; the error says where.
pub fn read(path: &Path, limits: &Limits) -> Result<Scene, ImportError> {
    read_bytes(&Input::open(path, limits)?.rest()?, path, limits)
}

/// Reads a MagicaVoxel file from memory; `path` names it in errors and gives the scene its name.
///
/// # Errors
/// As [`read`].
pub fn read_bytes(bytes: &[u8], path: &Path, limits: &Limits) -> Result<Scene, ImportError> {
    VoxFile::parse(bytes, path, limits)?.to_scene(path, limits)
}
