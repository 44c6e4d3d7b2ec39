//! Metals: light is reflected by facets or not at all. Light that meets several facets is lost, so rough metals are a little too dark.

use super::fresnel::fresnel_schlick;
use super::microfacets::{Microfacets, above, reflect};
use super::{Bsdf, BsdfEval, BsdfSample};
use crate::math::normalize;
use glam::Vec3;

/// A metal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Conductor {
    /// Reflectance at normal incidence, linear, each channel in [0, 1].
    pub f0: Vec3,
    /// Its roughness.
    pub facets: Microfacets,
}

impl Bsdf for Conductor {
    #[inline]
    fn sample(&self, wo: Vec3, [u, v, _]: [f32; 3]) -> Option<BsdfSample> {
        let wo = above(wo);
        if self.facets.is_smooth() {
            let wi = Vec3::new(-wo.x, -wo.y, wo.z);
            return Some(BsdfSample { wi, weight: fresnel_schlick(wo.z, self.f0), pdf: 1.0, is_delta: true });
        }
        let wm = self.facets.sample_visible(wo, u, v);
        let wi = reflect(wo, wm);
        if wi.z <= 0.0 {
            return None;
        }
        let cos = wo.dot(wm);
        let weight = fresnel_schlick(cos, self.f0) * self.facets.shadowing(wo.z, wi.z);
        Some(BsdfSample { wi, weight, pdf: self.facets.visible_pdf(wo, wm) / (4.0 * cos), is_delta: false })
    }

    #[inline]
    fn eval(&self, wo: Vec3, wi: Vec3) -> BsdfEval {
        if self.facets.is_smooth() || wi.z <= 0.0 {
            return BsdfEval::NONE;
        }
        let wo = above(wo);
        let wm = normalize(wo + wi);
        let cos = wo.dot(wm);
        let weight = fresnel_schlick(cos, self.f0) * self.facets.shadowing(wo.z, wi.z);
        BsdfEval { weight, pdf: self.facets.visible_pdf(wo, wm) / (4.0 * cos) }
    }

    #[inline]
    fn albedo(&self) -> Vec3 {
        self.f0
    }
}
