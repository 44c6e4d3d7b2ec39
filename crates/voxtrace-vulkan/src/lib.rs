//! The GPU tracers of voxtrace, on Vulkan. [`VulkanTracer`] fulfils the contract of [`voxtrace_core::Tracer`] with a walk
//! in a compute shader or with the device's ray tracing hardware.
#![allow(unsafe_code, reason = "Vulkan is a C interface; each block says why it is sound")]

mod accel;
mod bindings;
mod buffer;
mod capabilities;
mod choose;
mod commands;
mod device;
mod errors;
mod faults;
mod film;
mod memory;
mod method;
mod passes;
pub mod probe;
mod ray_program;
pub mod records;
mod scene;
mod schedule;
pub mod selftest;
mod spirv;
mod tracer;
mod transfer;
mod vulkan;
mod worker;

pub use accel::AccelReport;
pub use capabilities::{DeviceInfo, DeviceKind, Limits, RayTracing, devices};
pub use choose::{Choice, Request, choose, missing};
pub use device::Device;
pub use faults::{Fault, Faults};
pub use memory::MemoryReport;
pub use method::{Primitive, Traversal};
pub use tracer::{Settings, VulkanTracer};
pub use vulkan::{Messages, Options, Vulkan};
pub use worker::Statistics;
