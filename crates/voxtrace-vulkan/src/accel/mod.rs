//! The acceleration structures of a scene: one below for each grid, shared by its instances, and one above over the
//! instances.

mod bricks;
mod faces;
mod geometry;
pub mod structure;

use crate::buffer::Buffer;
use crate::commands::Submitter;
use crate::device::Device;
use crate::method::Primitive;
use crate::transfer::Transfer;
use ash::vk;
use bytemuck::cast_slice;
use geometry::{Geometry, words_per_record};
use gpu_allocator::MemoryLocation;
use std::sync::Arc;
use structure::{Input, Structure};
use voxtrace_core::PackedScene;
use voxtrace_core::TraceError;
use voxtrace_scene::Transform;

const BOTTOM: vk::AccelerationStructureTypeKHR = vk::AccelerationStructureTypeKHR::BOTTOM_LEVEL;
const TOP: vk::AccelerationStructureTypeKHR = vk::AccelerationStructureTypeKHR::TOP_LEVEL;
const NAME: &str = "acceleration structures";
/// Most bytes of scratch memory of one build; more primitives are built in parts.
const SCRATCH_BUDGET: u64 = 4 << 30;
/// The number of an entry of the top level has this many bits.
const ENTRY_BITS: u32 = 24;

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
    /// Bytes of the records of primitives.
    pub record_bytes: u64,
    /// Number of structures below.
    pub structures: u64,
}

/// The structures and records of a scene.
pub struct Accel {
    // Dropped before what it refers to.
    top: Structure,
    _bottom: Vec<Structure>,
    /// The records, see `shaders/primitive.slang`.
    pub records: Buffer,
    pub report: AccelReport,
}

/// Part of a grid that one structure holds, and where its records begin.
struct Part {
    grid: u32,
    structure: usize,
    first_word: usize,
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
        for (index, grid) in scene.grids().iter().enumerate() {
            let geometry = Geometry::of(scene, grid, primitive, is_opaque);
            for (part, first) in builder.build_grid(&geometry)? {
                // Two triangles share one record.
                let records = if geometry.corners.is_empty() { first } else { first / 2 };
                let first_word = words.len() + records * words_per_record(primitive);
                parts.push(Part { grid: index as u32, structure: bottom.len(), first_word });
                bottom.push(part);
            }
            words.extend(geometry.records);
        }
        let (instances, table) = entries(scene, &bottom, &parts)?;
        let words = [table, words].concat();
        report.record_bytes = words.len() as u64 * 4;
        let records = Buffer::storage(device, "primitive records", report.record_bytes)?;
        transfer.upload(submitter, &records, cast_slice(&words))?;
        let top = build_top(device, submitter, transfer, &instances)?;
        report.top_level_bytes = top.bytes();
        report.structures = bottom.len() as u64;
        Ok(Self { top, _bottom: bottom, records, report })
    }

    /// The structure over the instances.
    pub fn top_level(&self) -> vk::AccelerationStructureKHR {
        self.top.handle
    }
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
    fn build_grid(&mut self, geometry: &Geometry) -> Result<Vec<(Structure, usize)>, TraceError> {
        let total = geometry.count();
        self.report.primitives += total as u64;
        let limit = self.device.info().ray_tracing.max_primitive_count.min(u64::from(u32::MAX)) as usize;
        let most = total.min(limit);
        // Whole rectangles: an even number of triangles.
        let mut most = if most < total { most & !1 } else { most };
        while most > 2 && self.input(geometry, most, 0, 0).sizes(self.device)?.scratch > SCRATCH_BUDGET {
            most = most.div_ceil(2).next_multiple_of(2);
        }
        let mut parts = Vec::new();
        let mut first = 0;
        while first < total {
            let count = most.min(total - first);
            parts.push((self.build_part(geometry, first, count)?, first));
            first += count;
        }
        Ok(parts)
    }

    fn build_part(&mut self, geometry: &Geometry, first: usize, count: usize) -> Result<Structure, TraceError> {
        let (data, indices) = if geometry.corners.is_empty() {
            (self.input_buffer(cast_slice(&geometry.boxes[first..first + count]))?, None)
        } else {
            let corners = &geometry.corners[2 * first..2 * (first + count)];
            let indices: Vec<u32> =
                (0..corners.len() as u32 / 4).flat_map(|i| [0, 1, 2, 2, 1, 3].map(|corner| 4 * i + corner)).collect();
            (self.input_buffer(cast_slice(corners))?, Some(self.input_buffer(cast_slice(&indices))?))
        };
        let index_address = indices.as_ref().map_or(0, Buffer::address);
        let input = self.input(geometry, count, data.address(), index_address);
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

    fn input(&self, geometry: &Geometry, count: usize, data: u64, indices: u64) -> Input<'static> {
        let address = |device_address| vk::DeviceOrHostAddressConstKHR { device_address };
        let (kind, content) = if geometry.corners.is_empty() {
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

/// The entries of the top level, and for each the packed instance and the word of its first record.
fn entries(
    scene: &PackedScene,
    bottom: &[Structure],
    parts: &[Part],
) -> Result<(Vec<vk::AccelerationStructureInstanceKHR>, Vec<u32>), TraceError> {
    let addresses = bottom.iter().map(Structure::address).collect::<Result<Vec<_>, _>>()?;
    let mut starts: Vec<Vec<&Part>> = vec![Vec::new(); scene.grids().len()];
    for part in parts {
        starts[part.grid as usize].push(part);
    }
    let total: usize = scene.instances().iter().map(|instance| starts[instance.grid as usize].len()).sum();
    if total >= 1 << ENTRY_BITS {
        return Err(TraceError::Unsupported(format!("{total} instances: hardware numbers at most 2²⁴")));
    }
    let (mut instances, mut table) = (Vec::with_capacity(total), Vec::with_capacity(2 * total));
    for (index, instance) in scene.instances().iter().enumerate() {
        for part in &starts[instance.grid as usize] {
            let first_word = 2 * total + part.first_word;
            let too_large = || TraceError::Unsupported("more than 2³² words of records".into());
            table.extend([index as u32, u32::try_from(first_word).map_err(|_| too_large())?]);
            instances.push(vk::AccelerationStructureInstanceKHR {
                transform: matrix(&instance.world_from_grid),
                instance_custom_index_and_mask: vk::Packed24_8::new(instances.len() as u32, 0xff),
                instance_shader_binding_table_record_offset_and_flags: vk::Packed24_8::new(0, 0),
                acceleration_structure_reference: vk::AccelerationStructureReferenceKHR {
                    device_handle: addresses[part.structure],
                },
            });
        }
    }
    Ok((instances, table))
}

/// Three rows of four.
fn matrix(transform: &Transform) -> vk::TransformMatrixKHR {
    let (linear, translation) = (transform.linear, transform.translation);
    let mut matrix = [0.0; 12];
    for row in 0..3 {
        for column in 0..3 {
            matrix[4 * row + column] = linear.col(column)[row];
        }
        matrix[4 * row + 3] = translation[row];
    }
    vk::TransformMatrixKHR { matrix }
}

fn build_top(
    device: &Arc<Device>,
    submitter: &mut Submitter,
    transfer: &mut Transfer,
    instances: &[vk::AccelerationStructureInstanceKHR],
) -> Result<Structure, TraceError> {
    let usage = vk::BufferUsageFlags::ACCELERATION_STRUCTURE_BUILD_INPUT_READ_ONLY_KHR
        | vk::BufferUsageFlags::SHADER_DEVICE_ADDRESS
        | vk::BufferUsageFlags::TRANSFER_DST;
    let size = size_of_val(instances) as u64;
    let buffer = Buffer::new(device, "build input", size + 16, usage, MemoryLocation::GpuOnly)?;
    // SAFETY: the records are plain numbers without padding: 48 + 4 + 4 + 8 bytes.
    let bytes = unsafe { std::slice::from_raw_parts(instances.as_ptr().cast::<u8>(), size as usize) };
    transfer.upload(submitter, &buffer, bytes)?;
    let data = vk::AccelerationStructureGeometryInstancesDataKHR::default()
        .data(vk::DeviceOrHostAddressConstKHR { device_address: buffer.address() });
    let geometry = vk::AccelerationStructureGeometryKHR::default()
        .geometry_type(vk::GeometryTypeKHR::INSTANCES)
        .geometry(vk::AccelerationStructureGeometryDataKHR { instances: data });
    let input = Input::single(TOP, geometry, instances.len() as u32);
    Structure::build(device, submitter, "top level", &input)
}
