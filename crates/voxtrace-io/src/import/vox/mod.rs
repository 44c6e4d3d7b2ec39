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

pub use document::{Body, Chunk, Dict, GroupNode, Numbered, OldMaterial, ShapeNode, Text, TransformNode, VoxFile};
pub(crate) use graph::MAX_TRANSLATION;
pub(crate) use scene::MAX_EDGE;

/// The format of a [`crate::scene::Attachment`] that holds a .vox file without its voxels.
pub const ATTACHMENT: &str = "vox";

use super::{ImportError, Limits};
use std::path::Path;
use voxtrace_scene::scene::Scene;

/// Reads a MagicaVoxel file.
///
/// # Errors
/// If the file cannot be read, is malformed or goes beyond `limits`; the error says where.
pub fn read(path: &Path, limits: &Limits) -> Result<Scene, ImportError> {
    read_bytes(&super::read_bytes(path, limits)?, path, limits)
}

/// Reads a MagicaVoxel file from memory; `path` names it in errors and gives the scene its name.
///
/// # Errors
/// As [`read`].
pub fn read_bytes(bytes: &[u8], path: &Path, limits: &Limits) -> Result<Scene, ImportError> {
    VoxFile::parse(bytes, path, limits)?.to_scene(path, limits)
}
