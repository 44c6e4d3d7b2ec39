//! A packed scene on the device: its arrays as they are, and the cells as devices walk them.

use crate::bindings::Bindings;
use crate::buffer::Buffer;
use crate::commands::Submitter;
use crate::device::Device;
use crate::records::binding;
use crate::transfer::Transfer;
use bytemuck::cast_slice;
use std::sync::Arc;
use voxtrace_core::DeviceCells;
use voxtrace_core::PackedScene;
use voxtrace_core::TraceError;

/// The buffers of a scene.
pub struct SceneBuffers {
    pub scene: Arc<PackedScene>,
    /// The `top_shift` of all grids, 0 where they differ.
    pub top_shift: u32,
    /// The cells of bricks also say which of their blocks hold a voxel.
    pub cells_have_blocks: bool,
    buffers: Vec<(u32, Buffer)>,
}

impl SceneBuffers {
    /// Uploads a scene.
    pub fn new(
        device: &Arc<Device>,
        submitter: &mut Submitter,
        transfer: &mut Transfer,
        scene: &Arc<PackedScene>,
    ) -> Result<Self, TraceError> {
        let DeviceCells { cells, grids, top_shift, have_blocks } = scene.device_cells();
        let arrays: [(u32, &str, &[u8]); 9] = [
            (binding::CELLS, "cells", cast_slice(&cells)),
            (binding::BRICKS, "bricks", cast_slice(scene.bricks())),
            (binding::BRICK_MATERIALS, "voxel materials", cast_slice(scene.brick_materials())),
            (binding::GRIDS, "grids", cast_slice(&grids)),
            (binding::INSTANCES, "instances", cast_slice(scene.instances())),
            (binding::INSTANCE_NODES, "instance nodes", cast_slice(scene.instance_nodes())),
            (binding::MATERIALS, "materials", cast_slice(scene.materials())),
            (binding::EMITTERS, "emitters", cast_slice(scene.emitters())),
            (binding::LIGHT_NODES, "light nodes", cast_slice(scene.light_nodes())),
        ];
        let mut buffers = Vec::with_capacity(arrays.len());
        for (binding, name, bytes) in arrays {
            let buffer = Buffer::storage(device, name, bytes.len() as u64)?;
            transfer.upload(submitter, &buffer, bytes)?;
            buffers.push((binding, buffer));
        }
        Ok(Self { scene: Arc::clone(scene), top_shift, cells_have_blocks: have_blocks, buffers })
    }

    /// Binds all arrays.
    pub fn bind(&self, bindings: &Bindings) {
        for (binding, buffer) in &self.buffers {
            bindings.bind(*binding, buffer);
        }
    }
}
