//! Real-time light on a device: what it keeps from frame to frame, and the steps of a frame. Twin of `voxtrace-realtime`, whose parts the shaders name;
//! `docs/realtime.md` lists the steps.

pub mod left;

use crate::barrier::barrier;
use crate::bindings::Bindings;
use crate::buffer::Buffer;
use crate::device::Device;
use crate::errors::ResultExt;
use crate::passes::{Launch, Passes, WORKGROUP};
use crate::records::{WAVE_COUNTS_WORDS, WAVE_ROUND_WORDS, WaveStep, binding};
use crate::variant::{Entry, Variant};
use ash::vk;
use gpu_allocator::MemoryLocation;
use left::Left;
use std::sync::Arc;
use voxtrace_core::{Frame, TraceError};
use voxtrace_realtime::{FramesOnDevice, LightCache, Parts, RealTimeParams, Visibility, slots, squares};

/// How many pixels trace a path in each frame of real-time light.
pub use voxtrace_realtime::Rate;

/// Words of a pixel in memory, and within a frame.
const MEMORY_WORDS: u64 = 16;
const SCRATCH_WORDS: u64 = 20;
/// Place of the counts of paths in waves: those of the rest, workgroups for them along three axes, and those that are over.
const REST: u64 = 4;
/// Lists of rows of squares of pixels, after the pixels.
const SQUARE_LISTS: u64 = 4;
/// Words of the counts before the keys of cells, and lists of words behind them, which how often rays to lights arrive follows.
const CELL_COUNTS: u64 = 16;
const CELL_LISTS: u64 = 3;
/// Words of the rows of a cell.
const CELL_WORDS: u64 = 16;
/// Steps of a frame, at most.
const MOST_STEPS: u32 = 40 + 2 * left::MOST_ROUNDS;

/// What a frame of real-time light took.
#[derive(Clone, Debug, PartialEq)]
pub struct RealTimeFrame {
    /// Time on the device, milliseconds.
    pub gpu_ms: f64,
    /// Frames whose paths that is for: several where the picture is the first one of a view.
    pub frames: u32,
    /// That of each step, by its name, in order; empty where the device has no clock.
    pub passes: Vec<(&'static str, f64)>,
    /// Bytes on the device that real-time light takes beside the scene and the picture.
    pub bytes: u64,
}

impl RealTimeFrame {
    /// With what one before took whose picture is not shown.
    pub(crate) fn after(mut self, before: Self) -> Self {
        self.gpu_ms += before.gpu_ms;
        self.frames += before.frames;
        before.passes.into_iter().for_each(|(name, ms)| add(&mut self.passes, name, ms));
        self
    }
}

/// Real-time light of a view.
pub struct RealTime {
    device: Arc<Device>,
    pub frames: FramesOnDevice,
    pixels: Option<PixelBuffers>,
    pub cell_keys: Buffer,
    pub cell_rows: Buffer,
    params: Buffer,
    motions: Option<Buffer>,
    /// Whether paths are traced in waves: `shaders/pass/realtime_waves.slang` says how.
    pub in_waves: bool,
    queries: vk::QueryPool,
    /// What is known of paths that left them.
    pub left: Left,
    /// How many instances the last frame had.
    instances: Option<usize>,
    /// Whether the cells are to be cleared.
    is_new: bool,
}

/// Memory of pixels.
struct PixelBuffers {
    size: (u32, u32),
    memory: Buffer,
    scratch: Buffer,
    /// Where paths are traced in waves: those that few steps could not end.
    rest: Option<Buffer>,
    /// Where paths leave them: counts and queues of the waves of these.
    queues: Option<Buffer>,
}

/// A step of a frame: its entry point, and its invocations.
pub struct Step {
    pub name: &'static str,
    pub count: Count,
}

/// How many invocations a step has.
#[derive(Clone, Copy)]
pub enum Count {
    /// So many.
    Of(u32),
    /// As many as paths in waves go on.
    Rest,
    /// As many as paths have left the waves.
    Left,
    /// As many as of those have room in waves of their own.
    Room,
    /// As many as are under way in a round of these.
    Round(u32),
}

impl RealTime {
    /// One that knows nothing.
    pub fn new(device: &Arc<Device>, parts: Parts) -> Result<Self, TraceError> {
        let cells = LightCache::CAPACITY as u64;
        let usage = vk::BufferUsageFlags::STORAGE_BUFFER
            | vk::BufferUsageFlags::TRANSFER_SRC
            | vk::BufferUsageFlags::TRANSFER_DST
            | vk::BufferUsageFlags::INDIRECT_BUFFER;
        let size = 4 * (CELL_COUNTS + CELL_LISTS * cells + 2 * Visibility::PLACES as u64);
        let cell_keys = Buffer::new(device, "light cache", size, usage, MemoryLocation::GpuOnly)?;
        let cell_rows = Buffer::storage(device, "light cache", 4 * CELL_WORDS * cells)?;
        let usage = vk::BufferUsageFlags::UNIFORM_BUFFER;
        let size = size_of::<RealTimeParams>() as u64;
        let params = Buffer::new(device, "real-time parameters", size, usage, MemoryLocation::CpuToGpu)?;
        let left = Left::new(device)?;
        let info = vk::QueryPoolCreateInfo::default().query_type(vk::QueryType::TIMESTAMP).query_count(MOST_STEPS + 1);
        // SAFETY: the device is alive; `drop` destroys it.
        let queries = unsafe { device.raw.create_query_pool(&info, None) }.context("creating timestamps")?;
        Ok(Self {
            device: Arc::clone(device),
            frames: FramesOnDevice::new(parts),
            pixels: None,
            cell_keys,
            cell_rows,
            params,
            motions: None,
            in_waves: false,
            queries,
            left,
            instances: None,
            is_new: true,
        })
    }

    /// Makes room for pictures of a size, their paths traced in waves or not, which some leave or not. Where size or waves are others nothing is known of pixels any more.
    pub fn set_size(&mut self, width: u32, height: u32, (in_waves, leave): (bool, bool)) -> Result<(), TraceError> {
        let is_same = self
            .pixels
            .as_ref()
            .is_some_and(|pixels| pixels.size == (width, height) && pixels.queues.is_some() == leave);
        if is_same && self.in_waves == in_waves {
            return Ok(());
        }
        self.in_waves = in_waves;
        self.pixels = None;
        self.frames.forget_pixels();
        let count = u64::from(width) * u64::from(height);
        let squares = u64::from(squares((width, height)));
        let memory = 4 * MEMORY_WORDS * count + 16 * SQUARE_LISTS * squares;
        let slots = u64::from(slots((width, height), in_waves));
        let scratch = 4 * SCRATCH_WORDS * slots;
        let limit = self.device.info().limits.max_storage_bytes();
        if memory.max(scratch) > limit {
            return Err(TraceError::OutOfMemory { needed: memory.max(scratch), available: limit });
        }
        self.pixels = Some(PixelBuffers {
            size: (width, height),
            memory: Buffer::storage(&self.device, "real-time memory", memory)?,
            scratch: Buffer::storage(&self.device, "real-time scratch", scratch)?,
            rest: match in_waves {
                true => Some(Buffer::storage(&self.device, "real-time paths", 4 * slots)?),
                false => None,
            },
            queues: match leave {
                true => Some(Left::queues(&self.device, slots as u32)?),
                false => None,
            },
        });
        Ok(())
    }

    /// Says how many instances the next frame has. Where they are more or fewer than before nothing is known any more.
    pub fn set_instances(&mut self, count: usize) {
        if self.instances.is_some_and(|before| before != count) {
            self.forget();
        }
        self.instances = Some(count);
    }

    /// Another number of instances: nothing is known any more, as cells of the light cache and motions go by the numbers of instances.
    pub fn forget(&mut self) {
        self.frames.forget();
        self.is_new = true;
    }

    /// The buffers of pixels: what is known of them, and what a frame works with.
    pub fn pixel_buffers(&self) -> Option<(&Buffer, &Buffer)> {
        self.pixels.as_ref().map(|pixels| (&pixels.memory, &pixels.scratch))
    }

    /// Bytes that it takes.
    pub fn bytes(&self) -> u64 {
        let pixels = self.pixels.iter();
        let pixels = pixels
            .flat_map(|pixels| [&pixels.memory, &pixels.scratch].into_iter().chain(&pixels.rest).chain(&pixels.queues));
        let cells = [&self.cell_keys, &self.cell_rows, &self.params];
        self.left.bytes() + pixels.chain(cells).chain(&self.motions).map(Buffer::bytes).sum::<u64>()
    }

    /// Writes what the steps of a frame read, and how instances moved: the rows of [`FramesOnDevice::motions`]. Nothing may be in flight.
    pub fn write(&mut self, params: &RealTimeParams, motions: &[[f32; 4]]) -> Result<(), TraceError> {
        self.params.mapped_mut()[..size_of::<RealTimeParams>()].copy_from_slice(bytemuck::bytes_of(params));
        let bytes: &[u8] = bytemuck::cast_slice(motions);
        if params.motions == 0 {
            self.motions = None;
        }
        if bytes.is_empty() {
            return Ok(());
        }
        if self.motions.as_ref().is_none_or(|buffer| buffer.size < bytes.len() as u64) {
            let usage = vk::BufferUsageFlags::STORAGE_BUFFER;
            let size = bytes.len() as u64;
            self.motions = Some(Buffer::new(&self.device, "motions", size, usage, MemoryLocation::CpuToGpu)?);
        }
        if let Some(buffer) = &mut self.motions {
            buffer.mapped_mut()[..bytes.len()].copy_from_slice(bytes);
        }
        Ok(())
    }

    /// Nothing may be in flight.
    pub fn bind(&self, bindings: &Bindings, nothing: &Buffer) {
        bindings.bind(binding::REAL_TIME, &self.params);
        bindings.bind(binding::CELL_KEYS, &self.cell_keys);
        bindings.bind(binding::CELL_ROWS, &self.cell_rows);
        bindings.bind(binding::MOTIONS, self.motions.as_ref().unwrap_or(nothing));
        if let Some(pixels) = &self.pixels {
            bindings.bind(binding::MEMORY, &pixels.memory);
            bindings.bind(binding::SCRATCH, &pixels.scratch);
            bindings.bind(binding::REST, pixels.rest.as_ref().unwrap_or(nothing));
            if let Some(queues) = &pixels.queues {
                bindings.bind(binding::PATHS, &pixels.scratch);
                bindings.bind(binding::QUEUES, queues);
            }
        }
    }

    /// Records the steps of a frame. `passes` are those of each [`Kind`].
    pub fn record(
        &self,
        steps: &[Step],
        passes: &[Passes; 4],
        variants: [Variant; 4],
        bindings: &Bindings,
        (commands, offset): (vk::CommandBuffer, u32),
    ) {
        let raw = &self.device.raw;
        let fill = |first: u64, words: u64, value: u32| {
            // SAFETY: the buffer is alive and larger; the commands are being recorded.
            unsafe { raw.cmd_fill_buffer(commands, self.cell_keys.handle, 4 * first, 4 * words, value) };
        };
        if self.is_new {
            fill(0, self.cell_keys.size / 4, 0);
            // SAFETY: as above.
            unsafe { raw.cmd_fill_buffer(commands, self.cell_rows.handle, 0, vk::WHOLE_SIZE, 0) };
        }
        let queues = self.pixels.as_ref().and_then(|pixels| pixels.queues.as_ref());
        if let Some(queues) = queues {
            // SAFETY: as above.
            unsafe { raw.cmd_fill_buffer(commands, queues.handle, 0, 4 * u64::from(WAVE_COUNTS_WORDS), 0) };
        }
        let queues = queues.unwrap_or(&self.cell_keys);
        let capacity =
            self.pixels.as_ref().map_or(0, |pixels| self.left.room((pixels.scratch.size / (4 * SCRATCH_WORDS)) as u32));
        barrier(&self.device, commands);
        // Cells that trace.
        fill(2, 1, 0);
        fill(REST, 2, 0);
        // Workgroups along y and z.
        fill(REST + 2, 2, 1);
        fill(REST + 4, 1, 0);
        fill(left::COUNTS, 2, 0);
        fill(left::COUNTS + 2, 2, 1);
        // Those that were begun, and the round of the last of them.
        fill(left::COUNTS + 4, 1, capacity);
        fill(left::COUNTS + 5, 1, 0);
        bindings.use_in(commands, vk::PipelineBindPoint::COMPUTE, offset);
        // SAFETY: the pool is alive and not in use.
        unsafe { raw.cmd_reset_query_pool(commands, self.queries, 0, steps.len() as u32 + 1) };
        self.time(commands, 0);
        for (number, step) in (1..).zip(steps) {
            // Those that are followed again run beside the rest.
            if !["trace_again", "trace_before"].contains(&step.name) {
                barrier(&self.device, commands);
            }
            if step.name == "end_cells" {
                // Cells that are asked for are counted anew.
                fill(0, 2, 0);
                barrier(&self.device, commands);
            }
            let which = Kind::of(step.name) as usize;
            let round = if let Count::Round(round) = step.count { round } else { 0 };
            let launch = match step.count {
                Count::Of(count) => Launch::Groups(count.div_ceil(WORKGROUP)),
                Count::Rest => Launch::Told(&self.cell_keys, REST as u32 + 1),
                Count::Left => Launch::Told(&self.cell_keys, left::COUNTS as u32 + 1),
                // Each invocation also begins the counts of a round, of which there may be more than paths that have room.
                Count::Room => Launch::Groups(capacity.max(self.left.rounds() + 1).div_ceil(WORKGROUP)),
                Count::Round(_) => Launch::Told(queues, WAVE_ROUND_WORDS * round + 1),
            };
            let variant = variants[which].real_time(step.name);
            let wave = WaveStep { round, capacity, rounds: self.left.rounds(), ..WaveStep::default() };
            passes[which].launch_step(variant, bindings, commands, wave, &launch);
            self.time(commands, number);
            if step.name == "trace_left" {
                self.left.record(commands, &self.cell_keys);
            }
        }
    }

    fn time(&self, commands: vk::CommandBuffer, query: u32) {
        if self.device.info().limits.timestamp_period_ns > 0.0 {
            let stage = vk::PipelineStageFlags::BOTTOM_OF_PIPE;
            // SAFETY: these commands are being recorded, and have reset the queries.
            unsafe { self.device.raw.cmd_write_timestamp(commands, stage, self.queries, query) };
        }
    }

    /// The milliseconds of each step of a frame that is over.
    pub fn milliseconds(&self, steps: &[Step]) -> Result<Vec<(&'static str, f64)>, TraceError> {
        let limits = &self.device.info().limits;
        if limits.timestamp_period_ns == 0.0 {
            return Ok(Vec::new());
        }
        let mut ticks = vec![0u64; steps.len() + 1];
        let flags = vk::QueryResultFlags::TYPE_64 | vk::QueryResultFlags::WAIT;
        // SAFETY: the submit that writes these queries is over.
        unsafe { self.device.raw.get_query_pool_results(self.queries, 0, &mut ticks, flags) }
            .context("real-time light")?;
        let mut sums: Vec<(&'static str, f64)> = Vec::new();
        for (step, pair) in steps.iter().zip(ticks.windows(2)) {
            add(&mut sums, step.name, limits.milliseconds_between(pair[0], pair[1]));
        }
        Ok(sums)
    }

    /// Ends a frame.
    pub fn end(&mut self, frame: &Frame) {
        self.frames.end(frame);
        self.is_new = false;
    }
}

impl Drop for RealTime {
    fn drop(&mut self) {
        if self.device.hung().is_none() {
            // SAFETY: whoever drops it has waited for the work that uses it.
            unsafe { self.device.raw.destroy_query_pool(self.queries, None) };
        }
    }
}

/// Adds to the milliseconds of a step.
fn add(sums: &mut Vec<(&'static str, f64)>, name: &'static str, ms: f64) {
    match sums.iter_mut().find(|(other, _)| *other == name) {
        Some((_, sum)) => *sum += ms,
        None => sums.push((name, ms)),
    }
}

impl Variant {
    /// The same for a step of real-time light.
    pub fn real_time(self, name: &'static str) -> Self {
        Self { entry: Entry::RealTime(name), ..self }
    }
}

/// The module of a step.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// It traces rays, whatever the scene has.
    Tracing,
    /// It traces paths in waves.
    Waves,
    /// It traces paths that left those, in waves of their own.
    Left,
    /// It traces no rays.
    Gathering,
}

impl Kind {
    /// That of a step.
    pub fn of(name: &str) -> Self {
        match name {
            "trace" | "trace_left" | "trace_before" | "remember" => Self::Tracing,
            "list_left" => Self::Waves,
            "begin_left" | "walk_left" | "shade_left" | "finish_left" => Self::Left,
            _ if name.starts_with("trace_") => Self::Waves,
            _ => Self::Gathering,
        }
    }
}
