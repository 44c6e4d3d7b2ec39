//! MagicaVoxel .vox files. `document` is the file as it is, `parse` and `encode` go between it and bytes, and `scene` makes
//! a scene of it with the help of the other modules, one for each idea of the format.

mod air;
mod attributes;
pub(crate) mod camera;
mod document;
mod encode;
mod graph;
mod ignored;
pub(crate) mod light;
mod lines;
mod material;
mod model;
pub(crate) mod palette;
mod parse;
pub(crate) mod rotation;
mod scene;
pub(super) mod slab6;
mod surroundings;
mod timeline;

pub use document::{Body, Chunk, Dict, GroupNode, Numbered, OldMaterial, ShapeNode, Text, TransformNode, VoxFile};
pub(crate) use graph::MAX_TRANSLATION;
pub use ignored::{ignored, on_request};
pub use lines::lines;
pub(crate) use material::MEDIUM_KEYS;
pub use palette::default_palette;
pub(crate) use scene::MAX_EDGE;
pub use surroundings::{Surroundings, surroundings};

/// The format of a [`voxtrace_scene::scene::Attachment`] that holds a .vox file without its voxels.
pub const ATTACHMENT: &str = "vox";

use crate::import::panorama::environment_from_bytes;
use crate::import::reader::{ClipChoice, Data, Kind, Magic, NotShown, Reader, Voxels};
use crate::import::source::folder::Folder;
use crate::import::source::input::Input;
use light::Picture;
use std::path::Path;
use std::sync::Arc;
use voxtrace_scene::scene::Scene;
use voxtrace_scene::sky::EnvironmentMap;
use voxtrace_voxelize::{ImportError, Limits};

/// What the table of readers has of this format.
pub(crate) const READER: Reader = Reader::new(
    "MagicaVoxel",
    Kind::Scene,
    &["vox"],
    "MagicaVoxel scene; read also as Slab6 writes it",
    |source, options| {
        let (path, limits) = (source.path(), &options.limits);
        let (input, folder) = source.into_input()?;
        let bytes = input.rest()?;
        let mut notes = Vec::new();
        let mut map_of = |picture: &Picture| {
            let map = map_beside(&folder, picture, limits);
            map.map_err(|fault| notes.push(format!("the sky is one colour: its picture is not read: {fault}"))).ok()
        };
        let file = VoxFile::parse(&bytes, path, limits)?;
        let scene = file.scene_under(path, limits, &mut map_of)?;
        let mut parts = NotShown::default();
        // Who asks for an animation plays them.
        if options.animation == ClipChoice::None {
            parts.count("further keyframe", keyframes(&file));
        }
        ignored(&scene).iter().for_each(|part| parts.name(part));
        notes.extend(parts.note());
        Ok(Data::Voxels(Voxels { scene, notes }))
    },
)
.with_magic(&[Magic::first(b"VOX ")])
.with_up_axis(None);

/// What moves in a file is shown as it is at first: so many keyframes follow, of places and of models.
fn keyframes(file: &VoxFile) -> u64 {
    let further = |count: usize| count.saturating_sub(1) as u64;
    let has_graph = file.chunks.iter().any(|chunk| matches!(chunk.body, Body::Shape(_)));
    let of_chunk = |chunk: &Chunk| match &chunk.body {
        Body::Transform(node) => further(node.frames.len()),
        Body::Shape(node) => further(node.models.len()),
        Body::Pack(models) if !has_graph => further(*models as usize),
        _ => 0,
    };
    file.chunks.iter().map(of_chunk).sum()
}

/// The map of a picture in a folder.
fn map_beside(folder: &Folder, picture: &Picture, limits: &Limits) -> Result<Arc<EnvironmentMap>, String> {
    let bytes = folder.read(&picture.name).map_err(|refused| refused.to_string())?;
    let map = environment_from_bytes(&bytes, Path::new(&picture.name), limits).map_err(|error| error.to_string())?;
    map.scaled(picture.intensity).map(Arc::new).map_err(String::from)
}

/// Reads a MagicaVoxel file. A picture that is its sky is not looked for.
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
