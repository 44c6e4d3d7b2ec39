//! Voxelizes a mesh: tiles are processed in parallel, and their bricks are appended to the spill buffer in an order that does
//! not depend on the threads.

use super::appearance::BsdfClass;
use super::binning::{self, TILE, TileGrid};
use super::checkpoint::Step;
use super::color_histogram::ColorHistogram;
use super::fill::Column;
use super::mesh_appearance::MeshAppearance;
use super::palette::Palette;
use super::spill::SpillBuffer;
use super::tile::{Scratch, TileJob};
use super::voxelized::Voxelized;
use super::{
    Placement, VoxelizeError, VoxelizeOptions, VoxelizeProgress, bands, check_limits, material_count, pairs_within,
    tile_grid,
};
use crate::limits::Limits;
use crate::mesh::Mesh;
use glam::IVec3;
use rayon::prelude::*;
use std::ops::Range;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

/// Voxelizes all tiles of a mesh into the spill buffer.
pub(super) fn run(
    mesh: &Mesh,
    options: &VoxelizeOptions,
    limits: &Limits,
    spill: &mut SpillBuffer,
    progress: &VoxelizeProgress,
) -> Result<Voxelized, VoxelizeError> {
    mesh.validate().map_err(VoxelizeError::BadMesh)?;
    let placement = Placement::of(mesh, options.scale)?;
    let (appearance, histogram) = (MeshAppearance::of(mesh), ColorHistogram::default());
    let job =
        TileJob { mesh, placement: &placement, appearance: &appearance, rule: options.rule, histogram: &histogram };
    spill.resume(&histogram, progress)?;
    run_tiles(&job, options, limits, spill, progress)?;
    if spill.brick_count() == 0 {
        return Err(VoxelizeError::Empty);
    }
    let classes = BsdfClass::in_voxels(&appearance.classes, placement.voxel_size);
    let palette = Palette::of(&histogram, &classes, material_count(options), options.dither);
    Ok(Voxelized { placement, palette })
}

/// Voxelizes all tiles of a job.
pub(super) fn run_tiles(
    job: &TileJob,
    options: &VoxelizeOptions,
    limits: &Limits,
    spill: &mut SpillBuffer,
    progress: &VoxelizeProgress,
) -> Result<(), VoxelizeError> {
    let (mesh, placement) = (job.mesh, job.placement);
    let before = progress.done();
    let tiles = tile_grid(placement)?;
    if options.fill {
        let mut pairs = binning::pairs_of(mesh, placement, &tiles, &(0..tiles.layers()));
        progress.begin(before + pairs.len() as u64);
        run_columns(job, &tiles, &mut pairs, spill, limits, progress)?;
    }
    let (bands, total) = match most_pairs(mesh, options) {
        _ if options.fill => (Vec::new(), None),
        None => (vec![(0..tiles.layers(), None)], None),
        Some(most) => {
            let by_layer = binning::pairs_by_layer(mesh, placement, &tiles);
            let sum = |layers: &Range<usize>| by_layer[layers.clone()].iter().sum::<u64>();
            let bands = bands(&by_layer, most);
            (
                bands.into_iter().map(|layers| (layers.clone(), Some(sum(&layers)))).collect(),
                Some(by_layer.iter().sum()),
            )
        }
    };
    for (part, (layers, announced)) in bands.into_iter().enumerate() {
        let pairs = binning::pairs_of(mesh, placement, &tiles, &layers);
        let announced = announced.unwrap_or(pairs.len() as u64);
        progress.begin(before + total.unwrap_or(announced));
        run_band(job, &tiles, &pairs, part as u32, announced, spill, limits, progress)?;
    }
    Ok(())
}

/// How many (tile, triangle) pairs there may be at once; `None` where there is no need to ask.
fn most_pairs(mesh: &Mesh, options: &VoxelizeOptions) -> Option<u64> {
    /// Triangles whose pairs are little beside what else there is.
    const FEW: usize = 1 << 24;
    /// Half a gigabyte, as two lists of them exist at once.
    const MANY: u64 = 1 << 25;
    match options.memory_budget {
        Some(budget) => Some(pairs_within(budget, mesh.size_bytes())),
        None => (mesh.triangle_count() > FEW).then_some(MANY),
    }
}

/// Voxelizes whole columns of tiles, interiors included.
fn run_columns(
    job: &TileJob,
    tiles: &TileGrid,
    pairs: &mut [u64],
    spill: &mut SpillBuffer,
    limits: &Limits,
    progress: &VoxelizeProgress,
) -> Result<(), VoxelizeError> {
    /// Columns processed before their bricks go to the spill buffer.
    const BATCH: usize = 16;
    let place = |pair: &u64| tiles.tile((pair >> 32) as u32);
    pairs.par_sort_by_key(|pair| {
        let tile = place(pair);
        (tile.y, tile.x, tile.z, *pair as u32)
    });
    let open_lines = AtomicU64::new(0);
    let columns: Vec<&[u64]> = pairs.chunk_by(|a, b| place(a).truncate() == place(b).truncate()).collect();
    for (number, batch) in columns.chunks(BATCH).enumerate() {
        let step = Step { part: 0, batch: number as u32 };
        if spill.has(step) {
            progress.add(batch.iter().map(|pairs| pairs.len() as u64).sum());
            continue;
        }
        let work = |scratch: &mut Scratch, pairs: &&[u64]| {
            let mut triangles: Vec<usize> = pairs.iter().map(|&pair| pair as u32 as usize).collect();
            triangles.sort_unstable();
            triangles.dedup();
            let first = place(&pairs[0]);
            let column = Column::of(job.mesh, job.placement, first, &triangles);
            open_lines.fetch_add(column.open_lines, Relaxed);
            let (low, high) = column
                .extent()
                .map_or((first.z, first.z), |(low, high)| (low.div_euclid(TILE), (high - 1).div_euclid(TILE)));
            let (low, high) = (low.min(first.z), high.max(place(&pairs[pairs.len() - 1]).z));
            let mut rest = *pairs;
            let tile = |z: i32| {
                let (own, after) = rest.split_at(rest.partition_point(|pair| place(pair).z <= z));
                rest = after;
                let triangles = own.iter().map(|&pair| pair as u32 as usize);
                job.tile(IVec3::new(first.x, first.y, z), triangles, Some(&column), scratch)
            };
            (low..=high).map(tile).collect::<Vec<_>>()
        };
        let records: Vec<Vec<_>> = batch.par_iter().with_max_len(1).map_init(Scratch::new, work).collect();
        spill.push(step, records.into_iter().flatten().collect())?;
        check_limits(spill, limits, progress)?;
        progress.add(batch.iter().map(|pairs| pairs.len() as u64).sum());
    }
    let open_lines = open_lines.into_inner();
    if open_lines > 0 {
        progress.note(format!(
            "{open_lines} upright lines of voxels meet a surface that is not closed: they are not filled"
        ));
    }
    Ok(())
}

/// Voxelizes the tiles of sorted (tile, triangle) pairs: one part of the work, counted as `announced` units of progress.
#[expect(clippy::too_many_arguments, reason = "each is another thing")]
pub(super) fn run_band(
    job: &TileJob,
    tiles: &TileGrid,
    pairs: &[u64],
    part: u32,
    announced: u64,
    spill: &mut SpillBuffer,
    limits: &Limits,
    progress: &VoxelizeProgress,
) -> Result<(), VoxelizeError> {
    /// Tiles processed before their bricks go to the spill buffer.
    const BATCH: usize = 256;
    let tile_of = |pair: &u64| (pair >> 32) as u32;
    let parts: Vec<&[u64]> = pairs.chunk_by(|a, b| tile_of(a) == tile_of(b)).collect();
    let mut told = 0;
    for (number, batch) in parts.chunks(BATCH).enumerate() {
        let step = Step { part, batch: number as u32 };
        if !spill.has(step) {
            let work = |scratch: &mut Scratch, pairs: &&[u64]| {
                let triangles = pairs.iter().map(|&pair| pair as u32 as usize);
                job.tile(tiles.tile(tile_of(&pairs[0])), triangles, None, scratch)
            };
            let records: Vec<_> = batch.par_iter().with_max_len(4).map_init(Scratch::new, work).collect();
            spill.push(step, records)?;
        }
        check_limits(spill, limits, progress)?;
        let done = batch.iter().map(|pairs| pairs.len() as u64).sum::<u64>().min(announced - told);
        told += done;
        progress.add(done);
    }
    // Announced was an upper bound.
    progress.add(announced - told);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;

    #[test]
    fn pairs_of_many_triangles_are_made_in_parts_also_without_a_budget() {
        let mesh =
            |count: usize| Mesh { positions: vec![Vec3::ZERO], triangles: vec![[0; 3]; count], ..Mesh::new("many") };
        let options = VoxelizeOptions::default();
        assert_eq!(most_pairs(&mesh(1 << 10), &options), None);
        assert_eq!(most_pairs(&mesh((1 << 24) + 1), &options), Some(1 << 25));
        let budget = VoxelizeOptions { memory_budget: Some(8 << 30), ..options };
        assert_eq!(most_pairs(&mesh(1 << 10), &budget), Some(pairs_within(8 << 30, mesh(1 << 10).size_bytes())));
    }
}
