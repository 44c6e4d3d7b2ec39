//! Partition of the grid for external sorting: where not everything fits into memory, a sample of the triangles or points
//! estimates how many there are in each block of tiles, and consecutive blocks are joined to parts of about equal size (sample
//! sort). One part at a time is then voxelized in memory.

use super::binning::{TileFilter, TileGrid};
use glam::IVec3;

/// Most blocks of tiles.
const MAX_BLOCKS: u64 = 1 << 20;
/// Most parts; each has a buffer while records are sorted.
const MAX_PARTS: u64 = 2048;

/// The tiles of a grid, divided into parts.
pub(super) struct TilePartition {
    /// A block has 2^shift tiles along each edge.
    shift: u32,
    /// Number of blocks along each axis.
    size: IVec3,
    /// The part of each block.
    part_of: Vec<u32>,
    parts: usize,
}

impl TilePartition {
    /// Parts of about `most` items each. `sample` has the tiles of some items, each of which stands for `share` of them.
    pub fn of(tiles: &TileGrid, sample: impl Iterator<Item = [i32; 3]>, share: u64, most: u64) -> Self {
        let blocks_of = |shift: u32| (tiles.size() + ((1 << shift) - 1)) >> shift;
        let count = |size: IVec3| size.to_array().iter().map(|&n| n as u64).product::<u64>();
        let shift = (0..31).find(|&shift| count(blocks_of(shift)) <= MAX_BLOCKS).unwrap_or(31);
        let size: IVec3 = blocks_of(shift);
        let mut partition = Self { shift, size, part_of: vec![0; count(size) as usize], parts: 1 };
        let mut all = 0;
        for tile in sample {
            let block = partition.block(tiles.place(tile));
            partition.part_of[block] += 1;
            all += share;
        }
        let most = most.max(all / MAX_PARTS);
        let (mut part, mut sum) = (0, 0);
        for entry in &mut partition.part_of {
            let items = u64::from(*entry) * share;
            if sum > 0 && sum + items > most {
                (part, sum) = (part + 1, 0);
            }
            sum += items;
            *entry = part;
        }
        partition.parts = part as usize + 1;
        partition
    }

    /// The block of a tile, whose coordinates are counted from the margin.
    fn block(&self, place: IVec3) -> usize {
        let at: IVec3 = place >> self.shift;
        (at.x + self.size.x * (at.y + self.size.y * at.z)) as usize
    }

    /// Number of parts.
    pub fn part_count(&self) -> usize {
        self.parts
    }

    /// The part of a tile.
    #[inline]
    pub fn part(&self, tiles: &TileGrid, tile: [i32; 3]) -> u32 {
        self.part_of[self.block(tiles.place(tile))]
    }
}

/// The tiles of one part.
pub(super) struct Part<'a> {
    pub partition: &'a TilePartition,
    pub number: u32,
}

impl TileFilter for Part<'_> {
    fn may_hold(&self, _: (usize, usize)) -> bool {
        true
    }

    fn holds(&self, tiles: &TileGrid, tile: [i32; 3]) -> bool {
        self.partition.part(tiles, tile) == self.number
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Mesh;
    use crate::voxelize::{Placement, Scale};
    use glam::Vec3;

    fn tiles(extent: Vec3, scale: f64) -> TileGrid {
        let mesh = Mesh { positions: vec![Vec3::ZERO, extent, Vec3::ZERO], ..Mesh::new("box") };
        TileGrid::of(&Placement::of(&mesh, Scale::VoxelSize(scale)).unwrap()).unwrap()
    }

    #[test]
    fn parts_hold_about_as_much_as_they_may_and_every_tile_has_one() {
        let tiles = tiles(Vec3::new(640.0, 320.0, 64.0), 1.0);
        let all = || (0..20).flat_map(|x| (0..10).map(move |y| [x, y, 0]));
        let partition = TilePartition::of(&tiles, all(), 5, 100);
        let mut counts = vec![0; partition.part_count()];
        all().for_each(|tile| counts[partition.part(&tiles, tile) as usize] += 5);
        assert_eq!((counts.len(), counts.iter().max()), (10, Some(&100)));
        assert_eq!(TilePartition::of(&tiles, std::iter::empty(), 5, 100).part_count(), 1);
    }

    #[test]
    fn large_grids_have_few_blocks_and_few_parts() {
        let tiles = tiles(Vec3::splat(48_000.0), 1.0);
        let sample = || (0..1500).map(|at| [at, at, at]);
        let partition = TilePartition::of(&tiles, sample(), 1_000_000, 1);
        assert!(partition.part_of.len() as u64 <= MAX_BLOCKS && partition.part_count() as u64 <= MAX_PARTS + 1);
        assert!(
            partition.part_count() > 50
                && partition.part(&tiles, [1499, 1499, 1499]) > partition.part(&tiles, [0, 0, 0])
        );
    }
}
