//! Lambert's law: the surface looks equally bright from everywhere.

use super::{Bsdf, BsdfEval, BsdfSample};
use crate::math::{cosine_hemisphere, cosine_hemisphere_pdf};
use glam::Vec3;

/// A diffuse surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Diffuse {
    /// Share of light that is scattered, linear, each channel in [0, 1].
    pub reflectance: Vec3,
}

impl Bsdf for Diffuse {
    #[inline]
    fn sample(&self, _wo: Vec3, [u, v, _]: [f32; 3]) -> Option<BsdfSample> {
        let wi = cosine_hemisphere(u, v);
        // The reflectance over π times the cosine is the reflectance times the density.
        Some(BsdfSample { wi, weight: self.reflectance, pdf: cosine_hemisphere_pdf(wi.z), is_delta: false })
    }

    #[inline]
    fn eval(&self, _wo: Vec3, wi: Vec3) -> BsdfEval {
        BsdfEval { weight: self.reflectance, pdf: cosine_hemisphere_pdf(wi.z) }
    }

    #[inline]
    fn albedo(&self) -> Vec3 {
        self.reflectance
    }
}
