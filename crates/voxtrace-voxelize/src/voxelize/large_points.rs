//! Out-of-core voxelization of clouds larger than memory. A first pass over the file surveys the points; a second one
//! bucket-sorts them on the disk by part of the grid; then each part is voxelized as a small cloud. Colours are summed in fixed
//! point, so the voxels are the same bits as for a cloud in memory.

use super::checkpoint::Step;
use super::color_histogram::ColorHistogram;
use super::disk_buckets::DiskBuckets;
use super::estimate::bytes_of;
use super::hyperloglog::HyperLogLog;
use super::large::DEFAULT_BUDGET;
use super::partition::TilePartition;
use super::points::{BATCH, Grid, PointAccumulator, Scratch, finish};
use super::spill::SpillBuffer;
use super::voxelized::{Voxelized, scene_of_source};
use super::{Estimate, Placement, Scale, VoxelizeError, VoxelizeOptions, VoxelizeProgress, check_limits};
use crate::limits::Limits;
use crate::mesh::source::Sample;
use crate::points::source::PointSource;
use crate::points::{ColorBy, ColorMap, Density, ValueHistogram};
use glam::{DVec3, IVec3, Vec3};
use rayon::prelude::*;
use std::path::Path;
use voxtrace_scene::scene::Scene;

/// Bytes of a point on the disk: tile (4), index in the tile (2) and value of the colour (4).
const RECORD: usize = 10;
/// Bytes of a point in memory, while its part is worked on.
const IN_MEMORY: u64 = 24;
/// Points processed by one task.
const CHUNK: usize = 1 << 12;

/// Statistics of a first pass over all points: count, bounds, intensities, estimated voxels and a sample.
#[derive(Clone, Debug)]
pub struct Survey {
    low: Vec3,
    high: Vec3,
    sample: Sample,
    /// Histogram of the intensities.
    intensities: Vec<u64>,
    /// A guessed size of voxels, and the estimated number of voxels of that size with points in them.
    voxels: Option<(f64, f64)>,
    /// The resolution chosen by the points' density, for [`Scale::Automatic`].
    resolution: Option<u32>,
}

impl Survey {
    /// Makes the first pass; a second one follows where [`Scale::Automatic`] needs the density and the file announced wrong bounds.
    /// The size of voxels is known only afterwards; to estimate their number, it is guessed from the announced bounds.
    ///
    /// # Errors
    /// If they cannot be read; also if it was cancelled.
    pub fn of(
        source: &mut dyn PointSource,
        options: &VoxelizeOptions,
        progress: &VoxelizeProgress,
    ) -> Result<Self, VoxelizeError> {
        let bounds = source.announced_bounds();
        let along = |count: u32| bounds.map(|(low, high)| (high - low).max_element() / f64::from(count.max(1)));
        let guess = match options.scale {
            Scale::VoxelSize(size) => Some(size),
            Scale::Resolution(count) => along(count),
            Scale::Automatic => None,
        };
        let guess = guess.filter(|size| size.is_normal() && *size > 0.0);
        let mut counter = HyperLogLog::default();
        let (low, high) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
        let (intensities, sample) = (vec![0; 1 << 16], Sample::default());
        let mut survey = Self { low, high, sample, intensities, voxels: None, resolution: None };
        let count = source.count();
        let mut density: Option<Density> = None;
        progress.begin(count);
        source.for_each(&mut |piece| {
            for &point in &piece.positions {
                (survey.low, survey.high) = (survey.low.min(point), survey.high.max(point));
                survey.sample.add(|| point);
            }
            if let Some((low, high)) = bounds.filter(|_| options.scale == Scale::Automatic) {
                let own = |end: DVec3| (end - piece.offset).as_vec3();
                density.get_or_insert_with(|| Density::over(own(low), own(high), count)).add(&piece.positions);
            }
            piece.intensities.iter().for_each(|&value| survey.intensities[usize::from(value)] += 1);
            if let Some(size) = guess {
                let part = |points: &[Vec3]| {
                    let mut part = HyperLogLog::default();
                    points.iter().for_each(|point| part.add((point.as_dvec3() / size).floor().as_ivec3()));
                    part
                };
                let size = piece.positions.len().div_ceil(rayon::current_num_threads()).max(1);
                let parts: Vec<HyperLogLog> = piece.positions.par_chunks(size).map(part).collect();
                parts.iter().for_each(|part| counter.merge(part));
            }
            progress.add(piece.positions.len() as u64);
            !progress.is_cancelled()
        })?;
        if progress.is_cancelled() {
            return Err(VoxelizeError::Cancelled);
        }
        if survey.points() == 0 {
            return Err(VoxelizeError::NoPoints);
        }
        survey.voxels = guess.map(|size| (size, counter.count()));
        if options.scale == Scale::Automatic {
            let density = match density.filter(|density| density.is_over(survey.low, survey.high, survey.points())) {
                Some(density) => density,
                None => survey.density(source, progress)?,
            };
            survey.resolution = Some(density.resolution());
        }
        Ok(survey)
    }

    /// Makes another pass to measure the density within the true bounds.
    fn density(&self, source: &mut dyn PointSource, progress: &VoxelizeProgress) -> Result<Density, VoxelizeError> {
        let mut density = Density::over(self.low, self.high, self.points());
        progress.begin(self.points());
        source.for_each(&mut |piece| {
            density.add(&piece.positions);
            progress.add(piece.positions.len() as u64);
            !progress.is_cancelled()
        })?;
        if progress.is_cancelled() { Err(VoxelizeError::Cancelled) } else { Ok(density) }
    }

    /// The scale, with [`Scale::Automatic`] resolved.
    fn scale(&self, options: &VoxelizeOptions) -> Scale {
        match self.resolution {
            Some(resolution) if options.scale == Scale::Automatic => Scale::Resolution(resolution),
            _ => options.scale,
        }
    }

    /// Number of points.
    pub fn points(&self) -> u64 {
        self.sample.seen()
    }

    /// Everything but the sample, to tell one file from another.
    pub fn summary(&self) -> impl std::fmt::Debug + use<> {
        (self.points(), self.low, self.high)
    }

    fn placement(&self, offset: DVec3, options: &VoxelizeOptions) -> Result<Placement, VoxelizeError> {
        let bounds = (self.low.as_dvec3() + offset, self.high.as_dvec3() + offset);
        Placement::over(bounds, offset, self.scale(options))
    }

    /// Estimates the voxels of the cloud, as [`super::estimate_points`] does.
    ///
    /// # Errors
    /// If there is no grid for it.
    pub fn estimate(&self, source: &mut dyn PointSource, options: &VoxelizeOptions) -> Result<Estimate, VoxelizeError> {
        let placement = self.placement(source.frame().offset, options)?;
        let is_near = |size: f64| (size / placement.voxel_size - 1.0).abs() < 0.01;
        let counted = self.voxels.filter(|&(size, _)| is_near(size)).map(|(_, count)| count);
        let most = self.points() as f64;
        let voxels = placement.at_most(counted.unwrap_or(most).min(most));
        let is_bound = counted.is_none() || options.points.min_points > 1;
        Ok(Estimate { placement, voxels, bytes: bytes_of(voxels, false), is_bound })
    }
}

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
    let budget = options.memory_budget.unwrap_or(DEFAULT_BUDGET);
    let by = options.points.color_by.resolved(source.attributes()).map_err(VoxelizeError::Missing)?;
    let grid = Grid::of(survey.placement(source.frame().offset, options)?, survey.scale(options))?;
    let sample = survey.sample.points().iter();
    let sample = sample.map(|&point| grid.voxel(point).div_euclid(IVec3::splat(super::binning::TILE)).to_array());
    let partition = TilePartition::of(&grid.tiles, sample, survey.sample.stride(), budget / 4 / IN_MEMORY);
    // Sorting counts as one half of the work, voxelizing as the other.
    progress.begin(2 * survey.points());
    let mut buckets = DiskBuckets::beside(path, partition.part_count(), budget / 16)?;
    let mut heights = ValueHistogram::between(survey.low.z, survey.high.z);
    let histogram = ColorHistogram::default();
    spill.resume(&histogram, progress)?;
    let is_done = |part: u32| spill.is_past(part);
    sort(source, &grid, &partition, by, &is_done, &mut heights, &mut buckets, progress)?;
    let range = match by {
        ColorBy::Height => heights.percentile_range(),
        ColorBy::Intensity => survey.intensity_range(),
        _ => (0.0, 1.0),
    };
    let color_map = ColorMap::new(by, range);
    let frame = source.frame();
    let mut scene = scene_of_source(&frame.name, frame.unit);
    scene.georeference = Some(grid.placement.georeference(frame));

    let accumulator = PointAccumulator {
        tiles: &grid.tiles,
        color_map: &color_map,
        min_points: options.points.min_points,
        histogram: &histogram,
    };
    // Points of parts that were done earlier have not been sorted again.
    let sorted: u64 = (0..partition.part_count()).map(|part| buckets.size(part) / RECORD as u64).sum();
    progress.add(survey.points().saturating_sub(sorted));
    for part in 0..partition.part_count() {
        let mut points: Vec<(u32, u64)> = Vec::with_capacity((buckets.size(part) / RECORD as u64) as usize);
        buckets.read(part, |bytes| points.extend(bytes.as_chunks().0.iter().map(decoded)))?;
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
    Ok((finish(grid.placement, &histogram, options, spill)?, scene))
}

impl Survey {
    fn intensity_range(&self) -> (f32, f32) {
        let present = || self.intensities.iter().enumerate().filter(|(_, count)| **count > 0);
        let ends = present().next().zip(present().next_back());
        let Some(((low, _), (high, _))) = ends else { return (0.0, 1.0) };
        let mut histogram = ValueHistogram::between(low as f32, high as f32);
        present().for_each(|(value, &count)| histogram.add(value as f32, count));
        histogram.percentile_range()
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
    source.for_each(&mut |piece| {
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
