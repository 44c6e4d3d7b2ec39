//! A normal in 15 bits: its place on an octahedron that is unfolded onto a square (Cigolle et al., "A Survey of Efficient Representations for
//! Independent Unit Vectors", JCGT 3(2), 2014), seven bits along each edge, and whether both sides of the surface are seen.
//! Twin of `decode` in `shaders/normals.slang`.
//!
//! Places are the 127 whole numbers −63 to 63, so that those along axes are exact and decoding has no rounding at all.

use glam::{IVec3, Vec3};

/// Bits of the normal of a voxel.
pub const NORMAL_BITS: u32 = 15;
/// No normal of a voxel, but that of the face. A corner of the square, of which the three others mean the same direction.
pub const NO_NORMAL: u32 = 0;
/// Bits along one edge of the square that directions are unfolded onto.
pub const EDGE_BITS: u32 = 7;
/// Largest place of a normal along an edge: half the edge of the square.
pub const REACH: i32 = 63;
/// Set in the code of a normal where both sides of the surface are seen: the normal is then that of either.
pub const TWO_SIDED: u32 = 1 << (2 * EDGE_BITS);

/// A decoded normal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Decoded {
    /// A vector along it, never 0; the sum of its coordinates' absolute values is [`REACH`].
    pub along: IVec3,
    /// Whether the surface has two sides, and the opposite vector is as good.
    pub is_two_sided: bool,
}

/// The normal of a code that is not [`NO_NORMAL`].
#[inline]
pub fn decode(code: u32) -> Decoded {
    let mask = (1 << EDGE_BITS) - 1;
    let (u, v) = ((code & mask) as i32 - REACH, (code >> EDGE_BITS & mask) as i32 - REACH);
    let z = REACH - u.abs() - v.abs();
    let folded = |a: i32, b: i32| if a < 0 { b.abs() - REACH } else { REACH - b.abs() };
    let (x, y) = if z < 0 { (folded(u, v), folded(v, u)) } else { (u, v) };
    Decoded { along: IVec3::new(x, y, z), is_two_sided: code & TWO_SIDED != 0 }
}

/// The code nearest to `normal`, a unit vector.
pub fn encode(normal: Vec3, is_two_sided: bool) -> u32 {
    let scaled = normal * (REACH as f32 / (normal.x.abs() + normal.y.abs() + normal.z.abs()));
    let folded = |a: f32, b: f32| (REACH as f32 - b.abs()).copysign(a);
    let (u, v) = match scaled {
        Vec3 { x, y, z } if z < 0.0 => (folded(x, y), folded(y, x)),
        Vec3 { x, y, .. } => (x, y),
    };
    let candidates = (0..4).map(|corner| {
        let place = |at: f32, up: u32| (at.floor() as i32 + up as i32).clamp(-REACH, REACH);
        let (u, v) = (place(u, corner & 1), place(v, corner >> 1));
        (u + REACH) as u32 | ((v + REACH) as u32) << EDGE_BITS
    });
    let likeness = |code: u32| decode(code).along.as_vec3().normalize().dot(normal);
    let nearest = candidates.max_by(|&a, &b| likeness(a).total_cmp(&likeness(b))).unwrap_or(NO_NORMAL);
    // The opposite corner says the same as the one that says that there is none.
    let nearest = if nearest == NO_NORMAL { 2 * REACH as u32 } else { nearest };
    nearest | if is_two_sided { TWO_SIDED } else { 0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Directions spread evenly over the sphere: Fibonacci's spiral.
    fn directions(count: u32) -> impl Iterator<Item = Vec3> {
        (0..count).map(move |i| {
            let z = 1.0 - (2 * i + 1) as f32 / count as f32;
            let angle = i as f32 * 2.399_963_2;
            let radius = (1.0 - z * z).max(0.0).sqrt();
            Vec3::new(radius * angle.cos(), radius * angle.sin(), z)
        })
    }

    #[test]
    fn a_code_is_within_one_and_a_half_degrees_and_less_than_one_on_average() {
        let (mut sum, mut largest) = (0.0, 0.0f32);
        let count = 200_000;
        for normal in directions(count) {
            let code = encode(normal, false);
            assert_ne!(code, NO_NORMAL);
            let found = decode(code);
            assert_eq!((found.along.abs().element_sum(), found.is_two_sided), (REACH, false));
            let angle = found.along.as_vec3().normalize().cross(normal).length().asin().to_degrees();
            sum += f64::from(angle);
            largest = largest.max(angle);
        }
        let mean = sum / f64::from(count);

        assert!(mean < 0.7 && mean > 0.5, "mean {mean}°");
        assert!(largest < 1.5 && largest > 1.0, "largest {largest}°");
    }

    #[test]
    fn axes_are_exact_and_every_code_has_a_direction() {
        for axis in [Vec3::X, Vec3::Y, Vec3::Z, Vec3::NEG_X, Vec3::NEG_Y, Vec3::NEG_Z] {
            for is_two_sided in [false, true] {
                let code = encode(axis, is_two_sided);
                assert_ne!(code, NO_NORMAL);
                assert_eq!(decode(code), Decoded { along: axis.as_ivec3() * REACH, is_two_sided });
            }
        }
        for code in 0..1 << 16 {
            assert_ne!(decode(code).along, IVec3::ZERO, "{code}");
        }
    }
}
