//! Which walk found what rays meet: told by the code that ran, so that reports need not guess.

use std::ops::AddAssign;

/// Rays by the walk that traced them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct WalkCounts {
    /// In packets of camera rays behind beams.
    pub packets: u64,
    /// Sixteen at a time, in any order.
    pub streams: u64,
    /// Ray after ray.
    pub scalar: u64,
}

impl WalkCounts {
    /// All rays.
    pub fn total(&self) -> u64 {
        self.packets + self.streams + self.scalar
    }
}

impl AddAssign for WalkCounts {
    fn add_assign(&mut self, other: Self) {
        self.packets += other.packets;
        self.streams += other.streams;
        self.scalar += other.scalar;
    }
}
