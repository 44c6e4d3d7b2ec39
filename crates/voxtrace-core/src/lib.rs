//! What traces: the packed scene that every tracer reads, the exact walk, light transport, the film, and the CPU tracer.

pub mod aov;
pub mod atomic_file;
pub mod bsdf;
pub mod cpu;
pub mod film;
pub mod frame;
pub mod integrator;
pub mod light;
pub mod math;
pub mod nearest_centre;
mod overview;
pub mod packed;
pub mod sampler;
pub mod surface;
pub mod tracer;
pub mod walk;

pub use cpu::CpuTracer;
pub use film::Film;
pub use frame::{Frame, Integrator, Region};
pub use packed::{DeviceCells, Geometry, PackedScene, Placement};
pub use tracer::{Progress, TraceError, Tracer};

/// The example of the crate's page, tested.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
