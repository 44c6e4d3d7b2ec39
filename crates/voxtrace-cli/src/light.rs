//! Options about the light.

use crate::camera_file::CameraFile;
use crate::failure::Failure;
use crate::parse;
use crate::read_failure::import_failure;
use std::path::Path;
use voxtrace::PackedScene;
use voxtrace::changes::SunSetting;
use voxtrace::glam::Vec3;
use voxtrace::import::{Limits, read_environment};
use voxtrace::sky::{Background, Environment};

/// Options about the light.
#[derive(clap::Args, Clone, Debug, Default)]
#[command(next_help_heading = "Light")]
pub struct LightArgs {
    /// Sky of a panorama (.hdr or .exr, 360 x 180 degrees), or `physical`: the Earth's in the light of the sun
    #[arg(long, value_name = "FILE|physical", conflicts_with = "sky_color")]
    sky: Option<String>,
    /// Turn a panorama clockwise, seen from above, in degrees; at 0 its middle is in the bearing of +y [default: 0]
    #[arg(long, value_name = "DEGREES", value_parser = parse::finite, allow_hyphen_values = true)]
    sky_rotation: Option<f32>,
    /// Factor on the whole sky, the sun included
    #[arg(long, value_name = "FACTOR", value_parser = parse::positive)]
    sky_brightness: Option<f32>,
    /// Sky of one colour: #rrggbb, or linear r,g,b
    #[arg(long, value_name = "COLOR", value_parser = parse::color)]
    sky_color: Option<Vec3>,
    /// Sun at this bearing (clockwise from +y) and height, both in degrees, with this strength (irradiance) [default strength: 3]
    #[arg(long, value_name = "BEARING,HEIGHT[,STRENGTH]", value_parser = parse::sun, allow_hyphen_values = true)]
    sun: Option<SunSetting>,
    /// Whether the camera sees the sun's disc; mirrors and glass show it either way, and its light is the same [default: as the scene says]
    #[arg(long, value_enum, value_name = "SEEN")]
    sun_disc: Option<SunDisc>,
    /// Factor on the emission of all materials
    #[arg(long, value_name = "FACTOR", value_parser = parse::positive)]
    light_intensity: Option<f32>,
}

/// Whether the camera sees the sun's disc.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum SunDisc {
    /// It does.
    Visible,
    /// It does not.
    Hidden,
}

impl LightArgs {
    /// Whether the sky is the Earth's in the light of the sun.
    pub fn is_physical(&self) -> bool {
        self.sky.as_deref() == Some("physical")
    }

    /// Sets what is asked for; the rest stays.
    pub fn apply(&self, scene: &mut PackedScene) -> Result<(), Failure> {
        scene.light_intensity = self.light_intensity.unwrap_or(scene.light_intensity);
        scene.sky.set_brightness(self.sky_brightness.unwrap_or(scene.sky.brightness()));
        if let Some(color) = self.sky_color {
            scene.sky.set_background(Background::uniform(color));
        }
        if let Some(sun) = self.sun {
            scene.sky.set_sun(sun.sun());
        }
        if let Some(disc) = self.sun_disc {
            scene.sky.set_sun_disc_visible(disc == SunDisc::Visible);
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
        let sun = self.sun.or_else(|| SunSetting::of(&scene.sky)).unwrap_or(SunSetting::OF_PHYSICAL_SKY);
        let sky = sun.physical_sky().ok_or_else(|| Failure::usage("--sky physical needs a sun that shines"))?;
        let is_visible = scene.sky.is_sun_disc_visible();
        scene.sky = sky.with_brightness(scene.sky.brightness()).with_sun_disc_visible(is_visible);
        Ok(())
    }
}

/// Sets the light that a camera file says.
pub fn set_light_of(file: &CameraFile, scene: &mut PackedScene) {
    scene.sky.set_brightness(file.sky_brightness.unwrap_or(scene.sky.brightness()));
    scene.light_intensity = file.light_intensity.unwrap_or(scene.light_intensity);
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::Arc;
    use voxtrace::scenes;
    use voxtrace_viewer::render_command::SkySetting;
    use voxtrace_viewer::session::Session;
    use voxtrace_vulkan::Traversal;

    #[derive(clap::Parser)]
    struct Words {
        #[command(flatten)]
        light: LightArgs,
    }

    /// The light that `render` makes of the window's command.
    fn rendered(session: &Session) -> PackedScene {
        let words = session.render_command().unwrap().words().unwrap();
        let is_of_light = |word: &String| ["--sky", "--sun", "--light"].iter().any(|own| word.starts_with(own));
        let pairs = words.windows(2).filter(|pair| is_of_light(&pair[0]));
        let words = pairs.flat_map(|pair| match pair[0].contains('=') {
            true => vec![pair[0].clone()],
            false => pair.to_vec(),
        });
        let mut scene = (*session.open.as_ref().unwrap().original).clone();
        let parsed = <Words as clap::Parser>::parse_from(std::iter::once("render".into()).chain(words));
        parsed.light.apply(&mut scene).map_err(|failure| failure.line()).unwrap();
        scene
    }

    #[test]
    fn the_command_of_a_window_makes_the_windows_light_to_the_bit() {
        let scene = Arc::new(PackedScene::pack(&scenes::generate("city", Some(2_000)).unwrap()).unwrap());
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("sky.hdr");
        let pixels = (0..8 * 4).flat_map(|pixel| [pixel * 7, 200, 90, 129]);
        std::fs::write(&path, b"#?RADIANCE\n\n-Y 4 +X 8\n".iter().copied().chain(pixels).collect::<Vec<u8>>()).unwrap();
        let sun = Some(SunSetting { bearing: -33.3, height: 7.7, strength: 1.9 });
        let settings = [
            (None, sun, None),
            (Some(SkySetting::Color(Vec3::new(0.1, 1.0 / 3.0, 0.7))), None, None),
            (Some(SkySetting::Physical), None, None),
            (Some(SkySetting::Physical), sun, None),
            (Some(SkySetting::Panorama(path.clone())), None, Some(-12.3)),
            (Some(SkySetting::Panorama(path)), sun, None),
        ];
        let mut before = scene.sky.clone();
        for ((sky, sun, sky_rotation), sun_disc) in
            settings.into_iter().zip([None, Some(false), Some(true)].into_iter().cycle())
        {
            let mut session = Session::new(Traversal::Cpu);
            session.show("city".into(), scene.clone());
            let mut wanted = session.render_settings.clone();
            (wanted.sky, wanted.sun, wanted.sky_rotation) = (sky, sun, sky_rotation);
            (wanted.sky_brightness, wanted.light_intensity) = (Some(0.7), Some(1.3));
            wanted.sun_disc = sun_disc;
            session.set_render_settings(wanted);
            session.make_sky(Arc::new(|| {}));
            while session.skies.is_making() {
                std::thread::yield_now();
                session.take_sky();
            }
            let (shown, rendered) = (session.open.as_ref().unwrap().lit.clone(), rendered(&session));
            assert_eq!((&shown.sky, shown.light_intensity), (&rendered.sky, rendered.light_intensity));
            assert_ne!(shown.sky, before, "the comparison sees another light");
            before = shown.sky.clone();
        }
    }
}
