//! Estimates the number of voxels of a volume from a few of its layers.

use super::overlay::Layers;
use super::{Placement, Transfer, ValueStatistics, Volume, VolumeError, VolumeOptions, slab};
use crate::limits::Limits;
use rayon::prelude::*;

/// Layers of bricks that are counted.
const LAYERS: usize = 8;
/// Bytes of a voxel in a packed scene: its share of occupancy bits and of the tree, and its material.
const BYTES: f64 = 1.3;

/// Estimated size of the scene that voxelizing a volume would make.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VolumeEstimate {
    /// Voxels along each axis of the grid, empty ones included.
    pub size: [u64; 3],
    /// Edge of a voxel, in the volume's unit.
    pub voxel_size: f64,
    /// Occupied voxels; exact where the volume has at most eight layers of bricks.
    pub voxels: u64,
    /// Bytes of the scene.
    pub bytes: u64,
}

/// Estimates the voxels of a volume whose [`Volume::statistics`] are known, by those of eight layers of eight voxels each.
///
/// # Errors
/// If the volume is broken, or there is no grid for it within the limits.
pub fn estimate(
    volume: &Volume,
    values: &ValueStatistics,
    options: &VolumeOptions,
    limits: &Limits,
) -> Result<VolumeEstimate, VolumeError> {
    volume.validate().map_err(VolumeError::BadVolume)?;
    let mut transfer = options.transfer.clone().unwrap_or_else(|| Transfer::automatic(values));
    transfer.resolve(values, options.threshold);
    let placement = Placement::of(volume, options.scale, limits.voxels, transfer.is_labels())?;
    let (axes, lookup) = (&placement.axes, transfer.lookup());
    let all = Layers::new(volume, &placement, &lookup, &options.overlays)?;
    let shell = options.shell && all.is_opaque();
    let layers = axes[2].count().div_ceil(8);
    let looks = layers.min(LAYERS);
    // Each in the middle of one of as many equal parts of the height.
    let found: u64 =
        (0..looks).into_par_iter().map(|look| slab::count(&all, (2 * look + 1) * layers / (2 * looks), shell)).sum();
    let voxels = (found as f64 * layers as f64 / looks as f64).round() as u64;
    let size = [0, 1, 2].map(|axis| axes[axis].count() as u64);
    Ok(VolumeEstimate { size, voxel_size: placement.voxel_size, voxels, bytes: (voxels as f64 * BYTES) as u64 })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::volume::{Preset, voxelize};
    use glam::Vec3;

    fn ball(edge: usize) -> Volume {
        let middle = Vec3::splat(edge as f32 * 0.5);
        let at = |n: usize| Vec3::new((n % edge) as f32, (n / edge % edge) as f32, (n / edge / edge) as f32) + 0.5;
        let values = (0..edge.pow(3)).map(|n| edge as f32 * 0.4 - at(n).distance(middle)).collect();
        Volume::new([edge; 3], values)
    }

    #[test]
    fn an_estimate_is_exact_for_small_volumes_and_near_for_large_ones() {
        for (edge, tolerance) in [(60, 0.0), (260, 0.1)] {
            let volume = ball(edge);
            for shell in [true, false] {
                let options =
                    VolumeOptions { transfer: Some(Preset::Surface.transfer()), shell, ..VolumeOptions::default() };
                let estimate = estimate(&volume, &volume.statistics(), &options, &Limits::default()).unwrap();
                let count = voxelize(&volume, &options, &Limits::default()).unwrap().grids[0].count();
                let error = (estimate.voxels as f64 / count as f64 - 1.0).abs();
                assert!(error <= tolerance, "{edge} {shell}: {} {count}", estimate.voxels);
                assert_eq!((estimate.size, estimate.voxel_size), ([edge as u64; 3], 1.0));
            }
        }
    }
}
