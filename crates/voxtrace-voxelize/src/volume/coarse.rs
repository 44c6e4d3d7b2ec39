//! Volumes in coarser voxels that lie where the fine ones would: what is shown while a transfer function is being changed.

use super::{Placement, Transfer, ValueStatistics, Volume, VolumeError, VolumeOptions};
use super::{voxelize_placed, voxelize_with_statistics};
use crate::limits::Limits;
use crate::voxelize::Scale;
use voxtrace_scene::Transform;
use voxtrace_scene::scene::Scene;

/// As [`voxelize_with_statistics`], in larger voxels, `edge` along the longest side, that lie in the place of those which `options` ask for; each has the value of its nearest
/// sample. Where these are no more, they are taken.
///
/// # Errors
/// As [`super::voxelize`].
pub fn voxelize_coarse(
    volume: &Volume,
    values: &ValueStatistics,
    options: &VolumeOptions,
    edge: u32,
    limits: &Limits,
) -> Result<Scene, VolumeError> {
    volume.validate().map_err(VolumeError::BadVolume)?;
    let mut transfer = options.transfer.clone().unwrap_or_else(|| Transfer::automatic(values));
    transfer.resolve(values, options.threshold);
    let fine = Placement::of(volume, options.scale, limits.voxels, transfer.is_labels())?;
    let longest = fine.axes.iter().map(|axis| axis.count()).max().unwrap_or(1);
    let factor = longest as f64 / f64::from(edge.max(1));
    if factor <= 1.0 {
        return voxelize_with_statistics(volume, values, options, limits);
    }
    // The nearest sample of each voxel: a mean of all would read the whole volume, and thin things would fade.
    let coarse = Placement::of(volume, Some(Scale::VoxelSize(fine.voxel_size * factor)), limits.voxels, true)?;
    // Their corners are not the same where voxels fit no whole number of times.
    let corner = fine.coordinates_from_grid.inverse().transform_point3(coarse.coordinates_from_grid.translation);
    let mut scene = voxelize_placed(volume, values, options, &transfer, coarse, &|| true)?;
    let Transform { linear, .. } = fine.world_from_grid;
    let translation = fine.world_from_grid.point(corner.as_vec3());
    for instance in &mut scene.instances {
        instance.world_from_grid = Transform { linear: linear * factor as f32, translation };
    }
    (scene.voxel_size, scene.georeference) = (fine.voxel_size, Some(fine.georeference));
    Ok(scene)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::volume::Preset;
    use glam::{DAffine3, DVec3, Vec3};

    /// A ball in the middle of 40 × 32 × 24 samples, some of which lie apart by 2 mm, somewhere.
    fn ball() -> Volume {
        let size = [40, 32, 24];
        let middle = DVec3::new(20.0, 16.0, 12.0);
        let value = |i: usize| {
            let at = DVec3::new((i % 40) as f64, (i / 40 % 32) as f64, (i / 1280) as f64) + 0.5;
            (12.0 - (at - middle).length()) as f32
        };
        let mut volume = Volume::new(size, (0..40 * 32 * 24).map(value).collect());
        volume.world_from_index = DAffine3::from_scale_rotation_translation(
            DVec3::new(2.0, 2.0, 3.0),
            glam::DQuat::IDENTITY,
            DVec3::new(-33.0, 7.0, 100.0),
        );
        volume
    }

    fn bounds(scene: &Scene) -> (Vec3, Vec3) {
        let instance = &scene.instances[0];
        let own = scene.grids[instance.grid].bounds().unwrap();
        (instance.world_from_grid.point(own.min.as_vec3()), instance.world_from_grid.point(own.max.as_vec3()))
    }

    #[test]
    fn coarse_voxels_lie_where_the_fine_ones_do() {
        let volume = ball();
        let values = volume.statistics();
        let options = VolumeOptions {
            transfer: Some(Preset::Surface.transfer()),
            threshold: Some(2.0),
            ..VolumeOptions::default()
        };
        let limits = Limits::default();
        let fine = voxelize_with_statistics(&volume, &values, &options, &limits).unwrap();
        let coarse = voxelize_coarse(&volume, &values, &options, 10, &limits).unwrap();
        let ((a, b), (c, d)) = (bounds(&fine), bounds(&coarse));
        // Within a coarse voxel, which is four fine ones.
        assert!((a - c).abs().max_element() <= 4.0 && (b - d).abs().max_element() <= 4.0, "{a} {b}, {c} {d}");
        assert!(coarse.grids[0].count() * 8 < fine.grids[0].count());
        assert_eq!(coarse.voxel_size, fine.voxel_size);
        let same = voxelize_coarse(&volume, &values, &options, 40, &limits).unwrap();
        assert_eq!(same.grids[0].count(), fine.grids[0].count(), "there is nothing coarser to make");
        // Where neither voxels fit a whole number of times, a slope still lies where it is.
        let slope = Volume::new([7, 7, 37], (0..7 * 7 * 37).map(|n| (n / 49) as f32).collect());
        let slope = Volume { world_from_index: DAffine3::from_scale(DVec3::new(1.0, 1.0, 1.3)), ..slope };
        let options = VolumeOptions { threshold: Some(20.5), ..options };
        let values = slope.statistics();
        let fine = voxelize_with_statistics(&slope, &values, &options, &limits).unwrap();
        let coarse = voxelize_coarse(&slope, &values, &options, 11, &limits).unwrap();
        let size = coarse.instances[0].world_from_grid.linear.x_axis.x;
        // The value of a coarse voxel is that of its nearest sample, which is half a step away at most.
        let apart = (bounds(&coarse).0.z - bounds(&fine).0.z).abs();
        assert!(size > 4.0 && apart <= size * 0.5 + 1.3, "{size} {apart}");
        let options = VolumeOptions { threshold: Some(2.0), ..options };
        let moved = Volume {
            world_from_index: DAffine3::from_translation(DVec3::X * 50.0) * volume.world_from_index,
            ..volume
        };
        let coarse = voxelize_coarse(&moved, &moved.statistics(), &options, 10, &limits).unwrap();
        assert!((bounds(&coarse).0 - a).abs().max_element() > 4.0, "the comparison sees another place");
    }
}
