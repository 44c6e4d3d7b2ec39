//! Sky and sun of a .vox file, from its rOBJ chunks: `_inf` is the sun, and `_env` says which of the others is the sky: `_uni`, one
//! colour; `_ibl`, a picture in a file beside it; `_atm`, an atmosphere in the light of the sun.
//!
//! The format text names the keys and leaves their units to the program. What voxtrace takes them to be: the sky's radiance
//! is colour (sRGB) × intensity; the sun's irradiance is π × colour × intensity, so that it makes a white surface as
//! bright as a sky of the same numbers does, and under an atmosphere that above it; `_angle` is the sun's height above the horizon and its
//! bearing, in degrees, as a camera's pitch and yaw, rounded to 1e-4 degrees; `_area` is the radius of its disc in radians; with `_disk` 0 the camera
//! does not see the disc, which it does in older files, without the key; `_mode` 0, 1 and 2 are the skies in the order in which files list them (the file of mode 1 in our data is the one whose picture's intensity was changed);
//! `_rot` turns a picture clockwise, in degrees. Where the picture is not there, the colour stands in.

use super::{
    air::air_of,
    attributes::Attributes,
    camera::{direction_of, rounded, rounded_degrees},
    document::Dict,
};
use glam::Vec3;
use std::f64::consts::PI;
use std::sync::Arc;
use voxtrace_scene::material::linear_color;
use voxtrace_scene::sky::{Atmosphere, Background, Environment, EnvironmentMap, Sky, Sun};
use voxtrace_voxelize::ImportError;

/// Radius of the sun as seen from Earth: the smallest disc, since a point cannot be sampled.
const SMALLEST_SUN: f32 = 0.004_65;
/// Factors of light below this count as 0, and those above [`BRIGHTEST`] as that.
const FAINTEST: f64 = 1e-6;
/// Largest factor of light.
const BRIGHTEST: f64 = 1e9;
const DIRECTION_STEPS: f64 = (1 << 30) as f64;

/// A sky that is a picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// Name of its file.
    pub name: String,
    /// Factor on its radiance.
    pub intensity: f32,
}

/// What the rOBJ chunks of a file say about its light.
#[derive(Default)]
pub struct Light {
    uniform: Option<Vec3>,
    sun: Option<Sun>,
    /// Whether the camera does not see the sun's disc.
    hides_sun_disc: bool,
    /// With its rotation in degrees.
    picture: Option<(Picture, f32)>,
    air: Option<Atmosphere>,
    mode: i64,
    /// Whether anything was said about the sky of one colour or the sun.
    is_said: bool,
}

impl Light {
    /// Takes what one chunk says into account.
    pub fn read(&mut self, attributes: &Attributes) -> Result<(), ImportError> {
        match attributes.dict.get("_type") {
            Some(b"_env") => self.mode = attributes.integer("_mode")?.unwrap_or(0),
            Some(b"_uni") => {
                self.uniform = Some(color(attributes)? * factor_of_light(intensity(attributes)?));
                self.is_said = true;
            }
            Some(b"_inf") => {
                let [height, bearing] = attributes.floats("_angle")?.unwrap_or([50.0, 50.0]);
                let area = attributes.float("_area")?.unwrap_or(0.07);
                let sun = Sun {
                    direction: towards(height, bearing),
                    angular_radius: (area as f32).clamp(SMALLEST_SUN, std::f32::consts::FRAC_PI_2),
                    irradiance: color(attributes)? * factor_of_light(intensity(attributes)? * PI),
                };
                self.sun = (sun.irradiance.max_element() > 0.0).then_some(sun);
                self.hides_sun_disc = self.sun.is_some() && attributes.float("_disk")? == Some(0.0);
                self.is_said = true;
            }
            Some(b"_ibl") => {
                let name = attributes.text("_path").filter(|name| !name.is_empty());
                let intensity = factor_of_light(intensity(attributes)?);
                // Older files have two angles.
                let rotation = match attributes.float("_rot")? {
                    Some(rotation) => rotation,
                    None => attributes.floats("_angle")?.unwrap_or([0.0; 2])[1],
                };
                self.picture = name.map(|name| (Picture { name, intensity }, rotation as f32));
            }
            Some(b"_atm") => self.air = Some(air_of(attributes)?),
            _ => {}
        }
        Ok(())
    }

    /// The sky, `None` where nothing was said about it. `map_of` is asked for the map of a picture, if that is the sky.
    pub fn sky(self, map_of: &mut dyn FnMut(&Picture) -> Option<Arc<EnvironmentMap>>) -> Option<Sky> {
        let uniform = Sky::uniform(self.uniform.unwrap_or(Vec3::ZERO)).with_sun(self.sun);
        let air = self.air.unwrap_or(Atmosphere::EARTH);
        let other = match (self.mode, &self.picture, &self.sun) {
            (1, Some((picture, rotation)), _) => map_of(picture)
                .map(|map| Sky::new(Background::Environment(Environment::new(map, *rotation))).with_sun(self.sun)),
            (2, _, Some(sun)) => Some(air.sky(sun)),
            (2, _, None) => Some(Sky::uniform(Vec3::ZERO)),
            _ => None,
        };
        let sky = other.or_else(|| self.is_said.then_some(uniform))?;
        Some(sky.with_sun_disc_visible(!self.hides_sun_disc))
    }
}

/// Whether an rOBJ chunk says something that scenes have a place for. `_rayleigh` and `_mie` are `_atm` in older files, which have no `_env` to
/// choose it: their sky is `_uni`.
pub fn is_understood(properties: &Dict) -> bool {
    is_light(properties) || matches!(properties.get("_type"), Some(b"_ibl" | b"_atm" | b"_rayleigh" | b"_mie"))
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
