//! The tree of a grid: first its nodes from the root down, then the numbers of all leaves. It is gone over twice, to find the box
//! around what is active, and to fill it.

use super::cursor::Cursor;
use super::grid::Grid;
use super::values::{Packed, Values, bit};
use crate::import::samples::checked_size;
use glam::IVec3;
use rayon::prelude::*;
use rustc_hash::FxHashSet;
use std::path::Path;
use voxtrace_voxelize::{ImportError, Limits};

/// Logarithms of the edges of nodes in their own parts, from the root's children down, and of a part in voxels.
const LEVELS: [(u32, u32); 2] = [(5, 7), (4, 3)];
/// Voxels along an edge of a leaf, and the bytes of its mask.
const LEAF: i32 = 8;
const LEAF_MASK: u64 = 64;
/// Leaves whose numbers are unpacked before they are put in their place.
const BATCH: usize = 1 << 12;
/// Coordinates beyond this are impossible.
const FARTHEST: i32 = 1 << 29;

/// The lowest place of a grid that has a number of its own, how many there are along each axis, and the numbers, x fastest.
pub(super) type Dense = (IVec3, [usize; 3], Vec<f32>);

/// Reads a tree.
pub(super) fn read(bytes: &[u8], path: &Path, grid: &Grid, limits: &Limits) -> Result<Dense, ImportError> {
    let mut cursor = Cursor::new(bytes, path);
    cursor.at = grid.start;
    let mut seen = Bounds { low: IVec3::MAX, high: IVec3::MIN };
    walk(cursor, grid, limits, &mut seen)?;
    if seen.low.x > seen.high.x {
        return Err(cursor.malformed(format!("the grid {:?} is empty", grid.name)));
    }
    let edges = (seen.high - seen.low).to_array().map(|edge| edge as u64);
    let size = checked_size(path, grid.start as u64, edges, limits)?;
    let count = size.iter().product();
    let mut fill = Fill { low: seen.low, size, values: Vec::new(), leaves: Vec::new() };
    fill.values.try_reserve_exact(count).map_err(|_| ImportError::io(path, std::io::ErrorKind::OutOfMemory.into()))?;
    let values = background(cursor, grid)?;
    fill.values.resize(count, values.background);
    walk(cursor, grid, limits, &mut fill)?;
    cursor.go(grid.blocks)?;
    fill.leaves(cursor, &values)?;
    Ok((fill.low, fill.size, fill.values))
}

/// What is told of a tree.
trait Visitor {
    /// All voxels from `low` on, `1 << log` along each edge, have a value.
    fn tile(&mut self, low: IVec3, log: u32, value: f32, is_active: bool);
    /// A leaf with the bits of what is active.
    fn leaf(&mut self, low: IVec3, mask: &[u8]);
    /// Whether values are wanted.
    fn wants_values(&self) -> bool;
}

fn background(mut cursor: Cursor, grid: &Grid) -> Result<Values, ImportError> {
    let offset = cursor.at;
    if cursor.u32("the root of a tree")? != 1 {
        return Err(ImportError::malformed(cursor.path, offset as u64, "a tree with several values at a place"));
    }
    let background = grid.number.take(&mut cursor, "the root of a tree")?;
    Ok(Values { number: grid.number, packing: grid.packing, background })
}

fn walk(mut cursor: Cursor, grid: &Grid, limits: &Limits, visitor: &mut impl Visitor) -> Result<(), ImportError> {
    let what = "the root of a tree";
    let values = background(cursor, grid)?;
    cursor.u32(what)?;
    grid.number.take(&mut cursor, what)?;
    let [tiles, children] = [cursor.u32(what)?, cursor.u32(what)?];
    let mut places = FxHashSet::default();
    let mut place = |cursor: &mut Cursor| -> Result<IVec3, ImportError> {
        let low = cursor.place(what)?;
        // Nodes that lie on each other would be work without end.
        // The smallest number has no absolute value.
        let far = IVec3::splat(FARTHEST);
        let is_sound = low.cmpgt(-far).all() && low.cmplt(far).all() && (low & 4095) == IVec3::ZERO;
        if !is_sound || !places.insert(low) {
            return Err(cursor.malformed(format!("a node at {low}, where it cannot be or another one is")));
        }
        if places.len() as u64 > limits.items {
            let count = places.len() as u64;
            return Err(ImportError::limit(cursor.path, Some(cursor.at as u64), "nodes", count, limits.items));
        }
        Ok(low)
    };
    for _ in 0..tiles {
        let low = place(&mut cursor)?;
        let value = grid.number.take(&mut cursor, what)?;
        let is_active = cursor.array::<1>(what)?[0] != 0;
        visitor.tile(low, 12, value, is_active);
    }
    for _ in 0..children {
        let low = place(&mut cursor)?;
        node(&mut cursor, &values, low, &LEVELS, visitor)?;
    }
    Ok(())
}

/// A node whose parts are nodes or tiles; of the last level they are leaves or tiles.
fn node(
    cursor: &mut Cursor,
    values: &Values,
    low: IVec3,
    levels: &[(u32, u32)],
    visitor: &mut impl Visitor,
) -> Result<(), ImportError> {
    let Some((&(edge, part), below)) = levels.split_first() else {
        visitor.leaf(low, cursor.take(LEAF_MASK, "a leaf")?);
        return Ok(());
    };
    let bytes = 1u64 << (3 * edge - 3);
    let (children, active) = (cursor.take(bytes, "a node")?, cursor.take(bytes, "a node")?);
    let start = cursor.at as u64;
    let packed = values.take(cursor, active)?;
    // Bits of parts from x slowest to z fastest.
    let at = |n: usize| {
        let mask = (1 << edge) - 1;
        low + (IVec3::new((n >> (2 * edge)) as i32, (n >> edge) as i32, n as i32) & mask) * (1 << part)
    };
    if visitor.wants_values() {
        let numbers =
            values.unpack(&packed, active).map_err(|what| ImportError::malformed(cursor.path, start, what))?;
        for (n, &value) in numbers.iter().enumerate().filter(|&(n, _)| !bit(children, n)) {
            visitor.tile(at(n), part, value, bit(active, n));
        }
    } else {
        let tiles = (0..active.len() * 8).filter(|&n| bit(active, n) && !bit(children, n));
        tiles.for_each(|n| visitor.tile(at(n), part, 0.0, true));
    }
    for n in (0..children.len() * 8).filter(|&n| bit(children, n)) {
        node(cursor, values, at(n), below, visitor)?;
    }
    Ok(())
}

/// The box around what is active, `high` just outside.
struct Bounds {
    low: IVec3,
    high: IVec3,
}

impl Visitor for Bounds {
    fn tile(&mut self, low: IVec3, log: u32, _: f32, is_active: bool) {
        if is_active {
            self.low = self.low.min(low);
            self.high = self.high.max(low + (1 << log));
        }
    }

    fn leaf(&mut self, low: IVec3, mask: &[u8]) {
        // A row along z is a byte.
        for (row, &byte) in mask.iter().enumerate().filter(|(_, byte)| **byte != 0) {
            let at = low + IVec3::new(row as i32 / LEAF, row as i32 % LEAF, 0);
            self.low = self.low.min(at + IVec3::Z * byte.trailing_zeros() as i32);
            self.high = self.high.max(at + IVec3::new(1, 1, LEAF - byte.leading_zeros() as i32));
        }
    }

    fn wants_values(&self) -> bool {
        false
    }
}

/// The box in the making.
struct Fill {
    low: IVec3,
    size: [usize; 3],
    values: Vec<f32>,
    /// Where leaves lie, in the order in which their numbers follow.
    leaves: Vec<IVec3>,
}

impl Visitor for Fill {
    fn tile(&mut self, low: IVec3, log: u32, value: f32, _: bool) {
        let size = IVec3::from_array(self.size.map(|edge| edge as i32));
        let from = (low - self.low).clamp(IVec3::ZERO, size);
        let to = (low - self.low + (1 << log)).clamp(IVec3::ZERO, size);
        for (z, y) in (from.z..to.z).flat_map(|z| (from.y..to.y).map(move |y| (z, y))) {
            let row = self.row(y, z);
            self.values[row + from.x as usize..row + to.x.max(from.x) as usize].fill(value);
        }
    }

    fn leaf(&mut self, low: IVec3, _: &[u8]) {
        self.leaves.push(low);
    }

    fn wants_values(&self) -> bool {
        true
    }
}

impl Fill {
    /// Where a row of voxels begins.
    fn row(&self, y: i32, z: i32) -> usize {
        (z as usize * self.size[1] + y as usize) * self.size[0]
    }

    /// Takes the numbers of all leaves.
    fn leaves(&mut self, mut cursor: Cursor, values: &Values) -> Result<(), ImportError> {
        let path = cursor.path;
        let leaves = std::mem::take(&mut self.leaves);
        if values.number.is_bit() {
            for low in leaves {
                // Which are active, where the leaf lies, and the bits.
                cursor.take(LEAF_MASK + 12, "a leaf")?;
                let bits = cursor.take(LEAF_MASK, "a leaf")?;
                let numbers: Vec<f32> = (0..bits.len() * 8).map(|n| f32::from(u8::from(bit(bits, n)))).collect();
                self.put(low - self.low, &numbers);
            }
            return Ok(());
        }
        for leaves in leaves.chunks(BATCH) {
            let mut found: Vec<(u64, &[u8], Packed)> = Vec::with_capacity(leaves.len());
            for _ in leaves {
                let active = cursor.take(LEAF_MASK, "a leaf")?;
                found.push((cursor.at as u64, active, values.take(&mut cursor, active)?));
            }
            let numbers = found.par_iter().map(|(start, active, packed)| {
                values.unpack(packed, active).map_err(|what| ImportError::malformed(path, *start, what))
            });
            let numbers: Vec<Result<Vec<f32>, ImportError>> = numbers.collect();
            for (low, numbers) in leaves.iter().zip(numbers) {
                self.put(*low - self.low, &numbers?);
            }
        }
        Ok(())
    }

    /// Puts the numbers of a leaf, z fastest, to where they lie in the box.
    fn put(&mut self, low: IVec3, numbers: &[f32]) {
        let size = IVec3::from_array(self.size.map(|edge| edge as i32));
        for (n, &value) in numbers.iter().enumerate() {
            let n = n as i32;
            let at = low + IVec3::new(n / (LEAF * LEAF), n / LEAF % LEAF, n % LEAF);
            if at.cmpge(IVec3::ZERO).all() && at.cmplt(size).all() {
                let place = self.row(at.y, at.z) + at.x as usize;
                self.values[place] = value;
            }
        }
    }
}
