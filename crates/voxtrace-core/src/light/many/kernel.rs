//! What [`super::super::emitters`] computes of nodes and faces, for sixteen receivers at once: the same operations in the same order in each lane.

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

    /// The twin of `node_importance`.
    #[inline(always)]
    pub fn importance(&self, s: S, receivers: &Receivers<S>) -> S::Floats {
        let Receivers { point, normal, slack } = receivers;
        let (zero, one_half) = (s.floats(0.0), s.floats(0.5));
        let (mut half, mut toward) = ([zero; 3], [zero; 3]);
        for axis in 0..3 {
            half[axis] = s.mul_floats(s.sub_floats(self.max[axis], self.min[axis]), one_half);
            let middle = s.mul_floats(s.add_floats(self.min[axis], self.max[axis]), one_half);
            toward[axis] = s.sub_floats(middle, point[axis]);
        }
        let steep = [s.abs(normal[0]), s.abs(normal[1]), s.abs(normal[2])];
        let above = s.add_floats(s.add_floats(dot(s, &toward, normal), dot(s, &half, &steep)), *slack);
        let (far, near) = (dot(s, &toward, &toward), dot(s, &half, &half));
        let is_far = s.lt_floats(near, far);
        let mut spread = half;
        for axis in 0..3 {
            spread[axis] = s.select_floats(is_far, s.abs(toward[axis]), half[axis]);
        }
        let distance = length_bound(s, &spread);
        let mut along = [zero; 3];
        for axis in 0..3 {
            let beyond_min = s.min(s.max(s.sub_floats(point[axis], self.min[axis]), zero), distance);
            let beyond_max = s.min(s.max(s.sub_floats(self.max[axis], point[axis]), zero), distance);
            let lower = s.mul_floats(self.power[2 * axis], beyond_max);
            along[axis] = s.add_floats(lower, s.mul_floats(self.power[2 * axis + 1], beyond_min));
        }
        let sent = s.add_floats(s.add_floats(along[0], along[1]), along[2]);
        let falloff = reciprocal_guess(s, s.max(far, near));
        let seen = s.mul_floats(s.mul_floats(sent, s.min(above, distance)), s.mul_floats(falloff, falloff));
        s.select_floats(s.lt_floats(zero, above), seen, zero)
    }
}

/// Sixteen emitters.
#[derive(Clone, Copy)]
pub struct Emitters<S: Simd> {
    voxel: [S::Ints; 3],
    faces: S::Ints,
    luminance: S::Floats,
}

impl<S: Simd> Emitters<S> {
    /// Reads the emitters of these numbers.
    ///
    /// # Safety
    /// There must be such emitters.
    #[inline(always)]
    pub unsafe fn gather(s: S, number: S::Ints, emitters: &[[Row; 2]]) -> Self {
        // SAFETY: the caller's duty.
        let [[x, y, z, _], [faces, _, luminance, _]] = unsafe { s.gather_records(number, emitters) };
        Self { voxel: [x, y, z], faces, luminance: s.floats_of(luminance) }
    }

    /// The twin of `face_importances`.
    #[inline(always)]
    pub fn face_importances(&self, s: S, receivers: &Receivers<S>) -> [S::Floats; 3] {
        let Receivers { point, normal, slack } = receivers;
        let (zero, one_half) = (s.floats(0.0), s.floats(0.5));
        let mut toward = [zero; 3];
        let (mut aside, mut in_front, mut nearest, mut squares) = ([zero; 3], [zero; 3], [zero; 3], [zero; 3]);
        let mut height = [zero; 3];
        for axis in 0..3 {
            toward[axis] = s.sub_floats(s.add_floats(s.to_floats(self.voxel[axis]), one_half), point[axis]);
            aside[axis] = s.abs(toward[axis]);
            in_front[axis] = s.sub_floats(aside[axis], one_half);
            nearest[axis] = s.mul_floats(in_front[axis], in_front[axis]);
            squares[axis] = s.mul_floats(aside[axis], aside[axis]);
            height[axis] = s.mul_floats(s.abs(normal[axis]), one_half);
        }
        let middle = s.add_floats(dot(s, &toward, normal), *slack);
        let highest = s.add_floats(s.add_floats(height[0], height[1]), height[2]);
        let bound = length_bound(s, &aside);
        let mut importances = [zero; 3];
        for axis in 0..3 {
            let is_upper = s.lt_floats(toward[axis], zero);
            let nearer = s.select_floats(is_upper, normal[axis], s.sub_floats(zero, normal[axis]));
            let nearer = s.mul_floats(nearer, one_half);
            let above = s.add_floats(s.add_floats(middle, nearer), s.sub_floats(highest, height[axis]));
            let own = s.select(is_upper, s.ints(2 << (2 * axis)), s.ints(1 << (2 * axis)));
            let looks = s.both(s.test(self.faces, own), s.lt_floats(zero, in_front[axis]));
            let looks = s.both(looks, s.lt_floats(zero, above));
            let others = s.add_floats(squares[(axis + 1) % 3], squares[(axis + 2) % 3]);
            let distance_squared = s.add_floats(nearest[axis], others);
            let falloff = reciprocal_guess(s, s.max(distance_squared, one_half));
            let sent = s.mul_floats(self.luminance, in_front[axis]);
            let seen = s.mul_floats(s.mul_floats(sent, s.min(above, bound)), s.mul_floats(falloff, falloff));
            importances[axis] = s.select_floats(looks, seen, zero);
        }
        importances
    }
}

/// Sum of three products, the first two first.
#[inline(always)]
fn dot<S: Simd>(s: S, a: &[S::Floats; 3], b: &[S::Floats; 3]) -> S::Floats {
    let two = s.add_floats(s.mul_floats(a[0], b[0]), s.mul_floats(a[1], b[1]));
    s.add_floats(two, s.mul_floats(a[2], b[2]))
}

/// The twin of `length_bound`.
#[inline(always)]
fn length_bound<S: Simd>(s: S, [x, y, z]: &[S::Floats; 3]) -> S::Floats {
    let largest = s.max(*x, s.max(*y, *z));
    s.mul_floats(s.add_floats(largest, s.add_floats(s.add_floats(*x, *y), *z)), s.floats(0.5))
}

/// The twin of [`crate::math::reciprocal_guess`].
#[inline(always)]
fn reciprocal_guess<S: Simd>(s: S, x: S::Floats) -> S::Floats {
    let guess = s.floats_of(s.sub(s.ints(0x7ef3_11c3), s.bits_of(x)));
    s.mul_floats(guess, s.sub_floats(s.floats(2.0), s.mul_floats(x, guess)))
}

/// The twin of `weights_of`: the weights, and the lanes that have any.
#[inline(always)]
pub fn weights_of<S: Simd>(s: S, left: S::Floats, right: S::Floats) -> ([S::Floats; 2], S::Mask) {
    let (left, right) = (normal_or_zero(s, left), normal_or_zero(s, right));
    let sum = s.add_floats(left, right);
    // The twin of `inverse_power_of_two`; no sum is negative.
    let unit = s.floats_of(s.shl(s.sub(s.ints(254), s.shr(s.bits_of(sum), 23)), 23));
    let weights = [s.mul_floats(left, unit), s.mul_floats(right, unit)];
    ([normal_or_zero(s, weights[0]), normal_or_zero(s, weights[1])], s.lt_floats(s.floats(0.0), sum))
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
