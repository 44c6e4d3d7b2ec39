//! What goes into acceleration structures: boxes or triangles in grid space, and the records that shaders read behind them.
//! `shaders/primitive.slang` is the other side.

use super::bricks::{Occupancy, for_each_brick};
use super::faces::{Rectangle, rectangles};
use crate::method::Primitive;
use voxtrace::PackedScene;
use voxtrace::glam::{IVec3, Vec3};
use voxtrace::packed::PackedGrid;

/// A box as hardware takes it: lowest corner, highest corner.
pub type Aabb = [f32; 6];

/// The primitives of one grid.
#[derive(Debug, Default)]
pub struct Geometry {
    /// Boxes, a little larger than what they hold.
    pub boxes: Vec<Aabb>,
    /// Corners of rectangles, four each, in the order of the triangles (0, 1, 2) and (2, 1, 3).
    pub corners: Vec<[f32; 3]>,
    /// Records, [`words_per_record`] for each box or rectangle.
    pub records: Vec<u32>,
}

/// Words of a record.
pub fn words_per_record(primitive: Primitive) -> usize {
    match primitive {
        Primitive::VoxelExact | Primitive::VoxelApprox => 8,
        Primitive::Brick | Primitive::Triangle => 3,
        Primitive::Grid => 0,
    }
}

impl Geometry {
    /// The primitives of a grid.
    pub fn of(scene: &PackedScene, grid: &PackedGrid, primitive: Primitive) -> Self {
        let mut geometry = Self::default();
        let margin = margin(grid);
        match primitive {
            Primitive::Grid => geometry.boxes.push(inflated(grid.min, grid.max, margin)),
            Primitive::Brick => for_each_brick(scene, grid, &mut |brick| {
                let (low, high) = Occupancy::of(scene, brick.record).bounds();
                let corner = grid.origin + brick.low;
                geometry.boxes.push(inflated(corner + low, corner + high, margin));
                let [x, y, z]: [u64; 3] = (brick.low >> 3_i32).to_array().map(|coordinate| coordinate as u64);
                let place = x | y << 21 | z << 42;
                geometry.records.extend([(brick.record / 2) as u32, place as u32, (place >> 32) as u32]);
            }),
            Primitive::VoxelExact | Primitive::VoxelApprox => for_each_brick(scene, grid, &mut |brick| {
                for voxel in Occupancy::of(scene, brick.record).voxels() {
                    let voxel = grid.origin + brick.low + voxel;
                    geometry.boxes.push(inflated(voxel, voxel + 1, margin));
                    let corners = [voxel, voxel + 1].map(|corner| corner.as_vec3().to_array().map(f32::to_bits));
                    let material = scene.material_at(grid, voxel).unwrap_or(0);
                    geometry.records.extend(corners.concat());
                    geometry.records.extend([material, 0]);
                }
            }),
            Primitive::Triangle => for_each_brick(scene, grid, &mut |brick| {
                rectangles(scene, grid, brick, &mut |rectangle| geometry.push_rectangle(grid, &rectangle, margin));
            }),
        }
        geometry
    }

    /// Number of primitives as hardware counts them.
    pub fn count(&self) -> usize {
        self.boxes.len() + self.corners.len() / 2
    }

    fn push_rectangle(&mut self, grid: &PackedGrid, rectangle: &Rectangle, margin: f32) {
        let axis = rectangle.face as usize / 2;
        let others = [[1, 2], [0, 2], [0, 1]][axis];
        for corner in 0..4 {
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
