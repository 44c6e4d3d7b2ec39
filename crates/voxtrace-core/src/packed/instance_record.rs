//! Instances as native files have them, the section `INST`.

use super::{PackedInstance, Placement};
use bytemuck::{Pod, Zeroable};
use voxtrace_scene::transform::Transform;

/// An instance as the file has it: what the light tree over instances adds is not saved, and no part of the content.
#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C)]
pub(super) struct InstanceRecord {
    grid_from_world: Transform,
    world_from_grid: Transform,
    grid: u32,
    scene_instance: u32,
}

impl InstanceRecord {
    pub(super) fn all_of(placement: &Placement) -> Vec<Self> {
        let record = |instance: &PackedInstance| {
            let PackedInstance { grid_from_world, world_from_grid, grid, scene_instance, .. } = *instance;
            Self { grid_from_world, world_from_grid, grid, scene_instance }
        };
        placement.instances.iter().map(record).collect()
    }

    pub(super) fn instance(&self) -> PackedInstance {
        let Self { grid_from_world, world_from_grid, grid, scene_instance } = *self;
        PackedInstance { grid_from_world, ..PackedInstance::new(grid, world_from_grid, scene_instance) }
    }
}
