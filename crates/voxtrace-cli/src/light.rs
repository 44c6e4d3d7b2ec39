//! Options about the light.

use crate::camera_file::CameraFile;
use crate::failure::Failure;
use crate::parse::{self, SunOption};
use crate::read_failure::import_failure;
use std::path::Path;
use voxtrace::glam::Vec3;
use voxtrace::import::{Limits, read_environment};
use voxtrace::sky::{Atmosphere, Background, Environment};
use voxtrace::{PackedScene, Sun};

/// Where the sun of `--sky physical` stands where nothing says it: bearing, height, strength.
const SUN_OF_PHYSICAL_SKY: SunOption = SunOption { bearing: 135.0, height: 45.0, strength: 3.0 };

/// Options about the light.
#[derive(clap::Args, Clone, Debug, Default)]
#[command(next_help_heading = "Light")]
pub struct LightArgs {
    /// Sky of a panorama (.hdr or .exr, 360 x 180 degrees), or `physical`: the Earth's in the light of the sun
    #[arg(long, value_name = "FILE|physical", conflicts_with = "sky_color")]
    sky: Option<String>,
    /// Turn a panorama clockwise, seen from above; at 0 its middle is in the bearing of +y
    #[arg(long, value_name = "DEGREES", value_parser = parse::finite, allow_hyphen_values = true)]
    sky_rotation: Option<f32>,
    /// Factor on the whole sky, the sun included
    #[arg(long, value_name = "FACTOR", value_parser = parse::positive)]
    sky_brightness: Option<f32>,
    /// Sky of one colour: #rrggbb, or linear r,g,b
    #[arg(long, value_name = "COLOR", value_parser = parse::color)]
    sky_color: Option<Vec3>,
    /// Sun at this bearing (clockwise from +y) and height in degrees, with this strength [default strength: 3]
    #[arg(long, value_name = "BEARING,HEIGHT[,STRENGTH]", value_parser = parse::sun, allow_hyphen_values = true)]
    sun: Option<SunOption>,
    /// Factor on the emission of all materials
    #[arg(long, value_name = "FACTOR", value_parser = parse::positive)]
    light_intensity: Option<f32>,
}

impl LightArgs {
    /// Sets what is asked for; the rest stays.
    pub fn apply(&self, scene: &mut PackedScene) -> Result<(), Failure> {
        scene.light_intensity = self.light_intensity.unwrap_or(scene.light_intensity);
        scene.sky.set_brightness(self.sky_brightness.unwrap_or(scene.sky.brightness()));
        if let Some(color) = self.sky_color {
            scene.sky.set_background(Background::uniform(color));
        }
        if let Some(sun) = self.sun {
            scene.sky.set_sun(Sun::at(sun.bearing, sun.height, sun.strength));
        }
        match self.sky.as_deref() {
            Some("physical") => self.set_physical(scene)?,
            Some(path) => {
                let path = Path::new(path);
                let map = read_environment(path, &Limits::default())
                    .map_err(|error| import_failure(&error).hint("--sky takes a .hdr or .exr file, or `physical`"))?;
                scene.sky.set_background(Background::Environment(Environment::new(map.into(), 0.0)));
                // A panorama has its own.
                if self.sun.is_none() {
                    scene.sky.set_sun(None);
                }
            }
            None => {}
        }
        let Some(rotation) = self.sky_rotation else { return Ok(()) };
        let Some(environment) = scene.sky.background().environment() else {
            return Err(Failure::usage("--sky-rotation turns a panorama, and this sky is none")
                .hint("name one with --sky FILE"));
        };
        let turned = Environment::new(environment.map().clone(), rotation);
        scene.sky.set_background(Background::Environment(turned));
        Ok(())
    }

    /// The Earth's sky in the light of the sun that is asked for, or the scene's.
    fn set_physical(&self, scene: &mut PackedScene) -> Result<(), Failure> {
        if self.sky_rotation.is_some() {
            return Err(Failure::usage("--sky-rotation turns a panorama, and this sky is none")
                .hint("--sun says where the sun of a physical sky stands"));
        }
        let of_scene = || {
            scene.sky.sun().map(|sun| {
                let (bearing, height, strength) = sun.setting();
                SunOption { bearing, height, strength }
            })
        };
        let sun = self.sun.or_else(of_scene).unwrap_or(SUN_OF_PHYSICAL_SKY);
        // Above the air sunlight is white.
        let sun = Sun::at(sun.bearing, sun.height, sun.strength)
            .map(|disc| Sun { irradiance: Vec3::splat(sun.strength), ..disc })
            .ok_or_else(|| Failure::usage("--sky physical needs a sun that shines"))?;
        scene.sky = Atmosphere::EARTH.sky(&sun).with_brightness(scene.sky.brightness());
        Ok(())
    }
}

/// Sets the light that a camera file says.
pub fn set_light_of(file: &CameraFile, scene: &mut PackedScene) {
    scene.sky.set_brightness(file.sky_brightness.unwrap_or(scene.sky.brightness()));
    scene.light_intensity = file.light_intensity.unwrap_or(scene.light_intensity);
}
