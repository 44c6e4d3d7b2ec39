//! From the nodes where ways ended to emitters, by power alone: a side of the node, then a level of its tree after the other, then an emitter of the
//! leaf. Sixteen ways at a time, vector after vector, whose loads wait together.

use super::kernel::{Nodes, Receivers};
use super::ways::{CHOICE, COUNT, EMITTER, INDEX, NODE, POWER, SIDE, THRESHOLD, TOTAL, WEIGHT, WITHIN, Ways};
use crate::packed::{Emitter, LightNode};
use crate::walk::simd::{Bits, LANES, Row, Simd, prefetch, window, window_mut};
use std::mem::offset_of;

/// Bytes that processors fetch at once.
const LINE: usize = 64;

/// How many words so many bytes are.
const fn words(bytes: usize) -> i32 {
    (bytes / size_of::<u32>()) as i32
}

/// Chooses a side for each of the ways that came to a node, as [`crate::light::emitters::choose_side`] does. The others have a count of −1 then.
///
/// # Safety
/// The ways with a count other than 0 must stand at nodes of the tree.
#[inline(always)]
pub unsafe fn choose_sides<S: Simd>(s: S, nodes: &[LightNode], ways: &mut Ways) {
    let records: &[[Row; 4]] = bytemuck::cast_slice(nodes);
    let lanes = s.load(&std::array::from_fn(|lane| lane as i32));
    for first in (0..ways.count).step_by(LANES) {
        let receivers = Receivers::load(s, std::array::from_fn(|place| window(&ways.floats[place], first)));
        let (weight, total) = (float(s, ways, WEIGHT, first), float(s, ways, TOTAL, first));
        let (choice, within) = (float(s, ways, CHOICE, first), float(s, ways, WITHIN, first));
        let is_way = s.is_below(lanes, s.ints((ways.count - first) as i32));
        let is_there = s.except(is_way, s.eq(integer(s, ways, COUNT, first), s.ints(0)));
        // The first node stands in where there is no way.
        let node = s.select(is_there, integer(s, ways, NODE, first), s.ints(0));
        // SAFETY: the caller's duty.
        let nodes = unsafe { Nodes::gather(s, node, records) };
        let sides = nodes.choose_side(s, &receivers, [weight, total, choice]);
        let is_chosen = s.both(is_there, s.lt_floats(s.floats(0.0), sides.weight));
        set_float(s, ways, WEIGHT, first, sides.weight);
        set_float(s, ways, TOTAL, first, sides.total);
        set_float(s, ways, POWER, first, sides.power);
        set_float(s, ways, THRESHOLD, first, s.mul_floats(within, sides.power));
        set_integer(s, ways, SIDE, first, sides.side);
        set_integer(s, ways, INDEX, first, nodes.index);
        set_integer(s, ways, COUNT, first, s.select(is_chosen, nodes.count, s.ints(-1)));
    }
}

/// Takes the ways that have a side to leaves: each to the child at which the running sum of the powers on its side passes its threshold, as
/// [`crate::light::emitters::child_by_power`] chooses it.
///
/// # Safety
/// Those with a count of 0 must stand at inner nodes of the tree, which must be valid.
#[inline(always)]
pub unsafe fn to_leaves<S: Simd>(s: S, nodes: &[LightNode], ways: &mut Ways) {
    let nodes: &[u32] = bytemuck::cast_slice(nodes);
    let mut is_under_way = true;
    while is_under_way {
        is_under_way = false;
        for first in (0..ways.count).step_by(LANES) {
            let count = integer(s, ways, COUNT, first);
            let going = s.eq(count, s.ints(0));
            if !s.any(going) {
                continue;
            }
            is_under_way = true;
            let (node, right) = (integer(s, ways, NODE, first), integer(s, ways, INDEX, first));
            let (left, threshold) = (s.add(node, s.ints(1)), float(s, ways, THRESHOLD, first));
            let side = s.add(integer(s, ways, SIDE, first), s.ints(words(offset_of!(LightNode, power))));
            let size = s.ints(words(size_of::<LightNode>()));
            // SAFETY: the caller's duty; both children of an inner node are nodes.
            let (of_left, of_right) = unsafe {
                let of_left = s.gather(s.ints(0), going, s.add(s.mul(left, size), side), nodes);
                (s.floats_of(of_left), s.floats_of(s.gather(s.ints(0), going, s.add(s.mul(right, size), side), nodes)))
            };
            let is_left = s.either(s.lt_floats(threshold, of_left), s.le_floats(of_right, s.floats(0.0)));
            let rest = s.select_floats(s.except(going, is_left), s.sub_floats(threshold, of_left), threshold);
            let node = s.select(going, s.select(is_left, left, right), node);
            let index = s.add(s.mul(node, size), s.ints(words(offset_of!(LightNode, index))));
            let held = s.add(s.mul(node, size), s.ints(words(offset_of!(LightNode, count))));
            // SAFETY: as above.
            let (index, count) = unsafe { (s.gather(right, going, index, nodes), s.gather(count, going, held, nodes)) };
            set_float(s, ways, THRESHOLD, first, rest);
            set_integer(s, ways, NODE, first, node);
            set_integer(s, ways, INDEX, first, index);
            set_integer(s, ways, COUNT, first, count);
            // The right child is there when it is this vector's turn again; the left one lies beside the node.
            for &right in window(&ways.integers[INDEX], first) {
                prefetch(nodes.as_ptr().wrapping_add(right as usize * size_of::<LightNode>() / size_of::<u32>()));
            }
        }
    }
}

/// Chooses an emitter of the leaf that each came to, as [`crate::light::emitters::emitter_by_power`] does; −1 where there is none.
///
/// # Safety
/// The ways with a positive count must stand at leaves of the tree over these emitters, which must be valid.
#[inline(always)]
pub unsafe fn to_emitters<S: Simd>(s: S, emitters: &[Emitter], ways: &mut Ways) {
    for (&first, &count) in ways.integers[INDEX][..ways.count].iter().zip(&ways.integers[COUNT]) {
        let lines: *const [u8; LINE] = emitters.as_ptr().wrapping_add(first as usize).cast();
        for line in 0..=count * size_of::<Emitter>() as i32 / LINE as i32 {
            prefetch(lines.wrapping_add(line as usize));
        }
    }
    let emitters: &[u32] = bytemuck::cast_slice(emitters);
    for first in (0..ways.count).step_by(LANES) {
        let side = s.shl_each(s.ints(1), integer(s, ways, SIDE, first));
        let (mut emitter, mut count) = (integer(s, ways, INDEX, first), integer(s, ways, COUNT, first));
        let (mut threshold, mut chosen) = (float(s, ways, THRESHOLD, first), s.ints(-1));
        let mut open = s.except(s.mask(Bits::MAX), s.is_negative(count));
        while s.any(open) {
            let word = s.mul(emitter, s.ints(words(size_of::<Emitter>())));
            let faces = s.add(word, s.ints(words(offset_of!(Emitter, faces))));
            let luminance = s.add(word, s.ints(words(offset_of!(Emitter, luminance))));
            // SAFETY: the caller's duty.
            let (faces, luminance) = unsafe {
                let faces = s.gather(s.ints(0), open, faces, emitters);
                (faces, s.floats_of(s.gather(s.ints(0), open, luminance, emitters)))
            };
            let shines = s.both(open, s.test(faces, side));
            chosen = s.select(shines, emitter, chosen);
            let is_passed = s.both(shines, s.lt_floats(threshold, luminance));
            threshold = s.select_floats(shines, s.sub_floats(threshold, luminance), threshold);
            (emitter, count) = (s.add(emitter, s.ints(1)), s.sub(count, s.ints(1)));
            open = s.except(s.except(open, is_passed), s.eq(count, s.ints(0)));
        }
        set_integer(s, ways, EMITTER, first, chosen);
    }
}

#[inline(always)]
fn float<S: Simd>(s: S, ways: &Ways, place: usize, first: usize) -> S::Floats {
    s.load_floats(window(&ways.floats[place], first))
}

#[inline(always)]
fn integer<S: Simd>(s: S, ways: &Ways, place: usize, first: usize) -> S::Ints {
    s.load(window(&ways.integers[place], first))
}

#[inline(always)]
fn set_float<S: Simd>(s: S, ways: &mut Ways, place: usize, first: usize, values: S::Floats) {
    s.store(bytemuck::cast_mut(window_mut(&mut ways.floats[place], first)), s.bits_of(values));
}

#[inline(always)]
fn set_integer<S: Simd>(s: S, ways: &mut Ways, place: usize, first: usize, values: S::Ints) {
    s.store(window_mut(&mut ways.integers[place], first), values);
}
