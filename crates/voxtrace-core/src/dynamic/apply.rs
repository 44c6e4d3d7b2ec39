//! Bricks with new words take the places of those that were: the one way in which a grid changes, whether it is edited, undone or redone.

use super::cells::{BRICK_SHIFT, Cell, ChangedCells, top_position};
use super::emitters::{changes_of, emitters_of, with_neighbours};
use super::grow::most_of_top;
use super::history::Entry;
use super::plan::Change;
use super::store::BrickCode;
use super::{DynamicScene, Edit, EditError, Edited};
use crate::packed::{CELL_OCCUPIED, LightNode, PackedGrid, Placement};
use glam::IVec3;
use rayon::prelude::*;
use std::sync::Arc;
use voxtrace_scene::brick::{BRICK_SIZE, Brick};

/// Most levels of nodes above a brick: the coarsest cells of that many are wider than a grid.
const MOST_LEVELS: u32 = 9;

impl DynamicScene {
    /// Edits the voxels of a grid, which all its instances show. Nothing of it is seen by tracers before they get the next patch.
    ///
    /// # Errors
    /// [`EditError`] where the edit names what is not there, or too much; nothing has changed then.
    pub fn edit(&mut self, grid: u32, edit: &Edit) -> Result<Edited, EditError> {
        // Also where this fails or changes nothing, what is joined next is no part of the step before.
        self.history.close();
        let changes = self.plan(grid, edit)?;
        let (edited, entry) = self.apply(grid, changes)?;
        if !entry.bricks.is_empty() {
            self.history.push(entry);
        }
        Ok(edited)
    }

    /// Takes back the last edit that was not undone yet. Returns what that did, `None` where there is nothing to undo, or not any more.
    ///
    /// # Errors
    /// [`EditError::Full`], with nothing changed.
    pub fn undo(&mut self) -> Result<Option<Edited>, EditError> {
        // What cannot be put back stays a step that can be undone.
        self.history.next_undo().map_or(Ok(()), |entry| self.check_room(entry.grid, &entry.bricks))?;
        let Some(entry) = self.history.pop_undo() else { return Ok(None) };
        let (edited, back) = self.apply(entry.grid, entry.bricks)?;
        self.history.push_redo(back);
        Ok(Some(edited))
    }

    /// Does again what was undone last. Returns what that did, `None` where nothing was undone since the last edit.
    ///
    /// # Errors
    /// As [`Self::undo`].
    pub fn redo(&mut self) -> Result<Option<Edited>, EditError> {
        self.history.next_redo().map_or(Ok(()), |entry| self.check_room(entry.grid, &entry.bricks))?;
        let Some(entry) = self.history.pop_redo() else { return Ok(None) };
        let (edited, back) = self.apply(entry.grid, entry.bricks)?;
        self.history.push_undo(back);
        Ok(Some(edited))
    }

    /// Keeps at most so many bytes for undo and redo, 256 MiB unless said otherwise; the oldest edits are forgotten first.
    pub fn set_undo_limit(&mut self, bytes: u64) {
        self.history.set_most_bytes(bytes);
    }

    /// Bytes that undo and redo keep.
    pub fn undo_size_bytes(&self) -> u64 {
        self.history.size_bytes()
    }

    /// Gives bricks other words. Returns those that they had.
    pub(super) fn apply(&mut self, grid: u32, changes: Vec<Change>) -> Result<(Edited, Entry), EditError> {
        self.check_room(grid, &changes)?;
        if changes.is_empty() {
            return Ok((Edited::default(), Entry { grid, bricks: Vec::new() }));
        }
        let index = grid as usize;
        self.epoch = if self.epoch == u16::MAX { 1 } else { self.epoch + 1 };
        let lit = if self.glow.is_dark() { Vec::new() } else { with_neighbours(changes.iter().map(|change| change.0)) };
        let emitters = emitters_of(self.geometry(), index, &lit, &self.glow);
        self.reach(index, &changes);
        let mut changed = ChangedCells::default();
        let mut edited = Edited { bricks: changes.len(), voxels: 0 };
        let mut before = Vec::with_capacity(changes.len());
        // What becomes empty goes first: its places are then used again.
        let (emptied, filled): (Vec<_>, Vec<_>) = changes.into_iter().partition(|(_, code)| code.is_none());
        for (at, code) in emptied.into_iter().chain(filled) {
            self.changed_bricks.insert((grid, at), ());
            let was = self.replace(index, at, code, &mut changed, &mut edited);
            before.push((at, was));
        }
        self.shorten_all(index, &changed);
        self.note_repairs(index, &changed);
        let after = emitters_of(self.geometry(), index, &lit, &self.glow);
        let is_lit_anew = self.update_lights(index, &changes_of(emitters, after));
        self.is_placement_stale |= is_lit_anew;
        self.follow_with_placement();
        Ok((edited, Entry { grid, bricks: before }))
    }

    /// Whether the arrays may get as large as all changes of a grid could make them.
    pub(super) fn check_room(&self, grid: u32, changes: &[Change]) -> Result<(), EditError> {
        let words = |part: fn(&BrickCode) -> usize| {
            changes.iter().filter_map(|(_, code)| code.as_ref()).map(part).sum::<usize>() as u64
        };
        let limit = u64::from(CELL_OCCUPIED);
        let geometry = self.geometry();
        let bricks = geometry.bricks.len() as u64 + words(|code| code.record.len());
        let materials = geometry.brick_materials.len() as u64 + words(|code| code.materials.len());
        // Mostly there is plenty of room, and nobody has to count.
        let most_cells =
            geometry.cells.len() as u64 + 1024 * changes.len() as u64 + self.most_top_cells(grid, changes.len());
        let cells = if most_cells < limit { most_cells } else { self.cells_with(grid, changes) };
        if bricks < limit && materials < limit && cells < limit { Ok(()) } else { Err(EditError::Full) }
    }

    /// Cells that there are at most with changes of a grid, each node that they may need counted once.
    fn cells_with(&self, grid: u32, changes: &[Change]) -> u64 {
        let geometry = self.geometry();
        let packed = geometry.grids.get(grid as usize);
        // Bricks that there are, or that become empty, need no cells.
        let is_new = |(at, code): &&Change| {
            code.is_some() && packed.is_none_or(|packed| geometry.find_brick(packed, *at * BRICK_SIZE).is_none())
        };
        let mut places: Vec<IVec3> = changes.par_iter().filter(is_new).map(|(at, _)| *at).collect();
        // Cells of a grid that is still to come begin at its lowest brick.
        let lowest = places.iter().copied().reduce(IVec3::min).unwrap_or_default();
        let origin = packed.map_or(lowest, |packed| packed.origin >> BRICK_SHIFT as i32);
        places.par_iter_mut().for_each(|at| *at -= origin);
        let is_within = |packed: &PackedGrid| {
            let shift = packed.top_shift as i32 - BRICK_SHIFT as i32;
            places.par_iter().all(|&at| top_position(packed, at >> shift).is_some())
        };
        let top = if packed.is_some_and(is_within) { 0 } else { self.most_top_cells(grid, changes.len()) };
        let mut nodes = 0;
        for _ in 0..MOST_LEVELS {
            places.par_iter_mut().for_each(|at| *at >>= 2);
            places.dedup();
            places.par_sort_unstable_by_key(|at| (at.z, at.y, at.x));
            places.dedup();
            nodes += places.len() as u64;
        }
        geometry.cells.len() as u64 + 64 * nodes + top
    }

    /// Most cells that it takes to make the top array of a grid reach so many more bricks.
    fn most_top_cells(&self, grid: u32, bricks: usize) -> u64 {
        let Some(packed) = self.geometry().grids.get(grid as usize) else { return most_of_top(bricks as u64) };
        let (mut size, mut cells) = (packed.top_size.as_i64vec3(), 0);
        for _ in 0..MOST_LEVELS {
            // Its cells become those of nodes below a coarser one.
            size = (size + 3) >> 2;
            cells += 65 * size.element_product() as u64 + 64;
        }
        cells + most_of_top(self.bricks[grid as usize] + bricks as u64)
    }

    /// Makes the cells of a grid reach all bricks that are not empty.
    fn reach(&mut self, grid: usize, changes: &[Change]) {
        let (mut low, mut high, mut count) = (IVec3::MAX, IVec3::MIN, self.bricks[grid]);
        for &(at, _) in changes.iter().filter(|(_, code)| code.is_some()) {
            (low, high, count) = (low.min(at), high.max(at + 1), count + 1);
        }
        if low.cmplt(high).all() && self.store().reach(grid, (low, high), count) {
            self.regrown_grids.push(grid as u32);
            self.is_placement_stale = true;
        }
    }

    /// Replaces one brick. Returns its words before.
    fn replace(
        &mut self,
        grid: usize,
        at: IVec3,
        code: Option<BrickCode>,
        changed: &mut ChangedCells,
        edited: &mut Edited,
    ) -> Option<BrickCode> {
        let epoch = self.epoch;
        let mut store = self.store();
        let packed = store.geometry.grids[grid];
        let record = store.geometry.find_brick(&packed, at * BRICK_SIZE);
        let was = record.map(|record| store.brick_code(grid, record));
        let place = record.zip(was.as_ref()).map(|(record, was)| (record, was.record.len(), was.materials.len()));
        match &code {
            Some(code) => {
                let now = store.put_brick(place, code, epoch);
                if record != Some(now) {
                    store.fill_cell(grid, at, now, changed);
                }
            }
            None => {
                if let Some(place) = place {
                    store.drop_brick(place);
                    store.empty_cell(grid, at, changed);
                }
            }
        }
        self.bricks[grid] = self.bricks[grid] + u64::from(code.is_some()) - u64::from(was.is_some());
        let voxels = count(code.as_ref()) - count(was.as_ref());
        edited.voxels += voxels;
        self.update_bounds(grid, at, was.as_ref(), code.as_ref(), voxels);
        was
    }

    /// Shortens skip distances level by level.
    fn shorten_all(&mut self, grid: usize, changed: &ChangedCells) {
        let mut filled: Vec<Cell> = changed.filled.clone();
        filled.sort_unstable_by_key(|cell| cell.shift);
        for level in filled.chunk_by(|a, b| a.shift == b.shift) {
            let mut cells: Vec<IVec3> = level.iter().map(Cell::place).collect();
            self.store().shorten(grid, level[0].shift, &mut cells);
        }
    }

    /// Keeps the number of voxels, and bounds that hold all of them.
    fn update_bounds(&mut self, grid: usize, at: IVec3, was: Option<&BrickCode>, now: Option<&BrickCode>, voxels: i64) {
        let corner = at * BRICK_SIZE;
        let geometry = Arc::make_mut(&mut self.scene.geometry);
        let mut packed = geometry.grids[grid];
        let (low, high) = (corner.max(packed.min), (corner + BRICK_SIZE).min(packed.max));
        let is_inside = low == corner && high == corner + BRICK_SIZE;
        let was_empty = packed.voxels == [0, 0];
        let total = packed.voxel_count().wrapping_add_signed(voxels);
        packed.voxels = [total as u32, (total >> 32) as u32];
        if let Some(now) = now.filter(|_| !is_inside || was_empty) {
            let (min, max) = extent(now);
            let (min, max) = (corner + min, corner + max);
            (packed.min, packed.max) = if was_empty { (min, max) } else { (packed.min.min(min), packed.max.max(max)) };
        }
        let touches = |min: IVec3, max: IVec3| min.cmple(packed.min).any() || max.cmpge(packed.max).any();
        if was.is_some() && touches(corner, corner + BRICK_SIZE) {
            self.is_loose[grid] = true;
        }
        let before = geometry.grids[grid];
        self.is_placement_stale |= (before.min, before.max) != (packed.min, packed.max);
        geometry.grids.as_mut()[grid] = packed;
    }

    /// Brings the tree over a grid's emitters up to date. Returns whether it changed.
    fn update_lights(&mut self, grid: usize, changes: &[super::light_tree::EmitterChange]) -> bool {
        if changes.is_empty() {
            return false;
        }
        let root = self.geometry().light_root(grid as u32);
        let now = self.store().update_lights(root, changes);
        let geometry = Arc::make_mut(&mut self.scene.geometry);
        let mut roots = geometry.light_roots.to_vec();
        roots[grid] = now.unwrap_or(LightNode::NONE);
        geometry.light_roots = roots.into();
        true
    }

    /// Makes the placement anew where it depends on something that changed.
    pub(super) fn follow_with_placement(&mut self) {
        let geometry = Arc::make_mut(&mut self.scene.geometry);
        geometry.is_edited = true;
        if std::mem::take(&mut self.is_placement_stale) {
            self.is_placed_anew = true;
            geometry.fingerprint = geometry.fingerprint_of_edited();
            self.scene.placement = Placement::of_sound(geometry, self.scene.placement.instances().to_vec());
        }
    }
}

fn masks(code: &BrickCode) -> impl Iterator<Item = u64> {
    code.record[2..].chunks_exact(2).map(|words| u64::from(words[0]) | u64::from(words[1]) << 32)
}

/// Voxels of a brick.
fn count(code: Option<&BrickCode>) -> i64 {
    code.map_or(0, |code| masks(code).map(|mask| i64::from(mask.count_ones())).sum())
}

/// Lowest voxel of a brick along each axis, and one past the highest.
fn extent(code: &BrickCode) -> (IVec3, IVec3) {
    let mut occupancy = [0; 8];
    let blocks = (0..8).filter(|block| code.record[0] >> block & 1 == 1);
    blocks.zip(masks(code)).for_each(|(block, mask)| occupancy[block] = mask);
    let count: u32 = occupancy.iter().map(|mask| mask.count_ones()).sum();
    Brick::new(occupancy, vec![0; count as usize]).extent()
}
