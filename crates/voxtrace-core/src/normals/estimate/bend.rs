//! The direction in which a field is bent most: the eigenvectors of its matrix of second derivatives by Jacobi's rotations.

use glam::Vec3;

/// Rounds of rotations; three suffice for singles.
const ROUNDS: usize = 6;

/// The most negative eigenvalue of a symmetric matrix (xx, yy, zz, yz, zx, xy), its unit eigenvector, and the largest by amount of the others.
pub fn strongest_bend(matrix: &[f32; 6]) -> (f64, Vec3, f64) {
    let [xx, yy, zz, yz, zx, xy] = matrix.map(f64::from);
    let mut m = [[xx, xy, zx], [xy, yy, yz], [zx, yz, zz]];
    let mut vectors = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    for _ in 0..ROUNDS {
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            rotate(&mut m, &mut vectors, p, q);
        }
    }
    let least = (0..3).min_by(|&a, &b| m[a][a].total_cmp(&m[b][b])).unwrap_or(0);
    let other =
        (0..3).filter(|&i| i != least).map(|i| m[i][i]).fold(0.0, |a: f64, b| if b.abs() > a.abs() { b } else { a });
    let vector = Vec3::from_array(std::array::from_fn(|row| vectors[row][least] as f32));
    (m[least][least], vector, other)
}

/// Makes the element (p, q) of `m` zero, and turns `vectors` alike.
fn rotate(m: &mut [[f64; 3]; 3], vectors: &mut [[f64; 3]; 3], p: usize, q: usize) {
    if m[p][q].abs() < 1e-18 {
        return;
    }
    let theta = (m[q][q] - m[p][p]) / (2.0 * m[p][q]);
    let t = 1.0f64.copysign(theta) / (theta.abs() + (theta * theta + 1.0).sqrt());
    let c = 1.0 / (t * t + 1.0).sqrt();
    let s = t * c;
    for row in 0..3 {
        let (a, b) = (m[row][p], m[row][q]);
        (m[row][p], m[row][q]) = (c * a - s * b, s * a + c * b);
        let (a, b) = (vectors[row][p], vectors[row][q]);
        (vectors[row][p], vectors[row][q]) = (c * a - s * b, s * a + c * b);
    }
    let (row_p, row_q) = (m[p], m[q]);
    m[p] = std::array::from_fn(|column| c * row_p[column] - s * row_q[column]);
    m[q] = std::array::from_fn(|column| s * row_p[column] + c * row_q[column]);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_strongest_bend_of_a_sheet_is_across_it() {
        let normal = Vec3::new(0.36, -0.48, 0.8);
        let of = |a: f32, b: f32, n: Vec3| {
            let along = n.any_orthonormal_vector();
            let m = |i: usize, j: usize| -a * n[i] * n[j] + b * along[i] * along[j];
            strongest_bend(&[m(0, 0), m(1, 1), m(2, 2), m(1, 2), m(2, 0), m(0, 1)])
        };
        let (bend, across, other) = of(0.3, -0.1, normal);
        assert!((bend + 0.3).abs() < 1e-6 && (other + 0.1).abs() < 1e-6, "{bend} {other}");
        assert!(across.dot(normal).abs() > 0.999_999, "{across}");
        assert!(of(0.3, 0.0, Vec3::Z).1.dot(Vec3::Z).abs() > 0.999_999);
    }
}
