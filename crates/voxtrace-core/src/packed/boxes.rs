//! Empty boxes: how far a ray may go from an empty cell, on each axis and in each direction on its own.
//!
//! One box for all directions serves rays that run along floors and walls better than a cube for each octant: the cube
//! ends at the floor, the box goes on beside it. Boxes grow by one cell at a time on all six sides, each until it meets an
//! occupied cell. Sums over all boxes from the first cell on (Crow, SIGGRAPH 1984) say whether a layer is empty.

use glam::IVec3;

/// Bits of each of the six extents of a box in a cell's word.
const EXTENT_BITS: u32 = 5;
/// Most cells that a box extends beyond its own cell to one side.
const MAX_EXTENT: i32 = (1 << EXTENT_BITS) - 1;

/// The word of the empty cell at `cell`: extents of the largest box that grows from it within the array, towards +x, +y,
/// +z, −x, −y, −z, from the lowest bits on.
pub(super) fn box_of(counts: &Counts, cell: IVec3) -> u32 {
    let (below, above) = grown(counts, cell);
    let extents = [above.x, above.y, above.z, below.x, below.y, below.z];
    extents.iter().rev().fold(0, |word, &extent| word << EXTENT_BITS | extent as u32)
}

/// How far the empty box around an empty cell extends below and above it.
fn grown(counts: &Counts, cell: IVec3) -> (IVec3, IVec3) {
    // All sides grow together as long as none is blocked: the largest empty cube around the cell, found by halving.
    let (mut known, mut beyond) = (0, MAX_EXTENT + 1);
    while beyond - known > 1 {
        let middle = (known + beyond) / 2;
        match counts.is_empty(cell - middle, cell + middle + 1) {
            true => known = middle,
            false => beyond = middle,
        }
    }
    let mut extents = [IVec3::splat(known); 2];
    let mut grows = [[known < MAX_EXTENT; 3]; 2];
    while grows.as_flattened().contains(&true) {
        for axis in 0..3 {
            for side in 0..2 {
                if !grows[side][axis] {
                    continue;
                }
                let (mut low, mut high) = (cell - extents[0], cell + extents[1] + 1);
                (low[axis], high[axis]) = match side {
                    0 => (low[axis] - 1, low[axis]),
                    _ => (high[axis], high[axis] + 1),
                };
                let is_empty = counts.is_empty(low, high);
                extents[side][axis] += i32::from(is_empty);
                grows[side][axis] = is_empty && extents[side][axis] < MAX_EXTENT;
            }
        }
    }
    (extents[0], extents[1])
}

/// How many cells are occupied in each box that begins at the first cell of an array.
#[derive(Default)]
pub(super) struct Counts {
    size: IVec3,
    sums: Vec<u32>,
}

impl Counts {
    /// Counts in an array of cells, x fastest.
    pub fn of(size: IVec3, occupied: &[bool]) -> Self {
        let mut counts = Self::default();
        counts.fill(size, occupied);
        counts
    }

    /// As [`Counts::of`], in the same memory.
    pub fn fill(&mut self, size: IVec3, occupied: &[bool]) {
        let edge = [size.x as usize + 1, size.y as usize + 1, size.z as usize + 1];
        let layer = edge[0] * edge[1];
        self.size = size;
        self.sums.clear();
        self.sums.resize(layer * edge[2], 0);
        let sums = &mut self.sums;
        for (row, cells) in occupied.chunks_exact(size.x as usize).enumerate() {
            let (y, z) = (row % size.y as usize + 1, row / size.y as usize + 1);
            let at = z * layer + y * edge[0];
            let mut in_row = 0;
            for (x, &is_occupied) in (1..).zip(cells) {
                in_row += u32::from(is_occupied);
                let (before, below) = (at + x - edge[0], at + x - layer);
                sums[at + x] = (in_row + sums[before] + sums[below]).wrapping_sub(sums[below - edge[0]]);
            }
        }
    }

    /// Whether all cells from `low` on and below `high` are in the array, and none of them is occupied.
    fn is_empty(&self, low: IVec3, high: IVec3) -> bool {
        if low.cmplt(IVec3::ZERO).any() || high.cmpgt(self.size).any() {
            return false;
        }
        let edge = self.size + 1;
        let sum = |x: i32, y: i32, z: i32| self.sums[((z * edge.y + y) * edge.x + x) as usize];
        let layers = |z| {
            let inside = sum(high.x, high.y, z).wrapping_sub(sum(low.x, high.y, z));
            inside.wrapping_sub(sum(high.x, low.y, z)).wrapping_add(sum(low.x, low.y, z))
        };
        layers(high.z) == layers(low.z)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Extents below and above of the box of a cell.
    fn extents(word: u32) -> (IVec3, IVec3) {
        let at = |side: u32| (word >> (EXTENT_BITS * side)) as i32 & MAX_EXTENT;
        (IVec3::new(at(3), at(4), at(5)), IVec3::new(at(0), at(1), at(2)))
    }

    /// The words of the empty cells, zero for the others.
    fn boxes_of(size: IVec3, occupied: &[bool]) -> Vec<u32> {
        let counts = Counts::of(size, occupied);
        let cells = (0..).zip(occupied);
        cells.map(|(i, &is_occupied)| if is_occupied { 0 } else { box_of(&counts, cell_at(size, i)) }).collect()
    }

    fn cell_at(size: IVec3, i: i32) -> IVec3 {
        IVec3::new(i % size.x, i / size.x % size.y, i / size.x / size.y)
    }

    /// Whether a box is empty and in the array, and none of its sides could be farther out.
    fn is_empty_and_largest(size: IVec3, occupied: &[bool], cell: IVec3, word: u32) -> bool {
        let (below, above) = extents(word);
        let is_empty = |low: IVec3, high: IVec3| {
            low.cmpge(IVec3::ZERO).all()
                && high.cmplt(size).all()
                && !(low.z..=high.z).any(|z| {
                    (low.y..=high.y)
                        .any(|y| (low.x..=high.x).any(|x| occupied[((z * size.y + y) * size.x + x) as usize]))
                })
        };
        let cannot_grow = |axis: usize| {
            let (mut low, mut high) = (below, above);
            low[axis] += 1;
            high[axis] += 1;
            (below[axis] == MAX_EXTENT || !is_empty(cell - low, cell + above))
                && (above[axis] == MAX_EXTENT || !is_empty(cell - below, cell + high))
        };
        is_empty(cell - below, cell + above) && (0..3).all(cannot_grow)
    }

    #[test]
    fn boxes_are_empty_and_cannot_grow() {
        let size = IVec3::new(70, 23, 37);
        let count = size.element_product() as usize;
        // A floor, and single cells here and there below it.
        let is_floor = |i: usize| i / (70 * 23) == 5;
        let occupied: Vec<bool> = (0..count)
            .map(|i| is_floor(i) || i / (70 * 23) < 5 && (i as u32).wrapping_mul(0x9E37_79B9) >> 22 == 7)
            .collect();
        let words = boxes_of(size, &occupied);
        for (i, &word) in words.iter().enumerate() {
            assert_eq!(word >> 30, 0, "thirty bits");
            if !occupied[i] {
                let cell = cell_at(size, i as i32);
                assert!(is_empty_and_largest(size, &occupied, cell, word), "{cell}");
            }
        }
        // Above the floor it goes far along it, and not through it.
        let above_floor = ((6 * size.y + 11) * size.x + 35) as usize;
        assert_eq!(extents(words[above_floor]), (IVec3::new(31, 11, 0), IVec3::new(31, 11, 30)));
        // The comparison sees a box that is one cell too large, and one that is too small.
        let at = cell_at(size, above_floor as i32);
        assert!(!is_empty_and_largest(size, &occupied, at, words[above_floor] + (1 << (5 * EXTENT_BITS))));
        assert!(!is_empty_and_largest(size, &occupied, at, words[above_floor] - 1));
    }

    #[test]
    fn a_box_ends_where_the_array_does() {
        let words = boxes_of(IVec3::new(3, 1, 2), &[false; 6]);
        assert_eq!(extents(words[1]), (IVec3::new(1, 0, 0), IVec3::new(1, 0, 1)));
    }
}
