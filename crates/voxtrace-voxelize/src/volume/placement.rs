//! How the lattice of a volume is laid onto the voxel grid.

use super::resample::{Axis, Spacing};
use super::{Volume, VolumeError};
use crate::voxelize::Scale;
use glam::{DAffine3, DMat3, DVec3};
use voxtrace_scene::Transform;
use voxtrace_scene::georeference::Georeference;
use voxtrace_scene::grid::MAX_COORDINATE;

/// Most voxels along an axis by default.
const DEFAULT_MAX_SIZE: f64 = 2048.0;
/// Sine of the angle up to which a lattice axis counts as parallel to a world axis.
const MAX_TILT: f64 = 1e-3;
/// Share of a voxel up to which the length of an axis counts as a whole number of voxels.
const FITS: f64 = 1e-6;

/// How the lattice is laid onto the voxel grid.
pub(super) struct Placement {
    /// For each axis of the grid: the lattice axis along it, and whether it runs backwards.
    pub axes: [Axis; 3],
    pub voxel_size: f64,
    pub world_from_grid: Transform,
    pub georeference: Georeference,
    /// From the coordinates of the grid to the world of the volume, in its unit.
    pub coordinates_from_grid: DAffine3,
}

impl Placement {
    /// `box_limit` is the most voxels that the whole box may have, empty ones included.
    pub fn of(volume: &Volume, scale: Option<Scale>, box_limit: u64, nearest: bool) -> Result<Self, VolumeError> {
        let spacing = volume.spacing();
        let lengths = spacing * DVec3::from_array(volume.size.map(|size| size as f64));
        let voxel_size = match scale {
            Some(Scale::VoxelSize(size)) => size,
            Some(Scale::Resolution(count)) => lengths.max_element() / f64::from(count.max(1)),
            None | Some(Scale::Automatic) => spacing.min_element().max(lengths.max_element() / DEFAULT_MAX_SIZE),
        };
        if !voxel_size.is_finite() || voxel_size <= 0.0 {
            return Err(VolumeError::BadScale(voxel_size));
        }
        let axes = volume.world_from_index.matrix3;
        let directions = [axes.x_axis / spacing.x, axes.y_axis / spacing.y, axes.z_axis / spacing.z];
        let order = nearest_axes(directions);
        let mut spacings = [Spacing::over(1, 1); 3];
        for (world, &(lattice, _)) in order.iter().enumerate() {
            let count = (lengths[lattice] / voxel_size).round().max(1.0);
            let most = f64::from(MAX_COORDINATE / 2);
            if count > most {
                return Err(VolumeError::TooLarge {
                    what: "voxels along an axis",
                    needed: count as u64,
                    limit: most as u64,
                });
            }
            let (samples, count) = (volume.size[lattice], count as usize);
            // Samples that are voxels stay what they are, though these be a little longer or shorter along this axis; voxels of mixed samples are cubes.
            let fits = samples == count || (lengths[lattice] / voxel_size - count as f64).abs() < FITS;
            spacings[world] = if fits {
                Spacing::over(samples, count)
            } else {
                Spacing::within(samples, count, voxel_size / spacing[lattice])
            };
        }
        let needed = spacings.iter().map(|spacing| spacing.count as u64).fold(1, u64::saturating_mul);
        if needed > box_limit {
            return Err(VolumeError::TooLarge { what: "voxels of the whole box", needed, limit: box_limit });
        }
        // From the axes of the grid, which are the lattice's in another order, to the world.
        let signed = |world: usize| {
            let (lattice, backwards) = order[world];
            if backwards { -directions[lattice] } else { directions[lattice] }
        };
        let linear = DMat3::from_cols(signed(0), signed(1), signed(2));
        let edge = |world: usize| {
            let Spacing { count, margin, .. } = spacings[world];
            if margin == 0.0 { lengths[order[world].0] / count as f64 } else { voxel_size }
        };
        let edges = DVec3::from_array(std::array::from_fn(edge));
        let coordinates = linear * DMat3::from_diagonal(edges);
        let is_straight = (linear - DMat3::IDENTITY).to_cols_array().iter().all(|value| value.abs() < MAX_TILT);
        let is_rotation =
            (linear.transpose() * linear - DMat3::IDENTITY).to_cols_array().iter().all(|v| v.abs() < 1e-5);
        let linear = if is_straight || !is_rotation { DMat3::IDENTITY } else { linear };
        let mut first = DVec3::ZERO;
        for (&(lattice, backwards), Spacing { margin, .. }) in order.iter().zip(spacings) {
            first[lattice] = if backwards { volume.size[lattice] as f64 - 0.5 - margin } else { margin - 0.5 };
        }
        let first = volume.world_from_index.transform_point3(first);
        let corner = first / voxel_size;
        // Whole voxels, so that the volume keeps the grid's alignment; what is too far away for f32 stays here.
        let corner = if linear == DMat3::IDENTITY { corner.round() } else { corner };
        let corner = if corner.abs().max_element() < f64::from(MAX_COORDINATE / 2) { corner } else { DVec3::ZERO };
        let axes = std::array::from_fn(|world| {
            let (lattice, backwards) = order[world];
            Axis::spaced(lattice, volume.size, backwards, spacings[world], nearest)
        });
        let world_from_grid = Transform { linear: linear.as_mat3(), translation: corner.as_vec3() };
        let grid_from_world = DAffine3 { matrix3: linear, translation: corner }.inverse();
        let coordinates_from_grid = DAffine3 { matrix3: coordinates, translation: first };
        let coordinates_from_world = coordinates_from_grid * grid_from_world;
        let georeference = Georeference { coordinates_from_world, crs: String::new() };
        Ok(Self { axes, voxel_size, world_from_grid, georeference, coordinates_from_grid })
    }
}

impl Placement {
    /// For each axis of the lattice the axis of the grid along it.
    pub fn world_of_lattice(&self) -> [usize; 3] {
        std::array::from_fn(|lattice| self.axes.iter().position(|axis| axis.lattice == lattice).unwrap_or(lattice))
    }

    /// The axes in the order of the lattice.
    pub fn axes_of_lattice(&self) -> [&Axis; 3] {
        self.world_of_lattice().map(|world| &self.axes[world])
    }
}

/// For each axis of the world the lattice axis nearest to it, and whether that runs backwards.
fn nearest_axes(directions: [DVec3; 3]) -> [(usize, bool); 3] {
    const ORDERS: [[usize; 3]; 6] = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
    let fit = |order: &[usize; 3]| (0..3).map(|world| directions[order[world]][world].abs()).sum::<f64>();
    let mut best = ORDERS[0];
    for order in ORDERS {
        // Ties keep the order of the file.
        if fit(&order) > fit(&best) + 1e-9 {
            best = order;
        }
    }
    std::array::from_fn(|world| (best[world], directions[best[world]][world] < 0.0))
}
