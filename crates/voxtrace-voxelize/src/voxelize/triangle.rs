//! A triangle of the mesh in voxels, snapped to the lattice.

use super::placement::Placement;
use super::polygon::{Point, Polygon};
use crate::mesh::Mesh;
use glam::DVec3;

/// A triangle with an area.
#[derive(Clone, Copy)]
pub(super) struct Triangle {
    pub corners: [Point; 3],
    /// Cross product of two edges; its length is twice the area.
    pub normal: DVec3,
}

impl Triangle {
    /// `None` where the triangle has no area.
    #[inline]
    pub fn of(mesh: &Mesh, placement: &Placement, index: usize) -> Option<Self> {
        let [a, b, c] = mesh.corners(index);
        let at = |corner: usize| placement.voxels(mesh.positions[corner]);
        let corners = [at(a), at(b), at(c)];
        let normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
        if normal == DVec3::ZERO {
            return None;
        }
        let mut corners = [corners[0].to_array(), corners[1].to_array(), corners[2].to_array()];
        for axis in 0..3 {
            let at = corners[0][axis];
            if at == corners[1][axis] && at == corners[2][axis] && at == at.floor() {
                // A face exactly between two voxels belongs to the one behind it, so that a box from 2 to 8 is six voxels wide.
                let behind = if normal[axis] > 0.0 { -0.5 } else { 0.5 };
                corners.iter_mut().for_each(|corner| corner[axis] += behind);
            }
        }
        Some(Self { corners, normal })
    }

    /// The triangle as a polygon to clip.
    pub fn polygon(&self) -> Polygon {
        Polygon::new(&self.corners)
    }

    /// The dominant axis of the normal: the projection along it is the largest.
    pub fn dominant_axis(&self) -> usize {
        self.normal.abs().max_position()
    }
}
