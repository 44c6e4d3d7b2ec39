//! What [`super::super::emitters`] computes of nodes, for sixteen receivers at once: the same operations in the same order in each lane.

use super::super::emitters::{BY_NEAREST, FAR_SQUARED, NEAREST_SHARE};
use super::ways::{NORMAL, POINT, SLACK};
use crate::walk::simd::{LANES, Row, Simd};

/// Sixteen receivers, and what of them stays the same for all nodes.
#[derive(Clone, Copy)]
pub struct Receivers<S: Simd> {
    point: [S::Floats; 3],
    normal: [S::Floats; 3],
    slack: S::Floats,
}

impl<S: Simd> Receivers<S> {
    /// Those of some arrays, one for each quantity.
    #[inline(always)]
    pub fn load(s: S, floats: [&[f32; LANES]; SLACK + 1]) -> Self {
        let (mut point, mut normal) = ([s.floats(0.0); 3], [s.floats(0.0); 3]);
        for axis in 0..3 {
            point[axis] = s.load_floats(floats[POINT + axis]);
            normal[axis] = s.load_floats(floats[NORMAL + axis]);
        }
        Self { point, normal, slack: s.load_floats(floats[SLACK]) }
    }
}

/// Sixteen nodes.
#[derive(Clone, Copy)]
pub struct Nodes<S: Simd> {
    min: [S::Floats; 3],
    max: [S::Floats; 3],
    power: [S::Floats; 6],
    pub index: S::Ints,
    pub count: S::Ints,
}

impl<S: Simd> Nodes<S> {
    /// Reads the nodes of these numbers.
    ///
    /// # Safety
    /// There must be such nodes.
    #[inline(always)]
    pub unsafe fn gather(s: S, number: S::Ints, nodes: &[[Row; 4]]) -> Self {
        // SAFETY: the caller's duty.
        let [low, high, power, rest] = unsafe { s.gather_records(number, nodes) };
        Self {
            min: [s.floats_of(low[0]), s.floats_of(low[1]), s.floats_of(low[2])],
            max: [s.floats_of(high[0]), s.floats_of(high[1]), s.floats_of(high[2])],
            power: [
                s.floats_of(power[0]),
                s.floats_of(power[1]),
                s.floats_of(power[2]),
                s.floats_of(power[3]),
                s.floats_of(rest[0]),
                s.floats_of(rest[1]),
            ],
            index: low[3],
            count: high[3],
        }
    }

    /// The twin of `view`.
    #[inline(always)]
    pub fn view(&self, s: S, receivers: &Receivers<S>) -> Views<S> {
        let Receivers { point, normal, slack } = receivers;
        let (zero, one_half) = (s.floats(0.0), s.floats(0.5));
        let (mut half, mut toward, mut reach, mut nearest) = ([zero; 3], [zero; 3], [zero; 3], [zero; 3]);
        for axis in 0..3 {
            half[axis] = s.mul_floats(s.sub_floats(self.max[axis], self.min[axis]), one_half);
            let middle = s.mul_floats(s.add_floats(self.min[axis], self.max[axis]), one_half);
            toward[axis] = s.sub_floats(middle, point[axis]);
            let away = s.abs(toward[axis]);
            reach[axis] = s.max(away, half[axis]);
            let share = s.mul_floats(half[axis], s.floats(NEAREST_SHARE));
            nearest[axis] = s.max(s.sub_floats(away, half[axis]), share);
        }
        let steep = [s.abs(normal[0]), s.abs(normal[1]), s.abs(normal[2])];
        let (middle, aside) = (dot(s, &toward, normal), dot(s, &half, &steep));
        let above = s.add_floats(s.add_floats(middle, aside), *slack);
        let lowest = s.add_floats(s.sub_floats(middle, aside), *slack);
        let (far, near) = (dot(s, &reach, &reach), dot(s, &half, &half));
        let is_outside = s.lt_floats(s.mul_floats(near, s.floats(FAR_SQUARED)), far);
        let is_far = s.both(s.lt_floats(zero, lowest), is_outside);
        let falloff = reciprocal_guess(s, far);
        let sent = sum_of_sides(s, self.sent_by_side(s, receivers));
        let cosines = s.mul_floats(s.mul_floats(sent, above), falloff);
        let cosines = s.select_floats(s.lt_floats(zero, above), cosines, zero);
        let of_nearest = s.mul_floats(cosines, reciprocal_guess(s, dot(s, &nearest, &nearest)));
        Views { importance: s.mul_floats(cosines, falloff), of_nearest, is_far }
    }

    /// The twin of `sent_by_side`.
    #[inline(always)]
    fn sent_by_side(&self, s: S, receivers: &Receivers<S>) -> [S::Floats; 6] {
        let zero = s.floats(0.0);
        let mut sent = [zero; 6];
        for axis in 0..3 {
            let beyond_min = s.max(s.sub_floats(receivers.point[axis], self.min[axis]), zero);
            let beyond_max = s.max(s.sub_floats(self.max[axis], receivers.point[axis]), zero);
            sent[2 * axis] = s.mul_floats(self.power[2 * axis], beyond_max);
            sent[2 * axis + 1] = s.mul_floats(self.power[2 * axis + 1], beyond_min);
        }
        sent
    }

    /// The twin of `choose_side` without a side that was met: the sides, their power, and the weights of ways with these weights and choices; 0 where
    /// nothing is sent.
    #[inline(always)]
    pub fn choose_side(&self, s: S, receivers: &Receivers<S>, [weight, total, choice]: [S::Floats; 3]) -> Sides<S> {
        let zero = s.floats(0.0);
        let sent = self.sent_by_side(s, receivers);
        let sum = normal_or_zero(s, sum_of_sides(s, sent));
        let unit = inverse_power_of_two(s, sum);
        let of_all = s.mul_floats(sum, unit);
        let threshold = s.mul_floats(choice, of_all);
        let mut sides = Sides { side: s.ints(0), power: zero, weight: zero, total: s.mul_floats(total, of_all) };
        let (mut passed, mut is_open) = (zero, s.lt_floats(zero, sum));
        for (side, (sent, power)) in sent.into_iter().zip(self.power).enumerate() {
            let share = normal_or_zero(s, s.mul_floats(sent, unit));
            let is_chosen = s.both(is_open, s.lt_floats(zero, share));
            sides.side = s.select(is_chosen, s.ints(side as i32), sides.side);
            sides.power = s.select_floats(is_chosen, power, sides.power);
            sides.weight = s.select_floats(is_chosen, s.mul_floats(weight, share), sides.weight);
            passed = s.add_floats(passed, share);
            is_open = s.except(is_open, s.lt_floats(threshold, s.mul_floats(passed, weight)));
        }
        sides
    }
}

/// What sixteen nodes can send to as many receivers, and which of them are far.
#[derive(Clone, Copy)]
pub struct Views<S: Simd> {
    importance: S::Floats,
    of_nearest: S::Floats,
    pub is_far: S::Mask,
}

/// Sixteen chosen sides.
pub struct Sides<S: Simd> {
    pub side: S::Ints,
    pub power: S::Floats,
    pub weight: S::Floats,
    pub total: S::Floats,
}

/// Sum of three products, the first two first.
#[inline(always)]
fn dot<S: Simd>(s: S, a: &[S::Floats; 3], b: &[S::Floats; 3]) -> S::Floats {
    let two = s.add_floats(s.mul_floats(a[0], b[0]), s.mul_floats(a[1], b[1]));
    s.add_floats(two, s.mul_floats(a[2], b[2]))
}

/// The twin of [`crate::math::reciprocal_guess`].
#[inline(always)]
fn reciprocal_guess<S: Simd>(s: S, x: S::Floats) -> S::Floats {
    let guess = s.floats_of(s.sub(s.ints(0x7ef3_11c3), s.bits_of(x)));
    s.mul_floats(guess, s.sub_floats(s.floats(2.0), s.mul_floats(x, guess)))
}

/// The twin of [`crate::math::inverse_power_of_two`]; no sum is negative.
#[inline(always)]
fn inverse_power_of_two<S: Simd>(s: S, sum: S::Floats) -> S::Floats {
    s.floats_of(s.shl(s.sub(s.ints(254), s.shr(s.bits_of(sum), 23)), 23))
}

/// The twin of `sum_of_sides`.
#[inline(always)]
fn sum_of_sides<S: Simd>(s: S, sent: [S::Floats; 6]) -> S::Floats {
    let [x, y, z] = [s.add_floats(sent[0], sent[1]), s.add_floats(sent[2], sent[3]), s.add_floats(sent[4], sent[5])];
    s.add_floats(s.add_floats(x, y), z)
}

/// The twin of `weights_of`: the weights, and the lanes that have any.
#[inline(always)]
fn weights_of<S: Simd>(s: S, left: S::Floats, right: S::Floats) -> ([S::Floats; 2], S::Mask) {
    let (left, right) = (normal_or_zero(s, left), normal_or_zero(s, right));
    let sum = s.add_floats(left, right);
    let unit = inverse_power_of_two(s, sum);
    let weights = [s.mul_floats(left, unit), s.mul_floats(right, unit)];
    ([normal_or_zero(s, weights[0]), normal_or_zero(s, weights[1])], s.lt_floats(s.floats(0.0), sum))
}

/// The twin of `weights_of_views`: the weights, and the lanes that have any.
#[inline(always)]
pub fn weights_of_views<S: Simd>(s: S, left: &Views<S>, right: &Views<S>) -> ([S::Floats; 2], S::Mask) {
    let ([near_left, near_right], is_possible) = weights_of(s, left.of_nearest, right.of_nearest);
    let of_near = s.add_floats(near_left, near_right);
    let of_all = s.mul_floats(s.add_floats(left.importance, right.importance), s.floats(BY_NEAREST));
    let both = |view: &Views<S>, near| s.add_floats(s.mul_floats(view.importance, of_near), s.mul_floats(near, of_all));
    let (weights, have_any) = weights_of(s, both(left, near_left), both(right, near_right));
    (weights, s.both(is_possible, have_any))
}

/// What is too small for a normal number is 0.
#[inline(always)]
fn normal_or_zero<S: Simd>(s: S, x: S::Floats) -> S::Floats {
    s.select_floats(s.lt_floats(x, s.floats(f32::MIN_POSITIVE)), s.floats(0.0), x)
}

/// The lanes of an array.
#[inline(always)]
pub fn to_array<S: Simd>(s: S, vector: S::Ints) -> [i32; LANES] {
    let mut lanes = [0; LANES];
    s.store(&mut lanes, vector);
    lanes
}
