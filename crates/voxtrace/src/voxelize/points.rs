//! From points to voxels: points sorted by tile, then by voxel within it. A voxel has the mean colour of its points in
//! linear light, summed in whole numbers, so that no order of points or threads shows.

use super::bins::{TILE, Tiles};
use super::census::Census;
use super::key::{Class, key_of, rgb_bits};
use super::palette::Palette;
use super::part::Step;
use super::spool::{Spool, TileRecords};
use super::{
    Placement, Run, Scale, VoxelizeError, VoxelizeOptions, VoxelizeProgress, bands, check_on, material_count,
    pairs_within, tiles_of,
};
use crate::brick::{BRICK_SIZE, block_bit, block_index};
use crate::import::Limits;
use crate::mesh::MeshMaterial;
use crate::points::{ColorBy, Painter, PointCloud};
use glam::{IVec3, Vec3};
use rayon::prelude::*;
use std::ops::Range;

/// How points become voxels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PointOptions {
    /// What gives them their colours.
    pub color_by: ColorBy,
    /// Points that make a voxel; where there are fewer, nothing is.
    pub min_points: u32,
}

impl Default for PointOptions {
    fn default() -> Self {
        Self { color_by: ColorBy::Auto, min_points: 1 }
    }
}

/// A grid over points.
pub(super) struct Grid {
    pub placement: Placement,
    /// The highest voxel that a point may be in.
    last: IVec3,
    pub tiles: Tiles,
}

impl Grid {
    pub fn of(placement: Placement, scale: Scale) -> Result<Self, VoxelizeError> {
        // A resolution fills the grid from corner to corner, and the highest points belong into it.
        let last = placement.size - i32::from(!matches!(scale, Scale::VoxelSize(_)));
        Ok(Self { placement, last, tiles: tiles_of(&placement)? })
    }

    /// The voxel of a point.
    #[inline]
    pub fn voxel(&self, point: Vec3) -> IVec3 {
        self.placement.voxels(point).as_ivec3().clamp(IVec3::ZERO, self.last)
    }

    /// The tile of a voxel, and its place in the tile: brick, block and bit.
    #[inline]
    pub fn cell(&self, voxel: IVec3) -> (u32, u32) {
        let tile = voxel.div_euclid(IVec3::splat(TILE));
        let local = voxel - tile * TILE;
        let (brick, inner) = (local / BRICK_SIZE, local % BRICK_SIZE);
        let brick = (brick.z << 4 | brick.y << 2 | brick.x) as u32;
        let voxel = (block_index(inner) as u32) << 6 | block_bit(inner);
        (self.tiles.number(tile.to_array()), brick << VOXEL_BITS | voxel)
    }
}

/// Bits of a voxel in its brick.
const VOXEL_BITS: u32 = 9;

/// What makes bricks of the points of a tile.
pub(super) struct Mixer<'a> {
    pub tiles: &'a Tiles,
    pub painter: &'a Painter,
    pub min_points: u32,
    pub census: &'a Census,
}

impl Mixer<'_> {
    /// The bricks of one tile, of points as cell (upper half) and value of the colour, sorted by cell.
    pub fn tile(&self, number: u32, points: &[u64]) -> TileRecords {
        let low = self.tiles.tile(number) * TILE;
        let mut records = TileRecords::default();
        let mut keys = Vec::new();
        let brick_of = |point: u64| point >> 32 >> VOXEL_BITS;
        for points in points.chunk_by(|&a, &b| brick_of(a) == brick_of(b)) {
            let mut occupancy = [0u64; 8];
            keys.clear();
            let voxels = points.chunk_by(|a, b| a >> 32 == b >> 32);
            for points in voxels.filter(|points| points.len() >= self.min_points as usize) {
                let mut sums = [0u64; 3];
                for &point in points {
                    let color = self.painter.fixed(point as u32);
                    sums.iter_mut().zip(color).for_each(|(sum, value)| *sum += u64::from(value));
                }
                let voxel = points[0] >> 32;
                occupancy[(voxel >> 6 & 7) as usize] |= 1 << (voxel & 63);
                keys.push(key_of(rgb_bits(Painter::mean(sums, points.len() as u64)), 0, 0));
            }
            if !keys.is_empty() {
                self.census.add(&keys, 1);
                let brick = brick_of(points[0]) as i32;
                let at = low / BRICK_SIZE + IVec3::new(brick & 3, brick >> 2 & 3, brick >> 4);
                records.push(at, &occupancy, &keys);
            }
        }
        records
    }
}

/// The materials of points that are done.
pub(super) fn finish(
    placement: Placement,
    census: &Census,
    options: &VoxelizeOptions,
    spool: &Spool,
) -> Result<Run, VoxelizeError> {
    if spool.brick_count() == 0 {
        return Err(VoxelizeError::TooThin(options.points.min_points));
    }
    let classes = [Class::of(&MeshMaterial::default())];
    let palette = Palette::of(census, &classes, material_count(options), options.dither);
    Ok(Run { placement, palette })
}

/// Works through all points and leaves their bricks in the spool.
pub(super) fn run(
    cloud: &PointCloud,
    options: &VoxelizeOptions,
    limits: &Limits,
    spool: &mut Spool,
    progress: &VoxelizeProgress,
) -> Result<Run, VoxelizeError> {
    cloud.validate().map_err(VoxelizeError::BadPoints)?;
    let count = cloud.positions.len() as u64;
    if count > u64::from(u32::MAX) {
        return Err(VoxelizeError::TooLarge { what: "points", needed: count, limit: u32::MAX.into() });
    }
    let grid = Grid::of(Placement::of_points(cloud, options.scale)?, options.scale)?;
    let painter = Painter::of(cloud, options.points.color_by).map_err(VoxelizeError::Missing)?;
    let (tiles, min_points, census) = (&grid.tiles, options.points.min_points, Census::default());
    let mixer = Mixer { tiles, painter: &painter, min_points, census: &census };
    progress.begin(count);
    let all = 0..grid.tiles.layers();
    let layers = match options.memory_budget {
        None => vec![all],
        Some(budget) => bands(&points_by_layer(cloud, &grid), pairs_within(budget, cloud.size_bytes())),
    };
    let tile_of = |pair: &u64| (pair >> 32) as u32;
    spool.resume(&census, progress)?;
    for (part, layers) in layers.into_iter().enumerate() {
        let pairs = pairs(cloud, &grid, &layers);
        let parts: Vec<&[u64]> = pairs.chunk_by(|a, b| tile_of(a) == tile_of(b)).collect();
        for (number, batch) in parts.chunks(BATCH).enumerate() {
            let step = Step { part: part as u32, batch: number as u32 };
            let work = |pairs: &&[u64]| {
                let point = |&pair: &u64| {
                    let index = pair as u32 as usize;
                    let (_, cell) = grid.cell(grid.voxel(cloud.positions[index]));
                    u64::from(cell) << 32 | u64::from(painter.by().value(cloud, index))
                };
                let mut points: Vec<u64> = pairs.iter().map(point).collect();
                points.sort_unstable();
                mixer.tile(tile_of(&pairs[0]), &points)
            };
            if !spool.has(step) {
                spool.push(step, batch.par_iter().with_max_len(4).map(work).collect())?;
            }
            check_on(spool, limits, progress)?;
            progress.add(batch.iter().map(|pairs| pairs.len() as u64).sum());
        }
    }
    finish(grid.placement, &census, options, spool)
}

/// Tiles that are done before their bricks go to the spool.
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

/// Pairs of tile (upper half) and point of some layers of tiles, sorted.
fn pairs(cloud: &PointCloud, grid: &Grid, layers: &Range<usize>) -> Vec<u64> {
    let points = cloud.positions.par_iter().enumerate();
    let pair = |(index, &point): (usize, &Vec3)| {
        let tile = grid.voxel(point).div_euclid(IVec3::splat(TILE));
        (tile.z, u64::from(grid.tiles.number(tile.to_array())) << 32 | index as u64)
    };
    let mut pairs: Vec<u64> = if *layers == (0..grid.tiles.layers()) {
        points.map(|point| pair(point).1).collect()
    } else {
        let within = |(z, pair)| layers.contains(&grid.tiles.layer(z)).then_some(pair);
        points.filter_map(|point| within(pair(point))).collect()
    };
    pairs.par_sort_unstable();
    pairs
}
