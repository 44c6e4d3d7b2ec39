//! The hierarchy over instances: a binary tree of boxes.

use super::median_tree::Shape;
use super::sah_tree::sah_tree;
use super::{InstanceNode, PackedGrid, PackedInstance};
use glam::{IVec3, Vec3};

/// Most inner nodes above a leaf of the hierarchy over instances. Every walk over it, on devices too, has a
/// stack of so many nodes; a file with a deeper one is refused. Halving gives 32 levels to what 32 bits can count; other splits are taken where
/// as many are left.
pub const MAX_INSTANCE_DEPTH: usize = 32;

/// Builds the nodes, root first; the left child follows its parent. Empty where there are no instances.
pub(super) fn hierarchy_of(instances: &[PackedInstance], grids: &[PackedGrid]) -> Vec<InstanceNode> {
    let boxes: Vec<(Vec3, Vec3)> = (instances.iter())
        .map(|instance| {
            let grid = &grids[instance.grid as usize];
            world_box(instance, grid.min, grid.max)
        })
        .collect();
    let shape = sah_tree(&boxes);
    let mut nodes = vec![InstanceNode { min: Vec3::ZERO, index: 0, max: Vec3::ZERO, is_leaf: 0 }; shape.len()];
    // Children come after their parents.
    for (at, shape) in shape.into_iter().enumerate().rev() {
        nodes[at] = match shape {
            Shape::Leaf(index) => {
                let (min, max) = boxes[index as usize];
                InstanceNode { min, index, max, is_leaf: 1 }
            }
            Shape::Inner(index) => {
                let (left, right) = (nodes[at + 1], nodes[index as usize]);
                InstanceNode { min: left.min.min(right.min), index, max: left.max.max(right.max), is_leaf: 0 }
            }
        };
    }
    nodes
}

/// The box in world space around a box of voxels, a little larger than exact, so that rounding cannot cut a hit off.
pub fn world_box(instance: &PackedInstance, min: IVec3, max: IVec3) -> (Vec3, Vec3) {
    let (low, high) = corners_of(instance, min, max);
    let margin = (low.abs().max(high.abs()).max_element() + instance.world_from_grid.scale()) * 1e-5;
    (low - margin, high + margin)
}

/// The box in world space around the corners of a box of voxels.
pub(super) fn corners_of(instance: &PackedInstance, min: IVec3, max: IVec3) -> (Vec3, Vec3) {
    let (mut low, mut high) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
    for corner in 0..8 {
        let pick = IVec3::new(corner & 1, corner >> 1 & 1, corner >> 2);
        let point = instance.world_from_grid.point((min + (max - min) * pick).as_vec3());
        low = low.min(point);
        high = high.max(point);
    }
    (low, high)
}
