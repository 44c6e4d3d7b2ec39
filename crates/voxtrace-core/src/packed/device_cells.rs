//! The cells as devices walk them: empty ones say which box around them is empty, and where memory allows there is one
//! dense array with a cell for each brick instead of a tree. Devices with thousands of threads walk that faster, as every
//! step is one load; processors keep the tree and its skip distances, whose nodes fit their registers.

use super::boxes::{Counts, box_of};
use super::extent::position;
use super::{CELL_OCCUPIED, Geometry, PackedGrid};
use glam::IVec3;
use rayon::prelude::*;

/// Most cells for each brick of a grid: 64 bytes, against about 100 of the brick itself.
const MOST_CELLS_PER_BRICK: u64 = 16;
/// Bits of the brick's number in a cell that also says which blocks hold a voxel.
const CELL_INDEX_BITS: u32 = 23;
/// Boxes of nodes are found block by block: so many nodes along each edge of a block, and so many more to each side of it
/// that boxes may reach into.
const BLOCK: i32 = 4;
const AROUND: i32 = 4;
/// Cells along each edge of all that.
const CELLS: i32 = 4 * (BLOCK + 2 * AROUND);

/// Cells for devices.
pub struct DeviceCells {
    /// Top arrays, each padded to 64 words, and nodes of 64 cells.
    pub cells: Vec<u32>,
    /// The grids that number them.
    pub grids: Vec<PackedGrid>,
    /// The `top_shift` of all grids, 0 where they differ. 3: every grid has a cell for each brick in its top array, no nodes.
    pub top_shift: u32,
    /// Whether cells that hold a brick also say, in bits 23 to 30, which of its eight blocks hold a voxel.
    pub have_blocks: bool,
}

impl Geometry {
    /// The cells for devices. They are dense where that takes at most sixteen cells for each brick.
    #[doc(hidden)]
    pub fn device_cells(&self) -> DeviceCells {
        let (mut cells, grids) = self.dense_cells().unwrap_or_else(|| (self.tree_with_boxes(), self.grids.to_vec()));
        let shift = grids.first().map_or(0, |grid| grid.top_shift);
        let top_shift = if grids.iter().all(|grid| grid.top_shift == shift) { shift } else { 0 };
        let have_blocks = self.add_blocks(&mut cells, &grids);
        DeviceCells { cells, grids, top_shift, have_blocks }
    }

    /// The grids for devices that walk the cells as they are, tree and skip distances. No cells: devices take those of the geometry.
    #[doc(hidden)]
    pub fn tree_cells(&self) -> DeviceCells {
        let shift = self.grids.first().map_or(0, |grid| grid.top_shift);
        let top_shift = if self.grids.iter().all(|grid| grid.top_shift == shift) { shift } else { 0 };
        DeviceCells { cells: Vec::new(), grids: self.grids.to_vec(), top_shift, have_blocks: false }
    }

    fn dense_cells(&self) -> Option<(Vec<u32>, Vec<PackedGrid>)> {
        let mut cells = Vec::new();
        let mut grids = Vec::with_capacity(self.grids.len());
        for grid in &*self.grids {
            let bricks = self.brick_cells(grid);
            let size: IVec3 = (grid.max - grid.origin + 7) >> 3;
            let count = size.to_array().iter().map(|&n| n as u64).product::<u64>();
            // Cells and the corners between them are counted in 31 bits, words before those of the grid in 32.
            let corners = (size + 1).to_array().iter().map(|&n| n as u64).product::<u64>();
            if count > (MOST_CELLS_PER_BRICK * bricks.len() as u64).max(64) || corners > i32::MAX as u64 {
                return None;
            }
            let top_offset = u32::try_from(cells.len()).ok()?;
            let mut own = vec![0; count as usize];
            for (at, cell) in bricks {
                own[((at.z * size.y + at.y) * size.x + at.x) as usize] = cell;
            }
            add_boxes(size, &mut own);
            own.resize(own.len().next_multiple_of(64), 0);
            grids.push(PackedGrid { top_shift: 3, top_size: size, top_offset, ..*grid });
            cells.append(&mut own);
        }
        Some((cells, grids))
    }

    /// Adds to each of the `cells` that has a brick which of its eight blocks hold a voxel, so that the walk need not look
    /// into a brick to pass through its empty blocks. Returns false, and adds nothing, where the numbers of the bricks need
    /// those bits.
    fn add_blocks(&self, cells: &mut [u32], grids: &[PackedGrid]) -> bool {
        // A record has at least four words, so this many bricks have numbers of so many bits.
        if self.bricks.len() / 2 > 1 << CELL_INDEX_BITS {
            return false;
        }
        for grid in grids {
            let top = grid.top_offset as usize;
            let mut level: Vec<usize> = (top..top + grid.top_size.element_product() as usize).collect();
            for _ in (3..grid.top_shift).step_by(2) {
                level.retain(|&cell| cells[cell] & CELL_OCCUPIED != 0);
                level = level
                    .iter()
                    .flat_map(|&cell| (0..64).map(move |local| (cell, local)))
                    .map(|(cell, local)| (cells[cell] & !CELL_OCCUPIED) as usize * 64 + local)
                    .collect();
            }
            for cell in level {
                if cells[cell] & CELL_OCCUPIED != 0 {
                    cells[cell] |= (self.bricks[(cells[cell] & !CELL_OCCUPIED) as usize * 2] & 0xff) << CELL_INDEX_BITS;
                }
            }
        }
        true
    }

    /// The cells of the tree, with boxes in cells of their level instead of skip distances.
    fn tree_with_boxes(&self) -> Vec<u32> {
        let mut cells = self.cells.to_vec();
        for grid in &*self.grids {
            let top = grid.top_offset as usize..grid.top_offset as usize + grid.top_size.element_product() as usize;
            add_boxes(grid.top_size, &mut cells[top.clone()]);
            // Where the occupied cells of a level are, counted in them, and what they hold.
            let mut held: Vec<(IVec3, usize)> = Vec::new();
            for (index, cell) in self.cells[top].iter().enumerate().filter(|(_, cell)| *cell & CELL_OCCUPIED != 0) {
                held.push((position(grid.top_size, index), (cell & !CELL_OCCUPIED) as usize));
            }
            for shift in (3..grid.top_shift).step_by(2).rev() {
                for (node, words) in self.boxes_of_nodes(grid, shift, &held) {
                    cells[node * 64..][..64].copy_from_slice(&words);
                }
                held = self.held_by(&held);
            }
        }
        cells
    }

    /// The words of nodes whose cells are `1 << shift` voxels wide.
    fn boxes_of_nodes(&self, grid: &PackedGrid, shift: u32, nodes: &[(IVec3, usize)]) -> Vec<(usize, [u32; 64])> {
        let block_of = |&(at, _): &(IVec3, usize)| (at / BLOCK).to_array();
        let mut nodes = nodes.to_vec();
        nodes.par_sort_unstable_by_key(|node| (block_of(node), node.1));
        let blocks: Vec<_> = nodes.chunk_by(|a, b| block_of(a) == block_of(b)).collect();
        let memory = || (Counts::default(), vec![false; CELLS.pow(3) as usize]);
        let words = |(counts, occupied): &mut (Counts, Vec<bool>), block: &&[(IVec3, usize)]| {
            let first = IVec3::from_array(block_of(&block[0])) * BLOCK - AROUND;
            self.occupied_from(grid, shift, first, occupied);
            counts.fill(IVec3::splat(CELLS), occupied);
            let word = |at: IVec3, cell: u32, local: usize| match cell & CELL_OCCUPIED {
                0 => box_of(counts, (at - first) * 4 + cell_at(local)),
                _ => cell,
            };
            let words = |&(at, node)| (node, std::array::from_fn(|i| word(at, self.cells[node * 64 + i], i)));
            block.iter().map(words).collect::<Vec<_>>()
        };
        blocks.par_iter().map_init(memory, words).flatten_iter().collect()
    }

    /// Whether cells are occupied, or outside the grid, in the nodes from the one at `first` on.
    fn occupied_from(&self, grid: &PackedGrid, shift: u32, first: IVec3, occupied: &mut [bool]) {
        let edge = IVec3::splat(BLOCK + 2 * AROUND);
        for index in 0..edge.element_product() as usize {
            let beside = position(edge, index);
            let place = self.node_at(grid, shift, first + beside);
            for local in 0..64 {
                let to = beside * 4 + cell_at(local);
                occupied[((to.z * CELLS + to.y) * CELLS + to.x) as usize] = match place {
                    Place::Outside => true,
                    Place::Empty => false,
                    Place::Node(node) => self.cells[node * 64 + local] & CELL_OCCUPIED != 0,
                };
            }
        }
    }

    /// What there is at a place of the level whose nodes have cells `1 << shift` voxels wide, in nodes from the grid's
    /// origin.
    fn node_at(&self, grid: &PackedGrid, shift: u32, at: IVec3) -> Place {
        let (mut cell_shift, node_shift) = (grid.top_shift, shift + 2);
        let top = at >> (cell_shift - node_shift);
        let size = grid.top_size;
        if top.cmplt(IVec3::ZERO).any() || top.cmpge(size).any() {
            return Place::Outside;
        }
        let mut cell = self.cells[grid.top_offset as usize + ((top.z * size.y + top.y) * size.x + top.x) as usize];
        while cell & CELL_OCCUPIED != 0 {
            let node = (cell & !CELL_OCCUPIED) as usize;
            if cell_shift == node_shift {
                return Place::Node(node);
            }
            cell_shift -= 2;
            let local = (at >> (cell_shift - node_shift)) & 3;
            cell = self.cells[node * 64 + (local.x | local.y << 2 | local.z << 4) as usize];
        }
        Place::Empty
    }

    /// The occupied cells of nodes: where they are, in cells, and what they hold.
    fn held_by(&self, nodes: &[(IVec3, usize)]) -> Vec<(IVec3, usize)> {
        let mut held = Vec::new();
        for &(at, node) in nodes {
            for (local, cell) in self.cells[node * 64..][..64].iter().enumerate() {
                if cell & CELL_OCCUPIED != 0 {
                    held.push((at * 4 + cell_at(local), (cell & !CELL_OCCUPIED) as usize));
                }
            }
        }
        held
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
            self.bricks_below(self.cells[node + index], at * 4 + cell_at(index), shift - 2, found);
        }
    }
}

/// What there is at a place of a level of the tree.
#[derive(Clone, Copy)]
enum Place {
    /// Nothing: it is outside the grid.
    Outside,
    /// No voxel.
    Empty,
    /// The node of this number.
    Node(usize),
}

/// Where in its node a cell is.
fn cell_at(local: usize) -> IVec3 {
    position(IVec3::splat(4), local)
}

/// Replaces the words of the empty cells of an array by their boxes.
fn add_boxes(size: IVec3, cells: &mut [u32]) {
    let occupied: Vec<bool> = cells.iter().map(|cell| cell & CELL_OCCUPIED != 0).collect();
    let counts = Counts::of(size, &occupied);
    let empty = cells.par_iter_mut().enumerate().filter(|(_, cell)| **cell & CELL_OCCUPIED == 0);
    empty.for_each(|(index, cell)| *cell = box_of(&counts, position(size, index)));
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::packed::PackedScene;
    use voxtrace_scenes as scenes;

    /// A city and its geometry.
    fn city() -> (PackedScene, Geometry) {
        let packed = PackedScene::pack(&scenes::generate("city", Some(100_000)).unwrap()).unwrap();
        let geometry = (**packed.geometry()).clone();
        (packed, geometry)
    }

    #[test]
    fn cells_take_in_the_blocks_of_their_bricks_where_there_is_room() {
        let (_, packed) = city();
        let (plain, _) = packed.dense_cells().unwrap();
        let (mut cells, grids) = packed.dense_cells().unwrap();
        assert!(packed.add_blocks(&mut cells, &grids));
        for (cell, plain) in cells.iter().zip(&plain) {
            match plain & CELL_OCCUPIED {
                0 => assert_eq!(cell, plain, "empty cells stay as they are"),
                _ => {
                    let index = plain & !CELL_OCCUPIED;
                    assert_eq!(cell & ((1 << CELL_INDEX_BITS) - 1), index);
                    assert_eq!(cell >> CELL_INDEX_BITS & 0xff, packed.bricks[index as usize * 2] & 0xff);
                }
            }
        }
        // The bricks of a tree, and only they.
        let (mut tree, grid) = (packed.cells.to_vec(), packed.grids[0]);
        assert!(grid.top_shift == 5 && packed.add_blocks(&mut tree, &packed.grids));
        let top = grid.top_offset as usize..grid.top_offset as usize + grid.top_size.element_product() as usize;
        assert_eq!(tree[top.clone()], packed.cells[top.clone()]);
        let blocks = |cells: &[u32]| {
            cells
                .iter()
                .filter(|cell| *cell >> 31 == 1)
                .map(|cell| (cell >> CELL_INDEX_BITS & 0xff).count_ones())
                .sum::<u32>()
        };
        assert_eq!(blocks(&tree[top.end..]), blocks(&cells));
        let large = Geometry { bricks: vec![0; 4 << CELL_INDEX_BITS].into(), ..packed.clone() };
        assert!(!large.add_blocks(&mut cells, &grids), "numbers that need the bits");
    }

    #[test]
    fn a_scene_with_dense_cells_is_valid_and_the_same() {
        let (scene, packed) = city();
        let (cells, grids) = packed.dense_cells().expect("a city is dense enough");
        assert_ne!(cells.len(), packed.cells.len());
        let dense = Geometry { cells: cells.into(), grids: grids.into(), ..packed.clone() };
        dense.validate().unwrap();
        let dense = PackedScene { geometry: dense.into(), ..scene.clone() };
        for (tree, dense) in scene.to_scene().grids.iter().zip(&dense.to_scene().grids) {
            assert!(tree.voxels().eq(dense.voxels()));
        }
    }

    /// Cells of a tree that are empty: edge in voxels, lowest corner from the grid's origin, word.
    fn empty_cells(cells: &[u32], grid: &PackedGrid) -> Vec<(i32, IVec3, u32)> {
        let count = grid.top_size.element_product() as usize;
        let mut open: Vec<(u32, IVec3, u32)> = (0..count)
            .map(|i| (grid.top_shift, position(grid.top_size, i), cells[grid.top_offset as usize + i]))
            .collect();
        let mut empty = Vec::new();
        while let Some((shift, at, cell)) = open.pop() {
            if cell & CELL_OCCUPIED == 0 {
                empty.push((1 << shift, at << shift as i32, cell));
            } else if shift > 3 {
                let node = (cell & !CELL_OCCUPIED) as usize * 64;
                open.extend((0..64).map(|local| (shift - 2, at * 4 + cell_at(local), cells[node + local])));
            }
        }
        empty
    }

    #[test]
    fn boxes_in_a_tree_are_empty_inside_the_grid_and_reach_beyond_their_nodes() {
        let (_, packed) = city();
        let grid = &packed.grids[0];
        assert!(grid.top_shift > 3, "a tree");
        let cells = packed.tree_with_boxes();
        let bricks: Vec<IVec3> = packed.brick_cells(grid).into_iter().map(|(at, _)| at * 8).collect();
        let is_empty = |edge: i32, low: IVec3, word: u32| {
            let extents = |side: u32| {
                IVec3::from_array(std::array::from_fn(|axis| (word >> (5 * (3 * side + axis as u32))) as i32 & 31))
            };
            let (from, to) = (low - extents(1) * edge, low + edge + extents(0) * edge);
            from.cmpge(IVec3::ZERO).all()
                && to.cmple(grid.top_size << grid.top_shift as i32).all()
                && !bricks.iter().any(|&brick| brick.cmplt(to).all() && (brick + 8).cmpgt(from).all())
        };
        let empty = empty_cells(&cells, grid);
        for &(edge, low, word) in &empty {
            assert!(is_empty(edge, low, word), "{edge} wide at {low}");
        }
        assert!(empty.iter().any(|&(edge, _, word)| edge == 8 && word & 31 > 4), "into other nodes");
        // The check sees boxes that are one cell too large.
        let larger = |&(edge, low, word): &(i32, IVec3, u32)| word & 31 < 31 && !is_empty(edge, low, word + 1);
        assert!(empty.iter().any(larger));
        // Nothing else changed.
        let occupied = |cells: &[u32]| cells.iter().map(|cell| cell & CELL_OCCUPIED).collect::<Vec<_>>();
        assert_eq!(occupied(&cells), occupied(&packed.cells));
        Geometry { cells: cells.into(), ..packed.clone() }.validate().unwrap();
    }
}
