//! Sky and sun of a .vox file, from its rOBJ chunks: `_uni` is a sky of one colour, `_inf` the sun.
//!
//! The format text names the keys and leaves their units to the program. What voxtrace takes them to be: the sky's radiance
//! is colour (sRGB) × intensity; the sun's irradiance is π × colour × intensity, so that it makes a white surface as
//! bright as a sky of the same numbers does; `_angle` is the sun's height above the horizon and its bearing, in degrees,
//! as a camera's pitch and yaw, rounded to 1e-4 degrees; `_area` is the radius of its disc in radians. MagicaVoxel's pictures (`_ibl`) and
//! atmosphere (`_atm`) stay in the document only; the uniform sky stands in for them.

use super::{attributes::Attributes, camera::direction_of};
use crate::{
    import::ImportError,
    material::linear_color,
    sky::{Sky, Sun},
};
use glam::Vec3;
use std::f64::consts::PI;

/// Radius of the sun as seen from Earth: the smallest disc, since a point cannot be sampled.
pub const SMALLEST_SUN: f32 = 0.004_65;

/// Takes what one rOBJ chunk says into account. `sky` is `None` until a chunk says something.
pub fn add_light(sky: &mut Option<Sky>, attributes: &Attributes) -> Result<(), ImportError> {
    let black = Sky { nadir: Vec3::ZERO, zenith: Vec3::ZERO, brightness: 1.0, sun: None };
    match attributes.dict.get("_type") {
        Some(b"_uni") => {
            let radiance = color(attributes)? * positive(intensity(attributes)?);
            let sky = sky.get_or_insert(black);
            (sky.nadir, sky.zenith) = (radiance, radiance);
        }
        Some(b"_inf") => {
            let [height, bearing] = attributes.floats("_angle")?.unwrap_or([50.0, 50.0]);
            let area = attributes.float("_area")?.unwrap_or(0.07);
            let sun = Sun {
                direction: -direction_of(rounded(height), rounded(bearing)).as_vec3(),
                angular_radius: (area as f32).clamp(SMALLEST_SUN, std::f32::consts::FRAC_PI_2),
                irradiance: color(attributes)? * positive(intensity(attributes)? * PI),
            };
            sky.get_or_insert(black).sun = (sun.irradiance.max_element() > 0.0).then_some(sun);
        }
        _ => {}
    }
    Ok(())
}

fn color(attributes: &Attributes) -> Result<Vec3, ImportError> {
    Ok(linear_color(attributes.numbers("_k")?.unwrap_or([255; 3])))
}

fn intensity(attributes: &Attributes) -> Result<f64, ImportError> {
    Ok(attributes.float("_i")?.unwrap_or(1.0))
}

fn positive(value: f64) -> f32 {
    value.clamp(0.0, 1e9) as f32
}

/// Height above the horizon and bearing in degrees of the direction towards the sun.
pub fn angles_to(sun: Vec3) -> [f64; 2] {
    let [x, y, z] = sun.to_array().map(f64::from);
    [rounded(z.atan2(x.hypot(y)).to_degrees()), rounded((-x).atan2(-y).to_degrees())]
}

/// To 1e-4 degrees, which a direction of f32 tells apart: so a sun that is written and read again stands in the same place.
fn rounded(degrees: f64) -> f64 {
    (degrees * 1e4).round() / 1e4 + 0.0
}
