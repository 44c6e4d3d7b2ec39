//! How many voxels a mesh or a cloud of points will come to, without voxelizing it.

use super::hyperloglog::HyperLogLog;
use super::mesh_appearance::MeshAppearance;
use super::triangle::Triangle;
use super::{Placement, SurfaceRule, VoxelizeError, VoxelizeOptions, moving};
use crate::mesh::Mesh;
use crate::points::PointCloud;
use glam::DVec3;
use rayon::prelude::*;

/// Estimated size of the scene that voxelizing would make.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// The grid: its place, the edge of a voxel and the number of voxels along each axis.
    pub placement: Placement,
    /// Occupied voxels, usually within 10 %; too many where surfaces share voxels.
    pub voxels: u64,
    /// Bytes of the packed scene.
    pub bytes: u64,
    /// Whether both are only an upper bound, far from tight.
    pub is_bound: bool,
}

/// Estimates the voxels of a mesh by its projected areas. A plane of area A and unit normal n crosses A·(|n.x|+|n.y|+|n.z|)
/// voxels; thinly voxelized it takes the largest of the three terms.
///
/// # Errors
/// If there is no surface, or no grid for it.
pub fn estimate(mesh: &Mesh, options: &VoxelizeOptions) -> Result<Estimate, VoxelizeError> {
    if let Some(moving) = &mesh.moving {
        return moving::estimate(mesh, moving, options);
    }
    mesh.validate().map_err(VoxelizeError::BadMesh)?;
    let placement = Placement::of(mesh, options.scale)?;
    let voxels = placement.at_most(voxels_of(mesh, &placement, options.rule));
    let is_plain = MeshAppearance::of(mesh).uniform.is_some();
    Ok(Estimate { placement, voxels, bytes: bytes_of(voxels, is_plain), is_bound: false })
}

/// The voxels of a mesh by its projected areas.
pub(super) fn voxels_of(mesh: &Mesh, placement: &Placement, rule: SurfaceRule) -> f64 {
    let chunk = 1 << 14;
    let count = mesh.triangle_count();
    let sums: Vec<f64> = (0..count.div_ceil(chunk))
        .into_par_iter()
        .map(|at| {
            let triangles = at * chunk..((at + 1) * chunk).min(count);
            let normals = triangles.filter_map(|index| Triangle::of(mesh, placement, index)).map(|t| t.normal.abs());
            let voxels = normals.map(|normal| match rule {
                SurfaceRule::Conservative => normal.element_sum(),
                SurfaceRule::Thin => normal.max_element(),
            });
            voxels.sum::<f64>() * 0.5
        })
        .collect();
    sums.iter().sum()
}

/// The voxels that a closed mesh encloses: the sum of the tetrahedra between its triangles and the corner of the grid.
pub(super) fn enclosed_by(mesh: &Mesh, placement: &Placement) -> f64 {
    let triangles = (0..mesh.triangle_count()).filter_map(|index| Triangle::of(mesh, placement, index));
    triangles.map(|triangle| DVec3::from_array(triangle.corners[0]).dot(triangle.normal) / 6.0).sum::<f64>().abs()
}

/// Bytes of a packed scene of so many voxels, of one material (`is_plain`) or of many.
pub(super) fn bytes_of(voxels: u64, is_plain: bool) -> u64 {
    (voxels as f64 * if is_plain { 1.0 } else { 2.2 }) as u64
}

/// Estimates the voxels of a cloud of points: the number of distinct voxels with points in them, to about 1 % (HyperLogLog).
///
/// # Errors
/// If there is no point, or no grid for them.
pub fn estimate_points(cloud: &PointCloud, options: &VoxelizeOptions) -> Result<Estimate, VoxelizeError> {
    cloud.validate().map_err(VoxelizeError::BadPoints)?;
    let placement = Placement::of_points(cloud, options.scale)?;
    let part = |points: &[glam::Vec3]| {
        let mut part = HyperLogLog::default();
        points.iter().for_each(|&point| part.add(placement.voxels(point).as_ivec3()));
        part
    };
    let size = cloud.positions.len().div_ceil(rayon::current_num_threads()).max(1);
    let parts: Vec<HyperLogLog> = cloud.positions.par_chunks(size).map(part).collect();
    let mut counter = HyperLogLog::default();
    parts.iter().for_each(|part| counter.merge(part));
    let voxels = placement.at_most(counter.count().min(cloud.positions.len() as f64));
    let is_bound = options.points.min_points > 1;
    Ok(Estimate { placement, voxels, bytes: bytes_of(voxels, false), is_bound })
}
