//! The editable voxel grid: a sparse map from brick coordinates to bricks. Importers and generators fill it, edits
//! change it, and packing turns it into the flat arrays that tracers read.

use crate::brick::{BRICK_SIZE, Brick};
use glam::IVec3;
use rayon::prelude::*;
use rustc_hash::FxHashMap;

/// Largest coordinate (absolute value) of a voxel that a grid accepts: rays are f32, whose spacing at 2¹⁹ is 1/16 voxel.
pub const MAX_COORDINATE: i32 = 1 << 19;

/// A sparse, unbounded (±[`MAX_COORDINATE`]) grid of voxels. The voxel (i, j, k) fills [i, i+1) × [j, j+1) × [k, k+1)
/// of grid space; its value is an index into the scene's materials.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct VoxelGrid {
    bricks: FxHashMap<IVec3, Brick>,
}

/// An axis-aligned box of voxels: `min` inclusive, `max` exclusive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct VoxelBox {
    /// Lowest voxel inside.
    pub min: IVec3,
    /// One past the highest voxel inside.
    pub max: IVec3,
}

impl VoxelBox {
    /// Voxels along each axis, 0 where the box is inside out.
    pub fn size(&self) -> IVec3 {
        // Corners may be as far out as numbers go.
        self.max.saturating_sub(self.min).max(IVec3::ZERO)
    }

    /// Whether the voxel lies inside.
    pub fn contains(&self, voxel: IVec3) -> bool {
        voxel.cmpge(self.min).all() && voxel.cmplt(self.max).all()
    }
}

/// Coordinates of the brick that holds a voxel.
#[inline]
pub fn brick_of(voxel: IVec3) -> IVec3 {
    voxel >> 3
}

/// Coordinates, 0..8 each, of a voxel within its brick.
#[inline]
pub fn local_of(voxel: IVec3) -> IVec3 {
    voxel & (BRICK_SIZE - 1)
}

impl VoxelGrid {
    /// An empty grid.
    pub fn new() -> Self {
        Self::default()
    }

    /// A grid from whole bricks; later bricks replace earlier ones of the same coordinates, empty ones are dropped.
    pub fn from_bricks(bricks: impl IntoIterator<Item = (IVec3, Brick)>) -> Self {
        Self { bricks: bricks.into_iter().filter(|(_, brick)| !brick.is_empty()).collect() }
    }

    /// The material of a voxel, `None` where the grid is empty.
    pub fn get(&self, voxel: IVec3) -> Option<u16> {
        self.bricks.get(&brick_of(voxel))?.get(local_of(voxel))
    }

    /// Occupies a voxel. Returns the material it had.
    ///
    /// # Panics
    /// If a coordinate is beyond [`MAX_COORDINATE`].
    pub fn set(&mut self, voxel: IVec3, material: u16) -> Option<u16> {
        assert!(voxel.abs().cmple(IVec3::splat(MAX_COORDINATE)).all(), "voxel {voxel} is out of range");
        self.bricks.entry(brick_of(voxel)).or_default().set(local_of(voxel), Some(material))
    }

    /// Empties a voxel. Returns the material it had.
    pub fn clear(&mut self, voxel: IVec3) -> Option<u16> {
        let brick = self.bricks.get_mut(&brick_of(voxel))?;
        let was = brick.set(local_of(voxel), None);
        if brick.is_empty() {
            self.bricks.remove(&brick_of(voxel));
        }
        was
    }

    /// The brick at brick coordinates (voxel coordinates divided by 8, rounded down).
    pub fn brick(&self, coordinates: IVec3) -> Option<&Brick> {
        self.bricks.get(&coordinates)
    }

    /// Puts a whole brick in place; an empty one removes what was there.
    pub fn set_brick(&mut self, coordinates: IVec3, brick: Brick) {
        if brick.is_empty() {
            self.bricks.remove(&coordinates);
        } else {
            self.bricks.insert(coordinates, brick);
        }
    }

    /// Number of bricks that hold a voxel.
    pub fn brick_count(&self) -> usize {
        self.bricks.len()
    }

    /// All bricks, ordered by z, then y, then x of their coordinates: the order does not depend on hashing.
    pub fn sorted_bricks(&self) -> Vec<(IVec3, &Brick)> {
        let mut bricks: Vec<_> = self.bricks.iter().map(|(&at, brick)| (at, brick)).collect();
        bricks.par_sort_unstable_by_key(|(at, _)| (at.z, at.y, at.x));
        bricks
    }

    /// All voxels with their materials, brick by brick in the order of [`Self::sorted_bricks`].
    pub fn voxels(&self) -> impl Iterator<Item = (IVec3, u16)> + '_ {
        self.sorted_bricks()
            .into_iter()
            .flat_map(|(at, brick)| brick.voxels().map(move |(local, material)| (at * BRICK_SIZE + local, material)))
    }

    /// Number of occupied voxels.
    pub fn count(&self) -> u64 {
        self.bricks.values().map(|brick| brick.materials().len() as u64).sum()
    }

    /// Whether no voxel is occupied.
    pub fn is_empty(&self) -> bool {
        self.bricks.is_empty()
    }

    /// The smallest box around all voxels, `None` for an empty grid.
    pub fn bounds(&self) -> Option<VoxelBox> {
        self.bricks
            .par_iter()
            .map(|(&at, brick)| brick_bounds(at, brick))
            .reduce_with(|a, b| VoxelBox { min: a.min.min(b.min), max: a.max.max(b.max) })
    }
}

fn brick_bounds(at: IVec3, brick: &Brick) -> VoxelBox {
    let (mut min, mut max) = (IVec3::splat(i32::MAX), IVec3::splat(i32::MIN));
    for (local, _) in brick.voxels() {
        min = min.min(local);
        max = max.max(local);
    }
    VoxelBox { min: at * BRICK_SIZE + min, max: at * BRICK_SIZE + max + 1 }
}
