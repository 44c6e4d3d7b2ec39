//! Files of voxels on the command line: builds and worlds of Minecraft, models, heightmaps.

use crate::failure::Failure;
use crate::mesh::MeshArgs;
use crate::parse;
use crate::read_failure::import_failure;
use crate::report::Report;
use std::path::{Path, PathBuf};
use voxtrace::Scene;
use voxtrace::import::{self, Height, HeightOptions, ImportOptions};

/// Options about heightmaps.
#[derive(clap::Args, Clone, Debug, Default)]
#[command(next_help_heading = "Heightmaps")]
pub struct HeightArgs {
    /// Voxels from the lowest to the highest point [default: true to scale where the file tells, else a quarter of the longer side]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=200_000))]
    height: Option<u32>,
    /// Voxels for each unit of height
    #[arg(long, value_name = "F", value_parser = parse::positive, conflicts_with = "height")]
    height_scale: Option<f32>,
    /// A picture that is laid over the heights (PNG, JPEG)
    #[arg(long, value_name = "FILE")]
    color_image: Option<PathBuf>,
}

impl HeightArgs {
    /// Reads the voxels of a file and says what was left out; `shell` drops what nobody sees of a heightmap.
    pub fn scene(&self, path: &Path, mesh: &MeshArgs, shell: bool, report: &Report) -> Result<Scene, Failure> {
        let height = match (self.height, self.height_scale) {
            (Some(voxels), _) => Height::Voxels(voxels),
            (None, Some(scale)) => Height::Scale(scale.into()),
            (None, None) => Height::Automatic,
        };
        let heights = HeightOptions { height, color_image: self.color_image.clone(), shell };
        let options = ImportOptions { heights, ..mesh.import_options() };
        let voxels = import::read_voxels(path, &options).map_err(|error| import_failure(&error))?;
        for note in &voxels.notes {
            report.warn(&format!("{}: {note}", path.display()));
        }
        Ok(voxels.scene)
    }
}
