//! Drawing into an image of our own: frames without a window, for tests and for pictures of the window.

use super::copy::region;
use super::layer::{Layer, Panels, Target};
use super::painter::Painter;
use super::{DrawError, Step};
use ash::vk;
use std::sync::Arc;
use voxtrace_vulkan::Device;

/// An image that frames are drawn into and read back from.
pub struct Offscreen {
    painter: Painter,
    extent: vk::Extent2D,
    format: vk::Format,
    image: vk::Image,
    memory: vk::DeviceMemory,
    view: vk::ImageView,
    framebuffer: vk::Framebuffer,
    buffer: vk::Buffer,
    buffer_memory: vk::DeviceMemory,
    pool: vk::CommandPool,
    device: Arc<Device>,
}

impl Offscreen {
    /// An image of `width` × `height` pixels, red in the lowest byte of each.
    ///
    /// # Errors
    /// What the driver answers.
    pub fn new(device: &Arc<Device>, width: u32, height: u32) -> Result<Self, DrawError> {
        Self::of_order(device, width, height, false)
    }

    /// The same, or one with blue in the lowest byte, as images of windows have it.
    ///
    /// # Errors
    /// What the driver answers.
    pub fn of_order(device: &Arc<Device>, width: u32, height: u32, is_blue_lowest: bool) -> Result<Self, DrawError> {
        let format = if is_blue_lowest { vk::Format::B8G8R8A8_UNORM } else { vk::Format::R8G8B8A8_UNORM };
        let mut painter = Painter::new(device, format, vk::ImageLayout::TRANSFER_SRC_OPTIMAL)?;
        painter.measure()?;
        let mut target = Self {
            painter,
            extent: vk::Extent2D { width, height },
            format,
            image: vk::Image::null(),
            memory: vk::DeviceMemory::null(),
            view: vk::ImageView::null(),
            framebuffer: vk::Framebuffer::null(),
            buffer: vk::Buffer::null(),
            buffer_memory: vk::DeviceMemory::null(),
            pool: vk::CommandPool::null(),
            device: Arc::clone(device),
        };
        target.fill().step("making an image to draw into")?;
        Ok(target)
    }

    fn fill(&mut self) -> Result<(), vk::Result> {
        let raw = self.device.raw();
        let vk::Extent2D { width, height } = self.extent;
        let image = vk::ImageCreateInfo::default()
            .image_type(vk::ImageType::TYPE_2D)
            .format(self.format)
            .extent(vk::Extent3D { width, height, depth: 1 })
            .mip_levels(1)
            .array_layers(1)
            .samples(vk::SampleCountFlags::TYPE_1)
            .usage(
                vk::ImageUsageFlags::COLOR_ATTACHMENT
                    | vk::ImageUsageFlags::TRANSFER_SRC
                    | vk::ImageUsageFlags::TRANSFER_DST,
            );
        let buffer = vk::BufferCreateInfo::default()
            .size(u64::from(width) * u64::from(height) * 4)
            .usage(vk::BufferUsageFlags::TRANSFER_DST);
        let pool = vk::CommandPoolCreateInfo::default().queue_family_index(self.device.info().queue_family());
        // SAFETY: the device is alive; what was created is destroyed by `drop`, also when a later step fails.
        unsafe {
            self.image = raw.create_image(&image, None)?;
            let needs = raw.get_image_memory_requirements(self.image);
            self.memory = allocate(&self.device, needs, vk::MemoryPropertyFlags::empty())?;
            raw.bind_image_memory(self.image, self.memory, 0)?;
            self.buffer = raw.create_buffer(&buffer, None)?;
            let needs = raw.get_buffer_memory_requirements(self.buffer);
            let host = vk::MemoryPropertyFlags::HOST_VISIBLE | vk::MemoryPropertyFlags::HOST_COHERENT;
            self.buffer_memory = allocate(&self.device, needs, host)?;
            raw.bind_buffer_memory(self.buffer, self.buffer_memory, 0)?;
            self.pool = raw.create_command_pool(&pool, None)?;
        }
        self.view = view(raw, self.image, self.format)?;
        self.framebuffer = framebuffer(raw, self.painter.pass(), self.view, self.extent)?;
        Ok(())
    }

    /// Draws a frame and returns its pixels, four bytes each, row by row.
    ///
    /// # Errors
    /// What the driver answers.
    pub fn draw(&mut self, layer: Option<&Layer>, panels: Panels) -> Result<Vec<u8>, DrawError> {
        self.submit(layer, panels)?;
        self.read().step("reading a frame back")
    }

    /// Draws a frame that nobody looks at, as a window does that does not wait for it either.
    ///
    /// # Errors
    /// What the driver answers.
    pub fn submit(&mut self, layer: Option<&Layer>, mut panels: Panels) -> Result<(), DrawError> {
        self.painter.take_textures(std::mem::take(&mut panels.textures))?;
        self.painter.wait()?;
        let none = vk::Semaphore::null();
        let Self { image, framebuffer, extent, .. } = *self;
        let target = Target { image, framebuffer, extent, can_copy: true };
        self.painter.draw(&target, (none, none), layer, &panels)
    }

    /// Milliseconds of a frame that is over, by the device's clock, each once. Two frames are in flight, so it is of the one before the last.
    pub fn take_frame_ms(&mut self) -> Option<f64> {
        self.painter.take_frame_ms()
    }

    fn read(&self) -> Result<Vec<u8>, vk::Result> {
        let raw = self.device.raw();
        let vk::Extent2D { width, height } = self.extent;
        let allocate = vk::CommandBufferAllocateInfo::default().command_pool(self.pool).command_buffer_count(1);
        let to_host = vk::MemoryBarrier::default()
            .src_access_mask(vk::AccessFlags::TRANSFER_WRITE)
            .dst_access_mask(vk::AccessFlags::HOST_READ);
        // SAFETY: the frame is the last that was submitted to the queue, which is locked until it is idle; the buffer has room for
        // the image, and its memory is mapped once.
        unsafe {
            let commands = raw.allocate_command_buffers(&allocate)?;
            raw.begin_command_buffer(commands[0], &vk::CommandBufferBeginInfo::default())?;
            let layout = vk::ImageLayout::TRANSFER_SRC_OPTIMAL;
            raw.cmd_copy_image_to_buffer(commands[0], self.image, layout, self.buffer, &[region((width, height))]);
            let (copy, host) = (vk::PipelineStageFlags::TRANSFER, vk::PipelineStageFlags::HOST);
            raw.cmd_pipeline_barrier(commands[0], copy, host, vk::DependencyFlags::empty(), &[to_host], &[], &[]);
            raw.end_command_buffer(commands[0])?;
            let queue = self.device.present_queue();
            raw.queue_submit(*queue, &[vk::SubmitInfo::default().command_buffers(&commands)], vk::Fence::null())?;
            self.device.wait_for_queue(*queue)?;
            drop(queue);
            raw.free_command_buffers(self.pool, &commands);
            let size = width as usize * height as usize * 4;
            let bytes = raw.map_memory(self.buffer_memory, 0, vk::WHOLE_SIZE, vk::MemoryMapFlags::empty())?;
            let pixels = std::slice::from_raw_parts(bytes.cast::<u8>(), size).to_vec();
            raw.unmap_memory(self.buffer_memory);
            Ok(pixels)
        }
    }
}

impl Drop for Offscreen {
    fn drop(&mut self) {
        if !self.device.wait_presented() {
            return;
        }
        let raw = self.device.raw();
        // SAFETY: the queue that draws is idle; null handles are allowed.
        unsafe {
            raw.destroy_command_pool(self.pool, None);
            raw.destroy_framebuffer(self.framebuffer, None);
            raw.destroy_image_view(self.view, None);
            raw.destroy_image(self.image, None);
            raw.destroy_buffer(self.buffer, None);
            raw.free_memory(self.memory, None);
            raw.free_memory(self.buffer_memory, None);
        }
    }
}

/// Memory of a device, of the first type that is allowed and has what is wanted.
pub fn allocate(
    device: &Device,
    needs: vk::MemoryRequirements,
    wanted: vk::MemoryPropertyFlags,
) -> Result<vk::DeviceMemory, vk::Result> {
    // SAFETY: the physical device is one of this instance.
    let memory = unsafe { device.vulkan().instance().get_physical_device_memory_properties(device.info().physical()) };
    let types = &memory.memory_types[..memory.memory_type_count as usize];
    let suits = |(index, kind): &(usize, &vk::MemoryType)| {
        needs.memory_type_bits >> index & 1 == 1 && kind.property_flags.contains(wanted)
    };
    let (index, _) = types.iter().enumerate().find(suits).ok_or(vk::Result::ERROR_OUT_OF_DEVICE_MEMORY)?;
    let allocate = vk::MemoryAllocateInfo::default().allocation_size(needs.size).memory_type_index(index as u32);
    // SAFETY: the device is alive.
    unsafe { device.raw().allocate_memory(&allocate, None) }
}

/// A view of a whole image.
pub fn view(raw: &ash::Device, image: vk::Image, format: vk::Format) -> Result<vk::ImageView, vk::Result> {
    let whole = vk::ImageSubresourceRange {
        aspect_mask: vk::ImageAspectFlags::COLOR,
        level_count: 1,
        layer_count: 1,
        ..vk::ImageSubresourceRange::default()
    };
    let info = vk::ImageViewCreateInfo::default()
        .image(image)
        .view_type(vk::ImageViewType::TYPE_2D)
        .format(format)
        .subresource_range(whole);
    // SAFETY: the image is alive and was made with this format.
    unsafe { raw.create_image_view(&info, None) }
}

/// A framebuffer of one view.
pub fn framebuffer(
    raw: &ash::Device,
    pass: vk::RenderPass,
    view: vk::ImageView,
    extent: vk::Extent2D,
) -> Result<vk::Framebuffer, vk::Result> {
    let views = [view];
    let info = vk::FramebufferCreateInfo::default()
        .render_pass(pass)
        .attachments(&views)
        .width(extent.width)
        .height(extent.height)
        .layers(1);
    // SAFETY: the view is alive and has the format of the pass.
    unsafe { raw.create_framebuffer(&info, None) }
}
