//! Frames of real-time light (a stand-in until the passes are there: one sample of a tracer of its own).

use super::VulkanTracer;
use crate::picture::Picture;
use std::sync::Arc;
use voxtrace_core::{Frame, Progress, TraceError, Tracer};

/// How many pixels have a path of their own in a frame.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Rate {
    /// All.
    #[default]
    Full,
    /// Half of them.
    Half,
}

/// What a frame of real-time light took.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RealTimeFrame {
    /// Milliseconds of all passes, by the device's clock.
    pub gpu_ms: f64,
    /// Those of each pass.
    pub passes: Vec<(&'static str, f64)>,
    /// Bytes on the device beyond the scene.
    pub bytes: u64,
}

impl VulkanTracer {
    /// Traces the next frame of real-time light and writes it to `picture`, of the frame's size.
    ///
    /// # Errors
    /// As [`Self::resolve`].
    pub fn show_real_time(
        &mut self,
        frame: &Frame,
        _rate: Rate,
        picture: &Picture,
    ) -> Result<Option<RealTimeFrame>, TraceError> {
        if self.is_on_cpu() {
            return Ok(None);
        }
        let Some(scene) = self.scene.clone() else { return Err(TraceError::NoScene) };
        let mut scratch = Self::new(Arc::clone(&self.device), self.settings)?;
        scratch.set_scene(&scene)?;
        let frame = frame.clone().samples(1).seed(frame.seed.wrapping_add(77));
        match scratch.render_shown(&frame, &Progress::default(), picture)? {
            None => Ok(None),
            Some(_) => {
                let gpu_ms = scratch.statistics().gpu_ms;
                Ok(Some(RealTimeFrame { gpu_ms, passes: vec![("paths", gpu_ms)], bytes: 0 }))
            }
        }
    }

    /// Forgets what is known from frame to frame.
    pub fn forget_real_time(&mut self) {}
}
