//! What one changes about the picture beside the camera: how it is traced, light, exposure. All of it is also an option of
//! `voxtrace render`.

use crate::cutting::Cutting;
use crate::render_command::{SkySetting, SunSetting, usual_bounces};
use crate::skies::MadeSky;
use crate::surroundings::Surroundings;
use voxtrace::lines::Lines;
use voxtrace::output::ToneMap;
use voxtrace::sky::{Background, Environment};
use voxtrace::{BounceLimits, Integrator, PackedScene};
use voxtrace_vulkan::{Primitive, Traversal};

/// How the picture is made.
#[derive(Clone, Debug, PartialEq)]
pub struct RenderSettings {
    /// How rays find voxels.
    pub traversal: Traversal,
    /// What ray tracing hardware sees.
    pub primitive: Primitive,
    /// Whether the driver may round as it likes.
    pub fast: bool,
    /// How light is computed.
    pub integrator: Integrator,
    /// Most surfaces that scatter a path.
    pub max_bounces: u32,
    /// Most of them by kind.
    pub bounce_limits: BounceLimits,
    /// Most radiance that a bounce adds of indirect light, if that is clamped: above 0.
    pub clamp_indirect: Option<f32>,
    /// Whether light passes clear glass straight.
    pub clear_shadows: bool,
    /// Lines on the faces of voxels, which `path` draws.
    pub lines: Lines,
    /// Samples of each pixel after which the picture is done.
    pub samples: u32,
    /// Exposure and curve.
    pub tone_map: ToneMap,
    /// Factor on the sky; `None`: the scene's.
    pub sky_brightness: Option<f32>,
    /// Factor on everything that glows; `None`: the scene's.
    pub light_intensity: Option<f32>,
    /// The sun; `None`: the scene's.
    pub sun: Option<SunSetting>,
    /// Whether the camera sees the sun's disc; `None`: as the scene says.
    pub sun_disc: Option<bool>,
    /// The sky; `None`: the scene's.
    pub sky: Option<SkySetting>,
    /// How far a panorama is turned, degrees; `None`: as the scene's is, others not at all.
    pub sky_rotation: Option<f32>,
    /// What is kept of the scene.
    pub cutting: Cutting,
    /// What is around it.
    pub surroundings: Surroundings,
}

impl RenderSettings {
    /// What a window begins with, with what traces.
    pub fn new(traversal: Traversal) -> Self {
        Self {
            traversal,
            primitive: Primitive::default(),
            fast: false,
            integrator: Integrator::Path,
            max_bounces: usual_bounces(Integrator::Path),
            bounce_limits: BounceLimits::default(),
            clamp_indirect: None,
            clear_shadows: false,
            lines: Lines::default(),
            samples: 4096,
            tone_map: ToneMap::default(),
            sky_brightness: None,
            light_intensity: None,
            sun: None,
            sun_disc: None,
            sky: None,
            sky_rotation: None,
            cutting: Cutting::default(),
            surroundings: Surroundings::default(),
        }
    }

    /// Computes light by other means, with the bounces that are usual there.
    pub fn take_integrator(&mut self, integrator: Integrator) {
        if integrator != self.integrator {
            (self.integrator, self.max_bounces) = (integrator, usual_bounces(integrator));
        }
    }

    /// The lines that are drawn.
    pub fn drawn_lines(&self) -> Lines {
        if self.integrator == Integrator::Path { self.lines } else { Lines::default() }
    }

    /// The same in the light of any scene's own.
    #[must_use]
    pub fn without_light(self) -> Self {
        let without_sun = Self { sun: None, sun_disc: None, ..self };
        Self { sky_brightness: None, light_intensity: None, sky: None, sky_rotation: None, ..without_sun }
    }

    /// Whether both have the same light and the same cuts, so that the scene stays as it is.
    pub fn has_light_of(&self, other: &Self) -> bool {
        let light =
            |settings: &Self| (settings.sky_brightness, settings.light_intensity, settings.sun, settings.sun_disc);
        let sky = |settings: &Self| (settings.sky.clone(), settings.sky_rotation);
        light(self) == light(other) && sky(self) == sky(other) && self.cutting == other.cutting
    }

    /// The scene with these cuts in this light, under the sky that was made for it where that takes its time: until then under its own. What is large is
    /// shared with the original.
    pub fn lit(&self, scene: &PackedScene, made: Option<&MadeSky>) -> PackedScene {
        let mut lit = scene.clone();
        // What cannot be cut is refused before it becomes a setting.
        lit.cuts = self.cutting.cuts(&scene.cuts).unwrap_or_else(|_| scene.cuts.clone());
        lit.light_intensity = self.light_intensity.unwrap_or(scene.light_intensity);
        lit.sky.set_brightness(self.sky_brightness.unwrap_or(scene.sky.brightness()));
        if let Some(sun) = self.sun {
            lit.sky.set_sun(sun.sun());
        }
        lit.sky.set_sun_disc_visible(self.sun_disc.unwrap_or(scene.sky.is_sun_disc_visible()));
        match (&self.sky, made) {
            (Some(SkySetting::Color(color)), _) => lit.sky.set_background(Background::uniform(*color)),
            (Some(SkySetting::Physical), Some(MadeSky::Air(_, sky))) => {
                let is_visible = lit.sky.is_sun_disc_visible();
                lit.sky = sky.clone().with_brightness(lit.sky.brightness()).with_sun_disc_visible(is_visible);
            }
            (Some(SkySetting::Panorama(_)), Some(MadeSky::Panorama(_, map))) => {
                lit.sky.set_background(Background::Environment(Environment::new(map.clone(), 0.0)));
                // A panorama has its own.
                if self.sun.is_none() {
                    lit.sky.set_sun(None);
                }
            }
            _ => {}
        }
        if let (Some(rotation), Some(environment)) = (self.sky_rotation, lit.sky.background().environment()) {
            let turned = Environment::new(environment.map().clone(), rotation);
            lit.sky.set_background(Background::Environment(turned));
        }
        lit
    }
}
