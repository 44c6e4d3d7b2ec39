//! Instances that stand on the lattice of the world become one grid when a scene is packed, so that it is walked like one
//! (`docs/decisions/0062-merged-instances.md`). What was merged stays known: [`super::parts`].

mod choose;
mod cost;
mod grid;
mod lattice;
mod pack;
mod scatter;

pub(super) use choose::Candidate;
pub(super) use grid::{Joined, Owner};
pub use lattice::Lattice;
pub use scatter::Scatter;

use choose::candidates;
use cost::cost_of;
use voxtrace_scene::scene::{Instance, Scene};

/// Instances of a scene as one grid.
pub(super) struct Merge {
    /// Those that are merged, in the order of the visible instances.
    pub candidates: Vec<Candidate>,
    /// What they become.
    pub joined: Joined,
}

/// Most memory of a merged grid over that of its parts: voxels of models that do not keep to bricks of the world are cut anew.
const MOST_MEMORY: f64 = 1.25;
/// Bytes that it may take beyond that: nobody misses them.
const SLACK: f64 = 65_536.0;

impl Merge {
    /// What of the visible instances may be merged; `None` where that is less than two, or would take more memory.
    pub fn of(scene: &Scene, visible: &[(usize, &Instance)], material_bits: u32) -> Option<Self> {
        let candidates = candidates(scene, visible);
        if candidates.len() < 2 {
            return None;
        }
        let joined = grid::join(scene, visible, &candidates);
        let apart: u64 = candidates
            .iter()
            .map(|part| cost_of(&scene.grids[visible[part.instance].1.grid], material_bits) + cost::INSTANCE)
            .sum();
        let together = cost_of(&joined.grid, material_bits) + cost::of_owners(&joined);
        (together as f64 <= apart as f64 * MOST_MEMORY + SLACK).then_some(Self { candidates, joined })
    }
}
