//! Copies between host and device through one staging buffer, piece by piece. What is written together goes in as few submits as
//! the staging buffer has room for, so that a frame in which things move or change waits for the device once.

use crate::buffer::Buffer;
use crate::commands::{Barrier, Submitter};
use crate::device::Device;
use ash::vk;
use gpu_allocator::MemoryLocation;
use std::borrow::Cow;
use std::sync::Arc;
use voxtrace_core::TraceError;

/// Most and fewest bytes of one piece.
const PIECE: u64 = 32 << 20;
const LEAST_PIECE: u64 = 1 << 16;

/// Bytes for a place in a buffer.
#[derive(Clone)]
pub struct Write<'a> {
    /// Where they go.
    pub buffer: &'a Buffer,
    /// The first byte there.
    pub at: u64,
    /// The bytes.
    pub bytes: Cow<'a, [u8]>,
}

impl<'a> Write<'a> {
    /// Bytes that stay where they are.
    pub fn new(buffer: &'a Buffer, at: u64, bytes: &'a [u8]) -> Self {
        Self { buffer, at, bytes: bytes.into() }
    }
}

/// Commands that are recorded.
pub type Record<'a> = &'a dyn Fn(vk::CommandBuffer);

/// Submits commands of a step. Returns the device's milliseconds, 0 where nobody waits.
type Submit<'a> =
    &'a dyn Fn(&mut Submitter, &'static str, &dyn Fn(vk::CommandBuffer, Barrier)) -> Result<f64, TraceError>;

/// The two staging buffers, made when first needed.
pub struct Transfer {
    device: Arc<Device>,
    up: Option<Buffer>,
    down: Option<Buffer>,
}

impl Transfer {
    pub fn new(device: &Arc<Device>) -> Self {
        Self { device: Arc::clone(device), up: None, down: None }
    }

    /// Writes `bytes` to the start of a buffer.
    pub fn upload(&mut self, submitter: &mut Submitter, buffer: &Buffer, bytes: &[u8]) -> Result<(), TraceError> {
        self.write(submitter, &[Write::new(buffer, 0, bytes)], None).map(|_| ())
    }

    /// Writes all of them, in this order, and then runs what `then` records, which sees what was written. Returns the device's milliseconds.
    pub fn write(
        &mut self,
        submitter: &mut Submitter,
        writes: &[Write],
        then: Option<(&'static str, Record)>,
    ) -> Result<f64, TraceError> {
        self.write_and(submitter, writes, then, &Submitter::run_commands_and)
    }

    /// As [`Self::write`] without waiting for the last submit: what is submitted later sees it. Buffers must stay until
    /// [`Submitter::wait_for_quiet`].
    pub fn write_quietly(
        &mut self,
        submitter: &mut Submitter,
        writes: &[Write],
        then: Option<(&'static str, Record)>,
    ) -> Result<(), TraceError> {
        let last: Submit = &|submitter, step, record| submitter.run_quietly(step, record).map(|()| 0.0);
        self.write_and(submitter, writes, then, last).map(|_| ())
    }

    fn write_and(
        &mut self,
        submitter: &mut Submitter,
        writes: &[Write],
        then: Option<(&'static str, Record)>,
        last: Submit,
    ) -> Result<f64, TraceError> {
        submitter.wait_for_quiet()?;
        let total: u64 = writes.iter().map(|write| write.bytes.len() as u64).sum();
        let usage = vk::BufferUsageFlags::TRANSFER_SRC;
        let staging = staging(&self.device, &mut self.up, total, usage, MemoryLocation::CpuToGpu)?;
        let piece = staging.size as usize;
        let (mut copies, mut used, mut ms) = (Vec::new(), 0, 0.0);
        for write in writes {
            let mut done = 0;
            while done < write.bytes.len() {
                if used == piece {
                    ms += submitter.run_commands_and("uploading", &copying(&self.device, staging, &copies, None))?;
                    (used, copies) = (0, Vec::new());
                }
                let size = (write.bytes.len() - done).min(piece - used);
                staging.mapped_mut()[used..used + size].copy_from_slice(&write.bytes[done..done + size]);
                let (src_offset, dst_offset) = (used as u64, write.at + done as u64);
                copies.push((write.buffer.handle, vk::BufferCopy { src_offset, dst_offset, size: size as u64 }));
                (done, used) = (done + size, used + size);
            }
            self.device.allocations.uploaded(write.buffer.name(), write.bytes.len() as u64);
        }
        if copies.is_empty() && then.is_none() {
            return Ok(ms);
        }
        let (step, then) = then.map_or(("uploading", None), |(step, record)| (step, Some(record)));
        Ok(ms + last(submitter, step, &copying(&self.device, staging, &copies, then))?)
    }

    /// Reads a buffer from the byte `at` on.
    pub fn download(
        &mut self,
        submitter: &mut Submitter,
        buffer: &Buffer,
        at: u64,
        bytes: &mut [u8],
    ) -> Result<(), TraceError> {
        let usage = vk::BufferUsageFlags::TRANSFER_DST;
        let staging = staging(&self.device, &mut self.down, bytes.len() as u64, usage, MemoryLocation::GpuToCpu)?;
        let piece = staging.size as usize;
        for (index, part) in bytes.chunks_mut(piece).enumerate() {
            let src_offset = at + (index * piece) as u64;
            let copy = vk::BufferCopy { src_offset, dst_offset: 0, size: part.len() as u64 };
            let (device, from, to) = (&self.device, buffer.handle, staging.handle);
            submitter.run_commands("reading back", &|commands| {
                // SAFETY: both buffers are alive and the range lies inside both; the commands are being recorded.
                unsafe { device.raw.cmd_copy_buffer(commands, from, to, &[copy]) }
            })?;
            part.copy_from_slice(&staging.mapped()[..part.len()]);
        }
        Ok(())
    }

    /// Frees the staging buffers.
    pub fn trim(&mut self) {
        (self.up, self.down) = (None, None);
    }
}

/// The staging buffer in `slot`, as large as the next piece of `wanted` bytes, or smaller where there is little memory.
fn staging<'a>(
    device: &Arc<Device>,
    slot: &'a mut Option<Buffer>,
    wanted: u64,
    usage: vk::BufferUsageFlags,
    location: MemoryLocation,
) -> Result<&'a mut Buffer, TraceError> {
    let size = wanted.clamp(LEAST_PIECE, PIECE);
    if slot.as_ref().is_none_or(|buffer| buffer.size < size) {
        let had = slot.take().map_or(0, |buffer| buffer.size);
        let size = size.min((device.available_bytes() / 8).max(LEAST_PIECE)).max(had);
        *slot = Some(Buffer::new(device, "staging", size, usage, location)?);
    }
    Ok(slot.as_mut().expect("it was just made"))
}

/// Records copies from the staging buffer, those to one buffer by one command, then what else is recorded.
fn copying<'a>(
    device: &'a Device,
    staging: &'a Buffer,
    copies: &'a [(vk::Buffer, vk::BufferCopy)],
    then: Option<Record<'a>>,
) -> impl Fn(vk::CommandBuffer, Barrier) + 'a {
    move |commands, barrier| {
        for to_one in copies.chunk_by(|a, b| a.0 == b.0) {
            let regions: Vec<_> = to_one.iter().map(|copy| copy.1).collect();
            // SAFETY: all buffers are alive, and each range lies inside both of its buffers; the commands are being recorded.
            unsafe { device.raw.cmd_copy_buffer(commands, staging.handle, to_one[0].0, &regions) }
        }
        if let Some(record) = then {
            barrier(commands);
            record(commands);
        }
    }
}
