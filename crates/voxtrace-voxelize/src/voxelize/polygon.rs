//! Clips convex polygons to the cells of a grid: first into slabs along x, then rows along y, then cells along z (Sutherland and
//! Hodgman, "Reentrant Polygon Clipping", 1974). Each piece is the part of a triangle inside one cell, so occupancy, area and
//! centroid come from the same clipping.

/// A point in voxels.
pub(super) type Point = [f64; 3];

/// Most corners: a triangle gains at most one with each of the six planes of a box, and a few may be double.
const MOST_CORNERS: usize = 12;

/// Tolerance, in cells: what reaches less than this into a cell is rounding, as the lattice is coarser, and does not count.
pub(super) const TOUCH: f64 = 1e-7;

/// A convex polygon.
#[derive(Clone, Copy)]
pub(super) struct Polygon {
    corners: [Point; MOST_CORNERS],
    count: usize,
}

impl Polygon {
    const EMPTY: Self = Self { corners: [[0.0; 3]; MOST_CORNERS], count: 0 };

    pub fn new(corners: &[Point]) -> Self {
        let mut polygon = Self::EMPTY;
        for &corner in corners {
            polygon.push(corner);
        }
        polygon
    }

    pub fn corners(&self) -> &[Point] {
        &self.corners[..self.count]
    }

    #[inline(always)]
    fn push(&mut self, corner: Point) {
        // There is always room, by the count of planes above; the test is for the compiler.
        if self.count < MOST_CORNERS {
            self.corners[self.count] = corner;
            self.count = self.count.wrapping_add(1);
        }
    }

    /// Lowest and highest coordinate along an axis.
    #[inline(always)]
    pub fn range(&self, axis: usize) -> (f64, f64) {
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for corner in self.corners() {
            low = low.min(corner[axis]);
            high = high.max(corner[axis]);
        }
        (low, high)
    }

    /// The parts below and above the plane at `at` along an axis.
    #[inline(always)]
    fn split(&self, axis: usize, at: f64, below: &mut Self, above: &mut Self) {
        (below.count, above.count) = (0, 0);
        let corners = self.corners();
        let Some(&(mut last)) = corners.last() else { return };
        let mut last_side = last[axis] - at;
        for &corner in corners {
            let side = corner[axis] - at;
            if last_side * side < 0.0 {
                let t = last_side / (last_side - side);
                let mut cut = [0, 1, 2].map(|a| last[a] + (corner[a] - last[a]) * t);
                cut[axis] = at;
                below.push(cut);
                above.push(cut);
            }
            if side <= 0.0 {
                below.push(corner);
            }
            if side >= 0.0 {
                above.push(corner);
            }
            (last, last_side) = (corner, side);
        }
    }

    /// Whether the polygon lies between two planes along an axis.
    #[inline(always)]
    pub fn is_between(&self, axis: usize, from: f64, to: f64) -> bool {
        self.corners().iter().all(|corner| corner[axis] >= from && corner[axis] <= to)
    }

    /// Clips to the space between two planes along an axis; becomes empty where it reaches less than [`TOUCH`] into it.
    pub fn clip(&mut self, axis: usize, from: f64, to: f64) {
        let (low, high) = self.range(axis);
        if !(high > from + TOUCH && low < to - TOUCH) {
            self.count = 0;
            return;
        }
        let (mut below, mut above) = (Self::EMPTY, Self::EMPTY);
        if low < from {
            self.split(axis, from, &mut below, &mut above);
            *self = above;
        }
        if high > to {
            self.split(axis, to, &mut below, &mut above);
            *self = below;
        }
    }
}

/// Floor of a value that fits into 32 bits; the library's floor is a function call where SSE4.1 may be absent. Coordinates of voxels have
/// 21 bits ([`super::placement`] checks that): sums of them need no check in the innermost loops, where it would cost a twentieth.
#[inline(always)]
fn floor(value: f64) -> i32 {
    let cut = value as i32;
    cut.wrapping_sub(i32::from(value < f64::from(cut)))
}

/// Cells from the lowest to the highest that a range reaches, at least one.
#[inline(always)]
pub(super) fn cells_of((low, high): (f64, f64), touch: f64) -> (i32, i32) {
    let first = floor(low + touch);
    let last = floor(touch - high).wrapping_neg().wrapping_sub(1);
    (first, last.max(first))
}

/// Buffers for the pieces being clipped, one set for each axis.
pub(super) struct Pieces([[Polygon; 3]; 3]);

impl Pieces {
    pub fn new() -> Self {
        Self([[Polygon::EMPTY; 3]; 3])
    }
}

/// Calls `each` with every cell that the polygon reaches and the part of the polygon inside it.
#[inline(always)]
pub(super) fn for_each_cell(
    polygon: &Polygon,
    touch: f64,
    pieces: &mut Pieces,
    mut each: impl FnMut([i32; 3], &Polygon),
) {
    let [slabs, rows, cells] = &mut pieces.0;
    slice::<0>(polygon, touch, slabs, |x, slab| {
        slice::<1>(slab, touch, rows, |y, row| slice::<2>(row, touch, cells, |z, piece| each([x, y, z], piece)));
    });
}

#[inline(always)]
fn slice<const AXIS: usize>(
    polygon: &Polygon,
    touch: f64,
    [below, even, odd]: &mut [Polygon; 3],
    mut each: impl FnMut(i32, &Polygon),
) {
    if polygon.count < 3 {
        return;
    }
    let (first, last) = cells_of(polygon.range(AXIS), touch);
    if first == last {
        return each(first, polygon);
    }
    // The rest alternates between two buffers.
    polygon.split(AXIS, f64::from(first) + 1.0, below, even);
    each(first, below);
    let (mut rest, mut other) = (even, odd);
    for cell in first.wrapping_add(1)..last {
        rest.split(AXIS, f64::from(cell) + 1.0, below, other);
        each(cell, below);
        std::mem::swap(&mut rest, &mut other);
    }
    each(last, rest);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn area(polygon: &Polygon) -> f64 {
        use glam::DVec3;
        let corners: Vec<DVec3> = polygon.corners().iter().map(|&corner| DVec3::from_array(corner)).collect();
        (2..corners.len()).map(|i| (corners[i - 1] - corners[0]).cross(corners[i] - corners[0]).length() * 0.5).sum()
    }

    #[test]
    fn the_pieces_of_a_triangle_add_up_to_it_and_stay_in_their_cells() {
        let triangle = Polygon::new(&[[0.25, -3.5, 1.0], [7.75, 2.125, 4.5], [-2.0, 6.0, 9.0]]);
        let mut sum = 0.0;
        let mut count = 0;
        for_each_cell(&triangle, TOUCH, &mut Pieces::new(), |cell, piece| {
            sum += area(piece);
            count += 1;
            for corner in piece.corners() {
                for axis in 0..3 {
                    let inside = corner[axis] - f64::from(cell[axis]);
                    assert!((-1e-9..=1.0 + 1e-9).contains(&inside), "{cell:?} {corner:?}");
                }
            }
        });
        assert!((sum - area(&triangle)).abs() < 1e-9, "{sum} {}", area(&triangle));
        assert!(count > 80);
    }

    #[test]
    fn a_triangle_that_ends_at_a_plane_does_not_reach_beyond_it() {
        let mut cells = Vec::new();
        let triangle = Polygon::new(&[[1.0, 1.0, 0.5], [3.0, 1.0, 0.5], [1.0, 2.0, 0.5]]);
        for_each_cell(&triangle, TOUCH, &mut Pieces::new(), |cell, _| cells.push(cell));
        assert_eq!(cells, [[1, 1, 0], [2, 1, 0]]);
    }

    #[test]
    fn whole_numbers_are_those_below() {
        for value in [-2.5, -2.0, -0.1, 0.0, 0.9, 1.0, 1e6 + 0.5, -1e6 - 0.5] {
            assert_eq!(floor(value), value.floor() as i32);
        }
    }

    #[test]
    fn what_only_touches_a_slab_is_not_in_it() {
        let triangle = Polygon::new(&[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]);
        let clipped = |from, to| {
            let mut polygon = triangle;
            polygon.clip(0, from, to);
            polygon
        };
        assert_eq!(clipped(1.0, 2.0).corners().len(), 0);
        assert_eq!(clipped(-1.0, 0.0).corners().len(), 0);
        assert!((area(&clipped(0.5, 2.0)) - 0.125).abs() < 1e-12);
        assert!(triangle.is_between(0, 0.0, 1.0) && !triangle.is_between(1, 0.5, 1.0));
    }
}
