//! From an edit to the bricks that it changes, with their new words. Bricks are decoded, edited and encoded on all cores; what comes out the same
//! is left out.

use super::cells::{child, from_origin, top_position};
use super::clip::paste;
use super::edit_error::MOST_BRICKS;
use super::sketch::Sketch;
use super::spread::{extrude, flood};
use super::store::BrickCode;
use super::{DynamicScene, Edit, EditError};
use crate::packed::{CELL_OCCUPIED, Geometry, encode_brick};
use glam::IVec3;
use rayon::prelude::*;
use std::f64::consts::PI;
use voxtrace_scene::Shape;
use voxtrace_scene::brick::{BRICK_SIZE, Brick};
use voxtrace_scene::grid::{MAX_COORDINATE, VoxelBox, brick_of};

/// A brick that becomes another one: its coordinates and its words, `None` where it becomes empty.
pub(super) type Change = (IVec3, Option<BrickCode>);

/// Bricks that one task edits.
const CHUNK: usize = 16;
/// In a box of fewer bricks all are looked at.
const MANY_BRICKS: u64 = 1 << 12;
const FULL: [u64; 8] = [u64::MAX; 8];

/// A brick of some voxels of one material.
fn solid(mask: [u64; 8], material: u16) -> Brick {
    let count: u32 = mask.iter().map(|block| block.count_ones()).sum();
    Brick::new(mask, vec![material; count as usize])
}

/// Bricks that a box of voxels touches: the lowest, and one past the highest.
pub(super) fn brick_box(region: VoxelBox) -> (IVec3, IVec3) {
    (brick_of(region.min), brick_of(region.max - 1) + 1)
}

/// The part of a box that can hold voxels; its corners may be anywhere.
pub(super) fn within_range(region: VoxelBox) -> VoxelBox {
    let limit = IVec3::splat(MAX_COORDINATE);
    VoxelBox { min: region.min.clamp(-limit, limit + 1), max: region.max.clamp(-limit, limit + 1) }
}

/// A box whose voxels become something.
///
/// # Errors
/// [`EditError::OutOfRange`] where it reaches too far.
pub(super) fn check_range(region: VoxelBox) -> Result<(), EditError> {
    let limit = IVec3::splat(MAX_COORDINATE);
    if region.min.cmplt(-limit).any() {
        return Err(EditError::OutOfRange(region.min));
    }
    if region.max.cmpgt(limit + 1).any() {
        return Err(EditError::OutOfRange(region.max.saturating_sub(IVec3::ONE)));
    }
    Ok(())
}

impl DynamicScene {
    /// The bricks that an edit changes.
    pub(super) fn plan(&self, grid: u32, edit: &Edit) -> Result<Vec<Change>, EditError> {
        self.check_grid(grid)?;
        let count = self.scene.materials().len();
        if let Some(material) = edit.materials().find(|&material| usize::from(material) >= count) {
            return Err(EditError::NoMaterial { material, count });
        }
        if let Some(region) = edit.reach().filter(|region| region.size().min_element() > 0) {
            return self.plan_sketch(grid, edit, region);
        }
        match edit {
            Edit::Fill { shape, material: Some(material) } => self.plan_fill(grid, shape, *material, true),
            Edit::Add { shape, material } => self.plan_fill(grid, shape, *material, false),
            Edit::Fill { shape, material: None } => self.plan_masked(grid, shape, |brick, mask| {
                let is_met = brick.occupancy().iter().zip(mask).any(|(own, mask)| own & mask != 0);
                is_met.then(|| brick.replaced(&Brick::default(), mask))
            }),
            Edit::Paint { shape, material } => self.plan_masked(grid, shape, |brick, mask| {
                let painted = std::array::from_fn(|block| mask[block] & brick.occupancy()[block]);
                (painted != [0; 8]).then(|| brick.replaced(&solid(painted, *material), &painted))
            }),
            Edit::Replace { within, from, to } => {
                let everywhere = VoxelBox { min: IVec3::splat(-MAX_COORDINATE), max: IVec3::splat(MAX_COORDINATE + 1) };
                self.plan_masked(grid, &Shape::Box(within.unwrap_or(everywhere)), |brick, mask| {
                    let mut found = [0u64; 8];
                    for (local, _) in brick.voxels().filter(|(_, material)| material == from) {
                        let block = voxtrace_scene::brick::block_index(local);
                        found[block] |= mask[block] & 1 << voxtrace_scene::brick::block_bit(local);
                    }
                    let with = to.map_or_else(Brick::default, |to| solid(found, to));
                    (found != [0; 8]).then(|| brick.replaced(&with, &found))
                })
            }
            // Of no extent.
            Edit::Paste { .. } | Edit::Extrude { .. } | Edit::Flood { .. } => Ok(Vec::new()),
        }
    }

    /// # Errors
    /// [`EditError::NoGrid`] where there is no such grid.
    pub(super) fn check_grid(&self, grid: u32) -> Result<(), EditError> {
        let count = self.scene.grids().len();
        if (grid as usize) < count { Ok(()) } else { Err(EditError::NoGrid { grid, count }) }
    }

    /// An edit that goes voxel by voxel, and writes in a box.
    fn plan_sketch(&self, grid: u32, edit: &Edit, region: VoxelBox) -> Result<Vec<Change>, EditError> {
        check_range(region)?;
        let (low, high) = brick_box(region);
        let bricks = (high - low).as_i64vec3().element_product() as u64;
        // A flood goes as far as it is allowed.
        if bricks > MOST_BRICKS && !matches!(edit, Edit::Flood { .. }) {
            return Err(EditError::TooLarge { bricks });
        }
        let mut sketch = Sketch::new(self, grid);
        match edit {
            Edit::Paste { clip, at, with_empty } => paste(&mut sketch, clip, *at, *with_empty),
            Edit::Extrude { layer, face, distance } => extrude(&mut sketch, *layer, *face, *distance),
            Edit::Flood { start, material, within, most } => flood(&mut sketch, *start, *material, *within, *most)?,
            _ => {}
        }
        Ok(sketch.changes())
    }

    /// Fills the voxels of a shape: all of them, or those that are empty alone.
    fn plan_fill(&self, grid: u32, shape: &Shape, material: u16, replaces: bool) -> Result<Vec<Change>, EditError> {
        let Some(region) = bounds_of(shape)? else { return Ok(Vec::new()) };
        check_range(region)?;
        let bricks = bricks_of(shape, brick_box(region))?;
        let filled = solid(FULL, material);
        Ok(self.planned(grid, &bricks, |at, brick| match shape.mask(at) {
            [0, 0, 0, 0, 0, 0, 0, 0] => None,
            mask if !replaces => {
                let empty = std::array::from_fn(|block| mask[block] & !brick.occupancy()[block]);
                (empty != [0; 8]).then(|| brick.replaced(&solid(empty, material), &empty))
            }
            FULL => Some(filled.clone()),
            mask => Some(brick.replaced(&solid(mask, material), &mask)),
        }))
    }

    /// Edits those bricks that there are and that a shape touches.
    fn plan_masked(
        &self,
        grid: u32,
        shape: &Shape,
        change: impl Fn(&Brick, &[u64; 8]) -> Option<Brick> + Sync,
    ) -> Result<Vec<Change>, EditError> {
        let Some(region) = bounds_of(shape)? else { return Ok(Vec::new()) };
        let bricks = self.geometry().bricks_in(grid as usize, brick_box(within_range(region)));
        Ok(self.planned(grid, &bricks, |at, brick| {
            let mask = shape.mask(at);
            if mask == [0; 8] { None } else { change(brick, &mask) }
        }))
    }

    /// Edits bricks, each once, by what `change` makes of the brick at its coordinates; `None` leaves it.
    pub(super) fn planned(
        &self,
        grid: u32,
        bricks: &[IVec3],
        change: impl Fn(IVec3, &Brick) -> Option<Brick> + Sync,
    ) -> Vec<Change> {
        let geometry = self.geometry();
        let packed = &geometry.grids[grid as usize];
        let empty = Brick::default();
        let edit = |&at: &IVec3| {
            let record = geometry.find_brick(packed, at * 8);
            let was = record.map(|record| geometry.decode_brick(packed, record));
            let now = change(at, was.as_ref().unwrap_or(&empty))?;
            if now == *was.as_ref().unwrap_or(&empty) {
                return None;
            }
            Some((at, code_of(&now, packed.material_bits)))
        };
        bricks.par_iter().with_min_len(CHUNK).filter_map(edit).collect()
    }
}

/// The bricks of a box, from the lowest to before the highest, that a shape may touch, as they lie.
///
/// # Errors
/// [`EditError::TooLarge`] where they are too many.
fn bricks_of(shape: &Shape, (low, high): (IVec3, IVec3)) -> Result<Vec<IVec3>, EditError> {
    let size = (high - low).as_i64vec3();
    let all = size.element_product() as u64;
    let too_large = || EditError::TooLarge { bricks: all };
    let inside = match *shape {
        Shape::Capsule { from, to, radius } => {
            PI * radius * radius * (from.distance(to) + radius * 4.0 / 3.0) / f64::from(BRICK_SIZE.pow(3))
        }
        _ => all as f64,
    };
    if inside > MOST_BRICKS as f64 {
        return Err(too_large());
    }
    // A long stroke has a large box, most of which it is far away from.
    if all > MOST_BRICKS || (all >= MANY_BRICKS && inside < all as f64 / 4.0) {
        let (mut found, mut waiting) = (Vec::new(), vec![(low, high)]);
        while let Some((low, high)) = waiting.pop() {
            if !may_touch(shape, low, high) {
                continue;
            }
            let size = high - low;
            if size == IVec3::ONE {
                found.push(low);
                if found.len() as u64 > MOST_BRICKS {
                    return Err(too_large());
                }
                continue;
            }
            let axis = size.max_position();
            let middle = low[axis] + size[axis] / 2;
            let (mut below, mut above) = (high, low);
            (below[axis], above[axis]) = (middle, middle);
            waiting.extend([(low, below), (above, high)]);
        }
        found.par_sort_unstable_by_key(|at| (at.z, at.y, at.x));
        return Ok(found);
    }
    let place = |index: i64| {
        let at = [index % size.x, index / size.x % size.y, index / (size.x * size.y)];
        low + IVec3::from_array(at.map(|at| at as i32))
    };
    Ok((0..all as i64).map(place).collect())
}

/// Whether a capsule may have voxels in the bricks from `low` to before `high`: whether it comes as near to their middle as their corners.
fn may_touch(shape: &Shape, low: IVec3, high: IVec3) -> bool {
    let Shape::Capsule { from, to, radius } = *shape else { return true };
    let (low, high) = ((low * BRICK_SIZE).as_dvec3(), (high * BRICK_SIZE).as_dvec3());
    // Of the voxel whose lowest corner is the middle, the centre is asked.
    let reach = (high - low).length() * 0.5 + 1.0;
    radius >= 0.0 && Shape::Capsule { from, to, radius: radius + reach }.contains(((low + high) * 0.5).as_ivec3())
}

/// A shape's box, `None` where nothing is inside.
fn bounds_of(shape: &Shape) -> Result<Option<VoxelBox>, EditError> {
    let is_finite = match shape {
        Shape::Sphere { center, radius } => center.is_finite() && radius.is_finite(),
        Shape::Capsule { from, to, radius } => from.is_finite() && to.is_finite() && radius.is_finite(),
        _ => true,
    };
    if is_finite { Ok(shape.bounds()) } else { Err(EditError::NotFinite) }
}

/// The words of a brick, `None` where it is empty.
pub(super) fn code_of(brick: &Brick, material_bits: u32) -> Option<BrickCode> {
    if brick.is_empty() {
        return None;
    }
    let (record, materials) = encode_brick(brick, material_bits);
    Some(BrickCode { record: record.into(), materials: materials.into() })
}

impl Geometry {
    /// The bricks of a grid that there are, from `low` to before `high`.
    pub(super) fn bricks_in(&self, grid: usize, (low, high): (IVec3, IVec3)) -> Vec<IVec3> {
        let packed = &self.grids[grid];
        let region = (from_origin(packed, low), from_origin(packed, high));
        let shift = packed.top_shift as i32 - 3;
        let (first, last) = ((region.0 >> shift).max(IVec3::ZERO), ((region.1 - 1) >> shift).min(packed.top_size - 1));
        let mut bricks = Vec::new();
        for z in first.z..=last.z {
            for y in first.y..=last.y {
                for x in first.x..=last.x {
                    let at = IVec3::new(x, y, z);
                    let Some(position) = top_position(packed, at) else { continue };
                    self.collect_in(self.cells[position], at, shift, region, &mut bricks);
                }
            }
        }
        let origin = packed.origin >> 3;
        bricks.iter_mut().for_each(|brick| *brick += origin);
        bricks
    }

    fn collect_in(&self, cell: u32, at: IVec3, shift: i32, region: (IVec3, IVec3), bricks: &mut Vec<IVec3>) {
        let (low, high) = (at << shift, (at + 1) << shift);
        if cell & CELL_OCCUPIED == 0 || low.cmpge(region.1).any() || high.cmple(region.0).any() {
            return;
        }
        if shift == 0 {
            bricks.push(at);
            return;
        }
        for index in 0..64 {
            let local = IVec3::new(index & 3, index >> 2 & 3, index >> 4);
            let cell = self.cells[child(cell) * 64 + index as usize];
            self.collect_in(cell, at * 4 + local, shift - 2, region, bricks);
        }
    }
}
