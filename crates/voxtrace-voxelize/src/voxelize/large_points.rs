//! Clouds of points larger than memory: a first reading finds their bounds, a second one sorts them into buckets on the disk,
//! one for each bin of tiles, and then each bin is a small cloud. Sums of colours are whole numbers, so the voxels are those
//! of the cloud in memory.

use super::blocks::Blocks;
use super::buckets::Buckets;
use super::census::Census;
use super::distinct::Distinct;
use super::large::USUAL_BUDGET;
use super::part::Step;
use super::points::{BATCH, Grid, Mixer, Scratch, finish};
use super::spool::Spool;
use super::{Estimate, Placement, Run, Scale, VoxelizeError, VoxelizeOptions, VoxelizeProgress, bytes_of, check_on};
use crate::limits::Limits;
use crate::mesh::source::Sample;
use crate::points::source::PointSource;
use crate::points::{ColorBy, Density, Painter, Spread};
use glam::{DVec3, IVec3, Vec3};
use rayon::prelude::*;
use std::path::Path;
use voxtrace_scene::scene::Scene;

/// Bytes of a point on the disk: tile, cell and value of the colour.
const RECORD: usize = 10;
/// Bytes of a point in memory, while its bin is worked on.
const IN_MEMORY: u64 = 24;
/// Points looked at by one task.
const CHUNK: usize = 1 << 12;

/// What one reading of all points tells.
#[derive(Clone, Debug)]
pub struct Survey {
    low: Vec3,
    high: Vec3,
    sample: Sample,
    /// Points of each intensity.
    intensities: Vec<u64>,
    /// How many voxels of a size that was guessed have points.
    voxels: Option<(f64, f64)>,
    /// The resolution that suits the points, if it was asked for.
    resolution: Option<u32>,
}

impl Survey {
    /// Reads all points. How large voxels will be is known only then; with the bounds that the file announces it is guessed.
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
        let mut distinct = Distinct::default();
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
                    let mut part = Distinct::default();
                    points.iter().for_each(|point| part.add((point.as_dvec3() / size).floor().as_ivec3()));
                    part
                };
                let size = piece.positions.len().div_ceil(rayon::current_num_threads()).max(1);
                let parts: Vec<Distinct> = piece.positions.par_chunks(size).map(part).collect();
                parts.iter().for_each(|part| distinct.merge(part));
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
        survey.voxels = guess.map(|size| (size, distinct.count()));
        if options.scale == Scale::Automatic {
            let density = match density.filter(|density| density.is_over(survey.low, survey.high, survey.points())) {
                Some(density) => density,
                None => survey.density(source, progress)?,
            };
            survey.resolution = Some(density.resolution());
        }
        Ok(survey)
    }

    /// Looks at all points again, to see how dense they lie within their true bounds.
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

    /// How large voxels are: what suits the points is known here.
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

    /// All but the sample.
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

/// Voxelizes a cloud that is read piece by piece, and leaves its bricks in the spool.
pub(super) fn run(
    source: &mut dyn PointSource,
    survey: &Survey,
    options: &VoxelizeOptions,
    limits: &Limits,
    path: &Path,
    spool: &mut Spool,
    progress: &VoxelizeProgress,
) -> Result<(Run, Scene), VoxelizeError> {
    let budget = options.memory_budget.unwrap_or(USUAL_BUDGET);
    let by = options.points.color_by.settled(source.attributes()).map_err(VoxelizeError::Missing)?;
    let grid = Grid::of(survey.placement(source.frame().offset, options)?, survey.scale(options))?;
    let sample = survey.sample.points().iter();
    let sample = sample.map(|&point| grid.voxel(point).div_euclid(IVec3::splat(super::bins::TILE)).to_array());
    let blocks = Blocks::of(&grid.tiles, sample, survey.sample.stride(), budget / 4 / IN_MEMORY);
    // Sorting is one half of the work, what follows the other.
    progress.begin(2 * survey.points());
    let mut buckets = Buckets::beside(path, blocks.bins(), budget / 16)?;
    let mut heights = Spread::between(survey.low.z, survey.high.z);
    let census = Census::default();
    spool.resume(&census, progress)?;
    let is_done = |bin: u32| spool.is_past(bin);
    sort(source, &grid, &blocks, by, &is_done, &mut heights, &mut buckets, progress)?;
    let span = match by {
        ColorBy::Height => heights.span(),
        ColorBy::Intensity => survey.span_of_intensities(),
        _ => (0.0, 1.0),
    };
    let painter = Painter::new(by, span);
    let frame = source.frame();
    let mut scene = Scene::new(frame.name.clone());
    (scene.unit, scene.georeference) = (frame.unit, Some(grid.placement.georeference(&frame.crs)));

    let mixer = Mixer { tiles: &grid.tiles, painter: &painter, min_points: options.points.min_points, census: &census };
    // Points of bins that were done earlier have not been sorted again.
    let sorted: u64 = (0..blocks.bins()).map(|bin| buckets.size(bin) / RECORD as u64).sum();
    progress.add(survey.points().saturating_sub(sorted));
    for bin in 0..blocks.bins() {
        let mut points: Vec<(u32, u64)> = Vec::with_capacity((buckets.size(bin) / RECORD as u64) as usize);
        buckets.read(bin, |bytes| points.extend(bytes.as_chunks().0.iter().map(decoded)))?;
        points.par_sort_unstable_by_key(|&(tile, _)| tile);
        let tiles: Vec<&[(u32, u64)]> = points.chunk_by(|a, b| a.0 == b.0).collect();
        for (number, batch) in tiles.chunks(BATCH).enumerate() {
            let step = Step { part: bin as u32, batch: number as u32 };
            let work = |scratch: &mut Scratch, points: &&[(u32, u64)]| {
                let own: Vec<u64> = points.iter().map(|point| point.1).collect();
                mixer.tile(points[0].0, &own, scratch)
            };
            if !spool.has(step) {
                spool.push(step, batch.par_iter().with_max_len(4).map_init(Scratch::default, work).collect())?;
            }
            check_on(spool, limits, progress)?;
            progress.add(batch.iter().map(|points| points.len() as u64).sum());
        }
    }
    Ok((finish(grid.placement, &census, options, spool)?, scene))
}

impl Survey {
    fn span_of_intensities(&self) -> (f32, f32) {
        let present = || self.intensities.iter().enumerate().filter(|(_, count)| **count > 0);
        let ends = present().next().zip(present().next_back());
        let Some(((low, _), (high, _))) = ends else { return (0.0, 1.0) };
        let mut spread = Spread::between(low as f32, high as f32);
        present().for_each(|(value, &count)| spread.add(value as f32, count));
        spread.span()
    }
}

/// Puts every point into the bucket of its bin, unless that is done, and counts the heights.
#[expect(clippy::too_many_arguments, reason = "each is another thing")]
fn sort(
    source: &mut dyn PointSource,
    grid: &Grid,
    blocks: &Blocks,
    by: ColorBy,
    is_done: &(dyn Fn(u32) -> bool + Sync),
    heights: &mut Spread,
    buckets: &mut Buckets,
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
                let bin = blocks.bin(&grid.tiles, voxel.div_euclid(IVec3::splat(super::bins::TILE)).to_array());
                if !is_done(bin) {
                    sorted.push(bin, encoded(tile, cell, by.value(piece, index)));
                }
            }
            sorted
        });
        let chunks: Vec<Sorted> = chunks.collect();
        for (bin, records) in chunks.iter().flat_map(Sorted::runs) {
            if let Err(error) = buckets.push_all(bin, records, RECORD) {
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

/// Records one after the other, and how many of them go into the same bin.
struct Sorted {
    bytes: Vec<u8>,
    runs: Vec<(u32, usize)>,
}

impl Sorted {
    fn push(&mut self, bin: u32, record: [u8; RECORD]) {
        self.bytes.extend_from_slice(&record);
        match self.runs.last_mut() {
            Some((last, count)) if *last == bin => *count += 1,
            _ => self.runs.push((bin, 1)),
        }
    }

    /// Bins, and the records for them.
    fn runs(&self) -> impl Iterator<Item = (u32, &[u8])> {
        let mut rest = &self.bytes[..];
        self.runs.iter().map(move |&(bin, count)| {
            let (records, after) = rest.split_at(count * RECORD);
            rest = after;
            (bin, records)
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

/// The tile of a point, and its cell (upper half) and value.
fn decoded(&[a, b, c, d, e, f, g, h, i, j]: &[u8; RECORD]) -> (u32, u64) {
    let cell = u16::from_le_bytes([e, f]);
    (u32::from_le_bytes([a, b, c, d]), u64::from(cell) << 32 | u64::from(u32::from_le_bytes([g, h, i, j])))
}
