//! Embree 3 for comparison: the same voxels as boxes of a user geometry, and as quads of their exposed faces.

#[allow(missing_docs)]
mod ffi;

mod boxes;
mod cast;
mod quads;
mod structure;

pub use boxes::Boxes;
pub use quads::Quads;
