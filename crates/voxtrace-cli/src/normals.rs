//! With which normals surfaces are shaded, as an option.

use crate::failure::Failure;
use voxtrace::PackedScene;
use voxtrace::normals::Normals;

/// [`Normals`] as an option.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum NormalsArg {
    /// Those of the cubes: for art and Minecraft
    Faces,
    /// Those of the smooth surface that the voxels were made of, estimated from them: for scans and terrain
    Smooth,
}

impl From<NormalsArg> for Normals {
    fn from(name: NormalsArg) -> Self {
        match name {
            NormalsArg::Faces => Self::Faces,
            NormalsArg::Smooth => Self::Smooth,
        }
    }
}

/// The scene with the normals that are asked for, else those that it has.
pub fn with_normals(packed: PackedScene, asked: Option<NormalsArg>) -> Result<PackedScene, Failure> {
    let Some(normals) = asked.map(Normals::from).filter(|&normals| normals != packed.normals()) else {
        return Ok(packed);
    };
    packed.with_normals(normals).map_err(|error| Failure::input(format!("{}: {error}", packed.name)))
}
