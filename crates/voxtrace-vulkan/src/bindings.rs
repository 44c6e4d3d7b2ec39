//! The one descriptor set that all passes share.

use crate::buffer::Buffer;
use crate::commands::Submitter;
use crate::device::Device;
use crate::errors::ResultExt;
use crate::records::{Dispatch, WaveStep, binding};
use ash::vk;
use std::sync::Arc;
use voxtrace_core::TraceError;

/// The set, its layout and the layout of pipelines that use it.
pub struct Bindings {
    device: Arc<Device>,
    set_layout: vk::DescriptorSetLayout,
    pub layout: vk::PipelineLayout,
    pool: vk::DescriptorPool,
    pub set: vk::DescriptorSet,
}

/// Kind of each binding.
fn kind(binding: u32) -> vk::DescriptorType {
    match binding {
        binding::FRAME | binding::REAL_TIME => vk::DescriptorType::UNIFORM_BUFFER,
        binding::DISPATCH => vk::DescriptorType::UNIFORM_BUFFER_DYNAMIC,
        binding::TOP_LEVEL => vk::DescriptorType::ACCELERATION_STRUCTURE_KHR,
        _ => vk::DescriptorType::STORAGE_BUFFER,
    }
}

/// Storage buffers that every shader is given, whether it reads them or not.
pub fn storage_bindings() -> u32 {
    let all = binding::CELLS..=binding::LAST;
    all.filter(|&binding| kind(binding) == vk::DescriptorType::STORAGE_BUFFER).count() as u32
}

impl Bindings {
    pub fn new(device: &Arc<Device>) -> Result<Self, TraceError> {
        let mut bindings = Self {
            device: Arc::clone(device),
            set_layout: vk::DescriptorSetLayout::null(),
            layout: vk::PipelineLayout::null(),
            pool: vk::DescriptorPool::null(),
            set: vk::DescriptorSet::null(),
        };
        let has_acceleration = device.acceleration.is_some();
        let mut stages = vk::ShaderStageFlags::COMPUTE;
        if device.pipelines.is_some() {
            stages |= vk::ShaderStageFlags::RAYGEN_KHR
                | vk::ShaderStageFlags::INTERSECTION_KHR
                | vk::ShaderStageFlags::ANY_HIT_KHR
                | vk::ShaderStageFlags::CLOSEST_HIT_KHR
                | vk::ShaderStageFlags::MISS_KHR;
        }
        let all: Vec<_> = (binding::CELLS..=binding::LAST)
            .filter(|&binding| binding != binding::TOP_LEVEL || has_acceleration)
            .map(|binding| {
                vk::DescriptorSetLayoutBinding::default()
                    .binding(binding)
                    .descriptor_type(kind(binding))
                    .descriptor_count(1)
                    .stage_flags(stages)
            })
            .collect();
        let mut sizes: Vec<vk::DescriptorPoolSize> = Vec::new();
        for entry in &all {
            match sizes.iter_mut().find(|size| size.ty == entry.descriptor_type) {
                Some(size) => size.descriptor_count += 1,
                None => sizes.push(vk::DescriptorPoolSize { ty: entry.descriptor_type, descriptor_count: 1 }),
            }
        }
        let raw = &device.raw;
        let step = "creating descriptors";
        let info = vk::DescriptorSetLayoutCreateInfo::default().bindings(&all);
        // SAFETY: the device is alive; what was created is destroyed by `drop`, also when a later step fails.
        bindings.set_layout = unsafe { raw.create_descriptor_set_layout(&info, None) }.context(step)?;
        let layouts = [bindings.set_layout];
        let pushed = [vk::PushConstantRange::default()
            .stage_flags(vk::ShaderStageFlags::COMPUTE)
            .size(size_of::<WaveStep>() as u32)];
        let info = vk::PipelineLayoutCreateInfo::default().set_layouts(&layouts).push_constant_ranges(&pushed);
        // SAFETY: as above.
        bindings.layout = unsafe { raw.create_pipeline_layout(&info, None) }.context(step)?;
        let info = vk::DescriptorPoolCreateInfo::default().max_sets(1).pool_sizes(&sizes);
        // SAFETY: as above.
        bindings.pool = unsafe { raw.create_descriptor_pool(&info, None) }.context(step)?;
        let info = vk::DescriptorSetAllocateInfo::default().descriptor_pool(bindings.pool).set_layouts(&layouts);
        // SAFETY: as above.
        bindings.set = unsafe { raw.allocate_descriptor_sets(&info) }.context(step)?[0];
        Ok(bindings)
    }

    /// Binds a buffer. Nothing that uses the set may be in flight.
    pub fn bind(&self, binding: u32, buffer: &Buffer) {
        let range = if binding == binding::DISPATCH { size_of::<Dispatch>() as u64 } else { vk::WHOLE_SIZE };
        let buffers = [vk::DescriptorBufferInfo { buffer: buffer.handle, offset: 0, range }];
        let write = vk::WriteDescriptorSet::default()
            .dst_set(self.set)
            .dst_binding(binding)
            .descriptor_type(kind(binding))
            .buffer_info(&buffers);
        // SAFETY: the buffer is alive and stays so while the set is used; the tracer waits before it binds.
        unsafe { self.device.raw.update_descriptor_sets(&[write], &[]) };
    }

    /// Binds the acceleration structure over the instances. Nothing that uses the set may be in flight.
    pub fn bind_top_level(&self, structure: vk::AccelerationStructureKHR) {
        let structures = [structure];
        let mut acceleration =
            vk::WriteDescriptorSetAccelerationStructureKHR::default().acceleration_structures(&structures);
        let mut write = vk::WriteDescriptorSet::default()
            .dst_set(self.set)
            .dst_binding(binding::TOP_LEVEL)
            .descriptor_type(kind(binding::TOP_LEVEL))
            .push_next(&mut acceleration);
        write.descriptor_count = 1;
        // SAFETY: as in `bind`.
        unsafe { self.device.raw.update_descriptor_sets(&[write], &[]) };
    }

    /// Binds what the submitter owns.
    pub fn bind_submitter(&self, submitter: &Submitter) {
        self.bind(binding::COUNTERS, &submitter.counters);
        self.bind(binding::DISPATCH, &submitter.dispatches);
    }

    /// Makes `commands` use the set, with the dispatch's input at `offset`.
    pub fn use_in(&self, commands: vk::CommandBuffer, point: vk::PipelineBindPoint, offset: u32) {
        // SAFETY: only called while these commands are recorded.
        unsafe { self.device.raw.cmd_bind_descriptor_sets(commands, point, self.layout, 0, &[self.set], &[offset]) };
    }
}

impl Drop for Bindings {
    fn drop(&mut self) {
        if self.device.hung().is_some() {
            return;
        }
        let raw = &self.device.raw;
        // SAFETY: the submitter, dropped before, waited for everything; null handles are allowed.
        unsafe {
            raw.destroy_descriptor_pool(self.pool, None);
            raw.destroy_pipeline_layout(self.layout, None);
            raw.destroy_descriptor_set_layout(self.set_layout, None);
        }
    }
}
