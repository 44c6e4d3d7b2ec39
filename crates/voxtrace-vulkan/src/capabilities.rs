//! What a device can do, and why a traversal is missing where it is.

use crate::method::Traversal;
use ash::{ext, khr, vk};
use std::ffi::CStr;

/// Kinds of device, best first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum DeviceKind {
    /// A card of its own.
    Discrete,
    /// Part of the processor's chip.
    Integrated,
    /// A share of a card in another machine.
    Virtual,
    /// Anything else.
    Other,
    /// Software on the processor, for example lavapipe.
    Cpu,
}

impl DeviceKind {
    /// Name for people and files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Discrete => "discrete",
            Self::Integrated => "integrated",
            Self::Virtual => "virtual",
            Self::Other => "other",
            Self::Cpu => "software",
        }
    }
}

/// What the device answered about its limits.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Limits {
    /// Largest range of one storage buffer, bytes.
    pub max_storage_buffer_range: u64,
    /// Most workgroups of a dispatch along x.
    pub max_workgroups: u32,
    /// Most invocations that a workgroup may have.
    pub max_workgroup_invocations: u32,
    /// Most bytes of one memory allocation.
    pub max_allocation_bytes: u64,
    /// Nanoseconds of one tick of the device's clock; 0 where the queue has no clock.
    pub timestamp_period_ns: f32,
    /// Bits of that clock: past the last of them it begins anew at 0, on some GPUs once an hour.
    pub timestamp_bits: u32,
    /// Invocations of a subgroup.
    pub subgroup_size: u32,
    /// Alignment of offsets in uniform buffers, bytes.
    pub uniform_alignment: u64,
}

impl Limits {
    /// Largest storage buffer, bytes: it must lie in one allocation, which some drivers bound lower.
    pub(crate) fn max_storage_bytes(&self) -> u64 {
        self.max_storage_buffer_range.min(self.max_allocation_bytes)
    }

    /// Milliseconds between two readings of the device's clock.
    pub fn milliseconds_between(&self, first: u64, last: u64) -> f64 {
        let all_bits = u64::MAX.checked_shr(64 - self.timestamp_bits.min(64)).unwrap_or(0);
        (last.wrapping_sub(first) & all_bits) as f64 * f64::from(self.timestamp_period_ns) * 1e-6
    }
}

/// Limits of ray tracing, 0 where it is missing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct RayTracing {
    /// Most primitives of one acceleration structure.
    pub max_primitive_count: u64,
    /// Most instances of one acceleration structure.
    pub max_instance_count: u64,
    /// Most geometries of one acceleration structure.
    pub max_geometry_count: u64,
    /// Alignment of scratch memory, bytes.
    pub scratch_alignment: u64,
    /// Most rays of one launch of a pipeline.
    pub max_launch: u64,
    /// Bytes of a shader group handle, alignment of handles and of tables.
    pub handle_bytes: u32,
    /// Alignment of handles within a table.
    pub handle_alignment: u32,
    /// Alignment of tables.
    pub table_alignment: u32,
}

/// One device, as it describes itself.
#[derive(Clone, Debug)]
pub struct DeviceInfo {
    /// Number for `--device`, in the order of the loader.
    pub index: usize,
    /// Its name.
    pub name: String,
    /// Its kind.
    pub kind: DeviceKind,
    /// Name and version of its driver.
    pub driver: String,
    /// Version of Vulkan, for example "1.3.277".
    pub api_version: String,
    /// Bytes of the memory that is its own.
    pub memory_bytes: u64,
    /// Limits.
    pub limits: Limits,
    /// Limits of ray tracing.
    pub ray_tracing: RayTracing,
    /// Why the compute walk cannot run, `None` where it can.
    pub walk_missing: Option<String>,
    /// Why ray queries cannot run.
    pub query_missing: Option<String>,
    /// Why ray tracing pipelines cannot run.
    pub pipeline_missing: Option<String>,
    pub(crate) physical: vk::PhysicalDevice,
    /// What tells it from others of its name, wherever the loader lists it; zeros before Vulkan 1.1.
    pub(crate) uuid: [u8; vk::UUID_SIZE],
    pub(crate) queue_family: u32,
    /// Queues of that family.
    pub(crate) queue_count: u32,
    /// Whether they draw as well.
    pub(crate) has_graphics: bool,
    pub(crate) extensions: Vec<String>,
    pub(crate) scalar_layout: bool,
}

impl DeviceInfo {
    /// Whether its driver offers an extension.
    pub fn has_extension(&self, name: &str) -> bool {
        self.extensions.iter().any(|other| other == name)
    }

    /// The family of the queue that traces and presents.
    pub fn queue_family(&self) -> u32 {
        self.queue_family
    }

    /// The device itself, for whoever makes a surface for it.
    pub fn physical(&self) -> vk::PhysicalDevice {
        self.physical
    }

    /// Whether windows can be drawn: the queue that traces draws too, and the driver has swapchains.
    pub fn presents(&self) -> bool {
        self.has_graphics && self.has(khr::swapchain::NAME)
    }

    pub(crate) fn has(&self, extension: &CStr) -> bool {
        extension.to_str().is_ok_and(|name| self.has_extension(name))
    }
}

/// Extensions that a device gets where it has them, whatever the traversal. The last one must be enabled where it is offered: by drivers that are not
/// Vulkan in full, such as MoltenVK.
pub(crate) const WELCOME: [&CStr; 3] =
    [ext::memory_budget::NAME, ext::device_fault::NAME, khr::portability_subset::NAME];

/// Why a device lacks a traversal, `None` where it has it.
pub fn missing(info: &DeviceInfo, traversal: Traversal) -> Option<&str> {
    match traversal {
        Traversal::Cpu => None,
        Traversal::Walk => info.walk_missing.as_deref(),
        Traversal::Query => info.query_missing.as_deref(),
        Traversal::Pipeline => info.pipeline_missing.as_deref(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_clock_that_begins_anew_between_two_readings_gives_the_time_between_them() {
        let of = |timestamp_bits| Limits { timestamp_period_ns: 2.0, timestamp_bits, ..Limits::default() };
        for bits in [36, 63, 64] {
            let last = u64::MAX >> (64 - bits);
            assert_eq!(of(bits).milliseconds_between(5, 1_000_005), 2.0, "{bits} bits");
            assert_eq!(of(bits).milliseconds_between(last - 499_999, 500_000), 2.0, "{bits} bits");
        }
        assert_eq!(of(0).milliseconds_between(5, 7), 0.0);
    }

    #[test]
    fn a_storage_buffer_is_no_larger_than_a_binding_and_an_allocation() {
        let of = |max_storage_buffer_range, max_allocation_bytes| {
            Limits { max_storage_buffer_range, max_allocation_bytes, ..Limits::default() }.max_storage_bytes()
        };
        assert_eq!((of(u32::MAX.into(), 1 << 31), of(1 << 27, 1 << 31)), (1 << 31, 1 << 27));
    }
}
