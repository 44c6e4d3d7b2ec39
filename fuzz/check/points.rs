//! What must hold for any bytes that are read as points; shared by the fuzz target and the tests.

use std::path::Path;
use voxtrace::import::{self, Geometry, ImportErrorKind, ImportOptions, Kind, Limits, PointFilter, READERS};
use voxtrace::voxelize::{Scale, VoxelizeError, VoxelizeOptions, VoxelizeProgress, voxelize_points};

/// Limits small enough for a million runs.
const LIMITS: Limits =
    Limits { bytes: 1 << 20, voxels: 1 << 14, points: 1 << 14, items: 1 << 10, depth: 64, ratio: 200 };

/// Extensions that lead to each reader of this kind.
pub fn extensions() -> Vec<&'static str> {
    let readers = READERS.iter().filter(|reader| reader.kind == Kind::Points);
    let mut extensions: Vec<&str> = readers.flat_map(|reader| reader.extensions).copied().collect();
    // Files without faces are points too.
    extensions.extend(["obj", "ply", "gltf"]);
    extensions
}

/// [`check`] by every reader that may be meant: the one that the first bytes tell, or where they say nothing, all.
pub fn check_all(bytes: &[u8]) {
    let is_told = READERS.open_bytes(bytes, Path::new("fuzzed"), &ImportOptions::default()).is_ok();
    let extensions = extensions();
    let asked = if is_told { 1 } else { extensions.len() };
    extensions.iter().take(asked).for_each(|extension| check(&format!("fuzzed.{extension}"), bytes));
}

/// Either there is an error that says where, or points that hold together and become voxels.
///
/// # Panics
/// If not.
pub fn check(name: &str, bytes: &[u8]) {
    // Some are asked for a part of their points alone.
    let is_part = bytes.last().is_some_and(|byte| byte % 4 == 0);
    let points = PointFilter {
        classes: is_part.then(|| "1,2,vegetation".parse().expect("classes")),
        bounds: is_part.then(|| "-1e9,-1e9,1e9,1e7".parse().expect("a box")),
    };
    let options = ImportOptions { limits: LIMITS, points, ..ImportOptions::default() };
    match import::geometry_from_bytes(bytes, Path::new(name), &options) {
        Err(error) => {
            let is_of_all = matches!(error.kind, ImportErrorKind::Limit { .. } | ImportErrorKind::NothingChosen(_));
            assert!(error.offset.is_some_and(|at| at <= bytes.len() as u64) || is_of_all, "no offset: {error}");
        }
        Ok(Geometry::Mesh(_)) => {}
        Ok(Geometry::Points(cloud)) => {
            cloud.validate().expect("readers make whole clouds");
            for scale in [Scale::Resolution(9), Scale::Automatic] {
                let options = VoxelizeOptions { scale, ..VoxelizeOptions::default() };
                match voxelize_points(&cloud, &options, &LIMITS, &VoxelizeProgress::default()) {
                    Ok(scene) => assert!(!scene.grids[0].is_empty()),
                    Err(VoxelizeError::NoPoints | VoxelizeError::BadScale(_) | VoxelizeError::TooLarge { .. }) => {}
                    Err(error) => panic!("{name}: {error}"),
                }
            }
        }
    }
}
