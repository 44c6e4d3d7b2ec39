//! A ray in the space of one grid, with what the walk computes once for each ray.

use crate::packed::PackedGrid;
use crate::ray::Ray;
use crate::transform::Transform;
use glam::Vec3;

/// A ray in grid space.
#[derive(Clone, Copy, Debug)]
pub struct LocalRay {
    /// Origin, voxels.
    pub origin: Vec3,
    /// Direction, with the world ray's parametrization.
    pub direction: Vec3,
    /// 1 / direction. Along an axis that the ray does not move along the largest number, so that the plane ahead is
    /// crossed later than any other.
    pub inverse: Vec3,
    /// First t.
    pub t_min: f32,
    /// Last t.
    pub t_max: f32,
}

impl LocalRay {
    /// The ray in the space of a grid, or `None` where it goes nowhere or is not finite: such rays hit nothing.
    #[inline]
    pub fn new(ray: &Ray, grid_from_world: &Transform) -> Option<Self> {
        // The identity is the common case, and then nothing may be rounded.
        let (origin, direction) = if *grid_from_world == Transform::IDENTITY {
            (ray.origin, ray.direction)
        } else {
            (grid_from_world.point(ray.origin), grid_from_world.direction(ray.direction))
        };
        // A component whose inverse overflows moves the ray by less than rounding does: it counts as none.
        let direction = Vec3::select((1.0 / direction).abs().cmple(Vec3::MAX), direction, Vec3::ZERO);
        let inverse = Vec3::select(direction.cmpeq(Vec3::ZERO), Vec3::MAX, 1.0 / direction);
        let moves = direction != Vec3::ZERO && origin.is_finite() && direction.is_finite();
        let segment = ray.t_min >= 0.0 && ray.t_min.is_finite() && ray.t_min <= ray.t_max;
        (moves && segment).then_some(Self { origin, direction, inverse, t_min: ray.t_min, t_max: ray.t_max })
    }

    /// The last t that can matter: steps may overestimate t by rounding.
    #[inline]
    pub(super) fn t_end(&self) -> f32 {
        self.t_max * (1.0 + 1e-6)
    }

    /// How far the f32 position on each axis may be from the true one (negative where it is exact), anywhere along the walk through a grid: five
    /// roundings of values no larger than the origin's and the grid's coordinates, and a sixth for safety.
    #[inline]
    pub(super) fn tolerance(&self, grid: &PackedGrid) -> Vec3 {
        let extent = grid.min.abs().max(grid.max.abs()).as_vec3() + 1.0;
        let tolerance = (self.origin.abs() + extent) * (6.0 * 0.5 * f32::EPSILON);
        // Along an axis without movement the position is the origin, exactly.
        Vec3::select(self.direction.cmpeq(Vec3::ZERO), Vec3::NEG_ONE, tolerance)
    }

    /// Bit a is set where the ray runs in the negative direction of axis a.
    #[inline]
    pub(super) fn octant(&self) -> usize {
        let bit = |axis: usize| usize::from(self.direction[axis] < 0.0) << axis;
        bit(0) | bit(1) | bit(2)
    }
}
