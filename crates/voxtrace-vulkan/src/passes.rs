//! Pipelines, made when first needed.

use crate::bindings::Bindings;
use crate::buffer::Buffer;
use crate::device::Device;
use crate::errors::ResultExt;
use crate::ray_program::RayProgram;
use crate::records::WaveStep;
use crate::spirv::Module;
use crate::variant::{Specialization, Variant};
use ash::vk;
use bytemuck::{Pod, bytes_of};
use std::collections::HashMap;
use std::ffi::CString;
use std::sync::Arc;
use voxtrace_core::TraceError;

/// Invocations of a workgroup.
pub const WORKGROUP: u32 = 64;

/// The pipelines of one module.
pub struct Passes {
    device: Arc<Device>,
    layout: vk::PipelineLayout,
    module: Module,
    /// The same pass where paths know all materials, if there is one.
    materials: Option<Module>,
    programs: HashMap<Variant, Program>,
}

/// What runs a pass.
pub enum Program {
    /// A compute shader with workgroups of [`WORKGROUP`].
    Compute(vk::Pipeline),
    /// A ray tracing pipeline.
    Rays(Box<RayProgram>),
}

impl Passes {
    /// The passes of a module; `bindings` must outlive them.
    pub fn new(device: &Arc<Device>, bindings: &Bindings, module: Module) -> Self {
        Self { device: Arc::clone(device), layout: bindings.layout, module, materials: None, programs: HashMap::new() }
    }

    /// The same passes, with a module for scenes that are not all matte.
    pub fn with_materials(mut self, module: Module) -> Self {
        self.materials = Some(module);
        self
    }

    /// Makes the program of a variant, unless it is made already.
    pub fn prepare(&mut self, variant: Variant) -> Result<(), TraceError> {
        if self.programs.contains_key(&variant) {
            return Ok(());
        }
        let entry = variant.entry.name();
        let source = self.materials.filter(|_| variant.has_materials).unwrap_or(self.module);
        if !source.has_entry(entry) {
            return Err(TraceError::Unsupported(format!("the pass {} has no {entry}", source.name)));
        }
        let step = format!("compiling {} of the pass {}", entry, source.name);
        let raw = &self.device.raw;
        let words = source.words();
        let info = vk::ShaderModuleCreateInfo::default().code(&words);
        // SAFETY: the words are a valid module: `cargo xtask shaders` checked them.
        let module = unsafe { raw.create_shader_module(&info, None) }.context(&step)?;
        let program = match self.module.has_entry("intersect") {
            true => RayProgram::new(&self.device, self.layout, module, variant, &step)
                .map(|program| Program::Rays(Box::new(program))),
            false => self.compute(module, variant, &step).map(Program::Compute),
        };
        // SAFETY: pipelines do not need their modules.
        unsafe { raw.destroy_shader_module(module, None) };
        self.programs.insert(variant, program?);
        Ok(())
    }

    fn compute(&self, module: vk::ShaderModule, variant: Variant, step: &str) -> Result<vk::Pipeline, TraceError> {
        let name = CString::new(variant.entry.name()).expect("entry points have no zero in their names");
        let values = Specialization::new(&variant);
        let specialization = values.info();
        let stage = vk::PipelineShaderStageCreateInfo::default()
            .stage(vk::ShaderStageFlags::COMPUTE)
            .module(module)
            .name(&name)
            .specialization_info(&specialization);
        let info = vk::ComputePipelineCreateInfo::default().stage(stage).layout(self.layout);
        // SAFETY: module and layout are alive, and the layout has every binding of the module.
        let pipelines = unsafe { self.device.raw.create_compute_pipelines(vk::PipelineCache::null(), &[info], None) };
        Ok(pipelines.map_err(|(_, error)| error).context(step)?[0])
    }

    /// Most items that one launch can have.
    pub fn most_items(&self) -> u64 {
        let limits = &self.device.info().limits;
        let compute = u64::from(limits.max_workgroups) * u64::from(WORKGROUP);
        match self.module.has_entry("intersect") {
            true => self.device.info().ray_tracing.max_launch.min(compute),
            false => compute,
        }
    }

    /// What a launch of `count` items counts when all of them ran.
    pub fn proof(&self, variant: Variant, count: u32) -> u32 {
        match self.programs.get(&variant) {
            Some(Program::Rays(_)) => count,
            _ => count.div_ceil(WORKGROUP),
        }
    }

    /// Records a launch of `count` items of a prepared variant.
    pub fn launch(&self, variant: Variant, bindings: &Bindings, commands: vk::CommandBuffer, offset: u32, count: u32) {
        let raw = &self.device.raw;
        match self.programs.get(&variant) {
            Some(Program::Compute(pipeline)) => {
                bindings.use_in(commands, vk::PipelineBindPoint::COMPUTE, offset);
                // SAFETY: the pipeline is alive and its bindings are set; the count is within the device's limits.
                unsafe {
                    raw.cmd_bind_pipeline(commands, vk::PipelineBindPoint::COMPUTE, *pipeline);
                    raw.cmd_dispatch(commands, count.div_ceil(WORKGROUP), 1, 1);
                }
            }
            Some(Program::Rays(program)) => {
                bindings.use_in(commands, vk::PipelineBindPoint::RAY_TRACING_KHR, offset);
                program.launch(commands, count);
            }
            // Nothing runs, and the proof of work says so.
            None => {}
        }
    }
}

/// How a step of a wave is launched.
pub enum Launch<'a> {
    /// So many workgroups.
    Groups(u32),
    /// As many along three axes as stand in a buffer from a word on.
    Told(&'a Buffer, u32),
}

impl Passes {
    /// Records a step by a prepared variant, a compute shader, with its push constants. The bindings are in use already.
    pub fn launch_step<T: Pod>(
        &self,
        variant: Variant,
        bindings: &Bindings,
        commands: vk::CommandBuffer,
        step: T,
        launch: &Launch,
    ) {
        const { assert!(size_of::<T>() <= size_of::<WaveStep>(), "the layout has room for as much") };
        let Some(Program::Compute(pipeline)) = self.programs.get(&variant) else { return };
        let raw = &self.device.raw;
        // SAFETY: the pipeline is alive and its bindings are set; counts are within the device's limits, and the buffer is one of indirect commands.
        unsafe {
            raw.cmd_bind_pipeline(commands, vk::PipelineBindPoint::COMPUTE, *pipeline);
            raw.cmd_push_constants(commands, bindings.layout, vk::ShaderStageFlags::COMPUTE, 0, bytes_of(&step));
            match launch {
                Launch::Groups(count) => raw.cmd_dispatch(commands, *count, 1, 1),
                Launch::Told(buffer, word) => raw.cmd_dispatch_indirect(commands, buffer.handle, 4 * u64::from(*word)),
            }
        }
    }
}

impl Drop for Passes {
    fn drop(&mut self) {
        if self.device.hung().is_some() {
            return;
        }
        for program in self.programs.values() {
            if let Program::Compute(pipeline) = program {
                // SAFETY: the submitter, dropped before, waited for everything.
                unsafe { self.device.raw.destroy_pipeline(*pipeline, None) };
            }
        }
    }
}
