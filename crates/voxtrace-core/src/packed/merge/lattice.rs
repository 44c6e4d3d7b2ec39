//! Ways to stand on the lattice of the world: quarter turns, mirrors and whole translations, which take voxels to voxels in integers.

use glam::{IVec3, Mat3, Vec3};
use voxtrace_scene::ray::Face;
use voxtrace_scene::transform::Transform;

/// Farthest that anything on the lattice is moved along an axis, voxels: twice as far as a grid reaches.
pub const MAX_TRANSLATION: i32 = 1 << 21;

/// From the voxels of one grid to those of another: coordinate a of the other is coordinate `source[a]` of the one, negated where
/// `is_negative[a]`, plus `translation[a]`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Lattice {
    source: [usize; 3],
    is_negative: [bool; 3],
    translation: IVec3,
}

impl Lattice {
    /// What a transform does to voxels, `None` where it does not take the lattice to itself.
    pub fn of(transform: &Transform) -> Option<Self> {
        let rows = transform.linear.transpose();
        let (mut source, mut is_negative) = ([0; 3], [false; 3]);
        for a in 0..3 {
            let row = rows.col(a);
            source[a] = (0..3).find(|&axis| row[axis] != 0.0)?;
            is_negative[a] = row[source[a]] < 0.0;
            if row[source[a]].abs() != 1.0 || (0..3).any(|axis| axis != source[a] && row[axis] != 0.0) {
                return None;
            }
        }
        let translation = transform.translation;
        let is_whole = translation == translation.round() && translation.abs().max_element() <= MAX_TRANSLATION as f32;
        let found = Self { source, is_negative, translation: translation.as_ivec3() };
        (is_whole && found.is_permutation()).then_some(found)
    }

    /// From the numbers of a file, `None` where they are none of [`Self::to_record`].
    pub fn of_record(axes: u32, translation: IVec3) -> Option<Self> {
        let part = |a: usize| axes >> (3 * a) & 7;
        let found = Self {
            source: std::array::from_fn(|a| (part(a) & 3) as usize),
            is_negative: std::array::from_fn(|a| part(a) >> 2 != 0),
            translation,
        };
        let far = IVec3::splat(MAX_TRANSLATION);
        let is_near = translation.cmple(far).all() && translation.cmpge(-far).all();
        (axes >> 9 == 0 && is_near && found.is_permutation()).then_some(found)
    }

    /// Three bits for each axis, two for its source and one for its sign, and the translation.
    pub fn to_record(self) -> (u32, IVec3) {
        let bits = |a: usize| (self.source[a] as u32 | u32::from(self.is_negative[a]) << 2) << (3 * a);
        (bits(0) | bits(1) | bits(2), self.translation)
    }

    fn is_permutation(&self) -> bool {
        self.source.iter().fold(0, |seen, &axis| seen | 1 << axis) == 7
    }

    /// The same map of points.
    pub fn transform(&self) -> Transform {
        // Zeros have no sign: what comes of it is the same bits whichever way it was made.
        let row = |a: usize| Vec3::AXES[self.source[a]] * if self.is_negative[a] { -1.0 } else { 1.0 } + Vec3::ZERO;
        let linear = Mat3::from_cols(row(0), row(1), row(2)).transpose();
        Transform { linear, translation: self.translation.as_vec3() }
    }

    /// Where a voxel goes.
    #[inline]
    pub fn voxel(&self, voxel: IVec3) -> IVec3 {
        let along = |a: usize| {
            let coordinate = voxel[self.source[a]];
            self.translation[a] + if self.is_negative[a] { -1 - coordinate } else { coordinate }
        };
        IVec3::new(along(0), along(1), along(2))
    }

    /// The voxel that goes there: the inverse of [`Self::voxel`].
    #[inline]
    pub fn voxel_before(&self, voxel: IVec3) -> IVec3 {
        let moved = voxel - self.translation;
        let mut before = IVec3::ZERO;
        for a in 0..3 {
            before[self.source[a]] = if self.is_negative[a] { -1 - moved[a] } else { moved[a] };
        }
        before
    }

    /// The lowest and one past the highest voxel of a box of voxels given likewise.
    pub fn bounds(&self, min: IVec3, max: IVec3) -> (IVec3, IVec3) {
        let (a, b) = (self.voxel(min), self.voxel(max - 1));
        (a.min(b), a.max(b) + 1)
    }

    /// Number of the face that a face becomes.
    pub fn face(&self, face: Face) -> u32 {
        let along = (0..3).find(|&a| self.source[a] == face.axis()).expect("every axis has its place");
        2 * along as u32 + (face as u32 & 1 ^ u32::from(self.is_negative[along]))
    }

    /// Number of the face that becomes this one: the inverse of [`Self::face`].
    pub fn face_before(&self, face: Face) -> u32 {
        let along = face.axis();
        2 * self.source[along] as u32 + (face as u32 & 1 ^ u32::from(self.is_negative[along]))
    }

    /// How far whole bricks go, in bricks, where they stay whole and as they are.
    pub fn moved_bricks(&self) -> Option<IVec3> {
        let is_moved = self.source == [0, 1, 2] && self.is_negative == [false; 3];
        (is_moved && self.translation & 7 == IVec3::ZERO).then_some(self.translation >> 3)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use voxtrace_scene::ray::FACES;

    /// All 48 ways of a cube, by their matrices.
    fn ways() -> Vec<Transform> {
        let mut ways = Vec::new();
        for code in 0..216 {
            let (x, y, z) = (code % 6, code / 6 % 6, code / 36);
            let axis = |n: usize| Vec3::AXES[n / 2] * if n % 2 == 1 { -1.0 } else { 1.0 };
            let linear = Mat3::from_cols(axis(x), axis(y), axis(z));
            if linear.determinant().abs() == 1.0 {
                ways.push(Transform { linear, translation: Vec3::new(7.0, -12.0, code as f32) });
            }
        }
        ways
    }

    #[test]
    fn voxels_and_faces_go_where_their_points_go_and_come_back() {
        assert_eq!(ways().len(), 48);
        for way in ways() {
            let lattice = Lattice::of(&way).unwrap();
            assert_eq!(lattice.transform(), way);
            let (axes, translation) = lattice.to_record();
            assert_eq!(Lattice::of_record(axes, translation), Some(lattice));
            for voxel in [IVec3::ZERO, IVec3::new(5, -9, 100), IVec3::splat(-1)] {
                let moved = lattice.voxel(voxel);
                assert_eq!(way.point(voxel.as_vec3() + 0.5), moved.as_vec3() + 0.5);
                assert_eq!(lattice.voxel_before(moved), voxel);
            }
            for face in FACES {
                let moved = FACES[lattice.face(face) as usize];
                assert_eq!(moved.normal().as_vec3(), way.direction(face.normal().as_vec3()));
                assert_eq!(lattice.face_before(moved), face as u32);
            }
            let (min, max) = lattice.bounds(IVec3::new(-3, 0, 2), IVec3::new(4, 1, 9));
            let corners = [way.point(Vec3::new(-3.0, 0.0, 2.0)), way.point(Vec3::new(4.0, 1.0, 9.0))];
            assert_eq!(min.as_vec3(), corners[0].min(corners[1]));
            assert_eq!(max.as_vec3(), corners[0].max(corners[1]));
        }
    }

    #[test]
    fn what_is_off_the_lattice_is_none_of_its_ways() {
        let moved = |x: f32| Transform::from_translation(Vec3::new(x, 0.0, 0.0));
        assert!(Lattice::of(&moved(3.0)).is_some());
        assert_eq!(Lattice::of(&moved(0.5)), None);
        assert_eq!(Lattice::of(&moved(1e8)), None);
        assert_eq!(Lattice::of(&Transform::IDENTITY.scaled(2.0)), None);
        let turned = Transform { linear: Mat3::from_rotation_z(0.1), translation: Vec3::ZERO };
        assert_eq!(Lattice::of(&turned), None);
        assert_eq!(Lattice::of_record(0, IVec3::ZERO), None);
        let (axes, _) = Lattice::of(&moved(0.0)).unwrap().to_record();
        assert_eq!(Lattice::of_record(axes | 1 << 9, IVec3::ZERO), None);
        assert_eq!(Lattice::of_record(axes, IVec3::splat(i32::MIN)), None);
    }
}
