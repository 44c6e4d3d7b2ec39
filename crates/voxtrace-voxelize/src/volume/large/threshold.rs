//! Otsu's threshold of the values that voxels have, layer by layer: what [`super::super::threshold_of_voxels`] finds in memory.

use super::super::slab::EDGE;
use super::super::statistics::{Look, binned, sum};
use super::super::{Placement, Preset, ValueStatistics, Volume};
use super::SampleSource;
use super::ahead::ahead;
use super::classes::Classes;
use super::seen::{Feed, Window};
use super::stripes::stripes_of;
use crate::voxelize::{VoxelizeError, VoxelizeProgress};

/// Goes through all voxels once, and twice more where their values are not whole numbers.
pub(super) fn of_voxels(
    source: &mut dyn SampleSource,
    placement: &Placement,
    budget: u64,
    progress: &VoxelizeProgress,
) -> Result<f32, VoxelizeError> {
    let mut look = Look::default();
    for_each_voxel(source, placement, budget, progress, &mut |values| look.add(values, &|| true))?;
    let mut values = ValueStatistics::at_first(&look, &Volume::new([1; 3], Vec::new()));
    values.measure_scale(&look, &mut |low, high| {
        let mut counts = binned(&[], low, high);
        for_each_voxel(source, placement, budget, progress, &mut |values| {
            counts = sum(std::mem::take(&mut counts), binned(values, low, high));
        })?;
        Ok::<_, VoxelizeError>(counts)
    })?;
    Ok(values.threshold)
}

/// Hands out the values of all voxels, each once.
fn for_each_voxel(
    source: &mut dyn SampleSource,
    placement: &Placement,
    budget: u64,
    progress: &VoxelizeProgress,
    each: &mut dyn FnMut(&[f32]),
) -> Result<(), VoxelizeError> {
    let axes = placement.axes_of_lattice();
    let layers = axes[2].count();
    // Nobody asks what of them is seen.
    let (lookup, coding) = (Preset::Mri.transfer().lookup(), source.coding());
    let (classes, wide) = (Classes::new(&lookup, &coding), source.frame().size[0]);
    let stripes = stripes_of([wide as u64 * coding.bytes(), source.bytes_of_row()], &axes, budget);
    progress.begin((stripes.len() * layers) as u64);
    for stripe in stripes {
        let samples = stripe.samples.clone();
        let mut window = Window::new(axes, (stripe, wide), &classes, &coding);
        let is_backward = window.is_backward();
        // In the order of the samples, which the grid may have backwards.
        let at = |step: usize| if is_backward { layers - 1 - step } else { step };
        let needed = window.needed(at(0) / EDGE, at(layers - 1) / EDGE);
        ahead(source, needed, samples, |ahead| {
            let mut feed = Feed { ahead, tally: None };
            for step in 0..layers {
                if progress.is_cancelled() {
                    return Err(VoxelizeError::Cancelled);
                }
                each(window.own_values(at(step), &mut feed)?);
                progress.add(1);
            }
            Ok(())
        })?;
    }
    Ok(())
}
