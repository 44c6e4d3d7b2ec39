//! Environment maps for tests.

use crate::random::Random;
use glam::Vec3;
use std::sync::Arc;
use voxtrace::sky::EnvironmentMap;

/// A map of random texels, of which some are black and few much brighter than the others.
pub fn noise_map(edge: u32, seed: u64) -> Arc<EnvironmentMap> {
    let mut random = Random(seed);
    let texel = |_| {
        let brightness = [0.0, 0.3, 0.5, 1.0, 1.0, 1.0, 2.0, 30.0][random.below(8)];
        random.point(Vec3::splat(0.2), Vec3::ONE) * brightness
    };
    map_of(edge, &(0..edge * edge).map(texel).collect::<Vec<Vec3>>())
}

/// A map of the same radiance everywhere.
pub fn even_map(edge: u32, radiance: Vec3) -> Arc<EnvironmentMap> {
    map_of(edge, &vec![radiance; (edge * edge) as usize])
}

/// A black map with one texel that shines.
pub fn lone_texel(edge: u32, (x, y): (u32, u32), radiance: Vec3) -> Arc<EnvironmentMap> {
    let mut texels = vec![Vec3::ZERO; (edge * edge) as usize];
    texels[(y * edge + x) as usize] = radiance;
    map_of(edge, &texels)
}

fn map_of(edge: u32, texels: &[Vec3]) -> Arc<EnvironmentMap> {
    Arc::new(EnvironmentMap::new(edge, texels).expect("the texels are light"))
}
