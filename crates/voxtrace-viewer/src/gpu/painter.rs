//! One frame of a window or of a test: the picture, then the panels, into any target of the right format. Two frames are in flight.

use super::copy::{self, SURROUND};
use super::layer::{Layer, Panels, Target};
use super::panel_memory::PanelMemory;
use super::panel_waits;
use super::pass::{barrier, render_pass};
use super::pipeline::PresentPipeline;
use super::timestamps::Timestamps;
use super::{DrawError, Step};
use ash::vk;
use egui_ash_renderer::{Options, RenderMode, Renderer};
use std::ops::Range;
use std::sync::Arc;
use voxtrace_vulkan::{Device, Picture};

/// Frames in flight.
pub const FRAMES: usize = 2;

/// What a frame in flight uses.
#[derive(Default)]
struct Frame {
    commands: vk::CommandBuffer,
    fence: vk::Fence,
    /// Whether it was submitted with the fence, which is signaled some time then.
    is_submitted: bool,
    pictures: Vec<Arc<Picture>>,
    /// Textures that go when the frame is over.
    freed: Vec<egui::TextureId>,
}

/// Draws frames on a device.
pub struct Painter {
    device: Arc<Device>,
    /// What is drawn into a cleared image, and over a picture that was copied there.
    pass: vk::RenderPass,
    pass_above: vk::RenderPass,
    /// What images are left in.
    layout: vk::ImageLayout,
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
            pass: vk::RenderPass::null(),
            pass_above: vk::RenderPass::null(),
            layout,
            pool: vk::CommandPool::null(),
            frames: Default::default(),
            next: 0,
            freed: Vec::new(),
            present: None,
            panels: None,
            timestamps: None,
            frame_ms: None,
        };
        painter.pass = render_pass(raw, format, layout, false).step(step)?;
        painter.pass_above = render_pass(raw, format, layout, true).step(step)?;
        let info = vk::CommandPoolCreateInfo::default()
            .flags(vk::CommandPoolCreateFlags::RESET_COMMAND_BUFFER)
            .queue_family_index(device.info().queue_family());
        // SAFETY: the device is alive; what was created is destroyed by `drop`, also when a later step fails.
        painter.pool = unsafe { raw.create_command_pool(&info, None) }.step(step)?;
        let info =
            vk::CommandBufferAllocateInfo::default().command_pool(painter.pool).command_buffer_count(FRAMES as u32);
        // SAFETY: as above.
        let commands = unsafe { raw.allocate_command_buffers(&info) }.step(step)?;
        for (frame, commands) in painter.frames.iter_mut().zip(commands) {
            frame.commands = commands;
            // SAFETY: as above.
            frame.fence = unsafe { raw.create_fence(&vk::FenceCreateInfo::default(), None) }.step(step)?;
        }
        painter.present = Some(PresentPipeline::new(device, painter.pass, format, 2 * FRAMES)?);
        let options = Options { in_flight_frames: FRAMES, ..Options::default() };
        painter.panels = Some(Renderer::with_allocator(
            PanelMemory::new(device),
            panel_waits::functions(device),
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
        self.wait_for(self.next..self.next + 1)?;
        let frame = &mut self.frames[self.next];
        frame.pictures.clear();
        // Of a frame that could not be submitted they never come.
        if let Some(timestamps) = self.timestamps.as_mut().filter(|_| frame.is_submitted) {
            self.frame_ms = timestamps.take(self.next)?;
        }
        if let Some(panels) = &mut self.panels {
            for id in frame.freed.drain(..) {
                panels.free_texture(id)?;
            }
        }
        Ok(())
    }

    /// Waits for frames; a device that hangs is given up, and counts as lost.
    fn wait_for(&self, frames: Range<usize>) -> Result<(), DrawError> {
        let step = "waiting for a frame";
        if self.device.is_given_up() {
            return Err(vk::Result::ERROR_DEVICE_LOST).step(step);
        }
        let submitted = self.frames[frames].iter().filter(|frame| frame.is_submitted);
        let fences: Vec<vk::Fence> = submitted.map(|frame| frame.fence).collect();
        if fences.is_empty() {
            return Ok(());
        }
        // SAFETY: the fences are alive, and those of frames that were submitted.
        unsafe { self.device.wait_for_fences(&fences) }.step(step)
    }

    /// Writes the textures that changed. Those that are gone stay until the next frame is over.
    pub fn take_textures(&mut self, mut textures: egui::TexturesDelta) -> Result<(), DrawError> {
        self.freed.extend(textures.free.drain());
        self.set_textures(std::mem::take(&mut textures.set))
    }

    /// Submits a frame, after [`Self::wait`] and [`Self::take_textures`], into a target: it waits for `wait`, and
    /// signals `signal`, where they are not null.
    pub fn draw(
        &mut self,
        target: &Target,
        (wait, signal): (vk::Semaphore, vk::Semaphore),
        layer: Option<&Layer>,
        panels: &Panels,
    ) -> Result<(), DrawError> {
        let index = self.next;
        let commands = self.frames[index].commands;
        self.record(commands, target, layer, panels)?;
        let frame = &mut self.frames[index];
        frame.pictures = layer.into_iter().flat_map(Layer::placed).map(|(picture, _)| Arc::clone(picture)).collect();
        let raw = self.device.raw();
        let list = |semaphore: vk::Semaphore| if semaphore == vk::Semaphore::null() { vec![] } else { vec![semaphore] };
        let (waits, signals, buffers) = (list(wait), list(signal), [commands]);
        let writes = vk::PipelineStageFlags::COLOR_ATTACHMENT_OUTPUT | vk::PipelineStageFlags::TRANSFER;
        let stages = vec![writes; waits.len()];
        let submit = vk::SubmitInfo::default()
            .command_buffers(&buffers)
            .wait_semaphores(&waits)
            .wait_dst_stage_mask(&stages)
            .signal_semaphores(&signals);
        let queue = self.device.present_queue();
        frame.is_submitted = false;
        // SAFETY: the fence is of a frame that is over, and nobody waits for it; the commands are recorded; the queue is locked.
        unsafe {
            raw.reset_fences(&[frame.fence]).step("drawing")?;
            raw.queue_submit(*queue, &[submit], frame.fence).step("drawing")?;
        }
        frame.is_submitted = true;
        // Not before: of a frame that could not be submitted nobody waits for those before it, which read them.
        frame.freed.append(&mut self.freed);
        if let Some(present) = &self.present {
            layer.into_iter().flat_map(Layer::placed).for_each(|(picture, at)| picture.set_tone(present.tone(&at)));
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
        self.wait_for(0..FRAMES)?;
        let Some(renderer) = &mut self.panels else { return Ok(()) };
        let queue = self.device.present_queue();
        for (id, deltas) in changed {
            for delta in deltas {
                panel_waits::waiting(&self.device, || renderer.set_texture(*queue, self.pool, id, &delta))?;
            }
        }
        Ok(())
    }

    fn record(
        &mut self,
        commands: vk::CommandBuffer,
        target: &Target,
        layer: Option<&Layer>,
        panels: &Panels,
    ) -> Result<(), DrawError> {
        let begin = vk::CommandBufferBeginInfo::default().flags(vk::CommandBufferUsageFlags::ONE_TIME_SUBMIT);
        // SAFETY: the frame of these commands is over.
        unsafe {
            self.device.raw().begin_command_buffer(commands, &begin).step("drawing")?;
            if let Some(timestamps) = &mut self.timestamps {
                timestamps.begin(commands, self.next);
            }
        }
        self.make_visible(commands, layer);
        let copied = copy::copied(layer, target);
        let beside = copied.map(|picture| copy::beside(picture.size(), target.extent));
        let is_done = panels.primitives.is_empty() && beside.as_ref().is_some_and(Vec::is_empty);
        if let Some(picture) = copied {
            let layout = if is_done { self.layout } else { vk::ImageLayout::COLOR_ATTACHMENT_OPTIMAL };
            // SAFETY: what made it visible is waited for by transfers; who draws keeps the picture until the frame is over.
            unsafe { copy::record(self.device.raw(), commands, target, picture, layout) };
        }
        if !is_done {
            self.record_pass(commands, target, layer.filter(|_| copied.is_none()), beside, panels)?;
        }
        // SAFETY: as above.
        unsafe {
            if let Some(timestamps) = &mut self.timestamps {
                timestamps.end(commands, self.next);
            }
            self.device.raw().end_command_buffer(commands).step("drawing")
        }
    }

    /// Records what makes the pictures of a layer visible, for what draws and for copies.
    fn make_visible(&self, commands: vk::CommandBuffer, layer: Option<&Layer>) {
        use vk::PipelineStageFlags as Stage;
        let raw = self.device.raw();
        // Pictures are written by the other queue or by the host, which waited for that; this makes them visible here. What the frame before reads of
        // them is not written before it is over.
        let all = Stage::ALL_COMMANDS | Stage::HOST;
        let users = Stage::FRAGMENT_SHADER | Stage::TRANSFER;
        let written = vk::AccessFlags::MEMORY_WRITE | vk::AccessFlags::HOST_WRITE;
        let used = vk::AccessFlags::SHADER_READ | vk::AccessFlags::TRANSFER_READ;
        // SAFETY: the commands are being recorded, outside of a render pass.
        unsafe {
            let by_shaders = used | vk::AccessFlags::SHADER_WRITE;
            barrier(raw, commands, (all, users | Stage::COMPUTE_SHADER), (written, by_shaders));
            if let (Some(layer), Some(present)) = (layer, &self.present) {
                for (index, (picture, placement)) in layer.placed().enumerate() {
                    present.make_visible(commands, 2 * self.next + index, picture, &placement);
                }
                barrier(raw, commands, (Stage::COMPUTE_SHADER, users), (vk::AccessFlags::SHADER_WRITE, used));
            }
        }
    }

    /// Records the render pass: the pictures of a layer into an image that is cleared first, or what is `beside` a picture that was copied, and the
    /// panels.
    fn record_pass(
        &mut self,
        commands: vk::CommandBuffer,
        target: &Target,
        layer: Option<&Layer>,
        beside: Option<Vec<vk::ClearRect>>,
        panels: &Panels,
    ) -> Result<(), DrawError> {
        let extent = target.extent;
        let area = vk::Rect2D { offset: vk::Offset2D::default(), extent };
        let clear = [vk::ClearValue { color: SURROUND }];
        let pass = vk::RenderPassBeginInfo::default()
            .render_pass(if beside.is_some() { self.pass_above } else { self.pass })
            .framebuffer(target.framebuffer)
            .render_area(area)
            .clear_values(&clear);
        let viewport = vk::Viewport {
            width: extent.width as f32,
            height: extent.height as f32,
            max_depth: 1.0,
            ..vk::Viewport::default()
        };
        let raw = self.device.raw();
        // SAFETY: the commands are being recorded; all handles are alive.
        unsafe {
            raw.cmd_begin_render_pass(commands, &pass, vk::SubpassContents::INLINE);
            raw.cmd_set_viewport(commands, 0, &[viewport]);
            raw.cmd_set_scissor(commands, 0, &[area]);
            if let Some(strips) = beside.filter(|strips| !strips.is_empty()) {
                let color = vk::ClearAttachment {
                    aspect_mask: vk::ImageAspectFlags::COLOR,
                    color_attachment: 0,
                    clear_value: clear[0],
                };
                raw.cmd_clear_attachments(commands, &[color], &strips);
            }
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
        // SAFETY: as above.
        unsafe { self.device.raw().cmd_end_render_pass(commands) };
        Ok(())
    }
}

impl Drop for Painter {
    fn drop(&mut self) {
        let is_idle = self.device.wait_presented();
        let parts = (self.present.take(), self.panels.take(), self.timestamps.take());
        if !is_idle {
            return std::mem::forget(parts);
        }
        drop(parts);
        let raw = self.device.raw();
        // SAFETY: the queue that draws is idle; null handles are allowed.
        unsafe {
            for frame in &self.frames {
                raw.destroy_fence(frame.fence, None);
            }
            raw.destroy_command_pool(self.pool, None);
            raw.destroy_render_pass(self.pass, None);
            raw.destroy_render_pass(self.pass_above, None);
        }
    }
}

/// What lies to the right of a place, pixels.
fn right_of(split: f32, extent: vk::Extent2D) -> vk::Rect2D {
    let left = (split.max(0.0).round() as u32).min(extent.width);
    vk::Rect2D {
        offset: vk::Offset2D { x: left as i32, y: 0 },
        extent: vk::Extent2D { width: extent.width - left, ..extent },
    }
}
