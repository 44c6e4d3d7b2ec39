//! Paths in waves: memory of paths under way, and the steps that trace them. `shaders/pass/waves.slang` says how they go.

use crate::barrier::barrier;
use crate::bindings::Bindings;
use crate::buffer::Buffer;
use crate::device::Device;
use crate::passes::{Launch, Passes, WORKGROUP};
use crate::records::{Dispatch, WAVE_COUNTS_WORDS, WAVE_ROUND_WORDS, WaveStep, binding};
use crate::variant::{Entry, Variant};
use ash::vk;
use gpu_allocator::MemoryLocation;
use std::sync::Arc;
use voxtrace_core::TraceError;

/// Most paths of a wave where nothing else is said: twice the pixels of a common screen, so that all its processors have work.
pub const MOST_PATHS: u32 = 1 << 22;
/// For fewer paths waves take longer than one shader that follows each, with exact and with quick shaders: their steps wait for each other.
pub const LEAST_PATHS: u32 = 1 << 18;
/// As [`LEAST_PATHS`].
pub const LEAST_QUICK_PATHS: u32 = 1 << 20;
/// Share of the memory left that paths may take.
const SHARE: u64 = 4;
/// Rows of 16 bytes of a path among matte things, and of one that knows all materials.
const ROWS: u64 = 7;
const ROWS_IN_MEDIA: u64 = 13;
/// Queues: two in turn, and the paths that met light.
const QUEUES: u64 = 3;
/// Rounds after which so few paths are left that one shader follows each to its end: Russian roulette begins with the third bounce, but paths pass
/// boundaries of media beside.
const ROUNDS: u32 = 4;
const ROUNDS_IN_MEDIA: u32 = 8;

/// The steps of a wave.
pub const STEPS: [&str; 6] = ["wave_begin", "wave_walk", "wave_shade", "wave_lit", "wave_finish", "wave_end"];

/// Memory of paths under way.
pub struct Waves {
    device: Arc<Device>,
    queues: Buffer,
    paths: Buffer,
    capacity: u32,
    rows: u64,
    rounds: u32,
}

impl Waves {
    /// Rows of a path of a variant.
    fn rows_of(variant: Variant) -> u64 {
        if variant.has_materials { ROWS_IN_MEDIA } else { ROWS }
    }

    /// Whether its paths are those of a variant.
    pub fn suits(&self, variant: Variant) -> bool {
        self.rows == Self::rows_of(variant)
    }

    /// Paths of a variant that have room on a device, where `held` bytes of those that are there would be free.
    pub fn room_on(device: &Device, variant: Variant, held: u64) -> u32 {
        let rows = Self::rows_of(variant);
        let limits = &device.info().limits;
        let of_buffer = limits.max_storage_bytes() / (16 * rows);
        let of_memory = (device.available_bytes() + held) / SHARE / (16 * rows + 4 * QUEUES);
        let of_launch = u64::from(limits.max_workgroups) * u64::from(WORKGROUP);
        of_buffer.min(of_memory).min(of_launch).min(u32::MAX.into()) as u32
    }

    /// Room for so many paths of a variant.
    pub fn new(device: &Arc<Device>, variant: Variant, capacity: u32) -> Result<Self, TraceError> {
        let rows = Self::rows_of(variant);
        let usage = vk::BufferUsageFlags::STORAGE_BUFFER
            | vk::BufferUsageFlags::TRANSFER_DST
            | vk::BufferUsageFlags::INDIRECT_BUFFER;
        let size = 4 * (u64::from(WAVE_COUNTS_WORDS) + QUEUES * u64::from(capacity));
        Ok(Self {
            device: Arc::clone(device),
            queues: Buffer::new(device, "queues of paths", size, usage, MemoryLocation::GpuOnly)?,
            paths: Buffer::storage(device, "paths", 16 * rows * u64::from(capacity))?,
            capacity,
            rows,
            rounds: if variant.has_materials { ROUNDS_IN_MEDIA } else { ROUNDS },
        })
    }

    /// Nothing may be in flight.
    pub fn bind(&self, bindings: &Bindings) {
        bindings.bind(binding::PATHS, &self.paths);
        bindings.bind(binding::QUEUES, &self.queues);
    }

    /// Binds something else in its place. Nothing may be in flight.
    pub fn unbind(&self, bindings: &Bindings, nothing: &Buffer) {
        bindings.bind(binding::PATHS, nothing);
        bindings.bind(binding::QUEUES, nothing);
    }

    /// Paths that have room.
    pub fn capacity(&self) -> u32 {
        self.capacity
    }

    /// Bytes that it takes.
    pub fn bytes(&self) -> u64 {
        self.queues.bytes() + self.paths.bytes()
    }

    /// Most pixels of a wave, so that waves for `pixels` are about the same size.
    pub fn most_pixels(&self, pixels: u64) -> u64 {
        let waves = pixels.div_ceil(self.capacity.into());
        pixels.div_ceil(waves.max(1)).next_multiple_of(WORKGROUP.into()).min(self.capacity.into())
    }

    /// Samples of each of `pixels` pixels in one wave.
    fn samples_at_once(&self, pixels: u32) -> u32 {
        (self.capacity / pixels.max(1)).max(1)
    }

    /// Most samples of `pixels` pixels in a submit: the counts of so many waves have room.
    pub fn most_samples(&self, pixels: u64) -> u32 {
        let waves = WAVE_COUNTS_WORDS / (WAVE_ROUND_WORDS * (self.rounds + 1));
        waves.saturating_mul(self.samples_at_once(pixels.min(self.capacity.into()) as u32))
    }

    /// Records all samples of a dispatch, by the prepared steps of a variant.
    pub fn record(
        &self,
        (passes, bindings): (&Passes, &Bindings),
        variant: Variant,
        (commands, offset): (vk::CommandBuffer, u32),
        dispatch: &Dispatch,
    ) {
        bindings.use_in(commands, vk::PipelineBindPoint::COMPUTE, offset);
        let barrier = || barrier(&self.device, commands);
        let (queues, bytes) = (self.queues.handle, 4 * u64::from(WAVE_COUNTS_WORDS));
        // SAFETY: the buffer is alive and larger; the commands are being recorded.
        unsafe { self.device.raw.cmd_fill_buffer(commands, queues, 0, bytes, 0) };
        let (rounds, at_once) = (self.rounds, self.samples_at_once(dispatch.count));
        for wave in 0..dispatch.samples.div_ceil(at_once) {
            let samples = at_once.min(dispatch.samples - wave * at_once);
            let counts = wave * WAVE_ROUND_WORDS * (self.rounds + 1);
            let launch = |name, round, launch: Launch| {
                let step = WaveStep { round, counts, capacity: self.capacity, rounds, samples };
                passes.launch_step(variant.step(name), bindings, commands, step, &launch);
            };
            let groups = |count: u32| Launch::Groups(count.div_ceil(WORKGROUP));
            let paths = |round| Launch::Told(&self.queues, counts + WAVE_ROUND_WORDS * round + 1);
            let lit = |round| Launch::Told(&self.queues, counts + WAVE_ROUND_WORDS * round + 5);
            barrier();
            launch("wave_begin", 0, groups(dispatch.count * samples));
            for round in 0..rounds {
                if round > 0 {
                    launch("wave_walk", round, paths(round));
                    launch("wave_lit", round - 1, lit(round - 1));
                }
                barrier();
                launch("wave_shade", round, paths(round));
                barrier();
            }
            launch("wave_finish", rounds, paths(rounds));
            launch("wave_finish", rounds - 1, lit(rounds - 1));
            barrier();
            launch("wave_end", rounds, groups(dispatch.count));
        }
    }
}

impl Variant {
    /// The same for a step of a wave.
    pub fn step(self, name: &'static str) -> Self {
        Self { entry: Entry::Wave(name), ..self }
    }

    /// Whether it is one of those.
    pub fn is_in_waves(self) -> bool {
        matches!(self.entry, Entry::Wave(_))
    }
}
