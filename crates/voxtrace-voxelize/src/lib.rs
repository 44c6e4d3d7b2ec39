//! Surfaces, clouds of points and volumes become voxels, larger than memory if need be.

#![forbid(unsafe_code)]

pub mod close;
pub mod excavate;
mod import_error;
mod limits;
pub mod mesh;
pub mod points;
pub mod volume;
pub mod voxelize;

pub use import_error::{ImportError, ImportErrorKind};
pub use limits::Limits;
pub use mesh::Mesh;
pub use volume::Volume;
