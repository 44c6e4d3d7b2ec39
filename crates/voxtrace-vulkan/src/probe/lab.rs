//! Where probes are made: builds acceleration structures of boxes, casts rays at them through each traversal, and brings back
//! what every ray met. Can be told to build what is not asked for, to show that the probes notice.

use super::boxes::Aabb;
use super::model::{Bottom, BuildFlags, Model, Placed, Treatment};
use super::plant::Plant;
use super::shot::{Answers, Reports, Shot};
use crate::accel::structure::{Input, Structure};
use crate::bindings::Bindings;
use crate::buffer::Buffer;
use crate::commands::{Job, Submitter};
use crate::device::Device;
use crate::method::{Primitive, Traversal};
use crate::passes::Passes;
use crate::records::{Dispatch, ProbeAnswer, ProbeRay, binding};
use crate::spirv;
use crate::transfer::Transfer;
use crate::variant::{Entry, Variant};
use ash::vk;
use bytemuck::{cast_slice, cast_slice_mut};
use gpu_allocator::MemoryLocation;
use std::sync::Arc;
use voxtrace_core::TraceError;

const NAME: &str = "probe";

/// A model on the device.
pub struct Built {
    // Dropped before what it refers to.
    top: Structure,
    _bottoms: Vec<Structure>,
    records: Buffer,
}

/// One device, ready for probes.
pub struct Lab {
    // Dropped first: waits for everything.
    submitter: Submitter,
    transfer: Transfer,
    passes: Vec<(Traversal, Passes)>,
    bindings: Bindings,
    device: Arc<Device>,
    plant: Option<Plant>,
}

const VARIANT: Variant = Variant {
    entry: Entry::Cast,
    is_exact: true,
    is_single: false,
    top_shift: 0,
    cells_have_blocks: false,
    primitive: Primitive::VoxelExact,
    lens: 0,
    has_materials: false,
    has_cuts: false,
    has_catcher: false,
    has_lines: false,
    has_normals: false,
    cells_skip: false,
    has_pages: false,
    sky: 0,
};

impl Lab {
    /// Compiles the shaders of each traversal that the device has.
    pub fn new(device: &Arc<Device>, plant: Option<Plant>) -> Result<Self, TraceError> {
        let submitter = Submitter::new(device)?;
        let bindings = Bindings::new(device)?;
        bindings.bind_submitter(&submitter);
        let info = device.info();
        let all = [
            (Traversal::Pipeline, &info.pipeline_missing, spirv::PROBE_PIPELINE),
            (Traversal::Query, &info.query_missing, spirv::PROBE_QUERY),
        ];
        let mut passes = Vec::new();
        for (traversal, missing, module) in all {
            if missing.is_none() {
                let mut of_traversal = Passes::new(device, &bindings, module);
                of_traversal.prepare(VARIANT)?;
                passes.push((traversal, of_traversal));
            }
        }
        Ok(Self { submitter, transfer: Transfer::new(device), passes, bindings, device: Arc::clone(device), plant })
    }

    /// The traversals that can be probed.
    pub fn traversals(&self) -> Vec<Traversal> {
        self.passes.iter().map(|(traversal, _)| *traversal).collect()
    }

    pub fn device(&self) -> &Device {
        &self.device
    }

    pub fn plant(&self) -> Option<Plant> {
        self.plant
    }

    /// Builds a model; the records say what was asked for, also where the plant builds something else.
    pub fn build(&mut self, model: &Model) -> Result<Built, TraceError> {
        let (mut firsts, mut table, mut words) = (Vec::new(), Vec::new(), Vec::<f32>::new());
        let entries: usize = model.bottoms.iter().map(|bottom| bottom.geometries.len()).sum();
        for bottom in &model.bottoms {
            firsts.push(table.len() as u32);
            for geometry in &bottom.geometries {
                table.push((entries + words.len()) as u32);
                words.extend_from_slice(cast_slice(geometry));
            }
        }
        let bytes = [cast_slice::<u32, u8>(&table), cast_slice(&words)].concat();
        let records = Buffer::new(
            &self.device,
            NAME,
            bytes.len() as u64,
            vk::BufferUsageFlags::STORAGE_BUFFER | vk::BufferUsageFlags::TRANSFER_DST,
            MemoryLocation::GpuOnly,
        )?;
        if !bytes.is_empty() {
            self.transfer.upload(&mut self.submitter, &records, &bytes)?;
        }
        let mut bottoms = Vec::new();
        for bottom in &model.bottoms {
            bottoms.push(self.build_bottom(bottom)?);
        }
        let addresses = bottoms.iter().map(Structure::address).collect::<Result<Vec<_>, _>>()?;
        let top = self.build_top(&model.instances, &firsts, &addresses)?;
        Ok(Built { top, _bottoms: bottoms, records })
    }

    fn build_bottom(&mut self, bottom: &Bottom) -> Result<Structure, TraceError> {
        let wanted: Vec<Vec<Aabb>> = match self.plant {
            Some(plant) => bottom.geometries.iter().map(|boxes| plant.boxes(boxes)).collect(),
            None => bottom.geometries.clone(),
        };
        let first = match &bottom.treatment {
            Treatment::UpdatedFrom(other) => other,
            _ => &wanted,
        };
        let kind = vk::AccelerationStructureTypeKHR::BOTTOM_LEVEL;
        let (input, buffers) = self.input(first, bottom.flags)?;
        let structure = Structure::build(&self.device, &mut self.submitter, NAME, &input)?;
        drop(buffers);
        match &bottom.treatment {
            Treatment::Built => Ok(structure),
            Treatment::Compacted => structure.compacted(&mut self.submitter, NAME, kind),
            Treatment::UpdatedFrom(_) => {
                let (input, _buffers) = self.input(&wanted, bottom.flags)?;
                structure.update(&mut self.submitter, &input)?;
                Ok(structure)
            }
        }
    }

    /// The input of a build and the memory behind it.
    fn input(&self, geometries: &[Vec<Aabb>], flags: BuildFlags) -> Result<(Input<'static>, Vec<Buffer>), TraceError> {
        let mut buffers = Vec::new();
        for boxes in geometries {
            buffers.push(self.given(cast_slice(boxes))?);
        }
        let geometry = |buffer: &Buffer| {
            let data = vk::DeviceOrHostAddressConstKHR { device_address: buffer.address() };
            let boxes = vk::AccelerationStructureGeometryAabbsDataKHR::default().data(data).stride(24);
            vk::AccelerationStructureGeometryKHR::default()
                .geometry_type(vk::GeometryTypeKHR::AABBS)
                .geometry(vk::AccelerationStructureGeometryDataKHR { aabbs: boxes })
        };
        let input = Input {
            kind: vk::AccelerationStructureTypeKHR::BOTTOM_LEVEL,
            flags,
            geometries: buffers.iter().map(geometry).collect(),
            counts: geometries.iter().map(|boxes| boxes.len() as u32).collect(),
        };
        Ok((input, buffers))
    }

    /// A buffer that builds read.
    fn given(&self, bytes: &[u8]) -> Result<Buffer, TraceError> {
        let usage = vk::BufferUsageFlags::ACCELERATION_STRUCTURE_BUILD_INPUT_READ_ONLY_KHR
            | vk::BufferUsageFlags::SHADER_DEVICE_ADDRESS;
        let size = bytes.len() as u64 + 16;
        let mut buffer = Buffer::new(&self.device, NAME, size, usage, MemoryLocation::CpuToGpu)?;
        buffer.mapped_mut()[..bytes.len()].copy_from_slice(bytes);
        Ok(buffer)
    }

    fn build_top(&mut self, instances: &[Placed], firsts: &[u32], addresses: &[u64]) -> Result<Structure, TraceError> {
        let records: Vec<_> = instances
            .iter()
            .map(|placed| {
                let matrix = self.plant.map_or(placed.transform, |plant| plant.transform(placed.transform));
                vk::AccelerationStructureInstanceKHR {
                    transform: vk::TransformMatrixKHR { matrix },
                    instance_custom_index_and_mask: vk::Packed24_8::new(firsts[placed.bottom], placed.mask),
                    instance_shader_binding_table_record_offset_and_flags: vk::Packed24_8::new(0, 0),
                    acceleration_structure_reference: vk::AccelerationStructureReferenceKHR {
                        device_handle: addresses[placed.bottom],
                    },
                }
            })
            .collect();
        // SAFETY: the records are plain numbers without padding: 48 + 4 + 4 + 8 bytes.
        let bytes =
            unsafe { std::slice::from_raw_parts(records.as_ptr().cast::<u8>(), size_of_val(records.as_slice())) };
        let buffer = self.given(bytes)?;
        let data = vk::AccelerationStructureGeometryInstancesDataKHR::default()
            .data(vk::DeviceOrHostAddressConstKHR { device_address: buffer.address() });
        let geometry = vk::AccelerationStructureGeometryKHR::default()
            .geometry_type(vk::GeometryTypeKHR::INSTANCES)
            .geometry(vk::AccelerationStructureGeometryDataKHR { instances: data });
        let input = Input::single(vk::AccelerationStructureTypeKHR::TOP_LEVEL, geometry, records.len() as u32);
        Structure::build(&self.device, &mut self.submitter, NAME, &input)
    }

    /// Casts rays, with room for the numbers of `capacity` candidates each.
    pub fn cast(
        &mut self,
        built: &Built,
        traversal: Traversal,
        rays: &[ProbeRay],
        reports: Reports,
        capacity: usize,
    ) -> Result<Answers, TraceError> {
        let shot = self.load(built, rays, reports, capacity)?;
        self.fire(&shot, traversal, 1)?;
        self.look(shot)
    }

    /// Brings rays to the device. What was loaded before can no longer be fired.
    pub fn load(
        &mut self,
        built: &Built,
        rays: &[ProbeRay],
        reports: Reports,
        capacity: usize,
    ) -> Result<Shot, TraceError> {
        let given: Vec<ProbeRay> = (0u32..)
            .zip(rays)
            .map(|(index, ray)| ProbeRay {
                report: reports as u32,
                log_first: index * capacity as u32,
                log_capacity: capacity as u32,
                ..*ray
            })
            .collect();
        let device = &self.device;
        let usage = vk::BufferUsageFlags::STORAGE_BUFFER;
        let size = size_of_val(given.as_slice());
        let mut ray_buffer = Buffer::new(device, NAME, size as u64, usage, MemoryLocation::CpuToGpu)?;
        ray_buffer.mapped_mut()[..size].copy_from_slice(cast_slice(&given));
        let answers = Buffer::storage(device, NAME, (rays.len() * size_of::<ProbeAnswer>()) as u64)?;
        let log = Buffer::storage(device, NAME, (rays.len() * capacity * 4) as u64)?;
        self.bindings.bind(binding::RAYS, &ray_buffer);
        self.bindings.bind(binding::HITS, &answers);
        self.bindings.bind(binding::PIXELS, &log);
        self.bindings.bind(binding::PRIMITIVES, &built.records);
        self.bindings.bind_top_level(built.top.handle);
        Ok(Shot { _rays: ray_buffer, answers, log, count: rays.len(), capacity })
    }

    /// Casts what was loaded, `times` times in one submit; returns the device's milliseconds.
    pub fn fire(&mut self, shot: &Shot, traversal: Traversal, times: u32) -> Result<f64, TraceError> {
        let Some((_, passes)) = self.passes.iter().find(|(other, _)| *other == traversal) else {
            return Err(TraceError::Unsupported(format!("no traversal {}", traversal.name())));
        };
        let bindings = &self.bindings;
        let (mut first, mut gpu_ms) = (0, 0.0);
        while first < shot.count {
            let count = (shot.count - first).min(passes.most_items() as usize) as u32;
            let record = |commands, offset| {
                for _ in 0..times {
                    passes.launch(VARIANT, bindings, commands, offset, count);
                }
            };
            let dispatch = Dispatch { first: first as u32, count, ..Dispatch::default() };
            let workgroups = Some(passes.proof(VARIANT, count).wrapping_mul(times));
            let job = Job { step: "probing", work: 0, dispatch, workgroups, record: &record, then: None };
            gpu_ms += self.submitter.run(&job)?.gpu_ms;
            first += count as usize;
        }
        Ok(gpu_ms)
    }

    /// Brings back what the rays met.
    pub fn look(&mut self, shot: Shot) -> Result<Answers, TraceError> {
        // Nonsense, so that an answer that nobody wrote is noticed.
        let nonsense = ProbeAnswer { is_hit: 77, ..ProbeAnswer::default() };
        let capacity = shot.capacity;
        let mut answers =
            Answers { answers: vec![nonsense; shot.count], log: vec![u32::MAX; shot.count * capacity], capacity };
        self.transfer.download(&mut self.submitter, &shot.answers, 0, cast_slice_mut(&mut answers.answers))?;
        if capacity > 0 {
            self.transfer.download(&mut self.submitter, &shot.log, 0, cast_slice_mut(&mut answers.log))?;
        }
        if self.plant == Some(Plant::LastAttribute) {
            for index in 0..shot.count {
                if let Some(&last) = answers.candidates(index).last() {
                    answers.answers[index].attribute = last;
                }
            }
        }
        Ok(answers)
    }
}
