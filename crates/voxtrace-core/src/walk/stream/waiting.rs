//! Rays on their way into lanes: prepared some hundreds at a time, and put where lanes are free.

use super::{
    DIRECTION, FLOATS, INTEGERS, INVERSE, Lanes, ORIGIN, RAY, SIGN_INDEX, SKIP_SHIFT, T_END, TOLERANCE, VOXEL,
};
use crate::packed::{Geometry, PackedGrid};
use crate::walk::beams::{Beams, Entry};
use crate::walk::groups::Groups;
use crate::walk::local_ray::{LocalRay, MAX_ORIGIN, T_END_SCALE, TOLERANCE_SCALE};
use crate::walk::scalar::Walk;
use crate::walk::simd::{Bits, LANES, Simd, lanes_of, window, window_mut};
use voxtrace_scene::ray::Ray;
use voxtrace_scene::transform::Transform;

/// Rays prepared at a time.
const CHUNK: usize = 256;

/// Rays that are ready to be put into lanes, and those that are still to be prepared.
pub struct Waiting<'a> {
    rays: &'a [Ray],
    done: &'a Groups,
    /// Rays prepared so far, or done before: always whole groups.
    prepared: usize,
    grid: &'a PackedGrid,
    beams: Beams<'a>,
    /// One array for each quantity; a vector more than a chunk, so that whole vectors can be read and written.
    floats: [[f32; CHUNK + LANES]; FLOATS],
    integers: [[i32; CHUNK + LANES]; INTEGERS],
    /// The ready rays are `next..end`.
    next: usize,
    end: usize,
}

impl<'a> Waiting<'a> {
    #[inline(always)]
    pub fn new(rays: &'a [Ray], done: &'a Groups, (geometry, grid): (&'a Geometry, &'a PackedGrid)) -> Self {
        let (floats, integers) = ([[0.0; CHUNK + LANES]; FLOATS], [[0; CHUNK + LANES]; INTEGERS]);
        let beams = Beams::new(geometry, grid, rays);
        Self { rays, done, prepared: 0, grid, beams, floats, integers, next: 0, end: 0 }
    }

    /// Puts ready rays into all free lanes, or as many as there are.
    #[inline(always)]
    pub fn fill<S: Simd>(&mut self, simd: S, lanes: &mut Lanes) {
        while lanes.active != Bits::MAX {
            if self.next == self.end && !self.prepare(simd) {
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
            // No voxel lies in such a node.
            let nowhere = simd.select(simd.mask(filled), simd.ints(i32::MIN), simd.load(&lanes.node_at[0]));
            simd.store(&mut lanes.node_at[0], nowhere);
            lanes.active |= filled;
            self.next += count;
        }
    }

    /// Prepares the next rays. Returns false when there are none left.
    #[inline(always)]
    fn prepare<S: Simd>(&mut self, simd: S) -> bool {
        (self.next, self.end) = (0, 0);
        while self.end == 0 && self.prepared < self.rays.len() {
            let chunk_end = self.rays.len().min(self.prepared + CHUNK);
            while self.prepared < chunk_end {
                let count = LANES.min(chunk_end - self.prepared);
                if self.done.contains(self.prepared / LANES) {
                    self.prepared += count;
                    continue;
                }
                let entry = self.beams.entry(self.prepared / LANES);
                let plain = match self.rays[self.prepared..].first_chunk() {
                    _ if entry == Entry::Never => Bits::MAX,
                    Some(rays) if count == LANES => self.prepare_vector(simd, rays, entry),
                    _ => 0,
                };
                for lane in lanes_of(!plain & (Bits::MAX >> (LANES - count))) {
                    self.prepare_one(self.prepared + lane, entry);
                }
                self.prepared += count;
            }
        }
        self.end > 0
    }

    /// Prepares those of the next sixteen rays that need no special care: that begin within the grid's bounds, surely in one voxel, and move
    /// along every axis at a sensible speed. Returns which they are.
    #[inline(always)]
    fn prepare_vector<S: Simd>(&mut self, s: S, rays: &[Ray; LANES], entry: Entry) -> Bits {
        let (zero, one) = (s.floats(0.0), s.floats(1.0));
        let mut words = [[0.0; LANES]; 8];
        for (lane, ray) in rays.iter().enumerate() {
            let ray: &[f32; 8] = bytemuck::cast_ref(ray);
            for word in 0..8 {
                words[word][lane] = ray[word];
            }
        }
        let (t_min, t_max) = (s.load_floats(&words[3]), s.load_floats(&words[7]));
        let mut plain = s.both(s.le_floats(zero, t_min), s.le_floats(t_min, s.min(t_max, s.floats(f32::MAX))));
        let end = self.end;
        let mut skip_shift = s.ints(0);
        let (mut floats, mut integers) = ([zero; FLOATS], [s.ints(0); INTEGERS]);
        let t_end = s.min(s.mul_floats(t_max, s.floats(T_END_SCALE)), s.floats(f32::MAX));
        let (mut t, mut main, mut first) = (t_min, usize::MAX, 0);
        if let Entry::Plane { axis, plane } = entry {
            let distance = s.sub_floats(s.floats(plane as f32), s.load_floats(&words[axis]));
            t = s.mul_floats(distance, s.div_floats(one, s.load_floats(&words[4 + axis])));
            plain = s.both(plain, s.both(s.le_floats(t_min, t), s.le_floats(t, t_end)));
            (main, first) = (axis, plane);
        }
        for axis in 0..3 {
            let (origin, direction) = (s.load_floats(&words[axis]), s.load_floats(&words[4 + axis]));
            // Speeds between 1e-18 and 1e18 along every axis satisfy all that `LocalRay::new` asks of them.
            let speed = s.abs(direction);
            plain = s.both(plain, s.le_floats(s.floats(1e-18), speed));
            plain = s.both(plain, s.le_floats(speed, s.floats(1e18)));
            plain = s.both(plain, s.le_floats(s.abs(origin), s.floats(MAX_ORIGIN)));
            let extent = self.grid.min[axis].abs().max(self.grid.max[axis].abs()) as f32 + 1.0;
            let tolerance = s.mul_floats(s.add_floats(s.abs(origin), s.floats(extent)), s.floats(TOLERANCE_SCALE));
            floats[ORIGIN + axis] = origin;
            floats[DIRECTION + axis] = direction;
            floats[INVERSE + axis] = s.div_floats(one, direction);
            floats[TOLERANCE + axis] = tolerance;
            let is_negative = s.lt_floats(direction, zero);
            let voxel = if axis == main {
                s.select(is_negative, s.ints(first - 1), s.ints(first))
            } else {
                let position = s.add_floats(origin, s.mul_floats(direction, t));
                let (voxel, difference) = floor_of(s, position);
                // At t = 0 the position is the origin, exactly.
                let is_near = s.both(s.lt_floats(zero, t), s.le_floats(s.abs(difference), tolerance));
                plain = s.except(plain, is_near);
                // Far away the voxel would be another number.
                plain = s.both(plain, s.le_floats(s.abs(position), s.floats(MAX_ORIGIN)));
                voxel
            };
            let (min, max) = (self.grid.min[axis], self.grid.max[axis]);
            plain = s.both(plain, s.is_below(s.sub(voxel, s.ints(min)), s.ints(max - min)));
            integers[VOXEL + axis] = s.sub(voxel, s.ints(self.grid.origin[axis]));
            integers[SIGN_INDEX + axis] = s.select(is_negative, s.ints(4), s.ints(0));
            skip_shift = s.add(skip_shift, s.select(is_negative, s.ints(3 << axis), s.ints(0)));
        }
        floats[T_END] = t_end;
        integers[SKIP_SHIFT] = skip_shift;
        integers[RAY] = s.add(s.load(&NUMBERS), s.ints(self.prepared as i32));
        let plain = s.bits(plain);
        for (ready, values) in self.floats.iter_mut().zip(floats) {
            s.compress(bytemuck::cast_mut(window_mut(ready, end)), plain, s.bits_of(values));
        }
        for (ready, values) in self.integers.iter_mut().zip(integers) {
            s.compress(window_mut(ready, end), plain, values);
        }
        self.end += plain.count_ones() as usize;
        plain
    }

    /// Prepares any ray.
    #[cold]
    fn prepare_one(&mut self, index: usize, entry: Entry) {
        let Some(local) = LocalRay::new(&self.rays[index], &Transform::IDENTITY) else { return };
        let walk = Walk::new(&local, self.grid);
        let Some(voxel) = walk.begin(self.grid, entry) else { return };
        let (relative, octant, at) = (voxel - self.grid.origin, local.octant(), self.end);
        for axis in 0..3 {
            self.floats[ORIGIN + axis][at] = local.origin[axis];
            self.floats[DIRECTION + axis][at] = local.direction[axis];
            self.floats[INVERSE + axis][at] = local.inverse[axis];
            self.floats[TOLERANCE + axis][at] = walk.tolerance[axis];
            self.integers[VOXEL + axis][at] = relative[axis];
            self.integers[SIGN_INDEX + axis][at] = 4 * (octant as i32 >> axis & 1);
        }
        self.floats[T_END][at] = local.t_end();
        self.integers[SKIP_SHIFT][at] = 3 * octant as i32;
        self.integers[RAY][at] = index as i32;
        self.end += 1;
    }
}

/// The integers below coordinates, and how far those are from the nearest ones.
#[inline(always)]
pub fn floor_of<S: Simd>(s: S, position: S::Floats) -> (S::Ints, S::Floats) {
    let nearest = s.nearest(position);
    let difference = s.sub_floats(position, s.to_floats(nearest));
    let is_below = s.lt_floats(difference, s.floats(0.0));
    (s.select(is_below, s.sub(nearest, s.ints(1)), nearest), difference)
}

/// The numbers of lanes.
const NUMBERS: [i32; LANES] = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15];
