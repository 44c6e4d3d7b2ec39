//! Voxelizes a cloud of points: points are sorted by tile, then by brick, and accumulated in their voxels. A voxel has the mean
//! colour of its points in linear light, summed in fixed point, so that the order of points and threads does not matter.

use super::appearance::{AppearanceKey, BsdfClass, appearance_key, rgb_bits};
use super::binning::{TILE, TileGrid};
use super::checkpoint::Step;
use super::color_histogram::ColorHistogram;
use super::large_points::Seams;
use super::palette::Palette;
use super::point_sort::PointsByTile;
use super::spill::{SpillBuffer, TileRecords};
use super::voxelized::Voxelized;
use super::{
    Placement, Scale, VoxelizeError, VoxelizeOptions, VoxelizeProgress, bands, check_limits, material_count,
    pairs_within, tile_grid,
};
use crate::limits::Limits;
use crate::mesh::MeshMaterial;
use crate::points::{ColorBy, ColorMap, PointCloud};
use glam::{IVec3, Vec3};
use rayon::prelude::*;
use voxtrace_scene::brick::{BRICK_SIZE, bits, block_bit, block_index};

/// Options for voxelizing points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PointOptions {
    /// The attribute that colours them.
    pub color_by: ColorBy,
    /// Least number of points in an occupied voxel.
    pub min_points: u32,
}

impl Default for PointOptions {
    fn default() -> Self {
        Self { color_by: ColorBy::Auto, min_points: 1 }
    }
}

/// The voxel grid over a cloud, with its tiles.
pub(super) struct Grid {
    pub placement: Placement,
    /// The highest voxel that a point may be in.
    last: IVec3,
    pub tiles: TileGrid,
}

impl Grid {
    pub fn of(placement: Placement, scale: Scale) -> Result<Self, VoxelizeError> {
        // A resolution fills the grid from corner to corner, and the highest points belong into it.
        let last = placement.size - i32::from(!matches!(scale, Scale::VoxelSize(_)));
        Ok(Self { placement, last, tiles: tile_grid(&placement)? })
    }

    /// The voxel of a point.
    #[inline]
    pub fn voxel(&self, point: Vec3) -> IVec3 {
        self.placement.voxels(point).as_ivec3().clamp(IVec3::ZERO, self.last)
    }

    /// The number of a voxel's tile, and its index in the tile: brick (6 bits), block (3) and bit (6).
    #[inline]
    pub fn cell(&self, voxel: IVec3) -> (u32, u32) {
        // Voxels are not negative.
        let (tile, local) = (voxel >> TILE.ilog2(), voxel & (TILE - 1));
        let (brick, inner) = (local >> BRICK_SIZE.ilog2(), local & (BRICK_SIZE - 1));
        let brick = (brick.z << 4 | brick.y << 2 | brick.x) as u32;
        let voxel = (block_index(inner) as u32) << 6 | block_bit(inner);
        (self.tiles.number(tile.to_array()), brick << VOXEL_BITS | voxel)
    }
}

/// Bits of a voxel's index in its brick.
pub(super) const VOXEL_BITS: u32 = 9;
const VOXEL_MASK: usize = (1 << VOXEL_BITS) - 1;
/// Bricks in a tile.
const BRICKS: usize = 64;

/// Accumulates the points of a tile in their voxels and makes bricks of them.
pub(super) struct PointAccumulator<'a> {
    pub tiles: &'a TileGrid,
    pub color_map: &'a ColorMap,
    pub min_points: u32,
    pub histogram: &'a ColorHistogram,
    /// Where there are points that somebody else voxelizes: bricks that those reach into are left as sums.
    pub seams: Option<&'a Seams>,
}

/// Sums of a voxel's points: red, green and blue in fixed point, and their number.
pub(super) type VoxelSums = [u64; 4];

/// Buffers that a thread reuses from tile to tile.
#[derive(Default)]
pub(super) struct Scratch {
    by_brick: Vec<u64>,
    /// For each voxel of a brick. All 0 between two bricks.
    sums: Vec<VoxelSums>,
    keys: Vec<AppearanceKey>,
}

impl PointAccumulator<'_> {
    /// The bricks of one tile. A point is its voxel's index in the tile (upper 32 bits) and its [`ColorBy::value`]; any order.
    pub fn tile(&self, number: u32, points: &[u64], scratch: &mut Scratch) -> TileRecords {
        let low = self.tiles.tile(number) * TILE;
        let (mut records, mut tally) = (TileRecords::default(), self.histogram.tally());
        let Scratch { by_brick, sums, keys } = scratch;
        sums.resize(1 << VOXEL_BITS, [0; 4]);
        let starts = sorted_by_brick(points, by_brick);
        for brick in (0..BRICKS).filter(|&brick| starts[brick] < starts[brick + 1]) {
            let mut occupancy = [0u64; 8];
            for &point in &by_brick[starts[brick]..starts[brick + 1]] {
                let voxel = (point >> 32) as usize & VOXEL_MASK;
                let ([r, g, b], sum) = (self.color_map.fixed(point as u32), &mut sums[voxel]);
                *sum = [sum[0] + u64::from(r), sum[1] + u64::from(g), sum[2] + u64::from(b), sum[3] + 1];
                occupancy[voxel >> 6] |= 1 << (voxel & 63);
            }
            let inner = brick as i32;
            let at = low / BRICK_SIZE + IVec3::new(inner & 3, inner >> 2 & 3, inner >> 4);
            if self.seams.is_some_and(|seams| seams.reach(at)) {
                records.push_sums(at, &occupancy, sums);
                sums.fill([0; 4]);
                continue;
            }
            finish_brick(&mut occupancy, sums, self.min_points, keys);
            if !keys.is_empty() {
                tally.add(keys, 1);
                records.push(at, &occupancy, keys);
            }
        }
        records
    }
}

/// The appearances of a brick's voxels in rank order, by the sums of all their points; voxels that have too few are left out. Leaves
/// no sums behind.
pub(super) fn finish_brick(
    occupancy: &mut [u64; 8],
    sums: &mut [VoxelSums],
    min_points: u32,
    keys: &mut Vec<AppearanceKey>,
) {
    keys.clear();
    for (block, mask) in occupancy.iter_mut().enumerate() {
        for bit in bits(*mask) {
            let [r, g, b, count] = std::mem::take(&mut sums[block << 6 | bit as usize]);
            if count < min_points.into() {
                *mask &= !(1 << bit);
            } else {
                keys.push(appearance_key(rgb_bits(ColorMap::mean([r, g, b], count)), 0, 0));
            }
        }
    }
}

/// Counting sort of a tile's points by brick; returns where each brick begins, and the end.
fn sorted_by_brick(points: &[u64], sorted: &mut Vec<u64>) -> [usize; BRICKS + 1] {
    let brick_of = |point: u64| (point >> 32 >> VOXEL_BITS) as usize % BRICKS;
    let mut starts = [0; BRICKS + 1];
    points.iter().for_each(|&point| starts[brick_of(point) + 1] += 1);
    (0..BRICKS).for_each(|brick| starts[brick + 1] += starts[brick]);
    sorted.resize(points.len(), 0);
    let mut next = starts;
    for &point in points {
        let at = &mut next[brick_of(point)];
        sorted[*at] = point;
        *at += 1;
    }
    starts
}

/// Chooses the materials when all points are done.
pub(super) fn finish(
    placement: Placement,
    histogram: &ColorHistogram,
    options: &VoxelizeOptions,
    spill: &SpillBuffer,
) -> Result<Voxelized, VoxelizeError> {
    if spill.brick_count() == 0 {
        return Err(VoxelizeError::TooThin(options.points.min_points));
    }
    let classes = [BsdfClass::of(&MeshMaterial::default())];
    let palette = Palette::of(histogram, &classes, material_count(options), options.dither);
    Ok(Voxelized { placement, palette })
}

/// Voxelizes all points into the spill buffer.
pub(super) fn run(
    cloud: &PointCloud,
    options: &VoxelizeOptions,
    limits: &Limits,
    spill: &mut SpillBuffer,
    progress: &VoxelizeProgress,
) -> Result<Voxelized, VoxelizeError> {
    cloud.validate().map_err(VoxelizeError::BadPoints)?;
    let grid = Grid::of(Placement::of_points(cloud, options.scale)?, options.scale)?;
    let color_map = ColorMap::of(cloud, options.points.color_by).map_err(VoxelizeError::Missing)?;
    let (tiles, min_points, histogram) = (&grid.tiles, options.points.min_points, ColorHistogram::default());
    let accumulator = PointAccumulator { tiles, color_map: &color_map, min_points, histogram: &histogram, seams: None };
    progress.begin(cloud.positions.len() as u64);
    let all = 0..grid.tiles.layers();
    let layers = match options.memory_budget {
        None => vec![all],
        Some(budget) => bands(&points_by_layer(cloud, &grid), pairs_within(budget, cloud.size_bytes())),
    };
    spill.resume(&histogram, progress)?;
    for (part, layers) in layers.into_iter().enumerate() {
        let by_tile = PointsByTile::of(cloud, &grid, &layers, color_map.by());
        for (number, batch) in by_tile.groups().chunks(BATCH).enumerate() {
            let step = Step { part: part as u32, batch: number as u32 };
            let work = |scratch: &mut Scratch, &(group, _): &(u32, u64)| {
                let mut bricks = Vec::new();
                by_tile.for_each_tile(group, |tile, points| bricks.push(accumulator.tile(tile, points, scratch)));
                bricks
            };
            if !spill.has(step) {
                let bricks = batch.par_iter().with_max_len(4).map_init(Scratch::default, work);
                spill.push(step, bricks.flatten_iter().collect())?;
            }
            check_limits(spill, limits, progress)?;
            progress.add(batch.iter().map(|&(_, points)| points).sum());
        }
    }
    finish(grid.placement, &histogram, options, spill)
}

/// Tiles, or groups of them, processed before their bricks go to the spill buffer.
pub(super) const BATCH: usize = 256;

fn points_by_layer(cloud: &PointCloud, grid: &Grid) -> Vec<u64> {
    /// Points counted by one task.
    const TASK: usize = 1 << 16;
    let none = || vec![0; grid.tiles.layers()];
    let count = |points: &[Vec3]| {
        let mut counts = none();
        for &point in points {
            counts[grid.tiles.layer(grid.voxel(point).z.div_euclid(TILE))] += 1;
        }
        counts
    };
    let add = |mut a: Vec<u64>, b: Vec<u64>| {
        a.iter_mut().zip(b).for_each(|(a, b)| *a += b);
        a
    };
    cloud.positions.par_chunks(TASK).map(count).reduce(none, add)
}
