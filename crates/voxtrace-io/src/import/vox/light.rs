//! Sky and sun of a .vox file, from its rOBJ chunks: `_uni` is a sky of one colour, `_inf` the sun.
//!
//! The format text names the keys and leaves their units to the program. What voxtrace takes them to be: the sky's radiance
//! is colour (sRGB) × intensity; the sun's irradiance is π × colour × intensity, so that it makes a white surface as
//! bright as a sky of the same numbers does; `_angle` is the sun's height above the horizon and its bearing, in degrees,
//! as a camera's pitch and yaw, rounded to 1e-4 degrees; `_area` is the radius of its disc in radians. MagicaVoxel's pictures (`_ibl`) and
//! atmosphere (`_atm`) stay in the document only; the uniform sky stands in for them.

use super::{
    attributes::Attributes,
    camera::{direction_of, rounded, rounded_degrees},
    document::Dict,
};
use glam::Vec3;
use std::f64::consts::PI;
use voxtrace_scene::material::linear_color;
use voxtrace_scene::sky::{Background, Sky, Sun};
use voxtrace_voxelize::ImportError;

/// Radius of the sun as seen from Earth: the smallest disc, since a point cannot be sampled.
const SMALLEST_SUN: f32 = 0.004_65;
/// Factors of light below this count as 0, and those above [`BRIGHTEST`] as that.
const FAINTEST: f64 = 1e-6;
/// Largest factor of light.
const BRIGHTEST: f64 = 1e9;
const DIRECTION_STEPS: f64 = (1 << 30) as f64;

/// Takes what one rOBJ chunk says into account. `sky` is `None` until a chunk says something.
pub fn add_light(sky: &mut Option<Sky>, attributes: &Attributes) -> Result<(), ImportError> {
    let black = Sky::uniform(Vec3::ZERO);
    match attributes.dict.get("_type") {
        Some(b"_uni") => {
            let radiance = color(attributes)? * factor_of_light(intensity(attributes)?);
            sky.get_or_insert(black).set_background(Background::uniform(radiance));
        }
        Some(b"_inf") => {
            let [height, bearing] = attributes.floats("_angle")?.unwrap_or([50.0, 50.0]);
            let area = attributes.float("_area")?.unwrap_or(0.07);
            let sun = Sun {
                direction: towards(height, bearing),
                angular_radius: (area as f32).clamp(SMALLEST_SUN, std::f32::consts::FRAC_PI_2),
                irradiance: color(attributes)? * factor_of_light(intensity(attributes)? * PI),
            };
            sky.get_or_insert(black).set_sun((sun.irradiance.max_element() > 0.0).then_some(sun));
        }
        _ => {}
    }
    Ok(())
}

/// Whether an rOBJ chunk is one of those that say which sky there is.
pub fn is_light(properties: &Dict) -> bool {
    matches!(properties.get("_type"), Some(b"_uni" | b"_inf" | b"_env"))
}

fn color(attributes: &Attributes) -> Result<Vec3, ImportError> {
    Ok(linear_color(attributes.numbers("_k")?.unwrap_or([255; 3])))
}

fn intensity(attributes: &Attributes) -> Result<f64, ImportError> {
    Ok(attributes.float("_i")?.unwrap_or(1.0))
}

/// A factor of light: what is too faint to see is none.
pub fn factor_of_light(value: f64) -> f32 {
    if value.is_nan() || value < FAINTEST { 0.0 } else { value.min(BRIGHTEST) as f32 }
}

/// The direction towards the sun at a height above the horizon and a bearing, in degrees. Rounded, so that a sun that is
/// written and read again stands in the same place to the bit.
fn towards(height: f64, bearing: f64) -> Vec3 {
    let direction = -direction_of(rounded_degrees(height), rounded_degrees(bearing));
    Vec3::from_array(direction.to_array().map(|coordinate| rounded(coordinate, DIRECTION_STEPS) as f32))
}

/// Height above the horizon and bearing, in degrees, of the direction towards the sun.
pub fn angles_to(sun: Vec3) -> [f64; 2] {
    let [x, y, z] = sun.to_array().map(f64::from);
    [z.atan2(x.hypot(y)), (-x).atan2(-y)].map(|angle| rounded_degrees(angle.to_degrees()))
}
