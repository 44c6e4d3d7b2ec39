//! Out-of-core voxelization of clouds larger than memory. A first pass over the file surveys the points; a second one
//! bucket-sorts them on the disk by part of the grid; then each part is voxelized as a small cloud. Colours are summed in fixed
//! point, so the voxels are the same bits as for a cloud in memory.
//!
//! Several processes share a cloud of several files: `tiles` has what they find out about some files each, or expect of them, `part` voxelizes some of
//! them, where it leaves sums of what others reach into (`seams`), and `merge` makes the scene of all (`docs/decisions/0223-voxelizing-by-many-processes.md`).

mod merge;
mod part;
mod seams;
mod survey;
mod tiles;

pub use merge::merge_tiles;
pub use part::{TilePart, voxelize_tiles};
pub(super) use seams::Seams;
pub use survey::Survey;
pub(super) use tiles::check_files;
pub use tiles::{TileSurvey, joined_bytes};

use super::checkpoint::Step;
use super::color_histogram::ColorHistogram;
use super::disk_buckets::DiskBuckets;
use super::large::DEFAULT_BUDGET;
use super::partition::TilePartition;
use super::points::{BATCH, Grid, PointAccumulator, Scratch, finish};
use super::spill::SpillBuffer;
use super::voxelized::{Voxelized, scene_of_source};
use super::{VoxelizeError, VoxelizeOptions, VoxelizeProgress, check_limits};
use crate::limits::Limits;
use crate::points::source::PointSource;
use crate::points::{ColorBy, ColorMap, PointCloud, ValueHistogram};
use glam::IVec3;
use rayon::prelude::*;
use std::panic::resume_unwind;
use std::path::Path;
use std::sync::mpsc::sync_channel;
use std::thread;
use voxtrace_scene::scene::Scene;

/// Bytes of a point on the disk: tile (4), index in the tile (2) and value of the colour (4).
const RECORD: usize = 10;
/// Bytes of a point in memory, while its part is worked on.
const IN_MEMORY: u64 = 24;
/// Points processed by one task.
const CHUNK: usize = 1 << 12;

/// Voxelizes a cloud that is read piece by piece into the spill buffer.
pub(super) fn run(
    source: &mut dyn PointSource,
    survey: &Survey,
    options: &VoxelizeOptions,
    limits: &Limits,
    path: &Path,
    spill: &mut SpillBuffer,
    progress: &VoxelizeProgress,
) -> Result<(Voxelized, Scene), VoxelizeError> {
    let work = Work { survey, options, limits, path, progress, seams: None };
    let histogram = ColorHistogram::default();
    spill.resume(&histogram, progress)?;
    let grid = work.spill_bricks(source, &histogram, spill)?;
    let scene = scene_of(source, &grid);
    Ok((finish(grid.placement, &histogram, options, spill)?, scene))
}

/// The scene of a cloud without its bricks.
fn scene_of(source: &mut dyn PointSource, grid: &Grid) -> Scene {
    let frame = source.frame();
    let mut scene = scene_of_source(&frame.name, frame.unit);
    scene.georeference = Some(grid.placement.georeference(frame));
    scene
}

/// Voxelizing the points of a source: all of a cloud, or those of some of its files.
struct Work<'a> {
    /// Of all points of the cloud.
    survey: &'a Survey,
    options: &'a VoxelizeOptions,
    limits: &'a Limits,
    /// What temporary files lie beside.
    path: &'a Path,
    progress: &'a VoxelizeProgress,
    /// Where the source has the points of some files: what others reach into.
    seams: Option<&'a Seams>,
}

impl Work<'_> {
    /// Sorts the points and spills their bricks.
    fn spill_bricks(
        &self,
        source: &mut dyn PointSource,
        histogram: &ColorHistogram,
        spill: &mut SpillBuffer,
    ) -> Result<Grid, VoxelizeError> {
        let Self { survey, options, limits, path, progress, seams } = *self;
        let budget = options.memory_budget.unwrap_or(DEFAULT_BUDGET);
        let by = options.points.color_by.resolved(source.attributes()).map_err(VoxelizeError::Missing)?;
        let grid = Grid::of(survey.placement(source.frame().offset, options)?, survey.scale(options))?;
        let sample = survey.sample.points().iter().filter(|&&point| seams.is_none_or(|seams| seams.may_own(point)));
        let sample = sample.map(|&point| grid.voxel(point).div_euclid(IVec3::splat(super::binning::TILE)).to_array());
        let partition = TilePartition::of(&grid.tiles, sample, survey.sample.stride(), budget / 4 / IN_MEMORY, 1);
        let count = seams.map_or(survey.points(), Seams::points);
        // Sorting counts as one half of the work, voxelizing as the other.
        progress.begin(2 * count);
        let mut buckets = DiskBuckets::beside(path, partition.part_count(), budget / 16)?;
        let mut heights = ValueHistogram::between(survey.low.z, survey.high.z);
        let is_done = |part: u32| spill.is_past(part);
        sort(source, &grid, &partition, by, &is_done, &mut heights, &mut buckets, progress)?;
        let color_map = ColorMap::new(by, survey.color_range(by, &heights));
        let accumulator = PointAccumulator {
            tiles: &grid.tiles,
            color_map: &color_map,
            min_points: options.points.min_points,
            histogram,
            seams,
        };
        // Points of parts that were done earlier have not been sorted again.
        let sorted: u64 = (0..partition.part_count()).map(|part| buckets.size(part) / RECORD as u64).sum();
        progress.add(count.saturating_sub(sorted));
        for part in 0..partition.part_count() {
            let mut points: Vec<(u32, u64)> = Vec::with_capacity((buckets.size(part) / RECORD as u64) as usize);
            buckets.read(part, |bytes| points.par_extend(bytes.as_chunks().0.par_iter().map(decoded)))?;
            points.par_sort_unstable_by_key(|&(tile, _)| tile);
            let tiles: Vec<&[(u32, u64)]> = points.chunk_by(|a, b| a.0 == b.0).collect();
            for (number, batch) in tiles.chunks(BATCH).enumerate() {
                let step = Step { part: part as u32, batch: number as u32 };
                let work = |scratch: &mut Scratch, points: &&[(u32, u64)]| {
                    let own: Vec<u64> = points.iter().map(|point| point.1).collect();
                    accumulator.tile(points[0].0, &own, scratch)
                };
                if !spill.has(step) {
                    spill.push(step, batch.par_iter().with_max_len(4).map_init(Scratch::default, work).collect())?;
                }
                check_limits(spill, limits, progress)?;
                progress.add(batch.iter().map(|points| points.len() as u64).sum());
            }
        }
        Ok(grid)
    }
}

/// Puts every point into the bucket of its part, unless that is done, and builds the histogram of heights.
#[expect(clippy::too_many_arguments, reason = "each is another thing")]
fn sort(
    source: &mut dyn PointSource,
    grid: &Grid,
    partition: &TilePartition,
    by: ColorBy,
    is_done: &(dyn Fn(u32) -> bool + Sync),
    heights: &mut ValueHistogram,
    buckets: &mut DiskBuckets,
    progress: &VoxelizeProgress,
) -> Result<(), VoxelizeError> {
    let mut failure = None;
    for_each_ahead(source, &mut |piece| {
        let count = piece.positions.len();
        let chunks = (0..count.div_ceil(CHUNK)).into_par_iter().map(|chunk| {
            let points = chunk * CHUNK..((chunk + 1) * CHUNK).min(count);
            let mut sorted = Sorted { bytes: Vec::with_capacity(points.len() * RECORD), runs: Vec::new() };
            for index in points {
                let voxel = grid.voxel(piece.positions[index]);
                let (tile, cell) = grid.cell(voxel);
                let part = partition.part(&grid.tiles, voxel.div_euclid(IVec3::splat(super::binning::TILE)).to_array());
                if !is_done(part) {
                    sorted.push(part, encoded(tile, cell, by.value(piece, index)));
                }
            }
            sorted
        });
        let chunks: Vec<Sorted> = chunks.collect();
        for (part, records) in chunks.iter().flat_map(Sorted::runs) {
            if let Err(error) = buckets.push_all(part, records, RECORD) {
                failure = Some(error);
                return false;
            }
        }
        if by == ColorBy::Height {
            piece.positions.iter().for_each(|position| heights.add(position.z, 1));
        }
        progress.add(count as u64);
        !progress.is_cancelled()
    })?;
    buckets.end(failure, progress)
}

/// Goes through the pieces of a source, of which the next one is read while one is worked on.
fn for_each_ahead(
    source: &mut dyn PointSource,
    each: &mut dyn FnMut(&PointCloud) -> bool,
) -> Result<(), VoxelizeError> {
    thread::scope(|scope| {
        let (give, pieces) = sync_channel(1);
        let read = move || source.for_each(&mut |piece| give.send(piece.clone()).is_ok());
        let reader = thread::Builder::new().name("points".into()).spawn_scoped(scope, read)?;
        // Without anybody to take them, reading ends.
        for piece in pieces {
            if !each(&piece) {
                break;
            }
        }
        Ok(reader.join().unwrap_or_else(|panic| resume_unwind(panic))?)
    })
}

/// Encoded points in order, with runs of those that go into the same part.
struct Sorted {
    bytes: Vec<u8>,
    runs: Vec<(u32, usize)>,
}

impl Sorted {
    fn push(&mut self, part: u32, record: [u8; RECORD]) {
        self.bytes.extend_from_slice(&record);
        match self.runs.last_mut() {
            Some((last, count)) if *last == part => *count += 1,
            _ => self.runs.push((part, 1)),
        }
    }

    /// The runs: part and records.
    fn runs(&self) -> impl Iterator<Item = (u32, &[u8])> {
        let mut rest = &self.bytes[..];
        self.runs.iter().map(move |&(part, count)| {
            let (records, after) = rest.split_at(count * RECORD);
            rest = after;
            (part, records)
        })
    }
}

fn encoded(tile: u32, cell: u32, value: u32) -> [u8; RECORD] {
    let mut bytes = [0; RECORD];
    bytes[..4].copy_from_slice(&tile.to_le_bytes());
    bytes[4..6].copy_from_slice(&(cell as u16).to_le_bytes());
    bytes[6..].copy_from_slice(&value.to_le_bytes());
    bytes
}

/// The tile of a point, and its index in the tile (upper 32 bits) and value.
fn decoded(&[a, b, c, d, e, f, g, h, i, j]: &[u8; RECORD]) -> (u32, u64) {
    let cell = u16::from_le_bytes([e, f]);
    (u32::from_le_bytes([a, b, c, d]), u64::from(cell) << 32 | u64::from(u32::from_le_bytes([g, h, i, j])))
}
