//! Edits of whole regions: boxes, spheres and copies. They work brick by brick on bit masks; a brick that a region covers
//! is written whole, without visiting its voxels.

use crate::brick::{BLOCK_SIZE, BRICK_SIZE, Brick, bits, block_bit, block_index, voxel_of};
use crate::grid::{MAX_COORDINATE, VoxelBox, VoxelGrid, brick_of};
use glam::{DVec3, IVec3};

/// One bit for each voxel of a brick, block by block.
type Mask = [u64; 8];
const FULL: Mask = [u64::MAX; 8];
const VOXELS_PER_BRICK: usize = 512;

impl VoxelGrid {
    /// Occupies every voxel of a box.
    ///
    /// # Panics
    /// If the box reaches beyond [`MAX_COORDINATE`].
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
    /// If the sphere reaches beyond [`MAX_COORDINATE`], or is not finite.
    pub fn fill_sphere(&mut self, center: DVec3, radius: f64, material: u16) {
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
        let Some(region) = sphere_box(center, radius) else { return };
        self.clear_masked(within_range(region), |at| sphere_mask(center, radius, at));
    }

    /// Copies the voxels of a box of `source`, empty ones too, so that its lowest corner comes to lie at `destination`.
    /// Takes time by the volume of the box. To copy within a grid, copy from a clone.
    ///
    /// # Panics
    /// If the destination reaches beyond [`MAX_COORDINATE`].
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
        let merged = merged(self.brick(at), with, mask);
        self.set_brick(at, merged);
    }
}

/// The voxels of `with` inside the mask, and those of `old` outside.
fn merged(old: Option<&Brick>, with: Option<&Brick>, mask: Mask) -> Brick {
    let empty = Brick::default();
    let (old, with) = (old.unwrap_or(&empty), with.unwrap_or(&empty));
    let mut occupancy = [0; 8];
    let mut materials = Vec::new();
    let (mut old_left, mut with_left) = (old.materials(), with.materials());
    for block in 0..8 {
        let (old_block, with_block) = (old.occupancy()[block], with.occupancy()[block]);
        let (old_materials, with_materials);
        (old_materials, old_left) = old_left.split_at(old_block.count_ones() as usize);
        (with_materials, with_left) = with_left.split_at(with_block.count_ones() as usize);
        occupancy[block] = old_block & !mask[block] | with_block & mask[block];
        for bit in bits(occupancy[block]) {
            let before = (1 << bit) - 1;
            materials.push(if mask[block] >> bit & 1 != 0 {
                with_materials[(with_block & before).count_ones() as usize]
            } else {
                old_materials[(old_block & before).count_ones() as usize]
            });
        }
    }
    Brick::new(occupancy, materials)
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

/// The part of a box that can hold voxels.
fn within_range(region: VoxelBox) -> VoxelBox {
    let limit = IVec3::splat(MAX_COORDINATE);
    VoxelBox { min: region.min.max(-limit), max: region.max.min(limit + 1) }
}

fn assert_in_range(region: VoxelBox) {
    let in_range =
        region.min.cmpge(IVec3::splat(-MAX_COORDINATE)) & (region.max - 1).cmple(IVec3::splat(MAX_COORDINATE));
    assert!(is_empty(region) || in_range.all(), "region {region:?} is out of range");
}

fn is_empty(region: VoxelBox) -> bool {
    region.size().min_element() == 0
}

/// Number of bricks that a box touches.
fn brick_volume(region: VoxelBox) -> u64 {
    if is_empty(region) {
        return 0;
    }
    let edges = brick_of(region.max - 1) - brick_of(region.min) + 1;
    edges.to_array().into_iter().map(|edge| edge as u64).product()
}

/// Coordinates of the bricks that a box touches.
fn bricks_in(region: VoxelBox) -> impl Iterator<Item = IVec3> {
    let (first, last) = (brick_of(region.min), brick_of(region.max - 1));
    let last = if is_empty(region) { first - 1 } else { last };
    (first.z..=last.z)
        .flat_map(move |z| (first.y..=last.y).flat_map(move |y| (first.x..=last.x).map(move |x| IVec3::new(x, y, z))))
}

/// The voxels of the brick `at` that lie in a box.
fn box_mask(region: VoxelBox, at: IVec3) -> Mask {
    let corner = at * BRICK_SIZE;
    let (min, max) = ((region.min - corner).max(IVec3::ZERO), (region.max - corner).min(IVec3::splat(BRICK_SIZE)));
    std::array::from_fn(|block| {
        let origin = voxel_of(block, 0);
        let (low, high) = ((min - origin).max(IVec3::ZERO), (max - origin).min(IVec3::splat(BLOCK_SIZE)));
        if low.cmplt(high).all() { block_mask(low, high) } else { 0 }
    })
}

/// The bits of the voxels in a box inside a block, `low` inclusive, `high` exclusive, 0..=4 each.
fn block_mask(low: IVec3, high: IVec3) -> u64 {
    let span = |low: i32, high: i32| (1u64 << high) - (1u64 << low);
    // A row of x, repeated along y at each set bit of a mask with a step of 4, and along z with a step of 16.
    let row = span(low.x, high.x);
    let slice: u64 = (low.y..high.y).map(|y| row << (4 * y)).sum();
    (low.z..high.z).map(|z| slice << (16 * z)).sum()
}

/// The smallest box around the voxels whose centres lie in a sphere, `None` where there are none.
fn sphere_box(center: DVec3, radius: f64) -> Option<VoxelBox> {
    assert!(center.is_finite() && radius.is_finite(), "a sphere at {center} with radius {radius}");
    let (min, max) = ((center - radius - 0.5).ceil(), (center + radius - 0.5).floor() + 1.0);
    let limit = DVec3::splat(f64::from(i32::MAX) / 4.0);
    let region = VoxelBox { min: min.clamp(-limit, limit).as_ivec3(), max: max.clamp(-limit, limit).as_ivec3() };
    (radius >= 0.0 && !is_empty(region)).then_some(region)
}

/// The voxels of the brick `at` whose centres lie in a sphere.
fn sphere_mask(center: DVec3, radius: f64, at: IVec3) -> Mask {
    let corner = (at * BRICK_SIZE).as_dvec3() + 0.5 - center;
    let opposite = corner + f64::from(BRICK_SIZE - 1);
    let inside = |offset: DVec3| offset.length_squared() <= radius * radius;
    if inside(corner.abs().max(opposite.abs())) {
        return FULL;
    }
    if !inside(DVec3::ZERO.clamp(corner, opposite)) {
        return [0; 8];
    }
    std::array::from_fn(|block| {
        (0..64).map(|bit| u64::from(inside(corner + voxel_of(block, bit).as_dvec3())) << bit).sum()
    })
}
