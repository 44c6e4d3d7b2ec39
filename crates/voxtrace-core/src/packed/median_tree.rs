//! Binary trees over boxes that halve their number at the middle of the widest axis of the centres: the shape of the
//! light tree over instances. Quick enough to be built anew in each frame, and the same on
//! any number of threads.

use glam::Vec3;

/// A node of a tree.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Shape {
    /// A box, by its number.
    Leaf(u32),
    /// The left child follows the node; the right one has this number.
    Inner(u32),
}

/// Boxes from this number on are split on other threads too.
const PARALLEL: usize = 4096;

/// The nodes of a tree over boxes, root first, each subtree whole; empty where there are none.
pub(super) fn median_tree(boxes: &[(Vec3, Vec3)]) -> Vec<Shape> {
    // Twice the centres.
    let centers: Vec<Vec3> = boxes.iter().map(|(low, high)| low + high).collect();
    let mut order: Vec<u32> = (0..boxes.len() as u32).collect();
    let mut nodes = vec![Shape::Leaf(0); (2 * boxes.len()).saturating_sub(1)];
    if !order.is_empty() {
        split(&centers, &mut order, 0, &mut nodes);
    }
    nodes
}

/// Fills `nodes`, the first of which has the number `first`, with the tree over the boxes of `order`.
fn split(centers: &[Vec3], order: &mut [u32], first: u32, nodes: &mut [Shape]) {
    if let [only] = *order {
        nodes[0] = Shape::Leaf(only);
        return;
    }
    let half = halve(centers, order);
    let (left_order, right_order) = order.split_at_mut(half);
    // A tree over n boxes has 2n − 1 nodes.
    let (node, below) = nodes.split_at_mut(1);
    let (left, right) = below.split_at_mut(2 * half - 1);
    let right_at = first + 2 * half as u32;
    node[0] = Shape::Inner(right_at);
    if left_order.len() >= PARALLEL {
        rayon::join(|| split(centers, left_order, first + 1, left), || split(centers, right_order, right_at, right));
    } else {
        split(centers, left_order, first + 1, left);
        split(centers, right_order, right_at, right);
    }
}

/// Puts the half of the boxes with the lower centres along their widest axis first, and says how many they are.
pub(super) fn halve(centers: &[Vec3], order: &mut [u32]) -> usize {
    let (mut low, mut high) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
    for &i in &*order {
        low = low.min(centers[i as usize]);
        high = high.max(centers[i as usize]);
    }
    let axis = (0..3).max_by(|&a, &b| (high - low)[a].total_cmp(&(high - low)[b])).unwrap_or(0);
    let half = order.len() / 2;
    // Only which boxes go where matters, not their order.
    order.select_nth_unstable_by(half, |&a, &b| {
        centers[a as usize][axis].total_cmp(&centers[b as usize][axis]).then(a.cmp(&b))
    });
    half
}
