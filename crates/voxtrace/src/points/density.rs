//! How fine a grid the points of a cloud fill: as fine as surfaces stay closed. The share of points that are alone in their
//! cell estimates the chance that one more point would fall into an empty cell, that is the holes (Good, "The population
//! frequencies of species and the estimation of population parameters", 1953). Dense places count as much as they have points.

use super::{PointCloud, bounds};
use glam::{DVec3, UVec3, Vec3};
use rayon::prelude::*;

/// Cells along the longest side of the finest and the coarsest grid that are chosen.
pub(crate) const FINEST: u32 = 2048;
pub(crate) const COARSEST: u32 = 16;
/// Points that may be alone: with points at random as many voxels of a surface are missing.
const ALONE: f64 = 0.03;
/// Bits of a coordinate. Points in one of the smallest cells are one point that was measured more than once.
const BITS: u32 = 16;
/// About so many points are looked at; they are all that there are in some cells of a coarse grid.
const ENOUGH: u64 = 1 << 20;
/// Bits of a coordinate of the coarse grid.
const COARSE_BITS: u32 = 6;
const COARSE_CELLS: u32 = 1 << COARSE_BITS;

/// Cells along the longest side with which surfaces through the points are just closed, [`COARSEST`] to [`FINEST`].
pub(crate) fn suited_resolution(cloud: &PointCloud) -> u32 {
    let codes = codes(&cloud.positions);
    let share = |level: u32| alone_share(&codes, 3 * (BITS - level));
    let (mut level, mut before) = (COARSEST.ilog2(), 0.0);
    while level < BITS {
        let found = share(level);
        if found > ALONE {
            // Between two grids the share grows about by a factor for each halving, from a half of a point on.
            let least = 0.5 / codes.len() as f64;
            let (low, high) = (f64::ln(f64::max(before, least)), f64::ln(f64::max(found, least)));
            let part = if high > low { ((ALONE.ln() - low) / (high - low)).clamp(0.0, 1.0) } else { 0.0 };
            return ((f64::from(level) - 1.0 + part).exp2().round() as u32).clamp(COARSEST, FINEST);
        }
        if 1 << level >= FINEST {
            break;
        }
        (level, before) = (level + 1, found);
    }
    FINEST
}

/// The different cells of the finest grid that hold the points looked at, in Morton order: cells of coarser grids are runs.
fn codes(positions: &[Vec3]) -> Vec<u64> {
    let Some((min, max)) = bounds(positions) else { return Vec::new() };
    let Some(lattice) = Lattice::over((min, max), positions.len() as u64) else { return Vec::new() };
    let mut codes: Vec<u64> = positions.par_iter().filter_map(|&point| lattice.code(point)).collect();
    codes.par_sort_unstable();
    codes.dedup();
    codes
}

/// The cells of the finest and of the coarse grid over a cloud.
struct Lattice {
    min: DVec3,
    /// Finest cells in a unit.
    factor: f64,
    /// A bit for each coarse cell, x lowest: whether its points are looked at.
    chosen: Vec<u64>,
}

impl Lattice {
    /// `None` where the points are one.
    fn over((min, max): (DVec3, DVec3), count: u64) -> Option<Self> {
        let longest = (max - min).max_element();
        if longest.is_nan() || longest <= 0.0 {
            return None;
        }
        let most = if count > ENOUGH { ENOUGH * (1 << 32) / count } else { 1 << 32 };
        let is_chosen = |cell: u64| {
            let cell = UVec3::from_array([0, 1, 2].map(|axis| (cell >> (axis * COARSE_BITS)) as u32 % COARSE_CELLS));
            u64::from(scrambled(spread(cell) as u32)) < most
        };
        let word = |word: u64| (0..64).filter(|bit| is_chosen(word * 64 + bit)).fold(0, |mask, bit| mask | 1 << bit);
        let chosen = (0..1 << (3 * COARSE_BITS - 6)).map(word).collect();
        Some(Self { min, factor: f64::from(1u32 << BITS) / longest, chosen })
    }

    /// The code of a point's finest cell, if the point is looked at.
    #[inline]
    fn code(&self, point: Vec3) -> Option<u64> {
        let most = f64::from((1u32 << BITS) - 1);
        let cell = ((point.as_dvec3() - self.min) * self.factor).min(DVec3::splat(most)).as_uvec3();
        let coarse = cell >> (BITS - COARSE_BITS);
        let at = coarse.z << (2 * COARSE_BITS) | coarse.y << COARSE_BITS | coarse.x;
        (self.chosen[at as usize / 64] >> (at % 64) & 1 != 0).then(|| spread(cell))
    }
}

/// The share of codes that share their upper bits with no other.
fn alone_share(codes: &[u64], lost: u32) -> f64 {
    let alone = codes.chunk_by(|a, b| a >> lost == b >> lost).filter(|cell| cell.len() == 1).count();
    alone as f64 / codes.len().max(1) as f64
}

/// A cell's coordinates with their bits taken in turn.
fn spread(cell: UVec3) -> u64 {
    let [x, y, z] = cell.to_array().map(|value| {
        let mut bits = u64::from(value);
        for (shift, mask) in [(16, 0x00ff_0000_ff00_00ff), (8, 0xf00f_00f0_0f00_f00f), (4, 0x30c3_0c30_c30c_30c3)] {
            bits = (bits | bits << shift) & mask;
        }
        (bits | bits << 2) & 0x9249_2492_4924_9249
    });
    x | y << 1 | z << 2
}

/// Numbers without order (the finalizer of MurmurHash3, Appleby 2011).
fn scrambled(mut value: u32) -> u32 {
    value = (value ^ value >> 16).wrapping_mul(0x85eb_ca6b);
    value = (value ^ value >> 13).wrapping_mul(0xc2b2_ae35);
    value ^ value >> 16
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cloud(positions: Vec<Vec3>) -> PointCloud {
        PointCloud { positions, ..PointCloud::default() }
    }

    /// Points at random on a sphere.
    fn sphere(count: u32) -> Vec<Vec3> {
        let random = |at: u32| scrambled(at.wrapping_mul(2_654_435_761) ^ 0x5bd1_e995) as f32 / u32::MAX as f32;
        let point = |at: u32| {
            let (z, turn) = (random(2 * at) * 2.0 - 1.0, random(2 * at + 1) * std::f32::consts::TAU);
            let circle = (1.0 - z * z).max(0.0).sqrt();
            Vec3::new(circle * turn.cos(), circle * turn.sin(), z)
        };
        (0..count).map(point).collect()
    }

    #[test]
    fn four_times_as_many_points_on_a_surface_bear_twice_the_resolution() {
        let found: Vec<u32> = [5_000, 20_000, 80_000].map(|count| suited_resolution(&cloud(sphere(count)))).into();
        for pair in found.windows(2) {
            let factor = f64::from(pair[1]) / f64::from(pair[0]);
            assert!((1.8..2.2).contains(&factor), "{found:?}");
        }
    }

    #[test]
    fn few_more_points_fall_into_an_empty_voxel_and_with_four_times_the_resolution_many() {
        let points = sphere(100_000);
        let (points, more) = points.split_at(50_000);
        let missed = |resolution: u32| {
            let cell = |point: &Vec3| ((*point + 1.0) * 0.5 * resolution as f32).as_ivec3().to_array();
            let cells: std::collections::BTreeSet<_> = points.iter().map(cell).collect();
            more.iter().filter(|point| !cells.contains(&cell(point))).count() as f64 / more.len() as f64
        };
        let resolution = suited_resolution(&cloud(points.to_vec()));
        assert!((0.02..0.04).contains(&missed(resolution)), "{resolution}: {}", missed(resolution));
        assert!(missed(resolution * 4) > 0.5);
    }

    #[test]
    fn points_measured_twice_are_one_and_of_large_clouds_a_part_tells_all() {
        let points = sphere(60_000);
        let once = suited_resolution(&cloud(points.clone()));
        assert_eq!(suited_resolution(&cloud([points.clone(), points].concat())), once);
        let (large, small) = (suited_resolution(&cloud(sphere(4 << 20))), suited_resolution(&cloud(sphere(1 << 20))));
        let factor = f64::from(large) / f64::from(small);
        assert!((1.8..2.2).contains(&factor), "{large} {small}");
    }

    #[test]
    fn the_coarsest_and_the_finest_grid_bound_the_choice() {
        assert_eq!(suited_resolution(&cloud(vec![Vec3::ZERO, Vec3::ONE, Vec3::X])), COARSEST);
        assert_eq!(suited_resolution(&cloud(vec![Vec3::ONE; 5])), FINEST);
        let line = (0..1 << 17).map(|at| Vec3::X * at as f32).collect();
        assert_eq!(suited_resolution(&cloud(line)), FINEST);
    }

    #[test]
    fn bits_are_taken_in_turn() {
        assert_eq!(spread(UVec3::new(0xffff, 0, 0)), 0x2492_4924_9249);
        assert_eq!(spread(UVec3::new(0b101, 0b010, 0b111)), 0b1_0111_0101);
    }
}
