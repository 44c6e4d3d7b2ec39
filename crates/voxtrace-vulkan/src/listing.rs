//! The devices of a machine, as their drivers describe them.

use crate::bindings::storage_bindings;
use crate::capabilities::{DeviceInfo, DeviceKind, Limits, RayTracing};
use crate::errors::ResultExt;
use crate::vulkan::{Options, Vulkan};
use ash::{khr, vk};
use std::ffi::CStr;
use voxtrace_core::TraceError;

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
    let physical = unsafe { vulkan.instance.enumerate_physical_devices() }.map_err(|error| TraceError::Device {
        step: "listing the devices".into(),
        // One driver that fails is enough for some loaders.
        reason: format!("{error}; with VK_LOADER_DEBUG=error in the environment Vulkan's loader says which driver"),
    })?;
    Ok(physical.into_iter().enumerate().map(|(index, physical)| describe(vulkan, index, physical)).collect())
}

/// A device, also where its driver fails when it is asked: others may do.
fn describe(vulkan: &Vulkan, index: usize, physical: vk::PhysicalDevice) -> DeviceInfo {
    let instance = &vulkan.instance;
    let (extensions, failure) = match Extensions::of(instance, physical) {
        Ok(extensions) => (extensions, None),
        Err(error) => (Extensions::default(), Some(error.to_string())),
    };
    let properties = Properties::of(instance, physical, &extensions);
    let base = properties.base;
    let features = Features {
        storage_buffers: storage_buffers(&base.limits),
        ..Features::of(instance, physical, &extensions, base.api_version)
    };
    // SAFETY: the physical device is one of this instance.
    let families = unsafe { instance.get_physical_device_queue_family_properties(physical) };
    // SAFETY: as above.
    let memory = unsafe { instance.get_physical_device_memory_properties(physical) };
    let family = families.iter().position(|family| family.queue_flags.contains(vk::QueueFlags::COMPUTE));
    let own_family = family.map(|family| families[family]).unwrap_or_default();
    let timestamp_bits = own_family.timestamp_valid_bits;
    let missing = missing(base.api_version, family.is_some(), &features);
    let [walk_missing, query_missing, pipeline_missing] = missing.map(|lacks| failure.clone().or(lacks));
    let heaps = &memory.memory_heaps[..memory.memory_heap_count as usize];
    let own = heaps.iter().filter(|heap| heap.flags.contains(vk::MemoryHeapFlags::DEVICE_LOCAL));
    DeviceInfo {
        index,
        name: base.device_name_as_c_str().map(text).unwrap_or_default(),
        kind: match base.device_type {
            vk::PhysicalDeviceType::DISCRETE_GPU => DeviceKind::Discrete,
            vk::PhysicalDeviceType::INTEGRATED_GPU => DeviceKind::Integrated,
            vk::PhysicalDeviceType::VIRTUAL_GPU => DeviceKind::Virtual,
            vk::PhysicalDeviceType::CPU => DeviceKind::Cpu,
            _ => DeviceKind::Other,
        },
        driver: properties.driver,
        api_version: format!(
            "{}.{}.{}",
            vk::api_version_major(base.api_version),
            vk::api_version_minor(base.api_version),
            vk::api_version_patch(base.api_version)
        ),
        memory_bytes: own.map(|heap| heap.size).max().unwrap_or(0),
        limits: Limits {
            timestamp_period_ns: if timestamp_bits > 0 { base.limits.timestamp_period } else { 0.0 },
            timestamp_bits,
            ..properties.limits
        },
        ray_tracing: properties.ray_tracing,
        walk_missing,
        query_missing,
        pipeline_missing,
        physical,
        uuid: properties.uuid,
        queue_family: family.unwrap_or(0) as u32,
        queue_count: own_family.queue_count,
        has_graphics: own_family.queue_flags.contains(vk::QueueFlags::GRAPHICS),
        scalar_layout: features.scalar_layout,
        extensions: extensions.names,
    }
}

fn text(bytes: &CStr) -> String {
    bytes.to_string_lossy().into_owned()
}

/// The extensions that a driver offers.
#[derive(Default)]
struct Extensions {
    names: Vec<String>,
    has_acceleration: bool,
    has_pipelines: bool,
    has_queries: bool,
}

impl Extensions {
    fn of(instance: &ash::Instance, physical: vk::PhysicalDevice) -> Result<Self, TraceError> {
        // SAFETY: the physical device is one of this instance.
        let found =
            unsafe { instance.enumerate_device_extension_properties(physical) }.context("listing extensions")?;
        let names: Vec<String> =
            found.iter().filter_map(|extension| extension.extension_name_as_c_str().ok()).map(text).collect();
        let has = |name: &CStr| names.iter().any(|other| other.as_bytes() == name.to_bytes());
        Ok(Self {
            has_acceleration: has(khr::acceleration_structure::NAME) && has(khr::deferred_host_operations::NAME),
            has_pipelines: has(khr::ray_tracing_pipeline::NAME),
            has_queries: has(khr::ray_query::NAME),
            names,
        })
    }
}

/// What a driver says of itself and its limits.
struct Properties {
    base: vk::PhysicalDeviceProperties,
    /// Name and version.
    driver: String,
    uuid: [u8; vk::UUID_SIZE],
    /// Limits, the clock's left out.
    limits: Limits,
    ray_tracing: RayTracing,
}

impl Properties {
    fn of(instance: &ash::Instance, physical: vk::PhysicalDevice, extensions: &Extensions) -> Self {
        let mut driver = vk::PhysicalDeviceDriverProperties::default();
        let mut subgroup = vk::PhysicalDeviceSubgroupProperties::default();
        let mut maintenance = vk::PhysicalDeviceMaintenance3Properties::default();
        let mut accel = vk::PhysicalDeviceAccelerationStructurePropertiesKHR::default();
        let mut pipeline = vk::PhysicalDeviceRayTracingPipelinePropertiesKHR::default();
        let mut ids = vk::PhysicalDeviceIDProperties::default();
        let mut properties = vk::PhysicalDeviceProperties2::default()
            .push_next(&mut ids)
            .push_next(&mut driver)
            .push_next(&mut subgroup)
            .push_next(&mut maintenance);
        if extensions.has_acceleration {
            properties = properties.push_next(&mut accel);
        }
        if extensions.has_pipelines {
            properties = properties.push_next(&mut pipeline);
        }
        // SAFETY: the physical device is one of this instance; the chain holds records that it knows, alive until the call
        // returns.
        unsafe { instance.get_physical_device_properties2(physical, &mut properties) };
        let base = properties.properties;
        let info = driver.driver_info_as_c_str().map(text).unwrap_or_default();
        let name = driver.driver_name_as_c_str().map(text).unwrap_or_default();
        Self {
            base,
            uuid: ids.device_uuid,
            driver: format!("{name} {info}").trim().to_owned(),
            limits: Limits {
                max_storage_buffer_range: base.limits.max_storage_buffer_range.into(),
                max_workgroups: base.limits.max_compute_work_group_count[0],
                max_workgroup_invocations: base.limits.max_compute_work_group_invocations,
                max_allocation_bytes: maintenance.max_memory_allocation_size,
                timestamp_period_ns: 0.0,
                timestamp_bits: 0,
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
        }
    }
}

/// Most storage buffers that a shader can be given in one descriptor set.
fn storage_buffers(limits: &vk::PhysicalDeviceLimits) -> u32 {
    limits.max_per_stage_descriptor_storage_buffers.min(limits.max_descriptor_set_storage_buffers)
}

/// What a driver can do; what it was not asked for, it cannot.
#[derive(Clone, Copy)]
struct Features {
    storage_buffers: u32,
    timeline_semaphores: bool,
    scalar_layout: bool,
    buffer_addresses: bool,
    acceleration: bool,
    pipelines: bool,
    queries: bool,
}

impl Features {
    fn of(instance: &ash::Instance, physical: vk::PhysicalDevice, extensions: &Extensions, api_version: u32) -> Self {
        let mut features12 = vk::PhysicalDeviceVulkan12Features::default();
        let mut acceleration = vk::PhysicalDeviceAccelerationStructureFeaturesKHR::default();
        let mut pipelines = vk::PhysicalDeviceRayTracingPipelineFeaturesKHR::default();
        let mut queries = vk::PhysicalDeviceRayQueryFeaturesKHR::default();
        let mut features = vk::PhysicalDeviceFeatures2::default();
        if api_version >= vk::API_VERSION_1_2 {
            features = features.push_next(&mut features12);
        }
        if extensions.has_acceleration {
            features = features.push_next(&mut acceleration);
        }
        if extensions.has_pipelines {
            features = features.push_next(&mut pipelines);
        }
        if extensions.has_queries {
            features = features.push_next(&mut queries);
        }
        // SAFETY: the physical device is one of this instance; the chain holds records that it knows, alive until the call
        // returns.
        unsafe { instance.get_physical_device_features2(physical, &mut features) };
        Self {
            storage_buffers: 0,
            timeline_semaphores: features12.timeline_semaphore == vk::TRUE,
            scalar_layout: features12.scalar_block_layout == vk::TRUE,
            buffer_addresses: features12.buffer_device_address == vk::TRUE,
            acceleration: acceleration.acceleration_structure == vk::TRUE,
            pipelines: pipelines.ray_tracing_pipeline == vk::TRUE,
            queries: queries.ray_query == vk::TRUE,
        }
    }
}

/// Why walk, queries and pipelines cannot run, `None` where they can.
fn missing(api_version: u32, can_compute: bool, features: &Features) -> [Option<String>; 3] {
    let lacks = |is_there: bool, what: &str| (!is_there).then(|| what.to_owned());
    let walk = lacks(api_version >= vk::API_VERSION_1_2, "the driver has no Vulkan 1.2")
        .or_else(|| lacks(can_compute, "no queue can compute"))
        .or_else(|| lacks(features.timeline_semaphores, "no timeline semaphores"))
        .or_else(|| {
            let (has, needed) = (features.storage_buffers, storage_bindings());
            lacks(has >= needed, &format!("a shader can have {has} storage buffers, and needs {needed}"))
        });
    let acceleration = walk
        .clone()
        .or_else(|| lacks(features.acceleration, "no VK_KHR_acceleration_structure"))
        .or_else(|| lacks(features.buffer_addresses, "no bufferDeviceAddress"));
    let query = acceleration.clone().or_else(|| lacks(features.queries, "no VK_KHR_ray_query"));
    let pipeline = acceleration.or_else(|| lacks(features.pipelines, "no VK_KHR_ray_tracing_pipeline"));
    [walk, query, pipeline]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_traversal_that_is_missing_names_the_first_thing_that_it_lacks() {
        let all = Features {
            storage_buffers: storage_bindings(),
            timeline_semaphores: true,
            scalar_layout: true,
            buffer_addresses: true,
            acceleration: true,
            pipelines: true,
            queries: true,
        };
        let of = |version, can_compute, features: Features| {
            missing(version, can_compute, &features).map(|why| why.unwrap_or_default())
        };
        let new = vk::API_VERSION_1_2;
        assert_eq!(of(new, true, all), ["", "", ""]);
        assert_eq!(of(vk::API_VERSION_1_1, false, all), ["the driver has no Vulkan 1.2"; 3]);
        assert_eq!(of(new, false, all), ["no queue can compute"; 3]);
        assert_eq!(of(new, true, Features { timeline_semaphores: false, ..all }), ["no timeline semaphores"; 3]);
        let few = Features { storage_buffers: 24, ..all };
        assert_eq!(of(new, true, few), ["a shader can have 24 storage buffers, and needs 27"; 3]);
        let no_structure = Features { acceleration: false, buffer_addresses: false, queries: false, ..all };
        assert_eq!(
            of(new, true, no_structure),
            ["", "no VK_KHR_acceleration_structure", "no VK_KHR_acceleration_structure"]
        );
        let no_address = Features { buffer_addresses: false, ..all };
        assert_eq!(of(new, true, no_address), ["", "no bufferDeviceAddress", "no bufferDeviceAddress"]);
        assert_eq!(of(new, true, Features { queries: false, ..all }), ["", "no VK_KHR_ray_query", ""]);
        assert_eq!(of(new, true, Features { pipelines: false, ..all }), ["", "", "no VK_KHR_ray_tracing_pipeline"]);
    }
}
