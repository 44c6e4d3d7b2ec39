//! Sorts the points of a cloud by tile. Runs of points are counting-sorted in parallel by group of neighbouring tiles; a group is
//! then gathered from all runs and, where it has several tiles, sorted by tile.

use super::points::Grid;
use crate::points::{ColorBy, PointCloud};
use rayon::prelude::*;
use std::ops::Range;

/// Points in a run: input and output fit into the second-level cache.
const RUN: usize = 1 << 16;
/// Groups of neighbouring tiles aimed at; there are more where a tile's place in its group would take too many bits.
const GROUPS: u32 = 1 << 12;
/// Bits of a sorted point below the tile's place in its group: voxel in the tile, and value of the colour.
const TILE_SHIFT: u32 = 47;

/// The points of a cloud, sorted into groups of tiles.
pub(super) struct PointsByTile {
    /// Number of the first tile.
    first: u32,
    /// Base-2 logarithm of the number of tiles in a group.
    shift: u32,
    runs: Vec<SortedRun>,
    /// Groups that have points, and their numbers of points.
    groups: Vec<(u32, u64)>,
}

/// A run of points sorted by group, and where each group begins.
struct SortedRun {
    points: Vec<u64>,
    starts: Vec<u32>,
}

impl PointsByTile {
    /// Sorts the points in some layers of tiles. `by` is one that [`ColorBy::resolved`] returned.
    pub fn of(cloud: &PointCloud, grid: &Grid, layers: &Range<usize>, by: ColorBy) -> Self {
        let Range { start: first, end } = grid.tiles.numbers(layers);
        let bits = u32::BITS - (end - first).leading_zeros();
        let shift = bits.saturating_sub(GROUPS.ilog2()).min(u64::BITS - TILE_SHIFT);
        let count = ((end - first) >> shift) as usize + 1;
        let is_all = *layers == (0..grid.tiles.layers());
        let run = |number: usize| {
            let points = number * RUN..((number + 1) * RUN).min(cloud.positions.len());
            let (mut packed, mut group_of) = (Vec::with_capacity(points.len()), Vec::with_capacity(points.len()));
            let mut starts = vec![0u32; count + 1];
            for index in points {
                let (tile, cell) = grid.cell(grid.voxel(cloud.positions[index]));
                if !is_all && !(first..end).contains(&tile) {
                    continue;
                }
                let (group, inner) = ((tile - first) >> shift, (tile - first) & ((1 << shift) - 1));
                starts[group as usize] += 1;
                group_of.push(group);
                packed.push(u64::from(inner) << TILE_SHIFT | u64::from(cell) << 32 | u64::from(by.value(cloud, index)));
            }
            let mut sum = 0;
            starts.iter_mut().for_each(|start| (*start, sum) = (sum, sum + *start));
            let mut sorted = vec![0; packed.len()];
            for (point, group) in packed.into_iter().zip(group_of) {
                let at = &mut starts[group as usize];
                sorted[*at as usize] = point;
                *at += 1;
            }
            // Each start has moved on to where the next one was.
            starts.rotate_right(1);
            starts[0] = 0;
            SortedRun { points: sorted, starts }
        };
        let runs: Vec<SortedRun> = (0..cloud.positions.len().div_ceil(RUN)).into_par_iter().map(run).collect();
        let size = |group: usize| runs.iter().map(|run| u64::from(run.starts[group + 1] - run.starts[group])).sum();
        let groups = (0..count).into_par_iter().map(|group| (group as u32, size(group))).filter(|&(_, size)| size > 0);
        let groups = groups.collect();
        Self { first, shift, runs, groups }
    }

    /// The groups that have points, ascending, and their numbers of points.
    pub fn groups(&self) -> &[(u32, u64)] {
        &self.groups
    }

    /// Calls `each` with the number of every tile of a group that has points, ascending, and its points: the voxel in the tile
    /// (upper 32 bits) and the value of the colour.
    pub fn for_each_tile(&self, group: u32, mut each: impl FnMut(u32, &[u64])) {
        let mut points = Vec::new();
        for run in &self.runs {
            let (start, end) = (run.starts[group as usize], run.starts[group as usize + 1]);
            points.extend_from_slice(&run.points[start as usize..end as usize]);
        }
        if self.shift > 0 {
            points.sort_unstable();
        }
        for points in points.chunk_by_mut(|a, b| a >> TILE_SHIFT == b >> TILE_SHIFT) {
            let tile = self.first + (group << self.shift) + (points[0] >> TILE_SHIFT) as u32;
            points.iter_mut().for_each(|point| *point &= (1 << TILE_SHIFT) - 1);
            each(tile, points);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::voxelize::{Placement, Scale};
    use glam::Vec3;
    use std::collections::BTreeMap;

    #[test]
    fn every_point_is_in_its_tile_whether_tiles_are_few_or_many_and_bands_leave_out_the_others() {
        // More than a run, in two layers of tiles and more.
        let place = |at: u32| {
            Vec3::new(
                (at.wrapping_mul(7919) % 10_007) as f32,
                (at.wrapping_mul(104_729) % 9973) as f32,
                (at % 613) as f32,
            )
        };
        let positions: Vec<Vec3> = (0..RUN as u32 + 5000).map(place).collect();
        let colors = (0..positions.len()).map(|at| [(at >> 16) as u8, (at >> 8) as u8, at as u8]).collect();
        let cloud = PointCloud { positions, colors, ..PointCloud::default() };
        for resolution in [100, 8000] {
            let scale = Scale::Resolution(resolution);
            let grid = Grid::of(Placement::of_points(&cloud, scale).unwrap(), scale).unwrap();
            let half = grid.tiles.layers() / 2;
            for layers in [0..grid.tiles.layers(), 0..half, half..grid.tiles.layers()] {
                let mut expected = BTreeMap::<u32, Vec<u64>>::new();
                for (at, &point) in cloud.positions.iter().enumerate() {
                    let (tile, cell) = grid.cell(grid.voxel(point));
                    if grid.tiles.numbers(&layers).contains(&tile) {
                        expected.entry(tile).or_default().push(u64::from(cell) << 32 | at as u64);
                    }
                }
                expected.values_mut().for_each(|points| points.sort_unstable());
                let sorted = PointsByTile::of(&cloud, &grid, &layers, ColorBy::Rgb);
                assert_eq!(sorted.shift > 0, resolution == 8000);
                let (mut found, mut order) = (BTreeMap::new(), Vec::new());
                for &(group, size) in sorted.groups() {
                    let mut sum = 0;
                    sorted.for_each_tile(group, |tile, points| {
                        sum += points.len() as u64;
                        order.push(tile);
                        let mut points = points.to_vec();
                        points.sort_unstable();
                        assert!(found.insert(tile, points).is_none());
                    });
                    assert_eq!(sum, size);
                }
                assert!(order.is_sorted() && found == expected, "{resolution} {layers:?}");
            }
        }
    }
}
