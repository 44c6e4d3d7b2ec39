//! Many ways down a tree of lights at once, sixteen in a vector: as one comes to a leaf, another one begins in its lane.

use super::kernel::{Nodes, Receivers, to_array, weights_of_views};
use super::ways::{CHOICE, COUNT, INDEX, NODE, TOTAL, WEIGHT, Ways};
use crate::packed::LightNode;
use crate::walk::simd::{Bits, LANES, Row, Simd, lanes_of, prefetch, window};

/// Lanes that are free before others are put there: a vector's worth of work for each.
const FREE: u32 = 4;
/// Vectors of ways that are taken down in turn, so that one has its nodes fetched while the others compute.
const GROUPS: usize = 4;
/// Quantities that lanes need: the floats up to the choice.
const NEEDED: usize = CHOICE + 1;

/// Sixteen ways, one array for each quantity.
struct Lanes {
    floats: [[f32; LANES]; NEEDED],
    /// As [`Ways::integers`], with the number of the way in place of the count.
    integers: [[i32; LANES]; COUNT + 1],
    active: Bits,
}

impl Lanes {
    const EMPTY: Self =
        Self { floats: [[0.0; LANES]; NEEDED], integers: [[IDLE[0]; LANES], [IDLE[1]; LANES], [0; LANES]], active: 0 };
}

/// Node and index of lanes without a way: both children are the first node.
const IDLE: [i32; 2] = [-1, 0];
/// Place of the number of a lane's way.
const WAY: usize = COUNT;

/// Takes all ways that stand at inner nodes to leaves or, where it `ends_far`, to nodes that are far, as [`super::super::emitters::descend`] does without a
/// voxel. Those that lead nowhere then have a count of 0, all others another one.
///
/// # Safety
/// The ways must stand at nodes of the tree, which must be valid.
#[inline(always)]
pub unsafe fn descend<S: Simd>(s: S, nodes: &[LightNode], ends_far: bool, ways: &mut Ways) {
    let far_lanes = if ends_far { Bits::MAX } else { 0 };
    let records: &[[Row; 4]] = bytemuck::cast_slice(nodes);
    let mut groups = [Lanes::EMPTY; GROUPS];
    let mut next = 0;
    let mut is_under_way = true;
    while is_under_way {
        is_under_way = false;
        for lanes in &mut groups {
            if lanes.active.count_ones() + FREE <= LANES as u32 && next < ways.count {
                fill(s, lanes, ways, &mut next);
            }
            if lanes.active == 0 {
                continue;
            }
            is_under_way = true;
            // SAFETY: the caller's duty; every child of an inner node is a node.
            let step = unsafe { step(s, records, far_lanes, lanes) };
            for lane in lanes_of(lanes.active & !step.going) {
                let way = lanes.integers[WAY][lane] as usize;
                ways.integers[NODE][way] = step.node[lane];
                ways.integers[INDEX][way] = step.index[lane];
                ways.integers[COUNT][way] = step.count[lane];
                ways.floats[WEIGHT][way] = lanes.floats[WEIGHT][lane];
                ways.floats[TOTAL][way] = lanes.floats[TOTAL][lane];
                ways.floats[CHOICE][way] = lanes.floats[CHOICE][lane];
            }
            lanes.active = step.going;
            // The children are there when it is this group's turn again.
            for lane in 0..LANES {
                prefetch(nodes.as_ptr().wrapping_add((lanes.integers[NODE][lane] + 1) as usize));
                prefetch(nodes.as_ptr().wrapping_add(lanes.integers[INDEX][lane] as usize));
            }
        }
    }
}

/// Puts ways that stand at inner nodes into free lanes.
#[inline(always)]
fn fill<S: Simd>(s: S, lanes: &mut Lanes, ways: &Ways, next: &mut usize) {
    while *next < ways.count && lanes.active != Bits::MAX {
        let free = !lanes.active;
        let count = (free.count_ones() as usize).min(ways.count - *next);
        // The lowest `count` free lanes.
        let filled = lanes_of(free).take(count).fold(0, |bits: Bits, lane| bits | 1 << lane);
        for (lanes, ready) in lanes.floats.iter_mut().zip(&ways.floats) {
            s.expand(bytemuck::cast_mut(lanes), filled, bytemuck::cast_ref(window(ready, *next)));
        }
        for (lanes, ready) in lanes.integers.iter_mut().zip(&ways.integers) {
            s.expand(lanes, filled, window(ready, *next));
        }
        for lane in lanes_of(filled) {
            let is_inner = lanes.integers[COUNT][lane] == 0;
            lanes.active |= Bits::from(is_inner) << lane;
            if !is_inner {
                [lanes.integers[NODE][lane], lanes.integers[INDEX][lane]] = IDLE;
            }
            lanes.integers[WAY][lane] = *next as i32;
            *next += 1;
        }
    }
}

/// One level down.
struct Step {
    /// Lanes that go on.
    going: Bits,
    /// Where all lanes came to: a node, what it holds, and how much, 0 where the way leads nowhere.
    node: [i32; LANES],
    index: [i32; LANES],
    count: [i32; LANES],
}

/// Takes all active lanes one level down; those of `ends_far` end at nodes that are far.
///
/// # Safety
/// As for [`descend`].
#[inline(always)]
unsafe fn step<S: Simd>(s: S, records: &[[Row; 4]], ends_far: Bits, lanes: &mut Lanes) -> Step {
    let [p0, p1, p2, n0, n1, n2, slack, ..] = &lanes.floats;
    let receivers = Receivers::load(s, [p0, p1, p2, n0, n1, n2, slack]);
    let (near, far) = (s.add(s.load(&lanes.integers[NODE]), s.ints(1)), s.load(&lanes.integers[INDEX]));
    // SAFETY: the caller's duty; idle lanes stand before the first node.
    let (left, right) = unsafe { (Nodes::gather(s, near, records), Nodes::gather(s, far, records)) };
    let (of_left, of_right) = (left.view(s, &receivers), right.view(s, &receivers));
    let (weights, is_possible) = weights_of_views(s, &of_left, &of_right);
    let (weight, total) = (s.load_floats(&lanes.floats[WEIGHT]), s.load_floats(&lanes.floats[TOTAL]));
    let choice = s.load_floats(&lanes.floats[CHOICE]);
    let of_both = s.add_floats(weights[0], weights[1]);
    let (choice, threshold) = (s.mul_floats(choice, of_both), s.mul_floats(weights[0], weight));
    let zero = s.floats(0.0);
    let is_left = s.either(s.le_floats(weights[1], zero), s.lt_floats(choice, threshold));
    let choice = s.sub_floats(choice, s.select_floats(is_left, zero, threshold));
    let weight = s.mul_floats(weight, s.select_floats(is_left, weights[0], weights[1]));
    let total = s.mul_floats(total, of_both);
    s.store(bytemuck::cast_mut(&mut lanes.floats[WEIGHT]), s.bits_of(weight));
    s.store(bytemuck::cast_mut(&mut lanes.floats[TOTAL]), s.bits_of(total));
    s.store(bytemuck::cast_mut(&mut lanes.floats[CHOICE]), s.bits_of(choice));
    let possible = s.both(s.both(s.mask(lanes.active), is_possible), s.lt_floats(zero, weight));
    let is_far = s.either(s.both(is_left, of_left.is_far), s.except(of_right.is_far, is_left));
    let is_far = s.both(is_far, s.mask(ends_far));
    let count = s.select(is_far, s.ints(1), s.select(is_left, left.count, right.count));
    let count = s.select(possible, count, s.ints(0));
    let going = s.both(possible, s.eq(count, s.ints(0)));
    let (node, index) = (s.select(is_left, near, far), s.select(is_left, left.index, right.index));
    s.store(&mut lanes.integers[NODE], s.select(going, node, s.ints(IDLE[0])));
    s.store(&mut lanes.integers[INDEX], s.select(going, index, s.ints(IDLE[1])));
    Step { going: s.bits(going), node: to_array(s, node), index: to_array(s, index), count: to_array(s, count) }
}
