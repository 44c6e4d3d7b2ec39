//! A small deterministic generator of random numbers for tests: SplitMix64 (Steele, Lea and Flood 2014).

use voxtrace::glam::{IVec3, Vec3};

/// A sequence of random numbers that depends on its seed alone.
#[derive(Clone, Debug)]
pub struct Random(pub u64);

impl Random {
    /// 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ z >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ z >> 31
    }

    /// Uniform in [0, 1).
    pub fn unit(&mut self) -> f32 {
        (self.bits() >> 40) as f32 / 16_777_216.0
    }

    /// Uniform in `0..end`.
    pub fn below(&mut self, end: usize) -> usize {
        (self.bits() % end as u64) as usize
    }

    /// Uniform in [low, high) on each axis.
    pub fn point(&mut self, low: Vec3, high: Vec3) -> Vec3 {
        low + (high - low) * Vec3::new(self.unit(), self.unit(), self.unit())
    }

    /// Uniform voxel in `low..high`.
    pub fn voxel(&mut self, low: IVec3, high: IVec3) -> IVec3 {
        let size = (high - low).max(IVec3::ONE);
        low + IVec3::from_array(std::array::from_fn(|axis| self.below(size[axis] as usize) as i32))
    }

    /// Uniform on the unit sphere.
    pub fn direction(&mut self) -> Vec3 {
        loop {
            let point = self.point(Vec3::NEG_ONE, Vec3::ONE);
            if (0.01..1.0).contains(&point.length_squared()) {
                return point.normalize();
            }
        }
    }
}
