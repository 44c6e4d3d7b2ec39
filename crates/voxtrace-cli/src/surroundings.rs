//! Options about what is around the scene: a ground, fog, and what the camera sees behind everything.

use crate::failure::Failure;
use crate::parse;
use voxtrace::PackedScene;
use voxtrace::glam::Vec3;
use voxtrace::import::{Content, vox};
use voxtrace::material::linear_color;
use voxtrace::surroundings::{Fog, Ground};

/// The ground's colour where neither an option nor the file says one.
const GREY: [u8; 3] = [80; 3];

/// Options about what is around the scene.
#[derive(clap::Args, Clone, Debug, Default)]
#[command(next_help_heading = "Surroundings")]
pub struct SurroundingsArgs {
    /// A ground without end at this height, in voxels [default with no value: below the lowest voxel]
    #[arg(long, value_name = "HEIGHT", num_args = 0..=1, require_equals = true, default_missing_value = "auto")]
    #[arg(value_parser = height)]
    ground: Option<Height>,
    /// Colour of the ground: #rrggbb, or linear r,g,b [default: that of the .vox file, else #505050]
    #[arg(long, value_name = "COLOR", value_parser = parse::color, requires = "ground")]
    ground_color: Option<Vec3>,
    /// Show nothing of the ground but the shadows on it, black with alpha, in a transparent picture or before --background
    #[arg(long, requires = "ground", conflicts_with = "fog")]
    shadow_catcher: bool,
    /// Fog: how often light scatters on its way through a voxel (0.001: once in a thousand voxels), its colour [default: white], and the mean cosine of the angle, above 0 forwards [default: 0]; `file`: that of the .vox file
    #[arg(long, value_name = "DENSITY[,COLOR[,G]]|file", value_parser = fog)]
    fog: Option<FogOption>,
    /// What the camera sees where it sees no voxel: #rrggbb, linear r,g,b, or that of the .vox file; it sheds no light
    #[arg(long, value_name = "COLOR|file", value_parser = background, conflicts_with = "transparent")]
    background: Option<BackgroundOption>,
}

/// `--ground`.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Height {
    Auto,
    At(f32),
}

/// `--fog`.
#[derive(Clone, Copy, Debug, PartialEq)]
enum FogOption {
    OfFile,
    Given(Fog),
}

/// `--background`.
#[derive(Clone, Copy, Debug, PartialEq)]
enum BackgroundOption {
    OfFile,
    Color(Vec3),
}

/// What is around the scene of a run.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Surroundings {
    ground: Option<Ground>,
    fog: Option<Fog>,
    /// Radiance of what is behind everything.
    pub background: Option<Vec3>,
}

impl SurroundingsArgs {
    /// Whether pictures get a background.
    pub fn has_background(&self) -> bool {
        self.background.is_some()
    }

    /// Whether the ground shows shadows alone.
    pub fn has_shadow_catcher(&self) -> bool {
        self.shadow_catcher
    }

    /// What they ask for, some of it from the scene's file.
    pub fn of(&self, content: &Content) -> Result<Surroundings, Failure> {
        let own =
            if let Content::Scene(scene) = content { vox::surroundings(scene) } else { vox::Surroundings::default() };
        let lacks = |what: &str, option: &str| {
            Failure::usage(format!("the file says no {what}")).hint(format!("name one: {option}"))
        };
        let color = self.ground_color.or(own.ground).unwrap_or_else(|| linear_color(GREY)).min(Vec3::ONE);
        let ground = self.ground.map(|height| match height {
            Height::Auto => Ground { height: None, color },
            Height::At(height) => Ground { height: Some(height), color },
        });
        let fog = match self.fog {
            None => None,
            Some(FogOption::Given(fog)) => Some(fog),
            Some(FogOption::OfFile) => Some(own.fog.ok_or_else(|| lacks("fog", "--fog 0.002"))?),
        };
        let background = match self.background {
            None => None,
            Some(BackgroundOption::Color(color)) => Some(color),
            Some(BackgroundOption::OfFile) => {
                Some(own.background.ok_or_else(|| lacks("background", "--background '#303030'"))?)
            }
        };
        Ok(Surroundings { ground, fog, background })
    }
}

impl Surroundings {
    /// The scene with them.
    pub fn around(&self, scene: &PackedScene) -> Result<PackedScene, Failure> {
        if (self.ground, self.fog) == (None, None) {
            return Ok(scene.clone());
        }
        scene.with_surroundings(self.ground.as_ref(), self.fog.as_ref()).map_err(Failure::input)
    }
}

fn height(text: &str) -> Result<Height, String> {
    if text == "auto" { Ok(Height::Auto) } else { parse::finite(text).map(Height::At) }
}

fn background(text: &str) -> Result<BackgroundOption, String> {
    if text == "file" { Ok(BackgroundOption::OfFile) } else { parse::color(text).map(BackgroundOption::Color) }
}

/// `density`, `density,#rrggbb`, `density,r,g,b`, and either with `,g` behind it.
fn fog(text: &str) -> Result<FogOption, String> {
    if text == "file" {
        return Ok(FogOption::OfFile);
    }
    let (density, rest) = text.split_once(',').map_or((text, None), |(density, rest)| (density, Some(rest)));
    let density = parse::finite(density)?;
    let (color, anisotropy) = match rest {
        None => (Vec3::ONE, 0.0),
        Some(rest) => {
            let end = parse::end_of_color(rest);
            let color = parse::color(&rest[..end])?;
            (color, rest[end..].strip_prefix(',').map_or(Ok(0.0), parse::finite)?)
        }
    };
    if density <= 0.0 || density > 1e3 || anisotropy.abs() > 0.99 || color.max_element() > 1.0 {
        return Err("a fog's density is above 0, its colour's channels at most 1, its G from -0.99 to 0.99".into());
    }
    Ok(FogOption::Given(Fog { density, color, anisotropy }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fog_is_a_density_with_a_colour_and_an_angle_where_it_says_them() {
        let given = |density, color: [f32; 3], anisotropy| {
            Ok(FogOption::Given(Fog { density, color: Vec3::from(color), anisotropy }))
        };
        assert_eq!(fog("0.25"), given(0.25, [1.0; 3], 0.0));
        assert_eq!(fog("0.25,#ff0000"), given(0.25, [1.0, 0.0, 0.0], 0.0));
        assert_eq!(fog("0.25,#ffffff,-0.5"), given(0.25, [1.0; 3], -0.5));
        assert_eq!(fog("1,0.5,0.25,0.75"), given(1.0, [0.5, 0.25, 0.75], 0.0));
        assert_eq!(fog("1,0.5,0.25,0.75,0.9"), given(1.0, [0.5, 0.25, 0.75], 0.9));
        assert_eq!(fog("file"), Ok(FogOption::OfFile));
        for wrong in ["", "0", "-1", "1,", "1,2,2,2", "1,0.5", "1,#fff", "1,#ffffff,1", "1,0,0,0,0,0", "nan", "1,é"] {
            assert!(fog(wrong).is_err(), "{wrong}");
        }
        assert_eq!((height("auto"), height("-2.5")), (Ok(Height::Auto), Ok(Height::At(-2.5))));
        assert!(height("low").is_err() && background("grey").is_err());
    }
}
