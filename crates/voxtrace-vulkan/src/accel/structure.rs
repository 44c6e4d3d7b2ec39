//! One acceleration structure: its build, and its compaction.

use crate::buffer::Buffer;
use crate::commands::Submitter;
use crate::device::Device;
use crate::errors::ResultExt;
use ash::{khr, vk};
use gpu_allocator::MemoryLocation;
use std::sync::Arc;
use voxtrace_core::TraceError;

/// A built structure and its memory.
pub struct Structure {
    device: Arc<Device>,
    pub handle: vk::AccelerationStructureKHR,
    // Dropped after the structure.
    buffer: Buffer,
}

/// The extension's functions; structures are only made on devices that have them.
pub fn functions(device: &Device) -> Result<&khr::acceleration_structure::Device, TraceError> {
    let missing = || TraceError::Unsupported("no VK_KHR_acceleration_structure".into());
    device.acceleration.as_ref().ok_or_else(missing)
}

/// Bytes that a build needs.
#[derive(Clone, Copy, Debug, Default)]
pub struct Sizes {
    /// Of the structure.
    pub structure: u64,
    /// Of scratch memory.
    pub scratch: u64,
}

/// Memory that builds work in.
pub struct Scratch {
    buffer: Buffer,
    alignment: u64,
}

impl Scratch {
    /// Memory for builds that ask for up to `size` bytes.
    pub fn new(device: &Arc<Device>, size: u64) -> Result<Self, TraceError> {
        let alignment = device.info().ray_tracing.scratch_alignment.max(1);
        let usage = vk::BufferUsageFlags::STORAGE_BUFFER | vk::BufferUsageFlags::SHADER_DEVICE_ADDRESS;
        let buffer = Buffer::new(device, "build scratch", size + alignment, usage, MemoryLocation::GpuOnly)?;
        Ok(Self { buffer, alignment })
    }

    fn address(&self) -> vk::DeviceAddress {
        self.buffer.address().next_multiple_of(self.alignment)
    }
}

/// What to build: geometries of one kind and how many primitives each has.
pub struct Input<'a> {
    pub kind: vk::AccelerationStructureTypeKHR,
    pub flags: vk::BuildAccelerationStructureFlagsKHR,
    pub geometries: Vec<vk::AccelerationStructureGeometryKHR<'a>>,
    pub counts: Vec<u32>,
}

impl<'a> Input<'a> {
    /// One geometry with the flags that scenes are built with.
    pub fn single(
        kind: vk::AccelerationStructureTypeKHR,
        geometry: vk::AccelerationStructureGeometryKHR<'a>,
        count: u32,
    ) -> Self {
        let mut flags = vk::BuildAccelerationStructureFlagsKHR::PREFER_FAST_TRACE;
        if kind == vk::AccelerationStructureTypeKHR::BOTTOM_LEVEL {
            flags |= vk::BuildAccelerationStructureFlagsKHR::ALLOW_COMPACTION;
        }
        Self { kind, flags, geometries: vec![geometry], counts: vec![count] }
    }

    fn info(&self) -> vk::AccelerationStructureBuildGeometryInfoKHR<'_> {
        vk::AccelerationStructureBuildGeometryInfoKHR::default()
            .ty(self.kind)
            .flags(self.flags)
            .mode(vk::BuildAccelerationStructureModeKHR::BUILD)
            .geometries(&self.geometries)
    }

    /// What the driver says that it needs.
    pub fn sizes(&self, device: &Device) -> Result<Sizes, TraceError> {
        let mut sizes = vk::AccelerationStructureBuildSizesInfoKHR::default();
        let build = vk::AccelerationStructureBuildTypeKHR::DEVICE;
        // SAFETY: the geometry is described fully; addresses are not read here.
        unsafe {
            functions(device)?.get_acceleration_structure_build_sizes(build, &self.info(), &self.counts, &mut sizes);
        }
        let scratch = sizes.build_scratch_size.max(sizes.update_scratch_size);
        Ok(Sizes { structure: sizes.acceleration_structure_size, scratch })
    }
}

impl Structure {
    fn empty(
        device: &Arc<Device>,
        name: &str,
        kind: vk::AccelerationStructureTypeKHR,
        size: u64,
    ) -> Result<Self, TraceError> {
        let usage =
            vk::BufferUsageFlags::ACCELERATION_STRUCTURE_STORAGE_KHR | vk::BufferUsageFlags::SHADER_DEVICE_ADDRESS;
        let buffer = Buffer::new(device, name, size, usage, MemoryLocation::GpuOnly)?;
        let info = vk::AccelerationStructureCreateInfoKHR::default().buffer(buffer.handle).size(size).ty(kind);
        // SAFETY: the buffer is as large as the structure and allows it.
        let handle = unsafe { functions(device)?.create_acceleration_structure(&info, None) }
            .context("creating an acceleration structure")?;
        Ok(Self { device: Arc::clone(device), handle, buffer })
    }

    /// Builds a structure. `name` is that of its memory.
    pub fn build(
        device: &Arc<Device>,
        submitter: &mut Submitter,
        name: &str,
        input: &Input,
    ) -> Result<Self, TraceError> {
        let sizes = input.sizes(device)?;
        device.check_available(sizes.structure + sizes.scratch)?;
        let structure = Self::empty(device, name, input.kind, sizes.structure)?;
        structure.fill(submitter, input, sizes.scratch, false)?;
        Ok(structure)
    }

    /// Memory for a structure from an input of these sizes or smaller ones, not built yet.
    pub fn unbuilt(
        device: &Arc<Device>,
        name: &str,
        kind: vk::AccelerationStructureTypeKHR,
        sizes: Sizes,
    ) -> Result<Self, TraceError> {
        device.check_available(sizes.structure)?;
        Self::empty(device, name, kind, sizes.structure)
    }

    /// Brings a structure that was built with updates allowed to the input's boxes, as many as it was built with.
    pub fn update(&self, submitter: &mut Submitter, input: &Input) -> Result<(), TraceError> {
        self.fill(submitter, input, input.sizes(&self.device)?.scratch, true)
    }

    fn fill(
        &self,
        submitter: &mut Submitter,
        input: &Input,
        scratch_bytes: u64,
        is_update: bool,
    ) -> Result<(), TraceError> {
        let scratch = Scratch::new(&self.device, scratch_bytes)?;
        submitter.run_commands("building an acceleration structure", &|commands| {
            self.record_build(commands, input, &scratch, is_update);
        })?;
        Ok(())
    }

    /// Records the build, or the update, from an input that is no larger than the structure was made for. Nothing that uses the structure may
    /// be in flight; structure, scratch memory and what the input points to must live until the commands are done.
    pub fn record_build(&self, commands: vk::CommandBuffer, input: &Input, scratch: &Scratch, is_update: bool) {
        // Only devices that have the functions have structures.
        let Some(functions) = &self.device.acceleration else { return };
        let scratch_at = vk::DeviceOrHostAddressKHR { device_address: scratch.address() };
        let mut info = input.info().dst_acceleration_structure(self.handle).scratch_data(scratch_at);
        if is_update {
            info = info.mode(vk::BuildAccelerationStructureModeKHR::UPDATE).src_acceleration_structure(self.handle);
        }
        let range = |&count: &u32| vk::AccelerationStructureBuildRangeInfoKHR::default().primitive_count(count);
        let ranges: Vec<_> = input.counts.iter().map(range).collect();
        // SAFETY: structure, scratch and the buffers behind the addresses live until the commands are done, as the caller sees to.
        unsafe { functions.cmd_build_acceleration_structures(commands, &[info], &[&ranges]) }
    }

    /// The same structure in as little memory as it needs.
    pub fn compacted(
        self,
        submitter: &mut Submitter,
        name: &str,
        kind: vk::AccelerationStructureTypeKHR,
    ) -> Result<Self, TraceError> {
        let device = Arc::clone(&self.device);
        let raw = &device.raw;
        let query_type = vk::QueryType::ACCELERATION_STRUCTURE_COMPACTED_SIZE_KHR;
        let info = vk::QueryPoolCreateInfo::default().query_type(query_type).query_count(1);
        // SAFETY: the device is alive; the pool is destroyed below.
        let pool = unsafe { raw.create_query_pool(&info, None) }.context("compacting")?;
        let result = self.compacted_size(submitter, pool, query_type);
        if device.hung().is_none() {
            // SAFETY: the submit that used the pool is over.
            unsafe { raw.destroy_query_pool(pool, None) };
        }
        let compact = Self::empty(&device, name, kind, result?)?;
        let copy = vk::CopyAccelerationStructureInfoKHR::default()
            .src(self.handle)
            .dst(compact.handle)
            .mode(vk::CopyAccelerationStructureModeKHR::COMPACT);
        let functions = functions(&device)?;
        submitter.run_commands("compacting an acceleration structure", &|commands| {
            // SAFETY: both structures are alive; the new one has the size that the driver asked for.
            unsafe { functions.cmd_copy_acceleration_structure(commands, &copy) }
        })?;
        Ok(compact)
    }

    fn compacted_size(
        &self,
        submitter: &mut Submitter,
        pool: vk::QueryPool,
        query_type: vk::QueryType,
    ) -> Result<u64, TraceError> {
        let (raw, functions) = (&self.device.raw, functions(&self.device)?);
        submitter.run_commands("asking for the compacted size", &|commands| {
            // SAFETY: the structure was built with compaction allowed; the pool has one query of this type.
            unsafe {
                raw.cmd_reset_query_pool(commands, pool, 0, 1);
                functions.cmd_write_acceleration_structures_properties(commands, &[self.handle], query_type, pool, 0);
            }
        })?;
        let mut size = [0u64];
        let flags = vk::QueryResultFlags::TYPE_64 | vk::QueryResultFlags::WAIT;
        // SAFETY: the query has been written.
        unsafe { raw.get_query_pool_results(pool, 0, &mut size, flags) }.context("asking for the compacted size")?;
        Ok(size[0])
    }

    /// Its address on the device.
    pub fn address(&self) -> Result<vk::DeviceAddress, TraceError> {
        let info = vk::AccelerationStructureDeviceAddressInfoKHR::default().acceleration_structure(self.handle);
        // SAFETY: the structure is alive.
        Ok(unsafe { functions(&self.device)?.get_acceleration_structure_device_address(&info) })
    }

    /// Bytes of its memory.
    pub fn bytes(&self) -> u64 {
        self.buffer.bytes()
    }
}

impl Drop for Structure {
    fn drop(&mut self) {
        if self.device.hung().is_some() {
            return;
        }
        if let Some(functions) = &self.device.acceleration {
            // SAFETY: whoever drops a structure has waited for the work that uses it.
            unsafe { functions.destroy_acceleration_structure(self.handle, None) };
        }
    }
}
