//! Heightmaps on the command line: how high they become, and in which colours.

use crate::failure::Failure;
use crate::parse;
use std::path::PathBuf;
use voxtrace::import::{Height, HeightOptions};

/// Options about heightmaps.
#[derive(clap::Args, Clone, Debug, Default)]
#[command(next_help_heading = "Heightmaps")]
pub struct HeightArgs {
    /// Voxels from the lowest to the highest point [default: true to scale where the file has units, else a quarter of the longer side]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=200_000))]
    height: Option<u32>,
    /// Voxels for each unit of height
    #[arg(long, value_name = "F", value_parser = parse::positive, conflicts_with = "height")]
    height_scale: Option<f32>,
    /// Picture that gives the colours of the heights (PNG, JPEG)
    #[arg(long, value_name = "FILE")]
    color_image: Option<PathBuf>,
}

impl HeightArgs {
    /// Refuses options about heightmaps for what is none: `--height` is easily taken for the height of a picture.
    pub fn refuse(&self, name: &str) -> Result<(), Failure> {
        let asked = [
            ("--height", self.height.is_some()),
            ("--height-scale", self.height_scale.is_some()),
            ("--color-image", self.color_image.is_some()),
        ];
        match asked.into_iter().find(|(_, is_asked)| *is_asked) {
            Some((option, _)) => Err(Failure::usage(format!("{option} needs a heightmap, and {name} is none"))
                .hint("the size of a picture is that of `render --size 1280x720`")),
            None => Ok(()),
        }
    }

    /// How heightmaps become voxels; `shell` drops what nobody sees of them.
    pub fn options(&self, shell: bool) -> HeightOptions {
        let height = match (self.height, self.height_scale) {
            (Some(voxels), _) => Height::Voxels(voxels),
            (None, Some(scale)) => Height::Scale(scale.into()),
            (None, None) => Height::Automatic,
        };
        HeightOptions { height, color_image: self.color_image.clone(), shell }
    }
}
