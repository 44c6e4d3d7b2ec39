//! A ray tracing pipeline and its shader binding table: one ray generation shader, one miss shader, one hit group.

use crate::buffer::Buffer;
use crate::device::Device;
use crate::errors::ResultExt;
use crate::method::Primitive;
use crate::variant::{Specialization, Variant};
use ash::{khr, vk};
use gpu_allocator::MemoryLocation;
use std::ffi::CString;
use std::sync::Arc;
use voxtrace_core::TraceError;

/// Groups: ray generation, miss, hit.
const GROUPS: u32 = 3;

/// A ray tracing pipeline, ready to launch.
pub struct RayProgram {
    device: Arc<Device>,
    pipeline: vk::Pipeline,
    // The memory behind the regions.
    _table: Buffer,
    regions: [vk::StridedDeviceAddressRegionKHR; GROUPS as usize],
}

fn functions(device: &Device) -> Result<&khr::ray_tracing_pipeline::Device, TraceError> {
    let missing = || TraceError::Unsupported("no VK_KHR_ray_tracing_pipeline".into());
    device.pipelines.as_ref().ok_or_else(missing)
}

impl RayProgram {
    /// Compiles the entry points of `module` that a variant needs.
    pub fn new(
        device: &Arc<Device>,
        layout: vk::PipelineLayout,
        module: vk::ShaderModule,
        variant: Variant,
        step: &str,
    ) -> Result<Self, TraceError> {
        let values = Specialization::new(&variant);
        let specialization = values.info();
        let is_triangle = variant.primitive == Primitive::Triangle;
        let hits =
            if is_triangle { ["any_hit_triangle", "closest_hit_triangle"] } else { ["any_hit_box", "closest_hit_box"] };
        let mut shaders = vec![
            (vk::ShaderStageFlags::RAYGEN_KHR, variant.entry.name()),
            (vk::ShaderStageFlags::MISS_KHR, "missed"),
            (vk::ShaderStageFlags::ANY_HIT_KHR, hits[0]),
            (vk::ShaderStageFlags::CLOSEST_HIT_KHR, hits[1]),
        ];
        if !is_triangle {
            shaders.push((vk::ShaderStageFlags::INTERSECTION_KHR, "intersect"));
        }
        let names: Vec<CString> = shaders
            .iter()
            .map(|(_, name)| CString::new(*name).expect("entry points have no zero in their names"))
            .collect();
        let stages: Vec<_> = shaders
            .iter()
            .zip(&names)
            .map(|((stage, _), name)| {
                vk::PipelineShaderStageCreateInfo::default()
                    .stage(*stage)
                    .module(module)
                    .name(name)
                    .specialization_info(&specialization)
            })
            .collect();
        let unused = vk::RayTracingShaderGroupCreateInfoKHR::default()
            .general_shader(vk::SHADER_UNUSED_KHR)
            .closest_hit_shader(vk::SHADER_UNUSED_KHR)
            .any_hit_shader(vk::SHADER_UNUSED_KHR)
            .intersection_shader(vk::SHADER_UNUSED_KHR);
        let general = unused.ty(vk::RayTracingShaderGroupTypeKHR::GENERAL);
        let hit = unused.any_hit_shader(2).closest_hit_shader(3);
        let hit = match is_triangle {
            true => hit.ty(vk::RayTracingShaderGroupTypeKHR::TRIANGLES_HIT_GROUP),
            false => hit.ty(vk::RayTracingShaderGroupTypeKHR::PROCEDURAL_HIT_GROUP).intersection_shader(4),
        };
        let groups = [general.general_shader(0), general.general_shader(1), hit];
        let info = vk::RayTracingPipelineCreateInfoKHR::default()
            .stages(&stages)
            .groups(&groups)
            .max_pipeline_ray_recursion_depth(1)
            .layout(layout);
        let functions = functions(device)?;
        let (operation, cache) = (vk::DeferredOperationKHR::null(), vk::PipelineCache::null());
        // SAFETY: module and layout are alive, and the layout has every binding of the module.
        let pipelines = unsafe { functions.create_ray_tracing_pipelines(operation, cache, &[info], None) };
        let pipeline = pipelines.map_err(|(_, error)| error).context(step)?[0];
        match table(device, pipeline, step) {
            Ok((table, regions)) => Ok(Self { device: Arc::clone(device), pipeline, _table: table, regions }),
            Err(error) => {
                // SAFETY: nothing uses the pipeline.
                unsafe { device.raw.destroy_pipeline(pipeline, None) };
                Err(error)
            }
        }
    }

    /// Records a launch of `count` invocations of the ray generation shader.
    pub fn launch(&self, commands: vk::CommandBuffer, count: u32) {
        let Some(functions) = &self.device.pipelines else { return };
        let [generation, miss, hit] = &self.regions;
        let callable = vk::StridedDeviceAddressRegionKHR::default();
        // SAFETY: the pipeline is alive, its bindings are set and its table has all groups; only called while these
        // commands are recorded.
        unsafe {
            self.device.raw.cmd_bind_pipeline(commands, vk::PipelineBindPoint::RAY_TRACING_KHR, self.pipeline);
            functions.cmd_trace_rays(commands, generation, miss, hit, &callable, count, 1, 1);
        }
    }
}

/// The shader binding table: each group's handle at a place of its own.
fn table(
    device: &Arc<Device>,
    pipeline: vk::Pipeline,
    step: &str,
) -> Result<(Buffer, [vk::StridedDeviceAddressRegionKHR; GROUPS as usize]), TraceError> {
    let limits = device.info().ray_tracing;
    let (handle, base) = (limits.handle_bytes as usize, u64::from(limits.table_alignment.max(1)));
    // SAFETY: the pipeline was made with these groups.
    let handles = unsafe {
        functions(device)?.get_ray_tracing_shader_group_handles(pipeline, 0, GROUPS, handle * GROUPS as usize)
    }
    .context(step)?;
    let stride = u64::from(limits.handle_bytes.next_multiple_of(limits.handle_alignment.max(1)));
    let place = stride.next_multiple_of(base);
    let usage = vk::BufferUsageFlags::SHADER_BINDING_TABLE_KHR | vk::BufferUsageFlags::SHADER_DEVICE_ADDRESS;
    let size = place * u64::from(GROUPS) + base;
    let mut table = Buffer::new(device, "shader binding tables", size, usage, MemoryLocation::CpuToGpu)?;
    let first = table.address().next_multiple_of(base);
    let skip = first - table.address();
    let regions = std::array::from_fn(|group| {
        let offset = place * group as u64;
        let at = (skip + offset) as usize;
        table.mapped_mut()[at..at + handle].copy_from_slice(&handles[group * handle..][..handle]);
        vk::StridedDeviceAddressRegionKHR { device_address: first + offset, stride, size: stride }
    });
    Ok((table, regions))
}

impl Drop for RayProgram {
    fn drop(&mut self) {
        if self.device.hung().is_some() {
            return;
        }
        // SAFETY: the submitter, dropped before, waited for everything.
        unsafe { self.device.raw.destroy_pipeline(self.pipeline, None) };
    }
}
