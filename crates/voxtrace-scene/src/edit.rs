//! Edits of whole regions: boxes, spheres and copies. They work brick by brick on bit masks; a brick that a region covers
//! is written whole, without visiting its voxels.

use crate::brick::{BRICK_SIZE, Brick, bits, block_bit, block_index};
use crate::grid::{VoxelBox, VoxelGrid, brick_of};
use crate::shape::{
    FULL, Mask, assert_in_range, box_mask, brick_volume, bricks_in, sphere_box, sphere_mask, within_range,
};
use glam::{DVec3, IVec3};

const VOXELS_PER_BRICK: usize = 512;

impl VoxelGrid {
    /// Occupies every voxel of a box.
    ///
    /// # Panics
    /// If the box reaches beyond [`MAX_COORDINATE`](crate::grid::MAX_COORDINATE).
    pub fn fill_box(&mut self, region: VoxelBox, material: u16) {
        assert_in_range(region);
        for at in bricks_in(region) {
            self.fill_masked(at, box_mask(region, at), material);
        }
    }

    /// Empties every voxel of a box of any size.
    pub fn clear_box(&mut self, region: VoxelBox) {
        let region = within_range(region);
        self.clear_masked(region, |at| box_mask(region, at));
    }

    /// Occupies every voxel whose centre is at most `radius` from `center`.
    ///
    /// # Panics
    /// If the sphere reaches beyond [`MAX_COORDINATE`](crate::grid::MAX_COORDINATE), or is not finite.
    pub fn fill_sphere(&mut self, center: DVec3, radius: f64, material: u16) {
        assert!(center.is_finite() && radius.is_finite(), "a sphere at {center} with radius {radius}");
        let Some(region) = sphere_box(center, radius) else { return };
        assert_in_range(region);
        for at in bricks_in(region) {
            self.fill_masked(at, sphere_mask(center, radius, at), material);
        }
    }

    /// Empties every voxel whose centre is at most `radius` from `center`, which may be as large as it likes.
    ///
    /// # Panics
    /// If the sphere is not finite.
    pub fn clear_sphere(&mut self, center: DVec3, radius: f64) {
        assert!(center.is_finite() && radius.is_finite(), "a sphere at {center} with radius {radius}");
        let Some(region) = sphere_box(center, radius) else { return };
        self.clear_masked(within_range(region), |at| sphere_mask(center, radius, at));
    }

    /// Copies the voxels of a box of `source`, empty ones too, so that its lowest corner comes to lie at `destination`.
    /// Takes time by the volume of the box. To copy within a grid, copy from a clone.
    ///
    /// # Panics
    /// If the destination reaches beyond [`MAX_COORDINATE`](crate::grid::MAX_COORDINATE).
    pub fn copy_region(&mut self, source: &VoxelGrid, region: VoxelBox, destination: IVec3) {
        let shift = destination - region.min;
        let target = VoxelBox { min: destination, max: destination + region.size() };
        assert_in_range(target);
        if shift & (BRICK_SIZE - 1) == IVec3::ZERO {
            self.copy_aligned(source, target, shift);
        } else {
            self.copy_shifted(source, target, shift);
        }
    }

    /// A copy by whole bricks.
    fn copy_aligned(&mut self, source: &VoxelGrid, target: VoxelBox, shift: IVec3) {
        for at in bricks_in(target) {
            let (mask, from) = (box_mask(target, at), source.brick(at - brick_of(shift)));
            if mask == FULL {
                self.set_brick(at, from.cloned().unwrap_or_default());
            } else {
                self.merge(at, mask, from);
            }
        }
    }

    /// A copy that moves voxels within their bricks: gathers each target brick from up to eight source bricks.
    fn copy_shifted(&mut self, source: &VoxelGrid, target: VoxelBox, shift: IVec3) {
        for at in bricks_in(target) {
            let lowest = at * BRICK_SIZE - shift;
            let first = brick_of(lowest);
            let mask = box_mask(target, at);
            let mut gathered = Dense::default();
            for corner in 0..8 {
                let step = IVec3::new(corner & 1, corner >> 1 & 1, corner >> 2);
                if let Some(brick) = source.brick(first + step) {
                    gathered.add(brick, (first + step) * BRICK_SIZE - lowest);
                }
            }
            self.merge(at, mask, Some(&gathered.into_brick()));
        }
    }

    /// Occupies the voxels of a mask in one brick.
    fn fill_masked(&mut self, at: IVec3, mask: Mask, material: u16) {
        if mask == FULL {
            self.set_brick(at, Brick::new(FULL, vec![material; VOXELS_PER_BRICK]));
        } else if mask != [0; 8] {
            let count = mask.iter().map(|block| block.count_ones() as usize).sum();
            self.merge(at, mask, Some(&Brick::new(mask, vec![material; count])));
        }
    }

    /// Empties the voxels of the bricks that a box touches, by the mask of each brick.
    fn clear_masked(&mut self, region: VoxelBox, mask_of: impl Fn(IVec3) -> Mask) {
        let touched: Vec<IVec3> = if brick_volume(region) <= self.brick_count() as u64 {
            bricks_in(region).filter(|&at| self.brick(at).is_some()).collect()
        } else {
            self.sorted_bricks().into_iter().map(|(at, _)| at).collect()
        };
        for at in touched {
            let mask = mask_of(at);
            if mask != [0; 8] {
                self.merge(at, mask, None);
            }
        }
    }

    /// Replaces the voxels of a mask in one brick by those of another brick, `None` for an empty one.
    fn merge(&mut self, at: IVec3, mask: Mask, with: Option<&Brick>) {
        let empty = Brick::default();
        let merged = self.brick(at).unwrap_or(&empty).replaced(with.unwrap_or(&empty), &mask);
        self.set_brick(at, merged);
    }
}

/// A brick with a place for every material.
struct Dense {
    occupancy: Mask,
    materials: [[u16; 64]; 8],
}

impl Default for Dense {
    fn default() -> Self {
        Self { occupancy: [0; 8], materials: [[0; 64]; 8] }
    }
}

impl Dense {
    /// Adds the voxels of a brick, moved by `offset`, that come to lie inside.
    fn add(&mut self, brick: &Brick, offset: IVec3) {
        for (local, material) in brick.voxels() {
            let local = local + offset;
            if local & (BRICK_SIZE - 1) == local {
                let (block, bit) = (block_index(local), block_bit(local));
                self.occupancy[block] |= 1 << bit;
                self.materials[block][bit as usize] = material;
            }
        }
    }

    fn into_brick(self) -> Brick {
        let blocks = self.occupancy.iter().zip(&self.materials);
        let materials = blocks.flat_map(|(mask, materials)| bits(*mask).map(|bit| materials[bit as usize])).collect();
        Brick::new(self.occupancy, materials)
    }
}
