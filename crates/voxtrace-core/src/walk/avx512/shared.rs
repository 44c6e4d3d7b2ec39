//! What packets from one point along one octant share.
//!
//! Coordinates are turned: mirrored so that all rays run towards +. A turned coordinate counts from the grid's origin where
//! it is an integer, from the world's where it is a float; mirroring is exact for both (`!x` for voxels, `-x` for planes).

use super::cells::{Map, SkipDistances};
use super::octant::{OCTANTS, Octant};
use crate::walk::local_ray::TOLERANCE_SCALE;
use glam::{IVec3, Vec3};
use std::arch::x86_64::*;

/// What packets from one point along one octant share.
pub struct Shared {
    pub origin: Vec3,
    pub octant: usize,
    /// The axis along which the beams of the packets are followed.
    pub main: usize,
    /// All bits set along axes where the direction is negative: turns voxels.
    pub turn: [i32; 3],
    /// The origin, turned.
    pub turned: [f32; 3],
    /// The origin of the grid, turned.
    pub grid: [i32; 3],
    /// The first and the last turned voxel but one of the grid.
    pub start: [i32; 3],
    pub end: [i32; 3],
    pub skip_distances: SkipDistances,
    pub vectors: Vectors,
}

/// The same for all lanes, ready for the steps.
pub struct Vectors {
    pub turn: [__m512i; 3],
    pub turned: [__m512; 3],
    pub grid: [__m512i; 3],
    pub end: [__m512i; 3],
    /// The origin as seen from the grid's, and what takes a plane to the middle of the voxel behind it as seen from there.
    pub from_grid: [__m512; 3],
    pub to_middle: [__m512; 3],
    /// How far from the middle of a voxel f32 is sure.
    pub sure: [__m512; 3],
    pub tables: &'static Octant,
}

impl Shared {
    /// What packets share that start at `origin`.
    #[inline]
    #[target_feature(enable = "avx512f,avx512dq,avx512bw,avx512vl,popcnt,bmi1,bmi2,lzcnt,fma,avx2")]
    pub fn new(map: &Map, origin: Vec3, octant: usize, main: usize) -> Self {
        let turn: [i32; 3] = std::array::from_fn(|axis| -((octant >> axis & 1) as i32));
        let mirror = |axis: usize, x: f32| if turn[axis] != 0 { -x } else { x };
        let turned = std::array::from_fn(|axis| mirror(axis, origin[axis]));
        let size = map.size();
        let grid: [i32; 3] = std::array::from_fn(|axis| (map.grid().origin[axis] ^ turn[axis]) - turn[axis]);
        let start = std::array::from_fn(|axis| size[axis] & turn[axis]).map(|x: i32| -x);
        let end: [i32; 3] = std::array::from_fn(|axis| start[axis] + size[axis]);
        // Coordinates count from the grid's origin and from the world's.
        let tolerance: [f32; 3] = std::array::from_fn(|axis| {
            (origin[axis].abs() + grid[axis].abs() as f32 + size[axis] as f32 + 1.0) * TOLERANCE_SCALE
        });
        let vectors = Vectors {
            turn: each!(x in [turn[0], turn[1], turn[2]] => _mm512_set1_epi32(x)),
            turned: each!(x in [turned[0], turned[1], turned[2]] => _mm512_set1_ps(x)),
            grid: each!(x in [grid[0], grid[1], grid[2]] => _mm512_set1_epi32(x)),
            end: each!(x in [end[0], end[1], end[2]] => _mm512_set1_epi32(x)),
            from_grid: each!(axis in [0, 1, 2] => _mm512_set1_ps(turned[axis] - grid[axis] as f32)),
            to_middle: each!(x in [grid[0], grid[1], grid[2]] => _mm512_set1_ps(0.5 - x as f32)),
            sure: each!(tolerance in [tolerance[0], tolerance[1], tolerance[2]] => _mm512_set1_ps(0.5 - tolerance)),
            tables: &OCTANTS[octant],
        };
        Self {
            origin,
            octant,
            main,
            turn,
            turned,
            grid,
            start,
            end,
            skip_distances: SkipDistances::new(octant),
            vectors,
        }
    }

    /// A number along an axis, turned or turned back.
    #[inline]
    pub fn turn_float(&self, axis: usize, x: f32) -> f32 {
        if self.turn[axis] != 0 { -x } else { x }
    }

    /// Planes in the grid's own coordinates.
    pub fn real_plane(&self, turned: [i32; 3]) -> IVec3 {
        IVec3::from_array(std::array::from_fn(|axis| {
            ((turned[axis] + self.grid[axis]) ^ self.turn[axis]) - self.turn[axis]
        }))
    }
}
