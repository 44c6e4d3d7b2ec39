//! A picture of the size of its place is copied there, not drawn: devices that are made for computing shade fragments slowly, and every device
//! copies as quickly as its memory allows.

use super::layer::{Layer, Target};
use ash::vk;
use voxtrace_vulkan::Picture;

/// What surrounds a picture: the dark grey of `shaders/pass/present.slang`, sRGB.
pub const SURROUND: vk::ClearColorValue = vk::ClearColorValue { float32: [0.11, 0.11, 0.11, 1.0] };

const WHOLE: vk::ImageSubresourceRange = vk::ImageSubresourceRange {
    aspect_mask: vk::ImageAspectFlags::COLOR,
    base_mip_level: 0,
    level_count: 1,
    base_array_layer: 0,
    layer_count: 1,
};

/// The picture of a layer that can be copied into a target: one alone, pixel for pixel, in the upper left corner.
pub fn copied<'l>(layer: Option<&'l Layer>, target: &Target) -> Option<&'l Picture> {
    let layer = layer.filter(|layer| target.can_copy && layer.beside.is_none() && layer.corner == [0.0; 2])?;
    let (width, height) = layer.picture.size();
    let is_inside = width <= target.extent.width && height <= target.extent.height;
    (is_inside && layer.size == [width as f32, height as f32]).then_some(&*layer.picture)
}

/// What lies beside a picture in the upper left corner of a target, and below it.
pub fn beside((width, height): (u32, u32), extent: vk::Extent2D) -> Vec<vk::ClearRect> {
    let strip = |x: u32, y: u32, width: u32, height: u32| {
        let rect =
            vk::Rect2D { offset: vk::Offset2D { x: x as i32, y: y as i32 }, extent: vk::Extent2D { width, height } };
        vk::ClearRect { rect, base_array_layer: 0, layer_count: 1 }
    };
    let (right, below) = (extent.width.saturating_sub(width), extent.height.saturating_sub(height));
    let strips = [strip(width, 0, right, extent.height), strip(0, height, width.min(extent.width), below)];
    strips.into_iter().filter(|strip| strip.rect.extent.width > 0 && strip.rect.extent.height > 0).collect()
}

/// The copy between a buffer of pixels, row by row, and the upper left corner of an image.
pub fn region((width, height): (u32, u32)) -> vk::BufferImageCopy {
    let colors = vk::ImageSubresourceLayers {
        aspect_mask: vk::ImageAspectFlags::COLOR,
        layer_count: 1,
        ..vk::ImageSubresourceLayers::default()
    };
    vk::BufferImageCopy::default().image_subresource(colors).image_extent(vk::Extent3D { width, height, depth: 1 })
}

/// Records the copy of a picture that was made visible, and leaves the image in `layout`. What is beside the picture is undefined.
///
/// # Safety
/// The commands must be being recorded, outside of a render pass, after a barrier between what made the picture visible and transfers; picture
/// and target must be alive until they are over.
pub unsafe fn record(
    raw: &ash::Device,
    commands: vk::CommandBuffer,
    target: &Target,
    picture: &Picture,
    layout: vk::ImageLayout,
) {
    use vk::{AccessFlags as Access, ImageLayout as Layout, PipelineStageFlags as Stage};
    let change = |from: (Layout, Stage, Access), to: (Layout, Stage, Access)| {
        let barrier = vk::ImageMemoryBarrier::default()
            .image(target.image)
            .subresource_range(WHOLE)
            .old_layout(from.0)
            .new_layout(to.0)
            .src_access_mask(from.2)
            .dst_access_mask(to.2)
            .src_queue_family_index(vk::QUEUE_FAMILY_IGNORED)
            .dst_queue_family_index(vk::QUEUE_FAMILY_IGNORED);
        // SAFETY: as the caller says.
        unsafe {
            raw.cmd_pipeline_barrier(commands, from.1, to.1, vk::DependencyFlags::empty(), &[], &[], &[barrier]);
        }
    };
    let copying = (Layout::TRANSFER_DST_OPTIMAL, Stage::TRANSFER, Access::TRANSFER_WRITE);
    // The frame before may have been drawn, or read, in the same image.
    let used = Stage::COLOR_ATTACHMENT_OUTPUT | Stage::TRANSFER;
    change((Layout::UNDEFINED, used, Access::COLOR_ATTACHMENT_WRITE), copying);
    // SAFETY: as the caller says; the picture lies within the image.
    unsafe {
        raw.cmd_copy_buffer_to_image(commands, picture.display(), target.image, copying.0, &[region(picture.size())])
    };
    let next = match layout {
        Layout::COLOR_ATTACHMENT_OPTIMAL => {
            let drawn = Access::COLOR_ATTACHMENT_READ | Access::COLOR_ATTACHMENT_WRITE;
            (layout, Stage::COLOR_ATTACHMENT_OUTPUT, drawn)
        }
        Layout::TRANSFER_SRC_OPTIMAL => (layout, Stage::TRANSFER, Access::TRANSFER_READ),
        // Shown: the semaphore that is signaled makes it visible.
        _ => (layout, Stage::BOTTOM_OF_PIPE, Access::empty()),
    };
    change(copying, next);
}
