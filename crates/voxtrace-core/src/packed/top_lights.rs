//! The upper light tree: over the instances that emit, in world space. Its leaves are the roots of the grids' trees, taken to
//! world space (Moreau, Pharr and Clarberg, "Dynamic Many-Light Sampling for Real-Time Ray Tracing", HPG 2019, has such
//! two levels).

use super::lights::tree_over;
use super::sah_tree::Shape;
use super::{Geometry, LightNode, PackedInstance};
use glam::Vec3;
use rayon::prelude::*;
use voxtrace_scene::ray::FACES;

/// Builds the nodes, root first, and tells each instance its leaf. Empty where nothing emits.
pub(super) fn top_lights_of(geometry: &Geometry, instances: &mut [PackedInstance]) -> Vec<LightNode> {
    let leaves: Vec<LightNode> = (instances.par_iter().enumerate().with_min_len(1024))
        .filter_map(|(index, instance)| {
            let root = geometry.light_root(instance.grid)?;
            Some(in_world(instance, index as u32, root, &geometry.light_nodes[root as usize]))
        })
        .collect();
    let places: Vec<Vec3> = leaves.iter().map(|leaf| leaf.min + leaf.max).collect();
    let shape = tree_over(&leaves, &places, false);
    let mut nodes = vec![LightNode::EMPTY; shape.len()];
    instances.iter_mut().for_each(|instance| instance.light_leaf = LightNode::NONE);
    // Children come after their parents.
    for (at, shape) in shape.into_iter().enumerate().rev() {
        nodes[at] = match shape {
            Shape::Leaf(which) => {
                let leaf = leaves[which as usize];
                instances[leaf.index as usize].light_leaf = at as u32;
                leaf
            }
            Shape::Inner(right) => {
                (nodes[at + 1].parent, nodes[right as usize].parent) = (at as u32, at as u32);
                LightNode::over(&nodes[at + 1], right, &nodes[right as usize])
            }
        };
    }
    nodes
}

/// The leaf of an instance. A face that looks between the axes counts fully along each of them in turn: the sum is never
/// less than what it sends in any direction.
fn in_world(instance: &PackedInstance, index: u32, root: u32, node: &LightNode) -> LightNode {
    let area = instance.world_from_grid.linear.x_axis.length_squared();
    let mut leaf = LightNode { index, count: 1, root, ..LightNode::EMPTY };
    for corner in 0..8 {
        let pick = |axis: usize| if corner >> axis & 1 == 0 { node.min[axis] } else { node.max[axis] };
        let point = instance.world_from_grid.point(Vec3::new(pick(0), pick(1), pick(2)));
        (leaf.min, leaf.max) = (leaf.min.min(point), leaf.max.max(point));
    }
    for face in FACES {
        let normal = instance.world_normal(face);
        for axis in 0..3 {
            let side = 2 * axis + usize::from(normal[axis] > 0.0);
            leaf.power[side] += normal[axis].abs() * area * node.power[face as usize];
        }
    }
    leaf
}
