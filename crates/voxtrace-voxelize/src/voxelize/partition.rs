//! Partition of the grid for external sorting: where not everything fits into memory, a sample of the triangles or points
//! estimates how many there are in each block of tiles, and consecutive blocks are joined to parts of about equal size (sample
//! sort). One part at a time is then voxelized in memory.

use super::binning::{TileFilter, TileGrid};
use glam::IVec3;
use std::ops::Range;

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
    /// For each share of the work the number of its first part, then the number of parts.
    starts: Vec<u32>,
}

impl TilePartition {
    /// Parts of about `most` items each, in so many shares of about as many items each; a share is a box. `sample` has the tiles of some
    /// items, each of which stands for `stride` of them.
    pub fn of(tiles: &TileGrid, sample: impl Iterator<Item = [i32; 3]>, stride: u64, most: u64, shares: usize) -> Self {
        let blocks_of = |shift: u32| (tiles.size() + ((1 << shift) - 1)) >> shift;
        let count = |size: IVec3| size.to_array().iter().map(|&n| n as u64).product::<u64>();
        let shift = (0..31).find(|&shift| count(blocks_of(shift)) <= MAX_BLOCKS).unwrap_or(31);
        let size: IVec3 = blocks_of(shift);
        let mut partition = Self { shift, size, part_of: vec![0; count(size) as usize], starts: Vec::new() };
        let mut all = 0;
        for tile in sample {
            let block = partition.block(tiles.place(tile));
            partition.part_of[block] += 1;
            all += stride;
        }
        let most = most.max(all / MAX_PARTS);
        let boxes = shares_of(&partition.part_of, size, shares);
        let mut next = 0;
        for (low, high) in boxes {
            partition.starts.push(next);
            let mut sum = 0;
            for at in blocks_in(low, high) {
                let entry = &mut partition.part_of[index(size, at)];
                let items = u64::from(*entry) * stride;
                if sum > 0 && sum + items > most {
                    (next, sum) = (next + 1, 0);
                }
                sum += items;
                *entry = next;
            }
            next += 1;
        }
        partition.starts.push(next);
        partition
    }

    /// The block of a tile, whose coordinates are counted from the margin.
    fn block(&self, place: IVec3) -> usize {
        index(self.size, place >> self.shift)
    }

    /// The parts of a share: none of one that is not there because there are too few blocks.
    pub fn share(&self, number: usize) -> Range<u32> {
        let start = |number: usize| self.starts[number.min(self.starts.len() - 1)];
        start(number)..start(number + 1)
    }

    /// Whether the tiles of a box, both corners included, reach into some parts.
    pub fn reaches(&self, tiles: &TileGrid, (low, high): (IVec3, IVec3), parts: &Range<u32>) -> bool {
        let block = |tile: IVec3| {
            let place: IVec3 = tiles.place(tile.to_array()).clamp(IVec3::ZERO, tiles.size() - 1) >> self.shift;
            place
        };
        blocks_in(block(low), block(high) + 1).any(|at| parts.contains(&self.part_of[index(self.size, at)]))
    }

    /// Number of parts.
    pub fn part_count(&self) -> usize {
        self.starts.last().map_or(0, |&count| count as usize)
    }

    /// The part of a tile.
    #[inline]
    pub fn part(&self, tiles: &TileGrid, tile: [i32; 3]) -> u32 {
        self.part_of[self.block(tiles.place(tile))]
    }
}

/// The place of a block in the list of all.
fn index(size: IVec3, at: IVec3) -> usize {
    (at.x + size.x * (at.y + size.y * at.z)) as usize
}

/// The blocks of a box without its upper corner, x fastest.
fn blocks_in(low: IVec3, high: IVec3) -> impl Iterator<Item = IVec3> {
    (low.z..high.z)
        .flat_map(move |z| (low.y..high.y).flat_map(move |y| (low.x..high.x).map(move |x| IVec3::new(x, y, z))))
}

/// Divides all blocks into at most so many boxes, each of them not empty, with about as many items in each: each cut is across the longest axis
/// of the blocks that have items (a k-d tree, Bentley, "Multidimensional binary search trees used for associative searching", 1975).
fn shares_of(counts: &[u32], size: IVec3, shares: usize) -> Vec<(IVec3, IVec3)> {
    let mut done = Vec::new();
    let mut waiting = vec![(IVec3::ZERO, size, shares.max(1))];
    while let Some((low, high, shares)) = waiting.pop() {
        match cut(counts, size, (low, high), shares).filter(|_| shares > 1) {
            Some((axis, at)) => {
                let (mut below, mut above) = (high, low);
                (below[axis], above[axis]) = (at, at);
                waiting.push((above, high, shares - shares / 2));
                waiting.push((low, below, shares / 2));
            }
            None => done.push((low, high)),
        }
    }
    done
}

/// Where to cut a box for so many shares, of which half are below the cut: the axis, and the first block above. `None` where it is one block.
fn cut(counts: &[u32], size: IVec3, (low, high): (IVec3, IVec3), shares: usize) -> Option<(usize, i32)> {
    let mut along = [0, 1, 2].map(|axis| vec![0u64; (high - low)[axis] as usize]);
    for at in blocks_in(low, high) {
        let count = u64::from(counts[index(size, at)]);
        (0..3).for_each(|axis| along[axis][(at - low)[axis] as usize] += count);
    }
    let extent = |axis: usize| {
        let first = along[axis].iter().position(|&count| count > 0).unwrap_or(0);
        along[axis].iter().rposition(|&count| count > 0).unwrap_or(0) + 1 - first
    };
    // The first of the longest.
    let axis = [0, 1, 2].into_iter().rev().max_by_key(|&axis| (extent(axis), (high - low)[axis]))?;
    let length = (high - low)[axis];
    if length < 2 {
        return None;
    }
    let (all, half) = (along[axis].iter().sum::<u64>(), (shares / 2) as u64);
    let mut sum = 0;
    let cut = along[axis].iter().position(|&count| {
        sum += count;
        u128::from(sum) * shares as u128 >= u128::from(all) * u128::from(half)
    });
    Some((axis, low[axis] + (cut.unwrap_or(0) as i32 + 1).min(length - 1)))
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

    fn tiles_of(extent: Vec3, scale: f64) -> TileGrid {
        let mesh = Mesh { positions: vec![Vec3::ZERO, extent, Vec3::ZERO], ..Mesh::new("box") };
        TileGrid::of(&Placement::of(&mesh, Scale::VoxelSize(scale)).unwrap()).unwrap()
    }

    #[test]
    fn parts_hold_about_as_much_as_they_may_and_every_tile_has_one() {
        let tiles = tiles_of(Vec3::new(640.0, 320.0, 64.0), 1.0);
        let all = || (0..20).flat_map(|x| (0..10).map(move |y| [x, y, 0]));
        let partition = TilePartition::of(&tiles, all(), 5, 100, 1);
        let mut counts = vec![0; partition.part_count()];
        all().for_each(|tile| counts[partition.part(&tiles, tile) as usize] += 5);
        assert_eq!((counts.len(), counts.iter().max()), (10, Some(&100)));
        assert_eq!(TilePartition::of(&tiles, std::iter::empty(), 5, 100, 1).part_count(), 1);
    }

    #[test]
    fn shares_are_boxes_of_about_as_many_items_with_parts_of_their_own() {
        let tiles = tiles_of(Vec3::new(640.0, 640.0, 64.0), 1.0);
        let all = || (0..20).flat_map(|x| (0..20).map(move |y| [x, y, x % 2]));
        for shares in [2, 3, 7, 16] {
            let partition = TilePartition::of(&tiles, all(), 1, 20, shares);
            let ranges: Vec<_> = (0..shares).map(|share| partition.share(share)).collect();
            assert!(ranges.windows(2).all(|pair| pair[0].end == pair[1].start) && ranges[0].start == 0);
            assert_eq!(ranges[shares - 1].end as usize, partition.part_count());
            for range in &ranges {
                let own: Vec<IVec3> =
                    all().filter(|&tile| range.contains(&partition.part(&tiles, tile))).map(IVec3::from).collect();
                assert!((own.len() * shares).abs_diff(400) <= 20 * shares, "{} of 400 in {shares}", own.len());
                let (low, high) = own.iter().fold((own[0], own[0]), |(a, b), &tile| (a.min(tile), b.max(tile)));
                let inside = |tile: &[i32; 3]| {
                    let tile = IVec3::from(*tile);
                    tile.cmpge(low).all() && tile.cmple(high).all()
                };
                let others = all().filter(inside).filter(|&tile| !range.contains(&partition.part(&tiles, tile)));
                assert_eq!(others.count(), 0, "a share is a box");
                assert!(partition.reaches(&tiles, (low, high), range));
                assert!(own.iter().all(|&tile| partition.reaches(&tiles, (tile, tile), range)));
            }
            let first = IVec3::ZERO;
            let reached = ranges.iter().filter(|range| partition.reaches(&tiles, (first, first), range)).count();
            assert_eq!(reached, 1, "a tile is in one share");
        }
        // More shares than blocks.
        let small = tiles_of(Vec3::splat(10.0), 1.0);
        let few = TilePartition::of(&small, std::iter::once([0, 0, 0]), 1, 1, 500);
        let count = few.part_count();
        assert!(count > 1 && count < 500, "{count}");
        assert!((0..500).all(|share| few.share(share).len() == usize::from(share < count)));
    }

    #[test]
    fn large_grids_have_few_blocks_and_few_parts() {
        let tiles = tiles_of(Vec3::splat(48_000.0), 1.0);
        let sample = || (0..1500).map(|at| [at, at, at]);
        let partition = TilePartition::of(&tiles, sample(), 1_000_000, 1, 1);
        assert!(partition.part_of.len() as u64 <= MAX_BLOCKS && partition.part_count() as u64 <= MAX_PARTS + 1);
        assert!(
            partition.part_count() > 50
                && partition.part(&tiles, [1499, 1499, 1499]) > partition.part(&tiles, [0, 0, 0])
        );
    }
}
