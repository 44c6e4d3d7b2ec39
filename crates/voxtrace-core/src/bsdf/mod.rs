//! The seam of materials: how a surface scatters light. A model is a file of this folder that implements [`Bsdf`], a variant of
//! [`MaterialBsdf`] and a twin in `shaders/`.
//!
//! Directions are unit vectors in the frame of the surface ([`crate::surface::Surface::local_direction`]): z is the outward normal, `wo` leads
//! back along the path and `wi` to where light comes from; both point away from the surface. Conventions and names are those of Pharr, Jakob and
//! Humphreys, "Physically Based Rendering" (4th edition, 2023), chapter 9.

mod diffuse;

use crate::packed::PackedMaterial;
pub use diffuse::Diffuse;
use glam::Vec3;

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

/// The model of a material of a scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MaterialBsdf {
    /// All materials shade as diffuse.
    Diffuse(Diffuse),
}

impl MaterialBsdf {
    /// The model that `material` asks for.
    #[inline]
    pub fn new(material: &PackedMaterial) -> Self {
        Self::Diffuse(Diffuse { reflectance: material.base_color })
    }
}

impl Bsdf for MaterialBsdf {
    #[inline]
    fn sample(&self, wo: Vec3, u: [f32; 3]) -> Option<BsdfSample> {
        match self {
            Self::Diffuse(diffuse) => diffuse.sample(wo, u),
        }
    }

    #[inline]
    fn eval(&self, wo: Vec3, wi: Vec3) -> BsdfEval {
        match self {
            Self::Diffuse(diffuse) => diffuse.eval(wo, wi),
        }
    }

    #[inline]
    fn albedo(&self) -> Vec3 {
        match self {
            Self::Diffuse(diffuse) => diffuse.albedo(),
        }
    }
}
