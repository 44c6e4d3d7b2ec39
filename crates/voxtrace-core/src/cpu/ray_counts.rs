//! How many rays the CPU tracer traced, as shaders count theirs (`shaders/tally.slang`).

use crate::walk::WalkCounts;
use std::ops::Add;

/// Rays of one call of [`crate::Tracer::render`], counted as devices count them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct RayCounts {
    /// From the camera: one for each sample.
    pub camera: u64,
    /// That left a surface, a boundary or a place in a medium.
    pub bounce: u64,
    /// Towards lights: each stretch between boundaries of media that light passes.
    pub light: u64,
    /// The walks that found what they meet. Rays within media are in none, as they go from voxel to voxel, but those in a medium around all else.
    pub walks: WalkCounts,
}

impl RayCounts {
    /// Rays of all kinds.
    pub fn total(&self) -> u64 {
        self.camera + self.bounce + self.light
    }
}

impl Add for RayCounts {
    type Output = Self;

    fn add(mut self, other: Self) -> Self {
        self.walks += other.walks;
        Self {
            camera: self.camera + other.camera,
            bounce: self.bounce + other.bounce,
            light: self.light + other.light,
            ..self
        }
    }
}
