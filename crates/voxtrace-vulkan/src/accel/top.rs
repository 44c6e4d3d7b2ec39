//! The acceleration structure over the instances, with what its entries stand for. It is built anew where things move, in the memory that
//! it has as long as that suffices, by the same submit that writes the placement.

use super::structure::{Input, Scratch, Structure};
use crate::buffer::Buffer;
use crate::device::Device;
use crate::transfer::Write;
use ash::vk;
use bytemuck::cast_slice;
use gpu_allocator::MemoryLocation;
use rayon::prelude::*;
use std::sync::Arc;
use voxtrace_core::TraceError;
use voxtrace_core::packed::{PackedInstance, Placement};
use voxtrace_scene::Transform;

const KIND: vk::AccelerationStructureTypeKHR = vk::AccelerationStructureTypeKHR::TOP_LEVEL;
/// The number of an entry has this many bits.
const ENTRY_BITS: u32 = 24;
/// Room for more entries, in parts of those that there are, where their number has changed once.
const SLACK: usize = 4;

/// Part of a grid that one structure holds.
pub struct Part {
    /// Address of the structure.
    pub structure: vk::DeviceAddress,
    /// Where its records begin.
    pub first_word: u32,
}

/// The structure over the instances.
pub struct Top {
    structure: Structure,
    /// For each entry the packed instance and the word of its first record.
    pub entries: Buffer,
    /// What that buffer holds.
    table: Vec<u32>,
    /// Entries that the structure has memory for.
    capacity: usize,
    /// What a build needs beside it, where one is due or things have moved.
    site: Option<Site>,
}

/// What the build of a structure reads and works in.
struct Site {
    entries: Vec<vk::AccelerationStructureInstanceKHR>,
    /// Of them on the device.
    input: Buffer,
    scratch: Scratch,
    /// Whether the table of entries is another one than that on the device.
    has_new_table: bool,
}

impl Site {
    fn new(
        device: &Arc<Device>,
        entries: Vec<vk::AccelerationStructureInstanceKHR>,
        has_new_table: bool,
        capacity: usize,
    ) -> Result<Self, TraceError> {
        let usage = vk::BufferUsageFlags::ACCELERATION_STRUCTURE_BUILD_INPUT_READ_ONLY_KHR
            | vk::BufferUsageFlags::SHADER_DEVICE_ADDRESS
            | vk::BufferUsageFlags::TRANSFER_DST;
        let size = (capacity * size_of::<vk::AccelerationStructureInstanceKHR>()) as u64;
        let input = Buffer::new(device, "top level input", size + 16, usage, MemoryLocation::GpuOnly)?;
        let scratch = Scratch::new(device, input_of(0, capacity).sizes(device)?.scratch)?;
        Ok(Self { entries, input, scratch, has_new_table })
    }
}

impl Top {
    /// The structure over a placement, not built yet: what [`Self::writes`] says must be written, and then [`Self::record`] recorded. `parts` are
    /// those of each grid. In the memory of an `earlier` one where that suffices. It is built, not updated: updates keep the boxes of the first build,
    /// however far things have moved.
    pub fn unbuilt(
        device: &Arc<Device>,
        placement: &Placement,
        parts: &[Vec<Part>],
        earlier: Option<Self>,
    ) -> Result<Self, TraceError> {
        let (entries, table) = entries_of(placement.instances(), parts)?;
        let count = entries.len();
        let is_moving = earlier.is_some();
        if let Some(mut top) = earlier.filter(|top| count <= top.capacity && top.capacity <= 2 * SLACK * count.max(1)) {
            let has_new_table = top.table != table;
            let site = match top.site {
                Some(site) => Site { entries, has_new_table, ..site },
                None => Site::new(device, entries, has_new_table, top.capacity)?,
            };
            (top.table, top.site) = (table, Some(site));
            return Ok(top);
        }
        let capacity = if is_moving { count + count / SLACK } else { count };
        let sizes = input_of(0, capacity).sizes(device)?;
        Ok(Self {
            structure: Structure::unbuilt(device, "top level", KIND, sizes)?,
            entries: Buffer::storage(device, "top level entries", (capacity * 2 * size_of::<u32>()) as u64)?,
            table,
            capacity,
            site: Some(Site::new(device, entries, true, capacity)?),
        })
    }

    /// Frees what only builds need: nothing has moved yet, and perhaps never will.
    pub fn settled(self) -> Self {
        Self { site: None, ..self }
    }

    /// What must be on the device before the structure is built.
    pub fn writes(&self) -> Vec<Write<'_>> {
        let Some(site) = &self.site else { return Vec::new() };
        let entries = &site.entries;
        // SAFETY: the records are plain numbers without padding: 48 + 4 + 4 + 8 bytes.
        let bytes = unsafe { std::slice::from_raw_parts(entries.as_ptr().cast::<u8>(), size_of_val(&entries[..])) };
        let mut writes = vec![Write::new(&site.input, 0, bytes)];
        if site.has_new_table {
            writes.push(Write::new(&self.entries, 0, cast_slice(&self.table)));
        }
        writes
    }

    /// Records the build. Nothing that uses the structure may be in flight.
    pub fn record(&self, commands: vk::CommandBuffer) {
        if let Some(site) = &self.site {
            let input = input_of(site.input.address(), site.entries.len());
            self.structure.record_build(commands, &input, &site.scratch, false);
        }
    }

    /// The structure.
    pub fn handle(&self) -> vk::AccelerationStructureKHR {
        self.structure.handle
    }

    /// Bytes of the structure.
    pub fn bytes(&self) -> u64 {
        self.structure.bytes()
    }

    /// Bytes of the table of entries.
    pub fn entry_bytes(&self) -> u64 {
        size_of_val(&self.table[..]) as u64
    }
}

/// The input of a build from `count` entries at an address.
fn input_of(address: vk::DeviceAddress, count: usize) -> Input<'static> {
    let data = vk::AccelerationStructureGeometryInstancesDataKHR::default()
        .data(vk::DeviceOrHostAddressConstKHR { device_address: address });
    let geometry = vk::AccelerationStructureGeometryKHR::default()
        .geometry_type(vk::GeometryTypeKHR::INSTANCES)
        .geometry(vk::AccelerationStructureGeometryDataKHR { instances: data });
    Input::single(KIND, geometry, count as u32)
}

/// The entries of the top level, and for each the packed instance and the word of its first record.
fn entries_of(
    instances: &[PackedInstance],
    parts: &[Vec<Part>],
) -> Result<(Vec<vk::AccelerationStructureInstanceKHR>, Vec<u32>), TraceError> {
    let mut total = 0;
    let first = |instance: &PackedInstance| {
        total += parts[instance.grid as usize].len();
        total - parts[instance.grid as usize].len()
    };
    let first: Vec<usize> = instances.iter().map(first).collect();
    if total >= 1 << ENTRY_BITS {
        return Err(TraceError::Unsupported(format!("{total} instances: hardware numbers at most 2²⁴")));
    }
    let entry = |(instance, (number, part)): (&PackedInstance, (usize, &Part))| vk::AccelerationStructureInstanceKHR {
        transform: matrix(&instance.world_from_grid),
        instance_custom_index_and_mask: vk::Packed24_8::new(number as u32, 0xff),
        instance_shader_binding_table_record_offset_and_flags: vk::Packed24_8::new(0, 0),
        acceleration_structure_reference: vk::AccelerationStructureReferenceKHR { device_handle: part.structure },
    };
    let parts_of = |instance: &PackedInstance| parts[instance.grid as usize].iter();
    let entries = (instances.par_iter().zip(&first))
        .flat_map_iter(|(instance, &first)| {
            (first..).zip(parts_of(instance)).map(move |(number, part)| entry((instance, (number, part))))
        })
        .collect();
    let table = (instances.iter().enumerate())
        .flat_map(|(index, instance)| parts_of(instance).flat_map(move |part| [index as u32, part.first_word]))
        .collect();
    Ok((entries, table))
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
