//! How long frames take by the device's clock: a timestamp before and one after the commands of each frame in flight.

use super::{DrawError, Step};
use ash::vk;
use std::sync::Arc;
use voxtrace_vulkan::Device;

/// Timestamps of a frame.
const TIMES: u32 = 2;

/// The timestamps of the frames in flight.
pub struct Timestamps {
    device: Arc<Device>,
    pool: vk::QueryPool,
    /// For each frame in flight whether its timestamps were submitted and not read yet.
    is_written: Vec<bool>,
}

impl Timestamps {
    /// Those of `frames` frames; `None` where the device has no clock.
    pub fn new(device: &Arc<Device>, frames: usize) -> Result<Option<Self>, DrawError> {
        if device.info().limits.timestamp_period_ns <= 0.0 {
            return Ok(None);
        }
        let info =
            vk::QueryPoolCreateInfo::default().query_type(vk::QueryType::TIMESTAMP).query_count(TIMES * frames as u32);
        // SAFETY: the device is alive.
        let pool = unsafe { device.raw().create_query_pool(&info, None) }.step("creating timestamps")?;
        Ok(Some(Self { device: Arc::clone(device), pool, is_written: vec![false; frames] }))
    }

    /// Records the first timestamp of a frame.
    ///
    /// # Safety
    /// The commands must be being recorded, outside of a render pass, and the last ones of this frame must be over.
    pub unsafe fn begin(&mut self, commands: vk::CommandBuffer, frame: usize) {
        let (raw, first) = (self.device.raw(), TIMES * frame as u32);
        // SAFETY: as the caller says.
        unsafe {
            raw.cmd_reset_query_pool(commands, self.pool, first, TIMES);
            raw.cmd_write_timestamp(commands, vk::PipelineStageFlags::TOP_OF_PIPE, self.pool, first);
        }
        self.is_written[frame] = false;
    }

    /// Records the last timestamp of a frame, which is submitted next.
    ///
    /// # Safety
    /// As of [`Self::begin`].
    pub unsafe fn end(&mut self, commands: vk::CommandBuffer, frame: usize) {
        let stage = vk::PipelineStageFlags::BOTTOM_OF_PIPE;
        // SAFETY: as the caller says.
        unsafe { self.device.raw().cmd_write_timestamp(commands, stage, self.pool, TIMES * frame as u32 + 1) };
        self.is_written[frame] = true;
    }

    /// Milliseconds of a frame that is over, once.
    pub fn take(&mut self, frame: usize) -> Result<Option<f64>, DrawError> {
        if !std::mem::take(&mut self.is_written[frame]) {
            return Ok(None);
        }
        let mut ticks = [0u64; TIMES as usize];
        let flags = vk::QueryResultFlags::TYPE_64 | vk::QueryResultFlags::WAIT;
        // SAFETY: the submit that writes these queries is over.
        unsafe { self.device.raw().get_query_pool_results(self.pool, TIMES * frame as u32, &mut ticks, flags) }
            .step("reading timestamps")?;
        Ok(Some(self.device.info().limits.milliseconds_between(ticks[0], ticks[1])))
    }
}

impl Drop for Timestamps {
    fn drop(&mut self) {
        // SAFETY: whoever draws waited until the queue that draws was idle.
        unsafe { self.device.raw().destroy_query_pool(self.pool, None) };
    }
}
