//! The tree over the bricks of one grid, changed in place: bricks come and go, and with them the nodes above.

use super::store::Store;
use crate::packed::{CELL_OCCUPIED, Geometry, PackedGrid, SKIP_DISTANCES, cell_in_node};
use glam::IVec3;

/// log₂ of the voxels along an edge of a brick: the width of the finest cells.
pub(super) const BRICK_SHIFT: u32 = 3;

/// A cell of a level: log₂ of its width in voxels, and its coordinates in such cells from the grid's origin.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) struct Cell {
    pub shift: u32,
    /// z, y, x: cells sort as they lie.
    pub at: [i32; 3],
}

impl Cell {
    pub fn new(shift: u32, at: IVec3) -> Self {
        Self { shift, at: [at.z, at.y, at.x] }
    }

    pub fn place(&self) -> IVec3 {
        IVec3::new(self.at[2], self.at[1], self.at[0])
    }
}

/// Cells whose content changed.
#[derive(Default)]
pub(super) struct ChangedCells {
    /// Cells that were empty and are not now.
    pub filled: Vec<Cell>,
    /// Cells that were not empty and are now, with the shortest skip distances.
    pub emptied: Vec<Cell>,
    /// Nodes that are new, by their cell: their empty cells skip what the cell skipped.
    pub divided: Vec<Cell>,
}

/// Coordinates of a brick, in bricks from the grid's origin.
pub(super) fn from_origin(grid: &PackedGrid, brick: IVec3) -> IVec3 {
    brick - (grid.origin >> BRICK_SHIFT as i32)
}

/// Position of a top cell among the cells, `None` outside.
pub(super) fn top_position(grid: &PackedGrid, cell: IVec3) -> Option<usize> {
    let inside = cell.cmpge(IVec3::ZERO).all() && cell.cmplt(grid.top_size).all();
    let index = || (cell.z as usize * grid.top_size.y as usize + cell.y as usize) * grid.top_size.x as usize;
    inside.then(|| grid.top_offset as usize + index() + cell.x as usize)
}

/// Position of the first of the 64 cells, `1 << shift` voxels wide, of a node, by its coordinates in nodes; `None` where there is none.
pub(super) fn node_position(cells: &[u32], grid: &PackedGrid, shift: u32, node: IVec3) -> Option<usize> {
    let above = shift + 2;
    let mut cell = cells[top_position(grid, node >> (grid.top_shift - above) as i32)?];
    let mut at = grid.top_shift;
    while cell & CELL_OCCUPIED != 0 && at > above {
        at -= 2;
        let local = node >> (at - above) as i32 & 3;
        cell = cells[child(cell) * 64 + (local.x | local.y << 2 | local.z << 4) as usize];
    }
    (cell & CELL_OCCUPIED != 0).then(|| child(cell) * 64)
}

/// What a cell that is not empty holds: the number of a node, or of two words of brick records.
pub(super) fn child(cell: u32) -> usize {
    (cell & !CELL_OCCUPIED) as usize
}

/// The code of the largest skip distance that is at most `run` ≥ 1.
fn code_of(run: i32) -> u32 {
    SKIP_DISTANCES.iter().rposition(|&distance| i32::from(distance) <= run).unwrap_or(0) as u32
}

/// The 64 cells of a node where a cell was empty: each skips what of the cell's skipped cube lies ahead of it.
fn divided(word: u32) -> [u32; 64] {
    std::array::from_fn(|index| {
        let local = IVec3::new(index as i32 & 3, index as i32 >> 2 & 3, index as i32 >> 4);
        (0..8).fold(0, |cell, octant| {
            let distance = i32::from(SKIP_DISTANCES[(word >> (3 * octant) & 7) as usize]);
            let is_negative = IVec3::new(octant & 1, octant >> 1 & 1, octant >> 2);
            let along = IVec3::select(is_negative.cmpeq(IVec3::ONE), 3 - local, local);
            cell | code_of(4 * distance - along.max_element()) << (3 * octant)
        })
    })
}

impl Geometry {
    /// Position of the cell of a brick, which may be empty or that of a coarser empty cell, with log₂ of its width; `None` outside of
    /// the top array.
    pub(super) fn cell_of_brick(&self, grid: &PackedGrid, brick: IVec3) -> Option<(usize, u32)> {
        let relative = from_origin(grid, brick) << BRICK_SHIFT as i32;
        let mut position = top_position(grid, relative >> grid.top_shift as i32)?;
        let mut shift = grid.top_shift;
        while shift > BRICK_SHIFT && self.cells[position] & CELL_OCCUPIED != 0 {
            shift -= 2;
            position = child(self.cells[position]) * 64 + cell_in_node(relative, shift);
        }
        Some((position, shift))
    }
}

impl Store<'_> {
    /// Makes the cell of a brick name a record. The brick must lie within the top array.
    pub fn fill_cell(&mut self, grid: usize, brick: IVec3, record: usize, changed: &mut ChangedCells) {
        let packed = self.geometry.grids[grid];
        let relative = from_origin(&packed, brick) << BRICK_SHIFT as i32;
        loop {
            let (position, shift) = self.geometry.cell_of_brick(&packed, brick).expect("the grid was made to reach");
            let was = self.geometry.cells[position];
            if was & CELL_OCCUPIED == 0 {
                changed.filled.push(Cell::new(shift, relative >> shift as i32));
            }
            if shift == BRICK_SHIFT {
                self.set_cell(position, CELL_OCCUPIED | (record / 2) as u32);
                return;
            }
            let node = self.put_cells(&divided(was));
            changed.divided.push(Cell::new(shift, relative >> shift as i32));
            self.set_cell(position, CELL_OCCUPIED | (node / 64) as u32);
        }
    }

    /// Empties the cell of a brick that is there, and the nodes above that hold nothing any more. Returns its record.
    pub fn empty_cell(&mut self, grid: usize, brick: IVec3, changed: &mut ChangedCells) -> usize {
        let packed = self.geometry.grids[grid];
        let relative = from_origin(&packed, brick) << BRICK_SHIFT as i32;
        let mut position = top_position(&packed, relative >> packed.top_shift as i32).expect("a brick is in its grid");
        let mut path = vec![position];
        for shift in (BRICK_SHIFT..packed.top_shift).rev().step_by(2).map(|shift| shift - 1) {
            position = child(self.geometry.cells[position]) * 64 + cell_in_node(relative, shift);
            path.push(position);
        }
        let record = child(self.geometry.cells[position]) * 2;
        let mut shift = BRICK_SHIFT;
        while let Some(position) = path.pop() {
            if shift > BRICK_SHIFT {
                let node = child(self.geometry.cells[position]) * 64;
                if self.geometry.cells[node..node + 64].iter().any(|cell| cell & CELL_OCCUPIED != 0) {
                    break;
                }
                self.pools.cells.give((node / 64) as u32, 1);
            }
            changed.emptied.push(Cell::new(shift, relative >> shift as i32));
            self.set_cell(position, 0);
            shift += 2;
        }
        record
    }

    /// Writes a cell.
    pub fn set_cell(&mut self, position: usize, word: u32) {
        self.geometry.cells.as_mut()[position] = word;
        self.dirty.cells.mark(position, 1);
    }

    /// Puts cells, a multiple of 64, at a place of their own. Returns the position of the first.
    pub fn put_cells(&mut self, words: &[u32]) -> usize {
        let position = self.pools.cells.take((words.len() / 64) as u32) as usize * 64;
        let end = self.pools.cells.end() * 64;
        if end != self.geometry.cells.len() {
            self.geometry.cells.set_length(end);
        }
        self.geometry.cells.as_mut()[position..position + words.len()].copy_from_slice(words);
        self.dirty.cells.mark(position, words.len());
        position
    }
}
