//! Memory for the triangles and the textures of the panels. `egui-ash-renderer` lets go of a buffer or an image without destroying it where a
//! later step of an upload fails; so each is kept here too, and what is left goes with the renderer.

use super::target::allocate;
use ash::vk;
use egui_ash_renderer::RendererResult;
use egui_ash_renderer::allocator::Allocator;
use std::collections::HashMap;
use std::sync::Arc;
use voxtrace_vulkan::Device;

/// What the renderer of the panels has allocated on a device.
pub struct PanelMemory {
    device: Arc<Device>,
    buffers: HashMap<vk::Buffer, vk::DeviceMemory>,
    images: HashMap<vk::Image, vk::DeviceMemory>,
}

impl PanelMemory {
    pub fn new(device: &Arc<Device>) -> Self {
        Self { device: Arc::clone(device), buffers: HashMap::new(), images: HashMap::new() }
    }
}

impl Allocator for PanelMemory {
    type Allocation = vk::DeviceMemory;

    fn create_buffer(
        &mut self,
        raw: &ash::Device,
        size: usize,
        usage: vk::BufferUsageFlags,
    ) -> RendererResult<(vk::Buffer, vk::DeviceMemory)> {
        let info = vk::BufferCreateInfo::default().size(size as u64).usage(usage);
        let host = vk::MemoryPropertyFlags::HOST_VISIBLE | vk::MemoryPropertyFlags::HOST_COHERENT;
        // SAFETY: the device is alive; what is in the map is destroyed by `drop`, also when a later step fails.
        unsafe {
            let buffer = raw.create_buffer(&info, None)?;
            self.buffers.insert(buffer, vk::DeviceMemory::null());
            let memory = allocate(&self.device, raw.get_buffer_memory_requirements(buffer), host)?;
            self.buffers.insert(buffer, memory);
            raw.bind_buffer_memory(buffer, memory, 0)?;
            Ok((buffer, memory))
        }
    }

    fn create_image(
        &mut self,
        raw: &ash::Device,
        width: u32,
        height: u32,
    ) -> RendererResult<(vk::Image, vk::DeviceMemory)> {
        let info = vk::ImageCreateInfo::default()
            .image_type(vk::ImageType::TYPE_2D)
            .format(vk::Format::R8G8B8A8_SRGB)
            .extent(vk::Extent3D { width, height, depth: 1 })
            .mip_levels(1)
            .array_layers(1)
            .samples(vk::SampleCountFlags::TYPE_1)
            .usage(vk::ImageUsageFlags::TRANSFER_DST | vk::ImageUsageFlags::SAMPLED);
        // SAFETY: as above.
        unsafe {
            let image = raw.create_image(&info, None)?;
            self.images.insert(image, vk::DeviceMemory::null());
            let needs = raw.get_image_memory_requirements(image);
            let memory = allocate(&self.device, needs, vk::MemoryPropertyFlags::DEVICE_LOCAL)?;
            self.images.insert(image, memory);
            raw.bind_image_memory(image, memory, 0)?;
            Ok((image, memory))
        }
    }

    fn destroy_buffer(
        &mut self,
        raw: &ash::Device,
        buffer: vk::Buffer,
        memory: vk::DeviceMemory,
    ) -> RendererResult<()> {
        self.buffers.remove(&buffer);
        // SAFETY: whoever destroys a buffer has waited for the work that uses it.
        unsafe {
            raw.destroy_buffer(buffer, None);
            raw.free_memory(memory, None);
        }
        Ok(())
    }

    fn destroy_image(&mut self, raw: &ash::Device, image: vk::Image, memory: vk::DeviceMemory) -> RendererResult<()> {
        self.images.remove(&image);
        // SAFETY: as for buffers.
        unsafe {
            raw.destroy_image(image, None);
            raw.free_memory(memory, None);
        }
        Ok(())
    }

    fn update_buffer<T: Copy>(
        &mut self,
        raw: &ash::Device,
        memory: &mut vk::DeviceMemory,
        data: &[T],
    ) -> RendererResult<()> {
        // SAFETY: the buffer was made for data of this size, in memory that the host sees, which is mapped nowhere else.
        unsafe {
            let bytes = raw.map_memory(*memory, 0, vk::WHOLE_SIZE, vk::MemoryMapFlags::empty())?;
            std::ptr::copy_nonoverlapping(data.as_ptr().cast::<u8>(), bytes.cast::<u8>(), size_of_val(data));
            raw.unmap_memory(*memory);
        }
        Ok(())
    }
}

impl Drop for PanelMemory {
    fn drop(&mut self) {
        let raw = self.device.raw();
        // SAFETY: the renderer has destroyed what it knew of, and the queue that draws is idle; null handles are allowed.
        unsafe {
            for (&buffer, &memory) in &self.buffers {
                raw.destroy_buffer(buffer, None);
                raw.free_memory(memory, None);
            }
            for (&image, &memory) in &self.images {
                raw.destroy_image(image, None);
                raw.free_memory(memory, None);
            }
        }
    }
}
