//! The hierarchy over instances: a binary tree of boxes.

use super::median_tree::{Shape, median_tree};
use super::{InstanceNode, PackedGrid, PackedInstance};
use glam::{IVec3, Vec3};

/// Most inner nodes above a leaf of the hierarchy over instances. Every walk over it, on devices too, has a
/// stack of so many nodes; a file with a deeper one is refused. Halving gives 32 levels to what 32 bits can count.
pub const MAX_INSTANCE_DEPTH: usize = 32;

/// Builds the nodes, root first; the left child follows its parent. Empty where there are no instances.
pub(super) fn hierarchy_of(instances: &[PackedInstance], grids: &[PackedGrid]) -> Vec<InstanceNode> {
    let boxes: Vec<(Vec3, Vec3)> = (instances.iter())
        .map(|instance| {
            let grid = &grids[instance.grid as usize];
            world_box(instance, grid.min, grid.max)
        })
        .collect();
    let shape = median_tree(&boxes);
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::packed::{PackError, PackedScene};
    use voxtrace_scene::grid::VoxelGrid;
    use voxtrace_scene::material::Material;
    use voxtrace_scene::scene::{Instance, Scene};
    use voxtrace_scene::transform::Transform;

    /// Instances of one voxel, at places by their numbers.
    fn packed(count: usize, place: impl Fn(usize) -> Vec3) -> Result<PackedScene, PackError> {
        let mut grid = VoxelGrid::new();
        grid.set(IVec3::ZERO, 0);
        let mut scene = Scene::from_grid("many", grid, vec![Material::default()]);
        scene.instances = (0..count).map(|i| Instance::new(0, Transform::from_translation(place(i)))).collect();
        PackedScene::pack(&scene)
    }

    /// Most inner nodes above a leaf.
    fn depth(nodes: &[InstanceNode], at: usize) -> usize {
        match nodes[at].is_leaf {
            1 => 0,
            _ => 1 + depth(nodes, at + 1).max(depth(nodes, nodes[at].index as usize)),
        }
    }

    #[test]
    fn halving_keeps_any_number_of_instances_far_below_the_deepest_hierarchy() {
        let places: [fn(usize) -> Vec3; 4] = [
            |_| Vec3::ZERO,
            |i| Vec3::X * i as f32,
            // Each twice as far away as the one before, over and over: what other ways to split make chains of.
            |i| Vec3::Y * (i as f32 % 100.0).exp2(),
            |i| Vec3::new((i * 7919 % 1013) as f32, (i * 104_729 % 997) as f32, (i % 31) as f32),
        ];
        for place in places {
            for (count, expected) in [(1, 0), (2, 1), (3, 2), (33, 6), (65_535, 16), (65_536, 16), (65_537, 17)] {
                let packed = packed(count, place).unwrap();
                assert_eq!(depth(&packed.placement.instance_nodes, 0), expected, "{count} instances");
                packed.validate().unwrap();
            }
        }
        // As many as 32 bits can count.
        assert!((u64::from(u32::MAX)).next_power_of_two().ilog2() as usize <= MAX_INSTANCE_DEPTH);
    }
}
