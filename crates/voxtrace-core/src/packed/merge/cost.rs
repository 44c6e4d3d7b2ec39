//! What a grid takes in memory, counted without packing it.

use super::grid::{Joined, Owner};
use crate::packed::brick_record::brick_words;
use crate::packed::pack::levels_of;
use crate::packed::{InstanceNode, PackedGrid, PackedInstance};
use rayon::prelude::*;
use voxtrace_scene::brick::BRICK_SIZE;
use voxtrace_scene::grid::VoxelGrid;

/// Bytes that each instance takes beside its voxels: itself, its nodes in the hierarchy, its grid.
pub const INSTANCE: u64 =
    (size_of::<PackedInstance>() + 2 * size_of::<InstanceNode>() + size_of::<PackedGrid>()) as u64;

/// Bytes of the cells, the bricks and their materials.
pub fn cost_of(grid: &VoxelGrid, material_bits: u32) -> u64 {
    let Some(bounds) = grid.bounds() else { return 0 };
    let origin = bounds.min & !(BRICK_SIZE - 1);
    let bricks = grid.sorted_bricks();
    let words: u64 = bricks.par_iter().map(|(_, brick)| brick_words(brick, material_bits)).sum();
    let coordinates: Vec<_> = bricks.iter().map(|&(at, _)| at - (origin >> 3)).collect();
    let levels = levels_of(&coordinates, bounds.max - origin);
    let cells: usize = levels.iter().map(|level| level.occupied.len().next_multiple_of(64)).sum();
    4 * (words + cells as u64)
}

/// Bytes of the table that says whose the voxels are, about.
pub fn of_owners(joined: &Joined) -> u64 {
    let of_brick = |owner: &Owner| match owner {
        Owner::One(_) => 0,
        // Two runs, the parts that meet there, mostly two, and a bit for each voxel.
        Owner::Shared(whose) => 16 + 12 + whose.len() as u64 / 8,
    };
    joined.owners.iter().map(|(_, owner)| of_brick(owner)).sum::<u64>() + 20 * joined.covered.len() as u64
}
