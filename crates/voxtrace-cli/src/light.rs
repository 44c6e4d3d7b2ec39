//! Options about the light.

use crate::camera_file::CameraFile;
use crate::parse::{self, SunOption};
use voxtrace::glam::Vec3;
use voxtrace::sky::Background;
use voxtrace::{PackedScene, Sun};

/// Options about the light.
#[derive(clap::Args, Clone, Debug, Default)]
#[command(next_help_heading = "Light")]
pub struct LightArgs {
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
    pub fn apply(&self, scene: &mut PackedScene) {
        scene.light_intensity = self.light_intensity.unwrap_or(scene.light_intensity);
        scene.sky.set_brightness(self.sky_brightness.unwrap_or(scene.sky.brightness()));
        if let Some(color) = self.sky_color {
            scene.sky.set_background(Background::uniform(color));
        }
        if let Some(sun) = self.sun {
            scene.sky.set_sun(Sun::at(sun.bearing, sun.height, sun.strength));
        }
    }
}

/// Sets the light that a camera file says.
pub fn set_light_of(file: &CameraFile, scene: &mut PackedScene) {
    scene.sky.set_brightness(file.sky_brightness.unwrap_or(scene.sky.brightness()));
    scene.light_intensity = file.light_intensity.unwrap_or(scene.light_intensity);
}
