//! What the device did, by its own clock and counters.

use crate::commands::Finished;
use crate::records::Counter;

/// What the device did in the last call of `render`, `cast` or `set_placement`, told by its own clock and counters.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Statistics {
    /// Time of all submits on the device, milliseconds.
    pub gpu_ms: f64,
    /// The longest of them.
    pub longest_submit_ms: f64,
    /// How many there were.
    pub submits: u64,
    /// Rays from the camera, or rays cast.
    pub camera_rays: u64,
    /// Rays that left a surface.
    pub bounce_rays: u64,
    /// Rays towards lights.
    pub shadow_rays: u64,
    /// Sequence number that the shaders of the last submit wrote; it grows by one with each submit of a tracer.
    pub sequence: u32,
}

impl Statistics {
    pub(crate) fn add(&mut self, finished: &Finished) {
        let count = |counter: Counter| u64::from(finished.counters[counter as usize]);
        self.gpu_ms += finished.gpu_ms;
        self.longest_submit_ms = self.longest_submit_ms.max(finished.gpu_ms);
        self.submits += 1;
        self.camera_rays += count(Counter::CameraRays);
        self.bounce_rays += count(Counter::BounceRays);
        self.shadow_rays += count(Counter::ShadowRays);
        self.sequence = finished.counters[Counter::Sequence as usize];
    }
}
