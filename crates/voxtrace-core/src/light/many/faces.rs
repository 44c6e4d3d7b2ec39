//! Sixteen choices of a face among the emitters of a leaf at once.

use super::kernel::{Emitters, Receivers, to_array};
use super::ways::{COUNT, INDEX, WITHIN, Ways, window};
use crate::packed::{Emitter, LEAF_EMITTERS};
use crate::walk::simd::{LANES, Row, Simd};

/// What sixteen ways choose.
pub struct Faces {
    /// Number of the emitter; without meaning where the importance is 0.
    pub emitter: [i32; LANES],
    pub axis: [i32; LANES],
    /// Importance of the face, and that of all faces of the leaf.
    pub importance: [f32; LANES],
    pub sum: [f32; LANES],
}

/// Chooses a face for each of the sixteen ways from `first` on, as `choose_face` of [`super::super::emitters`] does.
///
/// # Safety
/// The ways must stand at leaves, or have a count of 0, and there must be emitters.
#[inline(always)]
pub unsafe fn choose<S: Simd>(s: S, emitters: &[Emitter], ways: &Ways, first: usize) -> Faces {
    let emitters: &[[Row; 2]] = bytemuck::cast_slice(emitters);
    let zero = s.floats(0.0);
    let [p0, p1, p2, n0, n1, n2, slack, ..] = &ways.floats;
    let at = [window(p0, first), window(p1, first), window(p2, first), window(n0, first), window(n1, first)];
    let [p0, p1, p2, n0, n1] = at;
    let receivers = Receivers::load(s, [p0, p1, p2, n0, n1, window(n2, first), window(slack, first)]);
    let counts = window(&ways.integers[COUNT], first);
    let (count, index) = (s.load(counts), s.load(window(&ways.integers[INDEX], first)));
    let mut most = 0;
    for &count in counts {
        most = count.max(most);
    }
    let most = (most as usize).min(LEAF_EMITTERS);
    let mut importances = [[zero; 3]; LEAF_EMITTERS];
    let mut sums = [zero; LEAF_EMITTERS];
    let mut sum = zero;
    for place in 0..most {
        let has_one = s.is_below(s.ints(place as i32), count);
        let number = s.select(has_one, s.add(index, s.ints(place as i32)), s.ints(0));
        // SAFETY: the caller's duty; the first emitter stands in where a leaf has no more.
        let of_faces = unsafe { Emitters::gather(s, number, emitters) }.face_importances(s, &receivers);
        for axis in 0..3 {
            importances[place][axis] = s.select_floats(has_one, of_faces[axis], zero);
        }
        let [x, y, z] = importances[place];
        sums[place] = s.add_floats(s.add_floats(x, y), z);
        sum = s.add_floats(sum, sums[place]);
    }
    let threshold = s.mul_floats(s.load_floats(window(&ways.floats[WITHIN], first)), sum);
    let (mut passed, mut is_open) = (zero, s.mask(u16::MAX));
    let (mut emitter, mut axis, mut importance) = (s.ints(0), s.ints(0), zero);
    for place in 0..most {
        let is_possible = s.both(is_open, s.lt_floats(zero, sums[place]));
        let [x, y, z] = importances[place];
        let rest = s.sub_floats(threshold, passed);
        let is_x = s.lt_floats(rest, x);
        let is_y = s.lt_floats(rest, s.add_floats(x, y));
        let one_if_y = s.select(s.lt_floats(zero, y), s.ints(1), s.ints(0));
        let last = s.select(s.lt_floats(zero, z), s.ints(2), one_if_y);
        let own_axis = s.select(is_x, s.ints(0), s.select(is_y, s.ints(1), last));
        let (first, second) = (s.ints(0), s.ints(1));
        let own = s.select_floats(s.eq(own_axis, first), x, s.select_floats(s.eq(own_axis, second), y, z));
        emitter = s.select(is_possible, s.add(index, s.ints(place as i32)), emitter);
        axis = s.select(is_possible, own_axis, axis);
        importance = s.select_floats(is_possible, own, importance);
        passed = s.add_floats(passed, sums[place]);
        is_open = s.except(is_open, s.both(is_possible, s.lt_floats(threshold, passed)));
    }
    Faces {
        emitter: to_array(s, emitter),
        axis: to_array(s, axis),
        importance: bytemuck::cast(to_array(s, s.bits_of(importance))),
        sum: bytemuck::cast(to_array(s, s.bits_of(sum))),
    }
}
