//! Rough boundaries as tiny mirrors whose normals are spread by the GGX distribution (Walter, Marschner, Li and Torrance, "Microfacet Models for
//! Refraction through Rough Surfaces", EGSR 2007), shadowed as Smith has it with heights correlated (Heitz, "Understanding the Masking-Shadowing
//! Function", JCGT 3(2), 2014).

use crate::math::{normalize, sincos_turns};
use glam::Vec3;
use std::f32::consts::PI;

/// Below this α a boundary is smooth: its peak would be too narrow for f32.
const SMOOTH_ALPHA: f32 = 0.01;
/// Least cosine of a direction that a boundary is seen from.
const MIN_COS: f32 = 1e-4;

/// The normals of a rough boundary.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Microfacets {
    /// Spread of their slopes, in (0, 1].
    pub alpha: f32,
}

impl Microfacets {
    /// Those of a material of some roughness in [0, 1]: α is its square, as in glTF.
    #[inline]
    pub fn of(roughness: f32) -> Self {
        Self { alpha: roughness * roughness }
    }

    /// Whether the boundary is a plane mirror.
    #[inline]
    pub fn is_smooth(&self) -> bool {
        self.alpha < SMOOTH_ALPHA
    }

    /// Share of the boundary's area whose normals look along `wm`, per solid angle.
    #[inline]
    fn distribution(&self, wm: Vec3) -> f32 {
        let alpha_squared = self.alpha * self.alpha;
        let base = alpha_squared * (wm.z * wm.z) + (wm.x * wm.x + wm.y * wm.y);
        alpha_squared / (PI * (base * base))
    }

    /// 1 + 2 Λ of a direction, times its cosine.
    #[inline]
    fn masking(&self, cos: f32) -> f32 {
        let alpha_squared = self.alpha * self.alpha;
        (alpha_squared + (1.0 - alpha_squared) * (cos * cos)).sqrt()
    }

    /// Share of the facets that `wo` sees of which light reaches the other side, too: G₂ / G₁. Both cosines > 0.
    #[inline]
    pub fn shadowing(&self, cos_o: f32, cos_i: f32) -> f32 {
        let (of_o, of_i) = (self.masking(cos_o), self.masking(cos_i));
        cos_i * (cos_o + of_o) / (cos_i * of_o + cos_o * of_i)
    }

    /// Density over solid angle of the normals that `wo` sees.
    #[inline]
    pub fn visible_pdf(&self, wo: Vec3, wm: Vec3) -> f32 {
        2.0 * wo.dot(wm).max(0.0) * self.distribution(wm) / (wo.z + self.masking(wo.z))
    }

    /// A normal that `wo` sees (Dupuy and Benyoub, "Sampling Visible GGX Normals with Spherical Caps", HPG 2023).
    #[inline]
    pub fn sample_visible(&self, wo: Vec3, u: f32, v: f32) -> Vec3 {
        let stretched = normalize(Vec3::new(self.alpha * wo.x, self.alpha * wo.y, wo.z));
        let (sin, cos) = sincos_turns(u);
        let z = (1.0 - v) * (1.0 + stretched.z) - stretched.z;
        let radius = (1.0 - z * z).max(0.0).sqrt();
        let normal = Vec3::new(radius * cos, radius * sin, z) + stretched;
        normalize(Vec3::new(self.alpha * normal.x, self.alpha * normal.y, normal.z.max(1e-7)))
    }
}

/// The direction from which a boundary is seen: never along it.
#[inline]
pub fn above(wo: Vec3) -> Vec3 {
    Vec3::new(wo.x, wo.y, wo.z.max(MIN_COS))
}

/// `wo` reflected by a facet.
#[inline]
pub fn reflect(wo: Vec3, wm: Vec3) -> Vec3 {
    wm * (2.0 * wo.dot(wm)) - wo
}
