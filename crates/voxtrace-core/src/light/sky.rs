//! The background of the sky as a light. No direction of a gradient needs to be chosen: what surfaces choose samples it almost perfectly.

use super::{DistantLight, LightSample, Receiver};
use glam::Vec3;
use voxtrace_scene::sky::Sky;

impl DistantLight for Sky {
    #[inline]
    fn sample(&self, _receiver: &Receiver, _u: f32, _v: f32) -> Option<LightSample> {
        None
    }

    #[inline]
    fn pdf(&self, _direction: Vec3) -> f32 {
        0.0
    }

    #[inline]
    fn le(&self, direction: Vec3) -> Vec3 {
        self.radiance(direction)
    }
}
