//! The hierarchy over instances as processors walk it: up to sixteen children a node, whose boxes are met together. Made of the binary tree when
//! it is first asked for. Boxes are rounded outwards to 1024 steps of their parent's, as in Ylitie, Karras and Laine, "Efficient Incoherent Ray
//! Traversal on GPUs Through Compressed Wide BVHs" (HPG 2017), so a million instances need 20 MB.

use super::InstanceNode;
use crate::walk::simd::LANES;
use bytemuck::{Pod, Zeroable};
use glam::Vec3;

/// Set in a child that is a leaf of the binary tree; the other bits are then its index there, else that of a wide node.
pub const LEAF: u32 = 1 << 31;

/// Steps of a box along each axis, less one.
const LAST_STEP: u32 = 1023;

/// Farthest places, voxels, that are counted in steps: rays on their way there do not leave the range of f32.
const FARTHEST: f32 = 1e8;

/// Least exponent of a step: products with numbers of steps are exact.
const LEAST_EXPONENT: i32 = -100;

/// Up to sixteen boxes, and what is in them.
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C, align(64))]
pub struct WideNode {
    /// Lowest corners, steps from `base`: ten bits an axis, x lowest.
    pub low: [u32; LANES],
    /// Highest corners, likewise.
    pub high: [u32; LANES],
    /// Wide nodes or, with [`LEAF`], leaves of the binary tree.
    pub children: [u32; LANES],
    /// Lowest corner of all boxes, world space.
    pub base: [f32; 4],
    /// Length of a step along each axis: a power of two.
    pub step: [f32; 4],
    /// How many children there are.
    pub count: u32,
    unused: [u32; 7],
}

/// A tree of wide nodes, root first.
#[derive(Debug)]
pub struct WideTree {
    pub nodes: Vec<WideNode>,
    /// Most children that wait while one of them is looked at.
    pub most_waiting: usize,
}

impl WideTree {
    /// The wide tree of a valid binary one; `None` where that is empty, or where boxes are too large or too small to be counted in steps.
    pub fn new(binary: &[InstanceNode]) -> Option<Self> {
        // Leaves below each node; children come after their parents.
        let mut leaves = vec![1u32; binary.len()];
        for (at, node) in binary.iter().enumerate().rev() {
            if node.is_leaf == 0 {
                leaves[at] = leaves[at + 1] + leaves[node.index as usize];
            }
        }
        let mut build = Build { binary, leaves, nodes: Vec::with_capacity(binary.len() / 12) };
        let below = build.add(0)?;
        Some(Self { nodes: build.nodes, most_waiting: 1 + below })
    }
}

struct Build<'a> {
    binary: &'a [InstanceNode],
    /// Leaves below each node of the binary tree.
    leaves: Vec<u32>,
    nodes: Vec<WideNode>,
}

impl Build<'_> {
    /// Adds the wide node over a node of the binary tree and all below it. Returns how many children may wait there.
    fn add(&mut self, root: usize) -> Option<usize> {
        let children = self.children_of(root)?;
        let boxes = children.iter().map(|&child| &self.binary[child]);
        let place = self.nodes.len();
        self.nodes.push(WideNode::around(boxes)?);
        let mut waiting = 0;
        for (lane, &child) in children.iter().enumerate() {
            self.nodes[place].children[lane] = if self.binary[child].is_leaf == 1 {
                child as u32 | LEAF
            } else {
                let below = self.nodes.len() as u32;
                waiting = waiting.max(self.add(child)?);
                below
            };
        }
        // One of them is looked at.
        Some(waiting + children.len() - 1)
    }

    /// The nodes of the binary tree that become children of one wide node.
    fn children_of(&self, root: usize) -> Option<Vec<usize>> {
        let mut children = vec![root];
        self.binary.get(root)?;
        while children.len() < LANES {
            let free = (LANES - children.len()) as u32;
            // Those that do not fit a node are opened first, the largest box first; of the others those that fit in here whole.
            let rank = |child: usize| {
                let (node, leaves) = (&self.binary[child], self.leaves[child]);
                let is_large = leaves > LANES as u32 || child == root;
                let can_open = node.is_leaf == 0 && (is_large || leaves - 1 <= free);
                can_open.then(|| (is_large, area(node)))
            };
            let ranked = children.iter().enumerate().filter_map(|(at, &child)| Some((at, rank(child)?)));
            let best = ranked.max_by(|(_, a), (_, b)| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
            let Some((at, _)) = best else { break };
            self.open(&mut children, at);
        }
        Some(children)
    }

    /// Puts the children of one of some nodes in its place: all leaves below where they fit a node.
    fn open(&self, children: &mut Vec<usize>, at: usize) {
        let is_whole = (self.leaves[children[at]] as usize) <= LANES + 1 - children.len();
        let mut waiting = vec![children.swap_remove(at)];
        let mut is_first = true;
        while let Some(node) = waiting.pop() {
            if self.binary[node].is_leaf == 1 || !(is_whole || is_first) {
                children.push(node);
            } else {
                waiting.extend([self.binary[node].index as usize, node + 1]);
            }
            is_first = false;
        }
    }
}

/// Half the surface of a box.
fn area(node: &InstanceNode) -> f32 {
    let size = node.max - node.min;
    size.x * size.y + size.y * size.z + size.z * size.x
}

impl WideNode {
    /// A node of some boxes, at most sixteen, without what is in them.
    fn around<'a>(boxes: impl Iterator<Item = &'a InstanceNode> + Clone) -> Option<Self> {
        let (mut low, mut high) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
        for node in boxes.clone() {
            low = low.min(node.min);
            high = high.max(node.max);
        }
        let mut wide = Self { base: low.extend(0.0).to_array(), ..Self::zeroed() };
        for axis in 0..3 {
            wide.step[axis] = step_over(low[axis], high[axis])?;
        }
        for node in boxes {
            let lane = wide.count as usize;
            for axis in 0..3 {
                let (base, step) = (low[axis], wide.step[axis]);
                wide.low[lane] |= step_below(base, step, node.min[axis]) << (10 * axis);
                wide.high[lane] |= step_above(base, step, node.max[axis]) << (10 * axis);
            }
            wide.count += 1;
        }
        Some(wide)
    }
}

/// Where a number of steps leads: what a walk computes of it, too.
fn place(base: f32, step: f32, steps: u32) -> f32 {
    base + steps as f32 * step
}

/// The least power of two, but for one that is too small, that leads from one end to the other in 1023 steps.
fn step_over(low: f32, high: f32) -> Option<f32> {
    let exact = ((high - low) / LAST_STEP as f32).max(f32::MIN_POSITIVE);
    if !(low >= -FARTHEST && high <= FARTHEST) {
        return None;
    }
    let exponent = ((exact.to_bits() >> 23) as i32 - 127).max(LEAST_EXPONENT);
    // The sum is rounded too, so the next one may be needed.
    (exponent..=exponent + 2)
        .map(|exponent| f32::from_bits(((exponent + 127) as u32) << 23))
        .find(|&step| place(low, step, LAST_STEP) >= high)
}

/// The last step that is not above a place.
fn step_below(base: f32, step: f32, place_of: f32) -> u32 {
    let guess = ((place_of - base) / step).floor() as u32;
    let first = (guess + 1).min(LAST_STEP);
    (0..=first).rev().find(|&steps| place(base, step, steps) <= place_of).unwrap_or(0)
}

/// The first step that is not below a place.
fn step_above(base: f32, step: f32, place_of: f32) -> u32 {
    let guess = ((place_of - base) / step).floor() as u32;
    (guess.saturating_sub(1)..LAST_STEP).find(|&steps| place(base, step, steps) >= place_of).unwrap_or(LAST_STEP)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A binary tree over boxes of many sizes, halved anyhow.
    fn binary(count: usize, size: impl Fn(usize) -> Vec3) -> Vec<InstanceNode> {
        fn split(boxes: &[(Vec3, Vec3)], first: usize, nodes: &mut Vec<InstanceNode>) {
            let at = nodes.len();
            if let [(min, max)] = *boxes {
                nodes.push(InstanceNode { min, index: first as u32, max, is_leaf: 1 });
                return;
            }
            nodes.push(InstanceNode { min: Vec3::ZERO, index: 0, max: Vec3::ZERO, is_leaf: 0 });
            let (left, right) = boxes.split_at(boxes.len().div_ceil(3));
            split(left, first, nodes);
            nodes[at].index = nodes.len() as u32;
            split(right, first + left.len(), nodes);
            let (left, right) = (nodes[at + 1], nodes[nodes[at].index as usize]);
            (nodes[at].min, nodes[at].max) = (left.min.min(right.min), left.max.max(right.max));
        }
        let place = |i: usize| Vec3::new((i * 7919 % 1013) as f32 * 0.37 - 100.0, (i * 31 % 97) as f32, i as f32);
        let boxes: Vec<_> = (0..count).map(|i| (place(i), place(i) + size(i))).collect();
        let mut nodes = Vec::new();
        if count > 0 {
            split(&boxes, 0, &mut nodes);
        }
        nodes
    }

    /// The boxes of a wide node as a walk decodes them.
    fn decoded(node: &WideNode, lane: usize) -> (Vec3, Vec3) {
        let corner = |corners: &[u32; LANES]| {
            Vec3::from_array(std::array::from_fn(|axis| {
                place(node.base[axis], node.step[axis], corners[lane] >> (10 * axis) & LAST_STEP)
            }))
        };
        (corner(&node.low), corner(&node.high))
    }

    #[test]
    fn each_leaf_is_in_the_wide_tree_once_and_in_every_box_above_it() {
        let sizes: [fn(usize) -> Vec3; 3] = [
            |_| Vec3::splat(1.0),
            |i| Vec3::new(1e-20, 0.0, (i % 13) as f32 * 40.0),
            |i| Vec3::splat(if i % 50 == 7 { 3.3e6 } else { 0.1 }),
        ];
        for size in sizes {
            for count in [1, 2, 16, 17, 33, 300, 5000] {
                let binary = binary(count, size);
                let tree = WideTree::new(&binary).expect("the boxes are sound");
                let mut found = vec![0; binary.len()];
                // Nodes with the boxes above them, and how many children wait meanwhile.
                let mut open = vec![(0, Vec::new(), 1)];
                while let Some((at, above, waiting)) = open.pop() {
                    let node: &WideNode = &tree.nodes[at];
                    assert!((1..=LANES as u32).contains(&node.count));
                    let waiting = waiting - 1 + node.count as usize;
                    assert!(waiting <= tree.most_waiting, "{waiting} of {}", tree.most_waiting);
                    for lane in 0..node.count as usize {
                        let child = node.children[lane];
                        let mut above = above.clone();
                        above.push(decoded(node, lane));
                        if child & LEAF == 0 {
                            open.push((child as usize, above, waiting));
                            continue;
                        }
                        let leaf = &binary[(child & !LEAF) as usize];
                        assert_eq!(leaf.is_leaf, 1);
                        found[(child & !LEAF) as usize] += 1;
                        for (low, high) in above {
                            assert!(low.cmple(leaf.min).all() && high.cmpge(leaf.max).all(), "{low} {high} {leaf:?}");
                        }
                    }
                }
                assert!(binary.iter().zip(found).all(|(node, found)| found == node.is_leaf), "{count} boxes");
                // Nodes are not left nearly empty.
                assert!(tree.nodes.len() <= 1 + count / 5, "{} nodes over {count} boxes", tree.nodes.len());
            }
        }
    }

    #[test]
    fn boxes_that_cannot_be_counted_in_steps_have_no_wide_tree() {
        assert!(WideTree::new(&[]).is_none());
        assert!(WideTree::new(&binary(20, |_| Vec3::splat(f32::INFINITY))).is_none());
        assert!(WideTree::new(&binary(20, |_| Vec3::splat(1e9))).is_none());
    }

    #[test]
    fn a_box_is_less_than_two_steps_larger_on_each_side() {
        for (low, high) in [(0.0, 1.0), (-3.7e5, 12.0), (0.1, 0.1), (1e6, 1e6 + 0.5)] {
            let step = step_over(low, high).expect("the box is sound");
            assert!(place(low, step, LAST_STEP) >= high && step <= 4.0 * ((high - low) / 1023.0).max(2e-30));
            for part in 0..=20 {
                let at: f32 = low + (high - low) * (part as f32 / 20.0);
                let (below, above) = (step_below(low, step, at), step_above(low, step, at));
                assert!(place(low, step, below) <= at && at <= place(low, step, above));
                assert!(above - below <= 3 || high - low < 2.0 * low.abs() * f32::EPSILON * 1024.0, "{at}");
            }
        }
    }
}
