//! Copies between host and device through one staging buffer, piece by piece.

use crate::buffer::Buffer;
use crate::commands::Submitter;
use crate::device::Device;
use ash::vk;
use gpu_allocator::MemoryLocation;
use std::sync::Arc;
use voxtrace_core::TraceError;

/// Bytes of one piece.
const PIECE: u64 = 32 << 20;

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
        let usage = vk::BufferUsageFlags::TRANSFER_SRC;
        let staging = staging(&self.device, &mut self.up, bytes.len() as u64, usage, MemoryLocation::CpuToGpu)?;
        let piece = staging.size as usize;
        for (index, part) in bytes.chunks(piece).enumerate() {
            staging.mapped_mut()[..part.len()].copy_from_slice(part);
            let copy = vk::BufferCopy { src_offset: 0, dst_offset: (index * piece) as u64, size: part.len() as u64 };
            copy_now(&self.device, submitter, "uploading", staging, buffer, copy)?;
        }
        self.device.allocations.uploaded(buffer.name(), bytes.len() as u64);
        Ok(())
    }

    /// Reads the start of a buffer.
    pub fn download(&mut self, submitter: &mut Submitter, buffer: &Buffer, bytes: &mut [u8]) -> Result<(), TraceError> {
        let usage = vk::BufferUsageFlags::TRANSFER_DST;
        let staging = staging(&self.device, &mut self.down, bytes.len() as u64, usage, MemoryLocation::GpuToCpu)?;
        let piece = staging.size as usize;
        for (index, part) in bytes.chunks_mut(piece).enumerate() {
            let copy = vk::BufferCopy { src_offset: (index * piece) as u64, dst_offset: 0, size: part.len() as u64 };
            copy_now(&self.device, submitter, "reading back", buffer, staging, copy)?;
            part.copy_from_slice(&staging.mapped()[..part.len()]);
        }
        Ok(())
    }

    /// Frees the staging buffers.
    pub fn trim(&mut self) {
        (self.up, self.down) = (None, None);
    }
}

/// The staging buffer in `slot`, at least as large as the next piece of `wanted` bytes.
fn staging<'a>(
    device: &Arc<Device>,
    slot: &'a mut Option<Buffer>,
    wanted: u64,
    usage: vk::BufferUsageFlags,
    location: MemoryLocation,
) -> Result<&'a mut Buffer, TraceError> {
    let size = wanted.clamp(1 << 16, PIECE);
    if slot.as_ref().is_none_or(|buffer| buffer.size < size) {
        *slot = None;
        *slot = Some(Buffer::new(device, "staging", size, usage, location)?);
    }
    Ok(slot.as_mut().expect("it was just made"))
}

fn copy_now(
    device: &Device,
    submitter: &mut Submitter,
    step: &'static str,
    from: &Buffer,
    to: &Buffer,
    copy: vk::BufferCopy,
) -> Result<(), TraceError> {
    let (from, to) = (from.handle, to.handle);
    submitter.run_commands(step, &|commands| {
        // SAFETY: both buffers are alive and the range lies inside both; the commands are being recorded.
        unsafe { device.raw.cmd_copy_buffer(commands, from, to, &[copy]) }
    })?;
    Ok(())
}
