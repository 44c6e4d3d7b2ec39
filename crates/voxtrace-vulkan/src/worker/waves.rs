//! Paths in waves: `shaders/pass/waves.slang`, which says how they go.

use super::Worker;
use crate::bindings::Bindings;
use crate::buffer::Buffer;
use crate::commands::barrier;
use crate::device::Device;
use crate::passes::{Launch, Passes, WORKGROUP};
use crate::records::{Dispatch, WAVE_COUNTS_WORDS, WAVE_ROUND_WORDS, WaveStep, binding};
use crate::variant::{Entry, Variant};
use ash::vk;
use gpu_allocator::MemoryLocation;
use std::sync::Arc;
use voxtrace_core::TraceError;

/// Rows of 16 bytes of a path.
const ROWS: u64 = 7;
/// Queues: two in turn, and the paths that met light.
const QUEUES: u64 = 3;

/// Memory of paths under way.
pub struct Waves {
    device: Arc<Device>,
    queues: Buffer,
    paths: Buffer,
    capacity: u32,
    pub rounds: u32,
    times: std::cell::RefCell<Times>,
}

struct Times { pool: vk::QueryPool, names: Vec<String>, sums: Vec<f64>, count: u32 }

impl Waves {
    /// Room for so many paths.
    pub fn new(device: &Arc<Device>, capacity: u32, rounds: u32) -> Result<Self, TraceError> {
        let usage = vk::BufferUsageFlags::STORAGE_BUFFER
            | vk::BufferUsageFlags::TRANSFER_DST
            | vk::BufferUsageFlags::INDIRECT_BUFFER;
        let size = 4 * (u64::from(WAVE_COUNTS_WORDS) + QUEUES * u64::from(capacity));
        let pool = unsafe { device.raw.create_query_pool(&vk::QueryPoolCreateInfo::default().query_type(vk::QueryType::TIMESTAMP).query_count(256), None) }.expect("pool");
        Ok(Self {
            times: std::cell::RefCell::new(Times { pool, names: vec![], sums: vec![], count: 0 }),
            device: Arc::clone(device),
            queues: Buffer::new(device, "queues of paths", size, usage, MemoryLocation::GpuOnly)?,
            paths: Buffer::storage(device, "paths", ROWS * 16 * u64::from(capacity))?,
            capacity,
            rounds,
        })
    }

    pub fn bind(&self, bindings: &Bindings) {
        bindings.bind(binding::PATHS, &self.paths);
        bindings.bind(binding::QUEUES, &self.queues);
    }

    /// Most pixels of a wave.
    pub fn most_pixels(&self) -> u64 {
        self.capacity.into()
    }

    /// Most samples of a submit.
    pub fn most_samples(&self) -> u32 {
        WAVE_COUNTS_WORDS / (WAVE_ROUND_WORDS * (self.rounds + 1))
    }

    /// Records `samples` waves, one after the other.
    pub fn record(
        &self,
        passes: &Passes,
        variant: Variant,
        bindings: &Bindings,
        commands: vk::CommandBuffer,
        offset: u32,
        dispatch: &Dispatch,
    ) {
        let raw = &self.device.raw;
        bindings.use_in(commands, vk::PipelineBindPoint::COMPUTE, offset);
        let barrier = || barrier(&self.device, commands);
        // SAFETY: the buffer is alive; the commands are being recorded.
        unsafe { raw.cmd_fill_buffer(commands, self.queues.handle, 0, 4 * u64::from(WAVE_COUNTS_WORDS), 0) };
        let is_timed = std::env::var_os("VOXTRACE_WAVE_TIMES").is_some() && dispatch.samples == 1;
        let mut times = self.times.borrow_mut();
        let times = &mut *times;
        if is_timed {
            if !times.names.is_empty() && dispatch.sequence == 0 {
                let mut ticks = vec![0u64; times.names.len() + 1];
                let ok = unsafe { raw.get_query_pool_results(times.pool, 0, &mut ticks, vk::QueryResultFlags::TYPE_64 | vk::QueryResultFlags::WAIT) };
                if ok.is_ok() {
                    times.sums.resize(times.names.len(), 0.0);
                    for (i, pair) in ticks.windows(2).enumerate() {
                        times.sums[i] += pair[1].wrapping_sub(pair[0]) as f64 * f64::from(self.device.info().limits.timestamp_period_ns) * 1e-6;
                    }
                    times.count += 1;
                    if times.count % 32 == 0 {
                        for (name, sum) in times.names.iter().zip(&times.sums) { eprint!("{name}={:.3} ", sum / f64::from(times.count)); }
                        eprintln!("all={:.3}", times.sums.iter().sum::<f64>() / f64::from(times.count));
                        times.count = 0;
                        times.sums.clear();
                    }
                }
            }
            times.names.clear();
            unsafe { raw.cmd_reset_query_pool(commands, times.pool, 0, 256); }
        }
        let mut stamp = |name: String| if is_timed {
            unsafe { raw.cmd_write_timestamp(commands, vk::PipelineStageFlags::BOTTOM_OF_PIPE, times.pool, if name.is_empty() { 0 } else { times.names.len() as u32 + 1 }) };
            if !name.is_empty() { times.names.push(name); }
        };
        let wave_words = WAVE_ROUND_WORDS * (self.rounds + 1);
        for sample in 0..dispatch.samples {
            let counts = sample * wave_words;
            let step = |round| WaveStep { round, counts, capacity: self.capacity, rounds: self.rounds };
            let launch = |name, round, launch: &Launch| {
                let variant = Variant { entry: Entry::Wave(name), ..variant };
                passes.launch_step(variant, bindings.layout, commands, step(round), launch);
            };
            let paths = |round: u32| Launch::Told(&self.queues, counts + WAVE_ROUND_WORDS * round + 1);
            let lit = |round: u32| Launch::Told(&self.queues, counts + WAVE_ROUND_WORDS * round + 5);
            barrier();
            stamp(String::new());
            launch("wave_begin", 0, &Launch::Groups(dispatch.count.div_ceil(WORKGROUP)));
            stamp("begin".into());
            for round in 0..self.rounds {
                if round > 0 {
                    launch("wave_walk", round, &paths(round));
                    launch("wave_lit", round - 1, &lit(round - 1));
                }
                barrier();
                if round > 0 { stamp(format!("walk{round}")); }
                launch("wave_shade", round, &paths(round));
                barrier();
                stamp(format!("shade{round}"));
            }
            launch("wave_finish", self.rounds, &paths(self.rounds));
            launch("wave_finish", self.rounds - 1, &lit(self.rounds - 1));
            barrier();
            stamp("finish".into());
        }
    }
}

/// The steps.
pub const STEPS: [&str; 5] = ["wave_begin", "wave_walk", "wave_shade", "wave_lit", "wave_finish"];

impl Worker {
    /// Makes what renders a variant in waves, where it is: else the one shader does it.
    pub(super) fn prepare_waves(&mut self, variant: Variant) -> Result<bool, TraceError> {
        let Some(value) = std::env::var_os("VOXTRACE_WAVES") else { return Ok(false) };
        let value = value.to_string_lossy().into_owned();
        let numbers: Vec<u32> = value.split(',').filter_map(|part| part.parse().ok()).collect();
        let (Some(passes), &[rounds, capacity]) = (self.wave_passes.as_mut(), &numbers[..]) else { return Ok(false) };
        if variant.entry != Entry::RenderPath || variant.has_materials || variant.has_pages {
            return Ok(false);
        }
        for name in STEPS {
            passes.prepare(Variant { entry: Entry::Wave(name), ..variant })?;
        }
        if self.waves.is_none() {
            self.waves = Some(Waves::new(&self.device, capacity, rounds)?);
        }
        if let Some(waves) = &self.waves {
            waves.bind(&self.bindings);
        }
        Ok(true)
    }
}
