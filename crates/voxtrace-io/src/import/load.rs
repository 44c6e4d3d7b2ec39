//! From a file to a scene: what readers give is voxelized where it is not voxels yet. That ends where reading does: once nobody waits for it.

use super::reader::{Data, ImportOptions};
use super::source::watch::Watch;
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
        let watch = Watch::of_thread();
        let scene = match data {
            Data::Packed(packed) => return Ok(Self { content: Content::Packed(packed), notes }),
            Data::Voxels(voxels) => voxels.scene,
            Data::Geometry(geometry) => {
                let progress = VoxelizeProgress::while_wanted(move || watch.goes_on());
                let scene = geometry.voxelize(&options.voxelize, &options.limits, &progress);
                notes.extend(progress.take_notes());
                scene.map_err(|error| error.into_import_error(path))?
            }
            Data::Volume(volume) => {
                volume::voxelize_while(&volume, &options.volume, &options.limits, &|| watch.goes_on())
                    .map_err(|error| error.into_import_error(path))?
            }
        };
        Ok(Self { content: Content::Scene(scene.into()), notes })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::import::reader::Geometry;
    use crate::import::source::watch::read_while;
    use glam::Vec3;
    use voxtrace_voxelize::mesh::MeshMaterial;
    use voxtrace_voxelize::points::PointCloud;
    use voxtrace_voxelize::{ImportErrorKind, Mesh, Volume};

    #[test]
    fn what_was_read_is_voxelized_as_long_as_somebody_waits() {
        let corners = vec![Vec3::ZERO, Vec3::X, Vec3::Y];
        let mesh = Mesh { positions: corners.clone(), materials: vec![MeshMaterial::default()], ..Mesh::default() };
        let cloud = PointCloud { positions: corners, ..PointCloud::default() };
        let values = (0..512).map(|at| if at % 8 < 4 { 0.0 } else { 100.0 }).collect();
        let all = [
            Data::Geometry(Geometry::Mesh(mesh)),
            Data::Geometry(Geometry::Points(cloud)),
            Data::Volume(Volume::new([8; 3], values)),
        ];
        for data in all {
            let loaded = |is_wanted: bool| {
                read_while(move || is_wanted, || Loaded::of(data.clone(), Path::new("a"), &ImportOptions::default()))
            };
            loaded(true).unwrap();
            let error = loaded(false).unwrap_err();
            assert!(matches!(error.kind, ImportErrorKind::Stopped), "{error}");
        }
    }
}
