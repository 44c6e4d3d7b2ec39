//! Out-of-core voxelization of volumes larger than memory. Samples stay in their file, from which layers of them are read one after
//! the other: once for what values there are, where the transfer function goes by them, and once for the voxels. Where layers are
//! large, the work is cut into stripes of rows. Several processes may voxelize layers of bricks each (`shares`). The scene in the file that comes of it is the one of the same volume in memory, bit for bit.

mod across;
mod ahead;
mod block;
mod bricks;
mod classes;
mod rows;
mod seen;
mod shares;
mod stripes;
mod survey;
mod tally;
mod threshold;

pub use block::{Block, Coding};
pub use shares::{layers_of_bricks, merge_volume_parts, voxelize_volume_part};
pub use survey::Survey;

use super::resample::Axis;
use super::transfer::Lookup;
use super::{Placement, ValueStatistics, Volume, VolumeError, VolumeOptions};
use crate::import_error::ImportError;
use crate::limits::Limits;
use crate::voxelize::{
    SpillBuffer, SpilledBricks, Step, VoxelizeError, VoxelizeProgress, Written, check_limits, of_description,
    with_spill,
};
use ahead::ahead;
use bricks::bricks_of;
use classes::Classes;
use seen::{Feed, Window};
use std::ops::Range;
use std::path::Path;
use stripes::{Stripe, stripes_of};
use tally::Tally;
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

    /// What its samples are.
    fn coding(&self) -> Coding {
        Coding::Reals
    }

    /// Reads the samples of some rows of a layer, as [`Volume::values`] has them, into a block of [`Self::coding`] that has room for just
    /// these. Layers are read in ascending order, and from the first one on again; only then is it cheap.
    ///
    /// # Errors
    /// If the file is damaged or cannot be read.
    fn read(&mut self, layer: usize, rows: Range<usize>, block: &mut Block) -> Result<(), ImportError>;
}

/// Voxelizes a volume that is read layer by layer straight into a native file, which holds the scene of [`super::voxelize`], packed.
/// `stamp` changes when the file does; it decides whether a checkpoint may be resumed. Overlays and colours of samples are left out. A survey
/// that read nothing knows what values there are once all samples were read for their voxels.
///
/// # Errors
/// If nothing is to be seen, there are more voxels than the limits allow, or a file cannot be read or written; also if it was cancelled.
pub fn voxelize_large_volume_to_file(
    (source, stamp): (&mut dyn SampleSource, &str),
    survey: &mut Survey,
    (options, memory_budget): (&VolumeOptions, Option<u64>),
    limits: &Limits,
    path: &Path,
    progress: &VoxelizeProgress,
) -> Result<Written, VoxelizeError> {
    let frame = source.frame().clone();
    let placement = survey.placement(&frame, options)?;
    let (lookup, coding) = (survey.transfer().lookup(), source.coding());
    let budget = memory_budget.unwrap_or(DEFAULT_BUDGET);
    let axes = placement.axes_of_lattice();
    let stripes = stripes_of([frame.size[0] as u64 * coding.bytes(), source.bytes_of_row()], &axes, budget);
    let about = (stamp, &frame, survey.values(), survey.transfer(), options.scale, options.shell, memory_budget);
    let key = of_description(&(about, &stripes));
    with_spill(Some(key), path, progress, |spill| {
        let classes = Classes::new(&lookup, &coding);
        let work = Work {
            shell: options.shell && lookup.is_opaque(),
            placement: &placement,
            axes,
            classes: &classes,
            coding: &coding,
            limits,
        };
        work.run((source, &stripes), survey, spill, progress)?;
        if spill.voxels() == 0 {
            let values = survey.values_of(source, budget, progress)?;
            return Err(nothing_seen(survey, Some(&values)));
        }
        let scene = scene_of(&frame, &placement, &lookup);
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

/// The error where nothing is to be seen of a volume of these values, as far as they are known.
fn nothing_seen(survey: &Survey, values: Option<&ValueStatistics>) -> VoxelizeError {
    let (lowest, highest) = values.map_or((0.0, 0.0), |values| (values.lowest, values.highest));
    let (transfer, shown) = (survey.transfer().name.clone(), survey.transfer().shown());
    VolumeError::Empty { lowest, highest, transfer, shown }.into()
}

/// Layers of bricks.
fn layers_of(axes: &[&Axis; 3]) -> usize {
    axes[2].count().div_ceil(super::slab::EDGE)
}

/// The scene of a volume without its bricks.
fn scene_of(frame: &Volume, placement: &Placement, lookup: &Lookup) -> Scene {
    let materials = lookup.colors().iter().map(|look| look.material()).collect();
    let mut scene = Scene { materials, ..Scene::new(frame.name.clone()) };
    (scene.voxel_size, scene.unit) = (placement.voxel_size, frame.unit);
    scene.georeference = Some(placement.georeference.clone());
    scene
}

/// What all stripes share.
struct Work<'a> {
    placement: &'a Placement,
    axes: [&'a Axis; 3],
    classes: &'a Classes<'a>,
    coding: &'a Coding,
    shell: bool,
    limits: &'a Limits,
}

impl Work<'_> {
    /// Layers of bricks.
    fn layers(&self) -> usize {
        layers_of(&self.axes)
    }

    /// Makes the bricks stripe after stripe, and within each one layer of bricks after the other as the layers of samples come.
    fn run(
        &self,
        (source, stripes): (&mut dyn SampleSource, &[Stripe]),
        survey: &mut Survey,
        spill: &mut SpillBuffer,
        progress: &VoxelizeProgress,
    ) -> Result<(), VoxelizeError> {
        spill.resume_settled(progress)?;
        progress.begin((stripes.len() * self.layers()) as u64);
        // What was resumed was not read.
        let mut tally = (survey.values().is_none() && spill.is_new()).then(|| Tally::new(self.coding));
        let (mut counted, mut rows) = (0u64, 0);
        for (part, stripe) in stripes.iter().enumerate() {
            let first = rows.max(stripe.samples.start) - stripe.samples.start;
            let fresh = stripe.samples.len().saturating_sub(first);
            let wide = source.frame().size[0];
            let tally = tally.as_mut().map(|tally| (tally, first * wide));
            let all = (part as u32, 0..self.layers());
            let read = self.stripe(all, stripe, (source, tally), spill, progress)?;
            counted += (fresh * read * wide) as u64;
            rows = stripe.samples.end;
        }
        let all = source.frame().size.iter().map(|&size| size as u64).product();
        if let Some(tally) = tally.filter(|_| counted == all) {
            survey.learn(tally.look(), source.frame());
        }
        Ok(())
    }

    /// Makes the bricks of some layers of a stripe, which count in the order of the samples; returns how many layers of samples were read for them.
    fn stripe(
        &self,
        (part, batches): (u32, Range<usize>),
        stripe: &Stripe,
        (source, tally): (&mut dyn SampleSource, Option<(&mut Tally, usize)>),
        spill: &mut SpillBuffer,
        progress: &VoxelizeProgress,
    ) -> Result<usize, VoxelizeError> {
        let wide = source.frame().size[0];
        let mut window = Window::new(self.axes, (stripe.clone(), wide), self.classes, self.coding);
        let layers = self.layers();
        let step = |batch: usize| Step { part, batch: batch as u32 };
        let done = batches.clone().take_while(|&batch| spill.has(step(batch))).count();
        progress.add(done as u64);
        let batches = batches.start + done..batches.end;
        if batches.is_empty() {
            return Ok(0);
        }
        // In the order of the samples, which the grid may have backwards.
        let is_backward = window.is_backward();
        let layer = |batch: usize| if is_backward { layers - 1 - batch } else { batch };
        let needed = window.needed(layer(batches.start), layer(batches.end - 1));
        let count = needed.len();
        ahead(source, needed, stripe.samples.clone(), |ahead| {
            let mut feed = Feed { ahead, tally };
            for batch in batches {
                window.move_to(layer(batch), &mut feed, progress)?;
                let world = self.placement.world_of_lattice();
                spill.push(step(batch), bricks_of(&window, layer(batch), world, self.shell))?;
                check_limits(spill, self.limits, progress)?;
                progress.add(1);
            }
            Ok(count)
        })
    }
}

#[cfg(test)]
mod tests;
