//! Thin (6-separating) surfaces: a voxel is set where the surface crosses one of the three axis-parallel lines through its centre.
//! No path from voxel to voxel through faces can pass such a surface (Laine, "A Topological Approach to Voxelization", EGSR 2013;
//! the 6-separating voxels of Schwarz and Seidel, "Fast Parallel Surface and Solid Voxelization on GPUs", SIGGRAPH Asia 2010).

use super::triangle::Triangle;
use glam::{DVec2, IVec3};

/// Calls `each` with every voxel of the triangle from `from` to `to` (exclusive), and the point where a line through the voxel's
/// centre crosses. A voxel may come up to three times.
pub(super) fn for_each_voxel(triangle: &Triangle, from: IVec3, to: IVec3, mut each: impl FnMut(IVec3, [f64; 3])) {
    for axis in 0..3 {
        let Some(projected) = ProjectedTriangle::of(triangle, axis) else { continue };
        let [u, v] = projected.axes;
        projected.for_each_line([from[u], from[v]], [to[u], to[v]], |line, depth| {
            let cell = depth.floor() as i32;
            if cell < from[axis] || cell >= to[axis] {
                return;
            }
            let mut voxel = IVec3::ZERO;
            (voxel[u], voxel[v], voxel[axis]) = (line[0], line[1], cell);
            let mut point = [0.0; 3];
            (point[u], point[v], point[axis]) = (f64::from(line[0]) + 0.5, f64::from(line[1]) + 0.5, depth);
            each(voxel, point);
        });
    }
}

/// A triangle projected along an axis. Its corners lie on the lattice, so the edge functions are exact and triangles that share
/// an edge agree.
pub(super) struct ProjectedTriangle {
    /// The two other axes.
    pub axes: [usize; 2],
    corners: [DVec2; 3],
    /// Depth at the origin of the projection plane.
    depth: f64,
    /// Gradient of the depth over the projection plane.
    slope: DVec2,
    /// +1 where the normal points along the axis, −1 where it points against it.
    pub facing: i32,
}

impl ProjectedTriangle {
    /// `None` where the triangle is parallel to the axis.
    pub fn of(triangle: &Triangle, axis: usize) -> Option<Self> {
        let across = triangle.normal[axis];
        if across == 0.0 {
            return None;
        }
        let axes = [(axis + 1) % 3, (axis + 2) % 3];
        let mut corners = triangle.corners.map(|corner| DVec2::from_array(axes.map(|axis| corner[axis])));
        let slope = DVec2::from_array(axes.map(|axis| triangle.normal[axis])) / -across;
        let depth = triangle.corners[0][axis] - slope.dot(corners[0]);
        if across < 0.0 {
            corners.swap(1, 2);
        }
        Some(Self { axes, corners, depth, slope, facing: if across > 0.0 { 1 } else { -1 } })
    }

    /// Calls `each` with every line through cell centres from `from` to `to` that the triangle covers, and the depth there. Of two
    /// triangles with a shared edge on a line exactly one covers it (the top-left rule of rasterization).
    pub fn for_each_line(&self, from: [i32; 2], to: [i32; 2], mut each: impl FnMut([i32; 2], f64)) {
        let [a, b, c] = self.corners;
        let (low, high) = (a.min(b).min(c), a.max(b).max(c));
        let first = |axis: usize| ((low[axis] - 0.5).ceil() as i32).max(from[axis]);
        let last = |axis: usize| ((high[axis] - 0.5).floor() as i32).min(to[axis] - 1);
        let edges = [(a, b), (b, c), (c, a)];
        for y in first(1)..=last(1) {
            for x in first(0)..=last(0) {
                let point = DVec2::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
                let is_covered = edges.iter().all(|&(from, to)| {
                    let edge = to - from;
                    let side = edge.perp_dot(point - from);
                    side > 0.0 || side == 0.0 && (edge.y < 0.0 || edge.y == 0.0 && edge.x < 0.0)
                });
                if is_covered {
                    each([x, y], self.depth + self.slope.dot(point));
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    fn triangle(corners: [[f64; 3]; 3]) -> Triangle {
        let [a, b, c] = corners.map(DVec3::from_array);
        Triangle { corners, normal: (b - a).cross(c - a) }
    }

    #[test]
    fn two_triangles_of_a_square_cover_each_line_once() {
        let [a, b, c, d] = [[0.5, 0.5, 1.0], [8.5, 0.5, 1.0], [8.5, 8.5, 1.0], [0.5, 8.5, 1.0]];
        let mut counts = [[0; 10]; 10];
        for corners in [[a, b, c], [a, c, d]] {
            let projected = ProjectedTriangle::of(&triangle(corners), 2).unwrap();
            projected.for_each_line([0, 0], [10, 10], |[x, y], depth| {
                assert_eq!(depth, 1.0);
                counts[y as usize][x as usize] += 1;
            });
        }
        assert_eq!(counts.iter().flatten().sum::<i32>(), 64);
        assert!(counts.iter().flatten().all(|&count| count <= 1));
    }

    #[test]
    fn a_slanted_triangle_takes_the_voxels_whose_middle_lines_it_crosses() {
        let mut voxels = Vec::new();
        let slanted = triangle([[0.0, 0.0, 0.25], [8.0, 0.0, 4.25], [0.0, 8.0, 0.25]]);
        for_each_voxel(&slanted, IVec3::ZERO, IVec3::splat(8), |voxel, point| {
            assert!((point[2] - (0.25 + point[0] * 0.5)).abs() < 1e-12, "{point:?}");
            voxels.push(voxel);
        });
        assert!(voxels.contains(&IVec3::new(3, 0, 2)) && !voxels.contains(&IVec3::new(3, 0, 1)));
    }
}
