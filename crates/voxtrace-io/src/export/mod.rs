//! Writing scenes to files of other programs.

mod flat_color;
#[cfg(feature = "rasters")]
mod heights;
#[cfg(feature = "mesh")]
mod mesh;
pub mod native;
#[cfg(feature = "voxels")]
mod qubicle;
#[cfg(feature = "minecraft")]
mod sponge;
pub mod vox;
mod writers;

pub use writers::{MTL_HEAD, WRITERS, Writer, writer_of};

use std::path::PathBuf;
use voxtrace_voxelize::bake::BakeError;

/// A scene could not be written to a file.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ExportError {
    /// The operating system refused.
    #[error("{}: {error}", path.display())]
    Io {
        /// The file.
        path: PathBuf,
        /// What the system says.
        #[source]
        error: std::io::Error,
    },
    /// The format cannot place an instance so.
    #[error("instance {instance} {name:?}: {format} {reason}")]
    Placement {
        /// The format, for example `.vox`.
        format: &'static str,
        /// Index of the instance.
        instance: usize,
        /// Its name.
        name: String,
        /// What the format lacks.
        reason: &'static str,
    },
    /// The scene has no voxel, and the format no place for nothing.
    #[error("a {format} file needs at least one voxel that is visible")]
    Empty {
        /// The format.
        format: &'static str,
    },
    /// The scene does not fit the format.
    #[error("{what} do not fit {format}")]
    TooLarge {
        /// The format, for example `.vox`.
        format: &'static str,
        /// What is too much.
        what: &'static str,
    },
    /// Nobody wants the file any more: there is the old one, or none.
    #[error("stopped")]
    Stopped,
}

/// Whether somebody still wants what is written. It says no for good, and what was made meanwhile is then of no use.
type Wanted<'a> = &'a (dyn Fn() -> bool + Sync);

/// Goes on only where that is wanted.
fn go_on(wanted: Wanted) -> Result<(), ExportError> {
    if wanted() { Ok(()) } else { Err(ExportError::Stopped) }
}

/// What stands in the way of one lattice, as the failure of a format.
fn bake_failure(format: &'static str, error: BakeError) -> ExportError {
    match error {
        BakeError::OffLattice { instance, name } => {
            let reason = "has only quarter turns and mirrors, at scale 1 and whole voxels";
            ExportError::Placement { format, instance, name, reason }
        }
        BakeError::Stopped => ExportError::Stopped,
        _ => ExportError::TooLarge { format, what: "voxels so far apart" },
    }
}
