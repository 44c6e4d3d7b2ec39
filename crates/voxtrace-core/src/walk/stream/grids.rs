//! The grids that lanes walk through: one for all, or one for each.

use super::Lanes;
use super::arrivals::GRID;
use super::kernel::cell_index;
use crate::packed::PackedGrid;
use crate::walk::simd::{LANES, Simd};
use glam::IVec3;

/// What is asked of the lanes' grids. Each answer has a number for each lane.
pub trait Grids<S: Simd> {
    /// The grid's first voxel.
    fn origin(&self, s: S, lanes: &Lanes, axis: usize) -> S::Ints;
    /// Cells of the top array along an axis.
    fn size(&self, s: S, lanes: &Lanes, axis: usize) -> S::Ints;
    /// Where the top array begins.
    fn offset(&self, s: S, lanes: &Lanes) -> S::Ints;
    /// The top cells that hold voxels.
    fn top(&self, s: S, lanes: &Lanes, voxel: [S::Ints; 3]) -> [S::Ints; 3];

    /// From the words of top cells, in the lanes of `known`, down to those of the finest level that is stored above bricks.
    ///
    /// # Safety
    /// The scene must be valid.
    unsafe fn descend(
        &self,
        s: S,
        lanes: &Lanes,
        cells: &[u32],
        voxel: [S::Ints; 3],
        cell: S::Ints,
        known: S::Mask,
    ) -> Descent<S>;
}

/// Where a descent ended.
#[derive(Clone, Copy)]
pub struct Descent<S: Simd> {
    /// The words of the cells.
    pub cell: S::Ints,
    /// log₂ of their sizes.
    pub shift: S::Ints,
    /// Lanes whose cell is a node of bricks.
    pub in_node: S::Mask,
}

/// One grid for all lanes.
#[derive(Clone, Copy)]
pub struct OneGrid<'a>(pub &'a PackedGrid);

impl<S: Simd> Grids<S> for OneGrid<'_> {
    #[inline(always)]
    fn origin(&self, s: S, _: &Lanes, axis: usize) -> S::Ints {
        s.ints(self.0.origin[axis])
    }

    #[inline(always)]
    fn size(&self, s: S, _: &Lanes, axis: usize) -> S::Ints {
        s.ints(self.0.top_size[axis])
    }

    #[inline(always)]
    fn offset(&self, s: S, _: &Lanes) -> S::Ints {
        s.ints(self.0.top_offset as i32)
    }

    #[inline(always)]
    fn top(&self, s: S, _: &Lanes, [x, y, z]: [S::Ints; 3]) -> [S::Ints; 3] {
        let shift = self.0.top_shift;
        [s.shr(x, shift), s.shr(y, shift), s.shr(z, shift)]
    }

    #[inline(always)]
    unsafe fn descend(
        &self,
        s: S,
        _: &Lanes,
        cells: &[u32],
        voxel: [S::Ints; 3],
        mut cell: S::Ints,
        known: S::Mask,
    ) -> Descent<S> {
        let mut level = self.0.top_shift;
        let mut shift = s.ints(level as i32);
        let mut below = s.both(known, s.is_negative(cell));
        while level > 5 && s.any(below) {
            level -= 2;
            let at = s.add(s.shl(cell, 6), cell_index(s, voxel, level));
            // SAFETY: children of a valid scene's cells are nodes.
            cell = unsafe { s.gather(cell, below, at, cells) };
            shift = s.select(below, s.ints(level as i32), shift);
            below = s.both(below, s.is_negative(cell));
        }
        Descent { cell, shift, in_node: if level == 5 { below } else { s.mask(0) } }
    }
}

/// A grid for each lane.
#[derive(Clone, Copy)]
#[repr(C, align(64))]
pub struct GridOfEach {
    origin: [[i32; LANES]; 3],
    size: [[i32; LANES]; 3],
    offset: [i32; LANES],
    top_shift: [i32; LANES],
}

impl GridOfEach {
    /// Grids without a cell.
    pub const NONE: Self =
        Self { origin: [[0; LANES]; 3], size: [[0; LANES]; 3], offset: [0; LANES], top_shift: [5; LANES] };

    /// Its numbers, in the order of [`GRID`].
    #[inline(always)]
    pub fn words(&mut self) -> [&mut [i32; LANES]; GRID] {
        let ([a, b, c], [d, e, f]) = (&mut self.origin, &mut self.size);
        [a, b, c, d, e, f, &mut self.offset, &mut self.top_shift]
    }

    /// The first voxel of a lane's grid.
    #[inline(always)]
    pub fn origin_of(&self, lane: usize) -> IVec3 {
        IVec3::new(self.origin[0][lane], self.origin[1][lane], self.origin[2][lane])
    }
}

/// The grids that lanes have.
#[derive(Clone, Copy)]
pub struct OwnGrids;

impl<S: Simd> Grids<S> for OwnGrids {
    #[inline(always)]
    fn origin(&self, s: S, lanes: &Lanes, axis: usize) -> S::Ints {
        s.load(&lanes.grids.origin[axis])
    }

    #[inline(always)]
    fn size(&self, s: S, lanes: &Lanes, axis: usize) -> S::Ints {
        s.load(&lanes.grids.size[axis])
    }

    #[inline(always)]
    fn offset(&self, s: S, lanes: &Lanes) -> S::Ints {
        s.load(&lanes.grids.offset)
    }

    #[inline(always)]
    fn top(&self, s: S, lanes: &Lanes, [x, y, z]: [S::Ints; 3]) -> [S::Ints; 3] {
        let shift = s.load(&lanes.grids.top_shift);
        [s.shr_each(x, shift), s.shr_each(y, shift), s.shr_each(z, shift)]
    }

    #[inline(always)]
    unsafe fn descend(
        &self,
        s: S,
        lanes: &Lanes,
        cells: &[u32],
        [x, y, z]: [S::Ints; 3],
        mut cell: S::Ints,
        known: S::Mask,
    ) -> Descent<S> {
        let three = s.ints(3);
        let mut shift = s.load(&lanes.grids.top_shift);
        let mut below = s.both(known, s.is_negative(cell));
        loop {
            // Levels are 3, 5, 7 and so on.
            let is_high = s.is_below(s.ints(5), shift);
            let descending = s.both(below, is_high);
            if !s.any(descending) {
                return Descent { cell, shift, in_node: s.both(below, s.eq(shift, s.ints(5))) };
            }
            shift = s.select(descending, s.sub(shift, s.ints(2)), shift);
            let index = s.or(
                s.and(s.shr_each(x, shift), three),
                s.or(s.shl(s.and(s.shr_each(y, shift), three), 2), s.shl(s.and(s.shr_each(z, shift), three), 4)),
            );
            // SAFETY: children of a valid scene's cells are nodes.
            cell = unsafe { s.gather(cell, descending, s.add(s.shl(cell, 6), index), cells) };
            below = s.both(below, s.is_negative(cell));
        }
    }
}
