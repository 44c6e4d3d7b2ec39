//! The editable scene: sparse voxel grids, and the scene that places them, with materials, cameras and sky.

#![forbid(unsafe_code)]

// One thread has no work to divide.
#[cfg(target_arch = "wasm32")]
extern crate voxtrace_serial as rayon;

pub mod animation;
pub mod brick;
pub mod camera;
mod edit;
/// For the meshes and acceleration structures of other crates of voxtrace: not covered by semantic versioning.
#[doc(hidden)]
pub mod faces;
pub mod georeference;
pub mod grid;
mod invalid;
mod length_unit;
pub mod material;
/// For the quantization of colours in other crates of voxtrace: not covered by semantic versioning.
#[doc(hidden)]
pub mod oklab;
pub mod ray;
pub mod scene;
mod shape;
pub mod sky;
pub mod transform;
/// For the lights and lenses of other crates of voxtrace: not covered by semantic versioning.
#[doc(hidden)]
pub mod trigonometry;

pub use animation::Animation;
pub use brick::Brick;
pub use camera::{Camera, Lens};
pub use grid::VoxelGrid;
pub use invalid::Invalid;
pub use material::Material;
pub use ray::{Face, Hit, Ray};
pub use scene::{Instance, Scene};
pub use shape::Shape;
pub use sky::{Sky, Sun};
pub use transform::{Axis, Transform};

pub use glam;

/// The example of the crate's page, tested.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
