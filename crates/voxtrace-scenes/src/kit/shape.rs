//! Primitive solids with a signed distance, in metres, negative inside, Lipschitz constant 1: what the shell
//! extraction relies on to skip space and to leave no holes.

use super::{
    noise::value_noise,
    profile::{Profile, box2},
};
use glam::{Vec2, Vec3, vec2, vec3};

/// An axis of space.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// x; a profile at right angles to it has (u, v) = (y, z).
    X,
    /// y; a profile at right angles to it has (u, v) = (x, z).
    Y,
    /// z; a profile at right angles to it has (u, v) = (x, y).
    Z,
}

impl Axis {
    /// The point's coordinates (u, v) at right angles to the axis, and the one along it.
    #[inline]
    fn split(self, p: Vec3) -> (Vec2, f32) {
        match self {
            Self::X => (vec2(p.y, p.z), p.x),
            Self::Y => (vec2(p.x, p.z), p.y),
            Self::Z => (vec2(p.x, p.y), p.z),
        }
    }
}

/// A primitive solid around the origin.
#[derive(Clone, Debug)]
pub enum Shape {
    /// A box: half its size, and the radius of its edges (part of the size).
    Cuboid(Vec3, f32),
    /// A sphere, by its radius.
    Ball(f32),
    /// An ellipsoid of three radii; its distance is a lower bound.
    Ellipsoid(Vec3),
    /// An upright cylinder: radius and half height.
    Cylinder(f32, f32),
    /// A torus around the z axis: radius of the ring and of its tube.
    Torus(f32, f32),
    /// A capsule between two points.
    Bar(Vec3, Vec3, f32),
    /// A half-space: the points with `normal · p ≤ offset`; the normal has unit length.
    HalfSpace(Vec3, f32),
    /// A profile extruded along an axis to ± half its length.
    Prism(Profile, Axis, f32),
    /// A profile in (distance from the z axis, z), revolved about the z axis.
    Revolution(Profile),
    /// A section swept along the border of a path: section coordinates are (distance outwards from the path's
    /// border, position along the axis).
    Moulding {
        /// The figure whose border is followed.
        path: Profile,
        /// The cross-section.
        section: Profile,
        /// Axis at right angles to the path's plane.
        axis: Axis,
    },
    /// The ground below a noise height field: amplitude, feature size, seed; mean height z = 0.
    Hills(f32, f32, u32),
}

impl Shape {
    /// Signed distance of a point from the surface, negative inside.
    pub fn distance(&self, p: Vec3) -> f32 {
        match self {
            Self::Cuboid(half, radius) => {
                let q = p.abs() - *half + *radius;
                q.max(Vec3::ZERO).length() + q.max_element().min(0.0) - radius
            }
            Self::Ball(radius) => p.length() - radius,
            Self::Ellipsoid(radii) => ((p / *radii).length() - 1.0) * radii.min_element(),
            Self::Cylinder(radius, half) => box2(vec2(vec2(p.x, p.y).length() - radius, p.z.abs() - half)),
            Self::Torus(ring, tube) => vec2(vec2(p.x, p.y).length() - ring, p.z).length() - tube,
            Self::Bar(a, b, radius) => {
                let (to_p, bar) = (p - *a, *b - *a);
                let along = (to_p.dot(bar) / bar.length_squared()).clamp(0.0, 1.0);
                (to_p - bar * along).length() - radius
            }
            Self::HalfSpace(normal, offset) => normal.dot(p) - offset,
            Self::Prism(profile, axis, half) => {
                let (uv, along) = axis.split(p);
                box2(vec2(profile.distance(uv), along.abs() - half))
            }
            Self::Revolution(profile) => profile.distance(vec2(vec2(p.x, p.y).length(), p.z)),
            Self::Moulding { path, section, axis } => {
                let (uv, along) = axis.split(p);
                section.distance(vec2(path.distance(uv), along))
            }
            &Self::Hills(amplitude, size, seed) => {
                let height = amplitude * value_noise(vec3(p.x / size, p.y / size, 0.5), seed);
                // The blend's steepest slope is 1.5 times the step between lattice values, at most 2, on each axis.
                let slope = amplitude * 3.0 / size;
                (p.z - height) / (1.0 + 2.0 * slope * slope).sqrt()
            }
        }
    }
}
