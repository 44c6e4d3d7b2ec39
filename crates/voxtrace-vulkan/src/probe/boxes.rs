//! Boxes to build structures from, and random numbers that are the same everywhere.

use bytemuck::{Pod, Zeroable};
use glam::{IVec3, Vec3};

/// A box as the driver reads it.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Aabb {
    pub min: [f32; 3],
    pub max: [f32; 3],
}

impl Aabb {
    pub fn new(min: Vec3, max: Vec3) -> Self {
        Self { min: min.into(), max: max.into() }
    }

    /// The box [cell, cell + 1)³.
    pub fn cell(cell: IVec3) -> Self {
        Self::new(cell.as_vec3(), cell.as_vec3() + 1.0)
    }

    /// A box that a build must leave out (Vulkan: inactive primitives).
    pub const INACTIVE: Self = Self { min: [f32::NAN, 0.0, 0.0], max: [0.0; 3] };

    /// Smaller by `by` on each side.
    pub fn inset(self, by: f32) -> Self {
        Self::new(Vec3::from(self.min) + by, Vec3::from(self.max) - by)
    }

    pub fn moved(self, by: Vec3) -> Self {
        Self::new(Vec3::from(self.min) + by, Vec3::from(self.max) + by)
    }

    /// The box around both, where it holds nothing else: they share a whole face.
    pub fn joined(self, other: Self) -> Option<Self> {
        let union = Self::new(Vec3::from(self.min).min(other.min.into()), Vec3::from(self.max).max(other.max.into()));
        let volume = |aabb: Self| (Vec3::from(aabb.max) - Vec3::from(aabb.min)).element_product();
        (volume(union).is_finite() && volume(union) == volume(self) + volume(other)).then_some(union)
    }
}

/// A solid block of `size`³ unit boxes, x quickest.
pub fn block(size: i32) -> Vec<Aabb> {
    (0..size * size * size).map(|i| Aabb::cell(IVec3::new(i % size, i / size % size, i / (size * size)))).collect()
}

/// Random numbers: SplitMix64 (Steele, Lea and Flood 2014).
pub struct Random(pub u64);

impl Random {
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// In [0, 1).
    pub fn unit(&mut self) -> f32 {
        (self.bits() >> 40) as f32 / (1u64 << 24) as f32
    }

    /// In [0, `end`).
    pub fn below(&mut self, end: usize) -> usize {
        (self.bits() % end.max(1) as u64) as usize
    }

    pub fn point(&mut self, min: Vec3, max: Vec3) -> Vec3 {
        min + Vec3::new(self.unit(), self.unit(), self.unit()) * (max - min)
    }

    /// A unit vector.
    pub fn direction(&mut self) -> Vec3 {
        loop {
            let v = self.point(Vec3::NEG_ONE, Vec3::ONE);
            if (0.01..=1.0).contains(&v.length_squared()) {
                return v.normalize();
            }
        }
    }

    /// The numbers 0 to `count` − 1 in random order.
    pub fn shuffled(&mut self, count: usize) -> Vec<usize> {
        let mut order: Vec<usize> = (0..count).collect();
        for last in (1..count).rev() {
            order.swap(last, self.below(last + 1));
        }
        order
    }
}
