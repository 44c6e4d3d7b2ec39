//! From the node where a way ended to an emitter, by power alone: the side for sixteen ways at once, then a level of each way after the other, so
//! that its nodes are there when it is its turn.

use super::kernel::{Nodes, Receivers, to_array};
use super::ways::{CAPACITY, CHOICE, COUNT, NODE, TOTAL, WEIGHT, WITHIN, Ways, window};
use crate::light::emitters::Odds;
use crate::packed::LightNode;
use crate::walk::simd::{LANES, Row, Simd, prefetch};
use std::hint::select_unpredictable;
use voxtrace_scene::ray::{FACES, Face};

/// A way that has chosen a side.
pub struct Fall {
    /// Number of the way.
    pub way: usize,
    pub side: Face,
    /// The power of the node where the way ended on that side.
    pub power: f32,
    /// The way's odds, with those of the side.
    pub odds: Odds,
    /// The node that it has come to, and what is left there of the running sum of powers.
    pub at: usize,
    pub threshold: f32,
}

impl Fall {
    /// Goes on to a child, as [`crate::light::emitters::child_by_power`] chooses it. Nobody foretells which, so both are read, and there is no branch.
    #[inline(always)]
    fn descend(&mut self, nodes: &[LightNode]) {
        let (side, right) = (self.side as usize, nodes[self.at].index as usize);
        let left_power = nodes[self.at + 1].power[side];
        let is_left = (self.threshold < left_power) | (nodes[right].power[side] <= 0.0);
        self.at = select_unpredictable(is_left, self.at + 1, right);
        self.threshold -= select_unpredictable(is_left, 0.0, left_power);
    }
}

/// Chooses a side for each of the ways that came to a node, as [`crate::light::emitters::choose_side`] does.
///
/// # Safety
/// The ways with a count other than 0 must stand at nodes of the tree.
#[inline(always)]
pub unsafe fn begin<S: Simd>(s: S, nodes: &[LightNode], ways: &Ways, falls: &mut Vec<Fall>) {
    falls.clear();
    let records: &[[Row; 4]] = bytemuck::cast_slice(nodes);
    let mut first = 0;
    while first < ways.count {
        let places = std::array::from_fn(|place| window(&ways.floats[place], first));
        let receivers = Receivers::load(s, places);
        let [weight, total, choice] =
            [WEIGHT, TOTAL, CHOICE].map(|place| s.load_floats(window(&ways.floats[place], first)));
        let mut at = *window(&ways.integers[NODE], first);
        for (lane, at) in at.iter_mut().enumerate() {
            // The first node stands in where there is no way.
            if first + lane >= ways.count || ways.integers[COUNT][first + lane] == 0 {
                *at = 0;
            }
        }
        // SAFETY: the caller's duty.
        let sides =
            unsafe { Nodes::gather(s, s.load(&at), records) }.choose_side(s, &receivers, [weight, total, choice]);
        let side = to_array(s, sides.side);
        let [power, weight, total]: [[f32; LANES]; 3] =
            [sides.power, sides.weight, sides.total].map(|floats| bytemuck::cast(to_array(s, s.bits_of(floats))));
        for lane in 0..LANES.min(ways.count - first) {
            let way = first + lane;
            if ways.integers[COUNT][way] != 0 && weight[lane] > 0.0 {
                let power = power[lane];
                falls.push(Fall {
                    way,
                    side: FACES[side[lane] as usize],
                    power,
                    odds: Odds { weight: weight[lane], total: total[lane] },
                    at: at[lane] as usize,
                    threshold: ways.floats[WITHIN][way] * power,
                });
            }
        }
        first += LANES;
    }
}

/// Takes all to leaves.
#[inline(always)]
pub fn to_leaves(nodes: &[LightNode], falls: &mut [Fall]) {
    // Places of those that have not come to one.
    let mut going: [u16; CAPACITY] = std::array::from_fn(|place| place as u16);
    let (mut count, mut is_first) = (falls.len(), true);
    while count > 0 {
        let mut kept = 0;
        for index in 0..count {
            let place = going[index];
            let fall = &mut falls[usize::from(place)];
            if !is_first {
                fall.descend(nodes);
            }
            let node = &nodes[fall.at];
            // The children are there when it is this one's turn again.
            prefetch(nodes.as_ptr().wrapping_add(fall.at + 1));
            prefetch(nodes.as_ptr().wrapping_add(node.index as usize));
            going[kept] = place;
            kept += usize::from(node.count == 0);
        }
        (count, is_first) = (kept, false);
    }
}
