//! Skip distances for empty-space skipping, one for each ray octant: how many cells a ray may advance from an empty cell without
//! meeting an occupied one.
//!
//! For each of the eight sign patterns of a direction (octants) an empty cell stores the edge of the largest empty cube
//! of cells that extends from it along that octant, a directional Chebyshev distance field: the cube at a cell is one larger than the
//! smallest cube at its seven neighbours along the octant. Levels are processed from coarse to fine; a neighbour that has no node of its own
//! takes the bound of the empty coarse cell around it.
//!
//! The top level is one pass of dynamic programming. In nodes a set of 64 cells is one word: the cells with cubes of edge *k* + 1 are the empty ones
//! among the erosion of those of edge *k* by a cube of two cells, which is shifts and conjunctions, for all nodes in any order.

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
    // The runs of the levels so far, by octants.
    let mut runs: Vec<[Vec<u8>; 8]> = Vec::with_capacity(levels.len());
    let mut words = Vec::with_capacity(levels.len());
    for (depth, level) in levels.iter().enumerate() {
        let is_finest = depth + 1 == levels.len();
        let (own, codes) =
            if level.is_top() { of_top(level) } else { of_nodes(&levels[..depth], &runs, level, is_finest) };
        runs.push(own);
        words.push(codes);
    }
    words
}

/// The code of the largest skip distance that is at most `run` ≥ 1.
fn code_of(run: u8) -> u32 {
    SKIP_DISTANCES.iter().rposition(|&distance| distance <= run).unwrap_or(0) as u32
}

/// Edges of the largest empty cubes of the cells of the top level along each octant, at most [`MAX_RUN`], 0 for an occupied cell;
/// and the words of the cells.
fn of_top(level: &Level) -> ([Vec<u8>; 8], Vec<u32>) {
    let mut runs: [Vec<u8>; 8] = Default::default();
    runs.par_iter_mut().enumerate().for_each(|(octant, runs)| *runs = runs_of_top(level, octant_step(octant)));
    let codes = std::array::from_fn::<u32, { MAX_RUN as usize + 1 }, _>(|run| code_of(run as u8));
    let word =
        |cell: usize| (0..8).fold(0, |word, octant| word | codes[usize::from(runs[octant][cell])] << (3 * octant));
    let words = (0..level.occupied.len()).into_par_iter().with_min_len(CHUNK).map(word).collect();
    (runs, words)
}

fn runs_of_top(level: &Level, step: IVec3) -> Vec<u8> {
    let mut runs = vec![0; level.occupied.len()];
    let [width, height, depth] = level.size.to_array();
    let row = |y: i32, z: i32| {
        let is_inside = (0..height).contains(&y) && (0..depth).contains(&z);
        let start = ((z * height + y) * width) as usize;
        is_inside.then(|| start..start + width as usize)
    };
    let mut beyond = vec![MAX_RUN; width as usize];
    for z in against(step.z, depth) {
        for y in against(step.y, height) {
            // The least of the three rows beyond this one.
            beyond.fill(MAX_RUN);
            let rows = [(step.y, 0), (0, step.z), (step.y, step.z)];
            for row in rows.into_iter().filter_map(|(dy, dz)| row(y + dy, z + dz)) {
                beyond.iter_mut().zip(&runs[row]).for_each(|(least, &run)| *least = run.min(*least));
            }
            let own = row(y, z).expect("the iteration stays inside");
            let (runs, occupied) = (&mut runs[own.clone()], &level.occupied[own]);
            let mut next = MAX_RUN;
            for x in against(step.x, width) {
                let x = x as usize;
                let least = next.min(beyond[x]);
                runs[x] = if occupied[x] { 0 } else { MAX_RUN.min(least + 1) };
                next = runs[x].min(beyond[x]);
            }
        }
    }
    runs
}

/// +1 or −1 for each axis: bit a of an octant's number says that the direction is negative along axis a.
fn octant_step(octant: usize) -> IVec3 {
    let sign = |axis: usize| if octant >> axis & 1 == 1 { -1 } else { 1 };
    IVec3::new(sign(0), sign(1), sign(2))
}

/// The places of a row, those further along `step` first.
fn against(step: i32, size: i32) -> impl Iterator<Item = i32> {
    (0..size).map(move |i| if step > 0 { size - 1 - i } else { i })
}

/// Nodes worked on by one task.
const CHUNK: usize = 1 << 11;

/// Runs of the cells of nodes along each octant, but of the finest level, whose runs nothing asks for; and the words of the cells.
fn of_nodes(coarser: &[Level], runs: &[[Vec<u8>; 8]], level: &Level, is_finest: bool) -> ([Vec<u8>; 8], Vec<u32>) {
    let count = level.nodes.len();
    let around = nodes_around(level);
    let mut own: [Vec<u8>; 8] = Default::default();
    let mut words = vec![0; count * 64];
    // Of one octant at a time: the cells with cubes of edge k + 1 and more, and what lies beside each node.
    let mut sets: [Vec<u64>; MAX_RUN as usize] = std::array::from_fn(|_| vec![0; count]);
    let mut beside = vec![[Beside::default(); 7]; count];
    for (octant, own) in own.iter_mut().enumerate() {
        let step = octant_step(octant);
        let coarser_runs: Vec<&[u8]> = runs.iter().map(|runs| &*runs[octant]).collect();
        by_chunks(&mut beside, 1, |first, beside| {
            for (index, beside) in beside.iter_mut().enumerate() {
                let at = level.nodes[first + index];
                *beside = std::array::from_fn(|side| {
                    let offset = step * offset_of(side + 1);
                    match around[first + index][around_index(offset)] {
                        NO_NODE => Beside::empty(at + offset, step, coarser, &coarser_runs),
                        node => Beside(node),
                    }
                });
            }
        });
        by_chunks(&mut sets[0], 1, |first, empty| {
            for (index, empty) in empty.iter_mut().enumerate() {
                let occupied = &level.occupied[(first + index) * 64..][..64];
                let set = occupied.iter().rev().fold(0, |set, &is_occupied| set << 1 | u64::from(!is_occupied));
                *empty = mirrored_cells(set, octant);
            }
        });
        for k in 1..MAX_RUN {
            let (smaller, larger) = sets.split_at_mut(usize::from(k));
            let (empty, smaller) = (&smaller[0], &smaller[usize::from(k) - 1]);
            by_chunks(&mut larger[0], 1, |first, larger| {
                for (index, larger) in larger.iter_mut().enumerate() {
                    let node = first + index;
                    let cells = smaller[node];
                    *larger = if cells == 0 { 0 } else { empty[node] & eroded(cells, &beside[node], k, smaller) };
                }
            });
        }
        by_chunks(&mut words, 64, |first, words| {
            let thresholds = SKIP_DISTANCES.map(|distance| &sets[usize::from(distance) - 1]);
            for (index, words) in words.as_chunks_mut::<64>().0.iter_mut().enumerate() {
                let planes: [u64; 3] = planes_of(thresholds.iter().skip(1).map(|set| set[first + index]));
                let planes = planes.map(|plane| mirrored_cells(plane, octant));
                for (cell, word) in words.iter_mut().enumerate() {
                    let code = |bit: usize| (planes[bit] >> cell & 1) << bit;
                    *word |= ((code(0) | code(1) | code(2)) as u32) << (3 * octant);
                }
            }
        });
        if !is_finest {
            own.resize(count * 64, 0);
            by_chunks(own, 64, |first, own| {
                for (index, own) in own.as_chunks_mut::<64>().0.iter_mut().enumerate() {
                    let planes: [u64; 5] = planes_of(sets.iter().map(|set| set[first + index]));
                    let planes = planes.map(|plane| mirrored_cells(plane, octant));
                    for (cell, run) in own.iter_mut().enumerate() {
                        *run = (0..5).fold(0, |run, bit| run | ((planes[bit] >> cell & 1) << bit) as u8);
                    }
                }
            });
        }
    }
    (own, words)
}

/// Works on pieces of items, each of so many values, at once; a task is told its first item.
fn by_chunks<T: Send>(values: &mut [T], of_item: usize, work: impl Fn(usize, &mut [T]) + Sync) {
    if values.len() <= CHUNK * of_item {
        return work(0, values);
    }
    values.par_chunks_mut(CHUNK * of_item).enumerate().for_each(|(chunk, values)| work(chunk * CHUNK, values));
}

/// There is no node.
const NO_NODE: u32 = u32::MAX;

/// An offset of 0 or 1 along each axis, from its three bits.
fn offset_of(side: usize) -> IVec3 {
    let side = side as i32;
    IVec3::new(side & 1, side >> 1 & 1, side >> 2)
}

/// Where the node at an offset of −1 to 1 along each axis stands among the 27.
fn around_index(offset: IVec3) -> usize {
    (offset + 1).dot(IVec3::new(1, 3, 9)) as usize
}

/// The numbers of the nodes around each node and of its own, x fastest. Nodes are in order, so that the nodes at one offset from them are, too.
fn nodes_around(level: &Level) -> Vec<[u32; 27]> {
    let nodes = &level.nodes;
    let place = |at: IVec3| (at.z, at.y, at.x);
    let mut around = vec![[NO_NODE; 27]; nodes.len()];
    by_chunks(&mut around, 1, |first, around| {
        for row in 0..9 {
            let offset = IVec3::new(-1, row % 3 - 1, row / 3 - 1);
            let mut next = nodes.partition_point(|&node| place(node) < place(nodes[first] + offset));
            for (&node, around) in nodes[first..].iter().zip(&mut *around) {
                let from = node + offset;
                while next < nodes.len() && place(nodes[next]) < place(from) {
                    next += 1;
                }
                let candidates = nodes[next..].iter().take(3).enumerate();
                for (further, candidate) in
                    candidates.take_while(|(_, at)| (at.y, at.z) == (from.y, from.z) && at.x <= from.x + 2)
                {
                    around[(candidate.x - from.x + 3 * row) as usize] = (next + further) as u32;
                }
            }
        }
    });
    around
}

/// What lies beside a node along an octant: the number of a node, or an empty region and how far it reaches along each axis from the
/// first cell of the node that is missing, at most [`MAX_REACH`] cells, five bits each.
#[derive(Clone, Copy, Default)]
struct Beside(u32);

/// Marks a [`Beside`] without a node.
const IS_EMPTY: u32 = 1 << 31;

/// As far as anything asks: from the last cell of a node so many cells as the largest run.
const MAX_REACH: i32 = MAX_RUN as i32 + 3;

impl Beside {
    fn empty(node: IVec3, step: IVec3, coarser: &[Level], coarser_runs: &[&[u8]]) -> Self {
        let end = end_of_empty(coarser, coarser_runs, node, step);
        let reach = (end - mirrored(node, step) * 4).clamp(IVec3::ZERO, IVec3::splat(MAX_REACH));
        Self(IS_EMPTY | reach.dot(IVec3::new(1, 1 << 5, 1 << 10)) as u32)
    }

    /// The cells there with cubes of edge `k` and more, whose sets the nodes have in `sets`.
    fn cells(self, k: u8, sets: &[u64]) -> u64 {
        if self.0 & IS_EMPTY == 0 {
            return sets[self.0 as usize];
        }
        // Along each axis as many cells as reach so far.
        let count = |axis: u32| ((self.0 >> (5 * axis) & 31) as usize + 1).saturating_sub(usize::from(k)).min(4);
        FIRST_CELLS[0][count(0)] & FIRST_CELLS[1][count(1)] & FIRST_CELLS[2][count(2)]
    }
}

/// The cells of a node whose coordinate along an axis is below 0 to 4.
const FIRST_CELLS: [[u64; 5]; 3] = [
    [0, 0x1111_1111_1111_1111, 0x3333_3333_3333_3333, 0x7777_7777_7777_7777, u64::MAX],
    [0, 0x000f_000f_000f_000f, 0x00ff_00ff_00ff_00ff, 0x0fff_0fff_0fff_0fff, u64::MAX],
    [0, 0xffff, 0xffff_ffff, 0xffff_ffff_ffff, u64::MAX],
];

/// The cells of a node all of whose neighbours along the octant (in mirrored cells: those one further along each axis) have cubes of edge `k` and
/// more, as they have themselves.
fn eroded(cells: u64, beside: &[Beside; 7], k: u8, sets: &[u64]) -> u64 {
    let [x, y, xy, z, xz, yz, xyz] = beside.map(|beside| beside.cells(k, sets));
    let along = |axis: usize, cells: u64, next: u64| {
        let shift = 1 << (2 * axis);
        cells & ((cells >> shift & FIRST_CELLS[axis][3]) | next << (3 * shift) & !FIRST_CELLS[axis][3])
    };
    let near = along(1, along(0, cells, x), along(0, y, xy));
    let far = along(1, along(0, z, xz), along(0, yz, xyz));
    along(2, near, far)
}

/// For sets of cells, each within the one before it: in how many of them a cell is, as planes of bits.
fn planes_of<const N: usize>(sets: impl Iterator<Item = u64>) -> [u64; N] {
    let mut planes = [0; N];
    for (count, set) in (1..).zip(sets) {
        for (bit, plane) in planes.iter_mut().enumerate() {
            *plane = if count >> bit & 1 == 1 { *plane | set } else { *plane & !set };
        }
    }
    planes
}

/// The cells of a node with the axes reversed along which an octant is negative.
fn mirrored_cells(mut cells: u64, octant: usize) -> u64 {
    for (axis, first) in FIRST_CELLS.iter().enumerate().filter(|(axis, _)| octant >> axis & 1 == 1) {
        let shift = 1 << (2 * axis);
        cells = (cells & first[2]) << (2 * shift) | cells >> (2 * shift) & first[2];
        let even = first[1] | first[1] << (2 * shift);
        cells = (cells & even) << shift | cells >> shift & even;
    }
    cells
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
fn end_of_empty(coarser: &[Level], coarser_runs: &[&[u8]], node: IVec3, step: IVec3) -> IVec3 {
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

#[cfg(test)]
mod tests;
