//! What readers of voxels share: grids built brick by brick and slab by slab, and the materials of colours.

pub(crate) mod dense;
pub(crate) mod paints;
pub(crate) mod slab;

use crate::import::source::input::beyond;
use glam::IVec3;
use std::path::Path;
use voxtrace_scene::grid::MAX_COORDINATE;
use voxtrace_voxelize::{ImportError, Limits};

/// The size of a box of voxels, checked: within what grids hold, and with no more places than there may be voxels.
pub(crate) fn checked_size(path: &Path, offset: u64, size: [u64; 3], limits: &Limits) -> Result<IVec3, ImportError> {
    let edge = size.into_iter().max().unwrap_or(0);
    if edge > MAX_COORDINATE as u64 {
        return Err(beyond(path, Some(offset), "voxels along an edge", edge, MAX_COORDINATE as u64));
    }
    let places = size.into_iter().fold(1u64, u64::saturating_mul);
    if places > limits.voxels {
        return Err(ImportError::limit(path, Some(offset), "places of voxels", places, limits.voxels));
    }
    Ok(IVec3::from_array(size.map(|edge| edge as i32)))
}
