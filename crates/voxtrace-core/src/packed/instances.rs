//! The hierarchy over instances: a binary tree of boxes, split at the middle of the widest axis of the centres.

use super::{InstanceNode, PackedGrid, PackedInstance};
use glam::{IVec3, Vec3};

/// Builds the nodes, root first; the left child follows its parent. Empty where there are no instances.
pub(super) fn hierarchy_of(instances: &[PackedInstance], grids: &[PackedGrid]) -> Vec<InstanceNode> {
    let boxes: Vec<(Vec3, Vec3)> = (instances.iter())
        .map(|instance| {
            let grid = &grids[instance.grid as usize];
            world_box(instance, grid.min, grid.max)
        })
        .collect();
    let mut order: Vec<u32> = (0..instances.len() as u32).collect();
    let mut nodes = Vec::with_capacity(2 * instances.len());
    if !order.is_empty() {
        build(&boxes, &mut order, &mut nodes);
    }
    nodes
}

/// The box in world space around a box of voxels, a little larger than exact, so that rounding cannot cut a hit off.
pub fn world_box(instance: &PackedInstance, min: IVec3, max: IVec3) -> (Vec3, Vec3) {
    let (mut low, mut high) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
    for corner in 0..8 {
        let pick = IVec3::new(corner & 1, corner >> 1 & 1, corner >> 2);
        let point = instance.world_from_grid.point((min + (max - min) * pick).as_vec3());
        low = low.min(point);
        high = high.max(point);
    }
    let margin = (low.abs().max(high.abs()).max_element() + instance.world_from_grid.scale()) * 1e-5;
    (low - margin, high + margin)
}

fn build(boxes: &[(Vec3, Vec3)], order: &mut [u32], nodes: &mut Vec<InstanceNode>) {
    let around = |order: &[u32]| {
        order.iter().fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |(min, max), &i| {
            let (low, high) = boxes[i as usize];
            (min.min(low), max.max(high))
        })
    };
    let (min, max) = around(order);
    if let [instance] = *order {
        nodes.push(InstanceNode { min, index: instance, max, is_leaf: 1 });
        return;
    }
    let center = |i: u32| boxes[i as usize].0 + boxes[i as usize].1;
    let (mut low, mut high) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
    for &i in &*order {
        low = low.min(center(i));
        high = high.max(center(i));
    }
    let axis = (0..3).max_by(|&a, &b| (high - low)[a].total_cmp(&(high - low)[b])).unwrap_or(0);
    let half = order.len() / 2;
    order.sort_unstable_by(|&a, &b| center(a)[axis].total_cmp(&center(b)[axis]).then(a.cmp(&b)));
    let node = nodes.len();
    nodes.push(InstanceNode { min, index: 0, max, is_leaf: 0 });
    build(boxes, &mut order[..half], nodes);
    nodes[node].index = nodes.len() as u32;
    build(boxes, &mut order[half..], nodes);
}
