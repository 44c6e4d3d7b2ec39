//! What happens in the middle of a medium, as a model like those of surfaces: the phase function scatters whatever arrives from anywhere. Its
//! frame is world space.

use super::{Bsdf, BsdfEval, BsdfSample};
use crate::medium::phase;
use glam::Vec3;

/// A place in a medium.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Phase {
    /// Share of light that goes on, linear, each channel in [0, 1].
    pub albedo: Vec3,
    /// Mean cosine of the angles of scattering.
    pub anisotropy: f32,
}

impl Bsdf for Phase {
    #[inline]
    fn sample(&self, wo: Vec3, [u, v, _]: [f32; 3]) -> Option<BsdfSample> {
        let (wi, cos) = phase::sample(self.anisotropy, -wo, u, v);
        Some(BsdfSample { wi, weight: self.albedo, pdf: phase::pdf(self.anisotropy, cos), is_delta: false })
    }

    #[inline]
    fn eval(&self, wo: Vec3, wi: Vec3) -> BsdfEval {
        BsdfEval { weight: self.albedo, pdf: phase::pdf(self.anisotropy, (-wo).dot(wi)) }
    }

    #[inline]
    fn albedo(&self) -> Vec3 {
        self.albedo
    }
}
