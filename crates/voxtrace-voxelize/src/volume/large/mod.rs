//! Out-of-core voxelization of volumes larger than memory. Samples stay in their file, from which layers of them are read one after
//! the other: once for the range of the values, where needed again for their histogram, and once for the voxels. Where layers are
//! large, the work is cut into stripes of rows. The scene in the file that comes of it is the one of the same volume in memory, bit for bit.

mod bricks;
mod seen;
mod stripes;
mod threshold;

use super::statistics::{Look, binned, sum};
use super::transfer::Lookup;
use super::{Placement, Transfer, ValueStatistics, Volume, VolumeError, VolumeOptions};
use crate::import_error::ImportError;
use crate::limits::Limits;
use crate::voxelize::{
    SpillBuffer, SpilledBricks, Step, VoxelizeError, VoxelizeProgress, Written, check_limits, of_description,
    with_spill,
};
use bricks::bricks_of;
use seen::Window;
use std::ops::Range;
use std::path::Path;
use stripes::{Stripe, rows_within, stripes_of};
use voxtrace_scene::scene::Scene;

/// Memory to work in where nobody says how much.
const DEFAULT_BUDGET: u64 = 1 << 30;

/// A volume whose samples stay in their file.
pub trait SampleSource: Send {
    /// The volume without its samples.
    fn frame(&self) -> &Volume;

    /// As [`Self::frame`], to be named and placed.
    fn frame_mut(&mut self) -> &mut Volume;

    /// Bytes that the source keeps for each row of samples while layers are read one after the other.
    fn bytes_of_row(&self) -> u64 {
        0
    }

    /// Reads the samples of some rows of a layer, as [`Volume::values`] has them. Layers are read in ascending order, and from the first one
    /// on again; only then is it cheap.
    ///
    /// # Errors
    /// If the file is damaged or cannot be read.
    fn read(&mut self, layer: usize, rows: Range<usize>, values: &mut [f32]) -> Result<(), ImportError>;
}

/// What was learned by reading all samples.
#[derive(Clone, Debug)]
pub struct Survey {
    values: ValueStatistics,
    look: Look,
    /// The transfer function, resolved.
    transfer: Transfer,
}

impl Survey {
    /// Reads all samples once, and twice more where the transfer function goes by a scale that they have not been counted for.
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
        progress.begin(source.frame().size.iter().map(|&size| size as u64).product());
        let mut look = Look::default();
        for_each(source, budget, progress, &mut |values| look.add(values))?;
        let mut values = ValueStatistics::at_first(&look, source.frame());
        let mut transfer = options.transfer.clone().unwrap_or_else(|| Transfer::automatic(&values));
        if transfer.is_relative() {
            let frame_values = |low: f32, high: f32| {
                let mut counts = binned(&[], low, high);
                for_each(source, budget, progress, &mut |values| {
                    counts = sum(std::mem::take(&mut counts), binned(values, low, high));
                })?;
                Ok::<_, VoxelizeError>(counts)
            };
            values.measure_scale(&look, &mut { frame_values })?;
        }
        transfer.resolve(&values, options.threshold);
        Ok(Self { values, look, transfer })
    }

    /// Statistics of the values; their scale was measured only where the transfer function goes by it.
    pub fn values(&self) -> &ValueStatistics {
        &self.values
    }

    /// The transfer function, resolved.
    pub fn transfer(&self) -> &Transfer {
        &self.transfer
    }

    /// Shows what is at least [`super::threshold_of_voxels`], which it returns, of a volume of which nothing was to be seen.
    ///
    /// # Errors
    /// If the volume cannot be read; also if it was cancelled.
    pub fn lower(
        &mut self,
        source: &mut dyn SampleSource,
        options: &VolumeOptions,
        memory_budget: Option<u64>,
        progress: &VoxelizeProgress,
    ) -> Result<f32, VoxelizeError> {
        let placement = Placement::of(source.frame(), options.scale, u64::MAX, false)?;
        let budget = memory_budget.unwrap_or(DEFAULT_BUDGET);
        let threshold = threshold::of_voxels(source, &placement, budget, progress)?;
        let mut transfer = Transfer::automatic(&self.values);
        transfer.resolve(&self.values, Some(threshold));
        self.transfer = transfer;
        Ok(threshold)
    }

    /// The share of samples with at least so much, where all are whole numbers.
    pub fn share_from(&self, low: f32) -> Option<f64> {
        self.look.share_from(low)
    }

    fn placement(&self, frame: &Volume, options: &VolumeOptions) -> Result<Placement, VolumeError> {
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

/// Hands out all samples, as many rows at a time as the budget holds.
fn for_each(
    source: &mut dyn SampleSource,
    budget: u64,
    progress: &VoxelizeProgress,
    each: &mut dyn FnMut(&[f32]),
) -> Result<(), VoxelizeError> {
    let [width, rows, layers] = source.frame().size;
    let most = rows_within(budget / 2, width as u64 * 12 + source.bytes_of_row()).min(rows);
    let mut values = Vec::new();
    for first in (0..rows).step_by(most) {
        let some = first..(first + most).min(rows);
        values.resize(some.len() * width, 0.0);
        for layer in 0..layers {
            if progress.is_cancelled() {
                return Err(VoxelizeError::Cancelled);
            }
            source.read(layer, some.clone(), &mut values)?;
            each(&values);
            progress.add(values.len() as u64);
        }
    }
    Ok(())
}

/// Voxelizes a volume that is read layer by layer straight into a native file, which holds the scene of [`super::voxelize`], packed.
/// `stamp` changes when the file does; it decides whether a checkpoint may be resumed. Overlays and colours of samples are left out.
///
/// # Errors
/// If nothing is to be seen, there are more voxels than the limits allow, or a file cannot be read or written; also if it was cancelled.
pub fn voxelize_large_volume_to_file(
    (source, stamp): (&mut dyn SampleSource, &str),
    survey: &Survey,
    (options, memory_budget): (&VolumeOptions, Option<u64>),
    limits: &Limits,
    path: &Path,
    progress: &VoxelizeProgress,
) -> Result<Written, VoxelizeError> {
    let frame = source.frame().clone();
    let placement = survey.placement(&frame, options)?;
    let lookup = survey.transfer.lookup();
    let about = (stamp, &frame, &survey.values, &survey.transfer, options.scale, options.shell, memory_budget);
    let key = of_description(&about);
    let budget = memory_budget.unwrap_or(DEFAULT_BUDGET);
    with_spill(Some(key), path, progress, |spill| {
        let work = Work { placement: &placement, lookup: &lookup, shell: options.shell && lookup.is_opaque(), limits };
        work.run(source, budget, spill, progress)?;
        let transfer = &survey.transfer;
        if spill.voxels() == 0 {
            let (lowest, highest) = (survey.values.lowest, survey.values.highest);
            let (transfer, shown) = (transfer.name.clone(), transfer.shown());
            return Err(VolumeError::Empty { lowest, highest, transfer, shown }.into());
        }
        let materials = lookup.colors().iter().map(|look| look.material()).collect();
        let mut scene = Scene { materials, ..Scene::new(frame.name.clone()) };
        (scene.voxel_size, scene.unit) = (placement.voxel_size, frame.unit);
        scene.georeference = Some(placement.georeference.clone());
        let written = Written { voxels: spill.voxels(), materials: scene.materials.len(), is_exact: true };
        let bricks = SpilledBricks {
            spill,
            material: |key, _| key as u16,
            world_from_grid: placement.world_from_grid,
            progress,
        };
        bricks.save(path, &scene).map(|()| written)
    })
}

/// What all stripes share.
struct Work<'a> {
    placement: &'a Placement,
    lookup: &'a Lookup,
    shell: bool,
    limits: &'a Limits,
}

impl Work<'_> {
    /// Makes the bricks stripe after stripe, and within each one layer of bricks after the other as the layers of samples come.
    fn run(
        &self,
        source: &mut dyn SampleSource,
        budget: u64,
        spill: &mut SpillBuffer,
        progress: &VoxelizeProgress,
    ) -> Result<(), VoxelizeError> {
        let axes = self.placement.axes_of_lattice();
        let stripes = stripes_of(source.frame().size[0], source.bytes_of_row(), &axes, budget);
        let layers = axes[2].count().div_ceil(super::slab::EDGE);
        spill.resume_settled(progress)?;
        progress.begin((stripes.len() * layers) as u64);
        for (part, stripe) in stripes.into_iter().enumerate() {
            self.stripe(&axes, part as u32, stripe, source, spill, progress)?;
        }
        Ok(())
    }

    fn stripe(
        &self,
        axes: &[&super::resample::Axis; 3],
        part: u32,
        stripe: Stripe,
        source: &mut dyn SampleSource,
        spill: &mut SpillBuffer,
        progress: &VoxelizeProgress,
    ) -> Result<(), VoxelizeError> {
        let mut window = Window::new(*axes, stripe, self.lookup);
        let layers = axes[2].count().div_ceil(super::slab::EDGE);
        for batch in 0..layers {
            let step = Step { part, batch: batch as u32 };
            if !spill.has(step) {
                // In the order of the samples, which the grid may have backwards.
                let layer = if window.is_backward() { layers - 1 - batch } else { batch };
                window.move_to(layer, source, progress)?;
                let world = self.placement.world_of_lattice();
                spill.push(step, bricks_of(&window, layer, world, self.shell))?;
            }
            check_limits(spill, self.limits, progress)?;
            progress.add(1);
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests;
