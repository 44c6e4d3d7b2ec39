//! Buffers on the device, each with a name in the report of what is allocated.

use crate::device::{Device, locked};
use crate::errors::{ResultExt, not_allocated};
use ash::vk;
use gpu_allocator::MemoryLocation;
use gpu_allocator::vulkan::{Allocation, AllocationCreateDesc, AllocationScheme};
use std::sync::Arc;
use voxtrace_core::TraceError;

/// Allocations from this size on get memory of their own.
const DEDICATED_BYTES: u64 = 1 << 20;

/// A buffer and its memory.
pub struct Buffer {
    device: Arc<Device>,
    pub handle: vk::Buffer,
    allocation: Option<Allocation>,
    /// Bytes that can be used.
    pub size: u64,
    /// Bytes that the driver needs for it.
    bytes: u64,
    name: String,
}

impl Buffer {
    /// A buffer of `size` bytes, at least 16, whose content is undefined.
    pub fn new(
        device: &Arc<Device>,
        name: &str,
        size: u64,
        usage: vk::BufferUsageFlags,
        location: MemoryLocation,
    ) -> Result<Self, TraceError> {
        let size = Self::rounded(size);
        if location == MemoryLocation::GpuOnly {
            device.check_available(size)?;
        }
        let info = vk::BufferCreateInfo::default().size(size).usage(usage);
        // SAFETY: the device is alive.
        let handle =
            unsafe { device.raw.create_buffer(&info, None) }.context(&format!("creating the buffer {name}"))?;
        let mut buffer =
            Self { device: Arc::clone(device), handle, allocation: None, size, bytes: 0, name: name.to_owned() };
        // SAFETY: the buffer was just created on this device.
        let requirements = unsafe { device.raw.get_buffer_memory_requirements(handle) };
        let is_dedicated = requirements.size >= DEDICATED_BYTES;
        let scheme = if is_dedicated {
            AllocationScheme::DedicatedBuffer(handle)
        } else {
            AllocationScheme::GpuAllocatorManaged
        };
        let allocation = locked(&device.allocator)
            .allocate(&AllocationCreateDesc { name, requirements, location, linear: true, allocation_scheme: scheme })
            .map_err(|error| not_allocated(device.available_bytes(), name, requirements.size, &error))?;
        // SAFETY: the memory is of a type that the requirements allow, and nothing else is bound there.
        let bound = unsafe { device.raw.bind_buffer_memory(handle, allocation.memory(), allocation.offset()) };
        buffer.allocation = Some(allocation);
        buffer.bytes = requirements.size;
        device.allocations.add(name, buffer.bytes);
        bound.context(&format!("binding the buffer {name}"))?;
        Ok(buffer)
    }

    /// The size that a buffer for so many bytes has. Empty arrays are bound too: as a buffer that nobody reads.
    pub fn rounded(size: u64) -> u64 {
        size.max(16).next_multiple_of(16)
    }

    /// A storage buffer in the device's memory.
    pub fn storage(device: &Arc<Device>, name: &str, size: u64) -> Result<Self, TraceError> {
        let limit = device.info().limits.max_storage_bytes();
        if Self::rounded(size) > limit {
            return Err(TraceError::OutOfMemory { needed: size, available: limit });
        }
        let usage = vk::BufferUsageFlags::STORAGE_BUFFER
            | vk::BufferUsageFlags::TRANSFER_SRC
            | vk::BufferUsageFlags::TRANSFER_DST;
        Self::new(device, name, size, usage, MemoryLocation::GpuOnly)
    }

    /// The bytes of a buffer that the host can see.
    pub fn mapped(&self) -> &[u8] {
        let slice = self.allocation.as_ref().and_then(Allocation::mapped_slice);
        slice.map_or(&[], |slice| &slice[..self.size as usize])
    }

    /// The bytes of a buffer that the host can see, to write.
    pub fn mapped_mut(&mut self) -> &mut [u8] {
        let slice = self.allocation.as_mut().and_then(Allocation::mapped_slice_mut);
        slice.map_or(&mut [], |slice| &mut slice[..self.size as usize])
    }

    /// The buffer's address on the device; its usage must allow that.
    pub fn address(&self) -> vk::DeviceAddress {
        let info = vk::BufferDeviceAddressInfo::default().buffer(self.handle);
        // SAFETY: only buffers made with that usage are asked, on devices that have the feature.
        unsafe { self.device.raw.get_buffer_device_address(&info) }
    }

    /// Its name in the book of memory.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Bytes that the driver needs for it.
    pub fn bytes(&self) -> u64 {
        self.bytes
    }
}

impl Drop for Buffer {
    fn drop(&mut self) {
        if self.device.hung().is_some() {
            return;
        }
        // SAFETY: whoever drops a buffer has waited for the work that uses it.
        unsafe { self.device.raw.destroy_buffer(self.handle, None) };
        if let Some(allocation) = self.allocation.take() {
            // An error would say that the allocation is not one of this allocator.
            let _ = locked(&self.device.allocator).free(allocation);
            self.device.allocations.remove(&self.name, self.bytes);
        }
    }
}
