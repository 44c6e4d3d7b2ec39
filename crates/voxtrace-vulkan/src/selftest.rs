//! Runs the functions that shaders share with the library on a device, for tests that compare their results: the entry
//! points of `shaders/pass/selftest.slang`.

use crate::bindings::Bindings;
use crate::buffer::Buffer;
use crate::commands::{Job, Submitter};
use crate::device::Device;
use crate::method::Primitive;
use crate::passes::Passes;
use crate::records::{Dispatch, FrameParams, LENS_PINHOLE, binding};
use crate::scene::SceneBuffers;
use crate::spirv;
use crate::transfer::Transfer;
use crate::variant::{Entry, Variant};
use ash::vk;
use bytemuck::{bytes_of, cast_slice, cast_slice_mut};
use gpu_allocator::MemoryLocation;
use std::sync::Arc;
use voxtrace_core::PackedScene;
use voxtrace_core::TraceError;

/// Runs `entry` on `count` cases, whose words are `inputs`, and returns the `output_words` words that all of them give.
///
/// # Errors
/// What the driver answers; [`TraceError::Unsupported`] where there is no such entry point.
pub fn run(
    device: &Arc<Device>,
    scene: &Arc<PackedScene>,
    entry: &'static str,
    inputs: &[u32],
    count: u32,
    output_words: usize,
) -> Result<Vec<u32>, TraceError> {
    let (mut submitter, mut transfer) = (Submitter::new(device)?, Transfer::new(device));
    let bindings = Bindings::new(device)?;
    bindings.bind_submitter(&submitter);
    let scene = SceneBuffers::new(device, &mut submitter, &mut transfer, scene, None)?;
    scene.bind(&bindings);
    let params = FrameParams::of_scene(&scene.scene);
    let usage = vk::BufferUsageFlags::UNIFORM_BUFFER;
    let size = size_of::<FrameParams>() as u64;
    let mut frame = Buffer::new(device, "frame parameters", size, usage, MemoryLocation::CpuToGpu)?;
    frame.mapped_mut()[..size_of::<FrameParams>()].copy_from_slice(bytes_of(&params));
    bindings.bind(binding::FRAME, &frame);
    let mut outputs = vec![0u32; output_words];
    let given = Buffer::storage(device, "inputs", size_of_val(inputs) as u64)?;
    let made = Buffer::storage(device, "outputs", size_of_val(&outputs[..]) as u64)?;
    transfer.upload(&mut submitter, &given, cast_slice(inputs))?;
    bindings.bind(binding::RAYS, &given);
    bindings.bind(binding::HITS, &made);
    // No scene of it lies in pages.
    bindings.bind(binding::PAGES, &given);

    let mut passes = Passes::new(device, &bindings, spirv::SELFTEST);
    let entry = Entry::SelfTest(entry);
    let variant = Variant {
        entry,
        is_exact: true,
        is_single: false,
        top_shift: scene.top_shift,
        lens: LENS_PINHOLE,
        has_materials: false,
        has_cuts: false,
        has_catcher: false,
        has_lines: false,
        has_normals: false,
        cells_skip: false,
        has_pages: false,
        sky: params.sky,
        cells_have_blocks: scene.cells_have_blocks,
        primitive: Primitive::default(),
    };
    passes.prepare(variant)?;
    let record = |commands, offset| passes.launch(variant, &bindings, commands, offset, count);
    let dispatch = Dispatch { count, ..Dispatch::default() };
    let workgroups = Some(passes.proof(variant, count));
    let job = Job { step: "self-test", work: 0, dispatch, workgroups, record: &record, then: None };
    submitter.run(&job)?;
    transfer.download(&mut submitter, &made, 0, cast_slice_mut(&mut outputs))?;
    Ok(outputs)
}
