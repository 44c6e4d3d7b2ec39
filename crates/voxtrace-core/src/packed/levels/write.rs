//! Writing a level of detail from the one below it, brick by brick: bricks and their materials, which are nearly all of it, are never in memory together.

use super::block::block_at;
use super::materials::{Kinds, Look, Materials, Rounding};
use super::window::{Traits, Window};
use crate::atomic_file::TemporaryFile;
use crate::packed::brick_record::encode_brick;
use crate::packed::coverage::{coverage_words, words_of};
use crate::packed::file::VERSION;
use crate::packed::instance_record::InstanceRecord;
use crate::packed::lights::append_lights_of_grid;
use crate::packed::material_records::MaterialRecords;
use crate::packed::pack::{CellsOfGrid, cells_of, levels_of, name_bricks, ordered_position, top_offset};
use crate::packed::section_writer::SectionWriter;
use crate::packed::skip_distances::Level;
use crate::packed::stream::{copy, map_bricks};
use crate::packed::{
    CELL_OCCUPIED, Geometry, PackError, PackedGrid, PackedInstance, PackedMaterial, PackedScene, Placement, StreamError,
};
use glam::{IVec3, Mat3};
use rayon::prelude::*;
use std::fs::File;
use std::io::{self, Write};
use std::path::Path;
use voxtrace_scene::brick::{BRICK_SIZE, Brick, block_bit, block_index, voxel_of};
use voxtrace_scene::transform::Transform;

/// Most sections of a level.
const SECTIONS: usize = 11;
/// Bricks that are made at a time.
const BATCH: usize = 1 << 10;
/// Bits of a palette entry.
const ENTRY_BITS: u32 = 16;

/// Writes the level above `below` into an empty file; others for a while beside `path`. `told` hears how many voxels of `below` are done, and stops the work by an error.
pub(super) fn write_level(
    below: &PackedScene,
    file: &File,
    path: &Path,
    told: &mut dyn FnMut(u64) -> io::Result<()>,
) -> Result<(), StreamError> {
    let materials = below.materials();
    let kinds = Kinds::of(materials);
    let traits: Vec<Traits> = materials.iter().map(Traits::from).collect();
    for rounding in Rounding::ALL {
        file.set_len(0)?;
        let materials = Materials::new(materials, &kinds, rounding);
        let waiting = TemporaryFile::nameless(path)?;
        let writer = SectionWriter::new(file.try_clone()?, SECTIONS)?;
        let pass = Pass { below, kinds: &kinds, traits: &traits, rounding, materials, writer, waiting, told };
        if pass.write(file)? {
            return Ok(());
        }
    }
    Err(io::Error::other("the last rounding takes the nearest material").into())
}

/// One attempt, with one way of rounding.
struct Pass<'a> {
    below: &'a PackedScene,
    kinds: &'a Kinds,
    traits: &'a [Traits],
    rounding: Rounding,
    materials: Materials<'a>,
    writer: SectionWriter,
    waiting: TemporaryFile,
    told: &'a mut dyn FnMut(u64) -> io::Result<()>,
}

/// What is known of a grid when its bricks are written, and where the next ones begin.
struct GridSoFar {
    voxels: u64,
    min: IVec3,
    max: IVec3,
    /// The number of each record, in order.
    records: Vec<u32>,
    emitting: Vec<(IVec3, u16)>,
}

/// A brick whose materials are not numbered yet.
struct Made {
    occupancy: [u64; 8],
    looks: Vec<Look>,
    coverages: Vec<u8>,
}

impl Pass<'_> {
    /// Writes the level; `false` where there were too many materials.
    fn write(mut self, file: &File) -> Result<bool, StreamError> {
        let geometry = &*self.below.geometry;
        let (mut cells, mut grids, mut emitting) = (Vec::new(), Vec::new(), Vec::new());
        let (mut record_words, mut material_words) = (0u64, 0u64);
        let mut voxels_before = 0;
        self.writer.begin::<u32>(b"BRIK")?;
        for grid in geometry.grids() {
            let (order, levels, low) = order_of(geometry, grid);
            let words = (&mut record_words, &mut material_words);
            let Some(found) = self.write_bricks(grid, &order, words, voxels_before)? else {
                return Ok(false);
            };
            voxels_before += grid.voxel_count();
            let first_node = (cells.len() / 64) as u32;
            let CellsOfGrid { cells: mut own, base } = cells_of(&levels);
            for cell in own[..base].iter_mut().filter(|cell| **cell & CELL_OCCUPIED != 0) {
                *cell += first_node;
            }
            name_bricks(&levels, &mut own[base..], found.records.iter().copied());
            grids.push(PackedGrid {
                origin: low * BRICK_SIZE,
                top_shift: levels[0].shift,
                top_size: levels[0].size,
                top_offset: top_offset(cells.len())?,
                min: found.min,
                voxels: [found.voxels as u32, (found.voxels >> 32) as u32],
                max: found.max,
                material_bits: ENTRY_BITS,
            });
            cells.extend(own);
            emitting.push(found.emitting);
        }
        for (name, pairs) in
            [("cells", cells.len() as u64 / 64), ("bricks", record_words / 2), ("materials", material_words / 2)]
        {
            if pairs >= u64::from(CELL_OCCUPIED) {
                return Err(PackError::TooLarge(pairs, name).into());
            }
        }
        self.writer.begin::<u32>(b"BMAT")?;
        copy(self.waiting.file(), &mut self.writer)?;
        self.writer.section(b"CELL", &cells)?;
        let mut level = Geometry {
            grids: grids.into(),
            materials: self.materials.all.into(),
            cells: cells.into(),
            has_coverage: true,
            ..Geometry::default()
        };
        map_bricks(&mut level, &mut self.writer, file)?;
        let (mut emitters, mut nodes) = (Vec::new(), Vec::new());
        for (grid, emitting) in emitting.into_iter().enumerate() {
            append_lights_of_grid(&level, grid, emitting, &mut emitters, &mut nodes);
        }
        (level.emitters, level.light_nodes) = (emitters.into(), nodes.into());
        write_rest(&level.finished(), &self.below.placement, self.writer)?;
        Ok(true)
    }

    /// Writes the bricks of a grid in their order; `None` where there were too many materials.
    fn write_bricks(
        &mut self,
        grid: &PackedGrid,
        order: &[IVec3],
        (record_words, material_words): (&mut u64, &mut u64),
        voxels_before: u64,
    ) -> Result<Option<GridSoFar>, StreamError> {
        let mut found = GridSoFar { voxels: 0, min: IVec3::MAX, max: IVec3::MIN, records: vec![], emitting: vec![] };
        let (geometry, materials) = (&*self.below.geometry, self.below.materials());
        let (traits, kinds, rounding) = (self.traits, self.kinds, self.rounding);
        for (number, batch) in order.chunks(BATCH).enumerate() {
            let share = (number * BATCH) as f64 / order.len() as f64;
            (self.told)(voxels_before + (grid.voxel_count() as f64 * share) as u64)?;
            let make = |window: &mut Window, &at: &IVec3| {
                window.load(grid, at);
                made(window, materials, kinds, rounding)
            };
            let made: Vec<Made> = batch.par_iter().map_init(|| Window::new(geometry, traits), make).collect();
            let mut bricks = Vec::with_capacity(made.len());
            for Made { occupancy, looks, coverages } in made {
                let numbers: Option<Vec<u16>> = looks.into_iter().map(|look| self.materials.index(look)).collect();
                let Some(numbers) = numbers else { return Ok(None) };
                bricks.push((Brick::new(occupancy, numbers), coverages));
            }
            let words: Vec<(Vec<u32>, Vec<u32>)> =
                bricks.par_iter().map(|(brick, coverages)| words_of_brick(brick, coverages)).collect();
            for (mut record, materials) in words {
                found.records.push((*record_words / 2) as u32);
                record[1] = record[1].wrapping_add(*material_words as u32);
                *record_words += record.len() as u64;
                *material_words += materials.len() as u64;
                self.writer.write(bytemuck::cast_slice(&record))?;
                self.waiting.file().write_all(bytemuck::cast_slice(&materials))?;
            }
            for (&at, (brick, _)) in batch.iter().zip(&bricks) {
                found.add(at * BRICK_SIZE, brick, &self.materials.all);
            }
        }
        Ok(Some(found))
    }
}

impl GridSoFar {
    fn add(&mut self, corner: IVec3, brick: &Brick, materials: &[PackedMaterial]) {
        self.voxels += brick.materials().len() as u64;
        let (low, high) = brick.extent();
        (self.min, self.max) = (self.min.min(corner + low), self.max.max(corner + high));
        let emits = |material: u16| materials[usize::from(material)].surface_emission().max_element() > 0.0;
        if brick.materials().iter().any(|&material| emits(material)) {
            let emitting = brick.voxels().filter(|&(_, material)| emits(material));
            self.emitting.extend(emitting.map(|(local, material)| (corner + local, material)));
        }
    }
}

/// The bricks of the level above a grid in the order in which they are written, the levels of the tree over them, and the lowest of their coordinates.
fn order_of(geometry: &Geometry, grid: &PackedGrid) -> (Vec<IVec3>, Vec<Level>, IVec3) {
    let mut order = bricks_above(geometry, grid);
    order.par_sort_unstable_by_key(|at| (at.z, at.y, at.x));
    order.dedup();
    let low = order.iter().copied().reduce(IVec3::min).unwrap_or(IVec3::ZERO);
    let high = order.iter().copied().reduce(IVec3::max).unwrap_or(IVec3::ZERO);
    let relative: Vec<IVec3> = order.iter().map(|&at| at - low).collect();
    let levels = levels_of(&relative, (high - low + 1) * BRICK_SIZE);
    drop(relative);
    order.par_sort_by_cached_key(|&at| ordered_position(&levels, at - low));
    (order, levels, low)
}

/// Coordinates of the bricks of the level above a grid; some come several times.
fn bricks_above(geometry: &Geometry, grid: &PackedGrid) -> Vec<IVec3> {
    let mut found: Vec<IVec3> = Vec::new();
    // Where the bricks of the node that is gone through begin: those of it are told apart at once, so that there are never as many as the grid has bricks.
    let mut start = (0, IVec3::MAX);
    geometry.for_each_brick(grid, &mut |brick| {
        let at = (brick + (grid.origin >> 3)) >> 1;
        if start.1 != brick >> 2 {
            start = (found.len(), brick >> 2);
        }
        if !found[start.0..].contains(&at) {
            found.push(at);
        }
    });
    found
}

/// The brick that a window has come to.
fn made(window: &Window, materials: &[PackedMaterial], kinds: &Kinds, rounding: Rounding) -> Made {
    let mut made = Made { occupancy: [0; 8], looks: Vec::new(), coverages: Vec::new() };
    for block in 0..8 {
        for bit in 0..64 {
            let local = voxel_of(block, bit);
            debug_assert_eq!((block_index(local), block_bit(local)), (block, bit));
            if let Some(found) = block_at(window, local, materials, kinds) {
                made.occupancy[block] |= 1 << bit;
                made.looks.push(Look::of(&found, kinds, rounding));
                made.coverages.push(found.coverage);
            }
        }
    }
    made
}

/// The record of a brick, and its coverages and materials.
fn words_of_brick(brick: &Brick, coverages: &[u8]) -> (Vec<u32>, Vec<u32>) {
    let (mut record, materials) = encode_brick(brick, ENTRY_BITS);
    let mut words = words_of(coverages);
    record[1] += coverage_words(coverages.len() as u32) as u32;
    words.extend(materials);
    (record, words)
}

/// Writes what is not written yet.
fn write_rest(level: &Geometry, below: &Placement, mut writer: SectionWriter) -> Result<(), StreamError> {
    let twice = Transform { linear: Mat3::from_diagonal(glam::Vec3::splat(2.0)), translation: glam::Vec3::ZERO };
    let above = |instance: &PackedInstance| {
        let Transform { linear, translation } = instance.world_from_grid;
        let world_from_grid = Transform { linear: linear * twice.linear, translation };
        PackedInstance::new(instance.grid, world_from_grid, instance.scene_instance)
    };
    let placement = Placement::of_sound(level, below.instances().iter().map(above).collect());
    writer.section(b"GRID", &level.grids)?;
    writer.section(b"INST", &InstanceRecord::all_of(&placement))?;
    writer.section(b"INOD", &placement.instance_nodes)?;
    let materials = MaterialRecords::of(&level.materials);
    writer.section(b"MATS", &materials.surfaces)?;
    if !materials.media.is_empty() {
        writer.section(b"MEDI", &materials.media)?;
    }
    writer.section(b"EMIT", &level.emitters)?;
    writer.section(b"LNOD", &level.light_nodes)?;
    writer.section(b"COVR", &[4u32])?;
    Ok(writer.finish(VERSION)?)
}
