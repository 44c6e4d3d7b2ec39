//! What there is to know of a volume before its voxels are made: what values it has, where the transfer function goes by them. Others
//! need no look at the samples; what values there were is known when all have been read for their voxels.

use super::super::statistics::{Look, binned, sum};
use super::super::{Placement, Transfer, ValueStatistics, Volume, VolumeError, VolumeOptions};
use super::ahead::{ON_THE_WAY, ahead};
use super::stripes::rows_within;
use super::tally::Tally;
use super::threshold;
use super::{Block, Coding, DEFAULT_BUDGET, SampleSource};
use crate::fields::{FieldReader, FieldWriter};
use crate::voxelize::{VoxelizeError, VoxelizeProgress};
use std::ops::Range;

/// First bytes of a look at some layers, and of a survey. To be changed with what follows them.
const LOOK: &[u8; 8] = b"voxlook\x01";
const SURVEY: &[u8; 8] = b"voxvals\x01";

/// The transfer function, and what is known of the values.
#[derive(Clone, Debug)]
pub struct Survey {
    /// What all samples say; `None` until they were read.
    seen: Option<(ValueStatistics, Look)>,
    /// The transfer function, resolved.
    transfer: Transfer,
}

impl Survey {
    /// Reads nothing where a transfer function is given that does not go by the values; else all samples once, and twice more where it goes by
    /// a scale and the values are too many to count each.
    ///
    /// # Errors
    /// If the volume is broken or cannot be read; also if it was cancelled.
    pub fn of(
        source: &mut dyn SampleSource,
        options: &VolumeOptions,
        memory_budget: Option<u64>,
        progress: &VoxelizeProgress,
    ) -> Result<Self, VoxelizeError> {
        if let Some(known) = Self::without_values(source.frame(), options)? {
            return Ok(known);
        }
        let all = 0..source.frame().size[2];
        let budget = memory_budget.unwrap_or(DEFAULT_BUDGET);
        let look = look_at(source, all.clone(), budget, progress)?;
        let frame = source.frame().clone();
        Self::by_look(&frame, options, look, &mut |low, high| count(source, (all.clone(), low, high), budget, progress))
    }

    /// The survey where a transfer function is given that does not go by the values, so that nothing is read.
    ///
    /// # Errors
    /// If the volume is broken.
    pub fn without_values(frame: &Volume, options: &VolumeOptions) -> Result<Option<Self>, VoxelizeError> {
        frame.validate_lattice().map_err(VolumeError::BadVolume)?;
        let given = options.transfer.as_ref().filter(|transfer| !transfer.goes_by_values());
        Ok(given.map(|transfer| {
            let mut transfer = transfer.clone();
            // It does not look at them.
            transfer.resolve(&ValueStatistics::at_first(&Look::default(), frame), options.threshold);
            Self { seen: None, transfer }
        }))
    }

    /// The survey of what all samples say; `binned` counts them in bins from its first to its second argument, where it is asked.
    fn by_look(
        frame: &Volume,
        options: &VolumeOptions,
        look: Look,
        binned: &mut dyn FnMut(f32, f32) -> Result<Vec<u64>, VoxelizeError>,
    ) -> Result<Self, VoxelizeError> {
        let mut values = ValueStatistics::at_first(&look, frame);
        let mut transfer = options.transfer.clone().unwrap_or_else(|| Transfer::automatic(&values));
        if transfer.is_relative() {
            values.measure_scale(&look, binned)?;
        }
        transfer.resolve(&values, options.threshold);
        Ok(Self { seen: Some((values, look)), transfer })
    }

    /// What some layers of samples say, for [`Self::of_looks`]: bytes.
    ///
    /// # Errors
    /// If they cannot be read; also if it was cancelled.
    pub fn look(
        source: &mut dyn SampleSource,
        layers: Range<usize>,
        memory_budget: Option<u64>,
        progress: &VoxelizeProgress,
    ) -> Result<Vec<u8>, VoxelizeError> {
        let look = look_at(source, layers, memory_budget.unwrap_or(DEFAULT_BUDGET), progress)?;
        let mut out = FieldWriter::new(LOOK);
        look.write(&mut out);
        Ok(out.finish())
    }

    /// How many of some layers' samples are in each bin, for the second argument of [`Self::of_looks`].
    ///
    /// # Errors
    /// As [`Self::look`].
    pub fn count(
        source: &mut dyn SampleSource,
        (layers, low, high): (Range<usize>, f32, f32),
        memory_budget: Option<u64>,
        progress: &VoxelizeProgress,
    ) -> Result<Vec<u64>, VoxelizeError> {
        count(source, (layers, low, high), memory_budget.unwrap_or(DEFAULT_BUDGET), progress)
    }

    /// The survey of all layers that several processes have looked at. `binned` is what [`Self::count`] gives of all of them together.
    ///
    /// # Errors
    /// If the volume is broken, or what was found is damaged; what `binned` says.
    pub fn of_looks<'a>(
        frame: &Volume,
        options: &VolumeOptions,
        looks: impl IntoIterator<Item = &'a [u8]>,
        binned: &mut dyn FnMut(f32, f32) -> Result<Vec<u64>, VoxelizeError>,
    ) -> Result<Self, VoxelizeError> {
        if let Some(known) = Self::without_values(frame, options)? {
            return Ok(known);
        }
        let damaged = || VoxelizeError::Parts("no look at samples of this version, or damaged".into());
        let mut all = Look::default();
        for bytes in looks {
            let look = FieldReader::open(bytes, LOOK).and_then(|mut from| Look::read(&mut from));
            all = all.and(look.ok_or_else(damaged)?);
        }
        Self::by_look(frame, options, all, binned)
    }

    /// The survey as bytes, for who has the same frame and options.
    pub fn to_bytes(&self) -> Vec<u8> {
        let mut out = FieldWriter::new(SURVEY);
        out.value(u8::from(self.seen.is_some()));
        if let Some((values, look)) = &self.seen {
            out.value([values.bright, values.threshold]);
            look.write(&mut out);
        }
        out.finish()
    }

    /// The survey of such bytes.
    ///
    /// # Errors
    /// If they are none, or damaged, or the volume is broken.
    pub fn from_bytes(bytes: &[u8], frame: &Volume, options: &VolumeOptions) -> Result<Self, VoxelizeError> {
        if let Some(known) = Self::without_values(frame, options)? {
            return Ok(known);
        }
        let read = || {
            let mut from = FieldReader::open(bytes, SURVEY)?;
            let scale: Option<[f32; 2]> = if from.value::<u8>()? > 0 { Some(from.value()?) } else { None };
            scale.zip(Look::read(&mut from))
        };
        let damaged = || VoxelizeError::Parts("no survey of this volume, or damaged".into());
        let ([bright, threshold], look) = read().ok_or_else(damaged)?;
        let values = ValueStatistics { bright, threshold, ..ValueStatistics::at_first(&look, frame) };
        let mut transfer = options.transfer.clone().unwrap_or_else(|| Transfer::automatic(&values));
        transfer.resolve(&values, options.threshold);
        Ok(Self { seen: Some((values, look)), transfer })
    }

    /// Statistics of the values, once all were read; their scale was measured only where the transfer function goes by it.
    pub fn values(&self) -> Option<&ValueStatistics> {
        self.seen.as_ref().map(|(values, _)| values)
    }

    /// The transfer function, resolved.
    pub fn transfer(&self) -> &Transfer {
        &self.transfer
    }

    /// Shows what is at least [`super::super::threshold_of_voxels`] of a volume of which nothing was to be seen, and returns it; `None`, and
    /// nothing else is shown, where the options choose what is.
    ///
    /// # Errors
    /// If the volume cannot be read; also if it was cancelled.
    pub fn lower(
        &mut self,
        source: &mut dyn SampleSource,
        options: &VolumeOptions,
        memory_budget: Option<u64>,
        progress: &VoxelizeProgress,
    ) -> Result<Option<f32>, VoxelizeError> {
        let is_chosen = options.transfer.is_some() || options.threshold.is_some();
        let Some((values, _)) = self.seen.as_ref().filter(|_| !is_chosen) else { return Ok(None) };
        let placement = Placement::of(source.frame(), options.scale, u64::MAX, false)?;
        let budget = memory_budget.unwrap_or(DEFAULT_BUDGET);
        let threshold = threshold::of_voxels(source, &placement, budget, progress)?;
        let mut transfer = Transfer::automatic(values);
        transfer.resolve(values, Some(threshold));
        self.transfer = transfer;
        Ok(Some(threshold))
    }

    /// The share of samples with at least so much, where all were counted.
    pub fn share_from(&self, low: f32) -> Option<f64> {
        self.seen.as_ref().and_then(|(_, look)| look.share_from(low))
    }

    /// Takes what all samples say.
    pub(super) fn learn(&mut self, look: Look, frame: &Volume) {
        self.seen = Some((ValueStatistics::at_first(&look, frame), look));
    }

    /// As [`Self::values`]; reads all samples where that was not done yet.
    pub(super) fn values_of(
        &mut self,
        source: &mut dyn SampleSource,
        budget: u64,
        progress: &VoxelizeProgress,
    ) -> Result<ValueStatistics, VoxelizeError> {
        if self.seen.is_none() {
            let all = 0..source.frame().size[2];
            let look = look_at(source, all, budget, progress)?;
            self.learn(look, source.frame());
        }
        let unknown = || ValueStatistics::at_first(&Look::default(), source.frame());
        Ok(self.values().cloned().unwrap_or_else(unknown))
    }

    pub(super) fn placement(&self, frame: &Volume, options: &VolumeOptions) -> Result<Placement, VolumeError> {
        // Empty voxels take no memory here.
        Placement::of(frame, options.scale, u64::MAX, self.transfer.is_labels())
    }

    /// Voxels along each axis of the grid, empty ones included, and the edge of one in the volume's unit.
    ///
    /// # Errors
    /// If there is no grid for the volume.
    pub fn grid(&self, frame: &Volume, options: &VolumeOptions) -> Result<([u64; 3], f64), VolumeError> {
        let placement = self.placement(frame, options)?;
        Ok((std::array::from_fn(|axis| placement.axes[axis].count() as u64), placement.voxel_size))
    }
}

/// What some layers of samples say.
fn look_at(
    source: &mut dyn SampleSource,
    layers: Range<usize>,
    budget: u64,
    progress: &VoxelizeProgress,
) -> Result<Look, VoxelizeError> {
    let [width, rows, _] = source.frame().size;
    progress.begin(width as u64 * rows as u64 * layers.len() as u64);
    let coding: Coding = source.coding();
    let mut tally = Tally::new(&coding);
    for_each(source, layers, budget, progress, &mut |block| tally.add(block, 0))?;
    Ok(tally.look())
}

/// Counts some layers of samples in bins.
fn count(
    source: &mut dyn SampleSource,
    (layers, low, high): (Range<usize>, f32, f32),
    budget: u64,
    progress: &VoxelizeProgress,
) -> Result<Vec<u64>, VoxelizeError> {
    let coding = source.coding();
    let mut counts = binned(&[], low, high);
    let mut tally = Tally::new(&coding);
    for_each(source, layers, budget, progress, &mut |block| match block {
        Block::Reals(values) => counts = sum(std::mem::take(&mut counts), binned(values, low, high)),
        codes => tally.add(codes, 0),
    })?;
    // All codes are counted, whatever they stand for.
    let codes = tally.look();
    Ok(match codes.binned(low, high).filter(|_| !matches!(coding, Coding::Reals)) {
        Some(of_codes) => sum(counts, of_codes),
        None => counts,
    })
}

/// Hands out samples of some layers, as many rows at a time as the budget holds.
fn for_each(
    source: &mut dyn SampleSource,
    layers: Range<usize>,
    budget: u64,
    progress: &VoxelizeProgress,
    each: &mut dyn FnMut(&Block),
) -> Result<(), VoxelizeError> {
    let [width, rows, _] = source.frame().size;
    let bytes_of_row = width as u64 * source.coding().bytes() * ON_THE_WAY + source.bytes_of_row();
    let most = rows_within(budget / 2, bytes_of_row).min(rows);
    for first in (0..rows).step_by(most) {
        let some = first..(first + most).min(rows);
        ahead(source, layers.clone().collect(), some, |ahead| {
            for _ in layers.clone() {
                if progress.is_cancelled() {
                    return Err(VoxelizeError::Cancelled);
                }
                let (_, block) = ahead.next()?;
                each(&block);
                progress.add(block.len() as u64);
                ahead.give_back(block);
            }
            Ok(())
        })?;
    }
    Ok(())
}
