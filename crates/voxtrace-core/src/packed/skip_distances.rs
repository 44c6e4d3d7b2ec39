//! Skip distances for empty-space skipping, one for each ray octant: how many cells a ray may advance from an empty cell without
//! meeting an occupied one.
//!
//! For each of the eight sign patterns of a direction (octants) an empty cell stores the edge of the largest empty cube
//! of cells that extends from it along that octant, a directional Chebyshev distance field. One dynamic-programming pass per octant
//! and level computes it: the cube at a cell is one larger than the smallest cube at its seven neighbours along the octant. Levels are processed
//! from coarse to fine; a neighbour that has no node of its own takes the bound of the empty coarse cell around it.

use glam::IVec3;
use rayon::prelude::*;
use rustc_hash::FxHashMap;

/// The skip distances, in cells, that the three bits in an empty cell encode.
pub const SKIP_DISTANCES: [u8; 8] = [1, 2, 3, 4, 6, 8, 12, 16];
/// Largest distance that is encoded.
const MAX_RUN: u8 = SKIP_DISTANCES[7];

/// One level of a grid's tree while it is packed. The coarsest level is one dense array, the others are nodes of
/// 4×4×4 cells.
pub(super) struct Level {
    /// log₂ of the voxels along one edge of a cell.
    pub shift: u32,
    /// Coordinates of the nodes, in nodes from the grid's origin, ordered by z, y, x. Empty for the top level.
    pub nodes: Vec<IVec3>,
    /// Index in `nodes` of a node.
    pub index_of: FxHashMap<IVec3, u32>,
    /// Cells along each axis of the top level.
    pub size: IVec3,
    /// Whether a cell is occupied: the top level's cells x fastest, the others 64 for each node.
    pub occupied: Vec<bool>,
}

impl Level {
    fn is_top(&self) -> bool {
        self.nodes.is_empty()
    }

    fn top_index(&self, cell: IVec3) -> Option<usize> {
        let inside = cell.cmpge(IVec3::ZERO).all() && cell.cmplt(self.size).all();
        inside.then(|| ((cell.z * self.size.y + cell.y) * self.size.x + cell.x) as usize)
    }
}

/// The 24 bits of skip distances, three for each octant, for every cell of every level, from the coarsest level to the finest.
/// Zero where a cell is occupied.
pub(super) fn skip_distances_of(levels: &[Level]) -> Vec<Vec<u32>> {
    let octants: Vec<Vec<Vec<u8>>> = (0..8).into_par_iter().map(|octant| runs_along(levels, octant)).collect();
    levels
        .iter()
        .enumerate()
        .map(|(level, cells)| {
            let word = |cell: usize| {
                if cells.occupied[cell] {
                    return 0;
                }
                (0..8).fold(0, |word, octant| word | code_of(octants[octant][level][cell]) << (3 * octant))
            };
            (0..cells.occupied.len()).into_par_iter().map(word).collect()
        })
        .collect()
}

/// The code of the largest skip distance that is at most `run` ≥ 1.
fn code_of(run: u8) -> u32 {
    SKIP_DISTANCES.iter().rposition(|&distance| distance <= run).unwrap_or(0) as u32
}

/// Edge of the largest empty cube from every cell along one octant, at most [`MAX_RUN`], 0 for an occupied cell.
fn runs_along(levels: &[Level], octant: usize) -> Vec<Vec<u8>> {
    let step = octant_step(octant);
    let mut runs: Vec<Vec<u8>> = Vec::with_capacity(levels.len());
    for (depth, level) in levels.iter().enumerate() {
        let mut own = vec![0u8; level.occupied.len()];
        if level.is_top() {
            fill_dense(level, step, &mut own);
        } else {
            fill_nodes(&levels[..depth], &runs, level, step, &mut own);
        }
        runs.push(own);
    }
    runs
}

/// +1 or −1 for each axis: bit a of an octant's number says that the direction is negative along axis a.
fn octant_step(octant: usize) -> IVec3 {
    let sign = |axis: usize| if octant >> axis & 1 == 1 { -1 } else { 1 };
    IVec3::new(sign(0), sign(1), sign(2))
}

/// Cell coordinates of a box in the order in which each cell comes after its neighbours along `step`.
fn against(step: IVec3, size: IVec3) -> impl Iterator<Item = IVec3> {
    let along = move |step: i32, size: i32| (0..size).map(move |i| if step > 0 { size - 1 - i } else { i });
    along(step.z, size.z).flat_map(move |z| {
        along(step.y, size.y).flat_map(move |y| along(step.x, size.x).map(move |x| IVec3::new(x, y, z)))
    })
}

/// The seven neighbours along a step.
fn neighbours(step: IVec3) -> [IVec3; 7] {
    std::array::from_fn(|i| {
        let i = i as i32 + 1;
        step * IVec3::new(i & 1, i >> 1 & 1, i >> 2)
    })
}

fn fill_dense(level: &Level, step: IVec3, runs: &mut [u8]) {
    let neighbours = neighbours(step);
    for cell in against(step, level.size) {
        let index = level.top_index(cell).expect("the iteration stays inside");
        if !level.occupied[index] {
            let run = |offset: &IVec3| level.top_index(cell + offset).map_or(MAX_RUN, |at| runs[at]);
            let least = neighbours.iter().map(run).min().unwrap_or(0);
            runs[index] = MAX_RUN.min(least + 1);
        }
    }
}

/// What lies beside a node: another node, or an empty region that ends at `end` (exclusive, counted along the octant
/// in cells of this level).
enum Beside {
    Node(usize),
    Empty { end: IVec3 },
}

fn fill_nodes(coarser: &[Level], coarser_runs: &[Vec<u8>], level: &Level, step: IVec3, runs: &mut [u8]) {
    let offsets = neighbours(step);
    // Nodes are ordered by z, y, x: along a negative step the order as it is visits neighbours first, along a positive
    // one the reverse. Mixed signs need a sort of their own.
    let mut order: Vec<u32> = (0..level.nodes.len() as u32).collect();
    order.sort_by_key(|&node| {
        let at = level.nodes[node as usize] * -step;
        (at.z, at.y, at.x)
    });
    for node in order {
        let node = node as usize;
        let at = level.nodes[node];
        let beside: [Beside; 8] = std::array::from_fn(|i| {
            let i = i as i32;
            let other = at + step * IVec3::new(i & 1, i >> 1 & 1, i >> 2);
            match level.index_of.get(&other) {
                Some(&index) => Beside::Node(index as usize),
                None => Beside::Empty { end: end_of_empty(coarser, coarser_runs, other, step) },
            }
        });
        for local in against(step, IVec3::splat(4)) {
            let index = node * 64 + cell_index(local);
            if level.occupied[index] {
                continue;
            }
            let run = |offset: &IVec3| {
                let neighbour = local + offset;
                let outside = neighbour.cmpne(neighbour & 3);
                let side = outside.bitmask() as usize;
                match &beside[side] {
                    Beside::Node(other) => runs[other * 64 + cell_index(neighbour & 3)],
                    Beside::Empty { end } => {
                        let cell = mirrored(at * 4 + neighbour, step);
                        (*end - cell).min_element().clamp(0, i32::from(MAX_RUN)) as u8
                    }
                }
            };
            let least = offsets.iter().map(run).min().unwrap_or(0);
            runs[index] = MAX_RUN.min(least + 1);
        }
    }
}

fn cell_index(local: IVec3) -> usize {
    (local.x | local.y << 2 | local.z << 4) as usize
}

/// Coordinates that grow along `step`: i for +1, −1 − i for −1, so that halving still rounds down.
fn mirrored(cell: IVec3, step: IVec3) -> IVec3 {
    IVec3::select(step.cmplt(IVec3::ZERO), -1 - cell, cell)
}

/// For a place without a node: where the empty cube around it ends along the octant, in mirrored cells of the level
/// that has no node there.
fn end_of_empty(coarser: &[Level], coarser_runs: &[Vec<u8>], node: IVec3, step: IVec3) -> IVec3 {
    let mut cell = node;
    let mut cells_per_coarse_cell = 4;
    for (level, runs) in coarser.iter().zip(coarser_runs).rev() {
        let run = if level.is_top() {
            level.top_index(cell).map_or(Some(MAX_RUN), |index| Some(runs[index]))
        } else {
            level.index_of.get(&(cell >> 2)).map(|&index| runs[index as usize * 64 + cell_index(cell & 3)])
        };
        if let Some(run) = run {
            return (mirrored(cell, step) + i32::from(run)) * cells_per_coarse_cell;
        }
        cell >>= 2;
        cells_per_coarse_cell *= 4;
    }
    unreachable!("the top level covers every place")
}
