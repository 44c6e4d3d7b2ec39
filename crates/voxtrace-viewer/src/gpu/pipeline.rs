//! The pipeline that draws a picture: one triangle over the window, whose shader applies exposure and curve.

use super::{DrawError, Step};
use ash::vk;
use bytemuck::bytes_of;
use std::sync::Arc;
use voxtrace::output::{Operator, ToneMap};
use voxtrace_vulkan::{Device, PICTURE_BINDING, Picture, PresentParams, present_shader};

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

/// The pipeline and its descriptors, one set for each picture of each frame in flight.
pub struct PresentPipeline {
    device: Arc<Device>,
    set_layout: vk::DescriptorSetLayout,
    layout: vk::PipelineLayout,
    pipeline: vk::Pipeline,
    pool: vk::DescriptorPool,
    sets: Vec<vk::DescriptorSet>,
}

impl PresentPipeline {
    pub fn new(device: &Arc<Device>, pass: vk::RenderPass, sets: usize) -> Result<Self, DrawError> {
        let mut made = Self {
            device: Arc::clone(device),
            set_layout: vk::DescriptorSetLayout::null(),
            layout: vk::PipelineLayout::null(),
            pipeline: vk::Pipeline::null(),
            pool: vk::DescriptorPool::null(),
            sets: Vec::new(),
        };
        let raw = device.raw();
        let step = "creating the pipeline of the window";
        let bindings = [vk::DescriptorSetLayoutBinding::default()
            .binding(PICTURE_BINDING)
            .descriptor_type(vk::DescriptorType::STORAGE_BUFFER)
            .descriptor_count(1)
            .stage_flags(vk::ShaderStageFlags::FRAGMENT)];
        let info = vk::DescriptorSetLayoutCreateInfo::default().bindings(&bindings);
        // SAFETY: the device is alive; what was created is destroyed by `drop`, also when a later step fails.
        made.set_layout = unsafe { raw.create_descriptor_set_layout(&info, None) }.step(step)?;
        let layouts = vec![made.set_layout; sets];
        let ranges = [vk::PushConstantRange {
            stage_flags: vk::ShaderStageFlags::FRAGMENT,
            offset: 0,
            size: size_of::<PresentParams>() as u32,
        }];
        let info = vk::PipelineLayoutCreateInfo::default().set_layouts(&layouts[..1]).push_constant_ranges(&ranges);
        // SAFETY: as above.
        made.layout = unsafe { raw.create_pipeline_layout(&info, None) }.step(step)?;
        let sizes = [vk::DescriptorPoolSize { ty: vk::DescriptorType::STORAGE_BUFFER, descriptor_count: sets as u32 }];
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
        let pipeline = made.create(module, pass);
        // SAFETY: pipelines do not need their modules.
        unsafe { raw.destroy_shader_module(module, None) };
        made.pipeline = pipeline.step(step)?;
        Ok(made)
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

    /// Records the drawing of a picture in the render pass, with descriptors that no frame in flight uses.
    pub fn draw(&self, commands: vk::CommandBuffer, set: usize, picture: &Picture, placement: &Placement) {
        let (width, height) = picture.size();
        let Placement { corner, size, tone_map } = *placement;
        let curve = Operator::ALL.iter().position(|&operator| operator == tone_map.operator).unwrap_or(0) as u32;
        let params = PresentParams { corner, size, width, height, exposure: tone_map.exposure.exp2(), curve };
        let set = self.sets[set];
        let buffers = [vk::DescriptorBufferInfo { buffer: picture.handle(), offset: 0, range: vk::WHOLE_SIZE }];
        let write = vk::WriteDescriptorSet::default()
            .dst_set(set)
            .dst_binding(PICTURE_BINDING)
            .descriptor_type(vk::DescriptorType::STORAGE_BUFFER)
            .buffer_info(&buffers);
        let raw = self.device.raw();
        let point = vk::PipelineBindPoint::GRAPHICS;
        // SAFETY: the frame is over, so its set is free; the caller keeps the picture until the new one is over; the commands
        // are being recorded, with viewport and scissor set.
        unsafe {
            raw.update_descriptor_sets(&[write], &[]);
            raw.cmd_bind_pipeline(commands, point, self.pipeline);
            raw.cmd_bind_descriptor_sets(commands, point, self.layout, 0, &[set], &[]);
            raw.cmd_push_constants(commands, self.layout, vk::ShaderStageFlags::FRAGMENT, 0, bytes_of(&params));
            raw.cmd_draw(commands, 3, 1, 0, 0);
        }
    }
}

impl Drop for PresentPipeline {
    fn drop(&mut self) {
        let raw = self.device.raw();
        // SAFETY: the painter waited until the device was idle; null handles are allowed.
        unsafe {
            raw.destroy_pipeline(self.pipeline, None);
            raw.destroy_descriptor_pool(self.pool, None);
            raw.destroy_pipeline_layout(self.layout, None);
            raw.destroy_descriptor_set_layout(self.set_layout, None);
        }
    }
}
