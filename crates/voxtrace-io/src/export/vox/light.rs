//! Sky and sun as rOBJ chunks: the inverse of the importer's.

use super::entry::split_color;
use crate::import::vox::{Body, Dict, light::angles_to};
use glam::Vec3;
use std::f64::consts::PI;
use voxtrace_scene::sky::Sky;

/// The chunks that say what the sky is; none for the sky that a file without them gets.
pub fn objects_of(sky: &Sky) -> Vec<Body<'static>> {
    if *sky == Sky::default() {
        return Vec::new();
    }
    let mut environment = Dict::default();
    environment.push("_type", "_env");
    environment.push("_mode", "0");
    let mut sun = Dict::default();
    sun.push("_type", "_inf");
    let irradiance = sky.sun().map_or(Vec3::ZERO, |sun| sun.irradiance * sky.brightness());
    push_color(&mut sun, irradiance, PI);
    if let Some(given) = sky.sun() {
        let [height, bearing] = angles_to(given.direction);
        sun.push("_angle", format!("{height} {bearing}"));
        sun.push("_area", given.angular_radius.to_string());
        sun.push("_disk", if sky.is_sun_disc_visible() { "1" } else { "0" });
    }
    let mut uniform = Dict::default();
    uniform.push("_type", "_uni");
    // Of two equal colours the mean is the colour, to the bit.
    push_color(&mut uniform, sky.mean_radiance(), 1.0);
    [environment, sun, uniform].map(Body::RenderObject).into()
}

/// What these chunks cannot say of a sky, in words.
pub fn lost_of(sky: &Sky) -> Option<String> {
    sky.background().environment().map(|_| "the picture of the sky, of which its mean stays".to_owned())
}

/// Colour and intensity whose product, times `unit`, is `light`.
fn push_color(properties: &mut Dict, light: Vec3, unit: f64) {
    let ([r, g, b], intensity) = split_color(light);
    properties.push("_i", (f64::from(intensity) / unit).to_string());
    properties.push("_k", format!("{r} {g} {b}"));
}
