//! What edits leave for later: skip distances that could be longer, since something became empty, and bounds that could be smaller. Rays find the
//! same without it, somewhat later.

use super::DynamicScene;
use super::cells::{Cell, ChangedCells};
use super::plan::brick_box;
use super::skip::{REACH, largest};
use crate::packed::PackedGrid;
use glam::IVec3;
use rayon::prelude::*;
use std::collections::BTreeSet;
use std::sync::Arc;
use voxtrace_scene::brick::BRICK_SIZE;
use voxtrace_scene::grid::VoxelBox;

/// Cells along an edge of a region that is repaired as one.
const EDGE: i32 = 32;
/// Regions that are looked at side by side.
const AT_ONCE: usize = 64;

/// A region whose skip distances may be too short: of a level of a grid, in edges of [`EDGE`] of its cells from voxel 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Region {
    grid: u32,
    shift: u32,
    at: [i32; 3],
}

/// Regions that wait, in the order in which they are repaired.
pub(super) type Repairs = BTreeSet<Region>;

/// Adds the regions of the cells from `low` to before `high`, from the grid's origin.
fn add(repairs: &mut Repairs, grid: u32, packed: &PackedGrid, shift: u32, (low, high): (IVec3, IVec3)) {
    let edge = EDGE << shift;
    let first = ((low << shift as i32) + packed.origin).map(|v| v.div_euclid(edge));
    let last = ((high << shift as i32) + packed.origin - 1).map(|v| v.div_euclid(edge));
    for z in first.z..=last.z {
        for y in first.y..=last.y {
            for x in first.x..=last.x {
                repairs.insert(Region { grid, shift, at: [x, y, z] });
            }
        }
    }
}

impl Region {
    /// Its cells from the grid's origin: the lowest, and one past the highest.
    fn cells(&self, packed: &PackedGrid) -> (IVec3, IVec3) {
        let edge = EDGE << self.shift;
        let low = (IVec3::from_array(self.at) * edge - packed.origin) >> self.shift as i32;
        let across = packed.top_size << (packed.top_shift - self.shift) as i32;
        (low.max(IVec3::ZERO), (low + EDGE + 1).min(across))
    }
}

impl DynamicScene {
    /// Notes where cells could skip more.
    pub(super) fn note_repairs(&mut self, grid: usize, changed: &ChangedCells) {
        let packed = self.geometry().grids[grid];
        let mut boxes: Vec<(u32, IVec3, IVec3)> = Vec::new();
        let around = |cell: &Cell| (cell.shift, cell.place() - REACH, cell.place() + REACH + 1);
        boxes.extend(changed.emptied.iter().map(around));
        boxes.extend(changed.divided.iter().map(|cell| (cell.shift - 2, cell.place() * 4, cell.place() * 4 + 4)));
        for (shift, low, high) in boxes {
            add(&mut self.repairs, grid as u32, &packed, shift, (low, high));
        }
    }

    /// Lengthens the skip distances of up to `regions` regions of 32³ cells where something became empty, as far as emptiness reaches.
    /// Rays find the same before and after, but sooner after. Returns whether some are left: call it in the background, a few regions at a
    /// time (1 ms each or less), until none is.
    pub fn repair(&mut self, regions: usize) -> bool {
        let mut left = regions;
        while left > 0 && !self.repairs.is_empty() {
            let some: Vec<Region> = self.repairs.iter().copied().take(left.min(AT_ONCE)).collect();
            some.iter().for_each(|region| _ = self.repairs.remove(region));
            left -= some.len();
            let geometry = self.geometry();
            let found: Vec<_> = some
                .par_iter()
                .filter_map(|region| {
                    let packed = &geometry.grids[region.grid as usize];
                    let is_level = region.shift <= packed.top_shift;
                    let (low, high) = is_level.then(|| region.cells(packed))?;
                    let is_some = low.cmplt(high).all();
                    is_some.then(|| (*region, largest(geometry, packed, region.shift, low, high)))
                })
                .collect();
            let mut store = self.store();
            for (region, distances) in &found {
                store.restore(region.grid as usize, region.shift, distances);
            }
        }
        !self.repairs.is_empty()
    }

    /// Does at once all that edits left for later: skip distances, and the bounds of grids.
    pub fn settle(&mut self) {
        self.repair(usize::MAX);
        for grid in 0..self.is_loose.len() {
            if std::mem::take(&mut self.is_loose[grid]) {
                self.tighten(grid);
            }
        }
        self.follow_with_placement();
    }

    /// Makes the bounds of a grid those of its voxels.
    fn tighten(&mut self, grid: usize) {
        let geometry = self.geometry();
        let mut packed = geometry.grids[grid];
        let all = brick_box(VoxelBox { min: packed.min, max: packed.max });
        let bricks = geometry.bricks_in(grid, all);
        let (mut low, mut high) = (IVec3::MAX, IVec3::MIN);
        bricks.iter().for_each(|&at| (low, high) = (low.min(at), high.max(at)));
        let is_outermost = |at: &&IVec3| (at.cmpeq(low) | at.cmpeq(high)).any();
        let (mut min, mut max) = (IVec3::MAX, IVec3::MIN);
        for &at in bricks.iter().filter(is_outermost) {
            let Some(record) = geometry.find_brick(&packed, at * BRICK_SIZE) else { continue };
            let (from, to) = geometry.decode_brick(&packed, record).extent();
            (min, max) = (min.min(at * BRICK_SIZE + from), max.max(at * BRICK_SIZE + to));
        }
        if min.cmplt(max).all() && (packed.min, packed.max) != (min, max) {
            (packed.min, packed.max) = (min, max);
            Arc::make_mut(&mut self.scene.geometry).grids.as_mut()[grid] = packed;
            self.is_placement_stale = true;
        }
    }
}
