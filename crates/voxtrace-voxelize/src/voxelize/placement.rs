//! Where the voxel grid lies over a mesh. Vertices are snapped to a lattice much finer than a voxel. Triangles that share a vertex
//! then agree about it, and the edge functions of lattice triangles are exact in f64.

use super::polygon::TOUCH;
use super::{Scale, VoxelizeError};
use crate::mesh::Mesh;
use crate::points::PointCloud;
use glam::{DVec3, IVec3};
use voxtrace_scene::georeference::Georeference;
use voxtrace_scene::grid::MAX_COORDINATE;

/// Most fraction bits of a lattice coordinate, in voxels; fewer where the grid is large.
const MOST_BITS: u32 = 12;
/// All bits of a lattice coordinate: products of two differences then fit into the 53 bits of an f64.
const COORDINATE_BITS: u32 = 25;

/// Voxels along the longest side of a mesh by default.
const USUAL_RESOLUTION: u32 = 512;

/// A grid over a mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// Lowest corner of voxel (0, 0, 0), in the mesh's units with its offset.
    pub origin: DVec3,
    /// Edge of a voxel in the mesh's units.
    pub voxel_size: f64,
    /// Voxels along each axis.
    pub size: IVec3,
    /// The mesh's offset relative to the origin.
    shift: DVec3,
    /// Lattice steps per voxel, a power of two, and per unit of the mesh.
    steps: f64,
    steps_in_unit: f64,
}

impl Placement {
    /// Places a grid: with a resolution, the mesh fills it from corner to corner; with a voxel size, voxels lie at whole
    /// multiples of it, so that parts of one model voxelize to parts of one grid.
    ///
    /// # Errors
    /// If the mesh has no triangle or no extent, or the grid would be too large.
    pub fn of(mesh: &Mesh, scale: Scale) -> Result<Self, VoxelizeError> {
        Self::over(mesh.bounds().ok_or(VoxelizeError::Empty)?, mesh.offset, scale)
    }

    /// As [`Self::of`], for a cloud of points.
    ///
    /// # Errors
    /// If there is no point, or the grid would be too large.
    pub fn of_points(cloud: &PointCloud, scale: Scale) -> Result<Self, VoxelizeError> {
        let scale = if scale == Scale::Automatic { Scale::Resolution(cloud.suited_resolution()) } else { scale };
        Self::over(cloud.bounds().ok_or(VoxelizeError::NoPoints)?, cloud.offset, scale)
    }

    /// As [`Self::of`], over a bounding box; `offset` is added to the positions to come.
    pub(super) fn over((min, max): (DVec3, DVec3), offset: DVec3, scale: Scale) -> Result<Self, VoxelizeError> {
        let longest = (max - min).max_element();
        // A single point is one voxel.
        let along = |count: u32| (min, if longest > 0.0 { longest / f64::from(count.max(1)) } else { 1.0 });
        let (origin, voxel_size) = match scale {
            Scale::Automatic => along(USUAL_RESOLUTION),
            Scale::Resolution(count) => along(count),
            Scale::VoxelSize(size) => ((min / size).floor() * size, size),
        };
        Self::at(origin, voxel_size, max, offset)
    }

    /// As [`Self::over`], in voxels of a size, at whole distances from `corner`.
    pub(super) fn on_lattice(
        (min, max): (DVec3, DVec3),
        offset: DVec3,
        corner: DVec3,
        voxel_size: f64,
    ) -> Result<Self, VoxelizeError> {
        Self::at(corner + ((min - corner) / voxel_size).floor() * voxel_size, voxel_size, max, offset)
    }

    fn at(origin: DVec3, voxel_size: f64, max: DVec3, offset: DVec3) -> Result<Self, VoxelizeError> {
        if !voxel_size.is_normal() || voxel_size < 0.0 || !origin.is_finite() {
            return Err(VoxelizeError::BadScale(voxel_size));
        }
        let extent = (max - origin) / voxel_size;
        let most = f64::from(MAX_COORDINATE - 8);
        if extent.is_nan() || extent.max_element() >= most {
            return Err(VoxelizeError::TooLarge {
                what: "voxels along an axis",
                needed: extent.max_element() as u64,
                limit: MAX_COORDINATE as u64,
            });
        }
        // A quotient of a length and a part of it is rounded, up at times: that is no further voxel.
        let size = ((extent - TOUCH).ceil().as_ivec3()).max(IVec3::ONE);
        let bits = MOST_BITS.min(COORDINATE_BITS - (size.max_element() as u32).ilog2() - 1);
        let shift = offset - origin;
        let steps = f64::from(1u32 << bits);
        Ok(Self { origin, voxel_size, size, shift, steps, steps_in_unit: steps / voxel_size })
    }

    /// A vertex in voxels, snapped to the lattice.
    #[inline]
    pub(super) fn voxels(&self, position: glam::Vec3) -> DVec3 {
        /// 1.5 · 2⁵²: adding and subtracting it rounds to whole numbers, as an f64 has no bits below them there.
        const ROUND: f64 = 6_755_399_441_055_744.0;
        let steps = (position.as_dvec3() + self.shift) * self.steps_in_unit;
        // Steps in a voxel are a power of two: multiplying by the inverse is exact.
        ((steps + ROUND) - ROUND) * (1.0 / self.steps)
    }

    /// A number of voxels, clamped to 1 and the volume of the grid.
    pub(super) fn at_most(&self, voxels: f64) -> u64 {
        let most = self.size.to_array().iter().map(|&n| f64::from(n)).product::<f64>();
        voxels.min(most).max(1.0) as u64
    }

    /// The grid's place in the reference system of the points that it is made of.
    pub(super) fn georeference(&self, cloud: &PointCloud) -> Georeference {
        let place = Georeference::of_grid(self.origin, self.voxel_size, &cloud.crs);
        Georeference { coordinates_from_world: cloud.crs_from_cloud * place.coordinates_from_world, ..place }
    }

    /// A point in the mesh's units without its offset, in voxels.
    pub(super) fn point(&self, position: glam::Vec3) -> glam::Vec3 {
        ((position.as_dvec3() + self.shift) / self.voxel_size).as_vec3()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;

    fn mesh(corners: [[f32; 3]; 3]) -> Mesh {
        Mesh { positions: corners.map(Vec3::from_array).to_vec(), ..Mesh::new("mesh") }
    }

    #[test]
    fn a_resolution_counts_along_the_longest_side() {
        let mesh = mesh([[1.0, 2.0, 3.0], [5.0, 2.0, 3.0], [1.0, 4.0, 3.5]]);
        let placed = Placement::of(&mesh, Scale::Resolution(8)).unwrap();
        assert_eq!((placed.voxel_size, placed.size), (0.5, IVec3::new(8, 4, 1)));
        assert_eq!(placed.voxels(mesh.positions[1]), DVec3::new(8.0, 0.0, 0.0));
    }

    #[test]
    fn a_resolution_is_the_number_of_voxels_whatever_quotients_are_rounded_to() {
        for length in [1.0, 0.3, 7.1, 123.456] {
            let mesh = mesh([[0.0; 3], [length, 0.0, 0.0], [0.0, 0.5 * length, 0.0]]);
            for count in 1..2000 {
                let placed = Placement::of(&mesh, Scale::Resolution(count)).unwrap();
                assert_eq!(placed.size.x, count as i32, "{length}");
            }
        }
    }

    #[test]
    fn a_voxel_size_lays_voxels_at_its_multiples() {
        let mesh = mesh([[1.3, -0.2, 0.0], [5.0, 0.0, 0.0], [1.3, 4.0, 0.5]]);
        let placed = Placement::of(&mesh, Scale::VoxelSize(0.5)).unwrap();
        assert_eq!(placed.origin, DVec3::new(1.0, -0.5, 0.0));
        assert_eq!(placed.size, IVec3::new(8, 9, 1));
    }

    #[test]
    fn grids_that_cannot_be_are_refused() {
        let mesh = mesh([[0.0; 3], [1e9, 0.0, 0.0], [0.0, 1.0, 0.0]]);
        for scale in [0.0, -1.0, f64::NAN, f64::INFINITY, 1.0] {
            assert!(Placement::of(&mesh, Scale::VoxelSize(scale)).is_err(), "{scale}");
        }
        assert!(Placement::of(&Mesh::new("empty"), Scale::Resolution(8)).is_err());
        let point = Mesh { positions: vec![Vec3::ONE; 3], ..Mesh::new("point") };
        assert_eq!(Placement::of(&point, Scale::Resolution(8)).unwrap().size, IVec3::ONE);
    }
}
