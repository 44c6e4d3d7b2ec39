//! From points to voxels: points sorted by tile, then by voxel within it. A voxel has the mean colour of its points in
//! linear light, summed in whole numbers, so that no order of points or threads shows.

use super::bins::{TILE, Tiles};
use super::census::Census;
use super::key::{Class, key_of, rgb_bits};
use super::palette::Palette;
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

/// A cloud and the grid over it.
struct Job<'a> {
    cloud: &'a PointCloud,
    placement: Placement,
    /// The highest voxel that a point may be in.
    last: IVec3,
    tiles: Tiles,
    painter: Painter<'a>,
    min_points: usize,
    census: Census,
}

/// Works through all points and leaves their bricks in the spool.
pub(super) fn run(
    cloud: &PointCloud,
    options: &VoxelizeOptions,
    limits: &Limits,
    spool: &mut Spool,
    progress: &VoxelizeProgress,
) -> Result<Run, VoxelizeError> {
    /// Tiles that are done before their bricks go to the spool.
    const BATCH: usize = 256;
    let job = Job::of(cloud, options)?;
    let count = cloud.positions.len() as u64;
    progress.begin(count);
    let most = options.memory_budget.map_or(u64::MAX, |budget| pairs_within(budget, cloud.size_bytes()));
    let layers = bands(&job.points_by_layer(), most);
    let tile_of = |pair: &u64| (pair >> 32) as u32;
    for layers in layers {
        let pairs = job.pairs(&layers);
        let parts: Vec<&[u64]> = pairs.chunk_by(|a, b| tile_of(a) == tile_of(b)).collect();
        for batch in parts.chunks(BATCH) {
            let records: Vec<_> = batch.par_iter().with_max_len(4).map(|pairs| job.tile(pairs)).collect();
            for record in records {
                spool.push(record)?;
            }
            check_on(spool, limits, progress)?;
            progress.add(batch.iter().map(|pairs| pairs.len() as u64).sum());
        }
    }
    if spool.brick_count() == 0 {
        return Err(VoxelizeError::TooThin(options.points.min_points));
    }
    let classes = [Class::of(&MeshMaterial::default())];
    let palette = Palette::of(&job.census, &classes, material_count(options), options.dither);
    Ok(Run { placement: job.placement, palette })
}

impl<'a> Job<'a> {
    fn of(cloud: &'a PointCloud, options: &VoxelizeOptions) -> Result<Self, VoxelizeError> {
        cloud.validate().map_err(VoxelizeError::BadPoints)?;
        let count = cloud.positions.len() as u64;
        if count > u64::from(u32::MAX) {
            return Err(VoxelizeError::TooLarge { what: "points", needed: count, limit: u32::MAX.into() });
        }
        let placement = Placement::of_points(cloud, options.scale)?;
        // A resolution fills the grid from corner to corner, and the highest points belong into it.
        let last = placement.size - i32::from(matches!(options.scale, Scale::Resolution(_)));
        let tiles = tiles_of(&placement)?;
        let painter = Painter::of(cloud, options.points.color_by).map_err(VoxelizeError::Missing)?;
        let min_points = options.points.min_points.max(1) as usize;
        Ok(Self { cloud, placement, last, tiles, painter, min_points, census: Census::default() })
    }

    /// The voxel of a point.
    fn voxel(&self, point: Vec3) -> IVec3 {
        self.placement.voxels(point).floor().as_ivec3().clamp(IVec3::ZERO, self.last)
    }

    fn points_by_layer(&self) -> Vec<u64> {
        let mut counts = vec![0; self.tiles.layers()];
        for &point in &self.cloud.positions {
            counts[self.tiles.layer(self.voxel(point).z.div_euclid(TILE))] += 1;
        }
        counts
    }

    /// Pairs of tile (upper half) and point of some layers of tiles, sorted.
    fn pairs(&self, layers: &Range<usize>) -> Vec<u64> {
        let pair = |(index, &point): (usize, &Vec3)| {
            let tile = self.voxel(point).div_euclid(IVec3::splat(TILE));
            let number = u64::from(self.tiles.number(tile.to_array()));
            layers.contains(&self.tiles.layer(tile.z)).then_some(number << 32 | index as u64)
        };
        let mut pairs: Vec<u64> = self.cloud.positions.par_iter().enumerate().filter_map(pair).collect();
        pairs.par_sort_unstable();
        pairs
    }

    /// The bricks of one tile.
    fn tile(&self, pairs: &[u64]) -> TileRecords {
        /// Bits of a voxel in its brick.
        const VOXEL_BITS: u32 = 9;
        let low = self.tiles.tile((pairs[0] >> 32) as u32) * TILE;
        let mut cells: Vec<u64> = pairs
            .iter()
            .map(|&pair| {
                let local = self.voxel(self.cloud.positions[pair as u32 as usize]) - low;
                let (brick, inner) = (local / BRICK_SIZE, local % BRICK_SIZE);
                let brick = (brick.z << 4 | brick.y << 2 | brick.x) as u64;
                let voxel = (block_index(inner) as u64) << 6 | u64::from(block_bit(inner));
                (brick << VOXEL_BITS | voxel) << 32 | pair & 0xffff_ffff
            })
            .collect();
        cells.sort_unstable();
        let mut records = TileRecords::default();
        let mut keys = Vec::new();
        let brick_of = |cell: u64| cell >> 32 >> VOXEL_BITS;
        for cells in cells.chunk_by(|&a, &b| brick_of(a) == brick_of(b)) {
            let mut occupancy = [0u64; 8];
            keys.clear();
            for points in cells.chunk_by(|a, b| a >> 32 == b >> 32).filter(|points| points.len() >= self.min_points) {
                let mut sums = [0u64; 3];
                for &point in points {
                    let color = self.painter.fixed(point as u32 as usize);
                    sums.iter_mut().zip(color).for_each(|(sum, value)| *sum += u64::from(value));
                }
                let voxel = points[0] >> 32;
                occupancy[(voxel >> 6 & 7) as usize] |= 1 << (voxel & 63);
                keys.push(key_of(rgb_bits(Painter::mean(sums, points.len() as u64)), 0, 0));
            }
            if !keys.is_empty() {
                self.census.add(&keys, 1);
                let brick = brick_of(cells[0]) as i32;
                let at = low / BRICK_SIZE + IVec3::new(brick & 3, brick >> 2 & 3, brick >> 4);
                records.push(at, &occupancy, &keys);
            }
        }
        records
    }
}
