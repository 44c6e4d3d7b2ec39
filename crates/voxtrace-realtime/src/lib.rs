//! Real-time light: pictures that are clean at one path a pixel, for windows. Frame after frame each pixel follows one path, which ends where
//! a [cache of light](LightCache) on the faces of voxels knows what comes from there; what the frames before [know](Memory) of a pixel is found again where
//! the camera or things moved; and a [filter](filter()) takes the noise that is left.
//!
//! What is shown so is an estimate. The film of the integrator, which fills as soon as nothing moves, is the picture; samples of here never enter it.
//!
//! ```
//! use voxtrace_core::{Frame, PackedScene};
//! use voxtrace_realtime::{Parts, RealTime};
//! use voxtrace_scene::{Camera, Instance, Material, Scene, VoxelGrid, glam::{IVec3, Vec3}, transform::Transform};
//!
//! let mut grid = VoxelGrid::default();
//! grid.set(IVec3::ZERO, 0);
//! let mut scene = Scene::new("a voxel");
//! scene.materials.push(Material::default());
//! scene.instances.push(Instance::new(0, Transform::IDENTITY));
//! scene.grids.push(grid.into());
//! let scene = PackedScene::pack(&scene)?;
//! let camera = Camera::look_at(Vec3::new(3.0, -4.0, 2.0), Vec3::splat(0.5));
//! let mut real_time = RealTime::new(Parts::ALL);
//! let picture = real_time.frame(&scene, &Frame::new(camera, 64, 36));
//! assert_eq!(picture.len(), 64 * 36);
//! # Ok::<(), voxtrace_core::packed::PackError>(())
//! ```

mod antialiasing;
mod confidence;
mod filter;
mod half_rate;
mod light_cache;
mod memory;
mod movers;
mod on_devices;
mod path;
mod real_time;
mod reprojection;
mod visibility;

pub use filter::filter;
pub use half_rate::Rate;
pub use light_cache::{Key, LightCache, Request};
pub use memory::Memory;
pub use path::{Sample, Shown, View};
pub use real_time::{Parts, RealTime};
pub use visibility::Visibility;

// For what makes the same pictures on devices: not covered by semantic versioning.
#[doc(hidden)]
pub use on_devices::{FramesOnDevice, RealTimeParams, flag, looks_of, slots, squares};

/// The example of the crate's page, tested.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
