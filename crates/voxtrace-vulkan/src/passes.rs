//! Compute pipelines, made when first needed.

use crate::bindings::Bindings;
use crate::device::Device;
use crate::errors::Named;
use crate::spirv::{Module, Specialization};
use ash::vk;
use std::collections::HashMap;
use std::ffi::CString;
use std::sync::Arc;
use voxtrace::{Integrator, TraceError};

/// Invocations of a workgroup.
pub const WORKGROUP: u32 = 64;

/// What a pass does.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Entry {
    /// Finds the first hit of rays.
    Cast,
    /// Adds samples, the study's way.
    RenderEssay,
    /// Adds samples, looking for light.
    RenderPath,
    /// A group of functions of the self-test.
    SelfTest(&'static str),
}

impl Entry {
    /// The entry that renders with an integrator.
    pub fn of(integrator: Integrator) -> Self {
        match integrator {
            Integrator::Essay => Self::RenderEssay,
            Integrator::Path => Self::RenderPath,
        }
    }

    /// Name of the entry point.
    pub fn name(self) -> &'static str {
        match self {
            Self::Cast => "cast_rays",
            Self::RenderEssay => "render_essay",
            Self::RenderPath => "render_path",
            Self::SelfTest(name) => name,
        }
    }
}

/// What a pipeline is made for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Variant {
    pub entry: Entry,
    pub is_exact: bool,
    pub is_single: bool,
}

/// The compute pipelines of one module.
pub struct ComputePasses {
    device: Arc<Device>,
    layout: vk::PipelineLayout,
    module: Module,
    pipelines: HashMap<Variant, vk::Pipeline>,
}

impl ComputePasses {
    /// The passes of a module; `bindings` must outlive them.
    pub fn new(device: &Arc<Device>, bindings: &Bindings, module: Module) -> Self {
        Self { device: Arc::clone(device), layout: bindings.layout, module, pipelines: HashMap::new() }
    }

    /// The pipeline of a variant.
    pub fn get(&mut self, variant: Variant) -> Result<vk::Pipeline, TraceError> {
        if let Some(&pipeline) = self.pipelines.get(&variant) {
            return Ok(pipeline);
        }
        let entry = variant.entry.name();
        if !self.module.has_entry(entry) {
            return Err(TraceError::Unsupported(format!("the pass {} has no {entry}", self.module.name)));
        }
        let step = format!("compiling {} of the pass {}", entry, self.module.name);
        let raw = &self.device.raw;
        let words = self.module.words();
        let info = vk::ShaderModuleCreateInfo::default().code(&words);
        // SAFETY: the words are a valid module: `cargo xtask shaders` checked them.
        let module = unsafe { raw.create_shader_module(&info, None) }.named(&step)?;
        let name = CString::new(entry).expect("entry points have no zero in their names");
        let values = Specialization::new(variant.is_exact, variant.is_single);
        let specialization = values.info();
        let stage = vk::PipelineShaderStageCreateInfo::default()
            .stage(vk::ShaderStageFlags::COMPUTE)
            .module(module)
            .name(&name)
            .specialization_info(&specialization);
        let info = vk::ComputePipelineCreateInfo::default().stage(stage).layout(self.layout);
        // SAFETY: module and layout are alive, and the layout has every binding of the module.
        let pipelines = unsafe { raw.create_compute_pipelines(vk::PipelineCache::null(), &[info], None) };
        // SAFETY: pipelines do not need their modules.
        unsafe { raw.destroy_shader_module(module, None) };
        let pipeline = pipelines.map_err(|(_, error)| error).named(&step)?[0];
        self.pipelines.insert(variant, pipeline);
        Ok(pipeline)
    }
}

impl Drop for ComputePasses {
    fn drop(&mut self) {
        for &pipeline in self.pipelines.values() {
            // SAFETY: the submitter, dropped before, waited for everything.
            unsafe { self.device.raw.destroy_pipeline(pipeline, None) };
        }
    }
}
