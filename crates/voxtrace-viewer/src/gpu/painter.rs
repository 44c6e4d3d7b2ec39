//! One frame of a window or of a test: the picture, then the panels, into any target of the right format. Two frames are in flight.

use super::panel_memory::PanelMemory;
use super::pipeline::{Placement, PresentPipeline};
use super::timestamps::Timestamps;
use super::{DrawError, Step};
use ash::vk;
use egui_ash_renderer::{Options, RenderMode, Renderer};
use std::sync::Arc;
use std::time::Duration;
use voxtrace::output::ToneMap;
use voxtrace_vulkan::{Device, DeviceKind, Picture};

/// Frames in flight.
pub const FRAMES: usize = 2;

/// A picture and its place in the window.
pub struct Layer {
    /// What to draw.
    pub picture: Arc<Picture>,
    /// Upper left corner, pixels.
    pub corner: [f32; 2],
    /// Width and height, pixels.
    pub size: [f32; 2],
    /// Exposure and curve.
    pub tone_map: ToneMap,
    /// Another picture at the same corner, of which the part to the right is seen.
    pub beside: Option<Beside>,
}

impl Layer {
    /// Its pictures, each with its place.
    fn placed(&self) -> impl Iterator<Item = (&Arc<Picture>, Placement)> {
        let placement = |size| Placement { corner: self.corner, size, tone_map: self.tone_map };
        let beside = self.beside.iter().map(move |beside| (&beside.picture, placement(beside.size)));
        std::iter::once((&self.picture, placement(self.size))).chain(beside)
    }
}

/// A picture that is compared with the one to its left.
pub struct Beside {
    /// What to draw.
    pub picture: Arc<Picture>,
    /// Width and height, pixels.
    pub size: [f32; 2],
    /// Where it begins, pixels from the left of the window.
    pub split: f32,
}

/// What egui wants drawn.
pub struct Panels {
    /// Textures that are new or changed, and those that are gone.
    pub textures: egui::TexturesDelta,
    /// The triangles.
    pub primitives: Vec<egui::ClippedPrimitive>,
    /// Pixels of a point.
    pub pixels_per_point: f32,
}

impl Drop for Panels {
    fn drop(&mut self) {
        // A frame that is left out is no fault: whoever draws keeps textures by itself.
        self.textures.clear();
    }
}

/// What a frame in flight uses.
#[derive(Default)]
struct Frame {
    commands: vk::CommandBuffer,
    fence: vk::Fence,
    pictures: Vec<Arc<Picture>>,
    /// Textures that go when the frame is over.
    freed: Vec<egui::TextureId>,
}

/// Draws frames on a device.
pub struct Painter {
    device: Arc<Device>,
    pass: vk::RenderPass,
    pool: vk::CommandPool,
    frames: [Frame; FRAMES],
    next: usize,
    /// Textures that go when the next frame is over.
    freed: Vec<egui::TextureId>,
    present: Option<PresentPipeline>,
    panels: Option<Renderer<PanelMemory>>,
    /// Where frames are measured.
    timestamps: Option<Timestamps>,
    /// Milliseconds of the last frame that was measured.
    frame_ms: Option<f64>,
}

impl Painter {
    /// A painter for targets of a format, which are left in `layout`.
    pub fn new(device: &Arc<Device>, format: vk::Format, layout: vk::ImageLayout) -> Result<Self, DrawError> {
        let raw = device.raw();
        let step = "preparing to draw";
        let mut painter = Self {
            device: Arc::clone(device),
            pass: render_pass(raw, format, layout).step(step)?,
            pool: vk::CommandPool::null(),
            frames: Default::default(),
            next: 0,
            freed: Vec::new(),
            present: None,
            panels: None,
            timestamps: None,
            frame_ms: None,
        };
        let info = vk::CommandPoolCreateInfo::default()
            .flags(vk::CommandPoolCreateFlags::RESET_COMMAND_BUFFER)
            .queue_family_index(device.info().queue_family());
        // SAFETY: the device is alive; what was created is destroyed by `drop`, also when a later step fails.
        painter.pool = unsafe { raw.create_command_pool(&info, None) }.step(step)?;
        let info =
            vk::CommandBufferAllocateInfo::default().command_pool(painter.pool).command_buffer_count(FRAMES as u32);
        // SAFETY: as above.
        let commands = unsafe { raw.allocate_command_buffers(&info) }.step(step)?;
        let signaled = vk::FenceCreateInfo::default().flags(vk::FenceCreateFlags::SIGNALED);
        for (frame, commands) in painter.frames.iter_mut().zip(commands) {
            frame.commands = commands;
            // SAFETY: as above.
            frame.fence = unsafe { raw.create_fence(&signaled, None) }.step(step)?;
        }
        painter.present = Some(PresentPipeline::new(device, painter.pass, 2 * FRAMES)?);
        let options = Options { in_flight_frames: FRAMES, ..Options::default() };
        painter.panels = Some(Renderer::with_allocator(
            PanelMemory::new(device),
            raw.clone(),
            RenderMode::RenderPass(painter.pass),
            options,
        )?);
        Ok(painter)
    }

    /// The render pass that framebuffers are made for.
    pub fn pass(&self) -> vk::RenderPass {
        self.pass
    }

    /// Measures frames from now on, where the device has a clock.
    pub fn measure(&mut self) -> Result<(), DrawError> {
        self.timestamps = Timestamps::new(&self.device, FRAMES)?;
        Ok(())
    }

    /// Milliseconds of a frame that is over, by the device's clock: each once, none where frames are not measured.
    pub fn take_frame_ms(&mut self) -> Option<f64> {
        self.frame_ms.take()
    }

    /// Waits until the oldest frame in flight is over. The next [`Self::draw`] takes its place.
    pub fn wait(&mut self) -> Result<(), DrawError> {
        let fence = self.frames[self.next].fence;
        self.wait_for(&[fence])?;
        let frame = &mut self.frames[self.next];
        frame.pictures.clear();
        if let Some(timestamps) = &mut self.timestamps {
            self.frame_ms = timestamps.take(self.next)?;
        }
        if let Some(panels) = &mut self.panels {
            for id in frame.freed.drain(..) {
                panels.free_texture(id)?;
            }
        }
        Ok(())
    }

    /// Waits for frames; a device that hangs counts as lost.
    fn wait_for(&self, fences: &[vk::Fence]) -> Result<(), DrawError> {
        let limit = match self.device.info().kind {
            // Software compiles shaders on first use, on cores that may be busy.
            DeviceKind::Cpu => Duration::from_secs(300),
            _ => Duration::from_secs(20),
        };
        let step = "waiting for a frame";
        // SAFETY: the fences are alive; that of a frame that was never submitted is signaled.
        match unsafe { self.device.raw().wait_for_fences(fences, true, limit.as_nanos() as u64) } {
            Err(vk::Result::TIMEOUT) => Err(vk::Result::ERROR_DEVICE_LOST).step(step),
            result => result.step(step),
        }
    }

    /// Writes the textures that changed. Those that are gone stay until the next frame is over.
    pub fn take_textures(&mut self, mut textures: egui::TexturesDelta) -> Result<(), DrawError> {
        self.freed.extend(textures.free.drain());
        self.set_textures(std::mem::take(&mut textures.set))
    }

    /// Submits a frame, after [`Self::wait`] and [`Self::take_textures`], into a framebuffer of `extent`: it waits for `wait`, and
    /// signals `signal`, where they are not null.
    pub fn draw(
        &mut self,
        (framebuffer, extent): (vk::Framebuffer, vk::Extent2D),
        (wait, signal): (vk::Semaphore, vk::Semaphore),
        layer: Option<&Layer>,
        panels: &Panels,
    ) -> Result<(), DrawError> {
        let index = self.next;
        let commands = self.frames[index].commands;
        self.record(commands, framebuffer, extent, layer, panels)?;
        let frame = &mut self.frames[index];
        frame.pictures = layer.into_iter().flat_map(Layer::placed).map(|(picture, _)| Arc::clone(picture)).collect();
        frame.freed.append(&mut self.freed);
        let raw = self.device.raw();
        let list = |semaphore: vk::Semaphore| if semaphore == vk::Semaphore::null() { vec![] } else { vec![semaphore] };
        let (waits, signals, buffers) = (list(wait), list(signal), [commands]);
        let stages = vec![vk::PipelineStageFlags::COLOR_ATTACHMENT_OUTPUT; waits.len()];
        let submit = vk::SubmitInfo::default()
            .command_buffers(&buffers)
            .wait_semaphores(&waits)
            .wait_dst_stage_mask(&stages)
            .signal_semaphores(&signals);
        let queue = self.device.present_queue();
        // SAFETY: the fence is signaled and nobody waits for it; the commands are recorded; the queue is locked.
        unsafe {
            raw.reset_fences(&[frame.fence]).step("drawing")?;
            raw.queue_submit(*queue, &[submit], frame.fence).step("drawing")?;
        }
        for (picture, placement) in layer.into_iter().flat_map(Layer::placed) {
            picture.set_tone(placement.tone());
        }
        self.next = (index + 1) % FRAMES;
        Ok(())
    }

    /// Writes the textures that changed.
    fn set_textures(
        &mut self,
        changed: impl IntoIterator<Item = (egui::TextureId, impl IntoIterator<Item = egui::epaint::ImageDelta>)>,
    ) -> Result<(), DrawError> {
        let mut changed = changed.into_iter().peekable();
        if changed.peek().is_none() {
            return Ok(());
        }
        // A texture that a frame in flight reads may be among them.
        let fences: Vec<vk::Fence> = self.frames.iter().map(|frame| frame.fence).collect();
        self.wait_for(&fences)?;
        let Some(renderer) = &mut self.panels else { return Ok(()) };
        let queue = self.device.present_queue();
        for (id, deltas) in changed {
            for delta in deltas {
                renderer.set_texture(*queue, self.pool, id, &delta)?;
            }
        }
        Ok(())
    }

    fn record(
        &mut self,
        commands: vk::CommandBuffer,
        framebuffer: vk::Framebuffer,
        extent: vk::Extent2D,
        layer: Option<&Layer>,
        panels: &Panels,
    ) -> Result<(), DrawError> {
        let raw = self.device.raw();
        let begin = vk::CommandBufferBeginInfo::default().flags(vk::CommandBufferUsageFlags::ONE_TIME_SUBMIT);
        use vk::PipelineStageFlags as Stage;
        // Pictures are written by the other queue or by the host, which waited for that; this makes them visible here. What the frame before reads of
        // them is not written before it is over.
        let all = Stage::ALL_COMMANDS | Stage::HOST;
        let shaders = Stage::COMPUTE_SHADER | Stage::FRAGMENT_SHADER;
        let written = vk::AccessFlags::MEMORY_WRITE | vk::AccessFlags::HOST_WRITE;
        let read_and_written = vk::AccessFlags::SHADER_READ | vk::AccessFlags::SHADER_WRITE;
        let area = vk::Rect2D { offset: vk::Offset2D::default(), extent };
        let clear = [vk::ClearValue { color: vk::ClearColorValue { float32: [0.11, 0.11, 0.11, 1.0] } }];
        let pass = vk::RenderPassBeginInfo::default()
            .render_pass(self.pass)
            .framebuffer(framebuffer)
            .render_area(area)
            .clear_values(&clear);
        let viewport = vk::Viewport {
            width: extent.width as f32,
            height: extent.height as f32,
            max_depth: 1.0,
            ..vk::Viewport::default()
        };
        // SAFETY: the frame of these commands is over; all handles are alive.
        unsafe {
            raw.begin_command_buffer(commands, &begin).step("drawing")?;
            if let Some(timestamps) = &mut self.timestamps {
                timestamps.begin(commands, self.next);
            }
            barrier(raw, commands, (all, shaders), (written, read_and_written));
            if let (Some(layer), Some(present)) = (layer, &self.present) {
                for (index, (picture, placement)) in layer.placed().enumerate() {
                    present.make_visible(commands, 2 * self.next + index, picture, &placement);
                }
                let (computed, drawn) = (Stage::COMPUTE_SHADER, Stage::FRAGMENT_SHADER);
                let (written, read) = (vk::AccessFlags::SHADER_WRITE, vk::AccessFlags::SHADER_READ);
                barrier(raw, commands, (computed, drawn), (written, read));
            }
            raw.cmd_begin_render_pass(commands, &pass, vk::SubpassContents::INLINE);
            raw.cmd_set_viewport(commands, 0, &[viewport]);
            raw.cmd_set_scissor(commands, 0, &[area]);
        }
        if let (Some(layer), Some(present)) = (layer, &self.present) {
            for (index, (picture, placement)) in layer.placed().enumerate() {
                let split = layer.beside.as_ref().filter(|_| index == 1).map(|beside| beside.split);
                let visible = split.map_or(area, |split| right_of(split, extent));
                // SAFETY: as above.
                unsafe { raw.cmd_set_scissor(commands, 0, &[visible]) };
                present.draw(commands, 2 * self.next + index, picture, &placement);
            }
            // SAFETY: as above.
            unsafe { raw.cmd_set_scissor(commands, 0, &[area]) };
        }
        if let Some(renderer) = &mut self.panels {
            renderer.cmd_draw(commands, extent, panels.pixels_per_point, &panels.primitives)?;
        }
        let raw = self.device.raw();
        // SAFETY: as above.
        unsafe {
            raw.cmd_end_render_pass(commands);
            if let Some(timestamps) = &mut self.timestamps {
                timestamps.end(commands, self.next);
            }
            raw.end_command_buffer(commands).step("drawing")
        }
    }
}

impl Drop for Painter {
    fn drop(&mut self) {
        self.device.wait_idle();
        (self.present, self.panels, self.timestamps) = (None, None, None);
        let raw = self.device.raw();
        // SAFETY: the device is idle; null handles are allowed.
        unsafe {
            for frame in &self.frames {
                raw.destroy_fence(frame.fence, None);
            }
            raw.destroy_command_pool(self.pool, None);
            raw.destroy_render_pass(self.pass, None);
        }
    }
}

/// Lets what comes after see what was before: stages and accesses.
///
/// # Safety
/// The commands must be being recorded, outside of a render pass.
unsafe fn barrier(
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

/// What lies to the right of a place, pixels.
fn right_of(split: f32, extent: vk::Extent2D) -> vk::Rect2D {
    let left = (split.max(0.0).round() as u32).min(extent.width);
    vk::Rect2D {
        offset: vk::Offset2D { x: left as i32, y: 0 },
        extent: vk::Extent2D { width: extent.width - left, ..extent },
    }
}

/// A pass with one colour attachment, cleared first and left in `layout`.
fn render_pass(raw: &ash::Device, format: vk::Format, layout: vk::ImageLayout) -> Result<vk::RenderPass, vk::Result> {
    let attachments = [vk::AttachmentDescription::default()
        .format(format)
        .samples(vk::SampleCountFlags::TYPE_1)
        .load_op(vk::AttachmentLoadOp::CLEAR)
        .store_op(vk::AttachmentStoreOp::STORE)
        .stencil_load_op(vk::AttachmentLoadOp::DONT_CARE)
        .stencil_store_op(vk::AttachmentStoreOp::DONT_CARE)
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
