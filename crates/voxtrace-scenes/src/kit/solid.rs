//! Constructive solid geometry: solids built from primitives by union, intersection, difference and transforms, each part with
//! a paint. Solids are cheap to clone: parts are shared. Lengths are metres, angles degrees, z is up.

use super::{
    noise::sin_cos_degrees,
    paint::Paint,
    profile::Profile,
    shape::{Axis, Shape},
};
use glam::{Mat3, Vec3, vec2, vec3};
use std::sync::Arc;

/// A solid.
#[derive(Clone, Debug)]
pub struct Solid(pub(super) Arc<Node>);

#[derive(Debug)]
pub(super) enum Node {
    Shape(Shape),
    Union(Vec<Solid>),
    Intersection(Solid, Solid),
    Difference(Solid, Solid),
    Complement(Solid),
    Placed(Placement, Solid),
    Painted(Paint, Solid),
}

/// `p ↦ scale · linear · p + origin`, `linear` a rotation or mirrored rotation.
#[derive(Clone, Copy, Debug)]
pub(super) struct Placement {
    pub linear: Mat3,
    pub origin: Vec3,
    pub scale: f32,
}

impl Placement {
    pub const IDENTITY: Self = Self { linear: Mat3::IDENTITY, origin: Vec3::ZERO, scale: 1.0 };

    /// `self` after `first`.
    pub fn after(&self, first: &Self) -> Self {
        Self {
            linear: self.linear * first.linear,
            origin: self.linear * first.origin * self.scale + self.origin,
            scale: self.scale * first.scale,
        }
    }

    /// The point whose image is `p`.
    #[inline]
    pub fn inverse_point(&self, p: Vec3) -> Vec3 {
        let p = p - self.origin;
        vec3(self.linear.x_axis.dot(p), self.linear.y_axis.dot(p), self.linear.z_axis.dot(p)) / self.scale
    }
}

impl From<Shape> for Solid {
    fn from(shape: Shape) -> Self {
        Self(Arc::new(Node::Shape(shape)))
    }
}

/// A box from corner to corner.
pub fn cuboid(min: Vec3, max: Vec3) -> Solid {
    rounded_cuboid(min, max, 0.0)
}

/// A box from corner to corner with edges rounded by `radius`.
pub fn rounded_cuboid(min: Vec3, max: Vec3, radius: f32) -> Solid {
    let (low, high) = (min.min(max), min.max(max));
    Solid::from(Shape::Cuboid((high - low) * 0.5, radius)).at((high + low) * 0.5)
}

/// A box that stands on the origin: width, depth, height.
pub fn block(width: f32, depth: f32, height: f32) -> Solid {
    cuboid(vec3(-width * 0.5, -depth * 0.5, 0.0), vec3(width * 0.5, depth * 0.5, height))
}

/// A sphere around the origin.
pub fn ball(radius: f32) -> Solid {
    Shape::Ball(radius).into()
}

/// An ellipsoid around the origin.
pub fn ellipsoid(radii: Vec3) -> Solid {
    Shape::Ellipsoid(radii).into()
}

/// An upright cylinder that stands on the origin.
pub fn cylinder(radius: f32, height: f32) -> Solid {
    Solid::from(Shape::Cylinder(radius, height * 0.5)).at(vec3(0.0, 0.0, height * 0.5))
}

/// An upright cone or frustum that stands on the origin: radius below and above.
pub fn cone(below: f32, above: f32, height: f32) -> Solid {
    revolve(&[(below, 0.0), (above, height)])
}

/// A torus around the z axis: radius of the ring and of its tube.
pub fn torus(ring: f32, tube: f32) -> Solid {
    Shape::Torus(ring, tube).into()
}

/// A capsule: a round bar from `a` to `b` with hemispherical ends.
pub fn bar(a: Vec3, b: Vec3, radius: f32) -> Solid {
    Shape::Bar(a, b, radius).into()
}

/// Capsules from point to point.
pub fn bars(points: &[Vec3], radius: f32) -> Solid {
    union(points.windows(2).map(|ends| bar(ends[0], ends[1], radius)))
}

/// The half-space behind the plane through `through`, on the side that `normal` points away from.
pub fn half_space(through: Vec3, normal: Vec3) -> Solid {
    let normal = normal.normalize();
    Shape::HalfSpace(normal, normal.dot(through)).into()
}

/// A profile extruded along an axis, from `from` to `to`. Profile coordinates: see [`Axis`].
pub fn extrude(profile: Profile, axis: Axis, from: f32, to: f32) -> Solid {
    if let Profile::Union(parts) = profile {
        // Parts of their own can be left out where they are far.
        return union(parts.into_iter().map(|part| extrude(part, axis, from, to)));
    }
    let (middle, half) = ((from + to) * 0.5, (to - from) * 0.5);
    let at = match axis {
        Axis::X => vec3(middle, 0.0, 0.0),
        Axis::Y => vec3(0.0, middle, 0.0),
        Axis::Z => vec3(0.0, 0.0, middle),
    };
    Solid::from(Shape::Prism(profile, axis, half)).at(at)
}

/// A solid of revolution about the z axis: its outline (radius, z) from the lowest to the highest point; it is closed
/// along horizontal lines to the axis.
pub fn revolve(outline: &[(f32, f32)]) -> Solid {
    // Close the figure far beyond the axis: an edge on the axis itself would count as a surface.
    let (first, last) = (outline[0], outline[outline.len() - 1]);
    revolve_profile(Profile::polygon(&[outline, &[(-1000.0, last.1), (-1000.0, first.1)]].concat()))
}

/// A solid of revolution: a profile in (distance from the z axis, z), revolved about the z axis.
pub fn revolve_profile(profile: Profile) -> Solid {
    Shape::Revolution(profile).into()
}

/// A section swept along the border of a path; section coordinates are (distance outwards from the border, position
/// along the axis).
pub fn moulding(path: Profile, section: Profile, axis: Axis) -> Solid {
    Shape::Moulding { path, section, axis }.into()
}

/// A gable roof or tent: `width` along x, `length` along y, rising to `height`, standing on the origin.
pub fn gable(width: f32, length: f32, height: f32) -> Solid {
    let triangle = Profile::polygon(&[(-width * 0.5, 0.0), (width * 0.5, 0.0), (0.0, height)]);
    extrude(triangle, Axis::Y, -length * 0.5, length * 0.5)
}

/// Everything below a noise height field of mean height 0.
pub fn hills(amplitude: f32, feature_size: f32, seed: u32) -> Solid {
    Shape::Hills(amplitude, feature_size, seed).into()
}

/// Everything outside `cavity`: a room seen from within, of which only the inner surface will exist.
pub fn around(cavity: Solid) -> Solid {
    Solid(Arc::new(Node::Complement(cavity)))
}

/// All points of any part. An empty list is empty space.
pub fn union(parts: impl IntoIterator<Item = Solid>) -> Solid {
    Solid(Arc::new(Node::Union(parts.into_iter().collect())))
}

/// `count` copies, each turned by an equal angle about the z axis.
pub fn ring(count: u32, part: &Solid) -> Solid {
    union((0..count).map(|i| part.turn_z(360.0 * i as f32 / count as f32)))
}

/// `count` copies, each `step` further than the one before.
pub fn row(count: u32, step: Vec3, part: &Solid) -> Solid {
    union((0..count).map(|i| part.at(step * i as f32)))
}

impl Solid {
    /// The union with another solid.
    pub fn and(&self, other: Solid) -> Solid {
        union([self.clone(), other])
    }

    /// The difference; the cut surface takes the paint of `other` if it has one, else that of this solid.
    pub fn minus(&self, other: Solid) -> Solid {
        Self(Arc::new(Node::Difference(self.clone(), other)))
    }

    /// The intersection with another solid.
    pub fn within(&self, other: Solid) -> Solid {
        Self(Arc::new(Node::Intersection(self.clone(), other)))
    }

    /// Painted. The innermost paint of a nested solid wins. The paint's pattern lies in the coordinates
    /// that the solid has here and moves with it from here on.
    pub fn paint(&self, paint: &Paint) -> Solid {
        Self(Arc::new(Node::Painted(paint.clone(), self.clone())))
    }

    /// Moved.
    pub fn at(&self, to: Vec3) -> Solid {
        self.placed(Placement { origin: to, ..Placement::IDENTITY })
    }

    /// Moved along x.
    pub fn x(&self, by: f32) -> Solid {
        self.at(vec3(by, 0.0, 0.0))
    }

    /// Moved along y.
    pub fn y(&self, by: f32) -> Solid {
        self.at(vec3(0.0, by, 0.0))
    }

    /// Moved along z.
    pub fn z(&self, by: f32) -> Solid {
        self.at(vec3(0.0, 0.0, by))
    }

    /// Turned about the x axis, y towards z.
    pub fn turn_x(&self, degrees: f32) -> Solid {
        let (s, c) = sin_cos_degrees(degrees);
        self.turned(Mat3::from_cols(Vec3::X, vec3(0.0, c, s), vec3(0.0, -s, c)))
    }

    /// Turned about the y axis, z towards x.
    pub fn turn_y(&self, degrees: f32) -> Solid {
        let (s, c) = sin_cos_degrees(degrees);
        self.turned(Mat3::from_cols(vec3(c, 0.0, -s), Vec3::Y, vec3(s, 0.0, c)))
    }

    /// Turned about the z axis, x towards y.
    pub fn turn_z(&self, degrees: f32) -> Solid {
        let (s, c) = sin_cos_degrees(degrees);
        self.turned(Mat3::from_cols(vec3(c, s, 0.0), vec3(-s, c, 0.0), Vec3::Z))
    }

    /// Turned so that its x axis points along (x, y).
    pub fn turn_towards(&self, x: f32, y: f32) -> Solid {
        let to = vec2(x, y).normalize();
        self.turned(Mat3::from_cols(vec3(to.x, to.y, 0.0), vec3(-to.y, to.x, 0.0), Vec3::Z))
    }

    /// Mirrored at the plane x = 0.
    pub fn mirror_x(&self) -> Solid {
        self.turned(Mat3::from_diagonal(vec3(-1.0, 1.0, 1.0)))
    }

    /// Mirrored at the plane y = 0.
    pub fn mirror_y(&self) -> Solid {
        self.turned(Mat3::from_diagonal(vec3(1.0, -1.0, 1.0)))
    }

    /// This and its mirror image at the plane x = 0.
    pub fn both_x(&self) -> Solid {
        self.and(self.mirror_x())
    }

    /// This and its mirror image at the plane y = 0.
    pub fn both_y(&self) -> Solid {
        self.and(self.mirror_y())
    }

    /// Scaled about the origin.
    pub fn scaled(&self, scale: f32) -> Solid {
        self.placed(Placement { scale, ..Placement::IDENTITY })
    }

    fn turned(&self, linear: Mat3) -> Solid {
        self.placed(Placement { linear, ..Placement::IDENTITY })
    }

    fn placed(&self, placement: Placement) -> Solid {
        match &*self.0 {
            Node::Placed(first, solid) => Self(Arc::new(Node::Placed(placement.after(first), solid.clone()))),
            _ => Self(Arc::new(Node::Placed(placement, self.clone()))),
        }
    }
}
