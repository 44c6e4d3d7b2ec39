//! Errors planted into Vulkan's function table, for tests.

use ash::vk;

/// An error to answer with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fault {
    /// The device is lost, for good.
    DeviceLost,
}

/// What to plant.
#[derive(Debug, Default)]
pub struct Faults {}

pub fn instance_with_faults(_: &ash::Entry, instance: ash::Instance, _: &Faults) -> ash::Instance {
    let _ = vk::Result::SUCCESS;
    instance
}
