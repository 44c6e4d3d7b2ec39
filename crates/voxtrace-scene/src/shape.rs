//! Regions of voxels that are edited as one: boxes, spheres, capsules. What of a brick lies inside is a mask of bits.

use crate::brick::{BLOCK_SIZE, BRICK_SIZE, voxel_of};
use crate::grid::{MAX_COORDINATE, VoxelBox, brick_of};
use glam::{DVec3, IVec3};

/// One bit for each voxel of a brick, block by block.
pub(crate) type Mask = [u64; 8];
pub(crate) const FULL: Mask = [u64::MAX; 8];

/// A region of voxels: those whose centres lie inside.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Shape {
    /// A box, of whole voxels.
    Box(VoxelBox),
    /// What is at most `radius` from `center`.
    Sphere {
        /// In voxels of the grid.
        center: DVec3,
        /// In voxels.
        radius: f64,
    },
    /// What is at most `radius` from the line between two points: a stroke of a round brush.
    Capsule {
        /// One end, in voxels of the grid.
        from: DVec3,
        /// The other end.
        to: DVec3,
        /// In voxels.
        radius: f64,
    },
}

impl Shape {
    /// The smallest box around its voxels, or one that is a little larger, `None` where it is empty or not finite. A thin capsule may have a box and
    /// no voxels.
    pub fn bounds(&self) -> Option<VoxelBox> {
        match *self {
            Self::Box(region) => (!is_empty(region)).then_some(region),
            Self::Sphere { center, radius } => sphere_box(center, radius),
            Self::Capsule { from, to, radius } => {
                let (a, b) = (sphere_box(from, radius + 0.5)?, sphere_box(to, radius + 0.5)?);
                Some(VoxelBox { min: a.min.min(b.min), max: a.max.max(b.max) })
            }
        }
    }

    /// Whether a voxel lies inside.
    pub fn contains(&self, voxel: IVec3) -> bool {
        let centre = voxel.as_dvec3() + 0.5;
        match *self {
            Self::Box(region) => region.contains(voxel),
            Self::Sphere { center, radius } => radius >= 0.0 && (centre - center).length_squared() <= radius * radius,
            Self::Capsule { from, to, radius } => {
                radius >= 0.0 && squared_distance(centre, from, to) <= radius * radius
            }
        }
    }

    /// The voxels of the brick `at` that lie inside: one bit for each, block by block.
    pub fn mask(&self, at: IVec3) -> [u64; 8] {
        match *self {
            Self::Box(region) => box_mask(region, at),
            Self::Sphere { center, radius } if radius >= 0.0 => sphere_mask(center, radius, at),
            Self::Capsule { from, to, radius } if radius >= 0.0 => capsule_mask((from, to), radius, at),
            _ => [0; 8],
        }
    }
}

/// Squared distance of a point from the line between two others.
fn squared_distance(point: DVec3, from: DVec3, to: DVec3) -> f64 {
    let along = to - from;
    let length = along.length_squared();
    let share = if length > 0.0 { ((point - from).dot(along) / length).clamp(0.0, 1.0) } else { 0.0 };
    (point - from - along * share).length_squared()
}

/// The voxels of the brick `at` whose centres lie in a capsule, which is convex.
fn capsule_mask((from, to): (DVec3, DVec3), radius: f64, at: IVec3) -> Mask {
    let corner = (at * BRICK_SIZE).as_dvec3() + 0.5;
    let inside = |point: DVec3| squared_distance(point, from, to) <= radius * radius;
    let half = f64::from(BRICK_SIZE - 1) / 2.0;
    let reach = radius + half * 3f64.sqrt() + 1e-9;
    if squared_distance(corner + half, from, to) > reach * reach {
        return [0; 8];
    }
    let is_corner_inside = |index: i32| {
        let pick = IVec3::new(index & 1, index >> 1 & 1, index >> 2);
        inside(corner + (pick * (BRICK_SIZE - 1)).as_dvec3())
    };
    if (0..8).all(is_corner_inside) {
        return FULL;
    }
    std::array::from_fn(|block| {
        (0..64).map(|bit| u64::from(inside(corner + voxel_of(block, bit).as_dvec3())) << bit).sum()
    })
}

/// The part of a box that can hold voxels.
pub(crate) fn within_range(region: VoxelBox) -> VoxelBox {
    let limit = IVec3::splat(MAX_COORDINATE);
    VoxelBox { min: region.min.max(-limit), max: region.max.min(limit + 1) }
}

pub(crate) fn assert_in_range(region: VoxelBox) {
    let in_range =
        region.min.cmpge(IVec3::splat(-MAX_COORDINATE)) & (region.max - 1).cmple(IVec3::splat(MAX_COORDINATE));
    assert!(is_empty(region) || in_range.all(), "region {region:?} is out of range");
}

pub(crate) fn is_empty(region: VoxelBox) -> bool {
    region.size().min_element() == 0
}

/// Number of bricks that a box touches.
pub(crate) fn brick_volume(region: VoxelBox) -> u64 {
    if is_empty(region) {
        return 0;
    }
    let edges = brick_of(region.max - 1) - brick_of(region.min) + 1;
    edges.to_array().into_iter().map(|edge| edge as u64).product()
}

/// Coordinates of the bricks that a box touches.
pub(crate) fn bricks_in(region: VoxelBox) -> impl Iterator<Item = IVec3> {
    let (first, last) = (brick_of(region.min), brick_of(region.max - 1));
    let last = if is_empty(region) { first - 1 } else { last };
    (first.z..=last.z)
        .flat_map(move |z| (first.y..=last.y).flat_map(move |y| (first.x..=last.x).map(move |x| IVec3::new(x, y, z))))
}

/// The voxels of the brick `at` that lie in a box.
pub(crate) fn box_mask(region: VoxelBox, at: IVec3) -> Mask {
    let corner = at * BRICK_SIZE;
    let within = |at: IVec3| at.saturating_sub(corner).clamp(IVec3::ZERO, IVec3::splat(BRICK_SIZE));
    let (min, max) = (within(region.min), within(region.max));
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
pub(crate) fn sphere_box(center: DVec3, radius: f64) -> Option<VoxelBox> {
    if !center.is_finite() || !radius.is_finite() {
        return None;
    }
    let (min, max) = ((center - radius - 0.5).ceil(), (center + radius - 0.5).floor() + 1.0);
    let limit = DVec3::splat(f64::from(i32::MAX) / 4.0);
    let region = VoxelBox { min: min.clamp(-limit, limit).as_ivec3(), max: max.clamp(-limit, limit).as_ivec3() };
    (radius >= 0.0 && !is_empty(region)).then_some(region)
}

/// The voxels of the brick `at` whose centres lie in a sphere.
pub(crate) fn sphere_mask(center: DVec3, radius: f64, at: IVec3) -> Mask {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn masks_are_of_the_voxels_inside() {
        let center = DVec3::new(3.3, -2.0, 9.7);
        let shapes = [
            Shape::Box(VoxelBox { min: IVec3::new(-3, 2, -9), max: IVec3::new(12, 5, 8) }),
            Shape::Box(VoxelBox { min: IVec3::MIN, max: IVec3::new(3, i32::MAX, -5) }),
            Shape::Sphere { center, radius: 9.2 },
            Shape::Sphere { center, radius: -1.0 },
            Shape::Capsule { from: center, to: DVec3::new(-8.0, 5.5, 0.0), radius: 4.1 },
            Shape::Capsule { from: center, to: center, radius: 14.0 },
            Shape::Capsule { from: center, to: DVec3::new(3.3, 20.0, 9.7), radius: 0.3 },
        ];
        for shape in shapes {
            let mut inside = 0;
            for index in 0..8 * 8 * 8 {
                let at = IVec3::new(index & 7, index >> 3 & 7, index >> 6) - 4;
                let mask = shape.mask(at);
                for bit in 0..512 {
                    let voxel = at * BRICK_SIZE + voxel_of(bit / 64, bit as u32 % 64);
                    let is_set = mask[bit / 64] >> (bit % 64) & 1 == 1;
                    assert_eq!(is_set, shape.contains(voxel), "{shape:?} {voxel}");
                    assert!(
                        !is_set || shape.bounds().is_some_and(|bounds| bounds.contains(voxel)),
                        "{shape:?} {voxel}"
                    );
                    inside += usize::from(is_set);
                }
            }
            assert_eq!(inside > 0, shape.bounds().is_some(), "{shape:?}");
        }
    }
}
