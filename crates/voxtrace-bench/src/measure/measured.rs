//! What measuring a cell gives, whole or not.

use super::conformance::Conformance;
use super::processor::Processor;
use super::walked::Walked;
use crate::numbers::FrameLine;
use serde_json::Value;
use std::collections::BTreeMap;
use voxtrace::{Film, Hit};
use voxtrace_vulkan::AccelReport;

/// What a cell gave, whole or not.
#[derive(Clone, Debug, Default)]
pub struct Measured {
    pub frames: Vec<FrameLine>,
    pub primary: Vec<FrameLine>,
    pub lost: u32,
    /// Why there are no frames, or no more of them.
    pub failure: Option<String>,
    pub is_interrupted: bool,
    pub notes: Vec<String>,
    pub memory: Option<Memory>,
    /// How often the whole film was read and held every frame.
    pub film_checks: u32,
    /// Clocks before the first frame and after the last, see `machine::clocks`.
    pub clocks: [Value; 2],
    /// What the processors did while the frames were measured.
    pub processor: Processor,
    /// Which walks traced the rays; `None` on a device.
    pub walked: Option<Walked>,
    pub conformance: Option<Conformance>,
    /// Whether what the device reads of time is its own clock.
    pub has_gpu_clock: bool,
    /// The picture, and what the rays through the middles of its pixels met; not kept in the results.
    pub film: Option<Film>,
    pub hits: Vec<Hit>,
}

/// Bytes on the device by name, as the driver says that it needs them.
#[derive(Clone, Debug, Default)]
pub struct Memory {
    pub bytes: BTreeMap<String, u64>,
    pub total: u64,
    pub peak: u64,
    pub accel: Option<AccelReport>,
}
