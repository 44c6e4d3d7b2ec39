//! Cells without nodes: one dense array with a cell for each brick, where memory allows. Devices with thousands of threads
//! walk it faster than a tree, as every step is one load; processors keep the tree, whose nodes fit their registers.

use super::leaps::{Level, leaps_of};
use super::{CELL_OCCUPIED, PackedGrid, PackedScene};
use glam::IVec3;
use rustc_hash::FxHashMap;

/// Most cells for each brick of a grid: 40 bytes, against about 100 of the brick itself.
const MOST_CELLS_PER_BRICK: u64 = 10;
/// Bits of the brick's number in a cell that also says which blocks hold a voxel.
const INDEX_BITS: u32 = 23;

impl PackedScene {
    /// The cells, and the grids that number them, with a dense array for every grid: `top_shift` is 3 everywhere. `None`
    /// where that would take more than ten cells for each brick.
    pub fn dense_cells(&self) -> Option<(Vec<u32>, Vec<PackedGrid>)> {
        let mut cells = Vec::new();
        let mut grids = Vec::with_capacity(self.grids.len());
        for grid in &*self.grids {
            let bricks = self.brick_cells(grid);
            let size: IVec3 = (grid.max - grid.origin + 7) >> 3;
            let count = size.to_array().iter().map(|&n| n as u64).product::<u64>();
            if count > (MOST_CELLS_PER_BRICK * bricks.len() as u64).max(64) {
                return None;
            }
            let position = |at: IVec3| ((at.z * size.y + at.y) * size.x + at.x) as usize;
            let mut occupied = vec![false; count as usize];
            for &(at, _) in &bricks {
                occupied[position(at)] = true;
            }
            let level = Level { shift: 3, nodes: Vec::new(), index_of: FxHashMap::default(), size, occupied };
            let mut own = leaps_of(&[level]).swap_remove(0);
            for (at, cell) in bricks {
                own[position(at)] = cell;
            }
            own.resize(own.len().next_multiple_of(64), 0);
            grids.push(PackedGrid { top_shift: 3, top_size: size, top_offset: cells.len() as u32, ..*grid });
            cells.append(&mut own);
        }
        Some((cells, grids))
    }

    /// Adds to each of the dense `cells` that has a brick which of its eight blocks hold a voxel, bits 23 to 30, so that
    /// the walk need not look into a brick to pass through its empty blocks. Returns false, and adds nothing, where the
    /// numbers of the bricks need those bits.
    pub fn add_blocks(&self, cells: &mut [u32]) -> bool {
        let index_of = |cell: u32| cell & !CELL_OCCUPIED;
        let has_brick = |cell: &u32| cell & CELL_OCCUPIED != 0;
        if cells.iter().any(|cell| has_brick(cell) && index_of(*cell) >> INDEX_BITS != 0) {
            return false;
        }
        for cell in cells.iter_mut().filter(|cell| has_brick(cell)) {
            *cell |= (self.bricks[index_of(*cell) as usize * 2] & 0xff) << INDEX_BITS;
        }
        true
    }

    /// The bricks of a grid: where they are, in bricks from the grid's origin, and their cell words.
    fn brick_cells(&self, grid: &PackedGrid) -> Vec<(IVec3, u32)> {
        let mut found = Vec::new();
        let size = grid.top_size;
        for z in 0..size.z {
            for y in 0..size.y {
                for x in 0..size.x {
                    let index = grid.top_offset as usize + ((z * size.y + y) * size.x + x) as usize;
                    self.bricks_below(self.cells[index], IVec3::new(x, y, z), grid.top_shift, &mut found);
                }
            }
        }
        found
    }

    fn bricks_below(&self, cell: u32, at: IVec3, shift: u32, found: &mut Vec<(IVec3, u32)>) {
        if cell & CELL_OCCUPIED == 0 {
            return;
        }
        if shift == 3 {
            found.push((at, cell));
            return;
        }
        let node = (cell & !CELL_OCCUPIED) as usize * 64;
        for index in 0..64 {
            let local = IVec3::new(index & 3, index >> 2 & 3, index >> 4);
            self.bricks_below(self.cells[node + index as usize], at * 4 + local, shift - 2, found);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{CELL_OCCUPIED, INDEX_BITS};
    use crate::{PackedScene, scenes};

    #[test]
    fn cells_take_in_the_blocks_of_their_bricks_where_there_is_room() {
        let packed = PackedScene::pack(&scenes::generate("city", Some(100_000)).unwrap()).unwrap();
        let (plain, _) = packed.dense_cells().unwrap();
        let mut cells = plain.clone();
        assert!(packed.add_blocks(&mut cells));
        for (cell, plain) in cells.iter().zip(&plain) {
            match plain & CELL_OCCUPIED {
                0 => assert_eq!(cell, plain, "empty cells stay as they are"),
                _ => {
                    let index = plain & !CELL_OCCUPIED;
                    assert_eq!(cell & ((1 << INDEX_BITS) - 1), index);
                    assert_eq!(cell >> INDEX_BITS & 0xff, packed.bricks[index as usize * 2] & 0xff);
                }
            }
        }
        let mut large = vec![CELL_OCCUPIED | 1 << INDEX_BITS, plain[0]];
        assert!(!packed.add_blocks(&mut large), "a number that needs the bits");
        assert_eq!(large, [CELL_OCCUPIED | 1 << INDEX_BITS, plain[0]]);
    }

    #[test]
    fn a_scene_with_dense_cells_is_valid_and_the_same() {
        let packed = PackedScene::pack(&scenes::generate("city", Some(100_000)).unwrap()).unwrap();
        let (cells, grids) = packed.dense_cells().expect("a city is dense enough");
        assert_ne!(cells.len(), packed.cells.len());
        let dense = PackedScene { cells: cells.into(), grids: grids.into(), ..packed.clone() };
        dense.validate().unwrap();
        for (tree, dense) in packed.to_scene().grids.iter().zip(&dense.to_scene().grids) {
            assert!(tree.voxels().eq(dense.voxels()));
        }
    }
}
