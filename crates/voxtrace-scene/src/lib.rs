//! What a person edits: sparse voxel grids and the scene that places them, with materials, cameras and light from the sky.

#![forbid(unsafe_code)]

pub mod brick;
pub mod camera;
pub mod edit;
pub mod georeference;
pub mod grid;
pub mod material;
pub mod oklab;
pub mod ray;
pub mod scene;
pub mod sky;
pub mod transform;

pub use brick::Brick;
pub use camera::Camera;
pub use grid::VoxelGrid;
pub use material::Material;
pub use ray::{Face, Hit, Ray};
pub use scene::{Instance, Scene};
pub use sky::{Sky, Sun};
pub use transform::Transform;

pub use glam;
