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
        let cos_theta = receiver.normal.dot(chosen.direction) + receiver.slack;
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::light::Lights;
    use crate::packed::PackedScene;
    use crate::sampler::Sampler;
    use glam::IVec3;
    use std::sync::Arc;
    use voxtrace_scene::sky::{Background, Environment, EnvironmentMap, Sun};
    use voxtrace_scene::{Material, Scene, VoxelGrid};

    #[test]
    fn a_place_in_a_medium_gets_the_light_of_a_map_and_of_the_sun_beside_it() {
        let map = EnvironmentMap::new(8, &[Vec3::ONE; 64]).unwrap();
        let sun = Sun::at(30.0, -20.0, 2.0);
        let sky = Sky::new(Background::Environment(Environment::new(Arc::new(map), 0.0)));
        let mut grid = VoxelGrid::new();
        grid.set(IVec3::ZERO, 0);
        let scene = Scene { sky: sky.with_sun(sun), ..Scene::from_grid("one", grid, vec![Material::default()]) };
        let scene = PackedScene::pack(&scene).unwrap();
        let lights = Lights::new(&scene);
        let receiver = Receiver::in_medium(Vec3::splat(3.0));
        for pixel in 0..1000 {
            let u = Sampler { seed: 1, pixel, sample: 0 }.independent(0);
            assert!(scene.sky.sample(&receiver, u).is_some(), "{u:?}: light counts from all sides");
        }
        let towards = lights.sun.as_ref().unwrap().direction;
        assert!(lights.sun_pdf(&receiver, towards) > 0.0 && lights.sky_pdf(&receiver, towards) > 0.0);
    }
}
