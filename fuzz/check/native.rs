//! What must hold for any bytes that are opened as a native file, with checksums that a malicious writer would mend; shared
//! by the fuzz target and the tests.

use std::sync::Arc;
use voxtrace::glam::Vec3;
use voxtrace::packed::FileErrorKind;
use voxtrace::{Hit, PackedScene, Ray, walk};
use xxhash_rust::xxh3::xxh3_64;

/// Bytes whose first one is aligned to 8, as a mapped file's is.
struct Aligned(Vec<u64>, usize);

impl AsRef<[u8]> for Aligned {
    fn as_ref(&self) -> &[u8] {
        &bytemuck::cast_slice(&self.0)[..self.1]
    }
}

/// Opens the bytes of a file.
///
/// # Errors
/// As [`PackedScene::open`].
pub fn open(bytes: &[u8]) -> Result<PackedScene, FileErrorKind> {
    let mut words = vec![0u64; bytes.len().div_ceil(8)];
    bytemuck::cast_slice_mut(&mut words)[..bytes.len()].copy_from_slice(bytes);
    PackedScene::from_bytes(Arc::new(Aligned(words, bytes.len())))
}

/// Either the file is refused, or its scene can be traced and unpacked.
///
/// # Panics
/// If not.
pub fn check(bytes: &[u8]) {
    let mut bytes = bytes.to_vec();
    mend(&mut bytes);
    let Ok(scene) = open(&bytes) else { return };
    let rays = rays(&scene);
    let mut hits = vec![Hit::MISS; rays.len()];
    walk::cast_batch(&scene, &rays, &mut hits);
    for (ray, hit) in rays.iter().zip(&hits) {
        assert_eq!(*hit, walk::cast(&scene, ray), "{ray:?}");
        if !hit.is_miss() {
            assert!(hit.t >= 0.0 && (scene.material_index(hit) as usize) < scene.materials().len());
            scene.material(hit);
        }
    }
    let unpacked = scene.to_scene();
    assert_eq!(unpacked.instances.len(), scene.instances().len());
}

/// Rays from all sides at the origin and at corners of the first instances.
fn rays(scene: &PackedScene) -> Vec<Ray> {
    let corners = scene.instances().iter().take(3).flat_map(|instance| {
        let grid = &scene.grids()[instance.grid as usize];
        [grid.min, grid.max, (grid.min + grid.max) / 2].map(|corner| instance.world_from_grid.point(corner.as_vec3()))
    });
    let sides = [Vec3::X, Vec3::NEG_Y, Vec3::Z, Vec3::new(0.5, 0.25, -1.0), Vec3::new(-0.3, 0.9, 0.2)];
    let aims = std::iter::once(Vec3::ZERO).chain(corners).filter(|aim| aim.is_finite() && aim.length() < 1e5);
    aims.flat_map(|aim| sides.map(|side| Ray::new(aim - side * 50.0 + Vec3::splat(0.37), side))).collect()
}

/// Writes the checksums that the sections and their table have, as far as they lie in the file.
fn mend(bytes: &mut [u8]) {
    let number = |bytes: &[u8], at: usize| {
        let number = bytes.get(at..at + 8)?.first_chunk()?;
        usize::try_from(u64::from_le_bytes(*number)).ok()
    };
    let Some(count) = bytes.get(12..16).and_then(|count| count.first_chunk()) else { return };
    let count = (u32::from_le_bytes(*count) as usize).min(bytes.len() / 32);
    let table = 64..64 + 32 * count;
    for entry in table.clone().step_by(32) {
        let Some(range) = number(bytes, entry + 8).zip(number(bytes, entry + 16)) else { return };
        let section = range.0.checked_add(range.1).and_then(|end| bytes.get(range.0..end));
        let Some(sum) = section.map(xxh3_64) else { continue };
        if let Some(place) = bytes.get_mut(entry + 24..entry + 32) {
            place.copy_from_slice(&sum.to_le_bytes());
        }
    }
    if let Some(sum) = bytes.get(table).map(xxh3_64) {
        bytes[16..24].copy_from_slice(&sum.to_le_bytes());
    }
}
