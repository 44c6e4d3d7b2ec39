//! The faces of voxels that no other voxel covers, merged greedily to rectangles within each brick.

use super::bricks::{BrickAt, Occupancy};
use glam::IVec3;
use voxtrace_core::packed::{Geometry, PackedGrid};

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

/// Both other axes of each axis.
const OTHERS: [[usize; 2]; 3] = [[1, 2], [0, 2], [0, 1]];

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
                (voxel[axis], voxel[OTHERS[axis][0]], voxel[OTHERS[axis][1]]) = (layer, u, v);
                let mut front = voxel;
                front[axis] += step;
                let is_covered = if (0..8).contains(&front[axis]) { own.has(front) } else { neighbour.has(front & 7) };
                rows[v as usize] |= u8::from(own.has(voxel) && !is_covered) << u;
            }
            let plane = brick.low[axis] + layer + i32::from(step == 1);
            merge(rows, &mut |first, count| {
                let [a, b] = OTHERS[axis];
                let first = [brick.low[a] + first[0], brick.low[b] + first[1]];
                found(Rectangle { face: face as u32, plane, first, count });
            });
        }
    }
}

/// Covers the set bits with rectangles: the longest run of a row, then as many rows as hold it.
fn merge(mut rows: [u8; 8], found: &mut impl FnMut([i32; 2], [i32; 2])) {
    for v in 0..8 {
        while rows[v] != 0 {
            let u = rows[v].trailing_zeros();
            let width = (rows[v] >> u).trailing_ones();
            let run = (((1u32 << width) - 1) << u) as u8;
            let height = rows[v..].iter().take_while(|row| **row & run == run).count();
            for row in &mut rows[v..v + height] {
                *row &= !run;
            }
            found([u as i32, v as i32], [width as i32, height as i32]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rectangles_cover_every_bit_once() {
        let mut state = 1u32;
        for _ in 0..1000 {
            let rows = [0; 8].map(|_: u8| {
                state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                (state >> 24 | state >> 16) as u8
            });
            let mut covered = [0u8; 8];
            merge(rows, &mut |first, count| {
                for v in first[1]..first[1] + count[1] {
                    for u in first[0]..first[0] + count[0] {
                        assert_eq!(covered[v as usize] >> u & 1, 0, "covered twice");
                        covered[v as usize] |= 1 << u;
                    }
                }
            });
            assert_eq!(covered, rows);
        }
    }

    #[test]
    fn a_full_layer_is_one_rectangle() {
        let mut all = Vec::new();
        merge([0xff; 8], &mut |first, count| all.push((first, count)));
        assert_eq!(all, [([0, 0], [8, 8])]);
    }
}
