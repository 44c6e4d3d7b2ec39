//! What Vulkan answers, as errors of the tracer.

use crate::device::Device;
use ash::vk;
use gpu_allocator::AllocationError;
use voxtrace_core::TraceError;

/// The error of a call that `step` names.
pub fn failed(step: &str, result: vk::Result) -> TraceError {
    match result {
        vk::Result::ERROR_DEVICE_LOST => TraceError::DeviceLost { last_pass: step.into() },
        vk::Result::ERROR_OUT_OF_DEVICE_MEMORY => {
            TraceError::Device { step: step.into(), reason: "the device has no memory left".into() }
        }
        vk::Result::ERROR_OUT_OF_HOST_MEMORY => {
            TraceError::Device { step: step.into(), reason: "the driver finds no memory on the host".into() }
        }
        other => TraceError::Device { step: step.into(), reason: other.to_string() },
    }
}

/// Turns the result of a call that `step` names into ours.
pub trait Named<T> {
    /// The value, or the error with the name of the step.
    fn named(self, step: &str) -> Result<T, TraceError>;
}

impl<T> Named<T> for Result<T, vk::Result> {
    fn named(self, step: &str) -> Result<T, TraceError> {
        self.map_err(|result| failed(step, result))
    }
}

/// The error of an allocation of `needed` bytes.
pub fn not_allocated(device: &Device, name: &str, needed: u64, error: &AllocationError) -> TraceError {
    match error {
        AllocationError::OutOfMemory | AllocationError::NoCompatibleMemoryTypeFound => {
            TraceError::OutOfMemory { needed, available: device.available_bytes() }
        }
        other => TraceError::Device { step: format!("allocating {name}"), reason: other.to_string() },
    }
}
