//! From triangles to voxels: the tiles that triangles reach into are worked through in parallel, and their bricks go to the
//! spool in an order that no thread changes.

use super::bins::{self, TILE, Tiles};
use super::census::Census;
use super::fill::Column;
use super::paint::Paints;
use super::palette::Palette;
use super::part::Step;
use super::spool::Spool;
use super::tile::{Job, Scratch};
use super::{
    Placement, Run, VoxelizeError, VoxelizeOptions, VoxelizeProgress, bands, check_on, material_count, pairs_within,
    tiles_of,
};
use crate::limits::Limits;
use crate::mesh::Mesh;
use glam::IVec3;
use rayon::prelude::*;
use std::ops::Range;

/// Works through all tiles of a mesh and leaves their bricks in the spool.
pub(super) fn run(
    mesh: &Mesh,
    options: &VoxelizeOptions,
    limits: &Limits,
    spool: &mut Spool,
    progress: &VoxelizeProgress,
) -> Result<Run, VoxelizeError> {
    mesh.validate().map_err(VoxelizeError::BadMesh)?;
    let placement = Placement::of(mesh, options.scale)?;
    let tiles = tiles_of(&placement)?;
    let (paints, census) = (Paints::of(mesh), Census::default());
    let job = Job { mesh, placement: &placement, paints: &paints, rule: options.rule, census: &census };
    spool.resume(&census, progress)?;
    if options.fill {
        let mut pairs = bins::pairs_of(mesh, &placement, &tiles, &(0..tiles.layers()));
        progress.begin(pairs.len() as u64);
        run_columns(&job, &tiles, &mut pairs, spool, limits, progress)?;
    }
    let (bands, total) = match options.memory_budget {
        _ if options.fill => (Vec::new(), None),
        None => (vec![(0..tiles.layers(), None)], None),
        Some(budget) => {
            let by_layer = bins::pairs_by_layer(mesh, &placement, &tiles);
            let sum = |layers: &Range<usize>| by_layer[layers.clone()].iter().sum::<u64>();
            let bands = bands(&by_layer, pairs_within(budget, mesh.size_bytes()));
            (
                bands.into_iter().map(|layers| (layers.clone(), Some(sum(&layers)))).collect(),
                Some(by_layer.iter().sum()),
            )
        }
    };
    for (part, (layers, announced)) in bands.into_iter().enumerate() {
        let pairs = bins::pairs_of(mesh, &placement, &tiles, &layers);
        let announced = announced.unwrap_or(pairs.len() as u64);
        progress.begin(total.unwrap_or(announced));
        run_band(&job, &tiles, &pairs, part as u32, announced, spool, limits, progress)?;
    }
    if spool.brick_count() == 0 {
        return Err(VoxelizeError::Empty);
    }
    let palette = Palette::of(&census, &paints.classes, material_count(options), options.dither);
    Ok(Run { placement, palette })
}

/// Works through the columns of tiles of the pairs, the insides included.
fn run_columns(
    job: &Job,
    tiles: &Tiles,
    pairs: &mut [u64],
    spool: &mut Spool,
    limits: &Limits,
    progress: &VoxelizeProgress,
) -> Result<(), VoxelizeError> {
    /// Columns that are done before their bricks go to the spool.
    const BATCH: usize = 16;
    let place = |pair: &u64| tiles.tile((pair >> 32) as u32);
    pairs.par_sort_by_key(|pair| {
        let tile = place(pair);
        (tile.y, tile.x, tile.z, *pair as u32)
    });
    let columns: Vec<&[u64]> = pairs.chunk_by(|a, b| place(a).truncate() == place(b).truncate()).collect();
    for (number, batch) in columns.chunks(BATCH).enumerate() {
        let step = Step { part: 0, batch: number as u32 };
        if spool.has(step) {
            progress.add(batch.iter().map(|pairs| pairs.len() as u64).sum());
            continue;
        }
        let work = |scratch: &mut Scratch, pairs: &&[u64]| {
            let mut triangles: Vec<usize> = pairs.iter().map(|&pair| pair as u32 as usize).collect();
            triangles.sort_unstable();
            triangles.dedup();
            let first = place(&pairs[0]);
            let column = Column::of(job.mesh, job.placement, first, &triangles);
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
        spool.push(step, records.into_iter().flatten().collect())?;
        check_on(spool, limits, progress)?;
        progress.add(batch.iter().map(|pairs| pairs.len() as u64).sum());
    }
    Ok(())
}

/// Works through the tiles of sorted pairs, one part of the work.
#[expect(clippy::too_many_arguments, reason = "each is another thing")]
pub(super) fn run_band(
    job: &Job,
    tiles: &Tiles,
    pairs: &[u64],
    part: u32,
    announced: u64,
    spool: &mut Spool,
    limits: &Limits,
    progress: &VoxelizeProgress,
) -> Result<(), VoxelizeError> {
    /// Tiles that are done before their bricks go to the spool.
    const BATCH: usize = 256;
    let tile_of = |pair: &u64| (pair >> 32) as u32;
    let parts: Vec<&[u64]> = pairs.chunk_by(|a, b| tile_of(a) == tile_of(b)).collect();
    let mut told = 0;
    for (number, batch) in parts.chunks(BATCH).enumerate() {
        let step = Step { part, batch: number as u32 };
        if !spool.has(step) {
            let work = |scratch: &mut Scratch, pairs: &&[u64]| {
                let triangles = pairs.iter().map(|&pair| pair as u32 as usize);
                job.tile(tiles.tile(tile_of(&pairs[0])), triangles, None, scratch)
            };
            let records: Vec<_> = batch.par_iter().with_max_len(4).map_init(Scratch::new, work).collect();
            spool.push(step, records)?;
        }
        check_on(spool, limits, progress)?;
        let done = batch.iter().map(|pairs| pairs.len() as u64).sum::<u64>().min(announced - told);
        told += done;
        progress.add(done);
    }
    // Announced was an upper bound.
    progress.add(announced - told);
    Ok(())
}
