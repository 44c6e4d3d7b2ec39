//! The hierarchy over instances: a binary tree of boxes.

use super::sah_tree::{Boxes, Shape, centers, half_area};
use super::{InstanceNode, PackedGrid, PackedInstance};
use glam::{IVec3, Vec3};
use rayon::prelude::*;

/// Most inner nodes above a leaf of the hierarchy over instances. Every walk over it, on devices too, has a
/// stack of so many nodes; a file with a deeper one is refused. Halving gives 32 levels to what 32 bits can count; other splits are taken where
/// as many are left.
pub const MAX_INSTANCE_DEPTH: usize = 32;

/// A hierarchy may take so many times the expected work that it took when it was built, before it is built anew.
const MOST_GROWTH: f32 = 1.5;

/// Builds the nodes, root first; the left child follows its parent. Empty where there are no instances.
pub(super) fn hierarchy_of(instances: &[PackedInstance], grids: &[PackedGrid]) -> Vec<InstanceNode> {
    let boxes = boxes_of(instances, grids);
    let node = |shape| match shape {
        Shape::Leaf(index) => InstanceNode { min: Vec3::ZERO, index, max: Vec3::ZERO, is_leaf: 1 },
        Shape::Inner(index) => InstanceNode { min: Vec3::ZERO, index, max: Vec3::ZERO, is_leaf: 0 },
    };
    let (places, weights) = (centers(&boxes), vec![1.0; boxes.len()]);
    // Each box is as probable to be met as its area is large.
    let split = Boxes {
        boxes: &boxes,
        places: &places,
        weights: &weights,
        measure: half_area,
        most_levels: MAX_INSTANCE_DEPTH,
        by_planes: false,
    };
    let mut nodes: Vec<InstanceNode> = split.tree().into_iter().map(node).collect();
    refit(&mut nodes, &boxes);
    nodes
}

/// The nodes of a hierarchy over as many instances, with the boxes of these; `None` where rays would have too much more work with it than
/// when it was built, `cost` by [`cost_of`].
pub(super) fn refitted(
    nodes: &[InstanceNode],
    cost: f32,
    instances: &[PackedInstance],
    grids: &[PackedGrid],
) -> Option<Vec<InstanceNode>> {
    if nodes.len() + 1 != 2 * instances.len() {
        return None;
    }
    let mut nodes = nodes.to_vec();
    refit(&mut nodes, &boxes_of(instances, grids));
    (cost_of(&nodes) <= MOST_GROWTH * cost).then_some(nodes)
}

/// The expected number of nodes that a ray visits which meets the box around all instances, by the areas of their boxes (the surface area
/// heuristic).
pub(super) fn cost_of(nodes: &[InstanceNode]) -> f32 {
    let area = |node: &InstanceNode| {
        let size = node.max - node.min;
        size.x * size.y + size.y * size.z + size.z * size.x
    };
    let Some(root) = nodes.first() else { return 0.0 };
    nodes.iter().map(|node| f64::from(area(node))).sum::<f64>() as f32 / area(root)
}

fn boxes_of(instances: &[PackedInstance], grids: &[PackedGrid]) -> Vec<(Vec3, Vec3)> {
    let of = |instance: &PackedInstance| {
        let grid = &grids[instance.grid as usize];
        world_box(instance, grid.min, grid.max)
    };
    instances.par_iter().with_min_len(1024).map(of).collect()
}

/// Gives each node the box around what is below it.
fn refit(nodes: &mut [InstanceNode], boxes: &[(Vec3, Vec3)]) {
    // Children come after their parents.
    for at in (0..nodes.len()).rev() {
        let index = nodes[at].index as usize;
        (nodes[at].min, nodes[at].max) = match nodes[at].is_leaf {
            0 => {
                let (left, right) = (&nodes[at + 1], &nodes[index]);
                (left.min.min(right.min), left.max.max(right.max))
            }
            _ => boxes[index],
        };
    }
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
