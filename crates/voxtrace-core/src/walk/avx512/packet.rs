//! Packets of sixteen rays that start at one point and run along one octant. Coordinates are turned as `shared` says.

use super::cells::{Blocks, CellsOfLanes, Map, Memory};
use super::shared::Shared;
use super::vectors::{LANES, Mask, floor, lanes_of, load, loadf, or3, store, storef};
use crate::walk::exact;
use crate::walk::local_ray::{LocalRay, T_END_SCALE};
use crate::walk::scalar::Walk;
use glam::{IVec3, Vec3};
use std::arch::x86_64::*;

/// Sixteen rays, or some lanes of them.
#[repr(C, align(64))]
#[derive(Clone, Copy)]
pub struct Packet {
    /// Size of the direction and of its inverse along each axis.
    pub speed: [[f32; LANES]; 3],
    pub inverse: [[f32; LANES]; 3],
    pub t_max: [f32; LANES],
    t_end: [f32; LANES],
    /// Turned voxels.
    pub at: [[i32; LANES]; 3],
    /// Turned exit planes as of the last step that left a lane unsure.
    exit: [[i32; LANES]; 3],
    pub active: Mask,
    /// Lanes whose voxel is occupied.
    pub hit: Mask,
    memory: Memory<2>,
}

impl Packet {
    /// No rays.
    pub const EMPTY: Self = Self {
        speed: [[0.0; LANES]; 3],
        inverse: [[0.0; LANES]; 3],
        t_max: [0.0; LANES],
        t_end: [0.0; LANES],
        at: [[0; LANES]; 3],
        exit: [[0; LANES]; 3],
        active: 0,
        hit: 0,
        memory: Memory::NONE,
    };

    /// Takes rays of these directions and ends.
    #[inline]
    #[target_feature(enable = "avx512f,avx512dq,avx512bw,avx512vl,popcnt,bmi1,bmi2,lzcnt,fma,avx2")]
    pub fn set_rays(&mut self, direction: [__m512; 3], t_max: __m512) {
        for axis in 0..3 {
            let speed = _mm512_abs_ps(direction[axis]);
            storef(&mut self.speed[axis], speed);
            storef(&mut self.inverse[axis], _mm512_div_ps(_mm512_set1_ps(1.0), speed));
        }
        storef(&mut self.t_max, t_max);
        let t_end = _mm512_mul_ps(t_max, _mm512_set1_ps(T_END_SCALE));
        storef(&mut self.t_end, _mm512_min_ps(t_end, _mm512_set1_ps(f32::MAX)));
    }

    /// The least and the largest slope, movement along `axis` for each movement along `main`, of some lanes.
    #[inline]
    #[target_feature(enable = "avx512f,avx512dq,avx512bw,avx512vl,popcnt,bmi1,bmi2,lzcnt,fma,avx2")]
    pub fn slopes(&self, lanes: Mask, main: usize, axis: usize) -> [f32; 2] {
        let slope = _mm512_mul_ps(loadf(&self.speed[axis]), loadf(&self.inverse[main]));
        [_mm512_mask_reduce_min_ps(lanes, slope), _mm512_mask_reduce_max_ps(lanes, slope)]
    }

    /// Puts some lanes where they cross a turned plane of the main axis, before which they meet nothing; at the origin
    /// where it is not ahead of that.
    #[inline]
    #[target_feature(enable = "avx512f,avx512dq,avx512bw,avx512vl,popcnt,bmi1,bmi2,lzcnt,fma,avx2")]
    pub fn start(&mut self, shared: &Shared, map: &Map, lanes: Mask, plane: i32) {
        let (main, vectors) = (shared.main, &shared.vectors);
        self.memory.clear();
        self.active = lanes;
        self.hit = 0;
        let distance = (plane + shared.grid[main]) as f32 - shared.turned[main];
        let mut unsure = 0;
        let mut outside = 0;
        for axis in 0..3 {
            let at = if distance > 0.0 {
                let t = _mm512_mul_ps(_mm512_set1_ps(distance), loadf(&self.inverse[main]));
                self.active &= _mm512_cmp_ps_mask::<_CMP_LE_OQ>(t, loadf(&self.t_end));
                if axis == main {
                    _mm512_set1_epi32(plane)
                } else {
                    let position = _mm512_fmadd_ps(loadf(&self.speed[axis]), t, vectors.from_grid[axis]);
                    unsure |= is_near_plane(position, vectors.sure[axis]);
                    floor(position)
                }
            } else {
                _mm512_set1_epi32((shared.origin[axis].floor() as i32 - map.grid().origin[axis]) ^ shared.turn[axis])
            };
            outside |= _mm512_cmplt_epi32_mask(at, _mm512_set1_epi32(shared.start[axis]));
            store(&mut self.at[axis], at);
        }
        for lane in lanes_of(unsure & self.active) {
            self.start_exactly(shared, map, lane, plane);
        }
        unsure |= self.enter_together(shared, outside & self.active & !unsure);
        for lane in lanes_of(unsure & self.active) {
            self.enter(shared, map, lane);
        }
    }

    /// Takes lanes that are before the grid to their first voxels inside, as [`Walk::enter`] does. Returns those that f32 is not sure about, which stay
    /// where they are.
    #[inline]
    #[target_feature(enable = "avx512f,avx512dq,avx512bw,avx512vl,popcnt,bmi1,bmi2,lzcnt,fma,avx2")]
    fn enter_together(&mut self, shared: &Shared, lanes: Mask) -> Mask {
        if lanes == 0 {
            return 0;
        }
        // Before along an axis means a whole half-space is empty; of several axes take the plane crossed last.
        let mut latest = _mm512_set1_ps(f32::NEG_INFINITY);
        let mut crossed = [0; 3];
        for axis in 0..3 {
            let before =
                _mm512_mask_cmplt_epi32_mask(lanes, load(&self.at[axis]), _mm512_set1_epi32(shared.start[axis]));
            let distance = (shared.start[axis] + shared.grid[axis]) as f32 - shared.turned[axis];
            let t = _mm512_mul_ps(_mm512_set1_ps(distance), loadf(&self.inverse[axis]));
            let is_later = _mm512_mask_cmp_ps_mask::<_CMP_GT_OQ>(before, t, latest);
            latest = _mm512_mask_mov_ps(latest, is_later, t);
            for crossed in &mut crossed {
                *crossed &= !is_later;
            }
            crossed[axis] = is_later;
        }
        let arriving = _mm512_mask_cmp_ps_mask::<_CMP_LE_OQ>(lanes, latest, loadf(&self.t_end));
        self.active &= !lanes | arriving;
        let (mut at, mut unsure) = ([_mm512_setzero_si512(); 3], 0);
        for axis in 0..3 {
            let position = _mm512_fmadd_ps(loadf(&self.speed[axis]), latest, shared.vectors.from_grid[axis]);
            unsure |= is_near_plane(position, shared.vectors.sure[axis]) & !crossed[axis];
            let first = _mm512_set1_epi32(shared.start[axis]);
            at[axis] = _mm512_mask_mov_epi32(floor(position), crossed[axis], first);
            // Rounding may have taken it for a plane that is crossed before.
            unsure |= _mm512_cmplt_epi32_mask(at[axis], first);
        }
        unsure &= arriving;
        for axis in 0..3 {
            let before = load(&self.at[axis]);
            store(&mut self.at[axis], _mm512_mask_mov_epi32(before, arriving & !unsure, at[axis]));
        }
        unsure
    }

    /// Where the lanes are.
    #[inline]
    #[target_feature(enable = "avx512f,avx512dq,avx512bw,avx512vl,popcnt,bmi1,bmi2,lzcnt,fma,avx2")]
    fn locate(&mut self, shared: &Shared, map: &Map) -> Place {
        let vectors = &shared.vectors;
        let at = [load(&self.at[0]), load(&self.at[1]), load(&self.at[2])];
        let mut inside = self.active;
        for axis in 0..3 {
            inside = _mm512_mask_cmplt_epi32_mask(inside, at[axis], vectors.end[axis]);
        }
        let voxel = [
            _mm512_xor_si512(at[0], vectors.turn[0]),
            _mm512_xor_si512(at[1], vectors.turn[1]),
            _mm512_xor_si512(at[2], vectors.turn[2]),
        ];
        Place { at, voxel, inside, cells: self.memory.cells(map, &shared.skip_distances, inside, voxel) }
    }

    /// The empty boxes around the lanes, and which lanes are in a voxel.
    ///
    /// # Safety
    /// The scene of the map must be valid.
    #[inline]
    #[target_feature(enable = "avx512f,avx512dq,avx512bw,avx512vl,popcnt,bmi1,bmi2,lzcnt,fma,avx2")]
    unsafe fn look(&mut self, shared: &Shared, map: &Map, place: &Place) -> View {
        let (one, three) = (_mm512_set1_epi32(1), _mm512_set1_epi32(3));
        let (tables, cells) = (shared.vectors.tables, &place.cells);
        let [x, y, z] = place.voxel;
        let block = block_of(place.voxel);
        let ahead = _mm512_permutexvar_epi32(block, load(&tables.blocks));
        // SAFETY: the caller's duty.
        let Blocks { others_ahead, low, high } =
            unsafe { self.memory.blocks(map, cells.in_brick, cells.cell, block, ahead) };
        let column = _mm512_or_si512(_mm512_and_si512(x, three), _mm512_slli_epi32::<2>(_mm512_and_si512(y, three)));
        let layer = _mm512_and_si512(z, three);
        let columns = _mm512_permutexvar_epi32(column, load(&tables.columns));
        let low_ahead = _mm512_and_si512(low, _mm512_permutexvar_epi32(layer, load(&tables.layers[0])));
        let high_ahead = _mm512_and_si512(high, _mm512_permutexvar_epi32(layer, load(&tables.layers[1])));
        let is_ahead = _mm512_mask_test_epi32_mask(cells.in_brick, _mm512_or_si512(low_ahead, high_ahead), columns);
        // The half of the block that holds the voxel.
        let is_upper = _mm512_test_epi32_mask(z, _mm512_set1_epi32(2));
        let half = _mm512_mask_mov_epi32(low, is_upper, high);
        let bit = _mm512_or_si512(column, _mm512_slli_epi32::<4>(_mm512_and_si512(z, one)));
        let hit = _mm512_mask_test_epi32_mask(is_ahead, _mm512_srlv_epi32(half, bit), one);
        let corner = _mm512_and_si512(bit, _mm512_set1_epi32(0b01010));
        let eight = _mm512_srlv_epi32(half, corner);
        let is_small = _mm512_mask_test_epi32_mask(is_ahead, eight, _mm512_set1_epi32(0x0033_0033));
        let mut shift = _mm512_mask_mov_epi32(cells.shift, others_ahead, _mm512_set1_epi32(2));
        shift = _mm512_mask_mov_epi32(shift, is_ahead, one);
        shift = _mm512_mask_mov_epi32(shift, is_small, _mm512_setzero_si512());
        View { shift, hit }
    }

    /// Where the lanes leave their boxes.
    #[inline]
    #[target_feature(enable = "avx512f,avx512dq,avx512bw,avx512vl,popcnt,bmi1,bmi2,lzcnt,fma,avx2")]
    fn leave(&self, shared: &Shared, place: &Place, view: &View) -> Exit {
        let vectors = &shared.vectors;
        let mut exit = [_mm512_setzero_si512(); 3];
        let mut plane = [_mm512_setzero_ps(); 3];
        let mut t = [_mm512_setzero_ps(); 3];
        for axis in 0..3 {
            let last = _mm512_add_epi32(_mm512_srav_epi32(place.at[axis], view.shift), place.cells.skip_distance);
            exit[axis] = _mm512_sllv_epi32(last, view.shift);
            plane[axis] = _mm512_cvtepi32_ps(_mm512_add_epi32(exit[axis], vectors.grid[axis]));
            t[axis] = _mm512_mul_ps(_mm512_sub_ps(plane[axis], vectors.turned[axis]), loadf(&self.inverse[axis]));
        }
        let first = _mm512_min_ps(t[0], _mm512_min_ps(t[1], t[2]));
        let on_x = _mm512_cmp_ps_mask::<_CMP_EQ_OQ>(t[0], first);
        let off_x = _mm512_cmp_ps_mask::<_CMP_NEQ_UQ>(t[0], first);
        let on_y = _mm512_mask_cmp_ps_mask::<_CMP_EQ_OQ>(off_x, t[1], first);
        let on_z = _mm512_mask_cmp_ps_mask::<_CMP_NEQ_UQ>(off_x, t[1], first);
        let going = _mm512_mask_cmp_ps_mask::<_CMP_LE_OQ>(place.inside & !view.hit, first, loadf(&self.t_end));
        Exit { exit, plane, first, on_axis: [on_x, on_y, on_z], going }
    }

    /// Puts the lanes where they arrive.
    #[inline]
    #[target_feature(enable = "avx512f,avx512dq,avx512bw,avx512vl,popcnt,bmi1,bmi2,lzcnt,fma,avx2")]
    fn arrive(&mut self, shared: &Shared, map: &Map, place: &Place, view: &View, exit: &Exit) {
        let vectors = &shared.vectors;
        let mut unsure = 0;
        let mut arrival = [_mm512_setzero_si512(); 3];
        for axis in 0..3 {
            let position = _mm512_fmadd_ps(loadf(&self.speed[axis]), exit.first, vectors.from_grid[axis]);
            // Surely beyond the plane that is crossed.
            let position = _mm512_mask_add_ps(position, exit.on_axis[axis], exit.plane[axis], vectors.to_middle[axis]);
            unsure |= is_near_plane(position, vectors.sure[axis]);
            arrival[axis] = floor(position);
        }
        unsure &= exit.going;
        let sure = exit.going & !unsure;
        for axis in 0..3 {
            store(&mut self.at[axis], _mm512_mask_mov_epi32(place.at[axis], sure, arrival[axis]));
        }
        self.active = exit.going;
        self.hit |= view.hit;
        if unsure != 0 {
            for axis in 0..3 {
                store(&mut self.exit[axis], exit.exit[axis]);
            }
            for lane in lanes_of(unsure) {
                self.decide(shared, map, lane);
            }
        }
    }

    /// Takes the step of a lane that f32 is not sure about.
    #[cold]
    fn decide(&mut self, shared: &Shared, map: &Map, lane: usize) {
        let exit = shared.real_plane(std::array::from_fn(|axis| self.exit[axis][lane]));
        let local = self.local(shared, lane);
        match exact::leave_box(&local, self.voxel(shared, map, lane), exit) {
            Some(voxel) => self.put(shared, map, lane, voxel),
            // A local ray crosses some plane of every box.
            None => self.active &= !(1 << lane),
        }
    }

    /// Puts a lane where it crosses a plane of the main axis.
    #[cold]
    fn start_exactly(&mut self, shared: &Shared, map: &Map, lane: usize, plane: i32) {
        // Half of the range: nothing may overflow.
        let mut exit = [i32::MAX / 4; 3];
        exit[shared.main] = plane;
        let local = self.local(shared, lane);
        let start = shared.origin.floor().as_ivec3();
        match exact::leave_box(&local, start, shared.real_plane(exit)) {
            Some(voxel) => self.put(shared, map, lane, voxel),
            None => self.active &= !(1 << lane),
        }
    }

    /// Takes a lane that may be outside of the grid to its first voxel inside.
    #[cold]
    fn enter(&mut self, shared: &Shared, map: &Map, lane: usize) {
        let local = self.local(shared, lane);
        let entered = Walk::new(&local, map.grid()).enter(map.grid(), self.voxel(shared, map, lane));
        match entered {
            Some(voxel) => self.put(shared, map, lane, voxel),
            None => self.active &= !(1 << lane),
        }
    }

    /// The ray of a lane.
    fn local(&self, shared: &Shared, lane: usize) -> LocalRay {
        let turn = |sizes: &[[f32; LANES]; 3]| {
            Vec3::from_array(std::array::from_fn(|axis| shared.turn_float(axis, sizes[axis][lane])))
        };
        LocalRay {
            origin: shared.origin,
            direction: turn(&self.speed),
            inverse: turn(&self.inverse),
            t_min: 0.0,
            t_max: self.t_max[lane],
        }
    }

    /// The voxel of a lane, in the grid's own coordinates.
    fn voxel(&self, shared: &Shared, map: &Map, lane: usize) -> IVec3 {
        let relative = std::array::from_fn(|axis| self.at[axis][lane] ^ shared.turn[axis]);
        IVec3::from_array(relative) + map.grid().origin
    }

    /// Puts a lane into a voxel.
    fn put(&mut self, shared: &Shared, map: &Map, lane: usize, voxel: IVec3) {
        let relative = voxel - map.grid().origin;
        for axis in 0..3 {
            self.at[axis][lane] = relative[axis] ^ shared.turn[axis];
        }
    }
}

/// Where lanes are.
#[derive(Clone, Copy)]
struct Place {
    /// Turned voxels, and voxels from the grid's origin.
    at: [__m512i; 3],
    voxel: [__m512i; 3],
    inside: Mask,
    cells: CellsOfLanes,
}

/// What lanes see from there.
#[derive(Clone, Copy)]
struct View {
    /// log₂ of the size of the cells of which the empty box is made.
    shift: __m512i,
    /// Lanes in a voxel.
    hit: Mask,
}

/// Where lanes leave the boxes around them.
#[derive(Clone, Copy)]
struct Exit {
    /// Turned planes, from the grid's origin and from the world's.
    exit: [__m512i; 3],
    plane: [__m512; 3],
    /// When the first of them is crossed, and which it is.
    first: __m512,
    on_axis: [Mask; 3],
    going: Mask,
}

/// Takes one step with all active lanes of packets. Stage by stage: while one packet waits the other computes.
///
/// # Safety
/// The scene of the map must be valid.
#[inline]
#[target_feature(enable = "avx512f,avx512dq,avx512bw,avx512vl,popcnt,bmi1,bmi2,lzcnt,fma,avx2")]
pub unsafe fn step(packets: [&mut Packet; 2], shared: &Shared, map: &Map) {
    let [a, b] = packets;
    let places = [a.locate(shared, map), b.locate(shared, map)];
    // SAFETY: the caller's duty.
    let views = unsafe { [a.look(shared, map, &places[0]), b.look(shared, map, &places[1])] };
    let exits = [a.leave(shared, &places[0], &views[0]), b.leave(shared, &places[1], &views[1])];
    a.arrive(shared, map, &places[0], &views[0], &exits[0]);
    b.arrive(shared, map, &places[1], &views[1], &exits[1]);
}

/// The number of the block of 4³ voxels in its brick.
#[inline]
#[target_feature(enable = "avx512f")]
pub fn block_of([x, y, z]: [__m512i; 3]) -> __m512i {
    or3(
        _mm512_and_si512(_mm512_srli_epi32::<2>(x), _mm512_set1_epi32(1)),
        _mm512_and_si512(_mm512_srli_epi32::<1>(y), _mm512_set1_epi32(2)),
        _mm512_and_si512(z, _mm512_set1_epi32(4)),
    )
}

/// Lanes whose coordinate may be on either side of an integer: those not nearer to the middle of a voxel than `sure`.
#[inline]
#[target_feature(enable = "avx512f,avx512dq")]
fn is_near_plane(position: __m512, sure: __m512) -> Mask {
    let fraction = _mm512_reduce_ps::<{ _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC }>(position);
    let from_middle = _mm512_abs_ps(_mm512_sub_ps(fraction, _mm512_set1_ps(0.5)));
    // True for what is no number, too.
    _mm512_cmp_ps_mask::<_CMP_NLT_UQ>(from_middle, sure)
}
