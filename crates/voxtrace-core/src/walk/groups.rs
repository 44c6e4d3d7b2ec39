//! Which groups of sixteen rays of a batch are done.

use super::simd::LANES;

/// A set of groups of sixteen rays that follow each other.
pub struct Groups(Vec<u64>);

impl Groups {
    /// The empty set of the groups of so many rays.
    pub fn none_of(rays: usize) -> Self {
        Self(vec![0; rays.div_ceil(LANES * 64)])
    }

    /// Adds a group: packets do, which need AVX-512.
    #[cfg(target_arch = "x86_64")]
    pub fn insert(&mut self, group: usize) {
        self.0[group / 64] |= 1 << (group % 64);
    }

    /// How many of so many rays are in its groups; the last group may be short.
    pub fn count_of(&self, rays: usize) -> usize {
        let groups: usize = self.0.iter().map(|bits| bits.count_ones() as usize).sum();
        let is_last_short = !rays.is_multiple_of(LANES) && self.contains(rays / LANES);
        groups * LANES - if is_last_short { LANES - rays % LANES } else { 0 }
    }

    /// Whether it has a group.
    #[inline(always)]
    pub fn contains(&self, group: usize) -> bool {
        self.0[group / 64] >> (group % 64) & 1 == 1
    }
}
