//! Choosing a light that shines on a place, and the density with which it is chosen: the emissive voxels by their tree,
//! the sun by its disc. The gradient of the sky needs no choice: the cosine lobe of a surface samples it almost perfectly.

mod emitters;
mod sun;

use crate::packed::PackedScene;
use emitters::{find_emitter, importance_of_all, sample_emitter};
use glam::Vec3;
pub use sun::SunDisc;
use voxtrace_scene::ray::{Hit, Ray};

/// Largest f32 below 1.
const BELOW_ONE: f32 = 1.0 - f32::EPSILON / 2.0;

/// A place that light falls on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Receiver {
    /// Point, world space.
    pub point: Vec3,
    /// Unit normal of the surface, world space; light from below it does not count.
    pub normal: Vec3,
}

/// A chosen light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightSample {
    /// From the receiver to just before the light: where nothing lies on its segment, the light is seen. The length of
    /// its direction is not one.
    pub ray: Ray,
    /// Cosine between the receiver's normal and the ray, > 0.
    pub cos_theta: f32,
    /// Radiance that comes along the ray.
    pub radiance: Vec3,
    /// Density of the choice over solid angle at the receiver, > 0.
    pub pdf: f32,
}

/// The lights that can be chosen in a scene.
#[derive(Clone, Copy, Debug)]
pub struct Lights<'a> {
    scene: &'a PackedScene,
    sun: Option<SunDisc>,
}

impl<'a> Lights<'a> {
    /// The lights of a scene.
    pub fn new(scene: &'a PackedScene) -> Self {
        Self { scene, sun: SunDisc::new(&scene.sky) }
    }

    /// Chooses a light for `receiver` by `u`, each uniform in [0, 1): `u[0]` between sun and emitters and down the tree,
    /// `u[1]` within the leaf, `u[2]` and `u[3]` on the face or the disc. `None` where no light can be seen, and
    /// sometimes otherwise: then this choice counts as black.
    pub fn sample(&self, receiver: &Receiver, u: [f32; 4]) -> Option<LightSample> {
        let sun_probability = self.sun_probability(receiver);
        match &self.sun {
            Some(sun) if u[0] < sun_probability => {
                let sample = sun.sample(receiver, u[2], u[3])?;
                Some(LightSample { pdf: sample.pdf * sun_probability, ..sample })
            }
            _ => {
                let choice = ((u[0] - sun_probability) / (1.0 - sun_probability)).min(BELOW_ONE);
                let sample = sample_emitter(self.scene, receiver, [choice, u[1], u[2], u[3]])?;
                Some(LightSample { pdf: sample.pdf * (1.0 - sun_probability), ..sample })
            }
        }
    }

    /// Density with which [`Self::sample`] chooses the point of an emitter that `ray`, which starts at the receiver,
    /// met; 0 where it never does.
    pub fn emitter_pdf(&self, receiver: &Receiver, ray: &Ray, hit: &Hit) -> f32 {
        match find_emitter(self.scene, hit) {
            Some(emitter) => {
                emitters::emitter_pdf(self.scene, receiver, ray, hit, emitter) * (1.0 - self.sun_probability(receiver))
            }
            None => 0.0,
        }
    }

    /// Radiance of the sun from a unit direction, `None` beside the disc.
    pub fn sun(&self, direction: Vec3) -> Option<Vec3> {
        self.sun.filter(|sun| sun.contains(direction)).map(|sun| sun.radiance)
    }

    /// Density with which [`Self::sample`] chooses a direction of the sun's disc.
    pub fn sun_pdf(&self, receiver: &Receiver) -> f32 {
        self.sun.map_or(0.0, |sun| sun.pdf * self.sun_probability(receiver))
    }

    /// Probability of choosing the sun: its share in the irradiance, as far as the root of the tree tells, but never so
    /// small or large that the other could not make up for a bad guess.
    fn sun_probability(&self, receiver: &Receiver) -> f32 {
        let Some(sun) = &self.sun else { return 0.0 };
        let cos_theta = receiver.normal.dot(sun.direction);
        if cos_theta <= -sun.sin_radius {
            return 0.0;
        }
        let from_emitters = importance_of_all(self.scene, receiver);
        if from_emitters <= 0.0 {
            return 1.0;
        }
        let from_sun = sun.irradiance * cos_theta.max(0.0);
        (from_sun / (from_sun + from_emitters)).clamp(0.25, 0.75)
    }
}
