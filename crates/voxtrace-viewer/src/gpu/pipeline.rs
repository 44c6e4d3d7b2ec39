//! The pipelines that show a picture: a compute pass applies exposure and curve, each pixel once and only where the picture or they are new, and
//! one triangle over the window draws the result. (Devices that are made for computing shade fragments slowly.)

use super::{DrawError, Step};
use ash::vk;
use bytemuck::bytes_of;
use std::sync::Arc;
use voxtrace::output::{Operator, ToneMap};
use voxtrace_vulkan::{
    BLUE_LOWEST, DISPLAY_BINDING, Device, PICTURE_BINDING, Picture, PresentParams, Tone, present_shader,
};

/// Pixels of a workgroup of the compute pass.
const WORKGROUP: u32 = 64;
/// What reads the push constants.
const STAGES: vk::ShaderStageFlags =
    vk::ShaderStageFlags::from_raw(vk::ShaderStageFlags::COMPUTE.as_raw() | vk::ShaderStageFlags::FRAGMENT.as_raw());

/// Where a picture goes, and how bright.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// Upper left corner in the window, pixels.
    pub corner: [f32; 2],
    /// Width and height in the window, pixels.
    pub size: [f32; 2],
    /// Exposure and curve.
    pub tone_map: ToneMap,
}

/// The pipelines and their descriptors, one set for each picture of each frame in flight.
pub struct PresentPipeline {
    device: Arc<Device>,
    set_layout: vk::DescriptorSetLayout,
    layout: vk::PipelineLayout,
    curve: vk::Pipeline,
    pipeline: vk::Pipeline,
    pool: vk::DescriptorPool,
    sets: Vec<vk::DescriptorSet>,
    /// Whether blue is the lowest byte of the images that are drawn into.
    is_blue_lowest: bool,
}

impl PresentPipeline {
    /// Pipelines that draw in a pass whose images have a format of eight bits a channel.
    pub fn new(device: &Arc<Device>, pass: vk::RenderPass, format: vk::Format, sets: usize) -> Result<Self, DrawError> {
        let mut made = Self {
            device: Arc::clone(device),
            set_layout: vk::DescriptorSetLayout::null(),
            layout: vk::PipelineLayout::null(),
            curve: vk::Pipeline::null(),
            pipeline: vk::Pipeline::null(),
            pool: vk::DescriptorPool::null(),
            sets: Vec::new(),
            is_blue_lowest: format == vk::Format::B8G8R8A8_UNORM,
        };
        let raw = device.raw();
        let step = "creating the pipeline of the window";
        let bindings = [PICTURE_BINDING, DISPLAY_BINDING].map(|binding| {
            vk::DescriptorSetLayoutBinding::default()
                .binding(binding)
                .descriptor_type(vk::DescriptorType::STORAGE_BUFFER)
                .descriptor_count(1)
                .stage_flags(STAGES)
        });
        let info = vk::DescriptorSetLayoutCreateInfo::default().bindings(&bindings);
        // SAFETY: the device is alive; what was created is destroyed by `drop`, also when a later step fails.
        made.set_layout = unsafe { raw.create_descriptor_set_layout(&info, None) }.step(step)?;
        let layouts = vec![made.set_layout; sets];
        let ranges =
            [vk::PushConstantRange { stage_flags: STAGES, offset: 0, size: size_of::<PresentParams>() as u32 }];
        let info = vk::PipelineLayoutCreateInfo::default().set_layouts(&layouts[..1]).push_constant_ranges(&ranges);
        // SAFETY: as above.
        made.layout = unsafe { raw.create_pipeline_layout(&info, None) }.step(step)?;
        let descriptor_count = (sets * bindings.len()) as u32;
        let sizes = [vk::DescriptorPoolSize { ty: vk::DescriptorType::STORAGE_BUFFER, descriptor_count }];
        let info = vk::DescriptorPoolCreateInfo::default().max_sets(sets as u32).pool_sizes(&sizes);
        // SAFETY: as above.
        made.pool = unsafe { raw.create_descriptor_pool(&info, None) }.step(step)?;
        let info = vk::DescriptorSetAllocateInfo::default().descriptor_pool(made.pool).set_layouts(&layouts);
        // SAFETY: as above.
        made.sets = unsafe { raw.allocate_descriptor_sets(&info) }.step(step)?;
        let words = present_shader();
        let info = vk::ShaderModuleCreateInfo::default().code(&words);
        // SAFETY: the words are a valid module: `cargo xtask shaders` checked them.
        let module = unsafe { raw.create_shader_module(&info, None) }.step(step)?;
        let (curve, pipeline) = (made.create_curve(module), made.create(module, pass));
        // SAFETY: pipelines do not need their modules.
        unsafe { raw.destroy_shader_module(module, None) };
        // Each is kept before the other's error is returned.
        (made.curve, made.pipeline) = (curve.unwrap_or_default(), pipeline.unwrap_or_default());
        curve.and(pipeline).step(step)?;
        Ok(made)
    }

    fn create_curve(&self, module: vk::ShaderModule) -> Result<vk::Pipeline, vk::Result> {
        let stage = vk::PipelineShaderStageCreateInfo::default()
            .stage(vk::ShaderStageFlags::COMPUTE)
            .module(module)
            .name(c"present_curve");
        let info = vk::ComputePipelineCreateInfo::default().stage(stage).layout(self.layout);
        // SAFETY: module and layout are alive, and the layout has what the module needs.
        let made = unsafe { self.device.raw().create_compute_pipelines(vk::PipelineCache::null(), &[info], None) };
        made.map(|pipelines| pipelines[0]).map_err(|(_, error)| error)
    }

    fn create(&self, module: vk::ShaderModule, pass: vk::RenderPass) -> Result<vk::Pipeline, vk::Result> {
        let stage = |stage, name| vk::PipelineShaderStageCreateInfo::default().stage(stage).module(module).name(name);
        let stages = [
            stage(vk::ShaderStageFlags::VERTEX, c"present_vertex"),
            stage(vk::ShaderStageFlags::FRAGMENT, c"present_fragment"),
        ];
        let vertices = vk::PipelineVertexInputStateCreateInfo::default();
        let assembly =
            vk::PipelineInputAssemblyStateCreateInfo::default().topology(vk::PrimitiveTopology::TRIANGLE_LIST);
        let viewport = vk::PipelineViewportStateCreateInfo::default().viewport_count(1).scissor_count(1);
        let raster = vk::PipelineRasterizationStateCreateInfo::default().line_width(1.0);
        let samples =
            vk::PipelineMultisampleStateCreateInfo::default().rasterization_samples(vk::SampleCountFlags::TYPE_1);
        let attachments =
            [vk::PipelineColorBlendAttachmentState::default().color_write_mask(vk::ColorComponentFlags::RGBA)];
        let blend = vk::PipelineColorBlendStateCreateInfo::default().attachments(&attachments);
        let dynamic_states = [vk::DynamicState::VIEWPORT, vk::DynamicState::SCISSOR];
        let dynamic = vk::PipelineDynamicStateCreateInfo::default().dynamic_states(&dynamic_states);
        let info = vk::GraphicsPipelineCreateInfo::default()
            .stages(&stages)
            .vertex_input_state(&vertices)
            .input_assembly_state(&assembly)
            .viewport_state(&viewport)
            .rasterization_state(&raster)
            .multisample_state(&samples)
            .color_blend_state(&blend)
            .dynamic_state(&dynamic)
            .layout(self.layout)
            .render_pass(pass);
        // SAFETY: module, layout and pass are alive, and the layout has what the module needs.
        let made = unsafe { self.device.raw().create_graphics_pipelines(vk::PipelineCache::null(), &[info], None) };
        made.map(|pipelines| pipelines[0]).map_err(|(_, error)| error)
    }

    /// What a picture is made visible with.
    pub fn tone(&self, placement: &Placement) -> Tone {
        let ToneMap { operator, exposure } = placement.tone_map;
        let curve = Operator::ALL.iter().position(|&other| other == operator).unwrap_or(0) as u32;
        let order = if self.is_blue_lowest { BLUE_LOWEST } else { 0 };
        Tone { exposure: exposure.exp2(), curve: curve | order }
    }

    fn params(&self, picture: &Picture, placement: &Placement) -> PresentParams {
        let ((width, height), Tone { exposure, curve }) = (picture.size(), self.tone(placement));
        PresentParams { corner: placement.corner, size: placement.size, width, height, exposure, curve }
    }

    /// Binds a picture to descriptors that no frame in flight uses, and records, before the render pass, what makes it visible, where that was
    /// not done yet: what draws must then wait for compute shaders.
    pub fn make_visible(&self, commands: vk::CommandBuffer, set: usize, picture: &Picture, placement: &Placement) {
        let set = self.sets[set];
        let raw = self.device.raw();
        let all = [(PICTURE_BINDING, picture.handle()), (DISPLAY_BINDING, picture.display())];
        for (binding, buffer) in all {
            let buffers = [vk::DescriptorBufferInfo { buffer, offset: 0, range: vk::WHOLE_SIZE }];
            let write = vk::WriteDescriptorSet::default()
                .dst_set(set)
                .dst_binding(binding)
                .descriptor_type(vk::DescriptorType::STORAGE_BUFFER)
                .buffer_info(&buffers);
            // SAFETY: the frame is over, so its set is free; the caller keeps the picture until the new one is over.
            unsafe { raw.update_descriptor_sets(&[write], &[]) };
        }
        if picture.has_tone(self.tone(placement)) {
            return;
        }
        let (width, height) = picture.size();
        // SAFETY: the commands are being recorded, and the picture is alive until they are over.
        unsafe {
            self.bind(commands, vk::PipelineBindPoint::COMPUTE, self.curve, set, &self.params(picture, placement));
            raw.cmd_dispatch(commands, width.div_ceil(WORKGROUP), height, 1);
        }
    }

    /// Records the drawing of a picture in the render pass, with the descriptors that it was made visible with.
    pub fn draw(&self, commands: vk::CommandBuffer, set: usize, picture: &Picture, placement: &Placement) {
        // SAFETY: the caller keeps the picture until the frame is over; the commands are being recorded, with viewport and scissor set.
        unsafe {
            let set = self.sets[set];
            self.bind(commands, vk::PipelineBindPoint::GRAPHICS, self.pipeline, set, &self.params(picture, placement));
            self.device.raw().cmd_draw(commands, 3, 1, 0, 0);
        }
    }

    /// # Safety
    /// The commands must be being recorded.
    unsafe fn bind(
        &self,
        commands: vk::CommandBuffer,
        point: vk::PipelineBindPoint,
        pipeline: vk::Pipeline,
        set: vk::DescriptorSet,
        params: &PresentParams,
    ) {
        let raw = self.device.raw();
        // SAFETY: as the caller says; pipeline and set fit the layout.
        unsafe {
            raw.cmd_bind_pipeline(commands, point, pipeline);
            raw.cmd_bind_descriptor_sets(commands, point, self.layout, 0, &[set], &[]);
            raw.cmd_push_constants(commands, self.layout, STAGES, 0, bytes_of(params));
        }
    }
}

impl Drop for PresentPipeline {
    fn drop(&mut self) {
        let raw = self.device.raw();
        // SAFETY: the painter waited until the queue that draws was idle; null handles are allowed.
        unsafe {
            raw.destroy_pipeline(self.curve, None);
            raw.destroy_pipeline(self.pipeline, None);
            raw.destroy_descriptor_pool(self.pool, None);
            raw.destroy_pipeline_layout(self.layout, None);
            raw.destroy_descriptor_set_layout(self.set_layout, None);
        }
    }
}
