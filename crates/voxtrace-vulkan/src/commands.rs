//! Submitting work: at most two submits in flight, each timed by the device's clock and proved by a number that the
//! device itself writes.

use crate::barrier::{barrier, memory_barrier};
use crate::buffer::Buffer;
use crate::device::Device;
use crate::errors::{ResultExt, failed};
use crate::records::{COUNTER_SLOTS, COUNTER_WORDS, COUNTERS, Counter, Dispatch};
use ash::vk;
use bytemuck::{bytes_of, pod_read_unaligned};
use gpu_allocator::MemoryLocation;
use std::collections::VecDeque;
use std::sync::Arc;
use std::time::Instant;
use voxtrace_core::TraceError;

/// Submits in flight.
const SLOTS: usize = 2;
/// Parts that a submit may have, one after the other.
const PARTS: usize = 2;
/// Times of a submit: when it began, and when each part was over.
const TIMES: u32 = PARTS as u32 + 1;
const COUNTERS_BYTES: u64 = (COUNTER_WORDS * 4) as u64;

/// What a submit did, told by the device.
#[derive(Clone, Copy, Debug)]
pub struct Finished {
    /// Time on the device, milliseconds, without what was done [`Job::then`].
    pub gpu_ms: f64,
    /// Time of that, `None` where there was nothing.
    pub then_ms: Option<f64>,
    /// What its shaders counted.
    pub counters: [u32; COUNTERS],
    /// The amount of work that the caller named.
    pub work: u64,
}

/// Records a barrier between two steps.
pub type Barrier<'a> = &'a dyn Fn(vk::CommandBuffer);

/// Work to submit.
pub struct Job<'a> {
    /// What it is, for messages.
    pub step: &'static str,
    /// How much it is, in units of the caller.
    pub work: u64,
    /// Input of the dispatch; the sequence number is filled in.
    pub dispatch: Dispatch,
    /// Workgroups, or invocations of a ray generation shader, that must have counted themselves, `None` for work that runs no shader of ours.
    pub workgroups: Option<u32>,
    /// Records the commands, given the offset of the dispatch's input in its buffer.
    pub record: &'a dyn Fn(vk::CommandBuffer, u32),
    /// What is done in the same submit, once all of that is over.
    pub then: Option<Then<'a>>,
}

/// The second part of a [`Job`].
pub struct Then<'a> {
    /// Input of the dispatch; the sequence number is filled in.
    pub dispatch: Dispatch,
    /// Workgroups that must have counted themselves.
    pub workgroups: u32,
    /// As [`Job::record`].
    pub record: &'a dyn Fn(vk::CommandBuffer, u32),
}

struct InFlight {
    slot: usize,
    value: u64,
    step: &'static str,
    work: u64,
    sequence: u32,
    workgroups: Option<u32>,
    has_then: bool,
    /// Whether nobody asks what it did.
    is_quiet: bool,
    submitted: Instant,
}

/// The queue of one tracer.
pub struct Submitter {
    device: Arc<Device>,
    pool: vk::CommandPool,
    commands: [vk::CommandBuffer; SLOTS],
    queries: vk::QueryPool,
    timeline: vk::Semaphore,
    submitted: u64,
    in_flight: VecDeque<InFlight>,
    sequence: u32,
    /// What shaders count into; cleared before each submit.
    pub counters: Buffer,
    readback: Buffer,
    /// Inputs of the dispatches, two for each slot.
    pub dispatches: Buffer,
    dispatch_stride: u64,
}

impl Submitter {
    pub fn new(device: &Arc<Device>) -> Result<Self, TraceError> {
        let raw = &device.raw;
        let usage = vk::BufferUsageFlags::TRANSFER_DST;
        let stride = (size_of::<Dispatch>() as u64).next_multiple_of(device.info().limits.uniform_alignment.max(16));
        let counters = Buffer::storage(device, "counters", COUNTERS_BYTES)?;
        let readback_size = COUNTERS_BYTES * SLOTS as u64;
        let readback = Buffer::new(device, "counters for the host", readback_size, usage, MemoryLocation::GpuToCpu)?;
        let usage = vk::BufferUsageFlags::UNIFORM_BUFFER;
        let dispatches =
            Buffer::new(device, "dispatch inputs", stride * (PARTS * SLOTS) as u64, usage, MemoryLocation::CpuToGpu)?;
        let mut submitter = Self {
            device: Arc::clone(device),
            pool: vk::CommandPool::null(),
            commands: [vk::CommandBuffer::null(); SLOTS],
            queries: vk::QueryPool::null(),
            timeline: vk::Semaphore::null(),
            submitted: 0,
            in_flight: VecDeque::new(),
            sequence: 0,
            counters,
            readback,
            dispatches,
            dispatch_stride: stride,
        };
        let pool_info = vk::CommandPoolCreateInfo::default()
            .flags(vk::CommandPoolCreateFlags::RESET_COMMAND_BUFFER)
            .queue_family_index(device.info().queue_family);
        // SAFETY: the device is alive; what was created is destroyed by `drop`, also when a later step fails.
        submitter.pool = unsafe { raw.create_command_pool(&pool_info, None) }.context("creating the command pool")?;
        let buffers_info =
            vk::CommandBufferAllocateInfo::default().command_pool(submitter.pool).command_buffer_count(SLOTS as u32);
        // SAFETY: the pool was just created.
        let commands = unsafe { raw.allocate_command_buffers(&buffers_info) }.context("creating command buffers")?;
        submitter.commands.copy_from_slice(&commands);
        let query_info =
            vk::QueryPoolCreateInfo::default().query_type(vk::QueryType::TIMESTAMP).query_count(TIMES * SLOTS as u32);
        // SAFETY: as above.
        submitter.queries = unsafe { raw.create_query_pool(&query_info, None) }.context("creating timestamps")?;
        let mut kind = vk::SemaphoreTypeCreateInfo::default().semaphore_type(vk::SemaphoreType::TIMELINE);
        let semaphore_info = vk::SemaphoreCreateInfo::default().push_next(&mut kind);
        // SAFETY: as above.
        submitter.timeline = unsafe { raw.create_semaphore(&semaphore_info, None) }.context("creating a semaphore")?;
        Ok(submitter)
    }

    /// Submits a job. Where two are in flight already, waits for the older one first and returns what it did. After an
    /// error nothing is in flight.
    pub fn submit(&mut self, job: &Job) -> Result<Option<Finished>, TraceError> {
        let result = self.try_submit(job);
        self.settle(result)
    }

    /// Lets an error wait until nothing is in flight, so that whoever gets it may free what was in use.
    fn settle<T>(&mut self, result: Result<T, TraceError>) -> Result<T, TraceError> {
        if result.is_err() {
            self.wait_for_all();
            self.in_flight.clear();
        }
        result
    }

    /// Waits until all that was submitted is over, or the device is given up.
    fn wait_for_all(&self) {
        if self.submitted > 0 && self.wait_until(self.submitted).is_err() && !self.device.is_given_up() {
            // It is lost, and does nothing any more, or the driver had no memory to wait.
            self.device.wait_idle();
        }
    }

    /// The error of a step on a device that was given up: because of this step, or of other work before it.
    fn given_up(&self, step: &str, was_waited_for: bool) -> Option<TraceError> {
        let seconds = self.device.hung()?.as_secs();
        let what = if was_waited_for { "which" } else { "as other work" };
        Some(TraceError::DeviceLost { last_pass: format!("{step}, {what} did not end within {seconds} s") })
    }

    fn try_submit(&mut self, job: &Job) -> Result<Option<Finished>, TraceError> {
        let is_quiet = self.in_flight.front().is_some_and(|oldest| oldest.is_quiet);
        let finished = if self.in_flight.len() == SLOTS { self.try_wait()?.filter(|_| !is_quiet) } else { None };
        let slot = (self.submitted % SLOTS as u64) as usize;
        self.sequence = self.sequence.wrapping_add(1).max(1);
        let inputs = [Some(job.dispatch), job.then.as_ref().map(|then| then.dispatch)];
        let offset = |part: usize| self.dispatch_stride * (PARTS * slot + part) as u64;
        let offsets = [offset(0), offset(1)];
        for (input, offset) in inputs.into_iter().zip(offsets) {
            let Some(input) = input else { continue };
            let (input, at) = (Dispatch { sequence: self.sequence, ..input }, offset as usize);
            self.dispatches.mapped_mut()[at..at + size_of::<Dispatch>()].copy_from_slice(bytes_of(&input));
        }

        let commands = self.commands[slot];
        self.record(commands, slot, job, offsets.map(|offset| offset as u32)).context(job.step)?;
        let (buffers, signals, values) = ([commands], [self.timeline], [self.submitted + 1]);
        let mut timeline = vk::TimelineSemaphoreSubmitInfo::default().signal_semaphore_values(&values);
        let submit =
            vk::SubmitInfo::default().command_buffers(&buffers).signal_semaphores(&signals).push_next(&mut timeline);
        let queue = self.device.queue();
        // Whoever held the queue may have found that the device hangs.
        if let Some(error) = self.given_up(job.step, false) {
            return Err(error);
        }
        // SAFETY: the commands are recorded and not in flight; the queue is locked, so nobody else submits.
        unsafe { self.device.raw.queue_submit(*queue, &[submit], vk::Fence::null()) }.context(job.step)?;
        drop(queue);
        self.submitted += 1;
        self.in_flight.push_back(InFlight {
            slot,
            value: self.submitted,
            step: job.step,
            work: job.work,
            sequence: self.sequence,
            workgroups: job.workgroups.map(|count| count + job.then.as_ref().map_or(0, |then| then.workgroups)),
            has_then: job.then.is_some(),
            is_quiet: false,
            submitted: Instant::now(),
        });
        Ok(finished)
    }

    /// Submits a job and waits until it and all before it are done; returns what it did.
    pub fn run(&mut self, job: &Job) -> Result<Finished, TraceError> {
        self.submit(job)?;
        let mut last = None;
        while let Some(finished) = self.wait()? {
            last = Some(finished);
        }
        last.ok_or_else(|| TraceError::Device { step: job.step.into(), reason: "nothing was submitted".into() })
    }

    /// Submits commands that run no shader of ours and waits for them; returns the device's milliseconds.
    pub fn run_commands(&mut self, step: &'static str, record: &dyn Fn(vk::CommandBuffer)) -> Result<f64, TraceError> {
        self.run_commands_and(step, &|commands, _| record(commands))
    }

    /// As [`Self::run_commands`], of commands in several steps: the second argument of `record` is a barrier between two.
    pub fn run_commands_and(
        &mut self,
        step: &'static str,
        record: &dyn Fn(vk::CommandBuffer, Barrier),
    ) -> Result<f64, TraceError> {
        let device = Arc::clone(&self.device);
        let record = |commands, _| record(commands, &|commands| barrier(&device, commands));
        let job = Job { step, work: 0, dispatch: Dispatch::default(), workgroups: None, record: &record, then: None };
        self.run(&job).map(|finished| finished.gpu_ms)
    }

    /// As [`Self::run_commands_and`], but does not wait: what is submitted later sees what these commands did. Whatever they use must stay until
    /// [`Self::wait_for_quiet`].
    pub fn run_quietly(
        &mut self,
        step: &'static str,
        record: &dyn Fn(vk::CommandBuffer, Barrier),
    ) -> Result<(), TraceError> {
        let device = Arc::clone(&self.device);
        let record = |commands, _| record(commands, &|commands| barrier(&device, commands));
        self.submit(&Job {
            step,
            work: 0,
            dispatch: Dispatch::default(),
            workgroups: None,
            record: &record,
            then: None,
        })?;
        self.in_flight.back_mut().into_iter().for_each(|last| last.is_quiet = true);
        Ok(())
    }

    /// Waits for what was submitted quietly before anything else that is in flight.
    pub fn wait_for_quiet(&mut self) -> Result<(), TraceError> {
        while self.in_flight.front().is_some_and(|oldest| oldest.is_quiet) {
            let result = self.try_wait();
            self.settle(result)?;
        }
        Ok(())
    }

    /// Waits for the oldest submit in flight; `None` where there is none. After an error nothing is in flight.
    pub fn wait(&mut self) -> Result<Option<Finished>, TraceError> {
        self.wait_for_quiet()?;
        let result = self.try_wait();
        self.settle(result)
    }

    fn try_wait(&mut self) -> Result<Option<Finished>, TraceError> {
        let Some(oldest) = self.in_flight.pop_front() else { return Ok(None) };
        self.wait_for(oldest.value, oldest.step)?;
        let (gpu_ms, then_ms) = self.milliseconds(&oldest)?;
        let at = COUNTERS_BYTES as usize * oldest.slot;
        let counters = summed(&self.readback.mapped()[at..at + COUNTERS_BYTES as usize]);
        if let Some(workgroups) = oldest.workgroups {
            let proof = (counters[Counter::Sequence as usize], counters[Counter::Workgroups as usize]);
            if proof != (oldest.sequence, workgroups) {
                let (sequence, expected) = (proof, (oldest.sequence, workgroups));
                let reason = format!("the device did not do the work: it wrote {sequence:?} instead of {expected:?}");
                return Err(TraceError::Device { step: oldest.step.into(), reason });
            }
        }
        Ok(Some(Finished { gpu_ms, then_ms, counters, work: oldest.work }))
    }

    fn record(
        &self,
        commands: vk::CommandBuffer,
        slot: usize,
        job: &Job,
        offsets: [u32; PARTS],
    ) -> Result<(), vk::Result> {
        let raw = &self.device.raw;
        let first_query = TIMES * slot as u32;
        let begin = vk::CommandBufferBeginInfo::default().flags(vk::CommandBufferUsageFlags::ONE_TIME_SUBMIT);
        let copy = vk::BufferCopy { src_offset: 0, dst_offset: COUNTERS_BYTES * slot as u64, size: COUNTERS_BYTES };
        let has_clock = self.device.info().limits.timestamp_period_ns > 0.0;
        let time = |index: u32| {
            if has_clock {
                // At the bottom: once everything before has ended.
                let stage = vk::PipelineStageFlags::BOTTOM_OF_PIPE;
                // SAFETY: these commands are being recorded, and have reset the queries.
                unsafe { raw.cmd_write_timestamp(commands, stage, self.queries, first_query + index) };
            }
        };
        // SAFETY: the slot's last submit is over, so its commands and queries are free; all handles are alive.
        unsafe {
            raw.begin_command_buffer(commands, &begin)?;
            self.barrier(commands);
            if has_clock {
                raw.cmd_reset_query_pool(commands, self.queries, first_query, TIMES);
            }
            time(0);
            let counts = job.workgroups.is_some();
            if counts {
                raw.cmd_fill_buffer(commands, self.counters.handle, 0, vk::WHOLE_SIZE, 0);
                self.barrier(commands);
            }
            (job.record)(commands, offsets[0]);
            self.barrier(commands);
            if let Some(then) = &job.then {
                time(1);
                (then.record)(commands, offsets[1]);
                self.barrier(commands);
            }
            if counts {
                raw.cmd_copy_buffer(commands, self.counters.handle, self.readback.handle, &[copy]);
            }
            time(if job.then.is_some() { 2 } else { 1 });
            memory_barrier(&self.device, commands, vk::PipelineStageFlags::HOST, vk::AccessFlags::HOST_READ);
            raw.end_command_buffer(commands)
        }
    }

    /// Lets everything after see everything before.
    pub fn barrier(&self, commands: vk::CommandBuffer) {
        barrier(&self.device, commands);
    }

    /// Waits for a submit of the queue by its number.
    fn wait_until(&self, value: u64) -> Result<(), vk::Result> {
        let (semaphores, values) = ([self.timeline], [value]);
        let info = vk::SemaphoreWaitInfo::default().semaphores(&semaphores).values(&values);
        // SAFETY: the semaphore is alive.
        self.device.wait_in_slices(|limit| unsafe { self.device.raw.wait_semaphores(&info, limit) })
    }

    /// As [`Self::wait_until`], of a step.
    fn wait_for(&self, value: u64, step: &'static str) -> Result<(), TraceError> {
        let was_given_up = self.device.is_given_up();
        self.wait_until(value)
            .map_err(|error| self.given_up(step, !was_given_up).unwrap_or_else(|| failed(step, error)))
    }

    /// The times of both parts of a submit.
    fn milliseconds(&self, done: &InFlight) -> Result<(f64, Option<f64>), TraceError> {
        let limits = &self.device.info().limits;
        if limits.timestamp_period_ns == 0.0 {
            return Ok((done.submitted.elapsed().as_secs_f64() * 1e3, done.has_then.then_some(0.0)));
        }
        let mut ticks = [0u64; TIMES as usize];
        let ticks = &mut ticks[..if done.has_then { 3 } else { 2 }];
        let flags = vk::QueryResultFlags::TYPE_64 | vk::QueryResultFlags::WAIT;
        // SAFETY: the submit that writes these queries is over.
        unsafe { self.device.raw.get_query_pool_results(self.queries, TIMES * done.slot as u32, ticks, flags) }
            .context(done.step)?;
        let between = |first: usize| limits.milliseconds_between(ticks[first], ticks[first + 1]);
        Ok((between(0), done.has_then.then(|| between(1))))
    }
}

/// The counters by name, with what ray generation shaders counted in many places added.
fn summed(bytes: &[u8]) -> [u32; COUNTERS] {
    let word = |index: usize| pod_read_unaligned::<u32>(&bytes[4 * index..4 * index + 4]);
    let mut counters: [u32; COUNTERS] = std::array::from_fn(word);
    let spread = [Counter::CameraRays, Counter::BounceRays, Counter::ShadowRays, Counter::Workgroups];
    for (index, counter) in spread.into_iter().enumerate() {
        let first = COUNTERS + index * COUNTER_SLOTS;
        let sum = (first..first + COUNTER_SLOTS).fold(0u32, |sum, at| sum.wrapping_add(word(at)));
        counters[counter as usize] = counters[counter as usize].wrapping_add(sum);
    }
    counters
}

impl Drop for Submitter {
    fn drop(&mut self) {
        self.wait_for_all();
        if self.device.is_given_up() {
            return;
        }
        let raw = &self.device.raw;
        // SAFETY: nothing is in flight; null handles are allowed.
        unsafe {
            raw.destroy_semaphore(self.timeline, None);
            raw.destroy_query_pool(self.queries, None);
            raw.destroy_command_pool(self.pool, None);
        }
    }
}
