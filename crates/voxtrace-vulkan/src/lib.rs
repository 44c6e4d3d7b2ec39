//! The GPU tracers of voxtrace, on Vulkan. [`VulkanTracer`] fulfils the contract of [`voxtrace_core::Tracer`] with a walk
//! in a compute shader or with the device's ray tracing hardware.
#![allow(unsafe_code, reason = "Vulkan is a C interface; each block says why it is sound")]

mod accel;
mod allocations;
mod barrier;
mod bindings;
mod buffer;
mod capabilities;
mod choose;
mod commands;
mod device;
mod errors;
#[cfg(feature = "faults")]
mod faults;
mod film;
mod listing;
mod method;
mod pages;
mod passes;
mod picture;
mod ray_program;
mod real_time;
mod scene;
mod schedule;
mod shared;
mod spirv;
mod statistics;
mod tracer;
mod transfer;
mod variant;
mod vulkan;
mod watch;
mod waves;
mod worker;

// For the other crates of voxtrace and their tests: not covered by semantic versioning.
#[doc(hidden)]
pub mod probe;
#[doc(hidden)]
pub mod records;
#[doc(hidden)]
pub mod selftest;

pub use accel::AccelReport;
pub use allocations::MemoryReport;
pub use capabilities::{DeviceInfo, DeviceKind, Limits, RayTracing, missing};
pub use choose::{Choice, Request, choose, choose_for};
pub use device::Device;
#[cfg(feature = "faults")]
#[doc(hidden)]
pub use faults::{Fault, Faults};
pub use listing::devices;
pub use method::{Primitive, Settings, Traversal};
pub use picture::{BLUE_LOWEST, DISPLAY_BINDING, PICTURE_BINDING, Picture, PresentParams, Tone, Under};
pub use real_time::{Rate, RealTimeFrame};
pub use shared::SharedTracer;
pub use statistics::Statistics;
pub use tracer::VulkanTracer;
pub use vulkan::{Messages, Options, Vulkan};

/// The shaders that show a [`Picture`] in a window, SPIR-V: the entry point `present_curve` takes the picture at [`PICTURE_BINDING`] of
/// set 0 through the curve to [`DISPLAY_BINDING`], a row of workgroups of 64 pixels for each of its rows; `present_vertex` and
/// `present_fragment` draw that. [`PresentParams`] are the push constants of all of them.
pub fn present_shader() -> Vec<u32> {
    spirv::PRESENT.words()
}

/// The example of the crate's page, tested.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
