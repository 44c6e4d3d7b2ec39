//! Scenes as MagicaVoxel .vox files. What the format has a place for comes back the same when the file is read: grids,
//! instances at quarter turns, mirrors and whole voxels, materials, layers, names, key frames, cameras, sun and uniform sky.
//! A scene that was read from such a file is written back into its chunks (`kept`), so that nothing is lost that voxtrace does
//! not know. Grids larger than 256³ become several models, more than 255 materials are reduced to 255, the study's sky is left out
//! because it is what a file without a sky gets, and other gradients become their mean.

mod camera;
mod entry;
mod kept;
mod light;
mod nodes;
mod palette;
mod pieces;

use super::{ExportError, Wanted, go_on};
use crate::import::vox::{Body, Chunk, Dict, Numbered, VoxFile};
use kept::Kept;
use palette::Palette;
use pieces::{Piece, pieces_of};
use rayon::prelude::*;
use std::{borrow::Cow, io::Write, path::Path};
use voxtrace_core::atomic_file::write_atomically_while;
use voxtrace_scene::scene::{Layer, Scene};

/// The format's name in errors.
const FORMAT: &str = ".vox";
/// Version that MagicaVoxel 0.99.7 writes.
const VERSION: u32 = 200;

/// Writes a scene as a MagicaVoxel file, which replaces an old one whole or not at all. Returns what of the MagicaVoxel file
/// that the scene came from could not be kept, one phrase each; nothing where the scene has not changed since.
///
/// # Errors
/// If the file cannot be written, or an instance stands as the format cannot say.
pub fn write(path: &Path, scene: &Scene) -> Result<Vec<String>, ExportError> {
    write_while(path, scene, &|| true)
}

/// As [`write`], as long as it is wanted.
pub(super) fn write_while(path: &Path, scene: &Scene, wanted: Wanted) -> Result<Vec<String>, ExportError> {
    let too_large = ExportError::TooLarge { format: FORMAT, what: "the voxels" };
    let (document, lost) = kept_or_new(scene, wanted)?;
    go_on(wanted)?;
    let bytes = document.to_bytes().ok_or(too_large)?;
    write_atomically_while(path, wanted, |file| file.write_all(&bytes))
        .map_err(|error| ExportError::Io { path: path.into(), error })?;
    Ok(lost)
}

/// The MagicaVoxel document of a scene. Where the scene came from such a document, it keeps of that what has not changed.
///
/// # Errors
/// If an instance stands as the format cannot say, or the scene has more nodes than it can number.
pub fn document_of(scene: &Scene) -> Result<VoxFile<'_>, ExportError> {
    kept_or_new(scene, &|| true).map(|(document, _)| document)
}

/// What the MagicaVoxel file that a scene came from says beyond a scene, one phrase each.
pub fn beyond_scenes(scene: &Scene) -> Vec<String> {
    Kept::of(scene).map_or_else(Vec::new, |kept| kept.beyond_scenes())
}

fn kept_or_new<'s>(scene: &'s Scene, wanted: Wanted) -> Result<(VoxFile<'s>, Vec<String>), ExportError> {
    match Kept::of(scene) {
        Some(kept) => kept.document_of(scene, wanted),
        None => Ok((new_document(scene, wanted)?, light::lost_of(&scene.sky).into_iter().collect())),
    }
}

/// Models and scene graph.
fn models_and_nodes(scene: &Scene, palette: &Palette, wanted: Wanted) -> Result<Vec<Body<'static>>, ExportError> {
    let pieces: Vec<Vec<Piece>> = scene.grids.par_iter().map(|grid| pieces_of(grid, palette, wanted)).collect();
    go_on(wanted)?;
    let mut bodies = Vec::new();
    let nodes = nodes::nodes_of(scene, &pieces)?;
    for piece in pieces.into_iter().flatten() {
        bodies.push(Body::Size(piece.size));
        bodies.push(Body::Voxels(Cow::Owned(piece.voxels)));
    }
    bodies.extend(nodes);
    Ok(bodies)
}

fn new_document(scene: &Scene, wanted: Wanted) -> Result<VoxFile<'static>, ExportError> {
    let palette = Palette::of(scene);
    let mut bodies = models_and_nodes(scene, &palette, wanted)?;
    bodies.extend((0..).zip(&scene.layers).map(|(id, layer)| layer_of(id, layer)));
    bodies.push(Body::Palette(palette.colors()));
    bodies.extend(palette.materials());
    bodies.extend(light::objects_of(&scene.sky));
    bodies.extend(camera::cameras_of(&scene.cameras));
    let chunks = bodies.into_iter().map(Chunk::new).collect();
    Ok(VoxFile { version: VERSION, chunks, ..VoxFile::default() })
}

fn layer_of(id: i32, layer: &Layer) -> Body<'static> {
    let mut properties = Dict::default();
    if !layer.name.is_empty() {
        properties.push("_name", layer.name.clone());
    }
    if layer.hidden {
        properties.push("_hidden", "1");
    }
    if let Some([r, g, b]) = layer.color {
        properties.push("_color", format!("{r} {g} {b}"));
    }
    Body::Layer(Numbered { id, properties }, -1)
}
