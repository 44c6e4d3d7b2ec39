//! Which face a cell of the light cache is.

use super::LIFE;
use glam::IVec3;
use voxtrace_core::sampler::pcg4d;
use voxtrace_scene::ray::{FACES, Face, Hit};

/// Largest level of detail: cubes of 64³ voxels.
const MOST_LEVEL: f32 = 6.0;
/// Bits of [`Request::rank`] for the voxel code.
const CODE_BITS: u32 = 20;
/// Makes numbers of frames to [`Request::scramble_of`].
const SCRAMBLE: u32 = 0x9e37_79b9;

/// A face of a cube of voxels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Key {
    /// The instance that the face belongs to.
    pub instance: u32,
    /// Number of the face, and from bit 3 on the level of detail: the cube is 2 to its power voxels wide.
    pub face_and_level: u32,
    /// The cube's lowest corner in cubes, grid space.
    pub cube: IVec3,
}

impl Key {
    /// The face.
    pub fn face(&self) -> Face {
        FACES[(self.face_and_level & 7) as usize]
    }

    /// The level of detail.
    fn level(&self) -> u32 {
        self.face_and_level >> 3
    }

    /// How wide the cube is, voxels.
    pub fn width(&self) -> f32 {
        (1 << self.level()) as f32
    }

    /// A number that looks random.
    pub fn hash(&self) -> u32 {
        let [x, y, z] = self.cube.to_array().map(|part| part as u32);
        pcg4d([x, y, z, self.instance.wrapping_mul(61).wrapping_add(self.face_and_level)])[0]
    }

    /// The voxel that a code stands for in this cell; see [`Request::voxel_code`].
    pub(super) fn voxel(&self, code: u32, scramble: u32) -> IVec3 {
        let level = self.level();
        let place = (code - 1) ^ scramble & self.mask();
        let part = |axis: u32| (place >> (axis * level) & ((1 << level) - 1)) as i32;
        (self.cube << level) + IVec3::new(part(0), part(1), part(2))
    }

    /// The bits of a place within the cube.
    fn mask(&self) -> u32 {
        (1 << (3 * self.level())) - 1
    }
}

/// Somebody asks for a cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Request {
    /// The cell.
    pub key: Key,
    /// Which of its voxels was met: one more than its place in the cube, scrambled by [`Self::scramble_of`] of the frame, so that none comes first more often
    /// than another.
    pub voxel_code: u32,
    /// Frames that the cell shall live.
    pub life: u32,
}

impl Request {
    /// The cell of the face that a ray met, about `size` voxels wide; `u`, uniform in [0, 1), chooses between the two nearest levels. `life` is that of
    /// who asks, `scramble` that of the frame.
    pub fn of(hit: &Hit, size: f32, u: f32, life: u32, scramble: u32) -> Self {
        // The exponent and the fraction beyond it: linear between powers of two, which needs no logarithm.
        let size = size.clamp(1.0, 128.0);
        let power = (size.to_bits() >> 23) as f32 - 127.0;
        let fraction = size / f32::from_bits((size.to_bits() >> 23) << 23) - 1.0;
        let level = (power + if u < fraction { 1.0 } else { 0.0 }).min(MOST_LEVEL) as u32;
        let key = Key {
            instance: hit.instance,
            face_and_level: hit.face() as u32 | level << 3,
            cube: hit.voxel >> level as i32,
        };
        let [x, y, z] = (hit.voxel - (key.cube << level)).to_array().map(|part| part as u32);
        let place = x | y << level | z << (2 * level);
        Self { key, voxel_code: 1 + (place ^ scramble & key.mask()), life: life.min(LIFE) }
    }

    /// What voxel codes of a frame are scrambled by.
    pub fn scramble_of(frame: u32) -> u32 {
        pcg4d([frame, 0, 0, SCRAMBLE])[0]
    }

    /// Of those who ask for a cell in a frame the one of the largest rank counts, whatever order they come in: who lives longest, then by the voxel.
    pub(super) fn rank(&self) -> u32 {
        self.life << CODE_BITS | self.voxel_code
    }

    /// The life in a rank.
    pub(super) fn life_of(rank: u32) -> u32 {
        rank >> CODE_BITS
    }

    /// The voxel code in a rank.
    pub(super) fn code_of(rank: u32) -> u32 {
        rank & ((1 << CODE_BITS) - 1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_stand_for_the_voxels_that_were_met() {
        for (voxel, size) in
            [(IVec3::new(5, -3, 77), 1.0), (IVec3::new(-64, 63, -1), 20.0), (IVec3::new(1000, 2, 3), 500.0)]
        {
            for u in [0.0, 0.99] {
                let hit = Hit { t: 1.0, instance: 3, voxel, face: 4 };
                let request = Request::of(&hit, size, u, u32::MAX, 0x1234_5678);
                assert_eq!(request.key.voxel(request.voxel_code, 0x1234_5678), voxel);
                assert_eq!((request.key.face() as u32, request.life), (4, LIFE));
                assert_ne!(
                    request.key.voxel(request.voxel_code % 2 + 1, 0x1234_5678),
                    voxel + IVec3::X,
                    "a fault is seen"
                );
                let corner = request.key.cube.as_vec3() * request.key.width();
                assert!((voxel.as_vec3() - corner).min_element() >= 0.0);
                assert!((voxel.as_vec3() - corner).max_element() < request.key.width());
            }
        }
    }

    #[test]
    fn levels_have_the_size_that_was_asked_for_in_the_mean() {
        let hit = Hit { t: 1.0, instance: 0, voxel: IVec3::ZERO, face: 0 };
        for size in [1.0, 1.5, 3.0, 12.0, 30.0] {
            let width = |step: u32| Request::of(&hit, size, (step as f32 + 0.5) / 1000.0, 1, 0).key.width();
            let mean = (0..1000).map(width).sum::<f32>() / 1000.0;
            assert!((mean / size - 1.0).abs() < 0.01, "{size}: {mean}");
        }
    }
}
