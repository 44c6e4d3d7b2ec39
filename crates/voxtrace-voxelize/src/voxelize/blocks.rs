//! Which tiles are worked on together where not everything fits into memory: blocks of tiles, counted by a sample of what is
//! in them, form bins of about one size.

use super::bins::{Selection, Tiles};
use glam::IVec3;

/// Most blocks.
const MOST: u64 = 1 << 20;
/// Most bins: each has a buffer.
const MOST_BINS: u64 = 2048;

/// Bins of blocks of tiles.
pub(super) struct Blocks {
    /// A block has 2^shift tiles along each edge.
    shift: u32,
    /// Blocks along each axis.
    size: IVec3,
    bin_of: Vec<u32>,
    bins: usize,
}

impl Blocks {
    /// Bins of about `most` items: the sample has the tiles of some of them, each of which stands for `share`.
    pub fn of(tiles: &Tiles, sample: impl Iterator<Item = [i32; 3]>, share: u64, most: u64) -> Self {
        let blocks_of = |shift: u32| (tiles.size() + ((1 << shift) - 1)) >> shift;
        let count = |size: IVec3| size.to_array().iter().map(|&n| n as u64).product::<u64>();
        let shift = (0..31).find(|&shift| count(blocks_of(shift)) <= MOST).unwrap_or(31);
        let size: IVec3 = blocks_of(shift);
        let mut blocks = Self { shift, size, bin_of: vec![0; count(size) as usize], bins: 1 };
        let mut all = 0;
        for tile in sample {
            let block = blocks.block(tiles.place(tile));
            blocks.bin_of[block] += 1;
            all += share;
        }
        let most = most.max(all / MOST_BINS);
        let (mut bin, mut sum) = (0, 0);
        for entry in &mut blocks.bin_of {
            let items = u64::from(*entry) * share;
            if sum > 0 && sum + items > most {
                (bin, sum) = (bin + 1, 0);
            }
            sum += items;
            *entry = bin;
        }
        blocks.bins = bin as usize + 1;
        blocks
    }

    fn block(&self, place: IVec3) -> usize {
        let at: IVec3 = place >> self.shift;
        (at.x + self.size.x * (at.y + self.size.y * at.z)) as usize
    }

    /// Number of bins.
    pub fn bins(&self) -> usize {
        self.bins
    }

    /// The bin of a tile.
    #[inline]
    pub fn bin(&self, tiles: &Tiles, tile: [i32; 3]) -> u32 {
        self.bin_of[self.block(tiles.place(tile))]
    }
}

/// The tiles of one bin.
pub(super) struct Bin<'a> {
    pub blocks: &'a Blocks,
    pub number: u32,
}

impl Selection for Bin<'_> {
    fn may_hold(&self, _: (usize, usize)) -> bool {
        true
    }

    fn holds(&self, tiles: &Tiles, tile: [i32; 3]) -> bool {
        self.blocks.bin(tiles, tile) == self.number
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::Mesh;
    use crate::voxelize::{Placement, Scale};
    use glam::Vec3;

    fn tiles(extent: Vec3, scale: f64) -> Tiles {
        let mesh = Mesh { positions: vec![Vec3::ZERO, extent, Vec3::ZERO], ..Mesh::new("box") };
        Tiles::of(&Placement::of(&mesh, Scale::VoxelSize(scale)).unwrap()).unwrap()
    }

    #[test]
    fn bins_hold_about_as_much_as_they_may_and_every_tile_has_one() {
        let tiles = tiles(Vec3::new(640.0, 320.0, 64.0), 1.0);
        let all = || (0..20).flat_map(|x| (0..10).map(move |y| [x, y, 0]));
        let blocks = Blocks::of(&tiles, all(), 5, 100);
        let mut counts = vec![0; blocks.bins()];
        all().for_each(|tile| counts[blocks.bin(&tiles, tile) as usize] += 5);
        assert_eq!((counts.len(), counts.iter().max()), (10, Some(&100)));
        assert_eq!(Blocks::of(&tiles, std::iter::empty(), 5, 100).bins(), 1);
    }

    #[test]
    fn large_grids_have_few_blocks_and_few_bins() {
        let tiles = tiles(Vec3::splat(48_000.0), 1.0);
        let sample = || (0..1500).map(|at| [at, at, at]);
        let blocks = Blocks::of(&tiles, sample(), 1_000_000, 1);
        assert!(blocks.bin_of.len() as u64 <= MOST && blocks.bins() as u64 <= MOST_BINS + 1);
        assert!(blocks.bins() > 50 && blocks.bin(&tiles, [1499, 1499, 1499]) > blocks.bin(&tiles, [0, 0, 0]));
    }
}
