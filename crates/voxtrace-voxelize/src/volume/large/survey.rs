//! What there is to know of a volume before its voxels are made: what values it has, where the transfer function goes by them. Others
//! need no look at the samples; what values there were is known when all have been read for their voxels.

use super::super::statistics::{Look, binned, sum};
use super::super::{Placement, Transfer, ValueStatistics, Volume, VolumeError, VolumeOptions};
use super::ahead::{ON_THE_WAY, ahead};
use super::stripes::rows_within;
use super::tally::Tally;
use super::threshold;
use super::{Block, Coding, DEFAULT_BUDGET, SampleSource};
use crate::voxelize::{VoxelizeError, VoxelizeProgress};

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
        source.frame().validate_lattice().map_err(VolumeError::BadVolume)?;
        let budget = memory_budget.unwrap_or(DEFAULT_BUDGET);
        if let Some(transfer) = options.transfer.as_ref().filter(|transfer| !transfer.goes_by_values()) {
            let mut transfer = transfer.clone();
            // It does not look at them.
            transfer.resolve(&ValueStatistics::at_first(&Look::default(), source.frame()), options.threshold);
            return Ok(Self { seen: None, transfer });
        }
        let look = look_at(source, budget, progress)?;
        let mut values = ValueStatistics::at_first(&look, source.frame());
        let mut transfer = options.transfer.clone().unwrap_or_else(|| Transfer::automatic(&values));
        if transfer.is_relative() {
            values.measure_scale(&look, &mut |low, high| {
                let mut counts = binned(&[], low, high);
                for_each(source, budget, progress, &mut |block| {
                    if let Block::Reals(values) = block {
                        counts = sum(std::mem::take(&mut counts), binned(values, low, high));
                    }
                })?;
                Ok::<_, VoxelizeError>(counts)
            })?;
        }
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
            let look = look_at(source, budget, progress)?;
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

/// What all samples say.
fn look_at(source: &mut dyn SampleSource, budget: u64, progress: &VoxelizeProgress) -> Result<Look, VoxelizeError> {
    progress.begin(source.frame().size.iter().map(|&size| size as u64).product());
    let coding: Coding = source.coding();
    let mut tally = Tally::new(&coding);
    for_each(source, budget, progress, &mut |block| tally.add(block, 0))?;
    Ok(tally.look())
}

/// Hands out all samples, as many rows at a time as the budget holds.
fn for_each(
    source: &mut dyn SampleSource,
    budget: u64,
    progress: &VoxelizeProgress,
    each: &mut dyn FnMut(&Block),
) -> Result<(), VoxelizeError> {
    let [width, rows, layers] = source.frame().size;
    let bytes_of_row = width as u64 * source.coding().bytes() * ON_THE_WAY + source.bytes_of_row();
    let most = rows_within(budget / 2, bytes_of_row).min(rows);
    for first in (0..rows).step_by(most) {
        let some = first..(first + most).min(rows);
        ahead(source, (0..layers).collect(), some, |ahead| {
            for _ in 0..layers {
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
