//! The acceleration structures of a scene: one below for each grid, shared by its instances, and one above over the
//! instances, which is built anew where things move.

mod bricks;
mod faces;
mod primitives;
pub mod structure;
mod top;

use crate::buffer::Buffer;
use crate::commands::Submitter;
use crate::device::Device;
use crate::method::Primitive;
use crate::scene::written;
use crate::transfer::Transfer;
use ash::vk;
use bytemuck::cast_slice;
use glam::IVec3;
use gpu_allocator::MemoryLocation;
use primitives::{Primitives, words_per_record};
use std::sync::Arc;
use structure::{Input, Structure};
use top::Part;
pub use top::Top;
use voxtrace_core::packed::{PackedGrid, Placement};
use voxtrace_core::{PackedScene, TraceError};

const BOTTOM: vk::AccelerationStructureTypeKHR = vk::AccelerationStructureTypeKHR::BOTTOM_LEVEL;
const NAME: &str = "acceleration structures";
/// The step in which instances are written and the structure over them is built.
pub const BUILDING_TOP: &str = "building the acceleration structure over the instances";
/// Most bytes of scratch memory of one build; more primitives are built in parts.
const SCRATCH_BUDGET: u64 = 4 << 30;

/// What the structures of a scene take, as the driver tells.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct AccelReport {
    /// Boxes and triangles of all grids.
    pub primitives: u64,
    /// Bytes below before compaction.
    pub bytes_before_compaction: u64,
    /// Bytes below after compaction.
    pub bytes: u64,
    /// Bytes above.
    pub top_level_bytes: u64,
    /// Bytes of the records of primitives, and of those of the entries above.
    pub record_bytes: u64,
    /// Number of structures below.
    pub structures: u64,
}

/// The structures and records of a scene.
pub struct Accel {
    // Dropped before what it refers to.
    top: Top,
    _bottom: Vec<Structure>,
    /// For each grid the parts that hold it.
    parts: Vec<Vec<Part>>,
    /// The records, see `shaders/primitive.slang`.
    pub records: Buffer,
    /// The bounds of each grid when its structure was built.
    bounds: Vec<(IVec3, IVec3)>,
    report: AccelReport,
}

impl Accel {
    /// Builds everything. `is_opaque`: what hardware finds needs no word of a shader to count.
    pub fn new(
        device: &Arc<Device>,
        submitter: &mut Submitter,
        transfer: &mut Transfer,
        scene: &PackedScene,
        primitive: Primitive,
        is_opaque: bool,
    ) -> Result<Self, TraceError> {
        let mut report = AccelReport::default();
        let (mut bottom, mut parts, mut words) = (Vec::new(), Vec::new(), Vec::<u32>::new());
        let mut builder = Builder { device, submitter, transfer, is_opaque, report: &mut report };
        for grid in scene.grids() {
            let primitives = Primitives::of(scene.geometry(), grid, primitive, is_opaque);
            let mut of_grid = Vec::new();
            for (structure, first) in builder.build_grid(&primitives)? {
                // Two triangles share one record.
                let records = if primitives.corners.is_empty() { first } else { first / 2 };
                let first_word = words.len() + records * words_per_record(primitive);
                let too_large = |_| TraceError::Unsupported("more than 2³² words of records".into());
                let first_word = u32::try_from(first_word).map_err(too_large)?;
                of_grid.push(Part { structure: structure.address()?, first_word });
                bottom.push(structure);
            }
            parts.push(of_grid);
            words.extend(primitives.records);
        }
        let records = written(device, submitter, transfer, "primitive records", cast_slice(&words))?;
        let top = Top::unbuilt(device, scene.placement(), &parts, None)?;
        transfer.write(submitter, &top.writes(), Some((BUILDING_TOP, &|commands| top.record(commands))))?;
        report.record_bytes = size_of_val(&words[..]) as u64;
        report.structures = bottom.len() as u64;
        let bounds = bounds_of(scene.grids()).collect();
        Ok(Self { top: top.settled(), _bottom: bottom, parts, records, bounds, report })
    }

    /// The same structures below, with instances of them elsewhere, once what [`Self::top`] says is written and recorded.
    pub fn unbuilt(self, device: &Arc<Device>, placement: &Placement) -> Result<Self, TraceError> {
        let top = Top::unbuilt(device, placement, &self.parts, Some(self.top))?;
        Ok(Self { top, ..self })
    }

    /// Whether its grids have these bounds.
    pub fn has_bounds(&self, grids: &[PackedGrid]) -> bool {
        bounds_of(grids).eq(self.bounds.iter().copied())
    }

    /// What is over the instances.
    pub fn top(&self) -> &Top {
        &self.top
    }

    /// The structure over the instances.
    pub fn top_level(&self) -> vk::AccelerationStructureKHR {
        self.top.handle()
    }

    /// For each entry of the structure over the instances what it stands for.
    pub fn entries(&self) -> &Buffer {
        &self.top.entries
    }

    /// What the structures take.
    pub fn report(&self) -> AccelReport {
        AccelReport {
            top_level_bytes: self.top.bytes(),
            record_bytes: self.report.record_bytes + self.top.entry_bytes(),
            ..self.report
        }
    }
}

fn bounds_of(grids: &[PackedGrid]) -> impl Iterator<Item = (IVec3, IVec3)> {
    grids.iter().map(|grid| (grid.min, grid.max))
}

/// What building the structure of a grid needs.
struct Builder<'a> {
    device: &'a Arc<Device>,
    submitter: &'a mut Submitter,
    transfer: &'a mut Transfer,
    is_opaque: bool,
    report: &'a mut AccelReport,
}

impl Builder<'_> {
    /// The structures of a grid, more than one where the device's limits ask for it, each with its first primitive.
    fn build_grid(&mut self, primitives: &Primitives) -> Result<Vec<(Structure, usize)>, TraceError> {
        let total = primitives.count();
        self.report.primitives += total as u64;
        let limit = self.device.info().ray_tracing.max_primitive_count.min(u64::from(u32::MAX)) as usize;
        let most = total.min(limit);
        // Whole rectangles: an even number of triangles.
        let mut most = if most < total { most & !1 } else { most };
        while most > 2 && self.input(primitives, most, 0, 0).sizes(self.device)?.scratch > SCRATCH_BUDGET {
            most = most.div_ceil(2).next_multiple_of(2);
        }
        let mut parts = Vec::new();
        let mut first = 0;
        while first < total {
            let count = most.min(total - first);
            parts.push((self.build_part(primitives, first, count)?, first));
            first += count;
        }
        Ok(parts)
    }

    fn build_part(&mut self, primitives: &Primitives, first: usize, count: usize) -> Result<Structure, TraceError> {
        let (data, indices) = if primitives.corners.is_empty() {
            (self.input_buffer(cast_slice(&primitives.boxes[first..first + count]))?, None)
        } else {
            let corners = &primitives.corners[2 * first..2 * (first + count)];
            let indices: Vec<u32> =
                (0..corners.len() as u32 / 4).flat_map(|i| [0, 1, 2, 2, 1, 3].map(|corner| 4 * i + corner)).collect();
            (self.input_buffer(cast_slice(corners))?, Some(self.input_buffer(cast_slice(&indices))?))
        };
        let index_address = indices.as_ref().map_or(0, Buffer::address);
        let input = self.input(primitives, count, data.address(), index_address);
        let built = Structure::build(self.device, self.submitter, NAME, &input)?;
        self.report.bytes_before_compaction += built.bytes();
        let compact = built.compacted(self.submitter, NAME, BOTTOM)?;
        self.report.bytes += compact.bytes();
        Ok(compact)
    }

    fn input_buffer(&mut self, bytes: &[u8]) -> Result<Buffer, TraceError> {
        let usage = vk::BufferUsageFlags::ACCELERATION_STRUCTURE_BUILD_INPUT_READ_ONLY_KHR
            | vk::BufferUsageFlags::SHADER_DEVICE_ADDRESS
            | vk::BufferUsageFlags::TRANSFER_DST;
        let size = bytes.len() as u64;
        let buffer = Buffer::new(self.device, "build input", size, usage, MemoryLocation::GpuOnly)?;
        self.transfer.upload(self.submitter, &buffer, bytes)?;
        Ok(buffer)
    }

    fn input(&self, primitives: &Primitives, count: usize, data: u64, indices: u64) -> Input<'static> {
        let address = |device_address| vk::DeviceOrHostAddressConstKHR { device_address };
        let (kind, content) = if primitives.corners.is_empty() {
            let boxes = vk::AccelerationStructureGeometryAabbsDataKHR::default().data(address(data)).stride(24);
            (vk::GeometryTypeKHR::AABBS, vk::AccelerationStructureGeometryDataKHR { aabbs: boxes })
        } else {
            let triangles = vk::AccelerationStructureGeometryTrianglesDataKHR::default()
                .vertex_format(vk::Format::R32G32B32_SFLOAT)
                .vertex_data(address(data))
                .vertex_stride(12)
                .max_vertex((2 * count).saturating_sub(1) as u32)
                .index_type(vk::IndexType::UINT32)
                .index_data(address(indices));
            (vk::GeometryTypeKHR::TRIANGLES, vk::AccelerationStructureGeometryDataKHR { triangles })
        };
        let flags = if self.is_opaque {
            vk::GeometryFlagsKHR::OPAQUE
        } else {
            vk::GeometryFlagsKHR::NO_DUPLICATE_ANY_HIT_INVOCATION
        };
        let geometry =
            vk::AccelerationStructureGeometryKHR::default().geometry_type(kind).geometry(content).flags(flags);
        Input::single(BOTTOM, geometry, count as u32)
    }
}
