//! What Vulkan answers, as errors of the tracer.

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

/// Gives results of Vulkan the context that our errors have.
pub trait ResultExt<T> {
    /// The value, or the error with the name of the step.
    fn context(self, step: &str) -> Result<T, TraceError>;
}

impl<T> ResultExt<T> for Result<T, vk::Result> {
    fn context(self, step: &str) -> Result<T, TraceError> {
        self.map_err(|result| failed(step, result))
    }
}

/// The error of an allocation of `needed` bytes where `available` are left.
pub fn not_allocated(available: u64, name: &str, needed: u64, error: &AllocationError) -> TraceError {
    match error {
        AllocationError::OutOfMemory | AllocationError::NoCompatibleMemoryTypeFound => {
            TraceError::OutOfMemory { needed, available }
        }
        other => TraceError::Device { step: format!("allocating {name}"), reason: other.to_string() },
    }
}
