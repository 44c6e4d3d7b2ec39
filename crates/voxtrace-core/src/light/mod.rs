//! Choosing a light that shines on a place, and the density with which it is chosen. Each technique has `sample`, `pdf` and `le`: emissive
//! voxels by their tree ([`EmitterTree`]), and what shines from infinitely far away ([`DistantLight`]): the sun by its disc, the sky.
//! [`Lights`] chooses among them.

mod emitters;
pub(crate) mod many;
mod sky;
mod sun;

use crate::light_group::LightGroup;
use crate::packed::PackedScene;
pub use emitters::{EmitterTree, emitted};
use glam::Vec3;
pub use sky::irradiance_of;
pub use sun::SunDisc;
use voxtrace_scene::ray::{Hit, Ray};
use voxtrace_scene::sky::Sky;

/// Largest f32 below 1.
pub const BELOW_ONE: f32 = 1.0 - f32::EPSILON / 2.0;

/// A place that light falls on.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Receiver {
    /// Point, world space.
    pub point: Vec3,
    /// Unit normal of the surface, world space; light from below it does not count. 0 in a medium.
    pub normal: Vec3,
    /// Added to cosines with the normal: 0 at a surface, [`Self::ALL_AROUND`] in a medium, where light counts from all sides.
    pub slack: f32,
}

impl Receiver {
    /// More than any cosine, any distance and any product of them in a scene.
    pub const ALL_AROUND: f32 = 1e30;

    /// A place on a surface.
    #[inline]
    pub fn on_surface(point: Vec3, normal: Vec3) -> Self {
        Self { point, normal, slack: 0.0 }
    }

    /// A place in a medium.
    #[inline]
    pub fn in_medium(point: Vec3) -> Self {
        Self { point, normal: Vec3::ZERO, slack: Self::ALL_AROUND }
    }
}

/// A chosen light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightSample {
    /// From the receiver to just before the light: where nothing lies on its segment, the light is seen. The length of
    /// its direction is not one.
    pub ray: Ray,
    /// Cosine between the receiver's normal and the ray, > 0; without meaning in a medium.
    pub cos_theta: f32,
    /// Radiance that comes along the ray.
    pub radiance: Vec3,
    /// Density of the choice over solid angle at the receiver, > 0.
    pub pdf: f32,
}

/// Light from infinitely far away, the same at every place.
pub trait DistantLight {
    /// Chooses a direction for `receiver` by `u`, each uniform in [0, 1): the first two say which part of the light, the others where in it. `None`
    /// where it is below the receiver's horizon, and where this light is never chosen.
    fn sample(&self, receiver: &Receiver, u: [f32; 4]) -> Option<LightSample>;

    /// Density over solid angle with which [`Self::sample`] chooses a unit direction; 0 where it never does.
    fn pdf(&self, direction: Vec3) -> f32;

    /// Radiance from a unit direction.
    fn le(&self, direction: Vec3) -> Vec3;
}

/// The lights of a scene.
#[derive(Clone, Copy, Debug)]
pub struct Lights<'a> {
    /// Emissive voxels.
    pub emitters: EmitterTree<'a>,
    /// The sun, where there is one that shines.
    pub sun: Option<SunDisc>,
    /// The sky without its sun.
    pub sky: &'a Sky,
    /// As [`irradiance_of`] says.
    pub sky_irradiance: f32,
}

/// Probabilities with which the techniques are chosen; their sum is one. Of skies only environment maps are ever chosen.
struct Selection {
    sun: f32,
    sky: f32,
    emitters: f32,
}

/// A technique that was chosen with probability `pdf`, and what is left of the random number for it.
enum Technique<'a> {
    Sun { sun: &'a SunDisc, pdf: f32 },
    Sky { choice: f32, pdf: f32 },
    Emitters { choice: f32, pdf: f32 },
}

impl<'a> Lights<'a> {
    /// The lights of a scene.
    pub fn new(scene: &'a PackedScene) -> Self {
        let sky = &scene.sky;
        let emitters = EmitterTree { scene, intensity: scene.light_intensity };
        Self { emitters, sun: SunDisc::new(sky), sky, sky_irradiance: irradiance_of(sky) }
    }

    /// The same lights, chosen in the same way, of which those of `group` alone shine; `sky` is what [`LightGroup::sky`] says.
    pub(crate) fn of_group(self, group: LightGroup, sky: &'a Sky) -> Self {
        let intensity = if group.has(LightGroup::Emitters) { self.emitters.intensity } else { 0.0 };
        let shining = |sun: SunDisc| {
            let radiance = if group.has(LightGroup::Sun) { sun.radiance } else { Vec3::ZERO };
            SunDisc { radiance, ..sun }
        };
        Self { emitters: EmitterTree { intensity, ..self.emitters }, sun: self.sun.map(shining), sky, ..self }
    }

    /// Chooses a light for `receiver` by `u`, each uniform in [0, 1): `u[0]` between sun, sky and emitters and down the tree,
    /// `u[1]` within the node, `u[2]` and `u[3]` on the face or the disc; the sky takes all four. `None` where no light can be seen, and
    /// sometimes otherwise: then this choice counts as black.
    pub fn sample(&self, receiver: &Receiver, u: [f32; 4]) -> Option<LightSample> {
        self.sample_by(self.technique(receiver, u[0]), receiver, u)
    }

    /// As [`Self::sample`], once the technique is chosen.
    #[inline]
    fn sample_by(&self, technique: Technique, receiver: &Receiver, u: [f32; 4]) -> Option<LightSample> {
        let (sample, pdf) = match technique {
            Technique::Sun { sun, pdf } => (sun.sample(receiver, u)?, pdf),
            Technique::Sky { choice, pdf } => (self.sky.sample(receiver, [choice, u[1], u[2], u[3]])?, pdf),
            Technique::Emitters { choice, pdf } => (self.emitters.sample(receiver, [choice, u[1], u[2], u[3]])?, pdf),
        };
        Some(LightSample { pdf: sample.pdf * pdf, ..sample })
    }

    /// Chooses the technique by `u`, uniform in [0, 1).
    #[inline]
    fn technique(&self, receiver: &Receiver, u: f32) -> Technique<'_> {
        let selection = self.selection(receiver);
        match &self.sun {
            Some(sun) if u < selection.sun => Technique::Sun { sun, pdf: selection.sun },
            _ if u < selection.sun + selection.sky => {
                let choice = ((u - selection.sun) / selection.sky).min(BELOW_ONE);
                Technique::Sky { choice, pdf: selection.sky }
            }
            _ => {
                let choice = ((u - (selection.sun + selection.sky)) / selection.emitters).min(BELOW_ONE);
                Technique::Emitters { choice, pdf: selection.emitters }
            }
        }
    }

    /// Density with which [`Self::sample`] chooses the point of an emitter that `ray`, which starts at the receiver,
    /// met; 0 where it never does.
    pub fn emitter_pdf(&self, receiver: &Receiver, ray: &Ray, hit: &Hit) -> f32 {
        let pdf = self.emitters.pdf(receiver, ray, hit);
        if pdf > 0.0 { pdf * self.selection(receiver).emitters } else { 0.0 }
    }

    /// Density with which [`Self::sample`] chooses a unit direction of the sun's disc; 0 beside it.
    pub fn sun_pdf(&self, receiver: &Receiver, direction: Vec3) -> f32 {
        self.sun.map_or(0.0, |sun| sun.pdf(direction) * self.selection(receiver).sun)
    }

    /// Density with which [`Self::sample`] chooses a unit direction as one of the sky.
    pub fn sky_pdf(&self, receiver: &Receiver, direction: Vec3) -> f32 {
        if self.sky_irradiance > 0.0 { self.sky.pdf(direction) * self.selection(receiver).sky } else { 0.0 }
    }

    /// How the technique is chosen: each by its share in the irradiance, as far as the root of the tree and the mean of the sky tell, but
    /// never with so small or large a probability that the others could not make up for a bad guess.
    fn selection(&self, receiver: &Receiver) -> Selection {
        let sun = self.sun_probability(receiver);
        let sky = self.sky_probability(receiver);
        Selection { sun: sun * (1.0 - sky), sky, emitters: (1.0 - sun) * (1.0 - sky) }
    }

    /// The sky's part of the selection.
    fn sky_probability(&self, receiver: &Receiver) -> f32 {
        if self.sky_irradiance <= 0.0 {
            return 0.0;
        }
        let of_sun = |sun: &SunDisc| sun.irradiance * sun_cosine(sun, receiver).max(0.0);
        let from_others = self.sun.as_ref().map_or(0.0, of_sun) + self.emitters.importance(receiver);
        if from_others <= 0.0 {
            return 1.0;
        }
        (self.sky_irradiance / (self.sky_irradiance + from_others)).clamp(0.25, 0.75)
    }

    /// The sun's part of what the sky leaves.
    fn sun_probability(&self, receiver: &Receiver) -> f32 {
        let Some(sun) = &self.sun else { return 0.0 };
        let cos_theta = sun_cosine(sun, receiver);
        if cos_theta <= -sun.sin_radius {
            return 0.0;
        }
        let from_emitters = self.emitters.importance(receiver);
        if from_emitters <= 0.0 {
            return 1.0;
        }
        let from_sun = sun.irradiance * cos_theta.max(0.0);
        (from_sun / (from_sun + from_emitters)).clamp(0.25, 0.75)
    }
}

/// Cosine with the direction of the sun. In a medium it counts from wherever it stands.
fn sun_cosine(sun: &SunDisc, receiver: &Receiver) -> f32 {
    if receiver.slack > 0.0 { 1.0 } else { receiver.normal.dot(sun.direction) }
}
