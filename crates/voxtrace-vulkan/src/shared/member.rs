//! One of the devices that share a picture.

use super::deal::Pace;
use crate::tracer::VulkanTracer;
use std::sync::Arc;
use voxtrace_core::{CpuTracer, PackedScene, TraceError, Tracer};

/// What traces a part.
pub enum Traces {
    /// A device, which gives up when it does not come back.
    Device(Box<VulkanTracer>),
    /// The processor.
    Processor(Box<CpuTracer>),
}

/// Whether a device takes part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum State {
    Ready,
    /// Until another scene is set.
    TooSmall,
    /// For good.
    Lost,
}

/// A device, how quick it is, and whether it takes part.
pub struct Member {
    pub traces: Traces,
    pub name: String,
    pub state: State,
    pub pace: Pace,
}

impl Member {
    pub fn device(tracer: VulkanTracer) -> Self {
        let name = format!("{} ({})", tracer.device().info().name, tracer.device().info().index);
        Self::new(Traces::Device(Box::new(tracer.without_processor())), name)
    }

    pub fn processor() -> Self {
        Self::new(Traces::Processor(Box::new(CpuTracer::new(None))), "the processor".into())
    }

    fn new(traces: Traces, name: String) -> Self {
        Self { traces, name, state: State::Ready, pace: Pace::default() }
    }

    pub fn is_ready(&self) -> bool {
        self.state == State::Ready
    }

    pub fn tracer(&mut self) -> &mut (dyn Tracer + Send) {
        match &mut self.traces {
            Traces::Device(tracer) => &mut **tracer,
            Traces::Processor(tracer) => &mut **tracer,
        }
    }

    pub fn scene(&self) -> Option<Arc<PackedScene>> {
        match &self.traces {
            Traces::Device(tracer) => tracer.scene().cloned(),
            Traces::Processor(tracer) => tracer.scene().ok(),
        }
    }

    /// Puts the errors in force that are planted for the device, on a thread of its own.
    #[cfg(feature = "faults")]
    pub fn follow_faults(&self) {
        if let Traces::Device(tracer) = &self.traces {
            tracer.device().vulkan().options.faults.iter().for_each(crate::Faults::follow);
        }
    }

    /// Leaves the others alone after an error, if they can do without; what it has to say goes to the notes. Else it is everybody's error.
    pub fn leave(&mut self, error: TraceError, notes: &mut Vec<String>) -> Result<(), TraceError> {
        self.state = match error {
            TraceError::OutOfMemory { .. } => State::TooSmall,
            TraceError::DeviceLost { .. } | TraceError::Device { .. } | TraceError::Unsupported(_) => State::Lost,
            error => return Err(error),
        };
        notes.append(&mut self.tracer().take_notes());
        notes.push(format!("{} takes no further part: {error}", self.name));
        Ok(())
    }
}
