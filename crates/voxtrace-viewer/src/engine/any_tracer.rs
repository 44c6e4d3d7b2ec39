//! Either kind of tracer, with the scene that it traces.

use std::sync::Arc;
use voxtrace::{CpuTracer, PackedScene, TraceError, Tracer};
use voxtrace_vulkan::VulkanTracer;

/// Either kind of tracer.
pub(super) enum AnyTracer {
    Cpu(Box<CpuTracer>),
    Device(Box<VulkanTracer>),
}

impl AnyTracer {
    pub fn as_tracer(&mut self) -> &mut dyn Tracer {
        match self {
            Self::Cpu(tracer) => &mut **tracer,
            Self::Device(tracer) => &mut **tracer,
        }
    }

    /// The scene that it traces, as edits have made it.
    pub fn scene(&self) -> Option<Arc<PackedScene>> {
        match self {
            Self::Cpu(tracer) => tracer.scene().ok(),
            Self::Device(tracer) => tracer.scene().cloned(),
        }
    }

    /// Takes the same scene in another light. After edits each tracer has arrays of its own, which stay.
    pub fn set_light_of(&mut self, scene: &Arc<PackedScene>) -> Result<(), TraceError> {
        let own = self.scene().filter(|own| !Arc::ptr_eq(own.geometry(), scene.geometry()));
        let mut shared = own.as_ref().map(|_| (**scene).clone());
        let is_shared = own.zip(shared.as_mut()).is_some_and(|(own, shared)| shared.take_arrays_of(&own));
        match shared.filter(|_| is_shared) {
            Some(shared) => self.as_tracer().set_scene(&Arc::new(shared)),
            None => self.as_tracer().set_scene(scene),
        }
    }
}
