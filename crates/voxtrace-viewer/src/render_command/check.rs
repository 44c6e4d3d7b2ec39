//! What `render` refuses, a command does not say.

use super::{CommandError, RenderCommand, SAMPLES, SkySetting, SunSetting};
use crate::cutting::MOST_PLANES;
use crate::tr;
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
            (camera.eye != camera.target, tr!("command.camera_on_target")),
            (camera.up != Vec3::ZERO, tr!("command.no_up")),
            (is_side(self.size.0) && is_side(self.size.1), tr!("dialogs.edge")),
            ((1..=SAMPLES.1).contains(&self.samples), tr!("dialogs.samples_range")),
            (self.clamp_indirect.is_none_or(|most| most > 0.0), tr!("command.clamp")),
            (self.tone_map.exposure.abs() <= 64.0, tr!("command.exposure")),
            (factors.into_iter().flatten().all(is_factor), tr!("command.factor")),
            (color.to_array().into_iter().all(is_factor), tr!("command.channels")),
            (sun.bearing.is_finite() && sun.height.abs() <= 90.0, tr!("command.sun_height")),
            (is_factor(sun.strength), tr!("command.sun_strength")),
            (!is_physical || sun.strength > 0.0, tr!("sky.needs_sun")),
            (!is_physical || self.sky_rotation.is_none(), tr!("command.sky_turned_by_sun")),
            (self.sky_rotation.is_none_or(f32::is_finite), tr!("command.sky_turned")),
            (ground.is_none_or(|ground| is_share(ground.color)), tr!("command.ground_colour")),
            (ground.and_then(|ground| ground.height).is_none_or(f32::is_finite), tr!("command.ground_height")),
            (self.surroundings.fog.is_none_or(|fog| is_fog(fog) && is_share(fog.color)), tr!("command.fog")),
            (self.cutting.planes.len() <= MOST_PLANES, tr!("command.planes")),
        ];
        rules.iter().find(|(holds, _)| !holds).map_or(Ok(()), |(_, reason)| Err(CommandError::Refused(reason)))
    }
}
