//! Voxelization of meshes, clouds of points and volumes, in memory or out of core, and edits of whole scenes.

#![forbid(unsafe_code)]

// One thread has no work to divide.
#[cfg(target_arch = "wasm32")]
extern crate voxtrace_serial as rayon;

pub mod bake;
pub mod close;
pub mod cull_hidden;
mod fields;
mod import_error;
mod limits;
pub mod mesh;
pub mod points;
mod read_at;
pub mod straighten;
pub mod volume;
pub mod voxelize;

pub use import_error::{ImportError, ImportErrorKind, Stopped};
pub use limits::Limits;
pub use mesh::Mesh;
pub use volume::Volume;

/// The example of the crate's page, tested.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
