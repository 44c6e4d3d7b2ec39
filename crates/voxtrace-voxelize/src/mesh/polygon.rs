//! Triangulates polygons by ear clipping (Meisters, "Polygons Have Ears", 1975), projected along the dominant axis of the normal.
//! Where no ear is left, as in a polygon that crosses itself, the rest becomes a fan.

use glam::{DVec2, Vec3};

/// Larger polygons become fans at once: ear clipping takes quadratic time.
const MOST_CORNERS: usize = 4096;
/// How often all corners are searched again for ears in a polygon that crosses itself, before the rest becomes a fan.
const MAX_RESCANS: usize = 8;

/// Appends the triangles of a polygon as indices 0..n into its corners.
pub fn triangulate(corners: &[Vec3], triangles: &mut Vec<[usize; 3]>) {
    let count = corners.len();
    if count <= 3 || count > MOST_CORNERS || is_convex(corners) {
        triangles.extend((2..count).map(|i| [0, i - 1, i]));
        return;
    }
    let points = flattened(corners);
    let mut left: Vec<usize> = (0..count).collect();
    let mut ears: Vec<bool> = (0..count).map(|at| is_ear(&points, &left, at)).collect();
    let mut rescans = MAX_RESCANS * count;
    while left.len() > 3 {
        let n = left.len();
        let ear = match ears.iter().position(|&is_ear| is_ear) {
            Some(ear) => ear,
            None if rescans >= n => {
                // Of a polygon that crosses itself, other corners than the neighbours may have become ears.
                rescans -= n;
                ears = (0..n).map(|at| is_ear(&points, &left, at)).collect();
                match ears.iter().position(|&is_ear| is_ear) {
                    Some(ear) => ear,
                    None => break,
                }
            }
            None => break,
        };
        triangles.push([left[(ear + n - 1) % n], left[ear], left[(ear + 1) % n]]);
        left.remove(ear);
        ears.remove(ear);
        for neighbour in [(ear + n - 2) % (n - 1), ear % (n - 1)] {
            ears[neighbour] = is_ear(&points, &left, neighbour);
        }
    }
    triangles.extend((2..left.len()).map(|i| [left[0], left[i - 1], left[i]]));
}

/// Area vector: along the normal, with twice the area as length (Newell).
fn normal(corners: &[Vec3]) -> Vec3 {
    (1..corners.len().saturating_sub(1))
        .map(|i| (corners[i] - corners[0]).cross(corners[i + 1] - corners[0]))
        .fold(Vec3::ZERO, |sum, part| sum + part)
}

fn is_convex(corners: &[Vec3]) -> bool {
    let normal = normal(corners);
    let count = corners.len();
    (0..count).all(|i| {
        let (a, b, c) = (corners[i], corners[(i + 1) % count], corners[(i + 2) % count]);
        (b - a).cross(c - b).dot(normal) >= 0.0
    }) && count == 4
}

/// The corners, projected so that the polygon runs counterclockwise.
fn flattened(corners: &[Vec3]) -> Vec<DVec2> {
    let normal = normal(corners);
    let axis = normal.abs().max_position();
    let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
    let sign = if normal[axis] < 0.0 { -1.0 } else { 1.0 };
    corners.iter().map(|corner| DVec2::new(f64::from(corner[u]) * sign, f64::from(corner[v]))).collect()
}

fn is_ear(points: &[DVec2], left: &[usize], at: usize) -> bool {
    let n = left.len();
    let [a, b, c] = [left[(at + n - 1) % n], left[at], left[(at + 1) % n]];
    let side = |p: usize, q: usize, r: usize| (points[q] - points[p]).perp_dot(points[r] - points[p]);
    if side(a, b, c) <= 0.0 {
        return false;
    }
    // Corners at the same place as one of the ear's do not block it.
    let is_same = |i: usize| [a, b, c].iter().any(|&corner| points[corner] == points[i]);
    left.iter().all(|&i| is_same(i) || side(a, b, i) < 0.0 || side(b, c, i) < 0.0 || side(c, a, i) < 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn area(corners: &[Vec3], triangles: &[[usize; 3]]) -> f32 {
        triangles.iter().map(|&[a, b, c]| (corners[b] - corners[a]).cross(corners[c] - corners[a]).length() * 0.5).sum()
    }

    #[test]
    fn a_concave_polygon_keeps_its_area() {
        // An L of three unit squares, in a tilted plane of the same area in x and y.
        let flat = [[0, 0], [2, 0], [2, 1], [1, 1], [1, 2], [0, 2]];
        for start in 0..6 {
            for is_turned in [false, true] {
                let mut corners: Vec<Vec3> =
                    (0..6).map(|i| flat[(i + start) % 6]).map(|[x, y]| Vec3::new(x as f32, y as f32, 0.0)).collect();
                if is_turned {
                    corners.reverse();
                }
                let mut triangles = Vec::new();
                triangulate(&corners, &mut triangles);
                assert_eq!(triangles.len(), 4);
                assert!((area(&corners, &triangles) - 3.0).abs() < 1e-6, "{start} {is_turned}");
            }
        }
    }

    #[test]
    fn a_concave_quad_is_cut_at_its_inner_corner() {
        let corners = [[0.0, 0.0], [2.0, 1.0], [0.0, 2.0], [0.5, 1.0]].map(|[x, y]| Vec3::new(x, y, 1.0));
        let mut triangles = Vec::new();
        triangulate(&corners, &mut triangles);
        assert!((area(&corners, &triangles) - 1.5).abs() < 1e-6);
    }

    #[test]
    fn a_comb_of_thousands_of_corners_keeps_its_area() {
        let teeth = 1000;
        let upper = (0..teeth).flat_map(|n| {
            [[n, 1], [n, 9]].map(|[x, y]| [2 * x, y]).into_iter().chain([[2 * n + 1, 9], [2 * n + 1, 1]])
        });
        let outline = upper.chain([[2 * teeth, 1], [2 * teeth, 0], [0, 0]]);
        let mut corners: Vec<Vec3> = outline.map(|[x, y]| Vec3::new(x as f32, 0.0, y as f32)).collect();
        for _ in 0..2 {
            let mut triangles = Vec::new();
            triangulate(&corners, &mut triangles);
            assert_eq!(triangles.len(), corners.len() - 2);
            let wanted = (2 * teeth + 8 * teeth) as f32;
            assert!((area(&corners, &triangles) / wanted - 1.0).abs() < 1e-4, "{}", area(&corners, &triangles));
            corners.reverse();
        }
    }

    #[test]
    fn a_saw_of_thousands_of_corners_that_block_each_other_keeps_its_area() {
        // Looking for every ear from the first corner on takes seconds here.
        let teeth = 1024;
        let there = (0..teeth).flat_map(|n| [[n as f32, 10.0], [n as f32 + 0.5, 0.0]]);
        let back = (1..=teeth).rev().flat_map(|n| [[n as f32, 11.0], [n as f32 - 0.5, 1.0]]);
        let corners: Vec<Vec3> = there.chain(back).map(|[x, y]| Vec3::new(x, y, 0.0)).collect();
        let mut triangles = Vec::new();
        triangulate(&corners, &mut triangles);
        assert_eq!(triangles.len(), corners.len() - 2);
        assert!((area(&corners, &triangles) - (teeth as f32 - 0.5)).abs() < 0.01, "{}", area(&corners, &triangles));
    }

    #[test]
    fn polygons_without_ears_or_area_still_end() {
        let crossing = [[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0], [0.5, 2.0]].map(|[x, y]| Vec3::new(x, y, 0.0));
        for corners in [&crossing[..], &[Vec3::ONE; 7][..], &[][..], &[Vec3::X][..], &[Vec3::X; 2][..]] {
            let mut triangles = Vec::new();
            triangulate(corners, &mut triangles);
            assert_eq!(triangles.len(), corners.len().saturating_sub(2));
        }
    }
}
