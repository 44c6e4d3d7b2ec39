//! Voxels that come in any order, gathered to bricks.

use glam::IVec3;
use rustc_hash::FxHashMap;
use voxtrace_scene::brick::{Brick, bits, block_bit, block_index};
use voxtrace_scene::grid::{brick_of, local_of};

/// A brick with a place for each of its voxels.
struct Dense {
    occupancy: [u64; 8],
    materials: [u16; 512],
}

/// Bricks that fill.
#[derive(Default)]
pub struct Scatter {
    index_of: FxHashMap<IVec3, usize>,
    bricks: Vec<(IVec3, Box<Dense>)>,
    /// The brick of the last voxel: neighbours are often in one.
    last: usize,
}

impl Scatter {
    /// Takes a voxel; of one that comes twice the last counts.
    pub fn set(&mut self, voxel: IVec3, material: u16) {
        self.put(voxel, material, true);
    }

    /// Takes a voxel where none is yet.
    pub fn set_if_empty(&mut self, voxel: IVec3, material: u16) {
        self.put(voxel, material, false);
    }

    fn put(&mut self, voxel: IVec3, material: u16, replaces: bool) {
        let at = brick_of(voxel);
        if self.bricks.get(self.last).is_none_or(|(last, _)| *last != at) {
            self.last = *self.index_of.entry(at).or_insert_with(|| {
                self.bricks.push((at, Box::new(Dense { occupancy: [0; 8], materials: [0; 512] })));
                self.bricks.len() - 1
            });
        }
        let (local, dense) = (local_of(voxel), &mut self.bricks[self.last].1);
        let (block, bit) = (block_index(local), block_bit(local));
        if !replaces && dense.occupancy[block] >> bit & 1 != 0 {
            return;
        }
        dense.occupancy[block] |= 1 << bit;
        dense.materials[block * 64 + bit as usize] = material;
    }

    /// The bricks, each once.
    pub fn finish(self) -> Vec<(IVec3, Brick)> {
        let brick = |(at, dense): (IVec3, Box<Dense>)| {
            let of_block = |block: usize| bits(dense.occupancy[block]).map(move |bit| block * 64 + bit as usize);
            let materials = (0..8).flat_map(of_block).map(|place| dense.materials[place]).collect();
            (at, Brick::new(dense.occupancy, materials))
        };
        self.bricks.into_iter().map(brick).collect()
    }
}
