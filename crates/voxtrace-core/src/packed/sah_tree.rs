//! Binary trees over boxes whose splits have the least cost, over bins (Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies", RT
//! 2007): the shape of the hierarchy over instances, where the cost is the expected work of a ray, and of the trees of lights. The same on any number of
//! threads.
//!
//! What is called in several places is kept out of line: the module for pages, which is optimized for speed here, has few bytes to spare.

use glam::Vec3;

/// Bins that places are counted in along an axis.
const BINS: usize = 16;
/// Boxes from this number on are split on other threads too.
const PARALLEL: usize = 4096;

/// A node of a tree.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Shape {
    /// A box, by its number.
    Leaf(u32),
    /// The left child follows the node; the right one has this number.
    Inner(u32),
}

/// What is built over.
pub(crate) struct Boxes<'a> {
    /// Lowest and highest corners.
    pub boxes: &'a [(Vec3, Vec3)],
    /// Where planes part them: each box is on the side of its place. Twice the centres, or places in units of one's own.
    pub places: &'a [Vec3],
    /// The cost of boxes together is the sum of their weights, times `measure` of the size of the box around them.
    pub weights: &'a [f32],
    pub measure: fn(Vec3) -> f32,
    /// Inner nodes above a leaf, at most.
    pub most_levels: usize,
    /// Whether planes alone part boxes, none of which have the same place: then there may be more levels, as many as halve what is between the first and the last place.
    pub by_planes: bool,
}

/// Half the area of a box of this size.
pub(super) fn half_area(size: Vec3) -> f32 {
    size.x * size.y + size.y * size.z + size.z * size.x
}

/// Twice the centres of boxes.
pub(super) fn centers(boxes: &[(Vec3, Vec3)]) -> Vec<Vec3> {
    boxes.iter().map(|(low, high)| low + high).collect()
}

/// Boxes together.
#[derive(Clone, Copy)]
struct Bin {
    low: Vec3,
    high: Vec3,
    weight: f32,
    count: u32,
}

impl Bin {
    const EMPTY: Self = Self { low: Vec3::INFINITY, high: Vec3::NEG_INFINITY, weight: 0.0, count: 0 };

    fn with(self, other: Self) -> Self {
        Self {
            low: self.low.min(other.low),
            high: self.high.max(other.high),
            weight: self.weight + other.weight,
            count: self.count + other.count,
        }
    }

    fn cost(self, measure: fn(Vec3) -> f32) -> f32 {
        if self.count > 0 { self.weight * measure(self.high - self.low) } else { 0.0 }
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
    /// The middle one; `None` where no plane along this axis parts places.
    fn along(axis: usize, low: Vec3, high: Vec3) -> Option<Self> {
        let density = BINS as f32 / (high - low)[axis];
        let is_wide = high[axis] > low[axis] && density.is_finite();
        is_wide.then_some(Self { axis, low: low[axis], density, bins: BINS / 2 })
    }

    fn bin(&self, place: Vec3) -> usize {
        (((place[self.axis] - self.low) * self.density) as usize).min(BINS - 1)
    }
}

/// Levels that halving needs for a number of boxes.
fn levels(count: usize) -> usize {
    count.next_power_of_two().ilog2() as usize
}

impl Boxes<'_> {
    /// The nodes of the tree, root first, each subtree whole; empty where there are no boxes.
    pub fn tree(&self) -> Vec<Shape> {
        let mut order: Vec<u32> = (0..self.boxes.len() as u32).collect();
        let mut nodes = vec![Shape::Leaf(0); (2 * order.len()).saturating_sub(1)];
        if !order.is_empty() {
            self.split(&mut order, self.most_levels, 0, &mut nodes);
        }
        nodes
    }

    /// Fills `nodes`, the first of which has the number `first`, with the tree over the boxes of `order`, of at most `left` levels.
    fn split(&self, order: &mut [u32], left: usize, first: u32, nodes: &mut [Shape]) {
        if let [only] = *order {
            nodes[0] = Shape::Leaf(only);
            return;
        }
        // Any split will do where halves of what is left have levels enough.
        let plane = match levels(order.len()) < left {
            true => self.best_plane(order),
            false => self.middle_plane(order).filter(|_| self.by_planes),
        };
        let below = left.saturating_sub(1);
        // Where boxes of a damaged file reach into infinity a plane parts nothing.
        let parted = plane.map(|plane| self.part(order, plane)).filter(|middle| (1..order.len()).contains(middle));
        let middle = parted.unwrap_or_else(|| halve(self.places, self.extent(order), order));
        let (left_order, right_order) = order.split_at_mut(middle);
        // A tree over n boxes has 2n − 1 nodes.
        let (node, others) = nodes.split_at_mut(1);
        let (left_nodes, right_nodes) = others.split_at_mut(2 * middle - 1);
        let right_at = first + 2 * middle as u32;
        node[0] = Shape::Inner(right_at);
        if left_order.len().min(right_order.len()) >= PARALLEL {
            rayon::join(
                || self.split(left_order, below, first + 1, left_nodes),
                || self.split(right_order, below, right_at, right_nodes),
            );
        } else {
            self.split(left_order, below, first + 1, left_nodes);
            self.split(right_order, below, right_at, right_nodes);
        }
    }

    /// The least and the greatest place along each axis.
    #[inline(never)]
    fn extent(&self, order: &[u32]) -> (Vec3, Vec3) {
        let (mut low, mut high) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
        for &i in order {
            low = low.min(self.places[i as usize]);
            high = high.max(self.places[i as usize]);
        }
        (low, high)
    }

    /// The plane in the middle of the axis along which places lie farthest apart; `None` where all are the same.
    fn middle_plane(&self, order: &[u32]) -> Option<Plane> {
        let (low, high) = self.extent(order);
        Plane::along(widest(low, high), low, high)
    }

    /// The plane with the least cost, the middle one where none can be told; `None` where all places are the same.
    #[inline(never)]
    fn best_plane(&self, order: &[u32]) -> Option<Plane> {
        let (low, high) = self.extent(order);
        let mut best: Option<(f32, Plane)> = None;
        for axis in 0..3 {
            let Some(plane) = Plane::along(axis, low, high) else { continue };
            let mut bins = [Bin::EMPTY; BINS];
            for &i in order {
                let bin = &mut bins[plane.bin(self.places[i as usize])];
                let (low, high) = self.boxes[i as usize];
                *bin = bin.with(Bin { low, high, weight: self.weights[i as usize], count: 1 });
            }
            let mut right = [Bin::EMPTY; BINS + 1];
            for i in (0..BINS).rev() {
                right[i] = right[i + 1].with(bins[i]);
            }
            let mut left = Bin::EMPTY;
            for i in 1..BINS {
                left = left.with(bins[i - 1]);
                let cost = left.cost(self.measure) + right[i].cost(self.measure);
                let is_split = left.count > 0 && right[i].count > 0;
                if is_split && cost.is_finite() && best.is_none_or(|(least, _)| cost < least) {
                    best = Some((cost, Plane { bins: i, ..plane }));
                }
            }
        }
        best.map(|(_, plane)| plane).or_else(|| self.middle_plane(order))
    }

    /// Puts the boxes before a plane first, and says how many they are.
    #[inline(never)]
    fn part(&self, order: &mut [u32], plane: Plane) -> usize {
        let mut middle = 0;
        for i in 0..order.len() {
            if plane.bin(self.places[order[i] as usize]) < plane.bins {
                order.swap(i, middle);
                middle += 1;
            }
        }
        middle
    }
}

/// The axis along which places lie farthest apart.
fn widest(low: Vec3, high: Vec3) -> usize {
    (0..3).max_by(|&a, &b| (high - low)[a].total_cmp(&(high - low)[b])).unwrap_or(0)
}

/// Puts the half of the boxes with the lower places along their widest axis first, and says how many they are.
#[inline(never)]
fn halve(places: &[Vec3], (low, high): (Vec3, Vec3), order: &mut [u32]) -> usize {
    let axis = widest(low, high);
    let half = order.len() / 2;
    // Only which boxes go where matters, not their order.
    order.select_nth_unstable_by(half, |&a, &b| {
        places[a as usize][axis].total_cmp(&places[b as usize][axis]).then(a.cmp(&b))
    });
    half
}

#[cfg(test)]
mod tests {
    use super::super::instances::MAX_INSTANCE_DEPTH;
    use super::*;

    /// The tree of at most so many levels where each box costs as much as the next one.
    fn tree(boxes: &[(Vec3, Vec3)], most_levels: usize) -> Vec<Shape> {
        let (places, weights) = (centers(boxes), vec![1.0; boxes.len()]);
        Boxes { boxes, places: &places, weights: &weights, measure: half_area, most_levels, by_planes: false }.tree()
    }

    /// Most inner nodes above a leaf, and the expected number of nodes that a ray through the root's box visits, by the areas of their boxes.
    fn measure(shape: &[Shape], boxes: &[(Vec3, Vec3)]) -> (usize, f64) {
        let mut all = vec![(Bin::EMPTY, 0); shape.len()];
        for (at, node) in shape.iter().enumerate().rev() {
            all[at] = match *node {
                Shape::Leaf(index) => {
                    let (low, high) = boxes[index as usize];
                    (Bin { low, high, weight: 1.0, count: 1 }, 0)
                }
                Shape::Inner(right) => {
                    let (a, b) = (all[at + 1], all[right as usize]);
                    (a.0.with(b.0), 1 + a.1.max(b.1))
                }
            };
        }
        let area = |bin: Bin| f64::from(half_area(bin.high - bin.low));
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
                let shape = tree(&boxes, MAX_INSTANCE_DEPTH);
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
    fn boxes_without_end_or_number_are_leaves_as_well() {
        let odd = [f32::INFINITY, f32::NEG_INFINITY, f32::NAN, f32::MAX, 0.0, 1.0];
        let boxes: Vec<_> = (0..216).map(|i| (Vec3::new(odd[i % 6], odd[i / 6 % 6], odd[i / 36]), Vec3::ONE)).collect();
        for most_levels in [levels(boxes.len()), MAX_INSTANCE_DEPTH] {
            let leaves = tree(&boxes, most_levels).iter().filter(|node| matches!(node, Shape::Leaf(_))).count();
            assert_eq!(leaves, boxes.len());
        }
    }

    #[test]
    fn rays_visit_fewer_nodes_than_where_boxes_are_halved() {
        // Small things among large ones, in clusters.
        let place = |i: usize| {
            let cluster = Vec3::new((i % 7 * 131) as f32, (i % 11 * 97) as f32, 0.0);
            cluster + Vec3::new((i * 7919 % 53) as f32, (i * 104_729 % 47) as f32, (i % 13) as f32)
        };
        let boxes = boxes(4000, place, |i| if i % 17 == 0 { 40.0 } else { 3.0 });
        let (ours, halved) = (
            measure(&tree(&boxes, MAX_INSTANCE_DEPTH), &boxes).1,
            measure(&tree(&boxes, levels(boxes.len())), &boxes).1,
        );
        assert!(ours < 0.8 * halved, "{ours} of {halved}");
    }
}
