//! What the bricks of a packed grid hold together, to be held against what the grid says of itself: devices and pictures go
//! by the latter.

use super::PackedGrid;
use glam::IVec3;
use voxtrace_scene::Invalid;
use voxtrace_scene::brick::{BRICK_SIZE, bits, voxel_of};

/// Voxels of bricks, and the smallest box around them in the space of their grid.
pub(super) struct Extent {
    voxels: u64,
    /// Lowest voxel in each axis.
    min: IVec3,
    /// One past the highest.
    max: IVec3,
}

impl Extent {
    pub fn empty() -> Self {
        Self { voxels: 0, min: IVec3::MAX, max: IVec3::MIN }
    }

    /// Adds a brick whose lowest voxel is `corner`: which of its blocks hold a voxel, and two words of each that does. Returns
    /// how many voxels it has.
    ///
    /// # Errors
    /// One sentence where the brick, or a block that is said to hold a voxel, has none.
    pub fn add(&mut self, corner: IVec3, blocks: u32, masks: &[u32]) -> Result<u64, Invalid> {
        let mask_of = |words: &[u32]| u64::from(words[0]) | u64::from(words[1]) << 32;
        let voxels = masks.iter().map(|word| u64::from(word.count_ones())).sum::<u64>();
        if blocks & 0xff == 0 || masks.chunks_exact(2).any(|words| mask_of(words) == 0) {
            return Err("a brick has no voxels where it says that it has some".into());
        }
        self.voxels += voxels;
        // Nearly all bricks lie inside of those before them.
        if corner.cmplt(self.min).any() || (corner + BRICK_SIZE).cmpgt(self.max).any() {
            let present = (0..8).filter(|block| blocks >> block & 1 != 0);
            for (block, words) in present.zip(masks.chunks_exact(2)) {
                for bit in bits(mask_of(words)) {
                    let voxel = corner + voxel_of(block, bit);
                    (self.min, self.max) = (self.min.min(voxel), self.max.max(voxel + 1));
                }
            }
        }
        Ok(voxels)
    }

    /// Checks that a grid says of itself what its bricks hold. One that `is_edited` may say that they reach further.
    ///
    /// # Errors
    /// One sentence that says both.
    pub fn check(&self, grid: &PackedGrid, is_edited: bool) -> Result<(), Invalid> {
        let said = grid.voxel_count();
        if self.voxels != said {
            return Err(format!("it says that it has {said} voxels, and has {}", self.voxels).into());
        }
        let is_within = grid.min.cmple(self.min).all() && grid.max.cmpge(self.max).all();
        if !(is_edited && is_within || (self.min, self.max) == (grid.min, grid.max)) {
            let (from, to) = (grid.min, grid.max);
            let (min, max) = (self.min, self.max);
            return Err(format!("it says that its voxels span {from} to {to}, and they span {min} to {max}").into());
        }
        Ok(())
    }
}

/// Where in an array of `size` cells, x fastest, a cell is.
pub(super) fn position(size: IVec3, index: usize) -> IVec3 {
    let index = index as i32;
    IVec3::new(index % size.x, index / size.x % size.y, index / size.x / size.y)
}
