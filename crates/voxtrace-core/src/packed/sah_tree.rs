//! Binary trees over boxes whose splits make the expected work of a ray least, by the surface area heuristic over bins (Wald, "On fast
//! Construction of SAH-based Bounding Volume Hierarchies", RT 2007): the shape of the hierarchy over instances. The same on any number of threads.

use super::instances::MAX_INSTANCE_DEPTH;
use super::median_tree::{Shape, halve};
use glam::Vec3;

/// Bins that centres are counted in along an axis.
const BINS: usize = 16;
/// Boxes from this number on are split on other threads too.
const PARALLEL: usize = 4096;

/// The nodes of a tree over boxes, root first, each subtree whole, at most [`MAX_INSTANCE_DEPTH`] inner nodes above a leaf; empty where there are no
/// boxes.
pub(super) fn sah_tree(boxes: &[(Vec3, Vec3)]) -> Vec<Shape> {
    let mut order: Vec<u32> = (0..boxes.len() as u32).collect();
    let mut nodes = vec![Shape::Leaf(0); (2 * boxes.len()).saturating_sub(1)];
    if !order.is_empty() {
        let centers: Vec<Vec3> = boxes.iter().map(|(low, high)| low + high).collect();
        Build { boxes, centers: &centers }.split(&mut order, MAX_INSTANCE_DEPTH, 0, &mut nodes);
    }
    nodes
}

/// What is built over.
struct Build<'a> {
    boxes: &'a [(Vec3, Vec3)],
    /// Twice the centres.
    centers: &'a [Vec3],
}

/// Boxes together.
#[derive(Clone, Copy)]
struct Bin {
    low: Vec3,
    high: Vec3,
    count: u32,
}

impl Bin {
    const EMPTY: Self = Self { low: Vec3::INFINITY, high: Vec3::NEG_INFINITY, count: 0 };

    fn with(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high), count: self.count + other.count }
    }

    /// The number of boxes, each as probable to be met as the area of all of them is large.
    fn cost(self) -> f32 {
        let size = self.high - self.low;
        match self.count {
            0 => 0.0,
            count => (size.x * size.y + size.y * size.z + size.z * size.x) * count as f32,
        }
    }
}

/// A plane between bins along an axis.
#[derive(Clone, Copy)]
struct Plane {
    axis: usize,
    low: f32,
    /// Bins a unit of length.
    density: f32,
    /// Bins before the plane.
    bins: usize,
}

impl Plane {
    fn bin(&self, center: Vec3) -> usize {
        (((center[self.axis] - self.low) * self.density) as usize).min(BINS - 1)
    }
}

/// Levels that halving needs for a number of boxes.
fn levels(count: usize) -> usize {
    count.next_power_of_two().ilog2() as usize
}

impl Build<'_> {
    /// Fills `nodes`, the first of which has the number `first`, with the tree over the boxes of `order`, of at most `left` levels.
    fn split(&self, order: &mut [u32], left: usize, first: u32, nodes: &mut [Shape]) {
        if let [only] = *order {
            nodes[0] = Shape::Leaf(only);
            return;
        }
        // Any split will do where halves of what is left have levels enough.
        let plane = if levels(order.len()) < left { self.best_plane(order) } else { None };
        let middle = match plane {
            Some(plane) => self.part(order, plane),
            None => halve(self.centers, order),
        };
        let (left_order, right_order) = order.split_at_mut(middle);
        // A tree over n boxes has 2n − 1 nodes.
        let (node, below) = nodes.split_at_mut(1);
        let (left_nodes, right_nodes) = below.split_at_mut(2 * middle - 1);
        let right_at = first + 2 * middle as u32;
        node[0] = Shape::Inner(right_at);
        if left_order.len().min(right_order.len()) >= PARALLEL {
            rayon::join(
                || self.split(left_order, left - 1, first + 1, left_nodes),
                || self.split(right_order, left - 1, right_at, right_nodes),
            );
        } else {
            self.split(left_order, left - 1, first + 1, left_nodes);
            self.split(right_order, left - 1, right_at, right_nodes);
        }
    }

    /// The plane with the least cost; `None` where all centres are at one place.
    fn best_plane(&self, order: &[u32]) -> Option<Plane> {
        let (mut low, mut high) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
        for &i in order {
            low = low.min(self.centers[i as usize]);
            high = high.max(self.centers[i as usize]);
        }
        let mut best: Option<(f32, Plane)> = None;
        for axis in 0..3 {
            let density = BINS as f32 / (high - low)[axis];
            if !(high[axis] > low[axis] && density.is_finite()) {
                continue;
            }
            let plane = Plane { axis, low: low[axis], density, bins: 0 };
            let mut bins = [Bin::EMPTY; BINS];
            for &i in order {
                let bin = &mut bins[plane.bin(self.centers[i as usize])];
                let (low, high) = self.boxes[i as usize];
                *bin = bin.with(Bin { low, high, count: 1 });
            }
            let mut right = [Bin::EMPTY; BINS + 1];
            for i in (0..BINS).rev() {
                right[i] = right[i + 1].with(bins[i]);
            }
            let mut left = Bin::EMPTY;
            for i in 1..BINS {
                left = left.with(bins[i - 1]);
                let cost = left.cost() + right[i].cost();
                let is_split = left.count > 0 && right[i].count > 0;
                if is_split && cost.is_finite() && best.is_none_or(|(least, _)| cost < least) {
                    best = Some((cost, Plane { bins: i, ..plane }));
                }
            }
        }
        best.map(|(_, plane)| plane)
    }

    /// Puts the boxes before a plane first, and says how many they are.
    fn part(&self, order: &mut [u32], plane: Plane) -> usize {
        let mut middle = 0;
        for i in 0..order.len() {
            if plane.bin(self.centers[order[i] as usize]) < plane.bins {
                order.swap(i, middle);
                middle += 1;
            }
        }
        middle
    }
}

#[cfg(test)]
mod tests {
    use super::super::median_tree::median_tree;
    use super::*;

    /// Most inner nodes above a leaf, and the expected number of nodes that a ray through the root's box visits, by the areas of their boxes.
    fn measure(shape: &[Shape], boxes: &[(Vec3, Vec3)]) -> (usize, f64) {
        let mut all = vec![(Bin::EMPTY, 0); shape.len()];
        for (at, node) in shape.iter().enumerate().rev() {
            all[at] = match *node {
                Shape::Leaf(index) => {
                    let (low, high) = boxes[index as usize];
                    (Bin { low, high, count: 1 }, 0)
                }
                Shape::Inner(right) => {
                    let (a, b) = (all[at + 1], all[right as usize]);
                    (a.0.with(b.0), 1 + a.1.max(b.1))
                }
            };
        }
        let area = |bin: Bin| f64::from(Bin { count: 1, ..bin }.cost());
        (all[0].1, all.iter().map(|(bin, _)| area(*bin)).sum::<f64>() / area(all[0].0))
    }

    fn boxes(count: usize, place: impl Fn(usize) -> Vec3, size: impl Fn(usize) -> f32) -> Vec<(Vec3, Vec3)> {
        (0..count).map(|i| (place(i), place(i) + size(i))).collect()
    }

    #[test]
    fn each_box_is_a_leaf_and_no_tree_is_too_deep() {
        let places: [fn(usize) -> Vec3; 4] = [
            |_| Vec3::ZERO,
            |i| Vec3::X * i as f32,
            // Each twice as far away as the one before, over and over: what makes chains.
            |i| Vec3::Y * (i as f32 % 100.0).exp2(),
            |i| Vec3::new((i * 7919 % 1013) as f32, (i * 104_729 % 997) as f32, (i % 31) as f32),
        ];
        for place in places {
            for count in [1, 2, 3, 33, 5000, 65_537] {
                let boxes = boxes(count, place, |_| 1.0);
                let shape = sah_tree(&boxes);
                let mut leaves: Vec<u32> = (shape.iter())
                    .filter_map(|node| if let Shape::Leaf(index) = node { Some(*index) } else { None })
                    .collect();
                leaves.sort_unstable();
                assert!(leaves.iter().copied().eq(0..count as u32), "{count} boxes");
                assert!(measure(&shape, &boxes).0 <= MAX_INSTANCE_DEPTH, "{count} boxes");
            }
        }
        // Halving alone is never too deep for as many as 32 bits can count.
        assert!(levels(u32::MAX as usize) <= MAX_INSTANCE_DEPTH);
    }

    #[test]
    fn rays_visit_fewer_nodes_than_where_boxes_are_halved() {
        // Small things among large ones, in clusters.
        let place = |i: usize| {
            let cluster = Vec3::new((i % 7 * 131) as f32, (i % 11 * 97) as f32, 0.0);
            cluster + Vec3::new((i * 7919 % 53) as f32, (i * 104_729 % 47) as f32, (i % 13) as f32)
        };
        let boxes = boxes(4000, place, |i| if i % 17 == 0 { 40.0 } else { 3.0 });
        let (ours, halved) = (measure(&sah_tree(&boxes), &boxes).1, measure(&median_tree(&boxes), &boxes).1);
        assert!(ours < 0.8 * halved, "{ours} of {halved}");
    }
}
