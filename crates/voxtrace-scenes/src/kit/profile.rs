//! Plane figures with a signed distance, in metres, negative inside: the outlines that are extruded, revolved or
//! swept into solids. The distance never changes faster than the point moves (Lipschitz constant 1). The formulas are
//! the common ones of implicit modelling (Hart, *Sphere tracing*, 1996).

use super::noise::sin_cos_degrees;
use glam::{Vec2, vec2};

/// A plane figure, in coordinates (u, v).
#[derive(Clone, Debug)]
pub enum Profile {
    /// A disc around the origin, by its radius.
    Disc(f32),
    /// A rectangle around the origin: half its size.
    Rectangle(Vec2),
    /// The points with `v ≤ 0`.
    Below,
    /// A regular octagon with sides towards the axes: half its width. Distances beyond its corners are lower bounds.
    Octagon(f32),
    /// A simple polygon by its edges, either way around: see [`Profile::polygon`].
    Polygon(Vec<Edge>),
    /// Everything closer to an open polyline than a half width.
    Stroke(Vec<Vec2>, f32),
    /// See [`Profile::arch`].
    Arch {
        /// Half the span.
        half_span: f32,
        /// Height of the springing line above v = 0.
        legs: f32,
        /// Radius of the two arcs; half the span makes a round arch.
        radius: f32,
    },
    /// The union.
    Union(Vec<Profile>),
    /// The difference, the first without the second.
    Minus(Box<(Profile, Profile)>),
    /// The intersection.
    Both(Box<(Profile, Profile)>),
    /// Offset outwards by a distance (inwards if negative), corners rounded.
    Offset(Box<Profile>, f32),
    /// The outline alone, this far to both sides.
    Outline(Box<Profile>, f32),
    /// Moved.
    Moved(Box<Profile>, Vec2),
    /// Turned counter-clockwise about the origin: sine and cosine.
    Turned(Box<Profile>, (f32, f32)),
    /// Stretched along u by a factor ≥ 1.
    Stretched(Box<Profile>, f32),
    /// The part with u ≥ 0 and its mirror image.
    Mirrored(Box<Profile>),
    /// This many copies, turned about the origin; the figure lies around the +u axis, within its sector.
    Ring(Box<Profile>, Vec<(f32, f32)>),
    /// Copies centred where lines of constant u cross lines of constant v, both ascending; the figure is symmetric
    /// about both of its axes.
    Grid(Box<Profile>, Vec<f32>, Vec<f32>),
}

/// An edge of a polygon from `start`, made ready for distances.
#[derive(Clone, Copy, Debug)]
pub struct Edge {
    start: Vec2,
    edge: Vec2,
    inverse_square: f32,
    slope: f32,
}

impl Edge {
    fn new(start: Vec2, end: Vec2) -> Self {
        let edge = end - start;
        Self { start, edge, inverse_square: 1.0 / edge.length_squared(), slope: edge.x / edge.y }
    }
}

impl Profile {
    /// A rectangle from corner to corner.
    pub fn rectangle(min: Vec2, max: Vec2) -> Self {
        Self::Rectangle((max - min) * 0.5).moved((max + min) * 0.5)
    }

    /// A polygon from its corners.
    pub fn polygon(corners: &[(f32, f32)]) -> Self {
        let corner = |i: usize| Vec2::from(corners[i % corners.len()]);
        Self::Polygon((0..corners.len()).map(|i| Edge::new(corner(i), corner(i + 1))).collect())
    }

    /// A polyline from its points, drawn `width` wide with round ends.
    pub fn stroke(points: &[(f32, f32)], width: f32) -> Self {
        Self::Stroke(points.iter().map(|&(u, v)| vec2(u, v)).collect(), width * 0.5)
    }

    /// An arched opening that stands on v = 0: `span` wide, straight up to `legs`, then an arch that rises by `rise`
    /// more: pointed where the rise is more than half the span, round where it is half of it.
    pub fn arch(span: f32, legs: f32, rise: f32) -> Self {
        let half_span = span * 0.5;
        Self::Arch { half_span, legs, radius: (rise * rise + half_span * half_span) / (2.0 * half_span) }
    }

    /// An arch whose legs go down without end: for mouldings and vaults.
    pub fn endless_arch(span: f32, rise: f32) -> Self {
        Self::arch(span, 1000.0, rise).moved(vec2(0.0, -1000.0))
    }

    /// `count` discs of `lobe` radius, their centres on a circle of radius `ring`, the first one upwards (+v): a
    /// trefoil, quatrefoil, …
    pub fn foil(count: u32, ring: f32, lobe: f32) -> Self {
        Self::Disc(lobe).moved(vec2(0.0, ring)).ring(count)
    }

    /// The union with another figure.
    pub fn and(self, other: Self) -> Self {
        match self {
            Self::Union(mut parts) => {
                parts.push(other);
                Self::Union(parts)
            }
            first => Self::Union(vec![first, other]),
        }
    }

    /// The difference, this figure without the other.
    pub fn minus(self, other: Self) -> Self {
        Self::Minus(Box::new((self, other)))
    }

    /// The intersection with another figure.
    pub fn within(self, other: Self) -> Self {
        Self::Both(Box::new((self, other)))
    }

    /// Offset outwards by `distance`, corners rounded.
    pub fn offset(self, distance: f32) -> Self {
        Self::Offset(Box::new(self), distance)
    }

    /// The outline alone, `width` wide.
    pub fn outline(self, width: f32) -> Self {
        Self::Outline(Box::new(self), width * 0.5)
    }

    /// Moved by `by`.
    pub fn moved(self, by: Vec2) -> Self {
        Self::Moved(Box::new(self), by)
    }

    /// Turned counter-clockwise (u to v) about the origin.
    pub fn turned(self, degrees: f32) -> Self {
        Self::Turned(Box::new(self), sin_cos_degrees(degrees))
    }

    /// Stretched along u by `factor` ≥ 1.
    pub fn stretched(self, factor: f32) -> Self {
        assert!(factor >= 1.0, "a stretch below 1 would break the distance");
        Self::Stretched(Box::new(self), factor)
    }

    /// The part with u ≥ 0 and its mirror image.
    pub fn mirrored(self) -> Self {
        Self::Mirrored(Box::new(self))
    }

    /// `count` copies turned about the origin by equal angles.
    pub fn ring(self, count: u32) -> Self {
        let turns = (0..count).map(|i| sin_cos_degrees(360.0 * i as f32 / count as f32)).collect();
        Self::Ring(Box::new(self), turns)
    }

    /// Copies of a figure that is symmetric about both of its axes (a window, a baluster), one centred at each (u, v);
    /// both lists ascend. One figure however many copies there are, where a union would be a primitive for each.
    pub fn grid(self, us: Vec<f32>, vs: Vec<f32>) -> Self {
        assert!(us.is_sorted() && vs.is_sorted(), "the lines of a grid ascend");
        Self::Grid(Box::new(self), us, vs)
    }

    /// Signed distance of a point from the border, negative inside.
    pub fn distance(&self, p: Vec2) -> f32 {
        match self {
            Self::Disc(radius) => p.length() - radius,
            Self::Rectangle(half) => box2(p.abs() - *half),
            Self::Below => p.y,
            Self::Octagon(half) => {
                let q = p.abs();
                q.x.max(q.y).max((q.x + q.y) * std::f32::consts::FRAC_1_SQRT_2) - half
            }
            Self::Polygon(edges) => polygon(edges, p),
            Self::Stroke(points, half_width) => {
                let square = points.windows(2).map(|edge| segment_square(p, edge[0], edge[1])).fold(f32::MAX, f32::min);
                square.sqrt() - half_width
            }
            &Self::Arch { half_span, legs, radius } => {
                let u = p.x.abs();
                let side =
                    if p.y < legs { u - half_span } else { vec2(u - half_span + radius, p.y - legs).length() - radius };
                side.max(-p.y)
            }
            Self::Union(parts) => parts.iter().map(|part| part.distance(p)).fold(f32::MAX, f32::min),
            Self::Minus(pair) => pair.0.distance(p).max(-pair.1.distance(p)),
            Self::Both(pair) => pair.0.distance(p).max(pair.1.distance(p)),
            Self::Offset(of, by) => of.distance(p) - by,
            Self::Outline(of, half_width) => of.distance(p).abs() - half_width,
            Self::Moved(of, by) => of.distance(p - *by),
            Self::Turned(of, turn) => of.distance(turn_back(p, *turn)),
            Self::Stretched(of, factor) => of.distance(vec2(p.x / factor, p.y)),
            Self::Mirrored(of) => of.distance(vec2(p.x.abs(), p.y)),
            Self::Ring(of, turns) => turns.iter().map(|&turn| of.distance(turn_back(p, turn))).fold(f32::MAX, f32::min),
            Self::Grid(of, us, vs) => match (nearest(us, p.x), nearest(vs, p.y)) {
                (Some(u), Some(v)) => of.distance(p - vec2(u, v)),
                _ => f32::MAX,
            },
        }
    }
}

/// The number nearest to `x` in an ascending list.
fn nearest(lines: &[f32], x: f32) -> Option<f32> {
    let next = lines.partition_point(|&line| line < x);
    let (below, above) = (next.checked_sub(1).map(|i| lines[i]), lines.get(next).copied());
    match (below, above) {
        (Some(below), Some(above)) => Some(if x - below < above - x { below } else { above }),
        _ => below.or(above),
    }
}

fn turn_back(p: Vec2, (sin, cos): (f32, f32)) -> Vec2 {
    vec2(p.x * cos + p.y * sin, p.y * cos - p.x * sin)
}

/// Distance from the quadrant u ≤ 0, v ≤ 0: with `q = |p| − half`, that of a rectangle.
#[inline]
pub(super) fn box2(q: Vec2) -> f32 {
    q.max(Vec2::ZERO).length() + q.x.max(q.y).min(0.0)
}

fn segment_square(p: Vec2, a: Vec2, b: Vec2) -> f32 {
    let (to_p, edge) = (p - a, b - a);
    let along = (to_p.dot(edge) / edge.length_squared()).clamp(0.0, 1.0);
    (to_p - edge * along).length_squared()
}

fn polygon(edges: &[Edge], p: Vec2) -> f32 {
    let (mut square, mut inside) = (f32::MAX, false);
    for edge in edges {
        let to_p = p - edge.start;
        let along = (to_p.dot(edge.edge) * edge.inverse_square).clamp(0.0, 1.0);
        square = square.min((to_p - edge.edge * along).length_squared());
        // Even-odd rule: count the edges that a ray towards +u crosses.
        inside ^= ((to_p.y < 0.0) != (to_p.y < edge.edge.y)) & (to_p.x < to_p.y * edge.slope);
    }
    if inside { -square.sqrt() } else { square.sqrt() }
}
