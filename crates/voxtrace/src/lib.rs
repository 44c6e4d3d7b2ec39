//! voxtrace path traces voxel scenes. This crate is the library without a GPU and without a window: the scene model,
//! the importers, the packed structure that every tracer reads, and the CPU tracer.

pub mod brick;
pub mod camera;
pub mod close;
pub mod cpu;
pub mod edit;
pub mod excavate;
pub mod export;
pub mod film;
pub mod frame;
pub mod georeference;
pub mod grid;
pub mod import;
pub mod integrator;
pub mod layers;
pub mod light;
pub mod material;
pub mod math;
pub mod mesh;
pub mod nearest_centre;
pub mod output;
mod overview;
pub mod packed;
pub mod points;
pub mod ray;
pub mod sampler;
pub mod scene;
pub mod scenes;
pub mod sky;
pub mod surface;
pub mod tracer;
pub mod transform;
pub mod volume;
pub mod voxelize;
pub mod walk;

pub use brick::Brick;
pub use camera::Camera;
pub use cpu::CpuTracer;
pub use film::Film;
pub use frame::{Frame, Integrator, Region};
pub use grid::VoxelGrid;
pub use material::Material;
pub use mesh::Mesh;
pub use packed::{DeviceCells, PackedScene};
pub use ray::{Face, Hit, Ray};
pub use scene::{Instance, Scene};
pub use sky::{Sky, Sun};
pub use tracer::{Progress, TraceError, Tracer};
pub use transform::Transform;
pub use volume::Volume;

pub use glam;
