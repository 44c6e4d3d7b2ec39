//! What must hold for any bytes that are read as a mesh; shared by the fuzz targets and the tests.

use std::path::Path;
use voxtrace::animation::{Animation, Playback};
use voxtrace::import::{self, ClipChoice, ImportErrorKind, ImportOptions, Limits};
use voxtrace::voxelize::{self, Scale, VoxelizeError, VoxelizeOptions};

/// Limits small enough for a million runs.
const LIMITS: Limits =
    Limits { bytes: 1 << 20, voxels: 1 << 14, points: 1 << 14, items: 1 << 10, depth: 64, ratio: 200 };

/// Either there is an error that says where, or a mesh that holds together and becomes voxels, or has no surface.
///
/// # Panics
/// If not.
pub fn check(name: &str, bytes: &[u8]) {
    let voxelize_options = VoxelizeOptions { scale: Scale::Resolution(9), ..VoxelizeOptions::default() };
    let animation = ClipChoice::First;
    let options = ImportOptions { limits: LIMITS, voxelize: voxelize_options, animation, ..ImportOptions::default() };
    match import::mesh_from_bytes(bytes, Path::new(name), &options) {
        Err(error) => {
            let is_limit = matches!(error.kind, ImportErrorKind::Limit { .. });
            assert!(error.offset.is_some() || is_limit, "no offset: {error}");
            assert!(!error.to_string().contains("the decoder failed"), "a reader panicked: {error}");
        }
        Ok(mesh) => {
            mesh.validate().expect("readers make whole meshes");
            match voxelize::voxelize(&mesh, &options.voxelize, &LIMITS) {
                Ok(scene) => {
                    assert!(!scene.grids[0].is_empty() && scene.materials.len() <= 65_535);
                    let animation = Animation { clip: Playback::Once, ..Animation::default() };
                    for seconds in [-1.0, 0.0, 0.3, 0.75, 1e9] {
                        let now = animation.scene_at(&scene, seconds);
                        assert!(now.instances.iter().all(|instance| instance.world_from_grid.is_similarity()));
                    }
                }
                Err(VoxelizeError::Empty | VoxelizeError::BadScale(_) | VoxelizeError::TooLarge { .. }) => {}
                Err(error) => panic!("{error}"),
            }
        }
    }
}
