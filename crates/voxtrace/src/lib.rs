//! voxtrace path traces voxel scenes. This crate is the library without a GPU and without a window: the scene model,
//! the importers, the packed structure that every tracer reads, and the CPU tracer.

#![forbid(unsafe_code)]

#[cfg(feature = "pictures")]
mod renderer;

#[cfg(feature = "pictures")]
pub use renderer::{Picture, RenderError, Renderer};
pub use voxtrace_core::{
    BounceLimits, CpuTracer, DynamicScene, Edit, EditError, Film, Frame, Geometry, Instructions, Integrator,
    LightGroup, PackedScene, Patch, Placement, Progress, RayCounts, Region, TraceError, Tracer, WalkCounts,
};
pub use voxtrace_core::{
    changes, cuts, denoise, dynamic, film, frame, lines, meanwhile, motion, normals, surroundings, tracer,
};
#[cfg(feature = "pictures")]
pub use voxtrace_io::difference;
pub use voxtrace_io::{export, import, output};
pub use voxtrace_scene::{
    Animation, Axis, Brick, Camera, Face, Hit, Instance, Invalid, Material, Ray, Scene, Shape, Sky, Sun, Transform,
    VoxelGrid, glam,
};
pub use voxtrace_scene::{animation, brick, camera, georeference, grid, material, ray, scene, sky, transform};
pub use voxtrace_scenes as scenes;
pub use voxtrace_voxelize::{Mesh, Volume};
pub use voxtrace_voxelize::{bake, close, cull_hidden, mesh, points, straighten, volume, voxelize};

/// The packed scene: how it is placed, saved and described. Its arrays are for tracers and not public.
pub mod packed {
    pub use voxtrace_core::packed::{
        BrickSource, FileError, FileErrorKind, Geometry, LevelCount, LevelListener, LevelProgress, LevelStep,
        LevelSummary, Levels, MAGIC, MAX_LEVELS, Object, Outline, PackError, PackedGrid, PackedInstance,
        PackedMaterial, PackedScene, Placement, PlacementError, Statistics, StreamError, add_levels, save_streamed,
    };
    // Nothing compresses in pages.
    #[cfg(not(target_arch = "wasm32"))]
    pub use voxtrace_core::packed::rewrite_for_streaming;
}

/// The example of the crate's page, tested.
#[cfg(all(doctest, feature = "pictures"))]
#[doc = include_str!("../README.md")]
struct Readme;
