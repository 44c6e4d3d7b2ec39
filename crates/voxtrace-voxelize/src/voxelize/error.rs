//! Why a mesh, a cloud of points or a volume in its file cannot be voxelized.

use crate::import_error::{ImportError, ImportErrorKind};
use crate::volume::VolumeError;
use std::io;
use std::path::Path;
use voxtrace_core::packed::{PackError, StreamError};
use voxtrace_scene::Invalid;

/// Why a mesh, a cloud of points or a volume in its file cannot be voxelized.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum VoxelizeError {
    /// The arrays of the mesh contradict each other.
    #[error("the mesh is broken: {0}")]
    BadMesh(Invalid),
    /// There is no triangle with an area.
    #[error("the mesh has no surface")]
    Empty,
    /// The arrays of the cloud contradict each other.
    #[error("the points are broken: {0}")]
    BadPoints(Invalid),
    /// There is no point.
    #[error("there are no points")]
    NoPoints,
    /// No voxel has as many points as [`super::PointOptions::min_points`] asks for.
    #[error("no voxel has {0} points")]
    TooThin(u32),
    /// The points do not have the attribute that is to colour them.
    #[error("the points have no {0}")]
    Missing(&'static str),
    /// The size of a voxel is not a positive, finite number.
    #[error("{0} is no size of a voxel")]
    BadScale(f64),
    /// A limit is exceeded.
    #[error("{what}: {needed} is more than {limit}")]
    TooLarge {
        /// The limited quantity, for people.
        what: &'static str,
        /// How much of it there would be.
        needed: u64,
        /// How much is allowed or possible.
        limit: u64,
    },
    /// The work was cancelled through its progress.
    #[error("stopped")]
    Cancelled,
    /// The output, the checkpoint file or a temporary file could not be read or written.
    #[error("{0}")]
    Io(#[from] io::Error),
    /// The scene is too large for its file.
    #[error("{0}")]
    Pack(#[from] PackError),
    /// There is no grid for a volume, or nothing of it is to be seen.
    #[error("{0}")]
    Volume(#[from] VolumeError),
    /// What several processes have made of some files each does not belong together, or is damaged.
    #[error("{0}")]
    Parts(String),
    /// A file that is read while it is voxelized is damaged.
    #[error("{0}")]
    Import(#[from] ImportError),
}

impl From<StreamError> for VoxelizeError {
    fn from(error: StreamError) -> Self {
        match error {
            StreamError::Io(error) => Self::Io(error),
            StreamError::Pack(error) => Self::Pack(error),
        }
    }
}

impl VoxelizeError {
    /// The same error as one of importing the file at `path`, which held the model.
    pub fn into_import_error(self, path: &Path) -> ImportError {
        let kind = match self {
            Self::TooLarge { what, needed, limit } => {
                ImportErrorKind::Limit { what: what.into(), value: needed, limit }
            }
            Self::Io(error) => ImportErrorKind::Io(error),
            Self::Import(error) => return error,
            Self::Volume(error) => return error.into_import_error(path),
            Self::Cancelled => ImportErrorKind::Stopped,
            error => ImportErrorKind::Malformed(error.to_string()),
        };
        ImportError { path: path.into(), offset: None, kind }
    }
}
