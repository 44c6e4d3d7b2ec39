//! What goes into acceleration structures: boxes or triangles in grid space, and the records that shaders read behind them.
//! `shaders/primitive.slang` is the other side.

use super::bricks::{BrickAt, Occupancy, for_each_brick};
use super::faces::{Rectangle, rectangles};
use crate::method::Primitive;
use glam::{IVec3, Vec3};
use rayon::prelude::*;
use voxtrace_core::packed::{Geometry, PackedGrid};

/// A box as hardware takes it: lowest corner, highest corner.
pub type Aabb = [f32; 6];

/// The primitives of one grid.
#[derive(Debug, Default)]
pub struct Primitives {
    /// Boxes, a little larger than what they hold.
    pub boxes: Vec<Aabb>,
    /// Corners of rectangles, four each, in the order of the triangles (0, 1, 2) and (2, 1, 3).
    pub corners: Vec<[f32; 3]>,
    /// Records, [`words_per_record`] for each box or rectangle.
    pub records: Vec<u32>,
}

/// Words of a voxel's record: its box as six floats, the material, and a word of padding.
const VOXEL_WORDS: usize = 8;
/// Words of a brick's record: half the position of its record in [`Geometry`]'s bricks, and its coordinates from the grid's origin,
/// in bricks, 21 bits each.
const BRICK_WORDS: usize = 3;
/// Words of a rectangle's record: 8 · plane + face, and along both other axes the first voxel and, from bit 24 on, the number of
/// voxels less one, all from the grid's origin.
const RECTANGLE_WORDS: usize = 3;

/// Words of a record.
pub fn words_per_record(primitive: Primitive) -> usize {
    match primitive {
        Primitive::VoxelExact | Primitive::VoxelApprox => VOXEL_WORDS,
        Primitive::Brick => BRICK_WORDS,
        Primitive::Triangle => RECTANGLE_WORDS,
        Primitive::Grid => 0,
    }
}

/// Bricks that one task takes.
const BRICKS_AT_A_TIME: usize = 1024;

impl Primitives {
    /// The primitives of a grid. Where `is_opaque`, hardware has the last word on what is hit.
    pub fn of(geometry: &Geometry, grid: &PackedGrid, primitive: Primitive, is_opaque: bool) -> Self {
        if primitive == Primitive::Grid {
            return Self { boxes: vec![inflated(grid.min, grid.max, margin(grid))], ..Self::default() };
        }
        let mut bricks = Vec::new();
        for_each_brick(geometry, grid, &mut |brick| bricks.push(brick));
        let part = |bricks: &[BrickAt]| {
            let mut primitives = Self::default();
            for brick in bricks {
                primitives.push_brick(geometry, grid, brick, primitive, is_opaque);
            }
            primitives
        };
        let parts: Vec<Self> = bricks.par_chunks(BRICKS_AT_A_TIME).map(part).collect();
        let total = |size: fn(&Self) -> usize| parts.iter().map(size).sum();
        let mut all = Self {
            boxes: Vec::with_capacity(total(|part| part.boxes.len())),
            corners: Vec::with_capacity(total(|part| part.corners.len())),
            records: Vec::with_capacity(total(|part| part.records.len())),
        };
        for mut part in parts {
            all.boxes.append(&mut part.boxes);
            all.corners.append(&mut part.corners);
            all.records.append(&mut part.records);
        }
        all
    }

    fn push_brick(
        &mut self,
        geometry: &Geometry,
        grid: &PackedGrid,
        brick: &BrickAt,
        primitive: Primitive,
        is_opaque: bool,
    ) {
        let corner = grid.origin + brick.low;
        match primitive {
            Primitive::Brick => {
                let (low, high) = Occupancy::of(geometry, brick.record).bounds();
                self.boxes.push(inflated(corner + low, corner + high, margin(grid)));
                let [x, y, z]: [u64; 3] = (brick.low >> 3_i32).to_array().map(|coordinate| coordinate as u64);
                let place = x | y << 21 | z << 42;
                self.records.extend([(brick.record / 2) as u32, place as u32, (place >> 32) as u32]);
            }
            Primitive::VoxelExact | Primitive::VoxelApprox => {
                // Nobody asks whether a ray really meets the box of the approximate method: the voxel itself, as the study
                // has it, so that what is wrong is the device's and not ours.
                let margin = if primitive == Primitive::VoxelApprox { 0.0 } else { margin(grid) };
                for voxel in Occupancy::of(geometry, brick.record).voxels() {
                    let voxel = corner + voxel;
                    self.boxes.push(inflated(voxel, voxel + 1, margin));
                    let corners = [voxel, voxel + 1].map(|corner| corner.as_vec3().to_array().map(f32::to_bits));
                    let material = geometry.material_at(grid, voxel).unwrap_or(0);
                    self.records.extend(corners.concat());
                    self.records.extend([material, 0]);
                }
            }
            Primitive::Triangle => {
                // Nobody asks again whether the ray really meets an opaque rectangle: just enough to close the joints.
                let margin = if is_opaque { margin(grid) / 32.0 } else { margin(grid) };
                rectangles(geometry, grid, *brick, &mut |rectangle| self.push_rectangle(grid, &rectangle, margin));
            }
            Primitive::Grid => {}
        }
    }

    /// Number of primitives as hardware counts them.
    pub fn count(&self) -> usize {
        self.boxes.len() + self.corners.len() / 2
    }

    fn push_rectangle(&mut self, grid: &PackedGrid, rectangle: &Rectangle, margin: f32) {
        let axis = rectangle.face as usize / 2;
        let others = [[1, 2], [0, 2], [0, 1]][axis];
        // Seen from outside the corners of a triangle go around counterclockwise: hardware leaves out what is seen from behind.
        let is_outward = (rectangle.face & 1 == 1) == (axis == 1);
        for corner in if is_outward { [0, 2, 1, 3] } else { [0, 1, 2, 3] } {
            let mut point = Vec3::ZERO;
            point[axis] = (grid.origin[axis] + rectangle.plane) as f32;
            for (side, &other) in others.iter().enumerate() {
                // A little larger, so that no ray slips through between rectangles.
                let (first, count) = (grid.origin[other] + rectangle.first[side], rectangle.count[side]);
                let is_far = corner >> side & 1 == 1;
                point[other] = if is_far { (first + count) as f32 + margin } else { first as f32 - margin };
            }
            self.corners.push(point.to_array());
        }
        let side = |index: usize| rectangle.first[index] as u32 | (rectangle.count[index] as u32 - 1) << 24;
        self.records.extend([(rectangle.plane as u32) << 3 | rectangle.face, side(0), side(1)]);
    }
}

/// How much larger boxes are than what they hold, voxels: more than rounding can move a ray that comes from within a few
/// times the grid's size.
fn margin(grid: &PackedGrid) -> f32 {
    let largest = grid.min.abs().max(grid.max.abs()).max_element() as f32;
    (largest / 524_288.0).max(1.0 / 512.0)
}

fn inflated(low: IVec3, high: IVec3, margin: f32) -> Aabb {
    let (low, high) = (low.as_vec3() - margin, high.as_vec3() + margin);
    [low.x, low.y, low.z, high.x, high.y, high.z]
}
