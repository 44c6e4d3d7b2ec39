//! Cuts: only a part of a scene is shown, that within a convex region of half spaces, and what a plane cuts is shown filled. Nothing is
//! removed: rays are clipped to the region (`docs/decisions/0051-cuts.md`).

mod cast;
mod span;

use crate::surface::{MARGIN_MAX, MARGIN_MIN};
#[doc(hidden)]
pub use cast::{cast, cast_inside};
pub(crate) use cast::{cast_batch, occluded_batch};
use glam::Vec3;
pub(crate) use span::Span;
use voxtrace_scene::ray::{Hit, Ray};

/// Most planes of all cuts of a scene: six of a box, and six others.
pub const MAX_PLANES: usize = 12;

/// What [`plane_margin`] is where f32 is coarse, relative to the distance of the plane from the origin.
const PLANE_MARGIN_SCALE: f32 = 1.0 / 1_048_576.0;

/// A half space, world space: the points whose product with the normal is at most the offset.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    normal: Vec3,
    offset: f32,
}

/// Cuts that cannot be made.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum CutError {
    /// A normal of no or no finite length, or an offset that is not finite.
    #[error("a cut's plane needs a normal of some length and finite numbers")]
    NoPlane,
    /// A box that ends before it begins.
    #[error("a cut's box needs a lowest corner that is below its highest one along every axis")]
    EmptyBox,
    /// More planes than tracers take.
    #[error("a scene is cut by at most {MAX_PLANES} planes, of which a box takes six and a slice two")]
    TooManyPlanes,
}

impl Plane {
    /// The points p, world space, with `normal` · p ≤ `offset`. The normal points to what is cut away; its length does not matter.
    ///
    /// # Errors
    /// [`CutError::NoPlane`] where the numbers say no plane.
    pub fn new(normal: Vec3, offset: f32) -> Result<Self, CutError> {
        let length = normal.length();
        if !(length.is_finite() && length >= f32::MIN_POSITIVE && offset.is_finite()) {
            return Err(CutError::NoPlane);
        }
        let plane = Self { normal: normal / length, offset: offset / length };
        let is_sound = plane.offset.is_finite() && plane.normal.is_finite();
        if is_sound { Ok(plane) } else { Err(CutError::NoPlane) }
    }

    /// The unit normal, which points to what is cut away.
    pub fn normal(&self) -> Vec3 {
        self.normal
    }

    /// Distance of the plane from the origin, along the normal.
    pub fn offset(&self) -> f32 {
        self.offset
    }

    /// The offset at which the plane cuts: a little before its own, so that a plane between two layers of voxels shows those that are
    /// kept, and not by chance the others.
    #[doc(hidden)]
    pub fn edge(&self) -> f32 {
        self.offset - 2.0 * plane_margin(self.offset)
    }
}

/// How far before a plane of this offset the rays that leave it begin, world units: 1/1024, and more where f32 is coarser.
#[inline]
pub(crate) fn plane_margin(offset: f32) -> f32 {
    (offset.abs() * PLANE_MARGIN_SCALE).clamp(MARGIN_MIN, MARGIN_MAX)
}

/// What of a scene is shown: the points that lie within all its planes. Without planes that is everything.
///
/// What is cut away is gone for light, too, unless [`Self::shadows`] asks for the light of the whole scene.
///
/// ```
/// use voxtrace_core::cuts::Cuts;
/// use voxtrace_scene::glam::Vec3;
///
/// // A slice of ten voxels, open above a tilted plane.
/// let cuts = Cuts::default()
///     .slice(1, 40.0, 50.0)?
///     .plane(Vec3::new(0.0, 0.6, 0.8), 64.0)?;
/// assert_eq!(cuts.planes().len(), 3);
/// # Ok::<(), voxtrace_core::cuts::CutError>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Cuts {
    planes: Vec<Plane>,
    casts_shadows: bool,
}

impl Cuts {
    /// Keeps also only the points p with `normal` · p ≤ `offset`, world space.
    ///
    /// # Errors
    /// [`CutError::NoPlane`] where the numbers say no plane, [`CutError::TooManyPlanes`] beyond [`MAX_PLANES`].
    pub fn plane(mut self, normal: Vec3, offset: f32) -> Result<Self, CutError> {
        if self.planes.len() == MAX_PLANES {
            return Err(CutError::TooManyPlanes);
        }
        self.planes.push(Plane::new(normal, offset)?);
        Ok(self)
    }

    /// Keeps also only the points between two planes across an axis (0 is x, 1 is y, 2 is z).
    ///
    /// # Errors
    /// As [`Self::plane`]; [`CutError::EmptyBox`] where `from` is not below `to`, [`CutError::NoPlane`] for an axis beyond 2.
    pub fn slice(self, axis: usize, from: f32, to: f32) -> Result<Self, CutError> {
        let normal = *Vec3::AXES.get(axis).ok_or(CutError::NoPlane)?;
        if from >= to {
            return Err(CutError::EmptyBox);
        }
        self.plane(-normal, -from)?.plane(normal, to)
    }

    /// Keeps also only the points of a box along the axes.
    ///
    /// # Errors
    /// As [`Self::slice`].
    pub fn clip_box(self, min: Vec3, max: Vec3) -> Result<Self, CutError> {
        (0..3).try_fold(self, |cuts, axis| cuts.slice(axis, min[axis], max[axis]))
    }

    /// Cuts as files hold them: planes of unit normals, and whether what is cut away casts shadows.
    ///
    /// # Errors
    /// [`CutError`] where these are no such planes, or too many.
    #[doc(hidden)]
    pub fn from_parts(planes: &[(Vec3, f32)], casts_shadows: bool) -> Result<Self, CutError> {
        if planes.len() > MAX_PLANES {
            return Err(CutError::TooManyPlanes);
        }
        let plane = |&(normal, offset): &(Vec3, f32)| {
            let is_sound = (normal.length() - 1.0).abs() < 1e-3 && offset.is_finite();
            is_sound.then_some(Plane { normal, offset }).ok_or(CutError::NoPlane)
        };
        Ok(Self { planes: planes.iter().map(plane).collect::<Result<_, _>>()?, casts_shadows })
    }

    /// Whether the light is that of the whole scene: what is cut away still casts shadows, shines and sends light back, and only the camera,
    /// and the faces of the cuts, look through it.
    #[must_use]
    pub fn shadows(mut self, shadows: bool) -> Self {
        self.casts_shadows = shadows;
        self
    }

    /// The planes, in the order in which they were added.
    pub fn planes(&self) -> &[Plane] {
        &self.planes
    }

    /// Whether what is cut away takes part in the light.
    pub fn casts_shadows(&self) -> bool {
        self.casts_shadows
    }

    /// Whether everything is shown.
    #[inline]
    pub fn is_none(&self) -> bool {
        self.planes.is_empty()
    }

    /// Whether a point, world space, is within all planes. Twin of `is_kept` in `shaders/cuts.slang`.
    #[inline]
    pub fn keeps(&self, point: Vec3) -> bool {
        self.planes.iter().all(|plane| plane.normal.dot(point) <= plane.edge())
    }

    /// Whether some plane cuts all of a box away, world space.
    pub fn cut_away(&self, (min, max): (Vec3, Vec3)) -> bool {
        // The corner that lies farthest within the plane.
        let within = |normal: Vec3| Vec3::select(normal.cmpgt(Vec3::ZERO), min, max);
        self.planes.iter().any(|plane| plane.normal.dot(within(plane.normal)) > plane.edge())
    }

    /// Whether the rays that leave a hit see no more than what is kept: all, unless the light is that of the whole scene; then those of the
    /// faces of cuts, which lie within what is cut away.
    #[inline]
    pub(crate) fn clips_after(&self, hit: &Hit) -> bool {
        !self.casts_shadows || hit.cut().is_some()
    }

    /// Whether a light that was chosen by a ray can be there: one at the ray's end must be kept.
    #[inline]
    pub(crate) fn admits(&self, ray: &Ray, is_clipped: bool) -> bool {
        !is_clipped || ray.t_max == f32::INFINITY || self.keeps(ray.at(ray.t_max))
    }

    /// The unit normal of the face of a cut, towards where a ray came from: away from what is kept where it entered, else into it.
    pub(crate) fn normal(&self, hit: &Hit) -> Option<Vec3> {
        let normal = self.planes.get(hit.cut()?)?.normal;
        Some(if hit.leaves_cut() { -normal } else { normal })
    }

    /// How far before the face of a cut rays begin.
    pub(crate) fn margin(&self, hit: &Hit) -> f32 {
        let plane = hit.cut().and_then(|index| self.planes.get(index));
        plane.map_or(0.0, |plane| plane_margin(plane.edge()))
    }
}

#[cfg(test)]
mod tests;
