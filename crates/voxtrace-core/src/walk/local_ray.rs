//! A ray in the space of one grid, with what the walk computes once for each ray.

use crate::packed::PackedGrid;
use glam::Vec3;
use std::borrow::Cow;
use voxtrace_scene::ray::Ray;
use voxtrace_scene::transform::Transform;

/// Six roundings, relative to the coordinates involved.
pub(super) const TOLERANCE_SCALE: f32 = 6.0 * 0.5 * f32::EPSILON;

/// Least speed, voxels for each unit of t, at which neither t nor its products leave the range of f32. A ray is as fast as the
/// largest component of its direction.
pub(super) const SPEED_MIN: f32 = 1e-18;
/// Largest such speed.
pub(super) const SPEED_MAX: f32 = 1e18;

/// Factor on the end of a segment: steps may overestimate t by rounding.
pub(super) const T_END_SCALE: f32 = 1.0 + 1e-6;

/// Largest absolute coordinate of a ray's origin, voxels of the grid.
pub const MAX_ORIGIN: f32 = 2_097_152.0;

/// Rays in the space of a grid, as [`LocalRay::new`] turns them: what a ray meets there is what it meets in the grid where that stands.
pub(super) fn turned<'a>(rays: &'a [Ray], grid_from_world: &Transform) -> Cow<'a, [Ray]> {
    if *grid_from_world == Transform::IDENTITY {
        return Cow::Borrowed(rays);
    }
    let turned = |ray: &Ray| Ray {
        origin: grid_from_world.point(ray.origin),
        direction: grid_from_world.direction(ray.direction),
        ..*ray
    };
    Cow::Owned(rays.iter().map(turned).collect())
}

/// A ray in grid space.
#[derive(Clone, Copy, Debug)]
pub struct LocalRay {
    /// Origin, voxels; along an axis that the ray does not move along the middle of its cell.
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
    /// The ray in the space of a grid, or `None` where it goes nowhere or at no sensible speed, is not finite, or starts more than
    /// [`MAX_ORIGIN`] voxels away, where f32 cannot say through which voxels it goes: such rays hit nothing.
    #[inline]
    pub fn new(ray: &Ray, grid_from_world: &Transform) -> Option<Self> {
        // The identity is the common case, and then nothing may be rounded.
        let (origin, direction) = if *grid_from_world == Transform::IDENTITY {
            (ray.origin, ray.direction)
        } else {
            (grid_from_world.point(ray.origin), grid_from_world.direction(ray.direction))
        };
        // Not left to the maximum of the components, which may drop it.
        let is_nan = direction.is_nan();
        // A component that some devices flush to zero moves the ray by less than rounding does: it counts as none.
        let is_zero = !direction.abs().cmpge(Vec3::splat(f32::MIN_POSITIVE));
        let direction = Vec3::select(is_zero, Vec3::ZERO, direction);
        let inverse = Vec3::select(is_zero, Vec3::MAX, 1.0 / direction);
        // Without movement only the cell matters. From its middle no plane is so near that the largest inverse gives a
        // small t.
        let origin = if is_zero.any() { Vec3::select(is_zero, origin.floor() + 0.5, origin) } else { origin };
        let moves = !is_nan && (SPEED_MIN..=SPEED_MAX).contains(&direction.abs().max_element());
        // False for what is not a number, too.
        let is_near = origin.abs().cmple(Vec3::splat(MAX_ORIGIN)).all();
        let segment = ray.t_min >= 0.0 && ray.t_min.is_finite() && ray.t_min <= ray.t_max;
        (moves && is_near && segment).then_some(Self { origin, direction, inverse, t_min: ray.t_min, t_max: ray.t_max })
    }

    /// The last t that can matter: steps may overestimate t by rounding. Always finite, so that a crossing whose time
    /// overflows ends the walk.
    #[inline]
    pub(super) fn t_end(&self) -> f32 {
        (self.t_max * T_END_SCALE).min(f32::MAX)
    }

    /// How far the f32 position on each axis may be from the true one (negative where it is exact), anywhere along the walk through a grid: five
    /// roundings of values no larger than the origin's and the grid's coordinates, and a sixth for safety.
    #[inline]
    pub(super) fn tolerance(&self, grid: &PackedGrid) -> Vec3 {
        let extent = grid.min.abs().max(grid.max.abs()).as_vec3() + 1.0;
        let tolerance = (self.origin.abs() + extent) * TOLERANCE_SCALE;
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
