//! The tree over parts of instances as devices walk it: rows of 16 bytes, four children a node, whose sides are counted from the node's lowest corner
//! in the upper halves of floats, rounded outwards. `shaders/instances.slang` says what a walk does there.
//!
//! A node is five rows: its lowest corner and nothing; its children; for each of them its lowest (low half) and highest side (high half) along x; along
//! y; along z. A leaf is one row: instance, grid, the row of the part's bounds or 0 where the part is the whole grid, nothing. Bounds are two rows: the
//! lowest voxel, the one past the highest. The root comes first.

use super::{Plan, WHOLE};
use crate::packed::{InstanceNode, PackedInstance};
use glam::Vec3;

/// Set in a child that is a leaf; the other bits are its row.
pub const DEVICE_LEAF: u32 = 1 << 31;
/// A child that a node does not have.
pub const DEVICE_MISSING: u32 = u32::MAX;
/// Most children that wait while one of them is looked at: every walk has a stack of so many.
pub const MOST_WAITING: usize = 64;

/// Children of a node.
const WIDTH: usize = 4;
/// Rows of a node.
const NODE_ROWS: usize = 5;
/// How much larger boxes are, of the size of their node: sixteen roundings.
const MARGIN: f32 = 8.0 * f32::EPSILON;

/// The rows over a binary tree whose leaves are those of `plan`; one node without children where there are none.
pub(super) fn rows_of(binary: &[InstanceNode], plan: &Plan, instances: &[PackedInstance]) -> Vec<[u32; 4]> {
    let mut rows = Vec::with_capacity(binary.len() * 2 + 16);
    let mut of_parts = vec![0; plan.parts.len()];
    if binary.is_empty() {
        rows.extend([[0; 4], [DEVICE_MISSING; 4], [0; 4], [0; 4], [0; 4]]);
        return rows;
    }
    let mut build = Build { binary, opens_largest: true, rows, nodes: Vec::new() };
    // Two levels of the binary tree a node are never too deep.
    if build.add(0) >= MOST_WAITING {
        build = Build { opens_largest: false, rows: Vec::new(), nodes: Vec::new(), ..build };
        build.add(0);
    }
    let Build { mut rows, nodes, .. } = build;
    for (row, part) in of_parts.iter_mut().zip(&plan.parts) {
        *row = rows.len() as u32;
        let corner = |at: glam::IVec3| [at.x as u32, at.y as u32, at.z as u32, 0];
        rows.extend([corner(part.min), corner(part.max)]);
    }
    // Leaves lie in the order of the nodes that have them.
    for node in nodes {
        for child in 0..WIDTH {
            let word = rows[node + 1][child];
            if word != DEVICE_MISSING && word & DEVICE_LEAF != 0 {
                let leaf = plan.leaves[(word & !DEVICE_LEAF) as usize];
                let bounds = if leaf.part == WHOLE { 0 } else { of_parts[leaf.part as usize] };
                rows[node + 1][child] = rows.len() as u32 | DEVICE_LEAF;
                rows.push([leaf.instance, instances[leaf.instance as usize].grid, bounds, 0]);
            }
        }
    }
    rows
}

struct Build<'a> {
    binary: &'a [InstanceNode],
    /// Whether the child with the largest box is opened first, instead of level by level.
    opens_largest: bool,
    rows: Vec<[u32; 4]>,
    /// First rows of the nodes.
    nodes: Vec<usize>,
}

impl Build<'_> {
    /// Adds the node over a node of the binary tree and all below it, with the leaves' numbers. Returns how many children may wait there.
    fn add(&mut self, root: usize) -> usize {
        let children = self.children_of(root);
        let (mut low, mut high) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
        for &child in &children {
            (low, high) = (low.min(self.binary[child].min), high.max(self.binary[child].max));
        }
        let margin = (high - low).max_element() * MARGIN;
        let base = low - margin;
        let at = self.rows.len();
        self.nodes.push(at);
        self.rows.extend([[0; 4]; NODE_ROWS]);
        self.rows[at] = [base.x.to_bits(), base.y.to_bits(), base.z.to_bits(), 0];
        self.rows[at + 1] = [DEVICE_MISSING; 4];
        for lane in 0..WIDTH {
            for axis in 0..3 {
                self.rows[at + 2 + axis][lane] = match children.get(lane) {
                    Some(&child) => {
                        let (min, max) = (self.binary[child].min[axis] - margin, self.binary[child].max[axis] + margin);
                        u32::from(half_below(min - base[axis])) | u32::from(half_above(max - base[axis])) << 16
                    }
                    None => 0,
                };
            }
        }
        let mut waiting = 0;
        for (lane, &child) in children.iter().enumerate() {
            let node = &self.binary[child];
            self.rows[at + 1][lane] = if node.is_leaf == 1 {
                node.index | DEVICE_LEAF
            } else {
                let below = self.rows.len() as u32;
                waiting = waiting.max(self.add(child));
                below
            };
        }
        // One of them is looked at.
        waiting + children.len() - 1
    }

    /// The nodes of the binary tree that become children of one node.
    fn children_of(&self, root: usize) -> Vec<usize> {
        let inner = |at: usize| self.binary[at].is_leaf == 0;
        let below = |at: usize| [at + 1, self.binary[at].index as usize];
        if !inner(root) {
            return vec![root];
        }
        let mut children = below(root).to_vec();
        if !self.opens_largest {
            let open = |child: usize| if inner(child) { below(child).to_vec() } else { vec![child] };
            return children.into_iter().flat_map(open).collect();
        }
        while children.len() < WIDTH {
            let size = |at: usize| {
                let size = self.binary[at].max - self.binary[at].min;
                size.x * size.y + size.y * size.z + size.z * size.x
            };
            let largest = (0..children.len())
                .filter(|&at| inner(children[at]))
                .max_by(|&a, &b| size(children[a]).total_cmp(&size(children[b])));
            let Some(at) = largest else { break };
            let opened = children.swap_remove(at);
            children.extend(below(opened));
        }
        children
    }
}

/// The upper half of the largest float of that kind that is not above a number, which is not negative but for rounding.
fn half_below(number: f32) -> u16 {
    (number.max(0.0).to_bits() >> 16) as u16
}

/// The upper half of the least float of that kind that is not below a number that is not negative.
fn half_above(number: f32) -> u16 {
    let bits = number.max(0.0).to_bits();
    ((bits >> 16) + u32::from(bits & 0xffff != 0)).min(0x7f7f) as u16
}
