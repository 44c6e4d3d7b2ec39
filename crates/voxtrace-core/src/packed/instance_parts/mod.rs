//! Instances as walks look for them: each in parts, whose boxes in the world are those around their voxels, however the instance is turned. A large
//! grid, the ground say, is many parts, so that rays walk through what they come near. Made of the bricks when a tracer first asks for it; files
//! have the binary tree over whole instances.
//!
//! Which parts there are changes no hit: a part's box holds all of its voxels with the margin that [`super::instances::world_box`] has, and of hits at
//! the same t in one instance the first on the ray's path counts.

mod device;
mod hull;
mod split;

pub use device::{DEVICE_LEAF, DEVICE_MISSING, MOST_WAITING};

use super::median_tree::Shape;
use super::sah_tree::sah_tree;
use super::wide_tree::{LEAF, WideTree};
use super::{Geometry, InstanceNode, PackedInstance, Placement};
use glam::{IVec3, Vec3};
use rayon::prelude::*;
use split::{Part, parts_of};
use std::sync::{Arc, OnceLock};
use voxtrace_scene::transform::Transform;

/// A part that is the whole grid, which says itself where it ends.
pub const WHOLE: u32 = u32::MAX;

/// A part of an instance.
#[derive(Clone, Copy, Debug)]
pub struct InstancePart {
    pub instance: u32,
    /// Index of the part, or [`WHOLE`].
    pub part: u32,
}

/// The parts of a placement's instances, and the trees over them.
#[derive(Debug)]
pub struct InstanceParts {
    planned: Planned,
    wide: OnceLock<Option<WideTree>>,
    device: OnceLock<Vec<[u32; 4]>>,
}

/// What stays as things move, and of what geometry it is.
#[derive(Clone, Debug)]
pub(super) struct Planned {
    state: GeometryState,
    plan: Arc<Plan>,
}

#[derive(Debug)]
struct Plan {
    parts: Vec<Part>,
    /// Leaves of the trees.
    leaves: Vec<InstancePart>,
    /// The tree over the leaves; that over the instances where nothing is in parts.
    shape: Option<Vec<Shape>>,
}

/// Where the arrays of a geometry lie: two with the same fingerprint may have other voxels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct GeometryState {
    cells: (usize, usize),
    bricks: (usize, usize),
    is_edited: bool,
}

impl GeometryState {
    fn of(geometry: &Geometry) -> Self {
        let place = |array: &[u32]| (array.as_ptr() as usize, array.len());
        Self { cells: place(&geometry.cells), bricks: place(&geometry.bricks), is_edited: geometry.is_edited }
    }
}

impl Plan {
    /// That of so many instances which are not in parts.
    fn whole(count: usize) -> Self {
        let leaf = |instance| InstancePart { instance, part: WHOLE };
        Self { parts: Vec::new(), leaves: (0..count as u32).map(leaf).collect(), shape: None }
    }

    fn new(geometry: &Geometry, instances: &[PackedInstance]) -> Self {
        let is_alone = matches!(instances, [only] if only.grid_from_world == Transform::IDENTITY);
        if geometry.is_edited || is_alone {
            return Self::whole(instances.len());
        }
        let (parts, of_grids) = parts_of(geometry, instances);
        let leaves: Vec<InstancePart> = (instances.iter().zip(0..))
            .flat_map(|(placed, instance)| {
                of_grids[placed.grid as usize].clone().map(move |part| InstancePart { instance, part })
            })
            .collect();
        let shape = sah_tree(&boxes_of(&parts, &leaves, instances));
        Self { parts, leaves, shape: Some(shape) }
    }

    /// The binary tree over the leaves, as [`InstanceNode`]s whose leaves are indices of ours.
    fn nodes(&self, placement: &Placement) -> Vec<InstanceNode> {
        let Some(shape) = &self.shape else { return placement.instance_nodes.to_vec() };
        let boxes = boxes_of(&self.parts, &self.leaves, &placement.instances);
        let node = |index, is_leaf| InstanceNode { min: Vec3::ZERO, index, max: Vec3::ZERO, is_leaf };
        let mut nodes: Vec<InstanceNode> = (shape.iter())
            .map(|shape| match *shape {
                Shape::Leaf(index) => node(index, 1),
                Shape::Inner(index) => node(index, 0),
            })
            .collect();
        super::instances::refit(&mut nodes, &boxes);
        nodes
    }
}

/// The boxes of leaves in the world.
fn boxes_of(parts: &[Part], leaves: &[InstancePart], instances: &[PackedInstance]) -> Vec<(Vec3, Vec3)> {
    let of = |leaf: &InstancePart| parts[leaf.part as usize].hull.world_box(&instances[leaf.instance as usize]);
    leaves.par_iter().with_min_len(256).map(of).collect()
}

impl InstanceParts {
    /// Those of a placement's instances; with the tree of `earlier`, where it was made for the same instances elsewhere.
    pub(super) fn new(geometry: &Geometry, instances: &[PackedInstance], earlier: Option<&Planned>) -> Self {
        let state = GeometryState::of(geometry);
        let planned = match earlier.filter(|earlier| earlier.state == state) {
            Some(earlier) => earlier.clone(),
            None => Planned { state, plan: Arc::new(Plan::new(geometry, instances)) },
        };
        Self { planned, wide: OnceLock::new(), device: OnceLock::new() }
    }

    /// A placement's instances as they are, not in parts: what stays right whatever is edited within the bounds of grids.
    pub fn whole(placement: &Placement) -> Self {
        let state = GeometryState { cells: (0, 0), bricks: (0, 0), is_edited: true };
        let plan = Arc::new(Plan::whole(placement.instances.len()));
        Self { planned: Planned { state, plan }, wide: OnceLock::new(), device: OnceLock::new() }
    }

    /// What stays as things move.
    pub(super) fn planned(&self) -> Planned {
        self.planned.clone()
    }

    /// Whether they are those of a geometry.
    pub(super) fn are_of(&self, geometry: &Geometry) -> bool {
        self.planned.state == GeometryState::of(geometry)
    }

    /// The leaves of the trees.
    pub fn leaves(&self) -> &[InstancePart] {
        &self.planned.plan.leaves
    }

    /// The lowest voxel of a part, and the one past the highest; `None` where it is the whole grid.
    #[inline]
    pub fn bounds(&self, part: u32) -> Option<(IVec3, IVec3)> {
        self.planned.plan.parts.get(part as usize).map(|part| (part.min, part.max))
    }

    /// The tree over the leaves as processors walk it, whose leaves are indices of ours; `None` where the binary tree has to do.
    pub fn wide_tree(&self, placement: &Placement) -> Option<&WideTree> {
        let make = || {
            let binary = self.planned.plan.nodes(placement);
            let mut tree = WideTree::new(&binary)?;
            let children = tree.nodes.iter_mut().flat_map(|node| &mut node.children[..node.count as usize]);
            for child in children.filter(|child| **child & LEAF != 0) {
                *child = binary[(*child & !LEAF) as usize].index | LEAF;
            }
            Some(tree)
        };
        self.wide.get_or_init(make).as_ref()
    }

    /// The tree as devices walk it: see [`device`].
    pub fn device_rows(&self, placement: &Placement) -> &[[u32; 4]] {
        self.device.get_or_init(|| device::rows_of(&self.planned.plan.nodes(placement), &self.planned.plan, &placement.instances))
    }
}
