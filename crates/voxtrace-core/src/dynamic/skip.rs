//! Skip distances of a scene that changes. A distance is a lower bound: as many cells ahead, along its octant, are empty. What becomes full
//! shortens each distance that reaches over it; what becomes empty changes none, until [`super::repair`] finds the largest ones.
//!
//! Both look at a box of cells as rows of bits. A cell may skip n cells unless something lies in the n³ cells ahead of it, which are the places
//! that what is full covers when it is spread by n − 1 cells against the octant, along one axis after the other.

use super::cells::{node_position, top_position};
use super::fields::{LONGEST, lesser};
use crate::packed::{CELL_OCCUPIED, Geometry, PackedGrid, SKIP_DISTANCES};
use glam::IVec3;

/// Cells that the longest skip distance reaches beyond its cell.
pub(super) const REACH: i32 = SKIP_DISTANCES[7] as i32 - 1;
/// Cells along an edge of a box that is looked at: with the reach on one side it fits 64 bits.
pub(super) const TILE: i32 = 48;

/// Skip distances of a box of cells, x fastest.
pub(super) struct Distances {
    pub low: IVec3,
    pub size: IVec3,
    words: Vec<u32>,
}

impl Distances {
    /// Of a box in which nothing lies ahead of any cell.
    fn longest(low: IVec3, high: IVec3) -> Self {
        let size = high - low;
        Self { low, size, words: vec![LONGEST; size.element_product() as usize] }
    }

    fn index(&self, cell: IVec3) -> usize {
        let at = (cell - self.low).as_uvec3();
        ((at.z * self.size.y as u32 + at.y) * self.size.x as u32 + at.x) as usize
    }

    pub fn at(&self, cell: IVec3) -> u32 {
        self.words[self.index(cell)]
    }

    /// Those of so many cells in a row.
    pub fn row(&self, cell: IVec3, count: usize) -> &[u32] {
        let first = self.index(cell);
        &self.words[first..first + count]
    }
}

/// Rows of bits along x, 64 at most, of a box of cells.
struct Rows {
    low: IVec3,
    size: IVec3,
    rows: Vec<u64>,
}

impl Rows {
    fn new(low: IVec3, high: IVec3) -> Self {
        let size = high - low;
        debug_assert!(size.x <= 64);
        Self { low, size, rows: vec![0; (size.y * size.z) as usize] }
    }

    fn set(&mut self, cell: IVec3) {
        let at = cell - self.low;
        self.rows[(at.z * self.size.y + at.y) as usize] |= 1 << at.x;
    }

    /// Spreads what is set by `count` cells along each axis, against `is_negative`'s direction.
    fn spread(&mut self, count: i32, is_negative: [bool; 3]) {
        for row in &mut self.rows {
            *row |= if is_negative[0] { *row << count } else { *row >> count };
        }
        let (row, slice) = (1, self.size.y as usize);
        for z in self.rows.chunks_exact_mut(slice) {
            spread_rows(z, count as usize * row, is_negative[1]);
        }
        spread_rows(&mut self.rows, count as usize * slice, is_negative[2]);
    }
}

/// Adds to each row the one `distance` behind it.
fn spread_rows(rows: &mut [u64], distance: usize, is_negative: bool) {
    if distance >= rows.len() {
        return;
    }
    if is_negative {
        for at in (distance..rows.len()).rev() {
            rows[at] |= rows[at - distance];
        }
    } else {
        for at in 0..rows.len() - distance {
            rows[at] |= rows[at + distance];
        }
    }
}

/// Shortens the distances of an octant in a box by what is set in `rows`.
fn shorten_octant(rows: &mut Rows, octant: u32, into: &mut Distances) {
    let is_negative = [0, 1, 2].map(|axis| octant >> axis & 1 == 1);
    let (low, high) = (into.low.max(rows.low), (into.low + into.size).min(rows.low + rows.size));
    let mut covered = vec![0u64; rows.rows.len()];
    for (code, pair) in SKIP_DISTANCES.windows(2).enumerate() {
        rows.spread(i32::from(pair[1] - pair[0]), is_negative);
        for z in low.z..high.z {
            for y in low.y..high.y {
                let at = ((z - rows.low.z) * rows.size.y + y - rows.low.y) as usize;
                let mut newly = rows.rows[at] & !covered[at];
                covered[at] = rows.rows[at];
                newly = newly >> (low.x - rows.low.x) & (u64::MAX >> (64 - (high.x - low.x)));
                let first = into.index(IVec3::new(low.x, y, z));
                while newly != 0 {
                    let word = &mut into.words[first + newly.trailing_zeros() as usize];
                    *word = *word & !(7 << (3 * octant)) | (code as u32) << (3 * octant);
                    newly &= newly - 1;
                }
            }
        }
    }
}

/// The distances that cells which become full allow to the cells around them; they lie in a box of [`TILE`] cells at most. The box of the result
/// is one of whole nodes.
pub(super) fn allowed_by(filled: &[IVec3]) -> Distances {
    let (mut low, mut high) = (IVec3::MAX, IVec3::MIN);
    for &cell in filled {
        (low, high) = (low.min(cell), high.max(cell + 1));
    }
    let mut allowed = Distances::longest((low - REACH) & !3, (high + REACH + 3) & !3);
    for octant in 0..8 {
        let is_negative = IVec3::new(octant & 1, octant >> 1 & 1, octant >> 2);
        let mut rows = Rows::new(low - REACH * (1 - is_negative), high + REACH * is_negative);
        filled.iter().for_each(|&cell| rows.set(cell));
        shorten_octant(&mut rows, octant as u32, &mut allowed);
    }
    allowed
}

/// The largest distances of the cells of a box of [`TILE`] at most, by what is full in and around it. What lies outside of the grid is empty.
pub(super) fn largest(geometry: &Geometry, grid: &PackedGrid, shift: u32, low: IVec3, high: IVec3) -> Distances {
    let full = full_cells(geometry, grid, shift, low - REACH, high + REACH);
    let mut found = Distances::longest(low, high);
    for octant in 0..8 {
        let is_negative = IVec3::new(octant & 1, octant >> 1 & 1, octant >> 2);
        let (from, to) = (low - REACH * is_negative, high + REACH * (1 - is_negative));
        let mut rows = Rows::new(from, to);
        let offset = from - full.low;
        let mask = u64::MAX >> (64 - rows.size.x);
        for z in 0..rows.size.z {
            for y in 0..rows.size.y {
                let wide = full.rows[((z + offset.z) * full.size.y + y + offset.y) as usize];
                rows.rows[(z * rows.size.y + y) as usize] = (wide >> offset.x) as u64 & mask;
            }
        }
        shorten_octant(&mut rows, octant as u32, &mut found);
    }
    found
}

impl Geometry {
    /// A cell of a box whose distance is longer along some octant than the largest one.
    pub(super) fn first_beyond(&self, grid: &PackedGrid, shift: u32, largest: &Distances) -> Option<IVec3> {
        let mut found = None;
        for_slots(self, grid, shift, (largest.low, largest.low + largest.size), |cell, position| {
            let word = self.cells[position];
            if word & CELL_OCCUPIED == 0 && lesser(word, largest.at(cell)) != word {
                found = Some(cell);
            }
        });
        found
    }
}

/// Rows of the cells of a box that are not empty.
struct WideRows {
    low: IVec3,
    size: IVec3,
    rows: Vec<u128>,
}

fn full_cells(geometry: &Geometry, grid: &PackedGrid, shift: u32, low: IVec3, high: IVec3) -> WideRows {
    let mut full = WideRows { low, size: high - low, rows: vec![0; ((high.y - low.y) * (high.z - low.z)) as usize] };
    for_slots(geometry, grid, shift, (low, high), |cell, position| {
        if geometry.cells[position] & CELL_OCCUPIED != 0 {
            let at = cell - low;
            full.rows[(at.z * full.size.y + at.y) as usize] |= 1 << at.x;
        }
    });
    full
}

/// Calls `each` with the coordinates and the position of every cell of a level that there is in a box.
pub(super) fn for_slots(
    geometry: &Geometry,
    grid: &PackedGrid,
    shift: u32,
    (low, high): (IVec3, IVec3),
    mut each: impl FnMut(IVec3, usize),
) {
    let across = grid.top_size << (grid.top_shift - shift) as i32;
    let (low, high) = (low.max(IVec3::ZERO), high.min(across));
    if low.cmpge(high).any() {
        return;
    }
    if shift == grid.top_shift {
        for z in low.z..high.z {
            for y in low.y..high.y {
                let Some(first) = top_position(grid, IVec3::new(low.x, y, z)) else { continue };
                (low.x..high.x).for_each(|x| each(IVec3::new(x, y, z), first + (x - low.x) as usize));
            }
        }
        return;
    }
    let cells = &*geometry.cells;
    let (first, last): (IVec3, IVec3) = (low >> 2, (high - 1) >> 2);
    for z in first.z..=last.z {
        for y in first.y..=last.y {
            for x in first.x..=last.x {
                let node = IVec3::new(x, y, z);
                let Some(position) = node_position(cells, grid, shift, node) else { continue };
                let (from, to) = ((low - node * 4).max(IVec3::ZERO), (high - node * 4).min(IVec3::splat(4)));
                for z in from.z..to.z {
                    for y in from.y..to.y {
                        for x in from.x..to.x {
                            each(node * 4 + IVec3::new(x, y, z), position + (x | y << 2 | z << 4) as usize);
                        }
                    }
                }
            }
        }
    }
}
