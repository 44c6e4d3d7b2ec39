//! What is done to a scene once it is read: closing holes, dropping what nobody sees, fewer colours, and the colours of a picture.

use crate::failure::Failure;
use crate::mesh::MeshArgs;
use crate::read_failure::import_failure;
use crate::report::Report;
use std::path::PathBuf;
use voxtrace::close::{LARGEST_RADIUS, close};
use voxtrace::cull_hidden::{Hidden, cull_hidden};
use voxtrace::import::{self, Limits};
use voxtrace::material::MAX_MATERIALS;
use voxtrace::{Scene, voxelize};
use voxtrace_bench::quantity::counted;

/// Options for every scene.
#[derive(clap::Args, Clone, Debug, Default)]
#[command(next_help_heading = "Any scene")]
pub struct EditArgs {
    /// Close holes up to 2 N voxels wide: morphological closing with a cube of edge 2 N + 1
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=i64::from(LARGEST_RADIUS)))]
    close: Option<u32>,
    /// Remove voxels that are never visible: `buried` those between six others, `sealed` also the walls of closed cavities [default with no value: buried]
    #[arg(long, value_name = "WHAT", num_args = 0..=1, require_equals = true, default_missing_value = "buried")]
    excavate: Option<HiddenArg>,
    /// Map all colours to the nearest ones of this picture (PNG, JPEG)
    #[arg(long, value_name = "FILE")]
    palette_image: Option<PathBuf>,
    /// As many as the file to write may have.
    #[arg(skip)]
    pub most_colors: Option<usize>,
}

#[derive(Clone, Copy, Debug, clap::ValueEnum)]
enum HiddenArg {
    /// Voxels whose six neighbours are occupied
    Buried,
    /// Also the walls of closed cavities
    Sealed,
}

impl EditArgs {
    /// Most colours, where nobody says how many.
    pub fn most_colors(&self) -> usize {
        self.most_colors.unwrap_or(MAX_MATERIALS)
    }

    /// Whether anything is to be done that wants the scene in memory.
    pub fn is_asked(&self) -> bool {
        self.close.is_some() || self.excavate.is_some() || self.palette_image.is_some()
    }

    /// Whether anything is to be done to a scene that has its voxels.
    pub fn changes_voxels(&self, mesh: &MeshArgs) -> bool {
        self.is_asked() || mesh.palette().is_some() || mesh.dither
    }

    /// Does it.
    pub fn apply(&self, scene: &mut Scene, mesh: &MeshArgs, report: &Report) -> Result<(), Failure> {
        let most = mesh.palette().unwrap_or(self.most_colors());
        if let Some(radius) = self.close {
            let added = close(scene, radius);
            report.remark(&format!("{} set where there were holes", counted(added, "voxel")));
        }
        if let Some(path) = &self.palette_image {
            let texels = import::read_picture(path, &Limits::default()).map_err(|error| import_failure(&error))?;
            let colors = voxelize::colors_of_texels(&texels, most);
            if colors.is_empty() {
                return Err(Failure::input(format!("{}: every pixel is transparent", path.display())));
            }
            voxelize::recolor(scene, &colors, mesh.dither);
        } else if mesh.palette().is_some() || mesh.dither {
            voxelize::quantize_palette(scene, most, mesh.dither);
        }
        if let Some(hidden) = self.excavate {
            let hidden = match hidden {
                HiddenArg::Buried => Hidden::Buried,
                HiddenArg::Sealed => Hidden::Sealed,
            };
            let dropped = cull_hidden(scene, hidden)
                .map_err(|error| Failure::input(format!("{}: {error}", scene.name)).hint("--excavate=buried"))?;
            let left: u64 = scene.grids.iter().map(|grid| grid.count()).sum();
            report.remark(&format!("{} dropped, {left} left", counted(dropped, "hidden voxel")));
        }
        Ok(())
    }
}
