//! From a file to a scene: what readers give is voxelized where it is not voxels yet.

use super::reader::{Data, ImportOptions};
use std::path::Path;
use voxtrace_core::packed::PackedScene;
use voxtrace_scene::scene::Scene;
use voxtrace_voxelize::ImportError;
use voxtrace_voxelize::volume;
use voxtrace_voxelize::voxelize::VoxelizeProgress;

/// What became of a file.
#[derive(Clone, Debug)]
pub struct Loaded {
    /// The scene.
    pub content: Content,
    /// What the reader left out or put up with.
    pub notes: Vec<String>,
}

/// A scene as it was found.
#[derive(Clone, Debug)]
pub enum Content {
    /// To be edited.
    Scene(Box<Scene>),
    /// Packed already.
    Packed(Box<PackedScene>),
}

impl Content {
    /// The scene as it can be edited and written to other formats.
    pub fn into_scene(self) -> Scene {
        match self {
            Self::Scene(scene) => *scene,
            Self::Packed(packed) => packed.to_scene(),
        }
    }
}

impl Loaded {
    /// A scene of what a reader has given.
    pub(super) fn of(data: Data, path: &Path, options: &ImportOptions) -> Result<Self, ImportError> {
        let mut notes = data.notes().to_vec();
        let scene = match data {
            Data::Packed(packed) => return Ok(Self { content: Content::Packed(packed), notes }),
            Data::Voxels(voxels) => voxels.scene,
            Data::Geometry(geometry) => {
                let progress = VoxelizeProgress::default();
                let scene = geometry.voxelize(&options.voxelize, &options.limits, &progress);
                notes.extend(progress.take_notes());
                scene.map_err(|error| error.into_import_error(path))?
            }
            Data::Volume(volume) => volume::voxelize(&volume, &options.volume, &options.limits)
                .map_err(|error| error.into_import_error(path))?,
        };
        Ok(Self { content: Content::Scene(scene.into()), notes })
    }
}
