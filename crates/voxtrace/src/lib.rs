//! voxtrace path traces voxel scenes. This crate is the library without a GPU and without a window: the scene model,
//! the importers, the packed structure that every tracer reads, and the CPU tracer.

#![forbid(unsafe_code)]

pub use voxtrace_core::{
    CpuTracer, DeviceCells, Film, Frame, Integrator, PackedScene, Progress, Region, TraceError, Tracer,
};
pub use voxtrace_core::{
    atomic_file, cpu, film, frame, integrator, layers, light, math, nearest_centre, packed, sampler, surface, tracer,
    walk,
};
pub use voxtrace_io::{export, import, output};
pub use voxtrace_scene::{
    Brick, Camera, Face, Hit, Instance, Material, Ray, Scene, Sky, Sun, Transform, VoxelGrid, glam,
};
pub use voxtrace_scene::{brick, camera, edit, georeference, grid, material, oklab, ray, scene, sky, transform};
pub use voxtrace_scenes as scenes;
pub use voxtrace_voxelize::{Mesh, Volume};
pub use voxtrace_voxelize::{close, excavate, mesh, points, volume, voxelize};
