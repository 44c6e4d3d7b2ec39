//! Files of voxels on the command line: Minecraft's builds and worlds.

use crate::failure::Failure;
use crate::load::import_failure;
use crate::mesh::MeshArgs;
use crate::report::Report;
use std::path::Path;
use voxtrace::Scene;
use voxtrace::import;

/// Reads the voxels of a file and says what was left out.
pub fn scene(path: &Path, mesh: &MeshArgs, report: &Report) -> Result<Scene, Failure> {
    let voxels = import::read_voxels(path, &mesh.import_options()).map_err(|error| import_failure(&error))?;
    for note in &voxels.notes {
        report.warn(&format!("{}: {note}", path.display()));
    }
    Ok(voxels.scene)
}
