//! The faces of voxels that no other voxel covers, merged greedily to rectangles within each brick.

use super::bricks::{BrickAt, Occupancy};
use glam::IVec3;
use voxtrace_core::packed::{Geometry, PackedGrid};
use voxtrace_scene::faces::{OTHER_AXES, merge_bits};

/// A rectangle of faces in one plane; coordinates count from the grid's origin.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rectangle {
    /// Number of the face: twice the axis, + 1 where it looks along +.
    pub face: u32,
    /// Coordinate of the plane along the face's axis.
    pub plane: i32,
    /// First voxel along the two other axes, lower axis first.
    pub first: [i32; 2],
    /// Voxels along them.
    pub count: [i32; 2],
}

/// The rectangles of one brick.
pub fn rectangles(geometry: &Geometry, grid: &PackedGrid, brick: BrickAt, found: &mut impl FnMut(Rectangle)) {
    let own = Occupancy::of(geometry, brick.record);
    for face in 0..6 {
        let axis = face / 2;
        let step = if face & 1 == 1 { 1 } else { -1 };
        let mut beside = IVec3::ZERO;
        beside[axis] = step * 8;
        let neighbour = geometry
            .find_brick(grid, brick.low + beside + grid.origin)
            .map_or(Occupancy::default(), |record| Occupancy::of(geometry, record));
        for layer in 0..8 {
            // Bit u of `rows[v]`: the face of the voxel at (u, v) is free.
            let mut rows = [0u8; 8];
            for i in 0..64 {
                let (u, v) = (i & 7, i >> 3);
                let mut voxel = IVec3::ZERO;
                (voxel[axis], voxel[OTHER_AXES[axis][0]], voxel[OTHER_AXES[axis][1]]) = (layer, u, v);
                let mut front = voxel;
                front[axis] += step;
                let is_covered = if (0..8).contains(&front[axis]) { own.has(front) } else { neighbour.has(front & 7) };
                rows[v as usize] |= u8::from(own.has(voxel) && !is_covered) << u;
            }
            let plane = brick.low[axis] + layer + i32::from(step == 1);
            merge_bits(rows, &mut |first, count| {
                let [a, b] = OTHER_AXES[axis];
                let first = [brick.low[a] + first[0], brick.low[b] + first[1]];
                found(Rectangle { face: face as u32, plane, first, count });
            });
        }
    }
}
