//! The seam of materials: how a surface scatters light. A model is a file of this folder that implements [`Bsdf`], a variant of
//! [`MaterialBsdf`] and a twin in `shaders/`.
//!
//! Directions are unit vectors in the frame of the surface ([`crate::surface::Surface::local_direction`]): z is the outward normal, `wo` leads
//! back along the path and `wi` to where light comes from; both point away from the surface. Conventions and names are those of Pharr, Jakob and
//! Humphreys, "Physically Based Rendering" (4th edition, 2023), chapter 9.

mod conductor;
mod dielectric;
mod diffuse;
mod fresnel;
mod microfacets;
mod phase;
mod plastic;

use crate::packed::PackedMaterial;
pub use conductor::Conductor;
pub use dielectric::Dielectric;
pub use diffuse::Diffuse;
pub use fresnel::{fresnel_dielectric, fresnel_schlick, straight_reflectance};
use glam::Vec3;
pub use microfacets::Microfacets;
pub(crate) use microfacets::above;
pub use phase::Phase;
pub use plastic::Plastic;

/// A direction that a surface chose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BsdfSample {
    /// Where light comes from.
    pub wi: Vec3,
    /// f · |cos θ| over the density of the choice, per channel.
    pub weight: Vec3,
    /// Density of the choice over solid angle, > 0; without meaning where the direction is the only possible one.
    pub pdf: f32,
    /// Whether the direction is one of finitely many, as in a mirror: no other technique finds it.
    pub is_delta: bool,
}

/// What a surface makes of light from a given direction; delta directions do not count.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BsdfEval {
    /// f · |cos θ| over `pdf`, per channel: their product is what arrives. Estimators divide by densities anyway, and quotients of
    /// the two stay small where each is large.
    pub weight: Vec3,
    /// Density over solid angle with which [`Bsdf::sample`] chooses the direction, 0 where it never does: then nothing is scattered.
    pub pdf: f32,
}

impl BsdfEval {
    /// Nothing arrives.
    pub const NONE: Self = Self { weight: Vec3::ZERO, pdf: 0.0 };
}

/// How a surface scatters light.
pub trait Bsdf {
    /// Chooses where light comes from by `u`, each uniform in [0, 1): the first two the direction, the third among lobes. `None` where
    /// nothing is scattered. It finds every direction from which light is scattered.
    fn sample(&self, wo: Vec3, u: [f32; 3]) -> Option<BsdfSample>;

    /// What light from `wi` gives, and how likely [`Self::sample`] finds it.
    fn eval(&self, wo: Vec3, wi: Vec3) -> BsdfEval;

    /// Share of light that is scattered, all directions together, per channel: an estimate that is 0 only where nothing is.
    fn albedo(&self) -> Vec3;
}

/// The model that a path meets at a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MaterialBsdf {
    /// A matte surface.
    Diffuse(Diffuse),
    /// A metal.
    Conductor(Conductor),
    /// A matte surface under a clear coat.
    Plastic(Plastic),
    /// The boundary of a medium.
    Dielectric(Dielectric),
    /// The middle of a medium.
    Phase(Phase),
}

impl MaterialBsdf {
    /// The model of `material` for a path in a medium of index of refraction `ior`, 1 in air. Of a mixture one model is chosen by `choice`,
    /// uniform in [0, 1), which is as good as new afterwards: the mean over all choices is the mixture.
    #[inline]
    pub fn new(material: &PackedMaterial, ior: f32, choice: &mut f32) -> Self {
        let facets = Microfacets::of(material.roughness);
        if chooses(material.metallic, choice) {
            return Self::Conductor(Conductor { f0: material.base_color, facets });
        }
        if chooses(material.transmission, choice) {
            return Self::Dielectric(Dielectric { eta: material.ior / ior, facets });
        }
        if material.specular > 0.0 {
            let eta = material.ior / ior;
            return Self::Plastic(Plastic {
                reflectance: material.base_color,
                specular: material.specular,
                eta,
                facets,
            });
        }
        Self::Diffuse(Diffuse { reflectance: material.base_color })
    }

    /// The boundary where a path leaves a medium into air.
    #[inline]
    pub fn out_of(medium: &PackedMaterial) -> Self {
        Self::Dielectric(Dielectric { eta: 1.0 / medium.ior, facets: Microfacets::of(medium.roughness) })
    }

    /// The middle of a medium.
    #[inline]
    pub fn within(medium: &PackedMaterial) -> Self {
        Self::Phase(Phase { albedo: medium.base_color, anisotropy: medium.anisotropy })
    }

    /// Whether no direction but those that [`Bsdf::sample`] gives scatters light, so that it is in vain to choose a light.
    #[inline]
    pub fn is_delta(&self) -> bool {
        match self {
            Self::Diffuse(_) | Self::Plastic(_) | Self::Phase(_) => false,
            Self::Conductor(conductor) => conductor.facets.is_smooth(),
            Self::Dielectric(dielectric) => dielectric.facets.is_smooth(),
        }
    }
}

/// Share of light that `material` sends back or lets in, all directions together: what the AOV `albedo` shows.
pub fn albedo_of(material: &PackedMaterial) -> Vec3 {
    let specular = material.specular * fresnel_dielectric(1.0, material.ior);
    let below =
        if material.specular > 0.0 { material.base_color.max(Vec3::splat(specular)) } else { material.base_color };
    let transmitted = below + (Vec3::ONE - below) * material.transmission;
    transmitted + (material.base_color - transmitted) * material.metallic
}

/// Whether the first of two alternatives, of probability `share`, is chosen by `choice`, which becomes a new number.
#[inline]
fn chooses(share: f32, choice: &mut f32) -> bool {
    if share <= 0.0 {
        return false;
    }
    let is_chosen = *choice < share;
    *choice = if is_chosen { *choice / share } else { (*choice - share) / (1.0 - share) };
    is_chosen
}

impl Bsdf for MaterialBsdf {
    #[inline]
    fn sample(&self, wo: Vec3, u: [f32; 3]) -> Option<BsdfSample> {
        match self {
            Self::Diffuse(diffuse) => diffuse.sample(wo, u),
            Self::Conductor(conductor) => conductor.sample(wo, u),
            Self::Plastic(plastic) => plastic.sample(wo, u),
            Self::Dielectric(dielectric) => dielectric.sample(wo, u),
            Self::Phase(phase) => phase.sample(wo, u),
        }
    }

    #[inline]
    fn eval(&self, wo: Vec3, wi: Vec3) -> BsdfEval {
        match self {
            Self::Diffuse(diffuse) => diffuse.eval(wo, wi),
            Self::Conductor(conductor) => conductor.eval(wo, wi),
            Self::Plastic(plastic) => plastic.eval(wo, wi),
            Self::Dielectric(dielectric) => dielectric.eval(wo, wi),
            Self::Phase(phase) => phase.eval(wo, wi),
        }
    }

    #[inline]
    fn albedo(&self) -> Vec3 {
        match self {
            Self::Diffuse(diffuse) => diffuse.albedo(),
            Self::Conductor(conductor) => conductor.albedo(),
            Self::Plastic(plastic) => plastic.albedo(),
            Self::Dielectric(dielectric) => dielectric.albedo(),
            Self::Phase(phase) => phase.albedo(),
        }
    }
}
