//! What must be known of all points before any becomes a voxel: bounds, density, ranges of values. Passes over a part of the points
//! find it out for that part, and what comes of several does not depend on who made them or in which order: minima, sums of whole
//! numbers, unions.

use crate::fields::{FieldReader, FieldWriter};
use crate::mesh::source::Sample;
use crate::points::source::PointSource;
use crate::points::{ColorBy, Density, PointCloud, ValueHistogram};
use crate::voxelize::estimate::bytes_of;
use crate::voxelize::hyperloglog::HyperLogLog;
use crate::voxelize::{Estimate, Placement, Scale, VoxelizeError, VoxelizeOptions, VoxelizeProgress};
use glam::{DVec3, Vec3};
use rayon::prelude::*;

/// Number of intensities that there may be.
const INTENSITIES: usize = 1 << 16;

/// Statistics of a first pass over all points: count, bounds, intensities, estimated voxels and a sample.
#[derive(Clone, Debug)]
pub struct Survey {
    pub(super) low: Vec3,
    pub(super) high: Vec3,
    pub(super) sample: Sample,
    /// Histogram of the intensities.
    intensities: Vec<u64>,
    /// A guessed size of voxels, and a sketch of the voxels of that size with points in them.
    voxels: Option<(f64, HyperLogLog)>,
    /// The points' density within the bounds that were announced, until it is settled whether they were right.
    density: Option<Density>,
    /// The resolution chosen by the points' density, for [`Scale::Automatic`].
    resolution: Option<u32>,
    /// The heights that are told apart by colours, where a second pass has found them out.
    heights: Option<(f32, f32)>,
}

/// What the files say of all points beforehand.
pub(super) struct Announced {
    pub points: u64,
    bounds: Option<(DVec3, DVec3)>,
    is_automatic: bool,
    /// A guessed size of voxels.
    guess: Option<f64>,
}

impl Announced {
    /// The size of voxels is known only after the pass; to estimate their number, it is guessed from the announced bounds.
    pub fn of(source: &dyn PointSource, options: &VoxelizeOptions) -> Self {
        let bounds = source.announced_bounds();
        let along = |count: u32| bounds.map(|(low, high)| (high - low).max_element() / f64::from(count.max(1)));
        let guess = match options.scale {
            Scale::VoxelSize(size) => Some(size),
            Scale::Resolution(count) => along(count),
            Scale::Automatic => None,
        };
        let guess = guess.filter(|size| size.is_normal() && *size > 0.0);
        Self { points: source.count(), bounds, is_automatic: options.scale == Scale::Automatic, guess }
    }

    /// For surveys of which nobody asks how many voxels there will be.
    pub fn without_guess(self) -> Self {
        Self { guess: None, ..self }
    }
}

impl Survey {
    /// Makes the first pass; a second one follows where [`Scale::Automatic`] needs the density and the file announced wrong bounds.
    ///
    /// # Errors
    /// If they cannot be read; also if it was cancelled.
    pub fn of(
        source: &mut dyn PointSource,
        options: &VoxelizeOptions,
        progress: &VoxelizeProgress,
    ) -> Result<Self, VoxelizeError> {
        let announced = Announced::of(source, options);
        let mut survey = Self::empty(&announced);
        progress.begin(announced.points);
        source.for_each(&mut |piece| {
            survey.add(piece, &announced);
            progress.add(piece.positions.len() as u64);
            !progress.is_cancelled()
        })?;
        if progress.is_cancelled() {
            return Err(VoxelizeError::Cancelled);
        }
        if survey.points() == 0 {
            return Err(VoxelizeError::NoPoints);
        }
        survey.settle();
        if announced.is_automatic && survey.resolution.is_none() {
            let measures = survey.measure(source, (true, false), progress)?;
            survey.take(measures);
        }
        Ok(survey)
    }

    /// The survey of no points.
    pub(super) fn empty(announced: &Announced) -> Self {
        Self {
            low: Vec3::INFINITY,
            high: Vec3::NEG_INFINITY,
            sample: Sample::default(),
            intensities: vec![0; INTENSITIES],
            voxels: announced.guess.map(|size| (size, HyperLogLog::default())),
            density: None,
            resolution: None,
            heights: None,
        }
    }

    /// Adds points.
    pub(super) fn add(&mut self, piece: &PointCloud, announced: &Announced) {
        for &point in &piece.positions {
            (self.low, self.high) = (self.low.min(point), self.high.max(point));
            self.sample.add(|| point);
        }
        if let Some((low, high)) = announced.bounds.filter(|_| announced.is_automatic) {
            let own = |end: DVec3| (end - piece.offset).as_vec3();
            let density = || Density::over(own(low), own(high), announced.points);
            self.density.get_or_insert_with(density).add(&piece.positions);
        }
        piece.intensities.iter().for_each(|&value| self.intensities[usize::from(value)] += 1);
        if let Some((size, counter)) = &mut self.voxels {
            let size = *size;
            let part = |points: &[Vec3]| {
                let mut part = HyperLogLog::default();
                points.iter().for_each(|point| part.add((point.as_dvec3() / size).floor().as_ivec3()));
                part
            };
            let run = piece.positions.len().div_ceil(rayon::current_num_threads()).max(1);
            let parts: Vec<HyperLogLog> = piece.positions.par_chunks(run).map(part).collect();
            parts.iter().for_each(|part| counter.merge(part));
        }
    }

    /// Adds so many of `all` points that are expected within bounds, as if they were spread evenly.
    pub(super) fn expect(&mut self, low: Vec3, high: Vec3, points: u64, all: u64) {
        // The R3 low-discrepancy sequence (Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences", 2018) fills a box evenly.
        const STEP: Vec3 = Vec3::new(0.819_172_5, 0.671_043_6, 0.549_700_5);
        if points == 0 {
            return;
        }
        (self.low, self.high) = (self.low.min(low), self.high.max(high));
        let stride = all.div_ceil(Sample::MOST as u64).next_power_of_two();
        let spread = |index: u64| low + (high - low) * (STEP * (1 + index % (1 << 16)) as f32).fract();
        let some = (0..points.div_ceil(stride)).map(spread).collect();
        self.thin_sample(all);
        self.sample.join(&Sample::of_parts(some, stride, points).expect("the stride is a power of two"));
    }

    /// Adds the survey of other points, for which the files announced the same.
    pub(super) fn join(&mut self, other: Self) {
        (self.low, self.high) = (self.low.min(other.low), self.high.max(other.high));
        self.sample.join(&other.sample);
        self.intensities.iter_mut().zip(other.intensities).for_each(|(own, other)| *own += other);
        match (&mut self.voxels, other.voxels) {
            (Some((own, counter)), Some((size, theirs))) if *own == size => counter.merge(&theirs),
            (own, _) => *own = None,
        }
        match (&mut self.density, other.density) {
            (Some(own), Some(other)) => own.join(other),
            (own, other) => *own = own.take().or(other),
        }
    }

    /// Makes the sample one that may be a part of a sample of so many points.
    pub(super) fn thin_sample(&mut self, points: u64) {
        self.sample.thin(points.div_ceil(Sample::MOST as u64).next_power_of_two());
    }

    /// Once all points are there: chooses the resolution, if the density was measured within their true bounds.
    pub(super) fn settle(&mut self) {
        let (low, high, points) = (self.low, self.high, self.points());
        let density = self.density.take().filter(|density| density.is_over(low, high, points));
        self.resolution = self.resolution.or(density.map(Density::resolution));
    }

    /// What a second pass has to measure so that everything is known: the density, and the range of heights.
    pub(super) fn wants(&self, options: &VoxelizeOptions, by: ColorBy) -> (bool, bool) {
        let wants_density = options.scale == Scale::Automatic && self.resolution.is_none();
        (wants_density, by == ColorBy::Height && self.heights.is_none())
    }

    /// Makes a second pass over points of the source, within the bounds of all.
    pub(super) fn measure(
        &self,
        source: &mut dyn PointSource,
        (wants_density, wants_heights): (bool, bool),
        progress: &VoxelizeProgress,
    ) -> Result<Measures, VoxelizeError> {
        let mut density = wants_density.then(|| Density::over(self.low, self.high, self.points()));
        let mut heights = wants_heights.then(|| ValueHistogram::between(self.low.z, self.high.z));
        if !wants_density && !wants_heights {
            return Ok(Measures { density, heights });
        }
        progress.begin(self.points());
        source.for_each(&mut |piece| {
            density.iter_mut().for_each(|density| density.add(&piece.positions));
            heights.iter_mut().for_each(|heights| piece.positions.iter().for_each(|point| heights.add(point.z, 1)));
            progress.add(piece.positions.len() as u64);
            !progress.is_cancelled()
        })?;
        if progress.is_cancelled() { Err(VoxelizeError::Cancelled) } else { Ok(Measures { density, heights }) }
    }

    /// Takes what second passes over all points have measured.
    pub(super) fn take(&mut self, measures: Measures) {
        self.resolution = self.resolution.or(measures.density.map(Density::resolution));
        self.heights = self.heights.or(measures.heights.map(|heights| heights.percentile_range()));
    }

    /// The scale, with [`Scale::Automatic`] resolved.
    pub(super) fn scale(&self, options: &VoxelizeOptions) -> Scale {
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

    /// What a second pass has found out.
    pub(super) fn found_later(&self) -> impl std::fmt::Debug + use<> {
        (self.resolution, self.heights)
    }

    pub(super) fn placement(&self, offset: DVec3, options: &VoxelizeOptions) -> Result<Placement, VoxelizeError> {
        let bounds = (self.low.as_dvec3() + offset, self.high.as_dvec3() + offset);
        Placement::over(bounds, offset, self.scale(options))
    }

    /// Estimates the voxels of the cloud, as [`crate::voxelize::estimate_points`] does.
    ///
    /// # Errors
    /// If there is no grid for it.
    pub fn estimate(&self, source: &mut dyn PointSource, options: &VoxelizeOptions) -> Result<Estimate, VoxelizeError> {
        let placement = self.placement(source.frame().offset, options)?;
        let is_near = |size: f64| (size / placement.voxel_size - 1.0).abs() < 0.01;
        let counted = self.voxels.as_ref().filter(|(size, _)| is_near(*size)).map(|(_, counter)| counter.count());
        let most = self.points() as f64;
        let voxels = placement.at_most(counted.unwrap_or(most).min(most));
        let is_bound = counted.is_none() || options.points.min_points > 1;
        Ok(Estimate { placement, voxels, bytes: bytes_of(voxels, false), is_bound })
    }

    /// The range of values that colours tell apart; `heights` are those of all points, where no second pass has found out their range.
    pub(super) fn color_range(&self, by: ColorBy, heights: &ValueHistogram) -> (f32, f32) {
        match by {
            ColorBy::Height => self.heights.unwrap_or_else(|| heights.percentile_range()),
            ColorBy::Intensity => self.intensity_range(),
            _ => (0.0, 1.0),
        }
    }

    fn intensity_range(&self) -> (f32, f32) {
        let present = || self.intensities.iter().enumerate().filter(|(_, count)| **count > 0);
        let ends = present().next().zip(present().next_back());
        let Some(((low, _), (high, _))) = ends else { return (0.0, 1.0) };
        let mut histogram = ValueHistogram::between(low as f32, high as f32);
        present().for_each(|(value, &count)| histogram.add(value as f32, count));
        histogram.percentile_range()
    }

    /// Adds the survey to what is written.
    pub(super) fn write(&mut self, out: &mut FieldWriter) {
        out.value([self.low, self.high]);
        out.values(self.sample.points());
        out.value([self.sample.stride(), self.sample.seen()]);
        let present = self.intensities.iter().enumerate().filter(|(_, count)| **count > 0);
        out.values(&present.map(|(value, &count)| [value as u64, count]).collect::<Vec<_>>());
        out.value(self.voxels.as_ref().map_or(f64::NAN, |(size, _)| *size));
        out.values(self.voxels.as_ref().map_or(&[][..], |(_, counter)| counter.registers()));
        out.value(self.resolution.unwrap_or(0));
        let (low, high) = self.heights.unwrap_or((f32::NAN, f32::NAN));
        out.value([low, high]);
        write_density(&mut self.density, out);
    }

    /// The survey that was written.
    pub(super) fn read(from: &mut FieldReader) -> Option<Self> {
        let [low, high] = from.value()?;
        let points = from.values()?;
        let [stride, seen] = from.value()?;
        let sample = Sample::of_parts(points, stride, seen)?;
        let mut intensities = vec![0; INTENSITIES];
        for [value, count] in from.values::<[u64; 2]>()? {
            *intensities.get_mut(usize::try_from(value).ok()?)? = count;
        }
        let (size, registers) = (from.value::<f64>()?, from.values::<u8>()?);
        let voxels = if size.is_nan() { None } else { Some((size, HyperLogLog::of_registers(registers)?)) };
        let resolution = Some(from.value::<u32>()?).filter(|&resolution| resolution > 0);
        let [least, most] = from.value::<[f32; 2]>()?;
        let heights = (!least.is_nan()).then_some((least, most));
        let density = read_density(from)?;
        Some(Self { low, high, sample, intensities, voxels, density, resolution, heights })
    }
}

/// What a second pass over points measures.
pub(super) struct Measures {
    density: Option<Density>,
    heights: Option<ValueHistogram>,
}

impl Measures {
    /// With what was measured of other points.
    pub fn joined(self, other: Self) -> Self {
        let density = match (self.density, other.density) {
            (Some(mut own), Some(other)) => {
                own.join(other);
                Some(own)
            }
            (own, other) => own.or(other),
        };
        let heights = match (self.heights, other.heights) {
            (Some(own), Some(other)) => Some(own.joined(other)),
            (own, other) => own.or(other),
        };
        Self { density, heights }
    }

    pub fn write(&mut self, out: &mut FieldWriter) {
        write_density(&mut self.density, out);
        let (low, high) = self.heights.as_ref().map_or((0.0, 0.0), ValueHistogram::ends);
        out.value([low, high]);
        out.values(self.heights.as_ref().map_or(&[][..], ValueHistogram::counts));
    }

    pub fn read(from: &mut FieldReader) -> Option<Self> {
        let density = read_density(from)?;
        let ([low, high], counts) = (from.value()?, from.values()?);
        let heights = if counts.is_empty() { None } else { Some(ValueHistogram::of_counts(low, high, counts)?) };
        Some(Self { density, heights })
    }
}

fn write_density(density: &mut Option<Density>, out: &mut FieldWriter) {
    out.value(u8::from(density.is_some()));
    density.iter_mut().for_each(|density| density.write(out));
}

/// `Some(None)` where there is none.
fn read_density(from: &mut FieldReader) -> Option<Option<Density>> {
    if from.value::<u8>()? == 0 { Some(None) } else { Density::read(from).map(Some) }
}
