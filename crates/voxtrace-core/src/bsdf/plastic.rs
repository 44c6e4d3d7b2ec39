//! A diffuse surface under a clear coat. The coat reflects by its facets; what it lets through, on the way in and on the way out, the surface
//! below scatters. Light that the coat reflects back inside is left out.

use super::fresnel::fresnel_dielectric;
use super::microfacets::{Microfacets, above, reflect};
use super::{Bsdf, BsdfEval, BsdfSample};
use crate::math::{cosine_hemisphere, cosine_hemisphere_pdf, normalize};
use glam::Vec3;

/// A coated diffuse surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plastic {
    /// Share of light that the surface below scatters, linear, each channel in [0, 1].
    pub reflectance: Vec3,
    /// Share of the coat's reflections that counts, in [0, 1].
    pub specular: f32,
    /// Index of refraction of the coat over that of the medium outside.
    pub eta: f32,
    /// The coat's roughness.
    pub facets: Microfacets,
}

impl Plastic {
    /// Share of light that the coat reflects.
    #[inline]
    fn coat(&self, cos: f32) -> f32 {
        self.specular * fresnel_dielectric(cos, self.eta)
    }

    /// Probability of choosing the coat: by what it and the surface below send back.
    #[inline]
    fn coat_probability(&self, coat: f32) -> f32 {
        let below = (1.0 - coat) * self.reflectance.max_element();
        if coat <= 0.0 { 0.0 } else { coat / (coat + below) }
    }

    /// Both lobes, the coat's only where it is rough; the probability of the surface below is what is left.
    #[inline]
    fn eval_lobes(&self, wo: Vec3, wi: Vec3, coat: f32, coat_probability: f32) -> BsdfEval {
        let diffuse_pdf = cosine_hemisphere_pdf(wi.z);
        let mut pdf = (1.0 - coat_probability) * diffuse_pdf;
        let mut scattered = self.reflectance * ((1.0 - coat) * (1.0 - self.coat(wi.z)) * diffuse_pdf);
        if !self.facets.is_smooth() {
            let wm = normalize(wo + wi);
            let cos = wo.dot(wm);
            let facet_pdf = self.facets.visible_pdf(wo, wm) / (4.0 * cos);
            pdf += coat_probability * facet_pdf;
            scattered += Vec3::splat(self.coat(cos) * self.facets.shadowing(wo.z, wi.z) * facet_pdf);
        }
        if pdf > 0.0 { BsdfEval { weight: scattered * (1.0 / pdf), pdf } } else { BsdfEval::NONE }
    }
}

impl Bsdf for Plastic {
    #[inline]
    fn sample(&self, wo: Vec3, [u, v, lobe]: [f32; 3]) -> Option<BsdfSample> {
        let wo = above(wo);
        let coat = self.coat(wo.z);
        let coat_probability = self.coat_probability(coat);
        let is_coat = lobe < coat_probability;
        if is_coat && self.facets.is_smooth() {
            let weight = Vec3::splat(coat / coat_probability);
            return Some(BsdfSample { wi: Vec3::new(-wo.x, -wo.y, wo.z), weight, pdf: 1.0, is_delta: true });
        }
        let wi = if is_coat { reflect(wo, self.facets.sample_visible(wo, u, v)) } else { cosine_hemisphere(u, v) };
        if wi.z <= 0.0 {
            return None;
        }
        let eval = self.eval_lobes(wo, wi, coat, coat_probability);
        (eval.pdf > 0.0).then_some(BsdfSample { wi, weight: eval.weight, pdf: eval.pdf, is_delta: false })
    }

    #[inline]
    fn eval(&self, wo: Vec3, wi: Vec3) -> BsdfEval {
        if wi.z <= 0.0 {
            return BsdfEval::NONE;
        }
        let wo = above(wo);
        let coat = self.coat(wo.z);
        self.eval_lobes(wo, wi, coat, self.coat_probability(coat))
    }

    #[inline]
    fn albedo(&self) -> Vec3 {
        // Never 0: the coat reflects whatever lies below.
        self.reflectance.max(Vec3::splat(self.coat(1.0)))
    }
}
