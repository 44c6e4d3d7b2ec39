//! The table of formats that scenes are written to, besides voxtrace's own, which holds packed scenes.

use super::{ExportError, Wanted, vox};
use std::path::{Path, PathBuf};
use voxtrace_scene::scene::Scene;

/// A format that scenes are written to.
pub struct Writer {
    /// Extension of its files.
    pub extension: &'static str,
    /// Most colours that it can have.
    pub most_colors: Option<usize>,
    /// Whether every voxel must stand on the lattice of the world.
    pub needs_lattice: bool,
    /// Whether the file has the scene's voxels, or their surface; a heightmap has not.
    pub keeps_voxels: bool,
    companions: fn(&Path) -> Vec<PathBuf>,
    write: Write,
}

/// Writes a scene as long as it is wanted.
type Write = fn(&Path, &Scene, Wanted) -> Result<Vec<String>, ExportError>;

/// First line of the materials that are written beside an `.obj` file: it says whose file that is.
pub const MTL_HEAD: &str = "# materials of voxtrace";
/// Most colours of a `.vox` file.
const VOX_COLORS: usize = 255;

/// All of them.
pub const WRITERS: &[Writer] = &[
    Writer { most_colors: Some(VOX_COLORS), ..Writer::new("vox", vox::write_while) },
    #[cfg(feature = "mesh")]
    Writer { needs_lattice: false, ..Writer::new("glb", super::mesh::write_glb) },
    #[cfg(feature = "mesh")]
    Writer {
        needs_lattice: false,
        companions: super::mesh::obj_companions,
        ..Writer::new("obj", super::mesh::write_obj)
    },
    #[cfg(feature = "mesh")]
    Writer { needs_lattice: false, ..Writer::new("ply", super::mesh::write_ply) },
    #[cfg(feature = "voxels")]
    Writer::new("qb", super::qubicle::write),
    #[cfg(feature = "minecraft")]
    Writer::new("schem", super::sponge::write),
    #[cfg(feature = "rasters")]
    Writer { keeps_voxels: false, ..Writer::new("asc", super::heights::write_asc) },
    #[cfg(all(feature = "rasters", feature = "pictures"))]
    Writer { keeps_voxels: false, ..Writer::new("png", super::heights::write_png) },
];

/// The writer of a file, by its extension.
pub fn writer_of(path: &Path) -> Option<&'static Writer> {
    let extension = path.extension()?;
    WRITERS.iter().find(|writer| extension.eq_ignore_ascii_case(writer.extension))
}

impl Writer {
    const fn new(extension: &'static str, write: Write) -> Self {
        let companions: fn(&Path) -> Vec<PathBuf> = |_| Vec::new();
        Self { extension, most_colors: None, needs_lattice: true, keeps_voxels: true, companions, write }
    }

    /// The files that are written besides, under names that follow from that of the file.
    pub fn companions(&self, path: &Path) -> Vec<PathBuf> {
        (self.companions)(path)
    }

    /// Writes the visible part of a scene, whole or not at all; `.vox` files have what is hidden, too. Returns what the file does not hold,
    /// one phrase each.
    ///
    /// # Errors
    /// If the file cannot be written, or the scene does not fit the format.
    pub fn write(&self, path: &Path, scene: &Scene) -> Result<Vec<String>, ExportError> {
        self.write_while(path, scene, &|| true)
    }

    /// As [`Self::write`], as long as it is `wanted`, which several threads ask, and which says no for good: once it is not, writing ends soon, and the
    /// old file is untouched.
    ///
    /// # Errors
    /// As [`Self::write`], and [`ExportError::Stopped`].
    pub fn write_while(
        &self,
        path: &Path,
        scene: &Scene,
        wanted: &(dyn Fn() -> bool + Sync),
    ) -> Result<Vec<String>, ExportError> {
        let written = (self.write)(path, scene, wanted);
        // Files say it in their own way.
        written.map_err(|error| if wanted() { error } else { ExportError::Stopped })
    }
}
