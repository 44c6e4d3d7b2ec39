//! What must hold for any bytes that are read as a panorama; shared by the fuzz target and the tests.

use std::path::Path;
use voxtrace::glam::Vec3;
use voxtrace::import::{Limits, environment_from_bytes};

/// Limits small enough for a million runs.
const LIMITS: Limits =
    Limits { bytes: 1 << 20, voxels: 1 << 16, points: 1 << 14, items: 1 << 12, depth: 64, ratio: 200 };

/// Either there is an error, which is no panic that was caught, or a map of finite light whose directions can be chosen.
///
/// # Panics
/// If not.
pub fn check(bytes: &[u8]) {
    match environment_from_bytes(bytes, Path::new("checked.hdr"), &LIMITS) {
        Err(error) => assert!(!error.to_string().contains("the decoder failed"), "a reader panicked: {error}"),
        Ok(map) => {
            let mean = map.mean_radiance();
            assert!(mean.is_finite() && mean.cmpge(Vec3::ZERO).all(), "{mean}");
            assert_eq!(map.texels().len(), (map.edge() * map.edge()) as usize);
        }
    }
}
