//! What one changes about the picture beside the camera: how it is traced, light, exposure. All of it is also an option of
//! `voxtrace render`.

use crate::render_command::{SunSetting, usual_bounces};
use voxtrace::output::ToneMap;
use voxtrace::{Integrator, PackedScene, Sun};
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
            samples: 4096,
            tone_map: ToneMap::default(),
            sky_brightness: None,
            light_intensity: None,
            sun: None,
        }
    }

    /// Computes light by other means, with the bounces that are usual there.
    pub fn take_integrator(&mut self, integrator: Integrator) {
        if integrator != self.integrator {
            (self.integrator, self.max_bounces) = (integrator, usual_bounces(integrator));
        }
    }

    /// Whether both have the same light, so that the scene stays as it is.
    pub fn has_light_of(&self, other: &Self) -> bool {
        let light = |settings: &Self| (settings.sky_brightness, settings.light_intensity, settings.sun);
        light(self) == light(other)
    }

    /// The scene in this light. What is large is shared with the original.
    pub fn lit(&self, scene: &PackedScene) -> PackedScene {
        let mut lit = scene.clone();
        lit.light_intensity = self.light_intensity.unwrap_or(scene.light_intensity);
        lit.sky.set_brightness(self.sky_brightness.unwrap_or(scene.sky.brightness()));
        if let Some(sun) = self.sun {
            lit.sky.set_sun(Sun::at(sun.bearing, sun.height, sun.strength));
        }
        lit
    }
}

/// The setting of a scene's sun, as near as its numbers tell.
pub fn setting_of(scene: &PackedScene) -> SunSetting {
    let (bearing, height, strength) = scene.sky.sun().map_or((135.0, 45.0, 0.0), Sun::setting);
    SunSetting { bearing, height, strength }
}
