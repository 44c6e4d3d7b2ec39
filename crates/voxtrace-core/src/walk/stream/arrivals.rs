//! Rays on their way into lanes of a scene of several instances: turned into the spaces of their grids and taken to where they enter them, sixteen
//! at a time. The steps are those of [`LocalRay::new`] and of `Walk::enter`, so the numbers are the same.

use super::journeys::Journeys;
use super::waiting::floor_of;
use super::{
    DIRECTION, FLOATS, INTEGERS, INVERSE, Lanes, ORIGIN, RAY, SIGN_INDEX, SKIP_SHIFT, T_END, TOLERANCE, VOXEL,
};
use crate::walk::beams::Entry;
use crate::walk::local_ray::{LocalRay, MAX_ORIGIN, SPEED_MAX, SPEED_MIN, T_END_SCALE, TOLERANCE_SCALE};
use crate::walk::scalar::Walk;
use crate::walk::simd::{Bits, LANES, Simd, lanes_of, window, window_mut};

/// Rays prepared at a time.
pub const CHUNK: usize = 64;

/// What lanes need of a grid: its origin, the cells of its top array along each axis, where that begins and log₂ of the size of its cells.
pub const GRID: usize = 8;
/// Places of these, and of the lowest voxel and the one past the highest, among the words of a `PackedGrid`.
const GRID_WORDS: [usize; GRID + 6] = [0, 1, 2, 4, 5, 6, 7, 3, 8, 9, 10, 13, 14, 15];

/// Rays that are ready to be put into lanes.
pub struct Arrivals {
    /// One array for each quantity; a vector more than a chunk, so that whole vectors can be read and written.
    floats: [[f32; CHUNK + LANES]; FLOATS],
    integers: [[i32; CHUNK + LANES]; INTEGERS],
    grids: [[i32; CHUNK + LANES]; GRID],
    /// The ready rays are `next..end`.
    next: usize,
    end: usize,
}

/// Sixteen rays in the world, the transforms into the spaces of their grids, and the grids.
struct Given {
    numbers: [i32; LANES],
    rays: [[f32; LANES]; 8],
    transforms: [[f32; LANES]; 12],
    grids: [[i32; LANES]; GRID + 6],
}

impl Arrivals {
    #[inline(always)]
    pub fn new() -> Self {
        let (floats, integers) = ([[0.0; CHUNK + LANES]; FLOATS], [[0; CHUNK + LANES]; INTEGERS]);
        Self { floats, integers, grids: [[0; CHUNK + LANES]; GRID], next: 0, end: 0 }
    }

    /// Puts rays into all free lanes, or as many as there are.
    #[inline(always)]
    pub fn fill<S: Simd>(&mut self, simd: S, journeys: &mut Journeys, lanes: &mut Lanes) {
        while lanes.active != Bits::MAX {
            if self.next == self.end && !self.prepare(simd, journeys) {
                return;
            }
            let free = !lanes.active;
            let count = (free.count_ones() as usize).min(self.end - self.next);
            // The lowest `count` free lanes.
            let filled = lanes_of(free).take(count).fold(0, |bits, lane| bits | 1 << lane);
            for (lanes, ready) in lanes.floats.iter_mut().zip(&self.floats) {
                simd.expand(bytemuck::cast_mut(lanes), filled, bytemuck::cast_ref(window(ready, self.next)));
            }
            for (lanes, ready) in lanes.integers.iter_mut().zip(&self.integers) {
                simd.expand(lanes, filled, window(ready, self.next));
            }
            for (lanes, ready) in lanes.grids.words().into_iter().zip(&self.grids) {
                simd.expand(lanes, filled, window(ready, self.next));
            }
            // No voxel lies in such a node.
            let nowhere = simd.select(simd.mask(filled), simd.ints(i32::MIN), simd.load(&lanes.node_at[0]));
            simd.store(&mut lanes.node_at[0], nowhere);
            lanes.active |= filled;
            self.next += count;
        }
    }

    /// Prepares the next rays. Returns false when there are none left that wait.
    #[inline(always)]
    fn prepare<S: Simd>(&mut self, simd: S, journeys: &mut Journeys) -> bool {
        (self.next, self.end) = (0, 0);
        let mut given = Given {
            numbers: [0; LANES],
            rays: [[0.0; LANES]; 8],
            transforms: [[0.0; LANES]; 12],
            grids: [[0; LANES]; GRID + 6],
        };
        while self.end + LANES <= CHUNK && journeys.are_waiting() {
            let (count, numbers) = journeys.advance(simd);
            if count == 0 {
                continue;
            }
            for lane in 0..count {
                given.put(lane, numbers[lane] as usize, journeys);
            }
            let all = Bits::MAX >> (LANES - count);
            let (plain, missed) = self.prepare_vector(simd, &given, all);
            for lane in lanes_of(missed) {
                journeys.wait(given.numbers[lane] as usize);
            }
            for lane in lanes_of(all & !plain & !missed) {
                self.prepare_one(journeys, given.numbers[lane] as usize);
            }
        }
        self.end > 0
    }

    /// Prepares those rays of some lanes that need no special care. Returns which they are, and which of the others do not enter their grid.
    #[inline(always)]
    fn prepare_vector<S: Simd>(&mut self, s: S, given: &Given, all: Bits) -> (Bits, Bits) {
        let mut turned = Turned::of(s, given, all);
        turned.enter(s, given);
        let (plain, missed) = (s.bits(turned.plain), s.bits(turned.missed));
        let end = self.end;
        for (ready, values) in self.floats.iter_mut().zip(turned.floats) {
            s.compress(bytemuck::cast_mut(window_mut(ready, end)), plain, s.bits_of(values));
        }
        for (ready, values) in self.integers.iter_mut().zip(turned.integers) {
            s.compress(window_mut(ready, end), plain, values);
        }
        for (ready, values) in self.grids.iter_mut().zip(&given.grids) {
            s.compress(window_mut(ready, end), plain, s.load(values));
        }
        self.end += plain.count_ones() as usize;
        (plain, missed)
    }

    /// Prepares any ray.
    #[cold]
    fn prepare_one(&mut self, journeys: &mut Journeys, number: usize) {
        let journey = journeys.of(number);
        let placed = &journeys.instances[journey.instance as usize];
        let grid = &journeys.grids[placed.grid as usize];
        let entered = LocalRay::new(&journey.ray, &placed.grid_from_world).and_then(|local| {
            let walk = Walk::new(&local, grid);
            let voxel = walk.begin(grid, Entry::Start)?;
            Some((local, walk.tolerance, voxel))
        });
        let Some((local, tolerance, voxel)) = entered else {
            journeys.wait(number);
            return;
        };
        let (relative, octant, at) = (voxel - grid.origin, local.octant(), self.end);
        for axis in 0..3 {
            self.floats[ORIGIN + axis][at] = local.origin[axis];
            self.floats[DIRECTION + axis][at] = local.direction[axis];
            self.floats[INVERSE + axis][at] = local.inverse[axis];
            self.floats[TOLERANCE + axis][at] = tolerance[axis];
            self.integers[VOXEL + axis][at] = relative[axis];
            self.integers[SIGN_INDEX + axis][at] = 4 * (octant as i32 >> axis & 1);
        }
        self.floats[T_END][at] = local.t_end();
        self.integers[SKIP_SHIFT][at] = 3 * octant as i32;
        self.integers[RAY][at] = number as i32;
        let words: &[i32; 17] = bytemuck::cast_ref(grid);
        for (grids, word) in self.grids.iter_mut().zip(GRID_WORDS) {
            grids[at] = words[word];
        }
        self.end += 1;
    }
}

impl Given {
    /// A coordinate of three words of the rays, in the spaces of the grids, before translation.
    #[inline(always)]
    fn turned<S: Simd>(&self, s: S, first: usize, axis: usize) -> S::Floats {
        let x = s.mul_floats(s.load_floats(&self.transforms[axis]), s.load_floats(&self.rays[first]));
        let y = s.mul_floats(s.load_floats(&self.transforms[3 + axis]), s.load_floats(&self.rays[first + 1]));
        let z = s.mul_floats(s.load_floats(&self.transforms[6 + axis]), s.load_floats(&self.rays[first + 2]));
        s.add_floats(s.add_floats(x, y), z)
    }

    /// Puts a ray into a lane, with the instance that it was taken to.
    #[inline(always)]
    fn put(&mut self, lane: usize, number: usize, journeys: &Journeys) {
        let journey = journeys.of(number);
        let placed = &journeys.instances[journey.instance as usize];
        let ray: &[f32; 8] = bytemuck::cast_ref(&journey.ray);
        let transform: &[f32; 12] = bytemuck::cast_ref(&placed.grid_from_world);
        let grid: &[i32; 17] = bytemuck::cast_ref(&journeys.grids[placed.grid as usize]);
        self.numbers[lane] = number as i32;
        for word in 0..8 {
            self.rays[word][lane] = ray[word];
        }
        for word in 0..12 {
            self.transforms[word][lane] = transform[word];
        }
        for word in 0..GRID + 6 {
            self.grids[word][lane] = grid[GRID_WORDS[word]];
        }
    }
}

/// Sixteen rays in the spaces of their grids.
struct Turned<S: Simd> {
    floats: [S::Floats; FLOATS],
    integers: [S::Ints; INTEGERS],
    is_negative: [S::Mask; 3],
    /// The first voxels.
    start: [S::Ints; 3],
    /// The lowest voxel of the grid, and the highest one.
    bounds: [[S::Ints; 3]; 2],
    /// Rays that start outside of the grid's bounds, when they are within all planes of these that lie ahead, and the axis of the one that they cross
    /// last then.
    is_outside: S::Mask,
    t_enter: S::Floats,
    enters: [S::Mask; 3],
    /// Rays that need no special care.
    plain: S::Mask,
    /// Rays that do not enter their grid.
    missed: S::Mask,
}

impl<S: Simd> Turned<S> {
    /// Turns rays into the spaces of their grids, and finds the planes through which they enter.
    #[inline(always)]
    fn of(s: S, given: &Given, all: Bits) -> Self {
        let (zero, none, one) = (s.floats(0.0), s.mask(0), s.ints(1));
        let (t_min, t_max) = (s.load_floats(&given.rays[3]), s.load_floats(&given.rays[7]));
        let mut turned = Self {
            floats: [zero; FLOATS],
            integers: [s.ints(0); INTEGERS],
            is_negative: [none; 3],
            start: [one; 3],
            bounds: [[one; 3]; 2],
            is_outside: none,
            t_enter: zero,
            enters: [none; 3],
            plain: s.mask(all),
            missed: none,
        };
        let mut fastest = zero;
        for axis in 0..3 {
            let direction = given.turned(s, 4, axis);
            let origin = s.add_floats(given.turned(s, 0, axis), s.load_floats(&given.transforms[9 + axis]));
            let speed = s.abs(direction);
            fastest = s.max(speed, fastest);
            turned.plain = s.both(turned.plain, s.le_floats(s.floats(f32::MIN_POSITIVE), speed));
            turned.plain = s.both(turned.plain, s.le_floats(speed, s.floats(SPEED_MAX)));
            turned.plain = s.both(turned.plain, s.le_floats(s.abs(origin), s.floats(MAX_ORIGIN)));
            let (low, end) = (s.load(&given.grids[GRID + axis]), s.load(&given.grids[GRID + 3 + axis]));
            let planes = [s.to_floats(low), s.to_floats(end)];
            let extent = s.add_floats(s.max(s.abs(planes[0]), s.abs(planes[1])), s.floats(1.0));
            let tolerance = s.mul_floats(s.add_floats(s.abs(origin), extent), s.floats(TOLERANCE_SCALE));
            let position = s.add_floats(origin, s.mul_floats(direction, t_min));
            turned.plain = s.both(turned.plain, s.le_floats(s.abs(position), s.floats(MAX_ORIGIN)));
            let (start, difference) = floor_of(s, position);
            // At t = 0 the position is the origin, exactly.
            let is_near = s.both(s.lt_floats(zero, t_min), s.le_floats(s.abs(difference), tolerance));
            turned.plain = s.except(turned.plain, is_near);
            let is_negative = s.lt_floats(direction, zero);
            turned.is_negative[axis] = is_negative;
            (turned.start[axis], turned.bounds[0][axis], turned.bounds[1][axis]) = (start, low, s.sub(end, one));
            turned.floats[ORIGIN + axis] = origin;
            turned.floats[DIRECTION + axis] = direction;
            turned.floats[INVERSE + axis] = s.div_floats(s.floats(1.0), direction);
            turned.floats[TOLERANCE + axis] = tolerance;
            turned.integers[SIGN_INDEX + axis] = s.select(is_negative, s.ints(4), s.ints(0));
            let skip_shift = s.select(is_negative, s.ints(3 << axis), s.ints(0));
            turned.integers[SKIP_SHIFT] = s.add(turned.integers[SKIP_SHIFT], skip_shift);
            turned.cross(s, axis, planes);
        }
        turned.plain = s.both(turned.plain, s.le_floats(s.floats(SPEED_MIN), fastest));
        let t_end = s.min(s.mul_floats(t_max, s.floats(T_END_SCALE)), s.floats(f32::MAX));
        turned.floats[T_END] = t_end;
        turned.integers[RAY] = s.load(&given.numbers);
        turned.missed = s.either(turned.missed, s.both(turned.is_outside, s.lt_floats(t_end, turned.t_enter)));
        turned
    }

    /// Where a voxel lies along an axis: beyond the grid, as the ray runs, and before it.
    #[inline(always)]
    fn sides(&self, s: S, axis: usize, voxel: S::Ints) -> (S::Mask, S::Mask) {
        let below = s.is_negative(s.sub(voxel, self.bounds[0][axis]));
        let above = s.is_negative(s.sub(self.bounds[1][axis], voxel));
        let is_negative = self.is_negative[axis];
        let beyond = s.either(s.both(below, is_negative), s.except(above, is_negative));
        (beyond, s.except(s.either(below, above), beyond))
    }

    /// Takes the plane of an axis that rays have to cross, where it is the one that they cross last so far.
    #[inline(always)]
    fn cross(&mut self, s: S, axis: usize, planes: [S::Floats; 2]) {
        let (beyond, before) = self.sides(s, axis, self.start[axis]);
        self.missed = s.either(self.missed, beyond);
        let plane = s.select_floats(self.is_negative[axis], planes[1], planes[0]);
        let t = s.mul_floats(s.sub_floats(plane, self.floats[ORIGIN + axis]), self.floats[INVERSE + axis]);
        let is_later = s.except(before, s.both(self.is_outside, s.le_floats(t, self.t_enter)));
        for enters in &mut self.enters {
            *enters = s.except(*enters, is_later);
        }
        self.enters[axis] = is_later;
        self.t_enter = s.select_floats(is_later, t, self.t_enter);
        self.is_outside = s.either(self.is_outside, before);
    }

    /// Takes rays to the voxels in which they enter their grids.
    #[inline(always)]
    fn enter(&mut self, s: S, given: &Given) {
        let (mut is_unsure, mut passed) = (s.mask(0), s.mask(0));
        for axis in 0..3 {
            let moved = s.mul_floats(self.floats[DIRECTION + axis], self.t_enter);
            let position = s.add_floats(self.floats[ORIGIN + axis], moved);
            let (floor, difference) = floor_of(s, position);
            let is_near = s.le_floats(s.abs(difference), self.floats[TOLERANCE + axis]);
            let is_far = s.lt_floats(s.floats(MAX_ORIGIN), s.abs(position));
            let is_computed = s.except(self.is_outside, self.enters[axis]);
            is_unsure = s.either(is_unsure, s.both(is_computed, s.either(is_near, is_far)));
            let first = s.select(self.is_negative[axis], self.bounds[1][axis], self.bounds[0][axis]);
            let reached = s.select(self.is_outside, floor, self.start[axis]);
            let voxel = s.select(self.enters[axis], first, reached);
            let (beyond, before) = self.sides(s, axis, voxel);
            passed = s.either(passed, beyond);
            is_unsure = s.either(is_unsure, before);
            self.integers[VOXEL + axis] = s.sub(voxel, s.load(&given.grids[axis]));
        }
        self.missed = s.both(self.plain, s.either(self.missed, s.except(passed, is_unsure)));
        self.plain = s.except(self.plain, s.either(self.missed, is_unsure));
    }
}
