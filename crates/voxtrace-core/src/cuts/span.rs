//! The part of a ray within the region that cuts keep. Twin of `shaders/cuts.slang`.

use super::Cuts;
use crate::medium::Inside;
use voxtrace_scene::ray::{Hit, Ray};

/// No plane.
const NO_PLANE: u32 = u32::MAX;

/// Where a ray is within what is kept, and the planes at which it comes and goes. Empty where it ends before it begins.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Span {
    /// First t.
    pub t_in: f32,
    /// Last t.
    pub t_out: f32,
    plane_in: u32,
    plane_out: u32,
}

impl Span {
    /// The whole ray.
    #[inline]
    pub fn whole(ray: &Ray) -> Self {
        Self { t_in: ray.t_min, t_out: ray.t_max, plane_in: NO_PLANE, plane_out: NO_PLANE }
    }

    /// The part of the ray.
    #[inline]
    pub fn part(&self, ray: &Ray) -> Ray {
        Ray { t_min: self.t_in, t_max: self.t_out, ..*ray }
    }

    /// The ray up to the end of the part: in media it begins where it is.
    #[inline]
    pub fn up_to_its_end(&self, ray: &Ray) -> Ray {
        Ray { t_max: ray.t_max.min(self.t_out), ..*ray }
    }

    /// What the ray met whose part met `hit`: a voxel in which the part begins is cut there.
    #[inline]
    pub fn entered(&self, hit: Hit) -> Hit {
        if !hit.is_miss() && self.plane_in != NO_PLANE && hit.t <= self.t_in {
            return Hit { face: Hit::FIRST_CUT + 2 * self.plane_in, ..hit };
        }
        hit
    }

    /// What a ray, from `t_min` to `t_max`, met in a medium whose part met `hit`: where it goes on beyond the part, the medium is cut there.
    #[inline]
    pub fn left(&self, hit: Hit, t_min: f32, t_max: f32, inside: &Inside) -> Hit {
        if hit.is_miss() && self.plane_out != NO_PLANE && self.t_out < t_max {
            let t = if self.t_out > t_min { self.t_out } else { t_min };
            return Hit {
                t,
                instance: inside.instance,
                voxel: hit.voxel,
                face: Hit::FIRST_CUT + 2 * self.plane_out + 1,
            };
        }
        hit
    }
}

impl Cuts {
    /// The part of a ray that is kept.
    #[inline]
    pub(crate) fn span(&self, ray: &Ray) -> Span {
        let mut span = Span::whole(ray);
        for (index, plane) in self.planes.iter().enumerate() {
            let along = plane.normal.dot(ray.direction);
            let ahead = plane.edge() - plane.normal.dot(ray.origin);
            // Devices may flush smaller numbers to zero.
            if along.abs() < f32::MIN_POSITIVE {
                if ahead < 0.0 {
                    span.t_out = -1.0;
                }
                continue;
            }
            let t = ahead / along;
            if along < 0.0 {
                if t > span.t_in {
                    (span.t_in, span.plane_in) = (t, index as u32);
                }
            } else if t < span.t_out {
                (span.t_out, span.plane_out) = (t, index as u32);
            }
        }
        span
    }

    /// As [`Self::span`] where the ray `is_clipped`, else the whole ray.
    #[inline]
    pub(crate) fn span_of(&self, ray: &Ray, is_clipped: bool) -> Span {
        if is_clipped { self.span(ray) } else { Span::whole(ray) }
    }
}
