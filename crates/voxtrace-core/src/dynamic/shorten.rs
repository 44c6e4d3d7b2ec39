//! Writing skip distances: shorter ones around cells that became full, and the largest ones where they were found.
//!
//! Around one cell no distance has to be looked for. A cell may skip as many cells as its coordinates differ from those of the full one along
//! the axis where they differ most, in those octants in which the full one lies ahead of it.

use super::cells::{node_position, top_position};
use super::fields::{LONGEST, are_within, shorten_cells};
use super::skip::{Distances, REACH, TILE, allowed_by, for_slots};
use super::store::Store;
use crate::packed::{CELL_OCCUPIED, PackedGrid, SKIP_DISTANCES};
use glam::IVec3;
use rayon::prelude::*;

/// Cells along an edge of the box around one that may skip up to it.
const AROUND: usize = 2 * REACH as usize + 1;
/// Tiles whose distances are found side by side.
const AT_ONCE: usize = 64;
/// Octants that go up along an axis, as fields that are full.
const UPWARD: [u32; 3] = [0o0707_0707, 0o0077_0077, 0o0000_7777];

/// What one cell that becomes full allows to cells of which it is so far away along an axis: the distance in all fields, and the fields of octants
/// in which it lies ahead as far as this axis says.
#[inline(always)]
fn along_axis(axis: usize, away: i32) -> (i32, u32) {
    let code = CODES[away.unsigned_abs().min(SKIP_DISTANCES[7] as u32) as usize];
    let ahead = match away {
        0 => LONGEST,
        1.. => UPWARD[axis],
        _ => LONGEST & !UPWARD[axis],
    };
    (code, ahead)
}

/// What holds along an axis for all four cells of a node, from the first of which the full one is so far away.
fn least(axis: usize, away: IVec3) -> (i32, u32) {
    match away[axis] {
        0..4 => (0, LONGEST),
        away @ 4.. => along_axis(axis, away - 3),
        away => along_axis(axis, away),
    }
}

/// What both say.
#[inline(always)]
fn both(a: (i32, u32), b: (i32, u32)) -> (i32, u32) {
    (a.0.max(b.0), a.1 & b.1)
}

/// As skip distances: the longest ones in the other octants.
#[inline(always)]
fn word((code, ahead): (i32, u32)) -> u32 {
    code as u32 & ahead | LONGEST & !ahead
}

/// By a number of cells the largest skip distance that is not longer, in all fields.
const CODES: [i32; SKIP_DISTANCES[7] as usize + 1] = {
    let mut codes = [0; SKIP_DISTANCES[7] as usize + 1];
    let (mut code, mut cells) = (0, 0);
    while cells < codes.len() {
        while code < 7 && SKIP_DISTANCES[code + 1] as usize <= cells {
            code += 1;
        }
        codes[cells] = code as i32 * 0o1111_1111;
        cells += 1;
    }
    codes
};

/// The nodes of a box of cells.
fn nodes_of((low, high): (IVec3, IVec3)) -> impl Iterator<Item = IVec3> {
    let (first, end): (IVec3, IVec3) = (low >> 2, (high + 3) >> 2);
    (first.z..end.z)
        .flat_map(move |z| (first.y..end.y).flat_map(move |y| (first.x..end.x).map(move |x| IVec3::new(x, y, z))))
}

impl Store<'_> {
    /// Shortens the distances of a level that reach over cells which became full.
    pub fn shorten(&mut self, grid: usize, shift: u32, filled: &mut [IVec3]) {
        let packed = self.geometry.grids[grid];
        if let [cell] = *filled {
            self.shorten_around(&packed, shift, cell);
            return;
        }
        let low = filled.iter().fold(IVec3::MAX, |low, cell| low.min(*cell));
        let tile = |cell: &IVec3| ((cell - low) / TILE).to_array();
        filled.sort_unstable_by_key(tile);
        let tiles: Vec<&[IVec3]> = filled.chunk_by(|a, b| tile(a) == tile(b)).collect();
        for some in tiles.chunks(AT_ONCE) {
            let allowed: Vec<Distances> = some.par_iter().map(|tile| allowed_by(tile)).collect();
            allowed.iter().for_each(|allowed| self.shorten_to(&packed, shift, allowed));
        }
    }

    /// Shortens the distances around a cell that became full.
    fn shorten_around(&mut self, grid: &PackedGrid, shift: u32, full: IVec3) {
        if shift == grid.top_shift {
            let along_x: [(i32, u32); AROUND] = std::array::from_fn(|x| along_axis(0, REACH - x as i32));
            self.shorten_rows(grid, (full - REACH, IVec3::splat(AROUND as i32)), |first, count, by| {
                let others = both(along_axis(1, full.y - first.y), along_axis(2, full.z - first.z));
                let from = (first.x - full.x + REACH) as usize;
                by.extend(along_x[from..from + count].iter().map(|&x| word(both(x, others))));
            });
            return;
        }
        let around = (full - REACH, IVec3::splat(AROUND as i32));
        self.shorten_nodes(grid, shift, around, |first, cells, by| {
            let away = full - first;
            // Mostly nothing changes: then the shortest one that any cell of the node may get tells.
            if are_within(cells, word(both(least(0, away), both(least(1, away), least(2, away))))) {
                return false;
            }
            let along_x: [_; 4] = std::array::from_fn(|x| along_axis(0, away.x - x as i32));
            let slice: [_; 16] = std::array::from_fn(|i| both(along_x[i & 3], along_axis(1, away.y - (i >> 2) as i32)));
            for (z, by) in by.chunks_exact_mut(16).enumerate() {
                let along_z = along_axis(2, away.z - z as i32);
                by.iter_mut().zip(slice).for_each(|(by, slice)| *by = word(both(slice, along_z)));
            }
            true
        });
    }

    /// Shortens the distances of a box of whole nodes.
    fn shorten_to(&mut self, grid: &PackedGrid, shift: u32, allowed: &Distances) {
        let region = (allowed.low, allowed.size);
        if shift == grid.top_shift {
            self.shorten_rows(grid, region, |first, count, by| by.extend_from_slice(allowed.row(first, count)));
            return;
        }
        self.shorten_nodes(grid, shift, region, |first, _, by| {
            for (row, by) in by.chunks_exact_mut(4).enumerate() {
                by.copy_from_slice(allowed.row(first + IVec3::new(0, row as i32 & 3, row as i32 >> 2), 4));
            }
            true
        });
    }

    /// Shortens the distances of top cells in a box row by row: `allowed` appends those that so many cells from a first one may have.
    #[inline(always)]
    fn shorten_rows(
        &mut self,
        grid: &PackedGrid,
        (low, size): (IVec3, IVec3),
        allowed: impl Fn(IVec3, usize, &mut Vec<u32>),
    ) {
        let (low, high) = (low.max(IVec3::ZERO), (low + size).min(grid.top_size));
        if low.cmpge(high).any() {
            return;
        }
        let (cells, count, mut by) = (self.geometry.cells.as_mut(), (high.x - low.x) as usize, Vec::new());
        for z in low.z..high.z {
            for y in low.y..high.y {
                let first = IVec3::new(low.x, y, z);
                let Some(position) = top_position(grid, first) else { continue };
                by.clear();
                allowed(first, count, &mut by);
                if let Some((from, to)) = shorten_cells(&mut cells[position..position + count], &by) {
                    self.dirty.cells.mark(position + from, to - from);
                }
            }
        }
    }

    /// Shortens the distances of the nodes that a box touches, all of each: `allowed` is given the first cell of a node and what its cells have, and
    /// writes what they may have, or says that they need not change.
    #[inline(always)]
    fn shorten_nodes(
        &mut self,
        grid: &PackedGrid,
        shift: u32,
        (low, size): (IVec3, IVec3),
        allowed: impl Fn(IVec3, &[u32], &mut [u32; 64]) -> bool,
    ) {
        let across = grid.top_size << (grid.top_shift - shift) as i32;
        let (low, high) = (low.max(IVec3::ZERO), (low + size).min(across));
        let (cells, mut by) = (self.geometry.cells.as_mut(), [0; 64]);
        for node in nodes_of((low, high)) {
            let Some(position) = node_position(cells, grid, shift, node) else { continue };
            let own = &mut cells[position..position + 64];
            if let Some((from, to)) = allowed(node * 4, own, &mut by).then(|| shorten_cells(own, &by)).flatten() {
                self.dirty.cells.mark(position + from, to - from);
            }
        }
    }

    /// Gives the cells of a box the largest distances.
    pub fn restore(&mut self, grid: usize, shift: u32, largest: &Distances) {
        let packed = self.geometry.grids[grid];
        let mut changes: Vec<(usize, u32)> = Vec::new();
        let geometry = &*self.geometry;
        for_slots(geometry, &packed, shift, (largest.low, largest.low + largest.size), |cell, position| {
            let was = geometry.cells[position];
            if was & CELL_OCCUPIED == 0 && largest.at(cell) != was {
                changes.push((position, largest.at(cell)));
            }
        });
        let cells = self.geometry.cells.as_mut();
        for (position, word) in changes {
            cells[position] = word;
            self.dirty.cells.mark(position, 1);
        }
    }
}
