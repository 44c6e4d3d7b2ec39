//! Making the top array of a grid reach further. It grows by whole cells on the sides where that is needed, and somewhat more, so that growing
//! again and again copies little. Where it would take more than four cells for each brick, its cells become the cells of nodes below
//! a coarser one first.

use super::cells::{BRICK_SHIFT, top_position};
use super::skip::{TILE, largest};
use super::store::Store;
use crate::packed::{CELL_OCCUPIED, PackedGrid};
use glam::{I64Vec3, IVec3};
use rayon::prelude::*;
use voxtrace_scene::grid::MAX_COORDINATE;

/// Most top cells for each brick.
const CELLS_PER_BRICK: u64 = 4;
/// Top cells that are never too many.
const FEW_CELLS: u64 = 256;

fn volume(size: I64Vec3) -> u64 {
    size.to_array().iter().map(|&n| n as u64).product()
}

/// Most top cells of a grid of so many bricks.
pub(super) fn most_of_top(bricks: u64) -> u64 {
    (bricks * CELLS_PER_BRICK).max(FEW_CELLS)
}

/// Top cells to add below and above, so that bricks from `low` to before `high` have a place; with some more on these sides, as far as voxels may
/// lie, where there is `room`.
fn missing(grid: &PackedGrid, low: IVec3, high: IVec3, has_room: bool) -> (IVec3, IVec3) {
    let shift = grid.top_shift as i32;
    let (low, high) = ((low << BRICK_SHIFT as i32) - grid.origin, (high << BRICK_SHIFT as i32) - grid.origin);
    let cell_up = |voxels: IVec3| (voxels + ((1 << shift) - 1)) >> shift;
    let below = cell_up((-low).max(IVec3::ZERO));
    let above = (cell_up(high) - grid.top_size).max(IVec3::ZERO);
    if !has_room {
        return (below, above);
    }
    let most_below = cell_up((grid.origin + MAX_COORDINATE + 8).max(IVec3::ZERO));
    let most_above = (cell_up(MAX_COORDINATE + 1 - grid.origin) - grid.top_size).max(IVec3::ZERO);
    let more = grid.top_size / 4 + 1;
    let with_room =
        |cells: IVec3, most: IVec3| IVec3::select(cells.cmpgt(IVec3::ZERO), cells.max(more.min(most)), IVec3::ZERO);
    (with_room(below, most_below), with_room(above, most_above))
}

impl Store<'_> {
    /// Makes the top array of a grid reach the bricks from `low` to before `high`, where it then will have so many bricks. Returns whether it had to change.
    pub fn reach(&mut self, grid: usize, (low, high): (IVec3, IVec3), bricks: u64) -> bool {
        let packed = self.geometry.grids[grid];
        let (below, above) = missing(&packed, low, high, false);
        if below == IVec3::ZERO && above == IVec3::ZERO {
            return false;
        }
        let most = most_of_top(bricks);
        loop {
            let packed = self.geometry.grids[grid];
            let fitting = [true, false]
                .into_iter()
                .map(|has_room| missing(&packed, low, high, has_room))
                .find(|(below, above)| volume((packed.top_size + below + above).as_i64vec3()) <= most);
            match fitting {
                Some((below, above)) => {
                    self.extend(grid, below, above);
                    break;
                }
                None => self.coarsen(grid),
            }
        }
        self.restore_top(grid);
        true
    }

    /// Adds empty top cells.
    fn extend(&mut self, grid: usize, below: IVec3, above: IVec3) {
        let was = self.geometry.grids[grid];
        let size = was.top_size + below + above;
        let mut cells = vec![0; (size.element_product() as usize).next_multiple_of(64)];
        for z in 0..was.top_size.z {
            for y in 0..was.top_size.y {
                let from = top_position(&was, IVec3::new(0, y, z)).expect("a row of the array");
                let to = ((z + below.z) * size.y + y + below.y) * size.x + below.x;
                let length = was.top_size.x as usize;
                cells[to as usize..to as usize + length].copy_from_slice(&self.geometry.cells[from..from + length]);
            }
        }
        let origin = was.origin - (below << was.top_shift as i32);
        self.replace_top(grid, &cells, PackedGrid { origin, top_size: size, ..was });
    }

    /// Makes nodes of the top cells, 4³ each, below a coarser array.
    fn coarsen(&mut self, grid: usize) {
        let was = self.geometry.grids[grid];
        let size: IVec3 = (was.top_size + 3) >> 2;
        let mut cells = vec![0; (size.element_product() as usize).next_multiple_of(64)];
        for index in 0..size.element_product() {
            let at = IVec3::new(index % size.x, index / size.x % size.y, index / (size.x * size.y));
            let node: [u32; 64] = std::array::from_fn(|index| {
                let local = IVec3::new(index as i32 & 3, index as i32 >> 2 & 3, index as i32 >> 4);
                top_position(&was, at * 4 + local).map_or(0, |position| self.geometry.cells[position])
            });
            if node.iter().any(|cell| cell & CELL_OCCUPIED != 0) {
                cells[index as usize] = CELL_OCCUPIED | (self.put_cells(&node) / 64) as u32;
            }
        }
        self.replace_top(grid, &cells, PackedGrid { top_size: size, top_shift: was.top_shift + 2, ..was });
    }

    fn replace_top(&mut self, grid: usize, cells: &[u32], mut now: PackedGrid) {
        let was = self.geometry.grids[grid];
        let length = (was.top_size.element_product() as usize).div_ceil(64);
        self.pools.cells.give(was.top_offset / 64, length as u32);
        now.top_offset = self.put_cells(cells) as u32;
        self.geometry.grids.as_mut()[grid] = now;
    }

    /// Gives the top cells the largest skip distances.
    fn restore_top(&mut self, grid: usize) {
        let packed = self.geometry.grids[grid];
        let tiles: Vec<IVec3> = boxes(packed.top_size, TILE).collect();
        let found: Vec<_> = (tiles.par_iter())
            .map(|&low| largest(self.geometry, &packed, packed.top_shift, low, (low + TILE).min(packed.top_size)))
            .collect();
        found.iter().for_each(|distances| self.restore(grid, packed.top_shift, distances));
    }
}

/// The lowest corners of the cubes that cover a box.
pub(super) fn boxes(size: IVec3, edge: i32) -> impl Iterator<Item = IVec3> {
    let along = move |size: i32| (0..size).step_by(edge as usize);
    along(size.z).flat_map(move |z| along(size.y).flat_map(move |y| along(size.x).map(move |x| IVec3::new(x, y, z))))
}
