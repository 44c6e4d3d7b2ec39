//! The boundary of two transparent media (Walter et al. 2007): light is reflected or refracted by facets, each with the probability that
//! Fresnel's equations give. Paths carry radiance over the squared index of refraction, which refraction does not change.

use super::fresnel::{fresnel_dielectric, refracted_cosine};
use super::microfacets::{Microfacets, above, reflect};
use super::{Bsdf, BsdfEval, BsdfSample};
use crate::math::normalize;
use glam::Vec3;

/// A boundary; `wo` is on its near side, and directions with z < 0 lead to the far one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dielectric {
    /// Index of refraction of the far side over that of the near one, not 1.
    pub eta: f32,
    /// Its roughness.
    pub facets: Microfacets,
}

impl Bsdf for Dielectric {
    #[inline]
    fn sample(&self, wo: Vec3, [u, v, lobe]: [f32; 3]) -> Option<BsdfSample> {
        let wo = above(wo);
        let is_smooth = self.facets.is_smooth();
        let wm = if is_smooth { Vec3::Z } else { self.facets.sample_visible(wo, u, v) };
        let cos = wo.dot(wm);
        let reflectance = fresnel_dielectric(cos, self.eta);
        let is_reflected = lobe < reflectance;
        let wi = if is_reflected {
            reflect(wo, wm)
        } else {
            let scale = 1.0 / self.eta;
            wm * (cos * scale - refracted_cosine(cos, self.eta)?) - wo * scale
        };
        if is_smooth {
            return Some(BsdfSample { wi, weight: Vec3::ONE, pdf: 1.0, is_delta: true });
        }
        // A facet that sends light to the wrong side of the whole.
        if (wi.z > 0.0) != is_reflected || wi.z == 0.0 {
            return None;
        }
        let weight = Vec3::splat(self.facets.shadowing(wo.z, wi.z.abs()));
        let pdf = reflectance * self.facets.visible_pdf(wo, wm) / (4.0 * cos);
        // Nobody chooses a light behind the boundary: what is refracted counts as the only way to get there.
        Some(BsdfSample { wi, weight, pdf: if is_reflected { pdf } else { 1.0 }, is_delta: !is_reflected })
    }

    /// Of what is reflected.
    #[inline]
    fn eval(&self, wo: Vec3, wi: Vec3) -> BsdfEval {
        if self.facets.is_smooth() || wi.z <= 0.0 {
            return BsdfEval::NONE;
        }
        let wo = above(wo);
        let wm = normalize(wo + wi);
        let cos = wo.dot(wm);
        let pdf = fresnel_dielectric(cos, self.eta) * self.facets.visible_pdf(wo, wm) / (4.0 * cos);
        BsdfEval { weight: Vec3::splat(self.facets.shadowing(wo.z, wi.z)), pdf }
    }

    #[inline]
    fn albedo(&self) -> Vec3 {
        Vec3::ONE
    }
}
