//! The background of the sky as a light. No direction of a gradient needs to be chosen: what surfaces choose samples it almost perfectly.
//! Those of an environment map are chosen in proportion to what they send.

use super::{DistantLight, LightSample, Receiver};
use crate::math::luminance;
use glam::Vec3;
use std::f32::consts::PI;
use voxtrace_scene::ray::Ray;
use voxtrace_scene::sky::Sky;

/// Luminance of the irradiance of a sky whose directions are chosen, on a surface that sees all its light from above; 0 where none is.
pub fn irradiance_of(sky: &Sky) -> f32 {
    let is_chosen = sky.background().environment().is_some();
    if is_chosen { luminance(sky.mean_radiance()) * PI } else { 0.0 }
}

impl DistantLight for Sky {
    #[inline]
    fn sample(&self, receiver: &Receiver, u: [f32; 4]) -> Option<LightSample> {
        let chosen = self.background().environment()?.choose(u)?;
        let cos_theta = receiver.normal.dot(chosen.direction);
        let ray = Ray::new(receiver.point, chosen.direction);
        let radiance = chosen.radiance * self.brightness();
        (cos_theta > 0.0).then_some(LightSample { ray, cos_theta, radiance, pdf: chosen.pdf })
    }

    #[inline]
    fn pdf(&self, direction: Vec3) -> f32 {
        self.background().environment().map_or(0.0, |environment| environment.pdf(direction))
    }

    #[inline]
    fn le(&self, direction: Vec3) -> Vec3 {
        self.radiance(direction)
    }
}
