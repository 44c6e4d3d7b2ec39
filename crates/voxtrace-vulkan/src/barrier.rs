//! Barriers between the steps of a submit.

use crate::device::Device;
use ash::vk;

/// Lets everything after see everything before.
pub fn barrier(device: &Device, commands: vk::CommandBuffer) {
    let access = vk::AccessFlags::MEMORY_READ | vk::AccessFlags::MEMORY_WRITE;
    memory_barrier(device, commands, vk::PipelineStageFlags::ALL_COMMANDS, access);
}

/// Lets a stage see everything before.
pub fn memory_barrier(
    device: &Device,
    commands: vk::CommandBuffer,
    stage: vk::PipelineStageFlags,
    access: vk::AccessFlags,
) {
    let memory = vk::MemoryBarrier::default().src_access_mask(vk::AccessFlags::MEMORY_WRITE).dst_access_mask(access);
    let (before, flags) = (vk::PipelineStageFlags::ALL_COMMANDS, vk::DependencyFlags::empty());
    // SAFETY: only called while these commands are recorded.
    unsafe { device.raw.cmd_pipeline_barrier(commands, before, stage, flags, &[memory], &[], &[]) };
}
