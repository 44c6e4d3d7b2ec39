//! A volume that several processes voxelize, layers of bricks each: what each needs to know of all samples beforehand, a part by each of them, and the
//! scene that comes of all parts, which is that of one process. A brick is one part's, so that nothing is left to be finished.

use super::{
    DEFAULT_BUDGET, SampleSource, Survey, Work, classes::Classes, layers_of, nothing_seen, scene_of, stripes_of,
};
use crate::limits::Limits;
use crate::volume::{Volume, VolumeOptions};
use crate::voxelize::{
    ColorHistogram, SpillBuffer, SpilledBricks, VoxelizeError, VoxelizeProgress, Written, check_limits, of_description,
};
use std::ops::Range;
use std::path::{Path, PathBuf};
use voxtrace_core::atomic_file::TemporaryFile;

/// The work that parts are: what they are made with.
fn key_of(stamp: &str, frame: &Volume, survey: &Survey, options: &VolumeOptions) -> u128 {
    of_description(&(stamp, frame, survey.transfer(), options.scale, options.shell))
}

/// Layers of bricks of a volume, which are shared out by their numbers in the order of the samples.
///
/// # Errors
/// If there is no grid for the volume.
pub fn layers_of_bricks(frame: &Volume, survey: &Survey, options: &VolumeOptions) -> Result<usize, VoxelizeError> {
    Ok(layers_of(&survey.placement(frame, options)?.axes_of_lattice()))
}

/// Voxelizes some layers of bricks into the part `path`, which is there whole or not at all; returns the number of their voxels. `stamp` tells the samples from
/// others, whoever reads them.
///
/// # Errors
/// If there are no such layers, samples cannot be read, there are more voxels than the limits allow, the part cannot be written, or it was cancelled.
pub fn voxelize_volume_part(
    (source, stamp): (&mut dyn SampleSource, &str),
    survey: &Survey,
    layers: Range<usize>,
    (options, memory_budget): (&VolumeOptions, Option<u64>),
    limits: &Limits,
    path: &Path,
    progress: &VoxelizeProgress,
) -> Result<u64, VoxelizeError> {
    let frame = source.frame().clone();
    let placement = survey.placement(&frame, options)?;
    let axes = placement.axes_of_lattice();
    let count = layers_of(&axes);
    if layers.start >= layers.end || layers.end > count {
        let Range { start, end } = layers;
        return Err(VoxelizeError::Parts(format!("there are no layers {start}..{end} among {count}")));
    }
    let (lookup, coding) = (survey.transfer().lookup(), source.coding());
    let bytes_of_rows = [frame.size[0] as u64 * coding.bytes(), source.bytes_of_row()];
    let stripes = stripes_of(bytes_of_rows, &axes, memory_budget.unwrap_or(DEFAULT_BUDGET));
    let temporary = TemporaryFile::beside(path)?;
    let mut spill = SpillBuffer::of_part(temporary.try_clone()?, key_of(stamp, &frame, survey, options))?;
    let classes = Classes::new(&lookup, &coding);
    let shell = options.shell && lookup.is_opaque();
    let work = Work { placement: &placement, axes, classes: &classes, coding: &coding, shell, limits };
    progress.begin((stripes.len() * layers.len()) as u64);
    for (part, stripe) in stripes.iter().enumerate() {
        work.stripe((part as u32, layers.clone()), stripe, (source, None), &mut spill, progress)?;
    }
    spill.end_part(layers.start as u64..layers.end as u64)?;
    temporary.replace(path)?;
    Ok(spill.voxels())
}

/// Makes a native file of the parts of a volume, in any order: the bytes that [`super::voxelize_large_volume_to_file`] writes. No sample is read.
///
/// # Errors
/// If a part is missing, damaged or of other work, nothing is to be seen, there are more voxels than the limits allow, the file cannot be written, or it was
/// cancelled.
pub fn merge_volume_parts(
    (frame, stamp): (&Volume, &str),
    survey: &Survey,
    parts: &[PathBuf],
    options: &VolumeOptions,
    limits: &Limits,
    path: &Path,
    progress: &VoxelizeProgress,
) -> Result<Written, VoxelizeError> {
    let placement = survey.placement(frame, options)?;
    let work = (key_of(stamp, frame, survey, options), layers_of(&placement.axes_of_lattice()) as u64, "layers");
    // Materials are known: the histogram is not asked.
    let histogram = ColorHistogram::default();
    let mut spill = SpillBuffer::of_parts(parts, work, (&histogram, 1), path, progress)?;
    check_limits(&spill, limits, progress)?;
    if spill.voxels() == 0 {
        return Err(nothing_seen(survey, survey.values()));
    }
    let scene = scene_of(frame, &placement, &survey.transfer().lookup());
    let written = Written { voxels: spill.voxels(), materials: scene.materials.len(), is_exact: true };
    let world_from_grid = placement.world_from_grid;
    let bricks = SpilledBricks { spill: &mut spill, material: |key, _| key as u16, world_from_grid, progress };
    bricks.save(path, &scene).map(|()| written)
}
