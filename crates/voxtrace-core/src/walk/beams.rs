//! Camera rays that follow each other are followed together through the empty space before them, ray by ray only from where that ends (after
//! the entry points of Reshetov, Soupikov, Hurley, "Multi-Level Ray Tracing Algorithm", SIGGRAPH 2005). Packets of AVX-512 have beams of
//! their own.
//!
//! A beam is the rectangle in which its rays cross a plane of their main axis. Empty boxes around its corners say how far all of it may go. All of
//! that is conservative: where a beam stops only decides where the exact walk of its rays begins.
//!
//! Coordinates are turned here: mirrored so that all rays run towards +, counted from the grid's origin, the main axis first.

use super::local_ray::{MAX_ORIGIN, SPEED_MAX, SPEED_MIN};
use super::scalar::{Around, Empty, Place};
use super::simd::LANES;
use crate::packed::{Geometry, PackedGrid};
use glam::{IVec3, Vec3};
use voxtrace_scene::ray::Ray;

/// Groups of rays that are first followed together: eight by eight pixels.
const GROUPS: usize = 4;
/// Steps that a beam takes at most.
const MOST_STEPS: usize = 64;
/// A plane that is never reached.
const FAR: i32 = 1 << 28;
/// How much wider a beam is than its rays, voxels: far more than all roundings of f64.
const MARGIN: f64 = 1e-6;

/// Where rays begin.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Entry {
    /// Where they start.
    Start,
    /// Where they cross a plane ahead of their start, before which they meet nothing.
    Plane {
        /// The axis that it is across.
        axis: usize,
        /// Its place, grid space.
        plane: i32,
    },
    /// They meet nothing at all.
    Never,
}

/// Where groups of sixteen rays through a grid that is not transformed begin.
pub struct Beams<'a> {
    cells: &'a [u32],
    bricks: &'a [u32],
    grid: &'a PackedGrid,
    rays: &'a [Ray],
    /// The groups that were followed last.
    followed: usize,
    entries: [Entry; GROUPS],
}

impl<'a> Beams<'a> {
    /// Those of some rays.
    pub fn new(geometry: &'a Geometry, grid: &'a PackedGrid, rays: &'a [Ray]) -> Self {
        let (cells, bricks): (&[u32], &[u32]) = (&geometry.cells, &geometry.bricks);
        Self { cells, bricks, grid, rays, followed: usize::MAX, entries: [Entry::Start; GROUPS] }
    }

    /// Where the rays of a group begin.
    #[inline]
    pub fn entry(&mut self, group: usize) -> Entry {
        let first = group / GROUPS * GROUPS * LANES;
        let rays = &self.rays[first..self.rays.len().min(first + GROUPS * LANES)];
        // Bounced rays have nothing in common.
        if rays.len() < 2 || rays[0].origin != rays[1].origin {
            return Entry::Start;
        }
        if self.followed != group / GROUPS {
            self.followed = group / GROUPS;
            self.follow(rays);
        }
        self.entries[group % GROUPS]
    }

    /// Follows some groups, together as long as they can be.
    #[inline(never)]
    fn follow(&mut self, rays: &[Ray]) {
        self.entries = [Entry::Start; GROUPS];
        let main = rays[0].direction.abs().max_position();
        let octant = octant_of(rays[0].direction);
        let groups = rays.chunks(LANES).map(|group| Slopes::of(group, rays[0].origin, octant, main));
        let mut slopes = [None; GROUPS];
        slopes.iter_mut().zip(groups).for_each(|(slopes, group)| *slopes = group);
        let Some(all) = slopes.iter().flatten().copied().reduce(Slopes::with) else { return };
        let mut beam = Beam::new((self.cells, self.bricks), self.grid, rays[0].origin, octant, main);
        beam.follow(all);
        let together = beam.reached;
        for (entry, slopes) in self.entries.iter_mut().zip(slopes) {
            if let Some(slopes) = slopes {
                beam.reached = together;
                beam.follow(slopes);
                *entry = beam.entry();
            }
        }
    }
}

/// Bit a is set where a direction is negative along axis a.
fn octant_of(direction: Vec3) -> usize {
    direction.cmplt(Vec3::ZERO).bitmask() as usize
}

/// Least and largest movement along the two minor axes for each voxel along the main axis.
#[derive(Clone, Copy)]
struct Slopes {
    low: [f64; 2],
    high: [f64; 2],
}

impl Slopes {
    /// Those of rays that start at one point, along one octant; `None` where they do not, or where one needs special care: that has no segment, or moves
    /// along an axis not at all, or at no sensible speed.
    #[inline]
    fn of(rays: &[Ray], origin: Vec3, octant: usize, main: usize) -> Option<Self> {
        let mut slopes = Self { low: [f64::INFINITY; 2], high: [0.0; 2] };
        if !origin.abs().cmple(Vec3::splat(MAX_ORIGIN)).all() {
            return None;
        }
        for ray in rays {
            let speed = ray.direction.abs();
            let is_sensible = speed.cmpge(Vec3::splat(SPEED_MIN)).all() && speed.cmple(Vec3::splat(SPEED_MAX)).all();
            let has_segment = (0.0..=f32::MAX).contains(&ray.t_min) && ray.t_min <= ray.t_max;
            if ray.origin != origin || !has_segment || !is_sensible || octant_of(ray.direction) != octant {
                return None;
            }
            let inverse = 1.0 / f64::from(speed[main]);
            for minor in 0..2 {
                let slope = f64::from(speed[(main + 1 + minor) % 3]) * inverse;
                slopes.low[minor] = slopes.low[minor].min(slope);
                slopes.high[minor] = slopes.high[minor].max(slope);
            }
        }
        Some(slopes)
    }

    /// Those of more rays.
    fn with(self, other: Self) -> Self {
        let (mut low, mut high) = (self.low, self.high);
        for minor in 0..2 {
            (low[minor], high[minor]) = (low[minor].min(other.low[minor]), high[minor].max(other.high[minor]));
        }
        Self { low, high }
    }
}

/// Rays that are followed together.
struct Beam<'a> {
    arrays: (&'a [u32], &'a [u32]),
    grid: &'a PackedGrid,
    octant: usize,
    main: usize,
    /// All bits set along axes that are mirrored.
    turn: [i32; 3],
    origin: [f64; 3],
    /// The grid's first voxel, and the one past its last.
    start: [i32; 3],
    end: [i32; 3],
    reached: Reached,
    corners: [Place; 4],
}

/// How far a beam has met nothing.
#[derive(Clone, Copy)]
struct Reached {
    /// Voxels along the main axis.
    distance: f64,
    /// The layer of voxels there.
    layer: i32,
    /// Whether it left the grid.
    is_out: bool,
}

/// An empty box: its first voxel, and the one past its last.
#[derive(Clone, Copy)]
struct Clear {
    low: [i32; 3],
    exit: [i32; 3],
}

impl<'a> Beam<'a> {
    fn new(arrays: (&'a [u32], &'a [u32]), grid: &'a PackedGrid, origin: Vec3, octant: usize, main: usize) -> Self {
        let axis = |place: usize| (main + place) % 3;
        let turn: [i32; 3] = std::array::from_fn(|place| -((octant >> axis(place) & 1) as i32));
        let bounds: [(i32, i32); 3] = std::array::from_fn(|place| {
            let axis = axis(place);
            let (min, max) = (grid.min[axis] - grid.origin[axis], grid.max[axis] - grid.origin[axis]);
            if turn[place] == 0 { (min, max) } else { (-max, -min) }
        });
        let origin: [f64; 3] = std::array::from_fn(|place| {
            let origin = f64::from(origin[axis(place)]) - f64::from(grid.origin[axis(place)]);
            if turn[place] == 0 { origin } else { -origin }
        });
        Self {
            arrays,
            grid,
            octant,
            main,
            turn,
            origin,
            start: [bounds[0].0, bounds[1].0, bounds[2].0],
            end: [bounds[0].1, bounds[1].1, bounds[2].1],
            reached: Reached { distance: 0.0, layer: floor(origin[0] - MARGIN), is_out: false },
            corners: std::array::from_fn(|_| Place::at(IVec3::ZERO)),
        }
    }

    /// Follows rays as far as nothing is in their way.
    #[inline]
    fn follow(&mut self, slopes: Slopes) {
        let inverse = [1.0 / slopes.high[0], 1.0 / slopes.high[1]];
        let [main, u, v] = self.origin;
        for _ in 0..MOST_STEPS {
            let Reached { distance, layer, .. } = self.reached;
            let low = [floor(u - MARGIN + slopes.low[0] * distance), floor(v - MARGIN + slopes.low[1] * distance)];
            let high = [floor(u + MARGIN + slopes.high[0] * distance), floor(v + MARGIN + slopes.high[1] * distance)];
            let Some(exit) = self.exit(low, high) else { return };
            if exit == [FAR; 3] {
                self.reached.is_out = true;
                return;
            }
            let straight = f64::from(exit[0]) - main;
            let sideways =
                ((f64::from(exit[1]) - MARGIN - u) * inverse[0]).min((f64::from(exit[2]) - MARGIN - v) * inverse[1]);
            let next = straight.min(sideways);
            if next <= distance {
                return;
            }
            let within = floor(main + next - MARGIN).max(layer).min(exit[0] - 1);
            self.reached.layer = if straight <= sideways { exit[0] } else { within };
            self.reached.distance = next;
        }
    }

    /// Where the beam leaves the empty boxes around the corners of its rectangle; `None` where they do not cover it.
    #[inline]
    fn exit(&mut self, low: [i32; 2], high: [i32; 2]) -> Option<[i32; 3]> {
        let near = self.clear(0, [self.reached.layer, low[0], low[1]])?;
        let covers = [near.exit[1] > high[0], near.exit[2] > high[1]];
        if covers[0] && covers[1] {
            return Some(near.exit);
        }
        // Boxes that hold the other corners.
        let u = if covers[0] { near } else { self.clear(1, [self.reached.layer, high[0], low[1]])? };
        let v = if covers[1] { near } else { self.clear(2, [self.reached.layer, low[0], high[1]])? };
        let both = match (u.exit[2] > high[1], v.exit[1] > high[0]) {
            (true, _) => u,
            (_, true) => v,
            _ => self.clear(3, [self.reached.layer, high[0], high[1]])?,
        };
        // Each place across is in a nearer box or in a farther one, and what leaves a nearer one sideways enters a farther one.
        let touch = near.exit[1].min(v.exit[1]) >= u.low[1].max(both.low[1])
            && near.exit[2].min(u.exit[2]) >= v.low[2].max(both.low[2]);
        touch.then(|| {
            let straight = near.exit[0].min(u.exit[0]).min(v.exit[0]).min(both.exit[0]);
            [straight, u.exit[1].min(both.exit[1]), v.exit[2].min(both.exit[2])]
        })
    }

    /// The empty box around a voxel and ahead of it; `None` where the voxel is occupied.
    #[inline]
    fn clear(&mut self, corner: usize, at: [i32; 3]) -> Option<Clear> {
        let (start, end) = (self.start, self.end);
        if at[0] >= end[0] || at[1] >= end[1] || at[2] >= end[2] {
            return Some(Clear { low: at, exit: [FAR; 3] });
        }
        if at[0] < start[0] || at[1] < start[1] || at[2] < start[2] {
            // Outside along an axis means a whole half-space is empty.
            let exit = |place: usize| if at[place] < start[place] { start[place] } else { FAR };
            return Some(Clear { low: [-FAR; 3], exit: [exit(0), exit(1), exit(2)] });
        }
        let [x, y, z] = [at[0] ^ self.turn[0], at[1] ^ self.turn[1], at[2] ^ self.turn[2]];
        let relative = match self.main {
            0 => IVec3::new(x, y, z),
            1 => IVec3::new(z, x, y),
            _ => IVec3::new(y, z, x),
        };
        match self.corners[corner].around(self.arrays, self.grid, relative, self.octant) {
            Around::Empty(Empty { own, shift, count }) => {
                let low = |place: usize| at[place] >> own << own;
                let exit = |place: usize| ((at[place] >> shift) + count) << shift;
                Some(Clear { low: [low(0), low(1), low(2)], exit: [exit(0), exit(1), exit(2)] })
            }
            Around::Voxel | Around::Nothing => None,
        }
    }

    /// Where its rays begin.
    fn entry(&self) -> Entry {
        let Reached { layer, is_out, .. } = self.reached;
        if is_out {
            return Entry::Never;
        }
        let (axis, turn) = (self.main, self.turn[0]);
        match f64::from(layer) > self.origin[0] {
            true => Entry::Plane { axis, plane: (layer ^ turn) - turn + self.grid.origin[axis] },
            false => Entry::Start,
        }
    }
}

/// The integer below a number, or the one that is nearest to it: without an instruction of its own, which the oldest processors lack.
#[inline(always)]
fn floor(x: f64) -> i32 {
    let towards_zero = x as i32;
    towards_zero - i32::from(f64::from(towards_zero) > x)
}
