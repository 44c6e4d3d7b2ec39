//! The acceleration structure over the instances, with what its entries stand for.

use super::structure::{Input, Structure};
use crate::buffer::Buffer;
use crate::commands::Submitter;
use crate::device::Device;
use crate::scene::written;
use crate::transfer::Transfer;
use ash::vk;
use bytemuck::cast_slice;
use gpu_allocator::MemoryLocation;
use std::sync::Arc;
use voxtrace_core::TraceError;
use voxtrace_core::packed::Placement;
use voxtrace_scene::Transform;

const KIND: vk::AccelerationStructureTypeKHR = vk::AccelerationStructureTypeKHR::TOP_LEVEL;
/// The number of an entry has this many bits.
const ENTRY_BITS: u32 = 24;

/// Part of a grid that one structure holds.
pub struct Part {
    /// Address of the structure.
    pub structure: vk::DeviceAddress,
    /// Where its records begin.
    pub first_word: u32,
}

/// The structure over the instances.
pub struct Top {
    pub structure: Structure,
    /// For each entry the packed instance and the word of its first record.
    pub entries: Buffer,
    /// Bytes of them.
    pub entry_bytes: u64,
    count: usize,
}

impl Top {
    /// Builds the structure; `parts` are those of each grid. In place of an `earlier` one where that has as many entries.
    /// It is built, not updated: updates keep the boxes of the first build, however far things have moved.
    pub fn new(
        device: &Arc<Device>,
        submitter: &mut Submitter,
        transfer: &mut Transfer,
        placement: &Placement,
        parts: &[Vec<Part>],
        earlier: Option<Self>,
    ) -> Result<Self, TraceError> {
        let (instances, table) = entries_of(placement, parts)?;
        let (earlier, kept) = match earlier {
            Some(top) => (Some(top.structure).filter(|_| top.count == instances.len()), Some(top.entries)),
            None => (None, None),
        };
        let entries = written(device, submitter, transfer, "top level entries", cast_slice(&table), kept)?;
        let buffer = input_buffer(device, submitter, transfer, &instances)?;
        let data = vk::AccelerationStructureGeometryInstancesDataKHR::default()
            .data(vk::DeviceOrHostAddressConstKHR { device_address: buffer.address() });
        let geometry = vk::AccelerationStructureGeometryKHR::default()
            .geometry_type(vk::GeometryTypeKHR::INSTANCES)
            .geometry(vk::AccelerationStructureGeometryDataKHR { instances: data });
        let input = Input::single(KIND, geometry, instances.len() as u32);
        let structure = match earlier {
            Some(structure) => structure.rebuilt(submitter, &input)?,
            None => Structure::build(device, submitter, "top level", &input)?,
        };
        Ok(Self { structure, entries, entry_bytes: size_of_val(&table[..]) as u64, count: instances.len() })
    }
}

/// The entries of the top level, and for each the packed instance and the word of its first record.
fn entries_of(
    placement: &Placement,
    parts: &[Vec<Part>],
) -> Result<(Vec<vk::AccelerationStructureInstanceKHR>, Vec<u32>), TraceError> {
    let total: usize = placement.instances().iter().map(|instance| parts[instance.grid as usize].len()).sum();
    if total >= 1 << ENTRY_BITS {
        return Err(TraceError::Unsupported(format!("{total} instances: hardware numbers at most 2²⁴")));
    }
    let (mut instances, mut table) = (Vec::with_capacity(total), Vec::with_capacity(2 * total));
    for (index, instance) in placement.instances().iter().enumerate() {
        for part in &parts[instance.grid as usize] {
            table.extend([index as u32, part.first_word]);
            instances.push(vk::AccelerationStructureInstanceKHR {
                transform: matrix(&instance.world_from_grid),
                instance_custom_index_and_mask: vk::Packed24_8::new(instances.len() as u32, 0xff),
                instance_shader_binding_table_record_offset_and_flags: vk::Packed24_8::new(0, 0),
                acceleration_structure_reference: vk::AccelerationStructureReferenceKHR {
                    device_handle: part.structure,
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

fn input_buffer(
    device: &Arc<Device>,
    submitter: &mut Submitter,
    transfer: &mut Transfer,
    instances: &[vk::AccelerationStructureInstanceKHR],
) -> Result<Buffer, TraceError> {
    let usage = vk::BufferUsageFlags::ACCELERATION_STRUCTURE_BUILD_INPUT_READ_ONLY_KHR
        | vk::BufferUsageFlags::SHADER_DEVICE_ADDRESS
        | vk::BufferUsageFlags::TRANSFER_DST;
    let size = size_of_val(instances) as u64;
    let buffer = Buffer::new(device, "top level input", size + 16, usage, MemoryLocation::GpuOnly)?;
    // SAFETY: the records are plain numbers without padding: 48 + 4 + 4 + 8 bytes.
    let bytes = unsafe { std::slice::from_raw_parts(instances.as_ptr().cast::<u8>(), size as usize) };
    transfer.upload(submitter, &buffer, bytes)?;
    Ok(buffer)
}
