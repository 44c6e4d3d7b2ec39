//! What frames are recorded with: render passes with one colour attachment, and barriers.

use ash::vk;

/// A pass into an image that it leaves in `layout`: cleared first, or, where something `lies_below`, drawn over what is there.
pub fn render_pass(
    raw: &ash::Device,
    format: vk::Format,
    layout: vk::ImageLayout,
    lies_below: bool,
) -> Result<vk::RenderPass, vk::Result> {
    let (load, initial) = match lies_below {
        true => (vk::AttachmentLoadOp::LOAD, vk::ImageLayout::COLOR_ATTACHMENT_OPTIMAL),
        false => (vk::AttachmentLoadOp::CLEAR, vk::ImageLayout::UNDEFINED),
    };
    let attachments = [vk::AttachmentDescription::default()
        .format(format)
        .samples(vk::SampleCountFlags::TYPE_1)
        .load_op(load)
        .store_op(vk::AttachmentStoreOp::STORE)
        .stencil_load_op(vk::AttachmentLoadOp::DONT_CARE)
        .stencil_store_op(vk::AttachmentStoreOp::DONT_CARE)
        .initial_layout(initial)
        .final_layout(layout)];
    let references = [vk::AttachmentReference { attachment: 0, layout: vk::ImageLayout::COLOR_ATTACHMENT_OPTIMAL }];
    let subpasses = [vk::SubpassDescription::default().color_attachments(&references)];
    let outputs = vk::PipelineStageFlags::COLOR_ATTACHMENT_OUTPUT;
    let dependencies = [
        // The image is free once the semaphore of its acquisition was waited for at this stage.
        vk::SubpassDependency::default()
            .src_subpass(vk::SUBPASS_EXTERNAL)
            .src_stage_mask(outputs)
            .dst_stage_mask(outputs)
            .dst_access_mask(vk::AccessFlags::COLOR_ATTACHMENT_WRITE),
        // For targets that are read back.
        vk::SubpassDependency::default()
            .dst_subpass(vk::SUBPASS_EXTERNAL)
            .src_stage_mask(outputs)
            .dst_stage_mask(vk::PipelineStageFlags::TRANSFER)
            .src_access_mask(vk::AccessFlags::COLOR_ATTACHMENT_WRITE)
            .dst_access_mask(vk::AccessFlags::TRANSFER_READ),
    ];
    let info =
        vk::RenderPassCreateInfo::default().attachments(&attachments).subpasses(&subpasses).dependencies(&dependencies);
    // SAFETY: the device is alive.
    unsafe { raw.create_render_pass(&info, None) }
}

/// Lets what comes after see what was before: stages and accesses.
///
/// # Safety
/// The commands must be being recorded, outside of a render pass.
pub unsafe fn barrier(
    raw: &ash::Device,
    commands: vk::CommandBuffer,
    (before, after): (vk::PipelineStageFlags, vk::PipelineStageFlags),
    (written, read): (vk::AccessFlags, vk::AccessFlags),
) {
    let barrier = vk::MemoryBarrier::default().src_access_mask(written).dst_access_mask(read);
    let none = vk::DependencyFlags::empty();
    // SAFETY: as the caller says.
    unsafe { raw.cmd_pipeline_barrier(commands, before, after, none, &[barrier], &[], &[]) };
}
