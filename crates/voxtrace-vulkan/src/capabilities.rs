//! What each device can do, and why a traversal is missing where it is.

use crate::errors::Named;
use crate::vulkan::{Options, Vulkan};
use ash::{ext, khr, vk};
use std::ffi::CStr;
use voxtrace_core::TraceError;

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
    /// Invocations of a subgroup.
    pub subgroup_size: u32,
    /// Alignment of offsets in uniform buffers, bytes.
    pub uniform_alignment: u64,
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
    pub(crate) queue_family: u32,
    pub(crate) extensions: Vec<String>,
    pub(crate) scalar_layout: bool,
}

impl DeviceInfo {
    /// Whether its driver offers an extension.
    pub fn has_extension(&self, name: &str) -> bool {
        self.extensions.iter().any(|other| other == name)
    }

    pub(crate) fn has(&self, extension: &CStr) -> bool {
        extension.to_str().is_ok_and(|name| self.has_extension(name))
    }
}

/// All devices of this machine, in the order of the loader.
///
/// # Errors
/// [`TraceError::Unsupported`] where there is no Vulkan.
pub fn devices(options: Options) -> Result<Vec<DeviceInfo>, TraceError> {
    let vulkan = Vulkan::open(options)?;
    list(&vulkan)
}

/// All devices of an instance.
pub(crate) fn list(vulkan: &Vulkan) -> Result<Vec<DeviceInfo>, TraceError> {
    // SAFETY: the instance is alive.
    let physical = unsafe { vulkan.instance.enumerate_physical_devices() }.named("listing the devices")?;
    physical.into_iter().enumerate().map(|(index, physical)| describe(vulkan, index, physical)).collect()
}

fn describe(vulkan: &Vulkan, index: usize, physical: vk::PhysicalDevice) -> Result<DeviceInfo, TraceError> {
    let instance = &vulkan.instance;
    // SAFETY: the physical device is one of this instance, and so in every call below.
    let extensions = unsafe { instance.enumerate_device_extension_properties(physical) }.named("listing extensions")?;
    let extensions: Vec<String> = extensions
        .iter()
        .filter_map(|extension| extension.extension_name_as_c_str().ok())
        .map(|name| name.to_string_lossy().into_owned())
        .collect();
    let has = |name: &CStr| extensions.iter().any(|other| other.as_bytes() == name.to_bytes());

    let mut driver = vk::PhysicalDeviceDriverProperties::default();
    let mut subgroup = vk::PhysicalDeviceSubgroupProperties::default();
    let mut maintenance = vk::PhysicalDeviceMaintenance3Properties::default();
    let mut accel = vk::PhysicalDeviceAccelerationStructurePropertiesKHR::default();
    let mut pipeline = vk::PhysicalDeviceRayTracingPipelinePropertiesKHR::default();
    let mut properties = vk::PhysicalDeviceProperties2::default()
        .push_next(&mut driver)
        .push_next(&mut subgroup)
        .push_next(&mut maintenance);
    let has_accel = has(khr::acceleration_structure::NAME) && has(khr::deferred_host_operations::NAME);
    let has_pipeline = has(khr::ray_tracing_pipeline::NAME);
    let has_query = has(khr::ray_query::NAME);
    if has_accel {
        properties = properties.push_next(&mut accel);
    }
    if has_pipeline {
        properties = properties.push_next(&mut pipeline);
    }
    // SAFETY: the chain holds records that the device knows, alive until the call returns.
    unsafe { instance.get_physical_device_properties2(physical, &mut properties) };
    let base = properties.properties;

    let mut features12 = vk::PhysicalDeviceVulkan12Features::default();
    let mut accel_features = vk::PhysicalDeviceAccelerationStructureFeaturesKHR::default();
    let mut pipeline_features = vk::PhysicalDeviceRayTracingPipelineFeaturesKHR::default();
    let mut query_features = vk::PhysicalDeviceRayQueryFeaturesKHR::default();
    let mut features = vk::PhysicalDeviceFeatures2::default();
    if base.api_version >= vk::API_VERSION_1_2 {
        features = features.push_next(&mut features12);
    }
    if has_accel {
        features = features.push_next(&mut accel_features);
    }
    if has_pipeline {
        features = features.push_next(&mut pipeline_features);
    }
    if has_query {
        features = features.push_next(&mut query_features);
    }
    // SAFETY: as above.
    unsafe { instance.get_physical_device_features2(physical, &mut features) };
    // SAFETY: as above.
    let families = unsafe { instance.get_physical_device_queue_family_properties(physical) };
    // SAFETY: as above.
    let memory = unsafe { instance.get_physical_device_memory_properties(physical) };

    let family = families.iter().position(|family| family.queue_flags.contains(vk::QueueFlags::COMPUTE));
    let timestamp_bits = family.map_or(0, |family| families[family].timestamp_valid_bits);
    let walk_missing = if base.api_version < vk::API_VERSION_1_2 {
        Some("the driver has no Vulkan 1.2".to_owned())
    } else if family.is_none() {
        Some("no queue can compute".to_owned())
    } else if features12.timeline_semaphore == vk::FALSE {
        Some("no timeline semaphores".to_owned())
    } else {
        None
    };
    let lacks = |is_there: bool, name: &str| (!is_there).then(|| format!("no {name}"));
    let accel_missing = walk_missing.clone().or_else(|| {
        lacks(has_accel && accel_features.acceleration_structure == vk::TRUE, "VK_KHR_acceleration_structure")
            .or_else(|| lacks(features12.buffer_device_address == vk::TRUE, "bufferDeviceAddress"))
    });
    let query_missing =
        accel_missing.clone().or_else(|| lacks(has_query && query_features.ray_query == vk::TRUE, "VK_KHR_ray_query"));
    let pipeline_missing = accel_missing.clone().or_else(|| {
        lacks(has_pipeline && pipeline_features.ray_tracing_pipeline == vk::TRUE, "VK_KHR_ray_tracing_pipeline")
    });
    let heaps = &memory.memory_heaps[..memory.memory_heap_count as usize];
    let own = heaps.iter().filter(|heap| heap.flags.contains(vk::MemoryHeapFlags::DEVICE_LOCAL));
    let text = |bytes: &CStr| bytes.to_string_lossy().into_owned();
    let info_text = driver.driver_info_as_c_str().map(text).unwrap_or_default();
    Ok(DeviceInfo {
        index,
        name: base.device_name_as_c_str().map(text).unwrap_or_default(),
        kind: match base.device_type {
            vk::PhysicalDeviceType::DISCRETE_GPU => DeviceKind::Discrete,
            vk::PhysicalDeviceType::INTEGRATED_GPU => DeviceKind::Integrated,
            vk::PhysicalDeviceType::VIRTUAL_GPU => DeviceKind::Virtual,
            vk::PhysicalDeviceType::CPU => DeviceKind::Cpu,
            _ => DeviceKind::Other,
        },
        driver: format!("{} {info_text}", driver.driver_name_as_c_str().map(text).unwrap_or_default())
            .trim()
            .to_owned(),
        api_version: format!(
            "{}.{}.{}",
            vk::api_version_major(base.api_version),
            vk::api_version_minor(base.api_version),
            vk::api_version_patch(base.api_version)
        ),
        memory_bytes: own.map(|heap| heap.size).max().unwrap_or(0),
        limits: Limits {
            max_storage_buffer_range: base.limits.max_storage_buffer_range.into(),
            max_workgroups: base.limits.max_compute_work_group_count[0],
            max_workgroup_invocations: base.limits.max_compute_work_group_invocations,
            max_allocation_bytes: maintenance.max_memory_allocation_size,
            timestamp_period_ns: if timestamp_bits > 0 { base.limits.timestamp_period } else { 0.0 },
            subgroup_size: subgroup.subgroup_size,
            uniform_alignment: base.limits.min_uniform_buffer_offset_alignment,
        },
        ray_tracing: RayTracing {
            max_primitive_count: accel.max_primitive_count,
            max_instance_count: accel.max_instance_count,
            max_geometry_count: accel.max_geometry_count,
            scratch_alignment: accel.min_acceleration_structure_scratch_offset_alignment.into(),
            max_launch: pipeline.max_ray_dispatch_invocation_count.into(),
            handle_bytes: pipeline.shader_group_handle_size,
            handle_alignment: pipeline.shader_group_handle_alignment,
            table_alignment: pipeline.shader_group_base_alignment,
        },
        walk_missing,
        query_missing,
        pipeline_missing,
        physical,
        queue_family: family.unwrap_or(0) as u32,
        scalar_layout: features12.scalar_block_layout == vk::TRUE,
        extensions,
    })
}

/// Extensions that a device gets where it has them, whatever the traversal.
pub(crate) const WELCOME: [&CStr; 2] = [ext::memory_budget::NAME, ext::device_fault::NAME];
