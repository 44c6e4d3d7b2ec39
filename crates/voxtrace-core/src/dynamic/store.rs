//! The arrays of a scene that is edited, with the places in them that are free and the ranges that were written.

use super::dirty::Dirty;
use super::pool::Pool;
use crate::packed::{Geometry, Section};
use bytemuck::Pod;

/// Words of the largest brick record, in units of two.
const LARGEST_RECORD: u32 = 9;
/// Words of the smallest brick record, in units of two.
const LEAST_RECORD: u32 = 2;
/// Words of the materials of a brick of 512 voxels and as many materials of 16 bits.
const LARGEST_MATERIALS: u32 = 256;
/// Largest pieces of free cells that are kept together, in nodes.
const LARGEST_CELLS: u32 = 256;
/// Largest pieces of nodes over emitters and of emitters: a tree of [`super::light_tree::BLOCK`], which has twice as many nodes at most. The longest
/// way down to the left, a node for each bit of three coordinates, is shorter.
const LARGEST_TREE: u32 = 2 * super::light_tree::BLOCK as u32;

/// Free places.
#[derive(Clone, Debug)]
pub(super) struct Pools {
    /// In nodes of 64 cells.
    pub cells: Pool,
    /// In units of two words.
    pub bricks: Pool,
    /// In words.
    pub materials: Pool,
    /// In emitters.
    pub emitters: Pool,
    /// In nodes.
    pub light_nodes: Pool,
}

/// Written ranges.
#[derive(Clone, Debug, Default)]
pub(super) struct DirtyArrays {
    pub cells: Dirty,
    pub bricks: Dirty,
    pub materials: Dirty,
    /// Of the materials of the scene.
    pub palette: Dirty,
    pub epochs: Dirty,
    pub emitters: Dirty,
    pub light_nodes: Dirty,
}

impl DirtyArrays {
    pub fn is_clean(&self) -> bool {
        let Self { cells, bricks, materials, palette, epochs, emitters, light_nodes } = self;
        [cells, bricks, materials, palette, epochs, emitters, light_nodes].iter().all(|dirty| dirty.is_clean())
    }
}

impl Pools {
    pub fn of(geometry: &Geometry) -> Self {
        Self {
            cells: Pool::new(geometry.cells.len().div_ceil(64), 1, LARGEST_CELLS),
            bricks: Pool::new(geometry.bricks.len() / 2, LEAST_RECORD, LARGEST_RECORD),
            materials: Pool::new(geometry.brick_materials.len(), 1, LARGEST_MATERIALS),
            emitters: Pool::new(geometry.emitters.len(), 1, super::light_tree::BLOCK as u32),
            light_nodes: Pool::new(geometry.light_nodes.len(), 1, LARGEST_TREE),
        }
    }
}

/// The arrays while they are changed.
pub(super) struct Store<'a> {
    pub geometry: &'a mut Geometry,
    pub pools: &'a mut Pools,
    pub dirty: &'a mut DirtyArrays,
    pub epochs: &'a mut Vec<u16>,
    /// How many emitters are below each node of the trees over them.
    pub below: &'a mut Vec<u32>,
}

/// A brick as its words: its record, whose second word does not count, and its materials.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct BrickCode {
    pub record: Box<[u32]>,
    pub materials: Box<[u32]>,
}

impl BrickCode {
    pub fn size_bytes(&self) -> u64 {
        size_of::<Self>() as u64 + 4 * (self.record.len() + self.materials.len()) as u64
    }
}

/// Position of a brick's epoch, by that of its record. A record has four words at least: no two have the same.
pub(super) fn epoch_position(record: usize) -> usize {
    record / 4
}

impl Store<'_> {
    /// The words of the brick with a record at `record`, as they are.
    pub fn brick_code(&self, grid: usize, record: usize) -> BrickCode {
        let (geometry, bricks) = (&*self.geometry, &*self.geometry.bricks);
        let words = &bricks[record..record + 2 + 2 * (bricks[record] & 0xff).count_ones() as usize];
        let start = words[1] as usize;
        let length = geometry.material_words(&geometry.grids[grid], record, geometry.voxels_of(record));
        BrickCode { record: words.into(), materials: geometry.brick_materials[start..start + length].into() }
    }

    /// Puts a brick where the one before it was, as far as that is as large, else elsewhere. Returns the position of its record.
    pub fn put_brick(&mut self, before: Option<(usize, usize, usize)>, code: &BrickCode, epoch: u16) -> usize {
        let materials = match before {
            Some((record, _, length)) if length == code.materials.len() => self.geometry.bricks[record + 1] as usize,
            _ => {
                if let Some((record, _, length)) = before {
                    let position = self.geometry.bricks[record + 1];
                    give_some(&mut self.pools.materials, position, length);
                }
                take_some(&mut self.pools.materials, code.materials.len()) as usize
            }
        };
        put(&mut self.geometry.brick_materials, self.pools.materials.end(), materials, &code.materials);
        self.dirty.materials.mark(materials, code.materials.len());
        let record = match before {
            Some((record, length, _)) if length == code.record.len() => record,
            _ => {
                if let Some((record, length, _)) = before {
                    self.pools.bricks.give((record / 2) as u32, (length / 2) as u32);
                }
                self.pools.bricks.take((code.record.len() / 2) as u32) as usize * 2
            }
        };
        put(&mut self.geometry.bricks, self.pools.bricks.end() * 2, record, &code.record);
        self.geometry.bricks.as_mut()[record + 1] = materials as u32;
        self.dirty.bricks.mark(record, code.record.len());
        let position = epoch_position(record);
        if self.epochs.len() <= position {
            self.epochs.resize(self.geometry.bricks.len().div_ceil(4), 0);
        }
        self.epochs[position] = epoch;
        self.dirty.epochs.mark(position, 1);
        record
    }

    /// Gives the places of a brick back.
    pub fn drop_brick(&mut self, (record, length, materials): (usize, usize, usize)) {
        give_some(&mut self.pools.materials, self.geometry.bricks[record + 1], materials);
        self.pools.bricks.give((record / 2) as u32, (length / 2) as u32);
    }
}

fn give_some(pool: &mut Pool, position: u32, length: usize) {
    if length > 0 {
        pool.give(position, length as u32);
    }
}

fn take_some(pool: &mut Pool, length: usize) -> u32 {
    if length > 0 { pool.take(length as u32) } else { 0 }
}

/// Writes records at a position of an array of `end`.
pub(super) fn put<T: Pod>(section: &mut Section<T>, end: usize, position: usize, records: &[T]) {
    if end != section.len() {
        section.set_length(end);
    }
    section.as_mut()[position..position + records.len()].copy_from_slice(records);
}
