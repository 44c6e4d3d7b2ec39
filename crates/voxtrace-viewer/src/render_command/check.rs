//! What `render` refuses, a command does not say.

use super::{CommandError, RenderCommand, SAMPLES, SkySetting, SunSetting};
use crate::cutting::MOST_PLANES;
use voxtrace::glam::Vec3;
use voxtrace::surroundings::Fog;

impl RenderCommand {
    /// Refuses what `render` refuses.
    pub(super) fn check(&self) -> Result<(), CommandError> {
        let camera = &self.camera;
        camera.check().map_err(CommandError::Refused)?;
        let factors = [self.sky_brightness, self.light_intensity];
        let color = if let Some(SkySetting::Color(color)) = self.sky { color } else { Vec3::ZERO };
        let sun = self.sun.unwrap_or(SunSetting::OF_PHYSICAL_SKY);
        let is_physical = self.sky == Some(SkySetting::Physical);
        let is_factor = |value: f32| value.is_finite() && value >= 0.0;
        let ground = self.surroundings.ground;
        let is_share = |color: Vec3| color.to_array().into_iter().all(|channel| (0.0..=1.0).contains(&channel));
        let is_fog = |fog: Fog| fog.density > 0.0 && fog.density <= 1e3 && fog.anisotropy.abs() <= 0.99;
        let is_side = |side: u32| (1..=65_536).contains(&side);
        let rules = [
            (camera.eye != camera.target, "the camera stands on its target"),
            (camera.up != Vec3::ZERO, "the camera's up is no direction"),
            (is_side(self.size.0) && is_side(self.size.1), "a picture has 1 to 65,536 pixels along an edge"),
            ((1..=SAMPLES.1).contains(&self.samples), "a picture has 1 to 1,048,576 samples"),
            (self.clamp_indirect.is_none_or(|most| most > 0.0), "a clamp of indirect light is above 0"),
            (self.tone_map.exposure.abs() <= 64.0, "the exposure is from -64 to 64 stops"),
            (factors.into_iter().flatten().all(is_factor), "a factor on light is a number that is not below 0"),
            (color.to_array().into_iter().all(is_factor), "a colour's channels are numbers that are not below 0"),
            (sun.bearing.is_finite() && sun.height.abs() <= 90.0, "the sun's height is from -90 to 90 degrees"),
            (is_factor(sun.strength), "the sun's strength is a number that is not below 0"),
            (!is_physical || sun.strength > 0.0, "a physical sky needs a sun that shines"),
            (!is_physical || self.sky_rotation.is_none(), "the sun says how a physical sky is turned"),
            (self.sky_rotation.is_none_or(f32::is_finite), "the sky is turned by a number of degrees"),
            (ground.is_none_or(|ground| is_share(ground.color)), "a ground's colour has channels from 0 to 1"),
            (ground.and_then(|ground| ground.height).is_none_or(f32::is_finite), "a ground has a height"),
            (
                self.surroundings.fog.is_none_or(|fog| is_fog(fog) && is_share(fog.color)),
                "a fog's density is above 0, its colour's channels at most 1, its G from -0.99 to 0.99",
            ),
            (self.cutting.planes.len() <= MOST_PLANES, "there are at most 6 planes"),
        ];
        rules.iter().find(|(holds, _)| !holds).map_or(Ok(()), |(_, reason)| Err(CommandError::Refused(reason)))
    }
}
