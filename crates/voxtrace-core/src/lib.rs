//! What traces: the packed scene that every tracer reads, the exact walk, light transport, the film, and the CPU tracer.

// One thread has no work to divide.
#[cfg(target_arch = "wasm32")]
extern crate voxtrace_serial as rayon;

mod bounce_limits;
pub mod changes;
mod cpu;
mod crops;
pub mod cuts;
pub mod denoise;
pub mod dynamic;
pub mod film;
pub mod frame;
mod light_group;
pub mod lines;
pub mod meanwhile;
pub mod motion;
pub mod normals;
mod overview;
pub mod packed;
mod portrait;
mod region;
pub mod surroundings;
mod trace_error;
pub mod tracer;

// How tracing works inside, for the other crates of voxtrace and their tests: not covered by semantic versioning.
#[doc(hidden)]
pub mod aov;
#[doc(hidden)]
pub mod atomic_file;
#[doc(hidden)]
pub mod bsdf;
#[doc(hidden)]
pub mod frame_params;
#[doc(hidden)]
pub mod held_film;
#[doc(hidden)]
pub mod integrator;
#[doc(hidden)]
pub mod light;
#[doc(hidden)]
pub mod math;
#[doc(hidden)]
pub mod medium;
#[doc(hidden)]
pub mod nearest_centre;
#[doc(hidden)]
pub mod sampler;
#[doc(hidden)]
pub mod shadow_catcher;
#[doc(hidden)]
pub mod surface;
#[doc(hidden)]
pub mod walk;

pub use bounce_limits::BounceLimits;
pub use cpu::{CpuTracer, RayCounts};
pub use dynamic::{DynamicScene, Edit, EditError, Patch};
pub use film::Film;
pub use frame::{Frame, Integrator, Region};
pub use light_group::LightGroup;
pub use packed::{Geometry, PackedScene, Placement};
pub use tracer::{Progress, TraceError, Tracer};
pub use walk::{Instructions, WalkCounts};

/// The example of the crate's page, tested.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
