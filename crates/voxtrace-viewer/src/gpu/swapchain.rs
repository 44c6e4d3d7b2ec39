//! The images of a window: its surface, and a swapchain that is made anew whenever the window has another size.

use super::layer::{Layer, Panels, Target};
use super::painter::Painter;
use super::window_system::Connection;
use super::{DrawError, Step};
use crate::phases::Phases;
use ash::{ext, khr, vk};
use std::sync::Arc;
use std::time::Duration;
use voxtrace_vulkan::{Device, Vulkan};
use winit::raw_window_handle::{HasDisplayHandle, HasWindowHandle};

/// Images that the window asks for: one shown, one waiting, one being drawn.
const IMAGES: u32 = 3;
/// How long a frame waits for an image: a window that is hidden may give none.
const FOR_AN_IMAGE: Duration = Duration::from_millis(250);

/// A window as Vulkan knows it. The window must outlive it.
pub struct Surface {
    handle: vk::SurfaceKHR,
    calls: khr::surface::Instance,
    vulkan: Arc<Vulkan>,
    /// Dropped after the surface.
    _connection: Connection,
}

impl Surface {
    /// The surface of a window.
    ///
    /// # Errors
    /// [`DrawError::Unsupported`] where the window system gives no handles; what the driver answers.
    pub fn new(vulkan: &Arc<Vulkan>, window: &(impl HasDisplayHandle + HasWindowHandle)) -> Result<Self, DrawError> {
        let calls = khr::surface::Instance::new(vulkan.entry(), vulkan.instance());
        let (handle, connection) = Connection::surface(vulkan, window)?;
        Ok(Self { handle, calls, vulkan: Arc::clone(vulkan), _connection: connection })
    }

    /// A surface that belongs to no window, of VK_EXT_headless_surface: frames go the whole way, and nobody sees them. For tests.
    ///
    /// # Errors
    /// What the driver answers.
    pub fn headless(vulkan: &Arc<Vulkan>) -> Result<Self, DrawError> {
        let calls = khr::surface::Instance::new(vulkan.entry(), vulkan.instance());
        let headless = ext::headless_surface::Instance::new(vulkan.entry(), vulkan.instance());
        let info = vk::HeadlessSurfaceCreateInfoEXT::default();
        // SAFETY: the instance has the extension.
        let handle = unsafe { headless.create_headless_surface(&info, None) }.step("making a surface")?;
        Ok(Self { handle, calls, vulkan: Arc::clone(vulkan), _connection: Connection::default() })
    }

    /// The instance that it belongs to.
    pub fn vulkan(&self) -> &Arc<Vulkan> {
        &self.vulkan
    }

    /// Whether a device can show pictures in it.
    pub fn suits(&self, device: &Device) -> bool {
        let info = device.info();
        // SAFETY: device and surface belong to the same instance.
        let answer = unsafe {
            self.calls.get_physical_device_surface_support(info.physical(), info.queue_family(), self.handle)
        };
        info.presents() && answer.unwrap_or(false)
    }
}

impl Drop for Surface {
    fn drop(&mut self) {
        // SAFETY: the swapchains of the surface are gone, as windows drop theirs first.
        unsafe { self.calls.destroy_surface(self.handle, None) };
    }
}

/// What became of a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// It will be shown.
    Shown,
    /// The window changed meanwhile, or gave no image in time: draw again.
    Again,
    /// The window has no size, as when it is minimized.
    Hidden,
}

/// One swapchain, with what is drawn into.
struct Swapchain {
    handle: vk::SwapchainKHR,
    extent: vk::Extent2D,
    /// Whether pictures can be copied into its images.
    can_copy: bool,
    images: Vec<vk::Image>,
    views: Vec<vk::ImageView>,
    framebuffers: Vec<vk::Framebuffer>,
    /// Signaled when an image is drawn, one for each image.
    drawn: Vec<vk::Semaphore>,
}

/// A window that frames are drawn into.
pub struct Window {
    painter: Painter,
    calls: khr::swapchain::Device,
    format: vk::SurfaceFormatKHR,
    chain: Option<Swapchain>,
    /// Signaled when an image is acquired, one for each frame in flight.
    acquired: Vec<vk::Semaphore>,
    next: usize,
    size: (u32, u32),
    device: Arc<Device>,
    surface: Arc<Surface>,
}

impl Window {
    /// Draws into a surface with a device.
    ///
    /// # Errors
    /// [`DrawError::Unsupported`] where the device cannot; what the driver answers.
    pub fn new(device: &Arc<Device>, surface: &Arc<Surface>, size: (u32, u32)) -> Result<Self, DrawError> {
        if !surface.suits(device) {
            let name = &device.info().name;
            return Err(DrawError::Unsupported(format!("{name} cannot show pictures in this window")));
        }
        // SAFETY: device and surface belong to the same instance.
        let formats =
            unsafe { surface.calls.get_physical_device_surface_formats(device.info().physical(), surface.handle) }
                .step("asking for formats")?;
        let format = chosen_format(&formats)
            .ok_or_else(|| DrawError::Unsupported("the window has no format of eight bits a channel".into()))?;
        let painter = Painter::new(device, format.format, vk::ImageLayout::PRESENT_SRC_KHR)?;
        let calls = khr::swapchain::Device::new(device.vulkan().instance(), device.raw());
        let mut window = Self {
            painter,
            calls,
            format,
            chain: None,
            acquired: Vec::new(),
            next: 0,
            size,
            device: Arc::clone(device),
            surface: Arc::clone(surface),
        };
        for _ in 0..super::painter::FRAMES {
            window.acquired.push(window.semaphore()?);
        }
        Ok(window)
    }

    fn semaphore(&self) -> Result<vk::Semaphore, DrawError> {
        // SAFETY: the device is alive; `drop` destroys it.
        unsafe { self.device.raw().create_semaphore(&vk::SemaphoreCreateInfo::default(), None) }
            .step("making a semaphore")
    }

    /// Writes textures of the panels that changed.
    ///
    /// # Errors
    /// What the driver answers.
    pub fn take_textures(&mut self, textures: egui::TexturesDelta) -> Result<(), DrawError> {
        self.painter.take_textures(textures)
    }

    /// The window has another size, pixels.
    pub fn resize(&mut self, size: (u32, u32)) {
        if size != self.size {
            self.size = size;
            self.drop_chain();
        }
    }

    /// Draws a frame, and takes down in `phases` what that was spent on. `about_to_show` is called just before it is handed to the
    /// window system.
    ///
    /// # Errors
    /// What the driver answers; see [`DrawError::loss`]. The window must then be made anew.
    pub fn draw(
        &mut self,
        layer: Option<&Layer>,
        mut panels: Panels,
        about_to_show: impl FnOnce(),
        phases: &mut Phases,
    ) -> Result<Outcome, DrawError> {
        // Also where the frame is not shown: the panels send them once.
        self.painter.take_textures(std::mem::take(&mut panels.textures))?;
        phases.lap("textures");
        self.painter.wait()?;
        phases.lap("wait");
        if self.chain.is_none() {
            self.chain = self.new_chain()?;
            phases.lap("images");
        }
        let Some(chain) = &self.chain else { return Ok(Outcome::Hidden) };
        let acquired = self.acquired[self.next];
        let limit = FOR_AN_IMAGE.as_nanos() as u64;
        // SAFETY: the frame that waited for this semaphore last is over.
        let image = match unsafe { self.calls.acquire_next_image(chain.handle, limit, acquired, vk::Fence::null()) } {
            Ok((image, _)) => image,
            Err(vk::Result::TIMEOUT | vk::Result::NOT_READY) => return Ok(Outcome::Again),
            Err(vk::Result::ERROR_OUT_OF_DATE_KHR) => {
                self.drop_chain();
                return Ok(Outcome::Again);
            }
            Err(result) => return Err(DrawError::Vulkan { step: "asking for an image of the window", result }),
        };
        phases.lap("acquire");
        let Swapchain { extent, can_copy, .. } = *chain;
        let index = image as usize;
        let target = Target { image: chain.images[index], framebuffer: chain.framebuffers[index], extent, can_copy };
        let drawn = chain.drawn[index];
        self.painter.draw(&target, (acquired, drawn), layer, &panels)?;
        phases.lap("submit");
        self.next = (self.next + 1) % self.acquired.len();
        about_to_show();
        let (semaphores, chains, images) = ([drawn], [chain.handle], [image]);
        let info =
            vk::PresentInfoKHR::default().wait_semaphores(&semaphores).swapchains(&chains).image_indices(&images);
        let queue = self.device.present_queue();
        // SAFETY: the image was acquired and is drawn when the semaphore is signaled; the queue is locked.
        let result = unsafe { self.calls.queue_present(*queue, &info) };
        drop(queue);
        phases.lap("present");
        match result {
            Ok(false) => Ok(Outcome::Shown),
            Ok(true) | Err(vk::Result::ERROR_OUT_OF_DATE_KHR) => {
                self.drop_chain();
                Ok(Outcome::Again)
            }
            Err(result) => Err(DrawError::Vulkan { step: "showing a frame", result }),
        }
    }

    /// A swapchain of the window's present size, `None` where it has none, as when it is minimized.
    fn new_chain(&self) -> Result<Option<Swapchain>, DrawError> {
        let (physical, surface) = (self.device.info().physical(), self.surface.handle);
        let step = "making the images of the window";
        // SAFETY: device and surface belong to the same instance.
        let (can, modes) = unsafe {
            let calls = &self.surface.calls;
            (
                calls.get_physical_device_surface_capabilities(physical, surface).step(step)?,
                calls.get_physical_device_surface_present_modes(physical, surface).step(step)?,
            )
        };
        let (least, most) = (can.min_image_extent, can.max_image_extent);
        let extent = match can.current_extent {
            vk::Extent2D { width: u32::MAX, .. } => vk::Extent2D {
                width: self.size.0.clamp(least.width, most.width),
                height: self.size.1.clamp(least.height, most.height),
            },
            extent => extent,
        };
        if extent.width == 0 || extent.height == 0 {
            return Ok(None);
        }
        let mode = if modes.contains(&vk::PresentModeKHR::MAILBOX) {
            vk::PresentModeKHR::MAILBOX
        } else {
            vk::PresentModeKHR::FIFO
        };
        let most_images = if can.max_image_count == 0 { u32::MAX } else { can.max_image_count };
        let alpha = [vk::CompositeAlphaFlagsKHR::OPAQUE, vk::CompositeAlphaFlagsKHR::INHERIT]
            .into_iter()
            .find(|&alpha| can.supported_composite_alpha.contains(alpha))
            .unwrap_or(vk::CompositeAlphaFlagsKHR::OPAQUE);
        let copied = vk::ImageUsageFlags::TRANSFER_DST & can.supported_usage_flags;
        let info = vk::SwapchainCreateInfoKHR::default()
            .surface(surface)
            .min_image_count(IMAGES.clamp(can.min_image_count, most_images))
            .image_format(self.format.format)
            .image_color_space(self.format.color_space)
            .image_extent(extent)
            .image_array_layers(1)
            .image_usage(vk::ImageUsageFlags::COLOR_ATTACHMENT | copied)
            .image_sharing_mode(vk::SharingMode::EXCLUSIVE)
            .pre_transform(can.current_transform)
            .composite_alpha(alpha)
            .present_mode(mode)
            .clipped(true);
        // SAFETY: the surface has no other swapchain: the last one was destroyed.
        let handle = unsafe { self.calls.create_swapchain(&info, None) }.step(step)?;
        let mut chain = Swapchain {
            handle,
            extent,
            can_copy: !copied.is_empty(),
            images: Vec::new(),
            views: Vec::new(),
            framebuffers: Vec::new(),
            drawn: Vec::new(),
        };
        let filled = self.fill(&mut chain);
        match filled {
            Ok(()) => Ok(Some(chain)),
            Err(error) => {
                self.destroy(chain);
                Err(error)
            }
        }
    }

    /// Makes what belongs to the images of a chain.
    fn fill(&self, chain: &mut Swapchain) -> Result<(), DrawError> {
        let step = "preparing the images of the window";
        // SAFETY: the chain is alive.
        let images = unsafe { self.calls.get_swapchain_images(chain.handle) }.step(step)?;
        for image in images {
            chain.images.push(image);
            chain.drawn.push(self.semaphore()?);
            let view = super::target::view(self.device.raw(), image, self.format.format).step(step)?;
            chain.views.push(view);
            let framebuffer = super::target::framebuffer(self.device.raw(), self.painter.pass(), view, chain.extent);
            chain.framebuffers.push(framebuffer.step(step)?);
        }
        Ok(())
    }

    fn drop_chain(&mut self) {
        if let Some(chain) = self.chain.take() {
            self.destroy(chain);
        }
    }

    fn destroy(&self, chain: Swapchain) {
        // What is being shown waits for semaphores of the chain. Where only what traces hangs, the chain goes all the same: window systems may give a window no
        // other one before, of whatever device.
        if !self.device.wait_presented() {
            // It stays, and so does the surface, which outlives its swapchains.
            return std::mem::forget(Arc::clone(&self.surface));
        }
        let raw = self.device.raw();
        // SAFETY: the queue that draws and shows is idle.
        unsafe {
            chain.framebuffers.iter().for_each(|&framebuffer| raw.destroy_framebuffer(framebuffer, None));
            chain.views.iter().for_each(|&view| raw.destroy_image_view(view, None));
            chain.drawn.iter().for_each(|&semaphore| raw.destroy_semaphore(semaphore, None));
            self.calls.destroy_swapchain(chain.handle, None);
        }
    }
}

impl Drop for Window {
    fn drop(&mut self) {
        self.drop_chain();
        if !self.device.wait_presented() {
            return;
        }
        for &semaphore in &self.acquired {
            // SAFETY: the queue that draws and shows is idle.
            unsafe { self.device.raw().destroy_semaphore(semaphore, None) };
        }
    }
}

/// A format whose values are the sRGB signal as it is written: the shader and the panels encode it themselves.
fn chosen_format(formats: &[vk::SurfaceFormatKHR]) -> Option<vk::SurfaceFormatKHR> {
    [vk::Format::B8G8R8A8_UNORM, vk::Format::R8G8B8A8_UNORM].into_iter().find_map(|wanted| {
        let suits = |format: &&vk::SurfaceFormatKHR| {
            format.format == wanted && format.color_space == vk::ColorSpaceKHR::SRGB_NONLINEAR
        };
        formats.iter().find(suits).copied()
    })
}
